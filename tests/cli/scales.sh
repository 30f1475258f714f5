#!/bin/sh
# hawser mms, hill, compare mms and frf --backbone: results, refusals, pictures.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
sketched
pair=$top/tests/reference/pair-2to1.json

works "mms" mms "$duffing" --json mms.json --tsv mms.tsv -q
python "mms: closed form of Duffing's equation" <<'END'
import json
r = json.load(open("mms.json"))
p = r["primary"]
assert abs(p["backbone"] - 0.0375) < 1e-15 and p["hardening"]
assert abs(p["peak"]["a"] - 3.6) < 1e-12 and len(p["folds"]) == 2
assert any(not q["stable"] for q in r["points"])
m = r["modulation"]["monomials_scaled"]
assert len(m) == 1 and m[0]["factors"] == ["A1", "A1", "A1*"] and abs(m[0]["re"] - 0.3) < 1e-15
END
works "mms of a pair" mms "$pair" --resonant 1:1,2:2 --from 1.12 --to 0.94 --json pair.json --tsv pair.tsv -q
python "mms of a pair: folds and tori near the published ones" <<'END'
import json
r = json.load(open("pair.json"))
for kind, want in (("fold", 1.037806516), ("fold", 1.078209077), ("torus", 1.009666609), ("torus", .987743365)):
    assert min(abs(e["Omega"] - want) for e in r["events"] if e["kind"] == kind) < 1e-3, (kind, want)
assert r["command"] == "mms" and [m["order"] for m in r["modulation"]["modes"]] == [1, 2]
END
cat >half.json <<'END'
{"n": 2, "D": [[0.02, 0], [0, 0.04]], "K": [[1, 0], [0, 4]], "Q": [[0, 0, 1, 1], [1, 0, 0, 0.5]], "harmonics": [{"k": 1, "f": [0, 0.02]}]}
END
run mms half.json --mode 2 --from 1.9 --to 2.1 --tsv half.tsv -q
try "a mode of half the frequency is named" like 0 "begins to move at half the forcing frequency"
works "and followed" frf half.json --from 1.9 --to 2.1 --json half-frf.json -q
python "it makes the closed form unstable where frf has its period doublings" <<'END'
import json
rows = [line.split("\t") for line in open("half.tsv") if line[0] != "#"]
named, rows = rows[0], [list(map(float, r[:2])) for r in rows[1:]]
assert named[0].startswith("Omega") and named[1] == "stable", named
turns = [b[0] for a, b in zip(rows, rows[1:]) if a[1] != b[1]]
doublings = [e["Omega"] for e in json.load(open("half-frf.json"))["events"] if e["kind"] == "period-doubling"]
assert len(turns) == len(doublings) == 2 and all(abs(a/b - 1) < 2e-3 for a, b in zip(turns, doublings)), (turns, doublings)
END
works "mms --superharmonic" mms "$duffing" --superharmonic 3 --from 0.3 --to 0.36 --tsv super.tsv -q
refuses_like 2 "has no subharmonic motion" mms "$duffing" --subharmonic 3 --from 2.9 --to 3.1
refuses 1 "--mode 2: the model has modes 1 to 1" mms "$duffing" --mode 2
refuses 1 "--superharmonic 4: must be at most 3" mms "$duffing" --superharmonic 4
refuses 1 "--superharmonic does not go with --subharmonic: leave out one of them" \
	mms "$duffing" --superharmonic 2 --subharmonic 2
cat >two.json <<'END'
{"n": 2, "K": [[1, 0], [0, 4]], "D": [[0.02, 0], [0, 0.04]], "Q": [[0, 0, 1, -0.4], [1, 0, 0, -0.2]],
 "harmonics": [{"k": 1, "f": [0, 0.02]}]}
END
works "a load near the second mode, with the first at half of its frequency" mms two.json --resonant 1:1/2,2:1 --from 1.8 --to 2.2 \
	--json half.json -q
works "the whole model" frf two.json --from 1.8 --to 2.2 --json whole.json -q
python "where the first mode begins to move" <<'END'
import json
half, whole = (json.load(open(name + ".json"))["events"] for name in ("half", "whole"))
assert [e["kind"] for e in half] == ["branch-point"]*2 and [e["kind"] for e in whole] == ["period-doubling"]*2
assert all(abs(a["Omega"]/b["Omega"] - 1) < 5e-6 for a, b in zip(half, whole))
END
refuses 1 "--resonant 1:1/2,2:1: motions of several periods of the load are not compared: write whole orders" \
	compare mms two.json --resonant 1:1/2,2:1
refuses_like 1 "write mode:order" mms "$pair" --resonant 1:1,3:2
refuses_like 1 "write mode:order" mms "$pair" --resonant 1:1,2:4294967298
refuses 1 "--resonant does not go with --mode: leave out one of them" \
	mms "$pair" --mode 1 --resonant 1:1
works "mms picture" mms "$chairlift" -n 2 --max-points 20 --plot mms.svg -q

works "compare mms" compare mms "$duffing" --levels 4 --json compare.json --tsv compare.tsv --plot compare.svg
cp "$scratch/out" figures
python "compare mms: the fold's distance falls with the fourth power" <<'END'
import json
r = json.load(open("compare.json"))
last = [m for m in r["marks"] if m["mark"] == "fold" and m["e"] == 1/8]
assert len(last) == 2 and all(abs(m["slope"] - 4) < 0.2 for m in last), last
END
refuses_like 1 "at most 10" compare mms "$duffing" --levels 11
try "compare mms picture" test -s compare.svg
python "prints the errors of the table besides" <<'END'
import csv
rows = list(csv.DictReader((l for l in open("compare.tsv") if l[0] != "#"), delimiter="\t"))
peak = [r for r in rows if r["mark"] == "peak"]
want = ["relative error of a at the peak, from level to level: " + ", ".join("%.2e" % abs(float(r["a_error"])) for r in peak),
        "distance of Omega, peak: " + ", ".join("%.2e" % float(r["Omega_distance"]) for r in peak)]
said = [l[2:].rstrip() for l in open("figures")]
assert all(w in said for w in want), said
END
rm figures

works "frf --backbone" frf "$duffing" --from 0.8 --to 1.5 --backbone 1 --energy --json backbone.json --tsv backbone.tsv --plot energy.svg -q
python "frf --backbone: Duffing's backbone between both orders" <<'END'
import json
b = json.load(open("backbone.json"))["backbone"]
assert abs(b["multiple_scales"] - 0.0375) < 1e-15
for p in b["points"]:
    a = p["coordinates"][0]
    if a < 0.5:
        assert abs(p["Omega"] - 1 - 0.0375*a*a) < 0.01*a**4
assert b["points"][-1]["energy"] > 0.1
END
refuses 1 "--energy needs --backbone J: give that" frf "$duffing" --energy
refuses_like 1 "backbone 2: the model has modes 1 to 1" frf "$duffing" --from 0.8 --to 0.9 --backbone 2

works "hill --mathieu" hill --mathieu --x delta=0:5 --y epsilon=0:2 --json mathieu.json --tsv mathieu.tsv -q
python "hill --mathieu: within 1e-10 of the characteristic values" <<'END'
rows = [l.split("\t") for l in open("mathieu.tsv") if l[0] != "#"][1:]
assert len(rows) > 100 and max(abs(float(r[-1])) for r in rows) < 1e-10
assert {r[1] for r in rows} == {"plus", "minus"}
END
works "a narrow tongue" hill --mathieu --x delta=170.4:171.4 --y epsilon=24.5:25.5 --tsv narrow.tsv --json narrow.json -q
python "hill --mathieu: both boundaries of a tongue less than 1e-6 wide" <<'END'
import json
rows = [l.split("\t") for l in open("narrow.tsv") if l[0] != "#"][1:]
assert {r[0] for r in rows} == {"1", "2"} and max(abs(float(r[-1])) for r in rows) < 1e-12
tongue = json.load(open("narrow.json"))["tongues"]
assert len(tongue) == 1 and tongue[0]["tongue"] == 13 and tongue[0]["width"][1] < 1e-6
END
works "a tongue closed by damping" hill --mathieu --damping 0.001 --x delta=170.8:171 --y epsilon=24.9:25.1 \
	--tsv closed.tsv -q
try "is named" grep -q "tongue 13: closed by the damping in this plane" closed.tsv
cat >combination.json <<'END'
{"hawser_rom": 1, "n": 2, "D": [[0.02, 0], [0, 0.02]], "K": [[1, 0], [0, 4.84]],
 "harmonics": [{"k": 1, "phase": "cos", "omega_power": 0, "K": [[0.3, 1], [1, 0.2]]}]}
END
cat >combination-load.json <<'END'
{"hawser_rom": 1, "n": 1, "D": [[0.05]], "K": [[1]],
 "harmonics": [{"k": 1, "phase": "cos", "omega_power": 0, "f": [0.1]}]}
END
works "hill boundaries" hill combination.json --x Omega=2.8:3.6 --y factor.load=0:0.4 --tsv torus.tsv -q
python "hill: a combination resonance begins at 4 c sqrt(w1 w2)" <<'END'
rows = [l.split("\t") for l in open("torus.tsv") if l[0] != "#"][1:]
low = min(float(r[3]) for r in rows if r[1] == "torus")
assert abs(low/(4*0.01*2.2**0.5) - 1) < 1e-3, low
END
works "hill --Omega" hill combination.json --Omega 3.2 --tsv multipliers.tsv -q
works "hill of what a load moves" hill "$duffing" --Omega 0.9 --json orbit.json -q
python "hill --orbit: Liouville" <<'END'
import json, math
r = json.load(open("orbit.json"))
total = sum(m["log_modulus"] for m in r["multipliers"])
assert abs(total + 0.05*2*math.pi/0.9) < 1e-9 and r["about"] == "orbit"
END
works "hill picture" hill --mathieu --damping 0.1 --x delta=0:2 --y epsilon=0:1 --plot mathieu.svg -q
refuses 1 "hill needs a SCENE|MODEL, or --mathieu (hawser hill --help)" hill
refuses 1 "give --Omega for multipliers, or --x and --y for boundaries" hill "$duffing"
refuses_like 1 "leave .* out" hill "$duffing" --mathieu
refuses_like 1 "write delta=FROM:TO" hill --mathieu --x delta=5:1
refuses_like 1 "write delta=FROM:TO" hill --mathieu --x delta=0:1e999
refuses 1 "--plot draws boundaries: give --x and --y" hill "$duffing" --Omega 1 --plot x.svg

python "a measured decay" <<'END'
import math
with open("decay.csv", "w") as f:
    f.write("time,flag,x\n")
    for i in range(300):
        t = 0.05*i
        f.write("%r,1,%r\n" % (t, 0.2 + math.exp(-0.03*2*t)*math.cos(2*math.sqrt(1 - 0.03**2)*t)))
END
works "damping" damping decay.csv --y 3 --json decay.json --tsv decay.tsv -q
python "damping: ratio and frequency" <<'END'
import json
r = json.load(open("decay.json"))
assert abs(r["ratio"] - 0.03) < 1e-9 and abs(r["omega_rad_s"] - 2) < 1e-9 and r["samples"] == 300
END
works "a response" frf combination-load.json --from 0.8 --to 1.2 --tsv response.tsv -q
works "damping --half-power" damping response.tsv --half-power --y 4 --json half.json -q
python "damping --half-power: of the model" <<'END'
import json
assert abs(json.load(open("half.json"))["ratio"] - 0.025) < 1e-5
END
refuses 1 "damping has no picture" damping decay.csv --plot x.svg
refuses_like 1 "no number in column 4" damping decay.csv --y 9
done_testing

#!/bin/sh
# Travelling cables: responses to the speed alone, braking, plans, model files.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
speed=$top/notebooks-data/scenes/b-table-5.4.yaml
brake=$top/notebooks-data/scenes/b-table-5.5.yaml
load=$top/notebooks-data/scenes/b-table-5.6.yaml
light='damping.rayleigh={mass: 0.04550184, stiffness: 0.0014065365}'

works "a response to the speed alone" frf "$speed" --from 1.08w1 --to 1.16w1 --step 0.02 --json frf.json
works "with modes to be chosen" frf "$speed" --set model.condense=static --set model.modes=auto \
	--from 1.08w1 --to 1.16w1 --step 0.02 --json auto.json
works "a model" rom "$speed" --json rom.json
# The frequencies of a file are those of its few coordinates: its w1 is another.
range=$(python3 -S -c 'import json; print("--from %.17g --to %.17g" % tuple(json.load(open("frf.json"))["range"]))')
works "which is one for other commands" frf rom.json $range --step 0.02 --json file.json
works "braking" integrate "$brake" --until 7 --every 0.5 --json brake.json
works "a model that brakes" rom "$brake" --json ramp.json
works "of which a file tells all" integrate ramp.json --until 7 --every 0.5 --json ramped.json
refuses_like 1 'changes once and for all' frf "$brake"
refuses_like 1 'changes once and for all' frf ramp.json
refuses_like 1 'travel.braking contradicts' frf "$speed" --set travel.braking=3
works "a plan" plan "$speed" --set model.condense=static --fidelities "raw 3" --json plan.json
# an abrupt stop, 600 m/s^2: the cable goes slack, here and at full order
stop='--set travel.speed=60 --set travel.braking=0.1 --until 0.5'
run integrate "$brake" $stop --json stop.json
try "an abrupt stop is warned of" grep -q '^hawser: warning: slack: with the axial waves' "$scratch/err"
run integrate "$brake" $stop --set model.energy=exact --set model.modes=10 \
	--json full.json
works "speed that changes a little" integrate "$speed" --Omega 5 --until 1 --json little.json
works "and at full order" integrate "$speed" --Omega 5 --until 1 --set model.energy=exact \
	--set model.basis=10 --json little-full.json
# The chain of tests/travel-chain.h, 401, 801 and 1601 rods: 4081.5, 4080.7, 4080.8 N at least and 7512.7, 7516.3,
# 7518.4 N at most; where the braking takes 0.7 s, 12 513 N at most, and below rho v^2 from 0.04 s on.
cat >guy.yaml <<'END'
cable: {EA: 14 MN, rho: 3.1}
span: {d: 90 m, h: 25 m}
tension: {T0: 6 kN}
travel: {speed: 18, hold: tension, braking: 3, final: 2}
model: {modes: 8}
END
run integrate guy.yaml --until 4 --every 0.02 --json guy.json
try "a braking without slack" test ! -s "$scratch/err"
run integrate guy.yaml --set travel.braking=0.7 --until 2 --every 0.02 --json quick.json
try "a quick braking is warned of" grep -q '^hawser: warning: slack: with the axial waves' "$scratch/err"
run integrate guy.yaml --set travel.braking=0.7 --until 0.05 --every 0.01 --json first.json
try "its first wave too" grep -q '^hawser: warning: the change of speed, with its axial waves' "$scratch/err"
works "rows far apart" integrate guy.yaml --until 4 --every 0.5 --json far.json
python "with the waves of its sudden start" <<'END'
import json
def waves(name): return json.load(open(name + ".json"))["tension_with_waves"]
r, far, quick, first = waves("guy"), waves("far"), waves("quick"), waves("first")
assert abs(r["min"]/4080.8 - 1) < 0.03 and abs(r["max"]/7518.4 - 1) < 0.03, r
assert abs(r["min"] - 4080.8) < r["error"] < 1200, r
assert abs(far["min"]/r["min"] - 1) < 0.01 and abs(far["max"]/r["max"] - 1) < 0.01, (far, r)
assert abs(quick["max"]/12513 - 1) < 0.03 and quick["min"] < 0 > quick["spare"], quick
assert first["min"] > 0 > first["spare"], first
END
python "the tension that speeding takes" <<'END'
import json
def load(name): return json.load(open(name + ".json"))
stop, full, little, right = load("stop"), load("full"), load("little"), load("little-full")["tension"]
waves = stop["tension_with_waves"]
assert waves["min"] < 0 and stop["warnings"] and full["tension"]["min"] < 0
assert abs(waves["min"] - full["tension"]["min"]) < waves["error"]
assert "tension_of_speeding" not in full and little["warnings"] == []
waves = little["tension_with_waves"] # of +-300 N; with 24 functions the full order moves by a few N
assert abs(waves["min"] - right["min"]) < 30 and abs(waves["max"] - right["max"]) < 30, (waves, right)
assert little["tension_of_speeding"] > 150
END
python "what motion adds" <<'END'
import json
def load(name): return json.load(open(name + ".json"))
frf, auto, file = load("frf"), load("auto"), load("file")
peak = lambda r: max(p["amplitude"]["y_mid"] for p in r["points"])
assert abs(peak(frf)/peak(file) - 1) < 1e-9, (peak(frf), peak(file))
assert abs(peak(auto)/peak(frf) - 1) < 0.02, (peak(auto), peak(frf))
assert abs(frf["points"][0]["tension"]["max"]/file["points"][0]["tension"]["max"] - 1) < 5e-3 # a file knows three points
rom = load("rom")
n = rom["n"]
assert [(h["k"], h["phase"], h["omega_power"]) for h in rom["harmonics"]] == \
    [(1, "sin", 0), (1, "cos", 1), (2, "cos", 0)]
assert 0 < rom["shapes"]["mach2"] < 1e-5
skew = max(abs(rom["D"][j][k] + rom["D"][k][j]) for j in range(n) for k in range(j))
assert skew == 0 and any(rom["D"][j][k] for j in range(n) for k in range(j))
a, b = load("brake")["states"], load("ramped")["states"]
assert max(abs(x - y) for x, y in zip(a[-1], b[-1])) < 1e-12
assert max(abs(x) for x in a[0]) == 0 and 1e-4 < max(abs(x) for x in a[-1]) < 1e-2
decided = {d["subject"]: d["modelled"] for d in load("plan")["decisions"]}
assert decided["gyroscopic terms"] and decided["harmonics of the speed"], decided
END

# Multiples of natural frequencies are those of hawser modes: a belt at 60 m/s (an outside program: 3.969
# rad/s, where the apparent cable at rest has 5.309), at rest.
cat >belt.yaml <<'END'
cable: {EA: 2.4 MN, rho: 1.1 kg/m}
span: {d: 40 m, h: 3 m}
tension: {T0: 9 kN}
travel: {speed: 60 m/s, hold: tension}
damping: {ratio: 0.5 %}
load: {frame: local, per_length: [0, 0.02, 0]}
model: {modes: 2}
END
for set in travel.speed=0 travel.speed=60; do
	run modes belt.yaml --set $set --json modes.json
	run frf belt.yaml --set $set --from 0.99w1 --to 1w2 --max-points 2 --json f.json
	run integrate belt.yaml --set $set --Omega 1w1 --until 0.05T --json i.json
	run plan belt.yaml --set $set --from 1w1 --to 1w2 --fidelities "raw 2" --json p.json
	run hill belt.yaml --set $set --Omega 1w2 --json h.json
	run map belt.yaml --set $set --x Omega=1w1:1w2 --y travel.speed=10:20 --points 2x2 --json m.json
	python "w1 and w2 with $set" <<'END'
import json
def load(name): return json.load(open(name + ".json"))
w = [m["omega"] for m in load("modes")["modes"]]
def same(*pairs):
    for a, b in pairs:
        assert abs(a/b - 1) < 1e-10, (a, b)
f, p, x = load("f"), load("p"), load("m")["x"]
assert len(f["natural_frequencies"]) == len(w)
same(*zip(f["natural_frequencies"], w), (f["range"][0], 0.99*w[0]), (f["range"][1], w[1]))
same((load("i")["Omega"], w[0]), (load("h")["Omega"], w[1]))
same((p["from"], w[0]), (p["to"], w[1]), (x["from"], w[0]), (x["to"], w[1]))
END
done
run integrate belt.yaml --set model.condense=static --set model.modes=auto --Omega 1w1 --until 0.05T --json auto.json
python "the figure of the belt, and with modes to be chosen" <<'END'
import json
w = json.load(open("modes.json"))["modes"][0]["omega"] # at 60 m/s
assert abs(w - 3.969) < 5e-4, w
assert abs(json.load(open("auto.json"))["Omega"]/w - 1) < 1e-10
END
# Files of two coordinates. With a skew D (entries +-g): w^4 - (K1 + K2 + g^2) w^2 + K1 K2 = 0. A damper between
# unequal masses, D = inv(M) C, changes nothing, and the same skew forces between such masses as g1, -g2 have g^2 = g1 g2.
for D in "0.01,0.5;-0.5,0.01" "0.3,-0.3;-0.1,0.1" "0.01,0.5;-0.25,0.01"; do
	D=$(printf %s "$D" | sed 's/;/],[/')
	echo "{\"hawser_rom\": 1, \"n\": 2, \"D\": [[$D]], \"K\": [[1, 0], [0, 2]],
		\"harmonics\": [{\"k\": 1, \"phase\": \"cos\", \"omega_power\": 0, \"f\": [0.01, 0]}]}" >turn.json
	run frf turn.json --from 0.99w1 --to 1w1 --json turned.json
	python "the file with D = $D" <<'END'
import json
D, got = json.load(open("turn.json"))["D"], json.load(open("turned.json"))["natural_frequencies"]
b = 3 + max(0, -D[0][1]*D[1][0])
for w, sign in zip(got, (-1, 1)):
    assert abs(w/((b + sign*(b*b - 8)**0.5)/2)**0.5 - 1) < 1e-9, (w, sign)
assert len(got) == 2
END
done

# Two solutions at one frequency, each found again in time.
rough "coexisting solutions" frf "$load" --set "$light" --set model.energy=quartic --from 0.9w1 --to 1.4w1 --json two.json
python "their states" <<'END'
import json
points, Omega = json.load(open("two.json"))["points"], 6.4
found = [a for a, b in zip(points, points[1:]) if (a["Omega"] - Omega)*(b["Omega"] - Omega) <= 0]
assert [p["stable"] for p in found] == [True, False, True]
json.dump({"state": found[0]["state"]}, open("large.json", "w"))
json.dump([p["amplitude"]["y_mid"] for p in found], open("amplitudes.json", "w"))
END
rough "from the large one" integrate "$load" --set "$light" --set model.energy=quartic --Omega 6.4 --until 120T --every 0.05T \
	--initial large.json --json a.json
rough "from rest" integrate "$load" --set "$light" --set model.energy=quartic --Omega 6.4 --until 120T --every 0.05T --json b.json
python "both stay" <<'END'
import json
want = json.load(open("amplitudes.json"))
def settled(name):
    probe = json.load(open(name))["probes"]["mid"]
    return max(abs(y) for y in probe["y"][-41:])
assert abs(settled("a.json")/want[0] - 1) < 0.03 and abs(settled("b.json")/want[2] - 1) < 0.06
assert settled("a.json") > 8*settled("b.json")
END
done_testing

#!/bin/sh
# A cable that travels: hawser statics, campbell, and irvine at some speeds: results and refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scene=$top/notebooks-data/scenes/b-table-5.3.yaml
rest=$top/notebooks-data/scenes/b-table-4.1-case-3.yaml

# --- statics
works "a steady state" statics "$scene" --points 11 --json state.json --tsv state.tsv
works "the same at speed 0" statics "$scene" --set travel.speed=0 --json zero.json
works "both holds over the speed" statics "$scene" --speeds --points 21 --json speeds.json --tsv speeds.tsv
works "H held" statics "$scene" --set tension.H="85 kN" --speeds --points 5 --to "200 m/s" --tsv H.tsv
python "what is printed is the actual tension, and the limit is told" <<'END'
import csv, json
r = json.load(open("state.json"))
t = r["travel"]
assert abs(r["T0"] - 85000) < 1e-7 and r["T0"] == r["profile"][0][3] and t["hold"] == "tension"
assert abs(t["apparent_T0"] - (85000 * (1 - t["mach2"]) - 5 * 60**2)) < 1e-6
assert abs(t["limit"] - 127.556285) < 1e-6 and t["speed"] == 60 and 0.51 < t["nu"] < 0.53
assert abs(r["profile"][-1][0] - r["length0"]) < 1e-9
assert abs(r["profile"][-1][1] - 100) < 1e-9 and abs(r["profile"][-1][2] - 5) < 1e-9
text = open("state.tsv").read()
for want in "# speed = 60 m/s", "# limit = 127.556284", "# apparent_H = ", "# T0 = 85000 N":
    assert want in text, want
zero = json.load(open("zero.json"))
assert zero["travel"]["nu"] == 0 and zero["travel"]["apparent_H"] == zero["H"]
END
python "the taut and the slack state meet, the other hold goes on" <<'END'
import csv, json
rows = [r for r in csv.DictReader((l for l in open("speeds.tsv") if not l.startswith("#")), delimiter="\t")]
curve = {}
for r in rows:
    curve.setdefault((r["hold"], r["state"]), []).append({k: float(v) for k, v in r.items() if k not in ("hold", "state")})
taut, slack, length = curve["tension", "taut"], curve["tension", "slack"], curve["length", ""]
assert len(taut) == len(slack) == len(length) == 21 == len(json.load(open("speeds.json"))["speeds"]) / 3
for a, b in zip(taut, slack):
    assert a["speed_m_s"] == b["speed_m_s"] and abs(a["T0_N"] - 85000) < 1e-6 and abs(b["T0_N"] - 85000) < 1e-6
    assert a["sag_m"] < b["sag_m"]
assert slack[-1]["sag_m"] / taut[-1]["sag_m"] < 1.0001 and slack[0]["sag_m"] / taut[0]["sag_m"] > 1000
assert length[-1]["speed_m_s"] > 150
for r in length:
    assert abs(r["length0_m"] / length[0]["length0_m"] - 1) < 1e-14
assert all(a["T0_N"] < b["T0_N"] for a, b in zip(length, length[1:]))
H = list(csv.DictReader((l for l in open("H.tsv") if not l.startswith("#")), delimiter="\t"))
assert all(abs(float(r["H_N"]) / 85000 - 1) < 1e-12 for r in H if r["hold"] == "tension")
END
refuses_like 2 'at 130 m/s the cable has no steady state.*127\.55' statics "$scene" --set travel.speed=130
refuses_like 1 'for a travelling cable' statics "$rest" --speeds
refuses_like 1 'models does not go with --speeds' statics "$scene" --speeds --models
refuses_like 1 'catenary' statics "$scene" --model parabola
refuses_like 1 'no range of steady states' statics "$scene" --speeds --from 128 --to 140
refuses_like 1 '--to: .*3 N.* wrong' statics "$scene" --speeds --to "3 N"
refuses_like 1 'not negative' statics "$scene" --speeds --from -1

# --- campbell
works "a Campbell diagram" campbell "$scene" --points 3 -n 2 --json c.json --tsv c.tsv
works "in Hz, with excitation" campbell "$scene" --to "144 km/h" --points 5 -n 3 --unit Hz --spacing "30 m" \
	--harmonics 2 --json h.json --tsv h.tsv
works "with its length held" campbell "$scene" --set travel.hold=length --points 5 -n 2 --json l.json
python "tables and JSON say the same, and what they have to" <<'END'
import csv, json, math
def table(name):
    return list(csv.DictReader((l for l in open(name) if not l.startswith("#")), delimiter="\t"))
for name, unit, scale, branches in ("c", "rad_s", 1, 2), ("h", "Hz", 2 * math.pi, 3):
    r, rows = json.load(open(name + ".json")), table(name + ".tsv")
    assert list(rows[0])[:5] == ["speed_m_s", "plane", "branch", "re_" + unit, "im_" + unit]
    flat = [(s["speed"], e) for s in r["speeds"] for e in s["eigenvalues"]]
    assert len(flat) == len(rows) == branches * len(r["speeds"])
    for row, (speed, e) in zip(rows, flat):
        assert float(row["speed_m_s"]) == speed and e["plane"].startswith(row["plane"])
        assert abs(float(row["im_" + unit]) * scale / e["im"] - 1) < 1e-14
        assert e["re"] == 0 and e["im"] > 0 and int(float(row["branch"])) == e["branch"]
c, h, l = (json.load(open(n + ".json")) for n in "chl")
assert c["critical"] == [{"speed": c["limit"], "kind": "no-steady-state", "plane": "in-plane"}]
assert h["critical"] == l["critical"] == [] and abs(h["speeds"][-1]["speed"] - 40) < 1e-12
assert abs(l["limit"] - math.sqrt(100e6 / 5)) < 1e-9 and c["unsure"] == 0
assert all(k["kind"] == "veering" for k in c["crossovers"])
assert h["resonances"] and h["spacing"] == 30
for x in h["resonances"]:
    assert abs(x["omega"] - x["harmonic"] * 2 * math.pi * x["speed"] / 30) < 1e-9
END
works "with damping" campbell "$scene" --set "damping={alpha: 0.1}" --points 3 -n 1 --to 20
try "it says that it leaves damping out" grep -q "^# the scene's damping is left out" "$scratch/out"
refuses 1 "campbell needs a SCENE (hawser campbell --help)" campbell
refuses_like 1 'no travel.*add travel' campbell "$rest"
refuses 1 "--unit rpm: must be one of rad/s, Hz" campbell "$scene" --unit rpm
refuses_like 1 '--method foo: must be one of .*spectral' campbell "$scene" --method foo
refuses 1 "--from -3: must be finite and not negative" campbell "$scene" --from -3
refuses 1 "--to 0: must be greater than zero and finite" campbell "$scene" --to 0
refuses 1 "--spacing 0: must be greater than zero and finite" campbell "$scene" --spacing 0
refuses_like 1 '--spacing: .*3 s.* wrong' campbell "$scene" --spacing "3 s"
refuses 1 "--points 1: must be at least 2" campbell "$scene" --points 1
refuses_like 1 'two that ascend' campbell "$scene" --from 5 --to 4
refuses_like 2 'from 128 m/s on the cable has no steady state.*127\.55' campbell "$scene" --from 128 --to 140 \
	--json out.json
refuses_like 2 'inextensible' campbell "$scene" --set cable.EA=.inf --tsv out.tsv
try "and no file" test ! -e out.json -a ! -e out.tsv

# --- irvine
works "Irvine diagrams at three speeds" irvine "$scene" --speeds "0, 5, 36 km/h" --points 12 -n 4 --json i.json \
	--tsv i.tsv
works "and at the scene's" irvine "$scene" --sweep T0 --points 2 -n 1 --json one.json
python "a diagram a speed; the gap of the first veering grows with it" <<'END'
import csv, json
r = json.load(open("i.json"))
assert [d["speed"] for d in r["diagrams"]] == [0, 5, 10]
rows = list(csv.DictReader((l for l in open("i.tsv") if not l.startswith("#")), delimiter="\t"))
assert len(rows) == sum(len(d["stations"]) for d in r["diagrams"]) and list(rows[0])[0] == "speed_m_s"
gap = [c["gap"] for d in r["diagrams"] for c in d["crossovers"][:1] if c["numbers"] == [1, 2]]
assert len(gap) == 3 and gap[0] < 0.02 and 1.8 < gap[2] / gap[1] < 2.2
one = json.load(open("one.json"))
assert one["speed"] == 60 and one["stations"][0]["value"] > one["stations"][-1]["value"]
END
refuses_like 2 'has one up to 127.556285 m/s' campbell "$scene" --from 200
refuses_like 2 'lower travel.fluctuation' campbell "$scene" --set travel.fluctuation=200
refuses_like 1 'more than 12 speeds' irvine "$scene" --speeds "0,1,2,3,4,5,6,7,8,9,10,11,12"
refuses_like 1 '--speeds' irvine "$scene" --speeds "0,,2"

# --- pictures
cat >changing.yaml <<'END'
cable: {EA: 100 MN, rho: 5}
span: {d: 80, h: 5}
tension: {H: 80 kN}
travel: {speed: 30, fluctuation: 3, hold: tension}
damping: {ratio: 0.005}
END
works "six modes lack the gyroscopic forces of the others" frf changing.yaml --from 5.25 --to 5.35 -q \
	--set model.energy=quartic --json modes.json
works "so that the exact energy answers" frf changing.yaml --from 5.25 --to 5.35 -q --json exact.json
python "both within their stated errors" <<'END'
import json
# exact energy on 12 and on 16 functions: 0.35386731 and 0.35386732 m
for name, least, most in ("modes", 0.03, 0.1), ("exact", 1e-4, 2e-3):
    r = json.load(open(name + ".json"))
    peak = max(p["size"] for p in r["peaks"] if p["probe"] == "mid" and p["component"] == "y")
    stated = r["model_error"]["estimated"]
    assert abs(peak/0.3538673 - 1) < stated and least < stated < most, (name, peak, stated)
END
if command -v gnuplot >/dev/null; then
	works "a Campbell picture" campbell "$scene" --points 4 --to 60 -n 3 --spacing "30 m" --plot campbell.svg -q
	try "it says what it shows" sh -c 'for w in "in plane" "out of plane" "Imaginary part (rad/s)" \
		"all real parts 0" excitation "mode 2"; do
		grep -q "$w" campbell.svg || exit 1; done'
	works "a picture of both holds" statics "$scene" --speeds --points 21 --plot speeds.svg -q
	try "it says what it shows" sh -c 'for w in "length held" slack limit Sag; do
		grep -q "$w" speeds.svg || exit 1; done'
	works "a panel a speed" irvine "$scene" --speeds "0, 5, 36 km/h" --points 2 -n 1 --plot irvine.svg -q
	try "each with its speed" sh -c 'for w in "= 0 m/s" "= 5 m/s" "= 10 m/s"; do
		grep -q "$w" irvine.svg || exit 1; done'
else
	skip "gnuplot is not installed"
fi
done_testing

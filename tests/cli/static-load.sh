#!/bin/sh
# A span with ice, wind and a change of temperature, through the commands: the plane of the cable swings,
# loads and displacements are along the axes of the scene.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
sketched
scene=$top/notebooks-data/scenes/conductor.yaml

works "statics" statics "$scene" --points 41 --json iced.json --tsv iced.tsv
works "the loaded state from its own tension" statics "$scene" --points 3 --json back.json \
	--set "tension={T0: 45565.8271111 N, state: loaded}"
python "both states, the supports in balance with the static force, the profile in space" <<'END'
import csv, json
from math import hypot
r, b = json.load(open("iced.json")), json.load(open("back.json"))
l = r["loaded"]
assert l["tension_given"] == "reference" and l["reference"]["H"] == 28000
assert abs(r["length0"] / (l["reference"]["length0"] * (1 - 20 * 1.9e-5)) - 1) < 1e-14
assert abs(b["loaded"]["reference"]["H"] / 28000 - 1) < 1e-9 and b["loaded"]["tension_given"] == "loaded"
assert l["force"][0] == 0 and abs(l["force"][1] + 2.5 * 9.81) < 1e-12 and abs(l["force"][2] - 12) < 1e-12
for k in range(3):
    assert abs(l["pull_A"][k] + l["pull_B"][k] - l["force"][k] * r["length0"]) < 1e-7
z = r["profile_z"]
rows = list(csv.DictReader((line for line in open("iced.tsv") if line[0] != "#"), delimiter="\t"))
assert [float(row["z_m"]) for row in rows] == z and z[0] == 0 and abs(z[-1]) < 1e-9
assert max(z) <= l["blowout"] < 1.001 * max(z)
chord = [12 / 400 * p[1] - p[2] for p in r["profile"]]
assert max(chord) <= l["sag_vertical"] < 1.001 * max(chord) and l["sag_vertical"] < r["sag"]
assert abs(hypot(l["sag_vertical"], l["blowout"]) / r["sag"] - 1) < 1e-3
END
works "without load the profile has no z" statics "$top/notebooks-data/scenes/chairlift.yaml" --points 3 --tsv plain.tsv
python "" <<'END'
text = open("plain.tsv").read()
assert "z_m" not in text and "swing" not in text
END
works "load cases" statics "$scene" --points 3 --cases --json cases.json --tsv cases.tsv
works "the same from the loaded state" statics "$scene" --points 3 --cases --json loaded.json \
	--set "tension={T0: 45565.8271111401 N, state: loaded}"
works "a case without solution" statics "$scene" --points 3 --cases --json failed.json --tsv failed.tsv \
	--set "cases=[{name: lifted, load: {static: {per_length: [0, 15.696, 0]}}}, {name: bare}]"
python "each case is the scene with its load and temperature" <<'END'
import csv, json
r, b, f = (json.load(open(n + ".json")) for n in ("cases", "loaded", "failed"))
rows = {c["name"]: c for c in r["cases"]}
assert list(rows) == ["reference", "everyday wind", "hot", "ice", "ice and wind"]
iced = json.load(open("iced.json"))
for k in "H", "T0", "T1", "sag", "length0", "length":
    assert rows["ice and wind"][k] == iced[k], k
assert rows["reference"]["H"] == 28000 and rows["hot"]["H"] < 28000 < rows["ice"]["H"]
assert rows["reference"]["sag_vertical"] == rows["reference"]["sag"]
for c, d in zip(r["cases"], b["cases"]):
    assert abs(c["H"] / d["H"] - 1) < 1e-9
table = list(csv.DictReader((line for line in open("cases.tsv") if line[0] != "#"), delimiter="\t"))
assert [(t["case"], float(t["T1_N"])) for t in table] == [(c["name"], c["T1"]) for c in r["cases"]]
bad, bare = f["cases"][1], f["cases"][2]
assert not bad["solved"] and "load.static balances the weight" in bad["why"] and bare["solved"] and bare["H"] == 28000
text = open("failed.tsv").read()
assert "# case lifted: no solution: load.static balances the weight" in text and "\nlifted\t\t\t" in text
assert r["scene"]["cases"][2]["load"]["static"]["mass"] == 1.6
END
cat >gale.yaml <<'END'
cable: {EA: 30 MN, rho: 1.5 kg/m}
span: {d: 380 m, h: 0 m}
tension: {H: 30 kN}
wind: {speed: 20 m/s, density: 1.25 kg/m^3, diameter: 58.6 mm, drag: 1.0}
cases: [{name: calm}, {name: gale, wind: {speed: 20 m/s}}]
END
works "cases in a wind" statics gale.yaml --cases --points 3 --json gale.json -q
refuses_like 1 "cases.0. .gale. has a wind.speed, and the scene has no wind: give it, with its density" statics "$chairlift" --set 'cases=[{name: gale, wind: {speed: 9}}]'
python "have the speed of the case, not that of the scene" <<'END'
import json
calm, gale = [c for c in json.load(open("gale.json"))["cases"] if c["name"] != "reference"]
assert abs(calm["H"]/30e3 - 1) < 1e-9 and gale["H"] > 1.2*calm["H"] and gale["swing_angle"] > 0.5, (calm, gale)
END
towers=$top/notebooks-data/scenes/conductor-towers.yaml
works "load cases of ends on springs" statics "$towers" --points 3 --cases --json towers.json --tsv towers.tsv
works "the same between rigid ends" statics "$towers" --points 3 --cases --json rigid.json \
	--set 'support.A.stiffness=[.inf, .inf, .inf]' --set 'support.B.stiffness=[.inf, .inf, .inf]'
works "one of the cases" statics "$towers" --points 3 --json windy.json \
	--set 'load.static={mass: 0.9 kg/m, per_length: [0, 0, 12 N/m]}'
python "each case says where its ends are, and the tension changes less" <<'END'
import json
r, s, w = (json.load(open(n + ".json")) for n in ("towers", "rigid", "windy"))
first = r["cases"][0]
assert first["moved_A"] == first["moved_B"] == [0, 0, 0] and first["H"] == 28000
k = {"A": [6e5, None, 4e5], "B": [6e4, 2e6, 4e4]}
for c, d in zip(r["cases"][1:], s["cases"][1:]):
    assert 28000 < c["H"] < d["H"] and c["imbalance"] < 1e-8 and d["moved_B"] == [0, 0, 0]
    for e in "AB":
        for a in range(3):
            u, p = c["moved_" + e][a], c["pull_" + e][a] - first["pull_" + e][a]
            assert (u == 0 if k[e][a] is None else abs(k[e][a] * u - p) < 1e-8), (c["name"], e, a)
one = r["cases"][3]
for key in "H", "T0", "sag":
    assert one[key] == w[key], key
l, end = w["loaded"], w["profile"][-1]
assert l["moved_A"] == one["moved_A"] and l["moved_B"] == one["moved_B"]
assert abs(end[1] - 400 - l["moved_B"][0]) < 1e-9 and abs(w["profile_z"][-1] - l["moved_B"][2]) < 1e-9
assert w["profile"][0][1] == l["moved_A"][0]
text = open("towers.tsv").read()
assert "# ice: moved_B = -0." in text
END
refuses_like 1 'add, for example, cases' statics "$top/notebooks-data/scenes/chairlift.yaml" --cases
works "a picture of load cases" statics "$scene" --cases --plot cases.svg -q
python "" <<'END'
assert "ice and wind" in open("cases.svg").read().replace("</text>", "")
END
works "modes" modes "$scene" -n 4
[ -z "${HAWSER_LONG:-}" ] || works "plan" plan "$scene"
works "frf of the swung span" frf "$scene" --set model.modes=2 --from 0.95w1 --to 1.05w1 --max-points 40 --json swung.json
python "the same span in the vertical plane, under the turned load" <<'END'
import json
from math import atan2, cos, sin
r = json.load(open("iced.json"))
l = r["loaded"]
force = sum(f * f for f in l["force"])**0.5
up = [-f / force for f in l["force"]]
h = 12 * up[1]
n = [12 * up[2], -400 * up[2], 400 * up[1]]
d = sum(x * x for x in n)**0.5
z = [x / d for x in n]
x = [up[1] * z[2] - up[2] * z[1], up[2] * z[0] - up[0] * z[2], up[0] * z[1] - up[1] * z[0]]
load = [0, 0, 0.5]
turned = [sum(a * b for a, b in zip(load, axis)) for axis in (x, up, z)]
json.dump([x, up, z], open("axes.json", "w"))
open("upright.yaml", "w").write(f"""
g: {force / 2.5!r}
cable: {{EA: 25 MN, rho: 2.5}}
span: {{d: {d!r}, h: {h!r}}}
tension: {{length0: {r['length0']!r}}}
damping: {{ratio: 0.005}}
load: {{frame: global, per_length: {turned!r}}}
model: {{modes: 2}}
""")
END
works "frf of that span" frf upright.yaml --from 0.95w1 --to 1.05w1 --max-points 40 --json upright.json
python "equal folds and peaks of the coordinates" <<'END'
import json
a, b = json.load(open("swung.json")), json.load(open("upright.json"))
for u, v in zip(a["natural_frequencies"], b["natural_frequencies"]):
    assert abs(u / v - 1) < 1e-9
ea, eb = ([e for e in r["events"]] for r in (a, b))
assert len(ea) == len(eb) and len(a["points"]) == len(b["points"])
for p, q in zip(ea, eb):
    assert p["kind"] == q["kind"] and abs(p["Omega"] / q["Omega"] - 1) < 1e-7
top = lambda r: max(max(p["coordinates"]) for p in r["points"])
assert abs(top(a) / top(b) - 1) < 1e-6
END
flat "a map over the wind" map "$scene" --x Omega=0.9w1:1.1w1 --y "load.static.per_length[2]=0:20" --points 4x3 \
	--quantity growth --rest
works "a Campbell diagram of a swung rope" campbell "$scene" -n 1 --points 2 --to 2 \
	--set "travel={speed: 1, hold: tension}"
works "travelling" statics "$scene" --points 3 --set "travel={speed: 5, hold: tension}"
works "speeds" statics "$scene" --points 3 --speeds --set "travel={speed: 5, hold: tension}"
works "other models" statics "$scene" --points 3 --models --set tension.state=loaded
works "irvine" irvine "$scene" -n 2 --points 3
works "point masses on an iced and heated cable" statics "$top/notebooks-data/scenes/ropeway-carriers.yaml" \
	--points 3 --set load.static.mass=1 --set "temperature={change: 20, expansion: 1.2e-5}" --json carriers.json
python "" <<'END'
import json
r = json.load(open("carriers.json"))
l = r["loaded"]
assert abs(r["length0"] / (l["reference"]["length0"] * (1 + 20 * 1.2e-5)) - 1) < 1e-13
masses = 9.81 * sum(a["mass"] for a in r["attachments"])
assert abs(l["pull_A"][1] + l["pull_B"][1] - l["force"][1] * r["length0"] + masses) < 1e-5 * masses
END
works "point masses in a wind" statics "$top/notebooks-data/scenes/ropeway-carriers.yaml" \
	--points 3 --set "load.static={per_length: [0, 0, 3]}" --json wind.json
python "" <<'END'
import json, math
r = json.load(open("wind.json"))
l = r["loaded"]
masses = 9.81 * sum(a["mass"] for a in r["attachments"])
for c, weight in (0, 0), (1, masses), (2, 0):
    assert abs(l["pull_A"][c] + l["pull_B"][c] - l["force"][c] * r["length0"] + weight) < 1e-5 * masses
for a in r["attachments"]:  # the kink, by the law of cosines of both tensions and the weight
    T, U, W = a["T_before"], a["T_after"], 9.81 * a["mass"]
    assert abs(math.acos((T * T + U * U - W * W) / (2 * T * U)) - a["kink"]) < 1e-6, a
END
works "modes in space" modes "$top/notebooks-data/scenes/ropeway-carriers.yaml" -n 3 \
	--set "load.static={per_length: [0, 0, 3]}" --view profile --plot modes.svg
refuses_like 1 'damped modes of a cable' modes "$top/notebooks-data/scenes/ropeway-carriers.yaml" -n 3 --damped \
	--set "load.static={per_length: [0, 0, 3]}"
spacers=$top/notebooks-data/scenes/conductor-spacers.yaml
works "a model in space" rom "$spacers" --json rom.json
works "it moves" integrate "$spacers" --until 10 --Omega 1.0 --quiet
works "a full-order model in space" integrate "$spacers" --until 2 --Omega 1.0 --quiet --set model.energy=exact
refuses_like 1 'moving ends .support.A.motion, support.B.motion, --motion. of a cable' rom "$spacers" \
	--set "support={B: {motion: [0, 0.01, 0]}}"
refuses_like 1 'not the same everywhere' irvine "$top/notebooks-data/scenes/ropeway-carriers.yaml" \
	--set "load.static={per_length: [0, 0, 3]}"
refuses_like 2 'load.static balances the weight, .*give a shorter length0' statics "$scene" --set "load.static={per_length: [0, 15.696, 0], mass: 0}"
refuses_like 1 'act along the chord' statics "$scene" --set "load.static={per_length: [400, 27.696, 0], mass: 0}"
refuses_like 1 'no change of temperature' statics "$scene" --set "temperature={change: -300, expansion: 0.01}"
refuses_like 1 "must be within \[-300, 300\]" statics "$scene" --set temperature.change=-1e6
refuses_like 1 'temperature.expansion is missing' statics "$top/notebooks-data/scenes/chairlift.yaml" \
	--set temperature.change=3
done_testing

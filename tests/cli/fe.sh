#!/bin/sh
# Spans as meshes of cable elements: --model fe of statics, modes and integrate, and hawser compare motion.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scenes=$top/notebooks-data/scenes
line2=$scenes/b-table-4.3-line-2.yaml

for model in catenary fe; do
	works "statics, $model" statics "$line2" --model $model --json statics-$model.json --tsv $model.tsv -q
	works "a loaded span" statics "$line2" --model $model --json loaded-$model.json -q --set \
		'load={static: {per_length: [0, 0, 31]}}' --set 'attach=[{at: 0.3, mass: 210 kg}]'
done
for model in cable fe; do
	works "modes, $model" modes "$line2" -n 6 --model $model --json modes-$model.json -q
done
works "shapes and a picture" modes "$line2" -n 2 --model fe --shapes --tsv shapes.tsv --plot modes.svg -q
works "a picture of statics" statics "$line2" --model fe --plot statics.svg -q
motion="--Omega 2.25 --until 4 --every 0.05"
# shellcheck disable=SC2086 # words
works "integrate" integrate "$line2" --model fe $motion --json fe.json --tsv motion.tsv --plot motion.svg -q
# shellcheck disable=SC2086
works "the reduced model" integrate "$line2" -n 12 $motion --json rom.json -q
# shellcheck disable=SC2086
works "compare motion" compare motion "$line2" $motion --fidelities "condensed 12, raw 3" --after 1 \
	--json compare.json --tsv compare.tsv --plot compare.svg -q
# tension is lost, and models that say so
works "slack" compare motion "$chairlift" --Omega 1w2 --until 0.5 --every 0.02 --fidelities "raw 12" \
	--set 'load.per_length=[0, 60, 0]' --json slack.json --tsv slack.tsv -q
works "moving ends" integrate "$line2" --model fe --Omega 2.25 --until 2 --elements 40 -q --json ends.json \
	--set 'support.B.motion=[0, 0.1 m, 0]' --set 'load.per_length=[0, 0, 0]'
run integrate "$line2" --model fe --Omega 2.25 --until 1 --elements 8 --tsv jerk.tsv -q \
	--set 'support.B.motion=[0, 0.1 m, 0]' --set 'support.B.phase=90 degree'
try "ends that jerk are told" grep -q '^hawser: warning: motion: at t = 0 the ends already move, with 0.225 m/s' \
	"$scratch/err"
try "columns of statics" grep -q "^S_m	x_m	y_m	T_N	slope$" fe.tsv
try "the mesh says its errors" grep -qE '^# errors of the mesh against the elastic catenary of the same length: H -2\.8e-05' fe.tsv
try "as integrate does" grep -qE '^# estimated errors by mesh and steps, relative, root mean square: x_quarter' motion.tsv
try "and compare motion" grep -qE '^# the mesh keeps its tension: least [0-9]' compare.tsv
try "or loses it" grep -qE '^# the mesh is slack from t = [0-9.]+ s, first at S = ' slack.tsv
try "the legend of the picture" grep -q 'estimated error of the mesh' compare.svg

python "the mesh has the numbers of the spans" <<'END'
import json
from math import sqrt

def load(name):
    return json.load(open(name + ".json"))

for kind in ("statics", "loaded"):
    exact, mesh = load(kind + "-catenary"), load(kind + "-fe")
    assert set(exact) - {"attachments"} | {"mesh"} == set(mesh), set(exact) ^ set(mesh)
    for key in ("H", "T0", "T1", "V1", "length0", "length", "sag", "eta"):
        assert abs(mesh[key]/exact[key] - 1) < 2e-3*(key == "sag") + 1e-4, (kind, key, mesh[key], exact[key])
    error = mesh["mesh"]["error"]
    assert abs(mesh["H"]/exact["H"] - 1 - error["H"]) < 1e-12 and 0 < error["place"] < 1e-3
    assert mesh["mesh"]["elements"] == 120 and len(mesh["profile"]) == 121
exact, mesh = load("modes-cable"), load("modes-fe")
assert mesh["method"] == "fe" and set(exact["modes"][0]) == set(mesh["modes"][0])
for a, b in zip(exact["modes"], mesh["modes"]):
    assert abs(b["omega"]/a["omega"] - 1) < b["residual"] < 1e-4
    assert [a[k] for k in ("index", "plane", "family", "symmetry")] == [b[k] for k in ("index", "plane", "family", "symmetry")]

mesh, rom = load("fe"), load("rom")
assert mesh["model"] == "fe" and list(mesh["energy"]) == ["kinetic", "potential", "work", "dissipated", "closure"]
assert len(mesh["times"]) == len(rom["times"]) == 81 and mesh["energy"]["closure"] < 1e-9
assert list(mesh["probes"]) == list(rom["probes"]) == ["quarter", "mid", "three_quarter"]
rms = lambda x: sqrt(sum(v*v for v in x)/len(x))
for probe in mesh["probes"]:
    for key, most in (("y", 0.03), ("z", 0.02), ("vy", 0.2), ("vz", 0.1), ("T", 0.01)):
        a, b = mesh["probes"][probe][key], rom["probes"][probe][key]
        gap = rms([u - v for u, v in zip(a, b)])/rms(b)
        assert gap < most, (probe, key, gap)
    for k in "xyz":
        assert 0 < mesh["mesh"]["error"]["%s_%s" % (k, probe)] < 1e-3
assert mesh["slack_at"] is None and mesh["tension"]["min"] > 7e4

both = load("compare")
names = [run["name"] for run in both["runs"]]
assert names == ["mesh 120", "condensed 12", "raw 3"] == list(both["displacements"])
own, condensed, raw = both["runs"]
assert own["difference"]["y_mid"] < condensed["difference"]["y_mid"] < raw["difference"]["y_mid"]
rows = [i for i, t in enumerate(both["times"]) if t > 1 - 1e-9]
a, b = (both["displacements"][n]["y_mid"] for n in names[:2])
gap = rms([b[i] - a[i] for i in rows])/rms([a[i] for i in rows])
assert abs(gap/condensed["difference"]["y_mid"] - 1) < 1e-9
assert abs(condensed["largest"]["z_mid"] - max(abs(b) for i, b in enumerate(both["displacements"][names[1]]["z_mid"]) if i in rows)) < 1e-15
assert all(run["slack_at"] is None and run["processor_secs"] > 0 for run in both["runs"])
slack = load("slack")["runs"]
assert slack[0]["tension"]["min"] == 0 and 0 < slack[0]["slack_at"] < 1 and 0 < slack[0]["slack_S"] < 251
assert 0 < slack[1]["slack_at"] < 1 and slack[1]["tension"]["min"] < 0
# quasi-static at first: the displacement at t = 0 is that of the moved end
ends = load("ends")
assert 0.04 < ends["probes"]["mid"]["y"][0] < 0.3 and abs(ends["probes"]["mid"]["vy"][0]) == 0
END

refuses 1 "--model fee: must be one of catenary, inextensible, parabola, fe" statics "$line2" --model fee
refuses 1 "--elements needs --model fe: give that" statics "$line2" --elements 5
refuses 1 "--elements needs --model fe: give that" modes "$line2" --elements 5
refuses 1 "--elements needs --model fe: give that" integrate "$line2" --elements 5
refuses 1 "the number of elements of the cable is 2 to 1000000, not 1" statics "$line2" --model fe --elements 1
refuses 1 "--points 50: the profile of --model fe is that of its nodes; give --elements" statics "$line2" \
	--model fe --points 50
refuses 1 "--model fx: must be one of cable, fe" modes "$line2" --model fx
refuses 1 "--damped does not go with --model fe: leave out one of them" modes "$line2" \
	--model fe --damped
refuses 1 "80 modes of a mesh of 120 elements: ask for 1 to 59, or give 162 elements or more" modes "$line2" \
	--model fe -n 80
refuses 1 "--model fx: must be one of rom, fe" integrate "$line2" --model fx
refuses 1 "--load does not go with --model fe: leave out one of them" integrate "$line2" \
	--model fe --load x
refuses 1 "--method gauss: must be one of energy, alpha, theta, euler, cvode" integrate "$line2" --model fe \
	--Omega 1w1 --method gauss
refuses 1 "the span is forced: give the frequency with --Omega, such as --Omega 0.9w1" integrate "$line2" --model fe
refuses 1 "a motion needs 4 elements at least, not 3: its error is estimated by a mesh with half of them" \
	integrate "$line2" --model fe --Omega 1w1 --elements 3
refuses 1 "$duffing is no scene of a span: a mesh of cable elements is made of one, give that" integrate \
	"$duffing" --model fe --Omega 1
refuses 1 "the fidelity auto has no motion from rest: name raw N, condensed N or full N" compare motion "$line2" \
	--Omega 1w1 --fidelities "auto 1"
refuses 1 "--after 4T is not before the end of the run, --until 3T" compare motion "$line2" --Omega 1w1 \
	--until 3T --after 4T
grep -v -e '^load' -e '^  frame' -e '^  per_length' "$line2" >free.yaml
refuses 1 "free.yaml: there is no load, so there is no motion to compare: add a section load" compare motion free.yaml
refuses 1 "--Omega 1: the scene has neither a load nor moving ends: add a section load, or leave --Omega out" \
	compare motion free.yaml --Omega 1
refuses 1 "--until 1e9 --every 1 makes 1e+09 rows: choose a longer interval" compare motion "$line2" --Omega 1 \
	--until 1e9 --every 1
refuses 1 "$scenes/d-figure-9.1.yaml is a scene of a beam: that is for hawser beam" compare motion \
	"$scenes/d-figure-9.1.yaml" --Omega 1
# what a mesh does not have, by its key
refused() {
	refuses 1 "$line2: $1" statics "$line2" --model fe --set "$2"
}
refused "travel: a mesh of cable elements does not travel" "travel={speed: 5, hold: length}"
refused "cable.EA: cable elements are elastic: give a finite EA" "cable.EA=.inf"
refused "cable.EI: cable elements have no bending stiffness" "cable.EI=1e4"
refused "support.B.stiffness: the ends of a mesh of cable elements are not on springs" \
	"support.B.stiffness=[1e6, .inf, .inf]"
refused "attach.0.absorber_cubic: dampers of a mesh of cable elements are to the ground, and its absorbers linear" \
	"attach=[{at: 0.5, absorber_mass: 3, absorber_stiffness: 20, absorber_cubic: 9}]"
refuses 1 "$line2: damping.ratio: a mesh of cable elements has no modal damping: give damping.alpha" integrate \
	"$line2" --model fe --Omega 1 --set "damping.ratio=0.01"
refuses 1 "$line2: damping.rayleigh: a mesh of cable elements has viscous damping only: give damping.alpha" \
	compare motion "$line2" --Omega 1 --set "damping={rayleigh: {mass: 0.1, stiffness: 0.1}}"
refuses 1 "$line2: damping.drag: a mesh of cable elements has no quadratic drag" integrate "$line2" --model fe \
	--Omega 1 --set "damping.drag=0.01"
works "modes without regard to damping" modes "$line2" -n 1 --model fe --set "damping.ratio=0.01" --elements 20 -q
done_testing

#!/bin/sh
# hawser statics of rods: text, JSON, VTK, picture, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scenes=$SRCDIR/notebooks-data/scenes

works "a rod" statics "$scenes/rod-bend.yaml" --json bend.json --tsv bend.tsv --plot bend.svg --vtk bend.vtk -q
python "JSON, table and VTK" <<'END'
import json, math
r = json.load(open("bend.json"))
assert r["scene"]["kind"] == "rod" and r["stable"] is True and r["flow"] is False and r["elements"] == 40
last = dict(zip(r["profile_columns"], r["profile"][-1]))
for key, want in (("x", 47.154), ("y", 15.687), ("z", 53.472)):
    assert abs(last[key] - want) < 2e-3 and abs(last[key] - want) < r["mesh_error"]["position"] + 1e-3
assert abs(math.hypot(last["qw"], last["qx"], last["qy"], last["qz"]) - 1) < 1e-14
assert abs(r["start"]["force"][2] + 600) < 1e-6 and r["end"]["force"] == [0, 0, 0]
# the moment of the support is that of the force about the start
m = [last["y"]*600, -last["x"]*600, 0]
assert all(abs(a + b) < 1e-5 for a, b in zip(r["start"]["moment"], m))
lines = [l for l in open("bend.tsv") if not l.startswith("#")]
assert lines[0].split("\t")[:8] == ["s_m", "x_m", "y_m", "z_m", "T_N", "Q2_N", "Q3_N", "M1_Nm"], lines[0]
assert float(lines[-1].split("\t")[3]) == last["z"]
vtk = open("bend.vtk").read()
assert "POINTS 41 double" in vtk and "tension_N" in vtk and "moment_Nm" in vtk
assert "under load" in open("bend.svg").read()
END
works "overrides" statics "$scenes/rod-bend.yaml" --set loads.i0.force='[0 N, 0 N, 300 N]' --set 'rod.elements=8' --json -
try "an override of elements" grep -q '"elements": 8' "$scratch/out"

cat >rod.yaml <<'END'
kind: rod
rod: {length: 2 m, EA: 1 MN, GA: [400 kN, 300 kN], EI: [2 N.m^2, 3 N.m^2], GJ: 2 N.m^2, rho: 1 kg/m}
start: {at: [0 m, 1 m, 0 m], tangent: [1, 1, 0], hold: clamped}
end: {at: [1 m, 1 m, 0 m], hold: hinged}
loads:
  - {from: 0.5 m, to: end, force: [0 N/m, 0 N/m, 3 N/m]}
END
works "two ends, weight and a wind" statics rod.yaml -q --json two.json
python "its supports bear it" <<'END'
import json
r = json.load(open("two.json"))
total = [a + b for a, b in zip(r["start"]["force"], r["end"]["force"])]
assert all(abs(a - b) < 1e-8 for a, b in zip(total, [0, 2*9.81, -4.5])), total
assert r["stable"] is True and r["end"]["moment"] == [0, 0, 0]
END

refused() { # what, words, sed, arguments
	what=$1 words=$2 change=$3
	shift 3
	sed "$change" rod.yaml >bad.yaml
	denies "$what" 1 "$words" statics bad.yaml "$@"
}
refused "a misspelt key" "bad.yaml:2:20: unknown key rod.EAA: did you mean EA" 's/EA:/EAA:/'
refused "a wrong unit" 'rod.EA: "1 kg"' 's/1 MN/1 kg/'
refused "a stiffness that is missing" "rod.GJ is missing: give a number in N.m^2" 's/GJ: 2 N.m^2, //'
refused "a load beyond the end" "loads.i0.to: 5 m is beyond the end of the rod at 2 m" 's/to: end/to: 5 m/'
refused "a load without force" "no force and no moment" 's/force: .*]/frame: fixed/'
refused "a normal along the tangent" "start.normal is along the tangent" 's/1, 0]/1, 0], normal: [2, 2, 0]/'
refused "a free end with a place" "end.at: the end is free" 's/hinged/free/'
refused "an option of spans" "--cases is for spans and ropeways, and .* is a rod" '' --cases
refused "a VTK file of another name" "must end in .vtk" '' --vtk rod.vtu
sed 's/clamped/free/; /^end/d' rod.yaml >bad.yaml
denies "nothing holds it" 2 "both ends of the rod are free" statics bad.yaml
denies "an option of rods" 1 "is for rods" statics "$scenes/chairlift.yaml" --load-steps 3
denies "another command" 1 "is a rod, which hawser modes does not take; these commands do: statics, integrate" modes "$scenes/rod-roll.yaml"
denies "a command of models" 1 "these commands do: statics, integrate. Reduced models are of cables" frf "$scenes/rod-roll.yaml"
done_testing

#!/bin/sh
# hawser statics of nets on obstacles: text, JSON, picture, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scenes=$SRCDIR/notebooks-data/scenes
sea=$scenes/net-seabed.yaml
works "a mooring line" statics "$sea" --set cables.line.elements=50 --profile --vtk sea.vtk --json sea.json --tsv sea.tsv --plot sea.svg -q
try "  a comment for the obstacle" grep -q '^# seabed: 21 nodes touch, 205 m of unstretched length, .*; 0 stick, 21 slide$' sea.tsv
try "  columns of contact" grep -q '^cable	S_m	x_m	y_m	z_m	T_N	obstacle	r_N_N	r_T_N	contact$' sea.tsv
try "  a node that slides" grep -q '^line	10	.*	seabed	.*	slip$' sea.tsv
try "  the end is open" grep -q '^line	500	.*	-	0	0	open$' sea.tsv
try "  states of contact in VTK" grep -q '^SCALARS contact double 1$' sea.vtk
try "  the picture" grep -q 'obstacles' sea.svg
python "JSON" <<'END'
import json
r = json.load(open("sea.json"))
c = r["contacts"]
assert len(c) == 21 and c[-1]["node"] == "A" and r["complementarity"] < 1e-12 and 0 <= r["gap"] < 1e-3
for one in c:
    assert one["obstacle"] == "seabed" and one.get("cable", "line") == "line" and one["state"] == "slip"
    assert abs(one["r_T"][0] + 0.1*one["r_N"]) < 1e-6 and one["position"][1] < 1e-12
A, B = r["reactions"]["A"], r["reactions"]["B"]
assert abs(A[1] + B[1] + sum(one["r_N"] for one in c) - 500*81.549439*9.81) < 1e-3
assert abs(A[0] + B[0] + sum(one["r_T"][0] for one in c)) < 1e-3
END
works "stiffness of a body" statics "$sea" --set cables.line.elements=50 --set cables.line.EA=5e7 --stiffness B --about "400 m,200,0" --json body.json --tsv body.tsv -q
try "  columns" grep -q '^motion	F_x_N	F_y_N	F_z_N	M_x_Nm	M_y_Nm	M_z_Nm$' body.tsv
try "  friction is told" grep -q '^# the matrix is not symmetric, by 0.0[0-9]*: friction' body.tsv
python "  one node: no moment resists" <<'END'
import json
k = json.load(open("body.json"))["stiffness"]
assert [row["motion"] for row in k["rows"]] == ["x", "y", "z", "rx", "ry", "rz"] and k["about"] == [400, 200, 0]
assert all(abs(row["moment_" + axis]) < 1e-9 for row in k["rows"] for axis in "xyz") and k["rows"][0]["force_x"] > 1e3
END
works "a drum" statics "$scenes/net-capstan.yaml" --json drum.json -q
python "  has no gap" <<'END'
import json, math
r = json.load(open("drum.json"))
assert r["gap"] is None and [c["state"] for c in r["contacts"]] == 12*["slip"]
assert abs(math.log(r["cables"][0]["T_to"]/r["cables"][0]["T_from"])/(1.1*math.log(2.588356)) - 1) < 1e-3
END

# a mass on top of a circle, which soft ropes do not hold there
cat > "$scratch/top.yaml" <<'END'
kind: net
nodes: {A: [-2 m, 0 m, 0 m], M: [0 m, 1 m, 0 m], B: [2 m, 0 m, 0 m]}
cables:
  - {name: a, from: A, to: M, EA: 10 kN, rho: 2 kg/m, length0: 2 m, elements: 1}
  - {name: b, from: M, to: B, EA: 10 kN, rho: 2 kg/m, length0: 2 m, elements: 1}
supports: {A: fixed, B: fixed}
masses: {M: 100 t}
obstacles: [{circle: {centre: [0 m, 0 m], radius: 1 m}}]
END
cat > "$scratch/lie.yaml" <<'END'
kind: net
g: 0
nodes: {A: [0 m, 0 m, 0 m], B: [10 m, 0 m, 0 m]}
cables: [{name: c, from: A, to: B, EA: 1 MN, rho: 2 kg/m, length0: 9.99 m, elements: 8}]
supports: {A: fixed, B: fixed}
obstacles: [{plane: {point: [0 m, 0 m], normal: [0, 1]}}]
END

# a key, a value, what the message has
refused() {
	run statics "$sea" --set "$1" -q
	try "refused: $1" test "$status" -eq "${3-1}"
	try "  $2" grep -qe "$2" "$scratch/err"
}
refused 'obstacles=[{plane: {point: [0, 1], normal: [0, 1]}}]' 'support A is 1 m inside obstacle s0'
refused 'obstacles=[{plane: {point: [0, -1], normal: [0, 1]}}, {plane: {point: [0, -2], normal: [0, -1]}}]' 'leave no room'
refused 'obstacles.seabed.friction=.inf' 'is not finite'
refused 'obstacles.seabed.friction=.nan' 'obstacles.seabed.friction'
refused 'obstacles.seabed.friction=-1' 'must be >= 0'
refused 'obstacles.seabed.frictoin=1' 'did you mean friction'
refused 'obstacles.seabed.velocity=[0, 1 m/s]' 'along the normal of the plane'
refused 'obstacles.seabed.side=above' 'leave side out'
refused 'obstacles=[{plane: {point: [0, 0], normal: [0, 0]}}]' 'no direction'
refused 'obstacles=[{segment: {from: [1, 0], to: [1, 0]}}]' 'one point'
refused 'obstacles=[{circle: {centre: [200 kg, -9], radius: 1}}]' 'circle.centre'
refused 'contact={sliding: history}' 'needs contact.path'
refused 'contact={restitution: 1.1}' 'contact.restitution: "1.1" is out of range: it must be from 0 to 1'
refused 'contact={sliding: history, path: {B: [[300, -2, 0]]}}' 'place 1 of contact.path.B is 2 m inside'
refused 'cables.line={name: line, from: A, to: B, EA: 1 MN, rho: 1, sag: 9}' 'form finding does not know obstacles'
run statics "$sea" --method cone -q
try "a method that knows none" grep -q 'the method cone does not know obstacles' "$scratch/err"
run integrate "$scenes/net-impact.yaml" --until 1 --method theta -q
try "a scheme that knows none" grep -q 'the scheme theta does not know obstacles' "$scratch/err"
works "a mass that bounces" integrate "$scenes/net-impact.yaml" --until "0.6 s" --every "0.1 s" --json hit.json --tsv hit.tsv \
	--vtk hit --plot hit.svg --animate hit.gif --frames 3 -q
try "  columns" grep -q 'slack	touching	sliding	friction_J	impacts_J	apart_m$' hit.tsv
try "  three frames" python3 -S -c 'import sys; d = open("hit.gif", "rb").read()
sys.exit(d[:6] != b"GIF89a" or d.count(bytes([0x21, 0xf9, 4])) != 3)'
try "  states of nodes" grep -q '^SCALARS contact double 1$' hit-00006.vtk
python "  JSON" <<'END'
import json
r = json.load(open("hit.json"))
e = r["energy"]
assert r["touching"] == 7*[0] and r["contacts"] == [] and r["laws"] < 1e-12 and e["closure"] < 1e-12
assert abs(e["impacts"][-1] - 19.62*(1 - 0.49)) < 1e-9 and e["friction"][-1] == 0 and max(r["apart"]) == r["complementarity"]
END
refused 'obstacles.seabed.groove=yes' 'a groove is of circles'
refused 'obstacles.seabed.rotation=free' 'rotation is of a circle'
refused 'obstacles=[{circle: {centre: [200, -9], radius: 1}, rotation: free, velocity: 1}]' 'rotation is free: leave'
refused 'obstacles=[{circle: {centre: [200, -9], radius: 1}, inertia: 1}]' 'inertia is of a circle that turns'
refused 'obstacles.seabed={plane: {point: [0, 0], normal: [0, 1]}, side: around}' 'leave side out'
refused 'obstacles={name: s, segment: {from: [0, -1], to: [9, -1]}, side: around}' 'list of mappings'

run plan "$scenes/net-belt-driven.yaml" --set dynamics.surfaces=now
try "surfaces that move or start" grep -q 'dynamics.surfaces: "now" must be moving or start' "$scratch/err"
works "the picture of a belt, which has no support" statics "$scenes/net-belt.yaml" --plot belt.svg -q
run integrate "$scenes/net-belt.yaml" --until "1 ms" --set obstacles.s0.rotation=free --set obstacles.s0.friction=0.1 -q
try "a circle that turns, in time" grep -q 'rotation: free is not yet' "$scratch/err"
run integrate "$scenes/net-belt.yaml" --until "1 ms" --set 'loads={P: [0, 0, 1 N]}' -q
try "a groove and a load along z, in time" grep -q 'groove is not yet known' "$scratch/err"

# --- modes
works "modes: slip" modes "$sea" --set cables.line.elements=50 --contact slip -n 3 --shapes --json slip.json --tsv slip.tsv --vtk slip.vtk --plot slip.svg -q
try "  comment" grep -q '^# contact: 20 nodes of the mesh slip along obstacles, 0 stick$' slip.tsv
try "  states in VTK" grep -q '^SCALARS contact double 1$' slip.vtk
works "modes: stick" modes "$sea" --set cables.line.elements=50 --set contact.modes=stick -n 3 --json stick.json -q
python "  JSON" <<'END'
import json
slip, stick = (json.load(open(n + ".json")) for n in ("slip", "stick"))
assert slip["contact"] == "slip" and stick["contact"] == "stick"
assert {c["state"] for c in slip["contacts"]} == {"slip"} and {c["state"] for c in stick["contacts"]} == {"stick"}
assert all(a["omega"] < 0.9*b["omega"] for a, b in zip(slip["modes"], stick["modes"]))
# nodes that touch do not move along y; those that stick not at all
at = [c["S"] for c in slip["contacts"]]
for S, u in zip(slip["S"]["line"], slip["modes"][2]["shape"]["line"]):
    assert min(abs(S - a) for a in at) > 1 or abs(u[1]) < 1e-15
END
run modes "$sea" --contact sllip -q
try "modes: a misspelt state" grep -q 'slip' "$scratch/err"
run modes "$scenes/net-bars.yaml" --contact slip -q
try "modes: no obstacles" grep -q 'has no obstacles: add them' "$scratch/err"
run modes "$scenes/net-belt.yaml" --set 'nodes.P={}' -q
try "a belt without places" grep -q 'node P has no place' "$scratch/err"
run modes "$scratch/lie.yaml" --set "obstacles=[{circle: {centre: [5.1, 0], radius: 0.5}, side: around}]" -q
try "a belt that cuts a circle" grep -q 'cuts obstacle s0' "$scratch/err"
run modes "$scratch/top.yaml" -q
try "a mass that would slide off: status 2" test "$status" -eq 2
try "  message" grep -q 'is not stable' "$scratch/err"
run modes "$scratch/lie.yaml" -q
try "nodes that touch without force" grep -q 'touch an obstacle without force' "$scratch/err"

# --- a span with a plane is a net of one cable
works "a span on a seabed" statics "$scenes/span-seabed.yaml" --set cable.elements=50 --json span.json -q
works "  as a net" statics "$sea" --set cables.line.elements=50 --set 'contact={sliding: none}' --json net.json -q
works "  modes" modes "$scenes/span-seabed.yaml" --set cable.elements=50 -n 2 -q
python "  the same forces" <<'END'
import json
a, b = json.load(open("span.json"))["reactions"], json.load(open("net.json"))["reactions"]
assert all(abs(a[n][k] - b[n][k]) < 1e-6*abs(b["B"][1]) for n in "AB" for k in range(3))
END
run statics "$scenes/span-seabed.yaml" --set 'tension={T0: 9 kN}' -q
try "  without a length" grep -q 'give tension.length0' "$scratch/err"
run statics "$scenes/span-seabed.yaml" --set cable.element=9 -q
try "  a misspelt key" grep -q 'did you mean elements' "$scratch/err"
run statics "$scenes/span-seabed.yaml" --set cable.elements=9.5 -q
try "  half an element" grep -q 'is not a whole number' "$scratch/err"
run statics "$scenes/span-seabed.yaml" --set kind=net -q
try "  another kind" grep -q 'must be span' "$scratch/err"

# --- plan
works "plan" plan "$sea" --set cables.line.elements=50 --json plan.json -q
python "  what touches" <<'END'
import json
p = json.load(open("plan.json"))
say = {d["subject"]: d["why"] for d in p["decisions"]}
assert "seabed (21 nodes)" in say["contact"] and "contact.path" in say["friction"]
END
run statics "$sea" --equilibria 3 -q
try "equilibria: not yet" grep -q 'does not know obstacles in nets yet' "$scratch/err"
run statics "$sea" -q --set 'obstacles=[{circle: {centre: [200, 150], radius: 1 m}}]' --set 'contact={sliding: none}'
try "a circle between two nodes" grep -q 'on the side that is not above' "$scratch/err"
done_testing

#!/bin/sh
# hawser statics of nets on obstacles: text, JSON, picture, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scenes=$SRCDIR/notebooks-data/scenes
sea=$scenes/net-seabed.yaml
works "a mooring line" statics "$sea" --set cables.line.elements=50 --profile --json sea.json --tsv sea.tsv --plot sea.svg -q
try "  a comment for the obstacle" grep -q '^# seabed: 20 nodes touch, 200 m of unstretched length, .*; 0 stick, 20 slide$' sea.tsv
try "  columns of contact" grep -q '^cable	S_m	x_m	y_m	z_m	T_N	obstacle	r_N_N	r_T_N	contact$' sea.tsv
try "  a node that slides" grep -q '^line	10	.*	seabed	.*	slip$' sea.tsv
try "  the end is open" grep -q '^line	500	.*	-	0	0	open$' sea.tsv
try "  the picture" grep -q 'obstacles' sea.svg
python "JSON" <<'END'
import json
r = json.load(open("sea.json"))
c = r["contacts"]
assert len(c) == 20 and r["complementarity"] < 1e-12 and 0 <= r["gap"] < 1e-3
for one in c:
    assert one["obstacle"] == "seabed" and one["cable"] == "line" and one["state"] == "slip"
    assert abs(one["r_T"][0] + 0.1*one["r_N"]) < 1e-6 and one["position"][1] < 1e-12
A, B = r["reactions"]["A"], r["reactions"]["B"]
assert abs(A[1] + B[1] + sum(one["r_N"] for one in c) - 500*81.549439*9.81) < 1e-3
assert abs(A[0] + B[0] + sum(one["r_T"][0] for one in c)) < 1e-3
END
works "a drum" statics "$scenes/net-capstan.yaml" --json drum.json -q
python "  has no gap" <<'END'
import json
r = json.load(open("drum.json"))
assert r["gap"] is None and [c["state"] for c in r["contacts"]] == 10*["slip"]
assert abs(r["cables"][0]["T_to"]/r["cables"][0]["T_from"] - 2.588356) < 1e-6
END

# a key, a value, what the message has
refused() {
	run statics "$sea" --set "$1" -q
	try "refused: $1" test "$status" -eq "${3-1}"
	try "  $2" grep -qe "$2" "$scratch/err"
}
refused 'obstacles=[{plane: {point: [0, 1], normal: [0, 1]}}]' 'support A is 1 m inside obstacle s0'
refused 'obstacles=[{plane: {point: [0, -1], normal: [0, 1]}}, {plane: {point: [0, -2], normal: [0, -1]}}]' 'leave no room'
refused 'obstacles.seabed.friction=.inf' 'out of range'
refused 'obstacles.seabed.friction=.nan' 'obstacles.seabed.friction'
refused 'obstacles.seabed.friction=-1' 'must be >= 0'
refused 'obstacles.seabed.frictoin=1' 'did you mean friction'
refused 'obstacles.seabed.velocity=[0, 1 m/s]' 'along the normal of the plane'
refused 'obstacles.seabed.side=above' 'leave side out'
refused 'obstacles.seabed.groove=yes' 'not yet in nets'
refused 'obstacles=[{plane: {point: [0, 0], normal: [0, 0]}}]' 'no direction'
refused 'obstacles=[{segment: {from: [1, 0], to: [1, 0]}}]' 'one point'
refused 'obstacles=[{circle: {centre: [200 kg, -9], radius: 1}}]' 'circle.centre'
refused 'contact={sliding: history}' 'needs contact.path'
refused 'contact={restitution: 1.1}' 'above 1'
refused 'contact={sliding: history, path: {B: [[300, -2, 0]]}}' 'place 1 of contact.path.B is 2 m inside'
refused 'cables.line={name: line, from: A, to: B, EA: 1 MN, rho: 1, sag: 9}' 'form finding does not know obstacles'
run statics "$sea" --method cone -q
try "a method that knows none" grep -q 'the method cone does not know obstacles' "$scratch/err"
for command in modes plan; do
	run $command "$sea" -q
	try "$command: not yet" grep -q 'does not know obstacles in nets yet' "$scratch/err"
done
run integrate "$scenes/net-impact.yaml" --until 1 --method theta -q
try "a scheme that knows none" grep -q 'the scheme theta does not know obstacles' "$scratch/err"
works "a mass that bounces" integrate "$scenes/net-impact.yaml" --until "0.6 s" --every "0.1 s" --json hit.json --tsv hit.tsv \
	--vtk hit --plot hit.svg -q
try "  columns" grep -q 'slack	touching	sliding	friction_J	impacts_J	apart_m$' hit.tsv
try "  states of nodes" grep -q '^SCALARS contact int 1$' hit-00006.vtk
python "  JSON" <<'END'
import json
r = json.load(open("hit.json"))
e = r["energy"]
assert r["touching"] == 7*[0] and r["contacts"] == [] and r["laws"] < 1e-12 and e["closure"] < 1e-12
assert abs(e["impacts"][-1] - 19.62*(1 - 0.49)) < 1e-9 and e["friction"][-1] == 0 and max(r["apart"]) == r["complementarity"]
END
run statics "$sea" --equilibria 3 -q
try "equilibria: not yet" grep -q 'does not know obstacles in nets yet' "$scratch/err"
run statics "$sea" -q --set 'obstacles=[{circle: {centre: [200, 150], radius: 1 m}}]' --set 'contact={sliding: none}'
try "a circle between two nodes" grep -q 'on the side that is not above' "$scratch/err"
done_testing

#!/bin/sh
# hawser statics of nets: results, methods, tables, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
sketched

net=$SRCDIR/notebooks-data/scenes/net-table-3-1.yaml
for method in automatic interior-point cone forces catenary; do
	works "$method" statics "$net" --method $method --json $method.json -q
done
works "a table" statics "$net" --tsv net.tsv --plot net.svg -q
works "a profile" statics "$net" --profile --tsv profile.tsv --json profile.json -q
try "cables" test "$(grep -c '^c[0-9]' net.tsv)" -eq 26
try "points" test "$(grep -c '^c[0-9]' profile.tsv)" -eq 1601
try "places" grep -q '^# J0 = (3.14112947, -2.61800509, 0.0846971467) m$' net.tsv
try "the picture" grep -q 'K4' net.svg
python "the results of all methods" <<'END2'
import json
own = json.load(open("automatic.json"))
assert set(own) >= {"nodes", "cables", "reactions", "energy", "gap", "residual", "floor", "method", "iterations"}
assert list(own["reactions"]) == ["A%d" % i for i in range(7)]
assert abs(sum(f[1] for f in own["reactions"].values()) - 894.326688) < 1e-6
for name in ("interior-point", "cone", "forces", "catenary"):
    other, exact = json.load(open(name + ".json")), name == "catenary"
    assert other["method"] == name and 0 <= other["gap"] < 1e-12
    for node in own["nodes"]:
        assert max(abs(a - b) for a, b in zip(own["nodes"][node], other["nodes"][node])) < (1e-4 if exact else 1e-9)
    for a, b in zip(own["cables"], other["cables"]):
        assert abs(a["T_from"]/b["T_from"] - 1) < (2e-2 if exact else 1e-9) and a["slack"] == 0
rows = json.load(open("profile.json"))["profile"]
assert len(rows) == 26 and rows["c0"][0][1:4] == [0, 0, 0]
END2

cat >slack.yaml <<'END2'
kind: net
nodes: {A: [0 m, 0 m, 0 m], B: [10 m, 0 m, 0 m], J: {}, K: {}}
cables:
  - {name: a, from: A, to: J, EA: 1 MN, rho: 0, length0: 6 m, elements: 1}
  - {name: b, from: J, to: B, EA: 1 MN, rho: 0, length0: 6 m, elements: 1}
  - {name: tie, from: A, to: B, EA: 1 MN, rho: 0, length0: 11 m, elements: 1}
  - {name: c, from: J, to: K, EA: 1 MN, rho: 1 kg/m, length0: 1 m}
supports: {A: fixed, B: fixed}
loads: {J: [0 N, -1 kN, 0 N]}
END2
python "the same scene in JSON" <<'END2'
import json
bars = [{"name": c, "from": "AJ"[c == "b"], "to": "JB"[c == "b"], "EA": 1e6, "rho": 0, "length0": 6} for c in "ab"]
for indent in (None, 1):
    with open(f"bars{indent}.json", "w") as file:
        json.dump({"kind": "net", "nodes": {"A": [0, 0, 0], "B": [10, 0, 0], "J": {}}, "cables": bars,
                   "supports": {"A": "fixed", "B": "fixed"}, "loads": {"J": [0, -1e3, 0]}}, file, indent=indent)
END2
works "JSON in one line" statics barsNone.json -q
works "JSON in lines" statics bars1.json -q
works "a slack member" statics slack.yaml --tsv slack.tsv --json slack.json -q
try "is named" grep -q '^# 1 cable with elements without tension: tie$' slack.tsv
works "a force density" statics slack.yaml --json density.json -q \
	--set 'cables.a={name: a, from: A, to: J, EA: 1 MN, rho: 0, force_density: 90 N/m, elements: 1}'
works "on another mesh" statics slack.yaml --json density7.json -q \
	--set 'cables.a={name: a, from: A, to: J, EA: 1 MN, rho: 0, force_density: 90 N/m, elements: 7}'
python "the shape of two bars, the hanging cable, the force density" <<'END2'
import json, math
slack = json.load(open("slack.json"))
y = slack["nodes"]["J"][1]
stretched = 6*(1 + slack["cables"][0]["T_max"]/1e6)
assert abs(math.hypot(5, y) - stretched) < 1e-12 and slack["cables"][2]["T_max"] == 0
load = 1000 + 9.81
assert abs(2*slack["cables"][0]["T_max"]*(-y)/stretched - load) < 1e-8
assert abs(slack["cables"][3]["T_from"] - 9.81) < 1e-6 and slack["mesh_error"]["tension"] < 1e-3
found = json.load(open("density.json"))
cable = found["cables"][0]
assert abs(cable["T_from"]/math.hypot(*found["nodes"]["J"]) - 90) < 1e-7
fine = json.load(open("density7.json"))
assert all(abs(a - b) < 1e-9 for a, b in zip(found["nodes"]["J"], fine["nodes"]["J"]))
assert abs(fine["cables"][0]["T_from"]/cable["T_from"] - 1) < 1e-9
assert abs(cable["length0"]*(1 + cable["T_from"]/1e6) - cable["length"]) < 1e-9
END2

denies "an option of spans" 1 "\-\-points is for spans and spans over obstacles, and .* is a net" statics "$net" --points 20
denies "an option of nets" 1 "\-\-profile is for nets and ropeways, and .* is a span" statics "$chairlift" --profile
denies "a command of spans" 1 "is a net of cables, which hawser campbell does not take; these commands do: plan, statics, modes" campbell "$net"
denies "an unknown method" 1 "must be one of automatic, interior-point" statics "$net" --method gauss
denies "a node that no cable reaches" 1 "no cable and no body reaches node X" check "$net" --set 'nodes.X={}'
loose='cables.c25={name: c25, from: X, to: Y, EA: 1 MN, rho: 1 kg/m, length0: 9 m}'
set -- --set 'nodes.X={}' --set 'nodes.Y={}' --set "$loose"
denies "a part without support" 2 "the nodes X, Y has no support in direction x" statics "$net" "$@"
denies "modes of it" 2 "the nodes X, Y has no support in direction x" modes "$net" "$@"
denies "motion of it" 2 "the nodes X, Y has no support in direction x" integrate "$net" --until 1 "$@"
denies "form finding by catenaries" 1 "takes cables with length0 only, and cable a has tension" statics slack.yaml \
	--method catenary --set 'cables.a={name: a, from: A, to: J, EA: 1 MN, rho: 0, tension: 5 N}'
denies "a density that no length has" 2 "the lengths that go with the given force densities" statics slack.yaml \
	--set 'cables.c={name: c, from: J, to: K, EA: 1 MN, rho: 1 kg/m, force_density: 0.25 N/m}'
denies "a tension that no shape has" 2 "the tension of c came to 100, and 5 is given" statics slack.yaml \
	--set 'cables.c={name: c, from: J, to: K, EA: 1 MN, rho: 0, tension: 5 N}' --set 'loads.K=[0 N, -100 N, 0 N]'
denies "a sag that no shape has" 2 "the sag of tie came to" statics slack.yaml \
	--set 'cables.tie={name: tie, from: A, to: B, EA: 1 MN, rho: 0, sag: 1 m}'
denies "a cable that is too short" 1 "slack.yaml:6:5: cable tie: .* a strain of 100 %: correct length0" statics slack.yaml \
	--set cables.tie.length0="5 m"
denies "two nodes in one place" 1 "A and B are in one place: correct their" statics slack.yaml --set 'nodes.B=[0 m, 0 m, 0 m]'
denies "a place that is not a number" 1 'nodes.B: "nan" is not a number' statics slack.yaml --set 'nodes.B=[nan, 0 m, 0 m]'
denies "a stiffness without bound" 1 'cables.a.EA: "inf N" is not a number' statics slack.yaml --set 'cables.a.EA=inf N'
denies "a cable from a node to itself" 1 "begins and ends at node A: give two nodes" statics slack.yaml --set cables.tie.to=A
run statics slack.yaml -q --set cables.a.length0="2 m" --set cables.b.length0="2 m"
try "cables much too short are solved" test "$status" -eq 0
try "and warned of" grep -q "2 cables are stretched by more than 50 %, most of all [ab], by 15[01] %" "$scratch/err"
denies "no length" 1 "is out of range" statics slack.yaml --set cables.a.length0="0 m"
sed 's/name: a, /&sag: 1 m, /' slack.yaml >twice.yaml
denies "two lengths" 1 "cables.a[.a-z0]* contradicts cables.a.*: give one of" statics twice.yaml
works "  one in the place of the other" check slack.yaml --set 'cables.a.sag=1 m'
denies "a million elements" 1 "elements need about" statics slack.yaml --set cables.c.elements=90000000
denies "a wrong key" 1 "unknown key" statics slack.yaml --set cables.a.EE=1
denies "a wrong name" 1 "there is no node Q" statics slack.yaml --set cables.a.from=Q

# B Table 3.1 with N/15 elements a cable, 2 or more: the least energy as a cone program has it (cvxopt).
awk '{
	if (match($0, /elements: [0-9]+/)) {
		n = int(substr($0, RSTART + 10, RLENGTH - 10)/15)
		sub(/elements: [0-9]+/, "elements: " (n < 2 ? 2 : n))
	}
	print
}' "$net" >coarse.yaml
works "a coarse mesh" statics coarse.yaml --json coarse.json -q
python "  has the energy of a cone program" <<'END'
import json
assert abs(json.load(open("coarse.json"))["energy"] + 1750.05326321) < 1e-8
END

# Jayaraman, Knudson, Computers & Structures 14 (1981) 175: 1000 ft, 3.16 lb/ft, 0.85 in2, 19e6 psi, 8 kip;
# the displacements of a mesh of 1600 elements were computed by another program.
cat >point.yaml <<'END2'
kind: net
g: 9.80665
nodes: {A: [0, 0, 0], B: [304.8, 0, 0], J: {}}
cables:
  - {name: a, from: A, to: J, EA: 71838779.08645707, rho: 4.70259806167979, length0: 125.84695176, elements: 640}
  - {name: b, from: J, to: B, EA: 71838779.08645707, rho: 4.70259806167979, length0: 186.85526256, elements: 960}
supports: {A: fixed, B: fixed}
END2
works "a cable of two parts" statics point.yaml --json before.json -q
works "a load between them" statics point.yaml --set 'loads={J: [0, -35585.772921284, 0]}' --json after.json -q
python "its displacement in feet" <<'END2'
import json
J = [json.load(open(name + ".json"))["nodes"]["J"] for name in ("before", "after")]
for a, b, published in zip(*J, (-2.81944, -18.45673)):
    assert abs((b - a)/0.3048 - published) < 1e-5, (b - a)/0.3048
END2

# Round-off of the positions, which is 9 N of tension here, excuses no force in what is slack.
cat >beside.yaml <<'END2'
kind: net
nodes: {A: [-3.9 m, -3.3 m, -3.7 m], B: {}}
supports: {A: fixed}
masses: {B: 4.7 kg}
cables:
  - {name: taut, from: A, to: B, EA: 110 kN, rho: 0.11, length0: 1.225 m, elements: 8}
  - {name: longer, from: A, to: B, EA: 1.8e14, rho: 4.6, length0: 1.29 m, elements: 8}
END2
works "a rigid cable that is longer than the taut one beside it" statics beside.yaml --json beside.json -q
python "its last element is slack, so that the taut one has all of the mass" <<'END2'
import json
taut, longer = json.load(open("beside.json"))["cables"]
assert abs(longer["T_to"] - 4.6*1.29/16*9.81) < 1e-6 and longer["slack"] == 1
assert abs(taut["T_to"] - 9.81*(4.7 + 4.6*1.29/16)) < 1e-8
END2

bars=$SRCDIR/notebooks-data/scenes/net-bars.yaml
works "bars" statics "$bars" --equilibria 2000 --tsv bars.tsv --json bars.json --plot bars.svg -q
try "their number" grep -q '^# 13 equilibria from 2000 random starts' bars.tsv
works "the same net of cables" statics "$bars" --json cables.json -q
python "the equilibrium of the cables is the only one without compression" <<'END2'
import json
bars, cables = json.load(open("bars.json")), json.load(open("cables.json"))
assert bars["bars"] == 4 and bars["unknowns"] == 9 and len(bars["equilibria"]) == 13
taut = [one for one in bars["equilibria"] if one["compressed"] == 0]
assert len(taut) == 1 and taut[0]["unstable"] == 0 and all(o["unstable"] for o in bars["equilibria"] if o != taut[0])
for node, x in cables["nodes"].items():
    assert max(abs(a - b) for a, b in zip(x, taut[0]["nodes"][node])) < 1e-9
assert abs(taut[0]["energy"] - cables["energy"]) < 1e-12
END2
denies "too many bars" 1 "the mesh has 4683 unknowns, and the search takes 1 to 90" statics "$net" --equilibria 10
denies "bars of a span" 1 "\--equilibria is for nets" statics "$SRCDIR/notebooks-data/scenes/chairlift.yaml" \
	--equilibria 10
done_testing

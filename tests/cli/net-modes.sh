#!/bin/sh
# hawser modes of nets: frequencies, planes and symmetry, shapes, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

net=$SRCDIR/notebooks-data/scenes/net-table-3-1.yaml
works "the net of Table 3.1" modes "$net" -n 6 --json table.json --tsv table.tsv -q
try "no symmetry" grep -q '^# no plane of symmetry$' table.tsv
try "none is missed" grep -q '^# no mode is missed: .* has 6 negative eigenvalues, as many' table.tsv

# A web of four spokes, turned by 30 degrees; cables that cross in the hub.
cat >web.yaml <<'END'
kind: net
nodes: {H: {}, J0: {}, J1: {}, J2: {}, J3: {}, A0: [8.660254037844386, 1, -5], A1: [-5, 1, -8.660254037844386],
  A2: [-8.660254037844386, 1, 5], A3: [5, 1, 8.660254037844386]}
cables:
END
for i in 0 1 2 3; do
	echo "  - {name: s$i, from: A$i, to: J$i, EA: 1 MN, rho: 0.8 kg/m, length0: 5 m, elements: 4}"
	echo "  - {name: h$i, from: H, to: J$i, EA: 1 MN, rho: 0.8 kg/m, length0: 5 m, elements: 4}"
	echo "  - {name: r$i, from: J$i, to: J$(((i + 1) % 4)), EA: 1 MN, rho: 0.8 kg/m, length0: 7.2 m, elements: 4}"
done >>web.yaml
echo 'supports: {A0: fixed, A1: fixed, A2: fixed, A3: fixed}' >>web.yaml
works "a web" modes web.yaml -n 8 --json web.json --tsv web.tsv -q
works "its picture and VTK" modes web.yaml -n 4 --plot web.svg --vtk web.vtk -q
try "titles" grep -q '1:  ' web.svg
try "symmetry in the picture" grep -q 'anti/sym' web.svg
python "the file of VTK, read strictly" <<'END'
import json, math
lines = open("web.vtk").read().split("\n")
assert lines[0] == "# vtk DataFile Version 3.0" and lines[2:4] == ["ASCII", "DATASET POLYDATA"] and lines[-1] == ""
words = iter(" ".join(lines[4:]).split())
def head(*want):
    for word in want:
        got = next(words)
        assert word is None or got == word, (got, word)
        last = got
    return int(last)
def floats(count):
    values = [float(next(words)) for _ in range(count)]
    assert all(map(math.isfinite, values))
    return values
head("FIELD", "FieldData", "1")
head("omega_rad_s", "1", "4")
assert next(words) == "double"
omega = floats(4)
points = head("POINTS", None)
assert next(words) == "double"
x = floats(3*points)
cells = head("LINES", None)
assert int(next(words)) == 3*cells
for _ in range(cells):
    two, a, b = (int(next(words)) for _ in range(3))
    assert two == 2 and 0 <= a < b < points
head("CELL_DATA", str(cells))
assert [next(words) for _ in range(6)] == ["SCALARS", "cable", "double", "1", "LOOKUP_TABLE", "default"]
assert sorted(set(floats(cells))) == list(range(1, 13)) and points == cells + 12 == 60
head("POINT_DATA", str(points))
modes = json.load(open("web.json"))["modes"]
for mode in modes[:4]:
    assert [next(words) for _ in range(3)] == ["VECTORS", "mode_%d" % mode["index"], "double"]
    u = floats(3*points)
    assert max(abs(a - b) for a, b in zip(u[12:15], mode["nodes"]["J0"])) < 1e-8
    assert abs(omega[mode["index"] - 1]/mode["omega"] - 1) < 1e-8
assert next(words, None) is None
END
works "a web with a mass on a joint" modes web.yaml -n 8 --set 'masses={J1: 0.5 kg}' --json one.json -q
works "and another on the next" modes web.yaml -n 8 --set 'masses={J1: 0.5 kg, J2: 0.6 kg}' --json none.json -q
try "the planes" test "$(grep -c '^# mirror plane [12] through' web.tsv)" -eq 2
try "the turn" grep -q '^# a turn by 1/4 about the axis through .* along (0, 1, 0) maps the net onto itself$' web.tsv
try "columns" grep -q '	symmetry	symmetry_2	waves	pair	residual	' web.tsv

# A span of two parts in the plane at 30 degrees, whose joint is held along y; and a slack cable beside it.
cat >span.yaml <<'END'
kind: net
nodes: {A: [0, 0, 0], J: [17.320508075688775 m, 0, -10 m], B: [34.64101615137755, 0, -20]}
cables:
  - {name: c1, from: A, to: J, EA: 1 MN, rho: 0.5 kg/m, length0: 20.1 m, elements: 9}
  - {name: c2, from: B, to: J, EA: 1 MN, rho: 0.5 kg/m, length0: 20.1 m, elements: 9}
supports: {A: fixed, B: fixed, J: {fixed: [y]}}
END
works "a span" modes span.yaml -n 6 --json span.json --tsv span.tsv --shapes -q
printf 'kind: net\nnodes: {A: [0, 0, 0], J: {}, B: [0, -5, 0]}\ncables:\n' >slack.yaml
for cable in "{name: a, from: A, to: J, EA: 1 MN, rho: 0.001 kg/m, length0: 1 m, elements: 1}" \
	"{name: b, from: J, to: B, EA: 1 MN, rho: 0.001 kg/m, length0: 5 m, elements: 1}"; do
	echo "  - $cable"
done >>slack.yaml
printf 'supports: {A: fixed, B: fixed}\nmasses: {J: 9 kg}\n' >>slack.yaml
works "a slack cable" modes slack.yaml -n 2 --json slack.json --tsv slack.tsv -q
try "is named" grep -q '^# 1 element without tension: no stiffness$' slack.tsv
works "no mass in it" modes slack.yaml --set cables.a.rho=0 --set cables.b.rho=0 --json light.json -q

python "frequencies, labels, shapes" <<'END'
import json, math
load = lambda name: json.load(open(name))
table = load("table.json")
# a judge's values, with consistent masses: those of the mean matrix are 1e-5 to 4e-5 lower
for mode, judge in zip(table["modes"], (2.71636, 2.94317, 3.52947, 3.83021)):
    assert 0 < 1 - mode["omega"]/judge < 4e-5 and mode["residual"] < 1e-9
assert table["certificate"]["modes"] == 6 and table["certificate"]["complete"]
assert all(mode["plane"] is None and mode["symmetry"] is None and mode["pair"] is None for mode in table["modes"])

web = load("web.json")
planes = web["symmetry"]["mirrors"]
assert len(planes) == 2 and web["symmetry"]["turns"] == 4 and web["symmetry"]["plane"] is None
assert all(plane["places"] < 1e-8 and abs(plane["normal"][1]) < 1e-9 for plane in planes)
angles = [math.degrees(math.atan2(-p["normal"][2], p["normal"][0])) % 90 for p in planes]
assert max(abs(angle - 30) for angle in angles) < 1e-6, angles
pairs = 0
for mode in web["modes"]:
    assert mode["symmetry"] in ("symmetric", "antisymmetric") and (mode["waves"] == 1) == (mode["pair"] is not None)
    assert all(abs(p) > 1 - 1e-9 for p in mode["parity"]["mirrors"])
    if mode["pair"] and mode["pair"] <= len(web["modes"]):
        other = web["modes"][mode["pair"] - 1]
        assert other["pair"] == mode["index"] and abs(other["omega"]/mode["omega"] - 1) < 1e-9
        assert other["symmetry"] != mode["symmetry"] and other["symmetry_2"] != mode["symmetry_2"]
        pairs += 1
assert pairs >= 2
assert len(load("one.json")["symmetry"]["mirrors"]) == 1 and load("one.json")["modes"][0]["symmetry"]
assert load("none.json")["symmetry"]["mirrors"] == [] and load("none.json")["modes"][0]["symmetry"] is None

span = load("span.json")
assert [round(n, 9) for n in span["symmetry"]["plane"]["normal"]] in ([0.5, 0, 0.866025404], [-0.5, 0, -0.866025404])
for mode in span["modes"]:
    J = mode["nodes"]["J"]
    assert J[1] == 0 and len(mode["shape"]["c1"]) == 10 and mode["shape"]["c1"][-1] == J
    assert mode["family"] == "transverse" and mode["symmetry"] in ("symmetric", "antisymmetric")
    across = abs(J[0]*0.5 + J[2]*0.866025404)
    assert mode["plane"] == "in-plane" and across < 1e-9 or mode["plane"] == "out-of-plane"
assert {mode["plane"] for mode in span["modes"]} == {"in-plane", "out-of-plane"}

# pendulum on a bar of length l with tension T; the slack bar gives it 5/12 of its mass and no stiffness
for name, mass in (("slack.json", 0.001), ("light.json", 0)):
    slack = load(name)
    T = 9.81*(9 + 3*mass)
    l, m = 1 + T/1e6, 9 + 6*5/12*mass
    assert slack["slack"] == 1 and slack["certificate"]["complete"] and slack["symmetry"]["straight"]
    assert [mode["plane"] for mode in slack["modes"][:2]] == ["in-plane", "out-of-plane"]
    assert all(abs(mode["omega"]/math.sqrt(T/l/m) - 1) < 1e-9 for mode in slack["modes"][:2])
END

denies "an option of spans" 1 "\-\-method is for spans, and web.yaml is a net" modes web.yaml --method spectral
denies "another name for VTK" 1 "must end in .vtk" modes web.yaml --vtk web.vtu
denies "a span in VTK" 1 "\-\-vtk is for nets" modes "$chairlift" --vtk web.vtk
denies "too many modes" 1 "the mesh has 123 unknowns with mass: ask for 1 to 123 modes, not 1000" modes web.yaml -n 1000
denies "a slack mesh" 2 "cable b is slack in the equilibrium, and without its stiffness a part of the net is not held" modes \
	slack.yaml --set cables.b.elements=2 --set cables.b.rho=0
denies "no mass" 2 "nothing that can move has a mass" modes slack.yaml --set cables.a.rho=0 --set cables.b.rho=0 \
	--set 'masses={}' --set 'loads={J: [0 N, -3 N, 0 N]}'
denies "neither slack nor taut" 2 "cable . has an element that is neither slack nor taut in the equilibrium" modes slack.yaml \
	--set g=0 --set 'nodes.B=[0, -6, 0]'
done_testing

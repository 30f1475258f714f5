#!/bin/sh
# Loads of nets: carriers that pass, and loads of a part of a cable.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

net() { # net NAME C2: a span on each side of an insulator; the rest of the scene is standard input
	cat >"$1.yaml"
	cat >>"$1.yaml" <<END
kind: net
nodes: {A: [0, 0, 0], J: [300, 0, 0], B: [600, 0, 0], P: [300, 3, 0]}
cables:
  - {name: c1, from: A, to: J, EA: 120 MN, rho: ${3:-6}, length0: 301.2 m, elements: 24}
  - {name: c2, $2, EA: 120 MN, rho: ${3:-6}, length0: 301.2 m, elements: 24}
  - {name: i, from: P, to: J, EA: 30 MN, rho: 20, length0: 3 m, elements: 1}
supports: {A: fixed, B: fixed, P: fixed}
damping: {alpha: 0.24}
END
}
weights="weight: 2943 N, spacing: 60 m, harmonics: 2"
echo "passing: [{along: [c1, c2], $weights}]" | net passing "from: J, to: B"
echo "passing: [{along: [c1, c2], $weights}]" | net turned "from: B, to: J"
echo "passing: [{along: [c2, c1], $weights}]" | net back "from: J, to: B"
echo "passing: [{along: [c1, c2], mass: 300 kg, spacing: 60 m, harmonics: 2}]" | net mass "from: J, to: B"
net waves "from: J, to: B" <<'END'
loads:
  c1:
    - {per_length: [0, -49.05, 0]}
    - {per_length: [0, -98.1, 0], harmonic: {multiple: 1, wavelength: 60}}
    - {per_length: [0, -98.1, 0], harmonic: {multiple: 2, wavelength: 30}}
  c2:
    - {per_length: [0, -49.05, 0]}
    - {per_length: [0, -98.1, 0], harmonic: {multiple: 1, wavelength: 60, phase: -31.541590242041522}}
    - {per_length: [0, -98.1, 0], harmonic: {multiple: 2, wavelength: 30, phase: -63.083180484083044}}
END
echo "loads: {c1: [{per_length: [0, 0, 3]}, {per_length: [0, -98.1, 0], harmonic: {multiple: 1}}]}" |
	net whole "from: J, to: B"
net parts "from: J, to: B" <<'END'
loads:
  c1:
    - {per_length: [0, 0, 3], extent: [0, 0.37]}
    - {per_length: [0, 0, 3], extent: [0.37, 1]}
    - {per_length: [0, -98.1, 0], harmonic: {multiple: 1}, extent: [0, 0.61]}
    - {per_length: [0, -98.1, 0], harmonic: {multiple: 1}, extent: [0.61, 1]}
END
for name in passing turned back mass waves whole parts; do
	works "a model of $name" rom $name.yaml -n 4 --json $name.json -q
done
python "loads" <<'END'
import json
m = {n: json.load(open(n + ".json")) for n in ("passing", "turned", "back", "mass", "waves", "whole", "parts")}
forces = lambda name: [h["f"] for h in m[name]["harmonics"] if any(h.get("f", []))]
def off(a, b): # but for the signs of modes
    most = max(abs(x) for f in forces(a) for x in f)
    return max(abs(abs(x) - abs(y)) for f, g in zip(forces(a), forces(b)) for x, y in zip(f, g))/most
assert off("passing", "waves") < 1e-9, off("passing", "waves")
assert off("passing", "turned") < 1e-6, off("passing", "turned")
assert off("passing", "back") < 1e-6 # the line is symmetric
assert off("whole", "parts") < 1e-9, off("whole", "parts")
first = lambda name: m[name]["K"][0][0]/m[name]["scale"]["time"]**2
assert abs(first("whole")/first("parts") - 1) < 1e-9
# their mean weight stretches both alike; their mean mass, 5 kg/m, moves too
assert 0.7 < (first("mass")*11/first("passing")/6) < 1.1, (first("mass"), first("passing"))
END
works "damping by axial" rom "$SRCDIR/notebooks-data/scenes/net-crosstie.yaml" -n 4 --json axial.json -q
works "  and as a damper" rom "$SRCDIR/notebooks-data/scenes/net-crosstie.yaml" -n 4 --set cables.tie.axial=0 \
	--set "cables.tie.damper=3.6363636363636363 kN.s/m" --json damper.json -q
python "a damper is axial damping" <<'END'
import json
a, b = (json.load(open(n + ".json"))["D"] for n in ("axial", "damper"))
most = max(abs(x) for row in a for x in row)
assert max(abs(x - y) for r, s in zip(a, b) for x, y in zip(r, s)) < 1e-12*most
END
# An absorber in the middle of a span.
cat >span.yaml <<'END'
cable: {EA: 120 MN, rho: 6 kg/m}
span: {d: 300 m, h: 0 m}
tension: {length0: 301.2 m}
attach:
  - {at: 50 %, absorber_mass: 60 kg, absorber_stiffness: 300 N/m, absorber_direction: [0, 1, 0]}
END
cat >hangs.yaml <<'END'
kind: net
nodes: {A: [0, 0, 0], J: {}, B: [300, 0, 0], M: {}}
cables:
  - {name: c1, from: A, to: J, EA: 120 MN, rho: 6, length0: 150.6 m, elements: 40}
  - {name: c2, from: J, to: B, EA: 120 MN, rho: 6, length0: 150.6 m, elements: 40}
  - {name: s, from: J, to: M, EA: 1200 N, rho: 0, length0: 4 m, elements: 1}
supports: {A: fixed, B: fixed}
masses: {M: 60 kg}
END
works "modes of a span with an absorber" modes span.yaml -n 8 --json span.json -q
works "  and of a net with a mass that hangs" modes hangs.yaml -n 10 --json hangs.json -q
python "a mass that hangs is an absorber" <<'END'
import json
span, net = (json.load(open(n + ".json"))["modes"] for n in ("span", "hangs"))
all_of_net = [m["omega"] for m in net]
for m in span: # in symmetric ones alone, since the net's swings along x where the span's moves with the cable
    if m["plane"] == "in-plane" and m["symmetry"] == "symmetric":
        near = min(all_of_net, key=lambda w: abs(w - m["omega"]))
        assert abs(near/m["omega"] - 1) < 1e-4, (m["omega"], all_of_net)
END
denies "a damper of a cable without length" 1 "has a damper and no length0" check passing.yaml --set cables.c1.damper=3 \
	--set cables.c1.length0= --set cables.c1.sag=3
echo "passing: [{along: [c1, c2], $weights, speed: 13 m/s}]" | net speed "from: J, to: B"
works "a motion at a speed" integrate speed.yaml --until 0.05 --every 0.05 --json motion.json -q
rough "a response begins below its frequency, and says which it is" frf speed.yaml -n 2 --max-points 2 --certificate no --tsv slow.tsv -q
try "  13 m/s at 60 m" awk '/own speed, 13 m.s, is Omega = 1.36135682 / {said = 1} /^[0-9]/ {print $1; exit !(said && $1 < 1.1)}' slow.tsv
works "a response" frf "$SRCDIR/notebooks-data/scenes/net-crosstie.yaml" --from "4.2 rad/s" --to "4.21 rad/s" -n 4 --certificate no \
	--plot places.gp --json response.json -q
try "  at both joints" test "$(grep -c "title 'J[12]'" places.gp)" = 2
works "the motion of all nodes" orbit response.json#1 --animate all.gif --frames 9 --tsv orbit.tsv -q
try "  frames" python3 -S -c 'import sys; d = open("all.gif", "rb").read()
sys.exit(d[:6] != b"GIF89a" or d.count(bytes([0x21, 0xf9, 4])) != 8)'
works "a response of a file" frf axial.json --from 1.07w3 --to 1.075w3 --json response.json -q
denies "the motion of a file" 1 "--animate is for nets and ropeways, and axial.json is none" orbit response.json#1 --animate all.gif
crosstie=$SRCDIR/notebooks-data/scenes/net-crosstie.yaml
works "models beside the mesh" compare "$crosstie" --fidelities "condensed 4, condensed 9" --from 1w3 --to 1.03w3 \
	--json compare.json -q
python "the larger one is nearer" <<'END'
import json
r = json.load(open("compare.json"))
row = {f["name"]: f for f in r["fidelities"]}
assert r["reference"] == "mesh" and row["mesh"]["coordinates"] == 303
four, nine = (row[n]["folds"]["Omega_error"] for n in ("condensed 4", "condensed 9"))
assert 8e-4 < four < 1.3e-3 and 3e-4 < nine < 0.6*four, (four, nine)
assert all(row[n]["folds"]["missing"] == row[n]["peaks"]["missing"] == 0 for n in row)
END
# A span as nets have it in tests/reference: the folds of the mesh there.
cat >certified.yaml <<'END'
cable: {EA: 1e8, rho: 5.56}
span: {d: 300, h: 15}
tension: {length0: 300.657021107}
damping: {alpha: 0.2}
load: {frame: global, per_length: [0.8, 0.8, 0.8]}
END
works "a span in its mesh" frf certified.yaml -n 6 --from 1.165 --to 1.195 --certificate yes --json certified.json -q
run frf span.yaml -n 2 --from 1.05w1 --to 1.051w1 --certificate yes --set damping.ratio=0.1 \
	--set "attach[0].absorber_direction=[1, 1, 0]" --set "load={frame: global, per_length: [0, 0, 1]}" -q
try "  not with oblique absorbers" grep -q "not corrected in a mesh: .*its absorber_direction is oblique" "$scratch/err"
python "  has the folds of a net" <<'END'
import json
r = json.load(open("certified.json"))
folds = sorted(l["Omega_mesh"] for l in r["certified"]["landmarks"] if l["kind"] == "fold")
assert abs(folds[0]/1.169214179 - 1) < 1e-6 and abs(folds[1]/1.190553850 - 1) < 1e-6, folds
of = r["model_error"] # z moves three times as far as y
assert r["certified"]["refused"] == 0 and 4e-3 < of["estimated"] < 6e-3 and 1e-2 < of["smaller"] < 3e-2, of
END
denies "a form that nets have not" 1 "raw 4: of nets and ropeways, condensed N and multiple-scales N" compare "$crosstie" \
	--fidelities "raw 4"
denies "multiple scales alone" 1 "name condensed N too" compare "$crosstie" --fidelities "multiple-scales 4"
denies "nothing driven and damped" 1 "the load drives no damped mode" compare mms "$crosstie" -n 4 --set damping.ratio=0 \
	--set cables.tie.axial=0
denies "a cable that is not there" 1 "passing\[0\].along: there is no cable c9" check passing.yaml \
	--set "passing=[{along: [c9], $weights}]"
denies "carriers without a weight" 1 "passing\[0\] needs weight or mass, and not both" check passing.yaml \
	--set "passing=[{along: [c1], spacing: 60}]"
denies "with both" 1 "passing\[0\] needs weight or mass" check passing.yaml --set "passing=[{along: [c1], $weights, mass: 300}]"
denies "one away from the rope" 1 "cable i does not begin where the one before it ends" check back.yaml \
	--set "passing=[{along: [c2, c1, i], $weights}]"
denies "a part of a cable by catenaries" 1 "takes loads of whole cables" statics parts.yaml --method catenary
done_testing

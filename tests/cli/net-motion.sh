#!/bin/sh
# hawser integrate of nets: results, runs that go on bit by bit, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >net.yaml <<'END'
kind: net
nodes: {A: [0 m, 0 m, 0 m], J: {}, B: [15 m, 1 m, 0 m], C: [7 m, 3 m, 6 m]}
cables:
  - {name: c1, from: A, to: J, EA: 100 kN, rho: 0.5 kg/m, length0: 8 m, elements: 6}
  - {name: c2, from: J, to: B, EA: 100 kN, rho: 0.5 kg/m, length0: 8.5 m, elements: 6}
  - {name: c3, from: J, to: C, EA: 100 kN, rho: 0.5 kg/m, length0: 7 m, elements: 5}
supports:
  A: fixed
  C: {table: C.txt}
  B: {motion: {x: {amplitude: 0.4 m, Omega: 3 rad/s}, z: {amplitude: 0.3 m, Omega: 2 rad/s, phase: 0.4}}}
masses: {J: 2 kg}
loads:
  J: {force: [5 N, 0 N, 10 N], harmonic: {Omega: 4 rad/s}}
  c1: {per_length: [0 N/m, 0 N/m, 1 N/m], harmonic: {Omega: 2.5 rad/s}}
damping: {alpha: 0.1 kg/m/s, axial: 1e-4}
END
printf '# t x y z\n0 0 0 0\n0.5 0.1 0 0.1\n1.2 0 0.2 0\n3 0 0 0\n' >C.txt
for step in "2 ms" auto; do
	works "a run, $step" integrate net.yaml --until "2 s" --every "0.1 s" --step "$step" --probe J,c2:0.4 \
		--json whole.json --tsv whole.tsv --state whole.state --vtk frame -q
	works "its half" integrate net.yaml --until "1 s" --every "0.1 s" --step "$step" --state half.state -q
	works "and the other" integrate net.yaml --until "2 s" --every "0.1 s" --step "$step" --probe J,c2:0.4 \
		--initial half.state --state second.state --json second.json -q
	try "they are one run, bit by bit" cmp whole.state second.state
	python "the ledger closes; the second half has the rows of the whole" <<'END'
import json
whole, second = json.load(open("whole.json")), json.load(open("second.json"))
assert whole["energy"]["closure"] < 1e-10, whole["energy"]["closure"]
assert whole["energy"]["work"][-1] != 0 and whole["energy"]["dissipated"][-1] > 0
assert len(whole["times"]) == 21 and list(whole["probes"]) == ["J", "c2:0.4"]
for name in whole["probes"]:
    assert whole["probes"][name]["x"][10:] == second["probes"][name]["x"]
END
done
works "by CVODE, with an error" integrate net.yaml --until "2 s" --every "0.1 s" --method cvode --probe J,c2:0.4 \
	--error --json cvode.json -q
python "within the stated errors" <<'END'
import json
one, other = json.load(open("whole.json")), json.load(open("cvode.json"))
assert other["error"]["from"] == "another run" and one["error"]["from"] == "local errors"
assert 0 < other["error"]["position"] < 1e-5 < one["error"]["position"] < 1e-2
assert other["scheme"] == "cvode" and other["energy"]["closure"] < 1e-6
off = max(abs(a - b) for name in one["probes"] for x, y in zip(one["probes"][name]["x"], other["probes"][name]["x"])
          for a, b in zip(x, y))
assert 0 < off < 1.5*one["error"]["position"], (off, one["error"])
END
try "21 files of VTK" test "$(find . -name 'frame-*.vtk' | wc -l)" -eq 21

sed 's/B: {motion/B: {fixed: [y], motion/' net.yaml >held.yaml
works "directions that are moved are held, listed or not" integrate held.yaml --until "0.5 s" --step "5 ms" --state held.state -q
works "as if all were" integrate net.yaml --until "0.5 s" --step "5 ms" --state all.state -q
try "they are one run" cmp held.state all.state

sed -e 's/elements: [0-9]*/elements: 1/' -e 's/0.5 kg.m/0/' -e '/^masses/d' net.yaml >massless.yaml
denies "no end" 1 "give the end of its motion" integrate net.yaml
denies "no mass" 1 "node J has none" integrate massless.yaml --until "1 s"
denies "an option of models" 1 "\-\-Omega 1 is of a model of the net: give -n" integrate net.yaml --until "1 s" --Omega 1
denies "an option of nets" 1 "\-\-step is for the mesh of --model fe: give that" integrate "$chairlift" --Omega 1 --step 1
denies "an unknown scheme" 1 "the schemes of nets are" integrate net.yaml --until "1 s" --method gauss
denies "one in the scene, by its place" 1 "there is no scheme gauss: the schemes are energy, alpha" integrate net.yaml --until "1 s" --set 'dynamics={scheme: gauss}'
denies "an unknown probe" 1 "neither a node of the net nor a place" integrate net.yaml --until "1 s" --probe c1:2
denies "a table that ends" 1 "and the run is from 0 to" integrate net.yaml --until "4 s"
denies "a long name" 1 "with commas between them" integrate net.yaml --until "1 s" --probe ,
denies "too many rows" 1 "choose a longer time between them" integrate net.yaml --until "1 s" --every "1e-9 s"
denies "another's state" 1 "is no state of this net" integrate net.yaml --until "1 s" --initial C.txt
sed -e 's/from: J, to: C/from: J, to: A/' -e 's/  C: {table/  C: fixed #/' net.yaml >other.yaml
denies "that of a net with as many nodes" 1 "joins them in another way" integrate other.yaml --until "2 s" --initial half.state
denies "no state" 1 "cannot read the state in" integrate net.yaml --until "1 s" --initial none.txt
printf '0 0 0 0\n' >C.txt
denies "a table of one time" 1 "needs two times at least" integrate net.yaml --until "1 s"
printf '0 0 0 0\n0 1 1 1\n' >C.txt
denies "times that stand" 1 "is not after that of the line before" integrate net.yaml --until "1 s"
printf '0 0 0\n' >C.txt
denies "three numbers" 1 "a line must have 4 numbers" integrate net.yaml --until "1 s"
rm C.txt
denies "no table" 1 "the table with the motion of a support cannot be read" integrate net.yaml --until "1 s"
# Strong axial damping from a state in motion: forces of damping have the round-off of displacements over
# the step, c ulp(u)/h, below which no step comes. CVODE is the judge.
cat >whip.yaml <<'END'
kind: net
nodes: {A: [0 m, 0 m, 0 m], B: [1.5 m, 0 m, 0 m]}
cables: [{name: c, from: A, to: B, EA: 750.77 N, rho: 0.03324 kg/m, length0: 1.8 m, elements: 20}]
supports: {A: fixed, B: fixed}
dynamics: {release: [B]}
END
works "a cable let go" integrate whip.yaml --until "0.5 s" --state whip.state -q
for scheme in energy alpha theta cvode; do
	works "then damped by 10 s, $scheme" integrate whip.yaml --until "0.55 s" --every "0.05 s" --initial whip.state \
		--set 'damping={axial: 10}' --method $scheme --json whip-$scheme.json -q
done
python "all at one place" <<'END'
import json
x = {s: json.load(open(f"whip-{s}.json"))["probes"]["B"]["x"][-1] for s in ("energy", "alpha", "theta", "cvode")}
assert all(abs(a - b) < 2e-4 for s in x for a, b in zip(x[s], x["cvode"])), x
END

# Recoil: the end that is let go has moved by 0.090 m after 0.1 s (outside program), with axial damping of
# 0.002 s by 0.085 m. A mesh without damping has 0.12 m, whatever its elements, and states so; by default it
# has the damping that fronts need, and its error falls with the elements.
cat >recoil.yaml <<'END'
kind: net
nodes: {A: [0 m, 0 m, 0 m], B: [100 m, 0 m, 0 m]}
cables: [{name: c, from: A, to: B, EA: 1 MN, rho: 2 kg/m, length0: 110 m, elements: 80}]
supports: {A: fixed, B: fixed}
dynamics: {release: [B]}
END
for n in 20 160; do
	works "recoil of $n elements" integrate recoil.yaml --until "0.1 s" --set cables.c.elements=$n \
		--json front-$n.json --tsv front.tsv
done
try "  its damping is named" grep -q '^# fronts behind which the cable is slack: damping.axial is 0.000486 s' front.tsv
"$HAWSER" integrate recoil.yaml --until "0.1 s" --set 'damping={axial: 0}' --json recoil.json --tsv recoil.tsv 2>recoil.err
try "undamped recoil warns" grep -q 'waves that make the cable slack have no damping: give damping.axial' recoil.err
try "  its fronts are named" grep -q '^# fronts behind which the cable is slack: with damping.axial = 0.00194' recoil.tsv
works "damped recoil" integrate recoil.yaml --until "0.1 s" --set cables.c.elements=160 --set 'damping={axial: 0.002}' --json damped.json
python "the error is stated" <<'END'
import json
for n, most in (20, 6e-3), (160, 1.5e-3): # the outside program's figure is known to 0.0005 m
    front = json.load(open(f"front-{n}.json"))
    off = abs(100 - front["probes"]["B"]["x"][-1][0] - 0.090)
    assert off < most and off < front["error"]["shock"] + 5e-4 < 2*most, (n, off, front["error"])
one, damped = json.load(open("recoil.json")), json.load(open("damped.json"))
x = 100 - one["probes"]["B"]["x"][-1][0]
assert abs(x - 0.090) < 1.1*one["error"]["shock"] and one["error"]["shock"] < 0.05
assert abs(100 - damped["probes"]["B"]["x"][-1][0] - 0.085) < 1e-3 and damped["error"]["shock"] is None
END

# in water: the views of the net at rest, and its surface in an animation
cp "$SRCDIR/notebooks-data/scenes/net-current.yaml" current.yaml
works "a net in water is drawn" statics current.yaml --set cables.c.elements=20 --plot current.svg -q
try "  with the surface" grep -q 'surface of the water' current.svg
works "  and in motion" integrate current.yaml --set cables.c.elements=20 --until 2 --every 1 --animate current.gif --frames 2 -q \
	--set water.depth=200 --set 'water.waves={height: 4 m, period: 9 s}'

# a line that snaps in waves without damping along it: the tensions are not to be believed
cat >snaps.yaml <<'END'
kind: net
water: {density: 1025, depth: 150, waves: {height: 8, period: 9}}
nodes: {A: [0, -150, 0], B: [90, -120, 0]}
supports: {A: fixed, B: {motion: {y: {amplitude: 3, Omega: 1.5}}}}
cables: [{name: c, from: A, to: B, EA: 700 MN, rho: 95, length0: 105, diameter: 0.25, drag: {normal: 1.1}, elements: 12}]
obstacles: [{plane: {point: [0, -150], normal: [0, 1]}, stiffness: 300 kPa/m}]
END
"$HAWSER" integrate snaps.yaml --until 5 --every 1 --set dynamics.step=0.02 --tsv snaps.tsv 2>snaps.err
try "waves along a cable without damping are warned of" grep -q 'slack and taut .* give damping.axial' snaps.err
rm snaps.tsv
"$HAWSER" integrate snaps.yaml --until 5 --every 1 --set dynamics.step=0.02 --set 'damping={axial: 0.01}' --tsv snaps.tsv 2>snaps.err
try "  not with damping" sh -c 'test -s snaps.tsv && ! grep -q "slack and taut" snaps.err'

# the beginning of a motion on a bed that gives way is at rest, whatever moves later
cat >begins.yaml <<'END'
kind: net
water: {density: 1025, depth: 30, surface: 30}
nodes: {A: [0, 0, 0], M: [500, 0, 0], B: [560, 28, 0]}
supports: {A: fixed, B: fixed}
cables:
  - {name: c, from: A, to: M, EA: 600 MN, rho: 88.4, length0: 500, diameter: 0.0766, elements: 20, drag: {normal: 2}}
  - {name: d, from: M, to: B, EA: 600 MN, rho: 88.4, length0: 67, diameter: 0.0766, elements: 10, drag: {normal: 2}}
obstacles: [{plane: {point: [0, 0], normal: [0, 1]}, stiffness: 3 MPa/m}]
END
begin=0
for more in water.surface=30 'loads={M: {force: [0, 20 kN, 0], harmonic: {Omega: 6}}}' 'water.waves={height: 4, period: 9}' \
	'supports.B={motion: {y: {amplitude: 2, Omega: 3}}}' 'supports.B={motion: {y: {amplitude: 2, Omega: 6}}}'; do
	"$HAWSER" integrate begins.yaml --until 0.1 --every 0.1 --probe M -q --set "$more" --json "begins$((begin += 1)).json"
done 2>begins.err
python "a motion begins at rest, whatever moves later" <<'END'
import json
rest, loaded, waves, slow, fast = [json.load(open(f"begins{n}.json"))["probes"]["M"]["x"][0] for n in range(1, 6)]
assert rest == loaded == waves and slow == fast != rest, (rest, loaded, waves, slow, fast)
END

done_testing

#!/bin/sh
# What is refused, and in which words: messages of the program that no other test here provokes.
# `make check-provoked` tells which those are.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scenes=$top/notebooks-data/scenes
beam=$scenes/d-figure-9.9.yaml
pair=$top/tests/reference/pair-2to1.json

# --- numbers and frequencies
refuses_like 1 'has natural frequencies w1 to w1' frf "$duffing" --from 0.6w2 --to 2
refuses_like 1 'no unit of time; write a plain number' frf "$duffing" --from '1 Hz' --to 2
refuses_like 1 'no unit of time; write a plain number' integrate "$duffing" --Omega 1 --until '1 s'
refuses_like 1 'or write a multiple of a natural frequency' frf "$chairlift" --from '1 kg' --to 3w1
refuses_like 1 'or write a number of periods' integrate "$chairlift" --Omega 1w1 --until '1 kg'
refuses_like 1 'must be greater than zero and finite' frf "$duffing" --from 0 --to 2
refuses_like 1 'must be greater than zero and finite' statics "$chairlift" --compatibility --from '-1 N'
refuses_like 1 'has these parameters: none' frf "$duffing" --from 1 --to 2 --set g=1
refuses_like 1 'more than .* times --set' frf "$duffing" $(i=0; while [ $i -lt 70 ]; do
	echo --set g=1; i=$((i + 1)); done)

# --- integrate
refuses_like 1 'makes .* rows: choose a longer interval' \
	integrate "$duffing" --Omega 1 --until 1e12T --every 0.001T
refuses_like 1 'too few rows for a picture' \
	integrate "$duffing" --Omega 1 --until 1T --every 1T --plot out.svg
refuses_like 1 'a spectrum needs .* rows or more' \
	integrate "$duffing" --Omega 1 --until 1T --every 0.5T --spectrum
refuses 1 "cannot read .: Is a directory" integrate "$duffing" --Omega 1 --initial .

# --- statics
printf 'cable: {EA: .inf, rho: 6}\nspan: {d: 250, h: 0}\ntension: {H: 8e4}\n' >stiff.yaml
refuses_like 2 'of an inextensible cable have epsilon = 0 everywhere' \
	statics stiff.yaml --compatibility --plot out.svg

# --- mms
refuses_like 1 'part of the range, at most 1' mms "$duffing" --step 2
refuses_like 1 'are the same frequency' mms "$duffing" --from 1 --to 1
refuses_like 1 'model.modes: auto chooses by the load' compare mms "$chairlift" --set model.modes=auto
sed 's/"f": \[[^]]*\]/"f": [0]/' "$duffing" >unloaded.json
refuses_like 1 'the load drives no mode at its own frequency: name one with --mode' mms unloaded.json
refuses_like 1 'the load has no component on mode 1' mms unloaded.json --mode 1
sed 's/"D": \[\[[^]]*\]\]/"D": [[0]]/' "$duffing" >undamped.json
refuses_like 1 'without damping its resonance has no peak' mms undamped.json --mode 1

# --- hill
refuses 1 '--mathieu, --forced and --orbit are different questions: choose one' \
	hill "$duffing" --forced --orbit
refuses_like 1 "is that of Mathieu's equation" hill "$duffing" --damping 0.1 --Omega 1
refuses_like 1 'boundaries are about rest' hill "$duffing" --orbit --x Omega=1:2 --y factor.load=0:1
refuses_like 1 'is a scene of a beam: hawser beam tells its stability' hill "$beam" \
	--x beam.v=0:1 --y beam.theta=1:2

# --- beam
refuses_like 1 'eigenvalues at one speed are no picture' beam "$beam" --plot out.svg
refuses_like 1 'cannot read missing: No such file' beam "$beam" --until 1 --initial missing
printf '0 0\n0.5 x\n1 0\n' >shape
refuses_like 1 'after 1 lines: a shape is 2 to' beam "$beam" --until 1 --initial shape
printf '0 0\n0.5 1e999\n1 0\n' >shape
refuses_like 1 'after 2 lines: a shape is 2 to' beam "$beam" --until 1 --initial shape
refuses_like 1 'is beyond double precision' beam "$beam" --to 1e999
refuses_like 1 'at most .* values' beam "$beam" --vary beam.rho=0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17
refuses_like 1 'at least 1' beam "$beam" --basis -1
refuses_like 1 'both axes are' map "$beam" --x beam.v=0:1 --y beam.v=0:2 --points 3x3

# --- damping
refuses_like 1 'cannot read missing: No such file' damping missing
refuses_like 1 'cannot read .: Is a directory' damping .
printf '0 0\n1 1\n' >short
refuses_like 1 'is for scenes; damping reads a table' damping short --set g=1
refuses_like 1 'give at least' damping short
refuses_like 1 'a confidence between 0 and 1' damping short --confidence 2
refuses_like 1 'points: give at least 5' damping short --half-power
refuses_like 1 '--y 0: short has no such column' damping short --y 0
refuses_like 1 '--x time: short has no such column' damping short --x time
refuses_like 1 'short:1: no number in column 3' damping short --y 3
printf 'Omega\tx\n1\t1\n2\t2\n3\t3\n2.5\t2\n2\t1\n' >folded
refuses_like 1 'the frequencies turn back at point 4 .*lower load' damping folded --half-power
awk 'BEGIN { for (i = 0; i < 40; i++) print (i == 20 ? 1 : i)/10, cos(i) }' >times
refuses_like 1 'times must ascend' damping times
awk 'BEGIN { for (i = 0; i < 40; i++) print i, (i == 20 ? "1e999" : cos(i)) }' >times
refuses_like 3 'is not finite' damping times
awk 'BEGIN { for (i = 0; i < 40; i++) print i, exp(-i/10) }' >times
refuses_like 1 'half-cycles stand out: give at least two whole cycles' damping times
awk 'BEGIN { for (i = 0; i < 9; i++) print 9 - i, 1 }' >curve
refuses_like 1 'frequencies must ascend from above zero' damping curve --half-power
awk 'BEGIN { for (i = 1; i < 9; i++) print i, 1 }' >curve
refuses_like 2 'does not fall to 0.707' damping curve --half-power

# --- maps and their kin
refuses_like 1 'both axes are Omega' map "$duffing" --x Omega=1:2 --y Omega=1:2
refuses_like 1 'with an accuracy in percent' compare "$chairlift" --from 1w1 --to 2w1 --fidelities auto:99%

# --- spans, modes and studies
travelling=$scenes/b-table-5.4.yaml
resting=$scenes/b-table-5.4-at-rest.yaml

# span EA RHO D H: --set of a span; tension H NEWTON
span() {
	echo "--set cable.EA=$1 --set cable.rho=$2 --set span.d=$3 --set span.h=$4"
}
moves() {
	echo "--set travel.fluctuation=0 --set travel.speed=$1 --set travel.hold=$2"
}
refuses_like 1 'must be finite' beam "$beam" --to .inf
refuses_like 3 'eigenvalue problems were not enough for the speeds from 0 to 100' \
	beam "$beam" --to 100 --points 2 --basis 8 --modes 8
refuses_like 3 'were not found \(LAPACK [0-9]+\): .*weight 1e\+308 is too large' \
	beam "$beam" --set beam.rho=1e308
refuses_like 3 'theta 1 and tension 1e\+308 .* beyond double precision' \
	beam "$beam" --set beam.mu=1e154
refuses_like 1 'is beyond double precision' statics "$chairlift" --set 'cable.EA=1e308 MN'
refuses_like 1 'the range has no point of the curve' mms "$duffing" --from 0.0001 --to 0.0002
refuses_like 3 'no method gave a result; fdm-source ended before it began.*left to itself: 270 finite' \
	compare modes "$travelling" --modes 45 --method fdm-source --from 20 --to 2
refuses_like 2 'no default range: where this cable is taut its strain' \
	irvine "$chairlift" --set cable.EA=36800
refuses_like 2 'is faster than waves along it, sqrt\(EA/rho\) = 8164.96' \
	irvine "$chairlift" --speeds '9000 m/s' --from 1e3 --to 1e4
refuses_like 2 'the tension must be above rho v\^2 = 60000 N' \
	irvine "$chairlift" --speeds '100 m/s' --sweep T0 --from 1e3 --to 1e6
refuses_like 2 'no multipliers at 2, .* \(no-state\): leave that out' \
	hill "$chairlift" --set model.modes=1 --x Omega=1:2 --y tension.T0=10:80000
awk 'BEGIN { for (i = 0; i < 40; i++) print i, (i%2 ? -1 : 1)*exp(-i/10) }' >twice
refuses_like 3 'do not determine frequency and damping: give more' damping twice
awk 'BEGIN { for (i = 0; i < 40; i++) print i, exp(-i/100)*cos(3.11018*i + 0.3) }' >near
refuses_like 3 'do not determine frequency and damping: give more' damping near
auto='--set model.modes=auto --set model.condense=static'
# shellcheck disable=SC2086 # words
refuses_like 3 'with [0-9]+ coordinates takes more than 3 points, and no accuracy' \
	frf "$chairlift" $auto --from 0.9w1 --to 0.95w1 --max-points 3
mkdir programs
printf '#!/nonexistent\n' >programs/gnuplot
chmod +x programs/gnuplot
full_path=$PATH
PATH=$PWD/programs:$PATH
refuses_like 4 'cannot run .*programs/gnuplot: No such file' frf "$duffing" --from 0.9 --to 1 --plot out.svg
PATH=$full_path

# sizes so far apart that numbers leave the range
stretched="$(span 1e-15 1e167 80 5) --set tension.H=1e150"
# shellcheck disable=SC2086
refuses_like 3 'finite-difference matrix of 35 points is singular' \
	modes "$resting" $stretched --method fdm
# shellcheck disable=SC2086
refuses_like 3 'not-a-number with 60 finite-difference points' \
	modes "$travelling" $stretched $(moves 1e-100 tension) --method fdm-source
# shellcheck disable=SC2086
refuses_like 3 'have 0 oscillating modes where 9 were requested' \
	modes "$travelling" $stretched $(moves 0.9999999e-91 tension) --method fdm-source
# shellcheck disable=SC2086
run modes "$travelling" $stretched $(moves 1e-92 tension)
try "the share of waves downstream stays in the range" test "$status" -eq 0
# shellcheck disable=SC2046
refuses_like 3 'the shape of mode 1 came out as not a number' modes "$resting" --modes 5 \
	$(span 4.5547595858010041e-152 6.4443130328160991e+112 7.9928673681085698e+33 5.9329553243412398e+38) \
	--set tension.H=9.1695435895629825e+53 --set model.basis=10
# shellcheck disable=SC2046
refuses_like 3 'the shape of mode 2 came out as not a number' \
	modes "$travelling" --modes 5 --method analytic \
	$(span 22157323230704944 5.2608645129465791e-10 2.2168175582336823e-24 1.2977907712841669e-30) \
	--set tension.H=9.694076182463547e-15 $(moves 9379966.9286914058 length)
# shellcheck disable=SC2046
refuses_like 3 'relative error of mode 1 of 5 \(out-of-plane, 4.75776e-142 rad/s\) is 1.0e\+00, so that its frequency is unknown' \
	modes "$travelling" --modes 5 --set model.basis=10 \
	$(span 3.3543599439329144e+91 6.674178449555647e-191 9.2665905967909386e+29 9.1429569919551388e+37) \
	--set tension.H=4.0846059059407531e-35 $(moves 6.4213082748628247e+140 length)
# the longitudinal modes that a small basis carries are 1/sqrt(epsilon) above the transverse ones
refuses_like 3 'in-plane mode 5 lies too far above the lowest one \([0-9.]* in' \
	modes "$resting" --modes 15 --set model.basis=5 --set cable.EA=1e60
refuses_like 3 'in-plane mode 5 lies too far above the lowest one \([0-9.]* in' \
	modes "$travelling" --modes 10 --set model.basis=5 --set cable.EA=1e60
# of what no method knows anything no number is shown, at rest and travelling, by any method; but
# compare modes measures it
refuses_like 3 'mode 1 of 5 .*1.0e\+00, .*method fdm, a basis of 60\): take the method spectral$' \
	modes "$resting" --modes 5 --method fdm --basis 60 --set cable.EA=1e20
refuses_like 3 'mode 1 of 5 .*method spectral, a basis of 2\): raise model.basis, or leave it out$' \
	modes "$resting" --modes 5 --basis 2 --set tension.H=30
refuses_like 3 'mode 6 of 9 .*, or ask for the lowest 5, which are known$' \
	modes "$chairlift" --modes 9 --basis 3
refuses_like 3 'so that its frequency is unknown \(method fdm-source, a basis of 60\)' \
	modes "$travelling" --modes 5 --method fdm-source --set cable.EA=1e20
refuses_like 3 'so that its frequency is unknown' irvine "$resting" -n 2 \
	--set model.basis=4 --from 30 --to 40
run compare modes "$resting" --modes 5 --method fdm --set cable.EA=1e20 --to 60
try "compare modes takes what the method says nothing of" test "$status" -eq 0
sed 's/^  H:.*/  length0: 1/' "$travelling" >by-length.yaml
# shellcheck disable=SC2046
refuses_like 2 'the least tension of this span exceeds the range' statics by-length.yaml \
	$(span 2.5488396765084198e-139 4.1310261270430848e+127 7.4574363611606174e+45 -6.5186540236090243e+47) \
	--set tension.length0=3.6012149159833731e-105 $(moves 3.064695540672245e-13 tension)
# shellcheck disable=SC2046
refuses_like 3 'the profile misses end B by 5.5.*e-199 m with the unstretched length' \
	statics by-length.yaml --set travel.speed=0 --set travel.fluctuation=0 \
	$(span 1.7569677343013463e-200 4.8590841396538378e+133 3.4661775015074426e-191 -5.5038497815367173e-199) \
	--set tension.length0=3.4648312702066508e-191
# shellcheck disable=SC2046
refuses_like 2 'with the horizontal tension H = .* exceeds the range' statics "$travelling" \
	$(span .inf 4.8970541377842826e+194 3.6971839866703892e-186 0) \
	--set tension.H=2.8764707611459698e+19 $(moves 1 tension)

# --- responses
# model NAME N D K Q C f [K of the harmonic]
model() {
	printf '{"hawser_rom": 1, "n": %s, "D": %s, "K": %s, "Q": %s, "C": %s, "harmonics": [{"k": 1, "phase": "cos", "omega_power": 0, "f": %s%s}]}\n' \
		"$2" "$3" "$4" "$5" "$6" "$7" "${8:+, \"K\": $8}" >"$1"
}
light='[[0.05, 0], [0, 0.05]]'
model off.json 2 "$light" '[[1, 0.1], [0.1, 4]]' '[]' '[]' '[0.01, 0]'
model turning.json 2 '[[0.1, 0.1], [-0.1, 0.1]]' '[[1, 0], [0, 4]]' '[[0, 0, 0, 1], [1, 1, 1, 1]]' '[]' '[0.01, 0]'
model falling.json 2 "$light" '[[-1, 0], [0, 4]]' '[]' '[]' '[0.01, 0]'
refuses_like 1 'K is not diagonal' frf off.json --from 0.9 --to 1.1 --backbone 1
refuses_like 1 'is gyroscopic .*and without symmetry' frf turning.json --from 0.9 --to 1.1 --backbone 1
refuses_like 1 'mode 1 has no positive stiffness' frf falling.json --from 0.9 --to 1.1 --backbone 1
refuses_like 3 'was found near mode 1: another mode is in resonance' \
	frf "$pair" --from 0.9 --to 1.1 --backbone 1
refuses_like 1 'the exact strain energy has no quadratic and cubic terms' \
	mms "$chairlift" --set model.energy=exact

# a branch whose ends are near a fold, in a discretisation as coarse as can be
echo '-1.00622679813633 0.40030970132575' >second
refuses_like 3 'the corrector failed at the end of the range' \
	frf "$duffing" --from 1.11570034 --to 0.5 --start second --method shooting
echo '-0.1148 3.4158' >first
refuses_like 3 'was lost when its mesh was refined' \
	frf "$duffing" --from 1.264 --to 2 --start first --method balance --tolerance 1e-3
model slow.json 1 '[[1e-4]]' '[[1]]' '[]' '[[0, 0, 0, 0, 0.1]]' '[1e-3]'
refuses_like 3 'needs more than 4000 integration steps a period for tolerance' \
	frf slow.json --from 4e-4 --to 0.01 --method shooting --segments 1 --tolerance 1e-13
refuses_like 3 'the sweep at Omega 0.0001 needs more than 20000 integration steps' \
	frf slow.json --from 1e-4 --to 2e-4 --max-points 3 --sweep up --sweep-points 2
model escape.json 1 '[[0.05]]' '[[1]]' '[]' '[[0, 0, 0, 0, -1]]' '[0.5]'
refuses_like 3 'grows without bound, even with' \
	frf escape.json --from 4 --to 0.9 --max-points 3 --sweep up --sweep-points 3
refuses_like 3 'the motion has faster parts than the basis of this full-order model resolves' \
	frf "$chairlift" --set model.energy=exact --set model.basis=2 --set tension.T0=2MN --from 0.2w1 \
	--to 0.3w1 --set 'load.per_length=[4000, 4000, 4000]' --tolerance 1e-6
model phase.json 2 "$light" '[[1, 0], [0, 1e8]]' '[]' '[]' '[0.1, 0]' '[[0, 0], [0, -1e8]]'
refuses_like 3 'the stiffness of the fast coordinates is singular at some phase' \
	frf phase.json --from 0.5 --to 1.5
# what shooting finds, and no 120 harmonics do
sed 's/"harmonics": \[.*/"harmonics": [{"k": 1, "f": [1.8e-4]}, {"k": 30, "f": [0.18]}]/' "$duffing" >high.json
refuses_like 3 'none of [0-9]* folds of the response could be converged as a fold' \
	folds high.json --from 0.045 --to 0.036 --load-from 0.9 --load-to 1 --no-isolas --method shooting

# numbers too far apart
refuses_like 3 'multipliers at Omega 1e-06 need about .* steps a period' hill "$duffing" --Omega 1e-6
model apart.json 2 '[[1e200, 0], [0, 0.05]]' '[[1e300, 1e300], [1e300, 1e300]]' '[]' '[]' '[0, 0]'
# which of the two comes first, the BLAS decides
refuses_like 3 '(a step of the variational equations at Omega 1e\+300 is singular|the transition matrix of a period is not finite)' \
	hill apart.json --Omega 1e300
refuses_like 3 'CVODE stopped at t = 0 with code -22' \
	integrate "$duffing" --Omega 1 --until 1e-300 --every 1e-301 --method adams
model drift.json 1 '[[0]]' '[[1e-300]]' '[]' '[]' '[0]'
echo '0 1e308' >far
refuses_like 3 'the displacement of coordinate 0 at t = 1.8 is inf' \
	integrate drift.json --Omega 1 --until 1.8 --every 1.8 --initial far --method gauss

# reduced models of travelling cables
refuses_like 1 'a model whose speed changes once and for all .* has no periodic response to export' \
	rom "$scenes/b-table-5.5.yaml" --export auto stem
works 'a model of a travelling cable' rom "$scenes/b-table-5.3.yaml" -n 2 --json - -q
sed 's/"mach2": *[0-9.e-]*/"mach2": 1.5/' "$scratch/out" >fast.json
refuses_like 1 'shapes.mach2 is 1.5; a number from 0 to below 1 is wanted' frf fast.json --from 1w1 --to 2w1

# --- moving supports
anchorage=$scenes/stay-anchorage.yaml
refuses_like 1 'support contradicts travel' rom "$travelling" --set 'support.B.motion=[0, 1 mm, 0]'
refuses_like 1 'does not know the motion of supports' \
	frf "$anchorage" --from 0.9w1 --to 1.1w1 --set model.modes=auto
refuses_like 1 'support.B.harmonic = 0|it must be' rom "$anchorage" --set support.B.harmonic=0
refuses_like 1 'support.A.motion is missing' rom "$anchorage" --set support.A.phase=0
works 'a model with a moving end' rom "$anchorage" -n 2 --json ends.json -q
python 'and four that are wrong' <<'END'
import json
for name in ("k", "few", "slope", "shapes"):
    r = json.load(open("ends.json"))
    if name == "k":
        r["ends"]["k"][0] = 0.5
    elif name == "few":
        r["ends"]["k"] = []
    elif name == "slope":
        r["ends"]["slope"] = []
    else:
        del r["shapes"]
        for h in r["harmonics"]:
            h.pop("answer", None)
    json.dump(r, open(name + ".json", "w"))
END
refuses_like 1 'ends.k\[0\] is 0.5; an integer from 0 to' frf k.json --from 1w1 --to 2w1
refuses_like 1 'ends.k: a list of 1 to' frf few.json --from 1w1 --to 2w1
refuses_like 1 'ends.slope: a list of 1 to' frf slope.json --from 1w1 --to 2w1
refuses_like 1 'ends: there are no shapes' frf shapes.json --from 1w1 --to 2w1
works 'moving supports are planned for' plan "$anchorage" --from 0.9w1 --to 0.91w1 --fidelities "raw 3"
try 'the plan says what the motion adds' grep -q 'motion of the supports.* mode choice (auto)$' "$scratch/out"

# --- elastic supports
mast=$scenes/stay-mast.yaml
refuses_like 1 'support contradicts travel' modes "$travelling" --set 'support.B.stiffness=[1e6, .inf, .inf]'
refuses_like 1 'support.A.stiffness is missing' modes "$mast" --set support.A.mass=3
refuses_like 1 'support.B.stiffness.*must be > 0 or .inf' modes "$mast" \
	--set 'support.B.stiffness=[0, 1e6, .inf]'
refuses_like 1 'for ends that stay where they are' statics "$mast" --model parabola --set 'load.static={mass: 1}'
refuses_like 1 'at an end that is rigid' modes "$mast" --set 'support.B.stiffness=[.inf, .inf, .inf]'
refuses_like 1 'springs join the planes' irvine "$mast" --set 'load.static.per_length=[0, 0, 9]'
refuses_like 1 'masses or springs' rom "$mast" --set 'load.static.per_length=[0, 0, 9]' \
	--set 'support.A.motion=[0, 1 mm, 0]'
works 'elastic supports in a wind' frf "$mast" --set 'load.static.per_length=[0, 0, 9]' \
	--from 0.99w1 --to 1.01w1 --json - -q
refuses_like 1 'support contradicts travel' campbell "$mast" --from 1 --to 9 \
	--set 'travel={speed: 1 m/s, hold: tension}'
refuses_like 1 'not weighed|does not know elastic' \
	frf "$mast" --from 0.9w1 --to 1.1w1 --set model.modes=auto --set model.condense=static
works 'elastic supports, condensed' rom "$mast" --set model.condense=static --json - -q
works 'a response with an elastic support' frf "$mast" --from 0.98w1 --to 1.02w1 --json - -q
try 'the scene of a result has its stiffness' grep -q '"stiffness": \[3000000.0, ".inf", 900000.0\]' \
	"$scratch/out"
done_testing

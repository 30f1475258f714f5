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
refuses_like 1 'applies to scenes only' frf "$duffing" --from 1 --to 2 --set g=1
refuses_like 1 'more than .* times --set' frf "$duffing" $(i=0; while [ $i -lt 70 ]; do
	echo --set g=1; i=$((i + 1)); done)

# --- integrate
refuses_like 1 'makes .* rows: choose a longer interval' \
	integrate "$duffing" --Omega 1 --until 1e12T --every 0.001T
refuses_like 1 'too few rows for a picture' \
	integrate "$duffing" --Omega 1 --until 1T --every 1T --plot out.svg
refuses_like 1 'a spectrum needs .* rows or more' \
	integrate "$duffing" --Omega 1 --until 1T --every 0.5T --spectrum
refuses 4 "cannot read .: Is a directory" integrate "$duffing" --Omega 1 --initial .

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
refuses_like 1 'the load does not meet mode 1' mms unloaded.json --mode 1
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
refuses_like 4 'cannot read missing: No such file' beam "$beam" --until 1 --initial missing
printf '0 0\n0.5 x\n1 0\n' >shape
refuses_like 1 'after 1 lines: a shape is 2 to' beam "$beam" --until 1 --initial shape
printf '0 0\n0.5 1e999\n1 0\n' >shape
refuses_like 1 'after 2 lines: a shape is 2 to' beam "$beam" --until 1 --initial shape
refuses_like 1 'is beyond double precision' beam "$beam" --to 1e999
refuses_like 1 'at most .* values' beam "$beam" --vary beam.rho=0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17
refuses_like 1 'at least 1' beam "$beam" --size -1
refuses_like 1 'both axes are' map "$beam" --x beam.v=0:1 --y beam.v=0:2 --points 3x3

# --- damping
refuses_like 4 'cannot be opened' damping missing
refuses_like 4 'cannot be read' damping .
printf '0 0\n1 1\n' >short
refuses_like 1 'is for scenes; damping reads a table' damping short --set g=1
refuses_like 1 'give at least' damping short
refuses_like 1 'a confidence between 0 and 1' damping short --confidence 2
refuses_like 1 'points: give at least 5' damping short --half-power
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

# --- responses
# model NAME N D K Q C f [K of the harmonic]
model() {
	printf '{"hawser_rom": 1, "n": %s, "D": %s, "K": %s, "Q": %s, "C": %s, "harmonics": [{"k": 1, "phase": "cos", "omega_power": 0, "f": %s%s}]}\n' \
		"$2" "$3" "$4" "$5" "$6" "$7" "${8:+, \"K\": $8}" >"$1"
}
light='[[0.05, 0], [0, 0.05]]'
model off.json 2 "$light" '[[1, 0.1], [0.1, 4]]' '[]' '[]' '[0.01, 0]'
model turning.json 2 '[[0.1, 0.1], [-0.1, 0.1]]' '[[1, 0], [0, 4]]' '[]' '[]' '[0.01, 0]'
model falling.json 2 "$light" '[[-1, 0], [0, 4]]' '[]' '[]' '[0.01, 0]'
refuses_like 1 'K is not diagonal' frf off.json --from 0.9 --to 1.1 --backbone 1
refuses_like 1 'the model is gyroscopic' frf turning.json --from 0.9 --to 1.1 --backbone 1
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
	frf "$scenes/deep-sag.yaml" --set model.energy=exact --set model.basis=1 --from 0.2w1 --to 1.2w1 \
	--set 'load.per_length=[3 N/m, 3 N/m, 3 N/m]' --tolerance 1e-6
model phase.json 2 "$light" '[[1, 0], [0, 1e8]]' '[]' '[]' '[0.1, 0]' '[[0, 0], [0, -1e8]]'
refuses_like 3 'the stiffness of the fast coordinates is singular at some phase' \
	frf phase.json --from 0.5 --to 1.5
# what shooting finds, and no 120 harmonics do
sed 's/"k": 1/"k": 30/' "$duffing" >high.json
refuses_like 3 'none of 2 folds of the response could be converged as a fold' \
	folds high.json --from 0.0333 --to 0.05 --load-to 1 --no-isolas --method shooting

# numbers too far apart
refuses_like 3 'multipliers at Omega 1e-06 need about .* steps a period' hill "$duffing" --Omega 1e-6
model apart.json 2 '[[1e200, 0], [0, 0.05]]' '[[1e300, 1e300], [1e300, 1e300]]' '[]' '[]' '[0, 0]'
refuses_like 3 'a step of the variational equations at Omega 1e\+300 is singular' \
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
done_testing

#!/bin/sh
# The command line: exact output of what a wrong one gets, and what a right one may look like.
# SPDX-License-Identifier: GPL-3.0-or-later
built=$PWD/man
. "$SRCDIR/tests/cli/lib.sh"

run
try "no command: usage on standard error, status 1" test "$status" -eq 1 -a ! -s "$scratch/out" \
	-a -s "$scratch/err"
works "--help" --help
ls "$built"/hawser-*.1 | sed 's/.*hawser-//; s/\.1$//' | sort >pages
commands | sed 's/ .*//' | sort -u >listed
try "--help lists the commands that have a manual page" diff pages listed
works "--version" --version
try "--version says it" grep -q '^hawser [0-9]*\.[0-9]*\.[0-9]*$' "$scratch/out"
cp "$scratch/out" version
works "-V" -V
try "-V is --version" cmp version "$scratch/out"
for command in frf compare 'compare modes' damping; do
	# shellcheck disable=SC2086 # words
	run $command --help
	cp "$scratch/out" help
	# shellcheck disable=SC2086 # words
	works "help $command" help $command
	try "help $command is $command --help" cmp help "$scratch/out"
done
run --help
cp "$scratch/out" help
works "help" help
try "help is --help" cmp help "$scratch/out"
refuses 1 "unknown command ffr; did you mean frf? (hawser --help lists the commands)" help ffr
refuses 1 "help columns needs a COMMAND, such as frf (hawser --help lists the commands)" help columns
works "help columns of a model" help columns rom
try "names its columns" grep -q "^  tensor  *K, D, Q, C, or f for the load" "$scratch/out"
rm version help

refuses 1 "unknown command static; did you mean statics? (hawser --help lists the commands)" static
refuses 1 "unknown command ffr; did you mean frf? (hawser --help lists the commands)" ffr
refuses 1 "unknown command zzzzzz (hawser --help lists the commands)" zzzzzz
refuses 1 "unknown option --verison (hawser --help lists the commands)" --verison
refuses 1 "compare needs a SCENE (hawser compare --help)" compare
refuses 1 "compare takes one SCENE, but moods and $chairlift are given" compare moods "$chairlift"
refuses 1 "there is no fidelity \"row 5\": write multiple-scales N, raw N, condensed N, \
chosen N, auto A, full N, separated by commas" \
	compare "$chairlift" --fidelities "raw 5, row 5"
refuses 1 "there is no fidelity \"\": write multiple-scales N, raw N, condensed N, \
chosen N, auto A, full N, separated by commas" \
	compare "$chairlift" --fidelities "raw 5,"
refuses 1 '"raw 0": write raw with a number of modes from 1 on, or a range such as 5-9' \
	compare "$chairlift" --fidelities "raw 0"
refuses 1 '"raw 9-5": write raw with a number of modes from 1 on, or a range such as 5-9' \
	compare "$chairlift" --fidelities "raw 9-5"
refuses 1 "more than 63 fidelities: leave some out" compare "$chairlift" --fidelities "raw 1-100"
refuses 1 "--from 1w1 and --to w1 are the same frequency" compare "$chairlift" --from 1w1 --to w1
refuses_like 1 "is a reduced model, which hawser compare does not take; these commands do: plan, modes, rom" \
	compare "$duffing"
refuses 1 "there is nothing to compare raw 5 with: name another fidelity" \
	compare "$chairlift" --fidelities "raw 5, raw:5"
refuses 1 "plan has no picture; hawser compare --plot draws errors against time" \
	plan "$chairlift" --plot x.svg
refuses 1 "plan needs a SCENE (hawser plan --help)" plan
refuses_like 1 "is a reduced model, which hawser statics does not take" statics "$duffing"
refuses 1 "--from 1w1 and --to w1 are the same frequency" plan "$chairlift" --from 1w1 --to w1
refuses_like 1 'there is no fidelity "row 5"' plan "$chairlift" --fidelities "row 5"
refuses 1 "--step 1.5: must be at most 1" compare "$chairlift" --step 1.5
refuses 1 "unknown command compar; did you mean compare? (hawser --help lists the commands)" compar
works "compare --help" compare --help
refuses 1 "compare modes needs a SCENE (hawser compare modes --help)" compare modes
refuses 1 "--method spectra: there is no such method (hawser modes --list-methods)" \
	compare modes "$chairlift" --method spectra
refuses 1 "--view side: must be one of components, profile, waves" modes "$chairlift" --view side
refuses 1 "--model parabole: must be one of catenary, inextensible, parabola, fe" \
	statics "$chairlift" --model parabole
refuses 1 "--models does not go with --compatibility: leave out one of them" \
	statics "$chairlift" --models --compatibility
refuses 1 "--models does not go with --model: leave out one of them" \
	statics "$chairlift" --models --model parabola
refuses 1 "tensions from 9000 N to 8000 N are no range: give --from and --to, the smaller one first" \
	statics "$chairlift" --compatibility --from "9 kN" --to 8000
refuses_like 1 '^hawser: --from: "3 kg" is a mass .*a force is wanted' \
	statics "$chairlift" --models --from "3 kg"
refuses 1 "frf: unknown option --form; did you mean --from? (hawser frf --help lists all)" \
	frf "$chairlift" --form 3
refuses 1 "frf: unknown option --max-point=5; did you mean --max-points? (hawser frf --help lists all)" \
	frf "$chairlift" --max-point=5
refuses 1 "statics: unknown option --omega (hawser statics --help lists all)" \
	statics "$chairlift" --omega
refuses 1 "statics: unknown option -x (hawser statics --help lists all)" statics "$chairlift" -x
refuses 1 "frf needs a SCENE|MODEL (hawser frf --help)" frf
refuses 1 "modes needs a SCENE (hawser modes --help)" modes
refuses 1 'statics takes one SCENE, but a and b are given (quote a value with a blank, such as "5 m")' \
	statics a b
refuses 1 "--json needs FILE" statics "$chairlift" --json
refuses 1 "--json: the FILE is empty" statics "$chairlift" --json ""
refuses 1 "--quiet takes no argument" statics "$chairlift" --quiet=1
refuses 1 "--export needs FORMAT STEM" rom "$chairlift" --export auto
refuses 1 "--export matlab: the formats are auto, coco, matcont and bifurcationkit" rom "$chairlift" --export matlab x
refuses 1 "rom has no picture; hawser modes --plot draws the shapes" rom "$chairlift" --plot x.svg
refuses 1 '--set cable.EA: write KEY=VALUE, such as cable.EA="100 MN"' \
	statics "$chairlift" --set cable.EA
refuses 1 "--points 1: must be at least 2" statics "$chairlift" --points 1
refuses 1 "--points 2.5: write a whole number" statics "$chairlift" --points 2.5
refuses 1 "--points 99999999999: write a whole number" statics "$chairlift" --points 99999999999
refuses 1 "--points 10000001: at most 10000000 points are possible" \
	statics "$chairlift" --points 10000001
refuses 1 "--points 1000001: at most 1000000 points of curves are possible" \
	statics "$chairlift" --models --points 1000001
refuses 1 "--step 1.5: must be at most 1" frf "$chairlift" --step 1.5
refuses 1 "--tolerance 0: write a number greater than zero" frf "$chairlift" --tolerance 0
refuses 1 "--tolerance nan: write a number greater than zero" frf "$chairlift" --tolerance nan
refuses 1 "--tolerance 1e-9x: write a number greater than zero" frf "$chairlift" --tolerance 1e-9x
refuses 1 "--sweep sideways: must be one of up, down, both" frf "$chairlift" --sweep sideways
refuses 1 "--scale cubic: must be one of auto, linear, log" frf "$chairlift" --scale cubic
refuses 1 "load factors from 0.01 to 0.5: the first must be between 0 and 1, the second 1 or more (1 is \
the model's own load)" folds "$duffing" --load-to 0.5
refuses 1 "--load-from 0: write a number greater than zero" folds "$duffing" --load-from 0
refuses 1 "--from 1w1 and --to w1 are the same frequency" folds "$duffing" --from 1w1 --to w1
refuses_like 2 "the response has no fold between Omega 0.5 and 0.7: nothing jumps there at load factors from 0.01 to 2" \
	folds "$duffing" --from 0.5 --to 0.7

# travelling beams
refuses 1 "beam needs a SCENE (hawser beam --help)" beam
refuses 1 "this scene is of a cable: hawser beam takes one with a section beam (man hawser-scene)" beam "$chairlift"
upright=$top/notebooks-data/scenes/d-figure-9.5.yaml
refuses 1 "$upright is a scene of a beam: that is for hawser beam" modes "$upright"
refuses 1 "--method cosine: must be one of legendre, sine, hermite" beam "$upright" --method cosine
refuses 1 "--from needs --to VALUE: give that" beam "$upright" --from 1
refuses 1 "--until does not go with --to: leave out one of them" beam "$upright" --until 1 --to 1
refuses 1 "--boundary needs --to VALUE: give that" beam "$upright" --boundary beam.c
refuses 1 "--bifurcation needs --boundary KEY: give that" beam "$upright" --bifurcation
refuses 1 "--vary beam.c: write KEY=A,B, such as beam.rho=0,10" beam "$upright" --vary beam.c
refuses 1 "--modes 101: must be at most 100" beam "$upright" -n 101
refuses_like 1 "beam.c = -1 is out of range" beam "$upright" --vary beam.c=-1
refuses_like 1 "beam.rhoA contradicts beam.mu" beam "$upright" --set beam.rhoA=3
refuses_like 1 "cable contradicts beam" beam "$upright" --set cable.EA=3
refuses_like 1 "a string has no rotary inertia" beam "$upright" --set beam.theta=0
refuses_like 2 "a string cannot carry that" beam "$upright" --set beam.theta=0 --set beam.slenderness=0
refuses_like 1 "two different speeds" beam "$upright" --basis 12 --from 1 --to 1
refuses_like 1 "cannot read nowhere" beam "$upright" --basis 12 --until 1 --initial nowhere

# frequencies and times
refuses 1 "the model is forced: give its frequency with --Omega, such as --Omega 0.9w1" \
	integrate "$chairlift"
refuses 1 "--Omega -1: must be greater than zero and finite" integrate "$chairlift" --Omega -1
refuses 1 "--Omega 0w1: must be greater than zero and finite" integrate "$chairlift" --Omega 0w1
refuses 1 "--Omega 3w9: the model has natural frequencies w1 to w5" \
	integrate "$chairlift" --Omega 3w9
refuses_like 1 '^hawser: --Omega: "3 kg" has a wrong unit' integrate "$chairlift" --Omega "3 kg"
refuses_like 1 '^hawser: --until: "abc" is not a number' \
	integrate "$chairlift" --Omega 1 --until abc
refuses 1 "--Omega 2 Hz: the model has no unit of time; write a plain number in the model's own \
unit, or a multiple of a natural frequency, such as 0.6w1" integrate "$duffing" --Omega "2 Hz"
refuses 1 "--until 3 s: the model has no unit of time; write a plain number in the model's own \
unit, or a number of periods, such as 50T" integrate "$duffing" --Omega 2 --until "3 s"
refuses 1 "--from 1w1 and --to w1 are the same frequency" frf "$duffing" --from 1w1 --to w1
refuses_like 1 "makes .* rows: choose a longer interval" \
	integrate "$duffing" --Omega 1 --every 1e-20
refuses 1 "$duffing is a reduced-model file: --modes applies to scenes only" frf "$duffing" -n 3
refuses 1 "--set g=1: $duffing has these parameters: none" \
	frf "$duffing" --set g=1

# spellings that mean the same
run modes "$chairlift" -n 2
cp "$scratch/out" a
for spelling in "-n2" "--modes 2" "--modes=2" "--set model.modes=2 -q"; do
	# shellcheck disable=SC2086 # words
	works "modes $spelling" modes $spelling "$chairlift"
	grep -v '^# set:' "$scratch/out" | try "the same table" diff - a
done
works "-- ends the options" statics --points 2 -- "$chairlift"
run integrate "$duffing" --Omega 1 --until 1 --every 0.25
try "integrate prints one row a time" test "$(grep -vc '^#' "$scratch/out")" -eq 6
done_testing

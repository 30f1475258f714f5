#!/bin/sh
# The same command gives the same bytes: table, JSON, picture and what it says, in every run, with any
# number of threads, whatever is in the memory that it is given.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scenes=$top/notebooks-data/scenes
travelling=$scenes/b-table-5.4.yaml
cat >../hill.json <<'EOF'
{"hawser_rom": 1, "n": 2, "D": [[0.02, 0], [0, 0.03]], "K": [[1, 0], [0, 2.3]],
 "harmonics": [{"k": 1, "phase": "cos", "K": [[1, 0.2], [0.2, 1.1]], "f": [0.1, 0.2]}]}
EOF
awk 'BEGIN { for (i = 0; i < 400; i++) print i/50 "," exp(-0.02*i/50)*cos(6.3*i/50) }' >../decay.csv
gnuplot=${HAWSER_GNUPLOT:-gnuplot}
pictures="--plot run.svg"
if ! command -v "$gnuplot" >/dev/null; then
	pictures=
	skip "pictures: gnuplot is not installed"
fi

# once THREADS FILL ARGUMENTS: all that a run leaves, in ../THREADS
once() {
	OMP_NUM_THREADS=$1 MALLOC_PERTURB_=$2
	export OMP_NUM_THREADS MALLOC_PERTURB_
	into=../$1
	shift 2
	rm -rf "$into"
	"$HAWSER" "$@" --reproducible >out 2>err </dev/null || { cat err; return 1; }
	mkdir "$into"
	mv -- * "$into"
}

# Two threads, and with HAWSER_LONG three as well.
three() {
	once 1 85 "$@" && once 2 170 "$@" && diff -r ../1 ../2 || return 1
	[ -z "${HAWSER_LONG-}" ] || { once 3 0 "$@" && diff -r ../1 ../3; }
}

# same ARGUMENTS: with all the outputs there are; drawn ARGUMENTS: with HAWSER_LONG a picture too (most of the time of
# this test is gnuplot's, whose input one command shows to be the same); pictured ARGUMENTS: always
same() {
	try "hawser $(echo "$*" | sed "s|$top/||g")" three "$@" --json run.json --tsv run.tsv
}
pictured() {
	# shellcheck disable=SC2086 # words
	same "$@" $pictures
}
drawn() {
	if [ -n "${HAWSER_LONG-}" ]; then
		pictured "$@"
	else
		same "$@"
	fi
}

try "hawser --help" three --help
try "hawser plan, for people" three plan "$scenes/b-table-4.4-line-2.yaml" --fidelities "raw 1"
same plan "$scenes/b-table-4.4-line-2.yaml" --fidelities "raw 1"
pictured statics "$chairlift"
drawn statics "$travelling" --speeds --points 5
drawn modes "$chairlift" --shapes
same modes "$travelling" -n 4
drawn irvine "$chairlift" --points 12 -n 4
same campbell "$travelling" --points 2 -n 1 --to 20
try "hawser rom" three rom "$chairlift" --json run.json
try "hawser rom --export" three rom "$chairlift" --export auto span
drawn integrate "$chairlift" --Omega 0.9w1 --until 5T
same integrate "$chairlift" --Omega 0.9w1 --until 2T --method adams
same integrate "$chairlift" --Omega 0.9w1 --until 2T --method bdf
drawn frf "$chairlift" -n 2 --from 0.95w1 --to 1.05w1 --multipliers --sweep up --sweep-points 2 --backbone 1
same frf "$chairlift" --to 0.8w1 -n 2 --method balance
same frf "$scenes/b-table-4.4-line-2.yaml" --from 0.95w1 --to 0.96w1 --set model.modes=auto --set model.accuracy=0.05 \
	--set model.condense=static
pictured folds "$duffing" --from 0.9 --to 1.5 --starts 6
drawn mms "$duffing"
same hill "$duffing" --Omega 0.9 --orbit
drawn hill ../hill.json --x Omega=1.8:2.2 --y factor.load=0:0.5 --lines 5 --samples 60
drawn hill --mathieu --x delta=0:2 --y epsilon=0:1 --lines 5 --samples 60
same damping ../decay.csv
same beam "$scenes/d-figure-9.9.yaml"
drawn beam "$scenes/second-stable-region.yaml" --from 19 --to 21 --points 2 -n 4
drawn beam "$scenes/d-figure-9.10.yaml" --until 1 --every 0.1
pictured map ../hill.json --x Omega=0.8:4 --y factor.load=0:0.5 --points 21x17 --quantity multiplier \
	--boundary edge.tsv
drawn map "$chairlift" -n 2 --x Omega=0.9w1:1.1w1 --y factor.load=0.1:1 --points 3x3 --quantity amplitude
same map "$travelling" -n 3 --x travel.speed=0:20 --y "tension.H=50 kN:90 kN" --points 5x5
same map "$scenes/d-figure-9.2.yaml" --x beam.mu=0.9:1.1 --y beam.v=0.5:4 --points 3x5
same compare "$scenes/b-table-4.4-line-2.yaml" --from 0.9w1 --to 0.92w1 --step 0.05 --fidelities "multiple-scales 2, raw 2, condensed 1"
same compare modes "$chairlift" -n 3 --method analytic --to 6
drawn compare mms "$duffing" --levels 2 --step 0.05
done_testing

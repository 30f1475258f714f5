#!/bin/sh
# The figures of the theory notes, from a build folder:  make figures
# Needs gnuplot. Writes into the folder given as argument.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
target=${1:?give the folder for the figures}
program=${BUILD:-.}/bench/shapes
[ -x "$program" ] || { echo "figures.sh: no $program: run make bench/shapes in the build folder" >&2; exit 1; }
mkdir -p "$target"
table=$(mktemp)
trap 'rm -f "$table"' EXIT

OPENBLAS_NUM_THREADS=1 "$program" analytic 121 >"$table"
# panel CASE INDEX
panel() {
	cat <<END
set lmargin at screen 0.10 + 0.30*$2
set rmargin at screen 0.37 + 0.30*$2
set title 'case $1' offset 0,-0.6
set xlabel 'Elastic ratio {/Symbol e} = {/:Italic H/EA}'
plot for [i = 0:4] table index 5*$2 + i using 2:6 with lines lt i + 1
END
}
{
	cat <<END
table = '$table'
set encoding utf8
set terminal svg size 680,320 enhanced font 'sans-serif,12' background '#ffffff' linewidth 1.2
set linetype 1 lc rgb '#0072B2'
set linetype 2 lc rgb '#56B4E9'
set linetype 3 lc rgb '#009E73'
set linetype 4 lc rgb '#E69F00'
set linetype 5 lc rgb '#D55E00'
set border 3 lw 0.8 lc rgb '#404040'
set tics nomirror out scale 0.6
set grid lw 0.5 lc rgb '#d8d8d8' dt solid
set logscale xy
set format '10^{%L}'
set xrange [4e-5:2e-2]
set yrange [5e-5:2]
set multiplot
set tmargin at screen 0.90
set bmargin at screen 0.32
set key off
set ylabel 'Error of the in-plane shapes' offset 0.5,0
END
	panel 1 0
	echo "unset ylabel; set format y ''"
	panel 2 1
	panel 3 2
	cat <<END
set lmargin at screen 0.05
set rmargin at screen 0.95
set tmargin at screen 0.02
set bmargin at screen 0.01
unset border; unset tics; unset grid; unset xlabel; unset title
set key at screen 0.53,0.03 center bottom horizontal samplen 2
plot NaN with lines lt 1 title '{/:Italic h/d} = 0', NaN with lines lt 2 title '0.05', \\
	NaN with lines lt 3 title '0.1', NaN with lines lt 4 title '0.25', \\
	NaN with lines lt 5 title '1/3'
unset multiplot
END
} | gnuplot >"$target/analytic-shapes.svg"
echo "$target/analytic-shapes.svg"

# Multiple scales over the response, a backbone, and Mathieu's boundaries.
program=${BUILD:-.}/hawser
span="${SRCDIR:?names the source directory}/notebooks-data/scenes/b-table-4.6-out-of-plane.yaml"
"$program" compare mms "$span" -n 12 --set model.condense=static --set "span.h=0 m" --levels 2 -q \
	--plot "$target/compare-mms.svg"
"$program" frf "$span" -n 8 --set model.condense=static --set "span.h=0 m" --from 1.3 --to 1.7 --backbone 1 \
	--scale linear -q --plot "$target/backbone.svg"
"$program" hill --mathieu -q --plot "$target/mathieu.svg"
printf '%s\n' "$target/compare-mms.svg" "$target/backbone.svg" "$target/mathieu.svg"

# Convergence in the number of modes against the full-order model: raw models stall, the lowest modes with
# the others condensed converge, chosen ones sooner. A picture of doc/commands.md; takes some minutes.
names="b-table-4.4-line-2 b-table-4.5 b-table-5.4-at-rest inclined b-table-4.2 deep-sag"
: "${SRCDIR:?names the source directory}"
HAWSER=${BUILD:-.}/hawser sh "$SRCDIR/bench/convergence.sh" "$target/convergence" $names \
	>"$target/convergence.log"
# block FAMILY SCENE: number of modes, the larger error of fold and peak frequencies, that of
# amplitudes, whether folds or peaks are missing or extra
block() {
	grep -v '^#' "$target/convergence/$2.tsv" | awk -F '\t' -v family="$1" '
		function size(x) { return x < 0 ? -x : x + 0 }
		NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
		split($1, name, " ") && name[1] == family && $2 == "compared" {
			fold = size($c["fold_Omega_error"]); peak = size($c["peak_Omega_error"])
			apart = $c["folds_missing"] + $c["folds_extra"] + $c["peaks_missing"] + $c["peaks_extra"]
			print name[2], (fold > peak ? fold : peak), size($c["peak_amplitude_error"]), (apart > 0) }'
}
# data FAMILY SCENE: its name in gnuplot
data() {
	printf '$%s_%s' "$1" "$(printf %s "$2" | tr -c 'a-z0-9' _)"
}
# series SCENE COLUMN
series() {
	separator=plot
	for f in raw condensed chosen; do
		case $f in raw) line=1 ;; condensed) line=2 ;; *) line=3 ;; esac
		block $f "$1" | awk -v c="$2" '$c > 0 { any = 1 } END { exit !any }' || continue
		some="(\$$2 > 0 ? \$$2 : NaN)"
		printf '%s %s using 1:%s with lines lt %s' "$separator" "$(data $f "$1")" "$some" $line
		printf ", '' using 1:%s:(\$4 == 1 ? 6 : 7) with points lt %s pt variable ps 0.55" "$some" $line
		separator=,
	done
	echo
}
title() {
	case $1 in
	b-table-4.4-line-2) echo 'B Table 4.4, line 2' ;;
	b-table-4.2) echo 'B Table 4.2, 0.3 load' ;;
	deep-sag) echo 'deep sag, 0.1 load' ;;
	b-table-*) echo "B Table ${1#b-table-}" ;;
	*) echo "$1" ;;
	esac
}
{
	for scene in $names; do
		for f in raw condensed chosen; do
			echo "$(data $f "$scene") << END"
			block $f "$scene"
			echo END
		done
	done
	cat <<END
set encoding utf8
set terminal svg size 1000,460 enhanced font 'sans-serif,12' background '#ffffff' linewidth 1.3
set linetype 1 lc rgb '#D55E00'
set linetype 2 lc rgb '#0072B2'
set linetype 3 lc rgb '#009E73'
set linetype 7 lc rgb '#404040'
set border 3 lw 0.8 lc rgb '#404040'
set tics nomirror out scale 0.6
set grid lw 0.5 lc rgb '#d8d8d8' dt solid
set xrange [4:17]
set logscale y
set key off
set multiplot
END
	i=0 numbers='10^{%L}' frequency='Error in frequency' amplitude='Error in amplitude'
	for scene in $names; do
		cat <<END
set lmargin at screen 0.075 + 0.155*$i
set rmargin at screen 0.205 + 0.155*$i
set tmargin at screen 0.93
set bmargin at screen 0.59
set title '$(title "$scene")' offset 0,-0.6
set xtics ('' 5, '' 9, '' 12, '' 16)
unset xlabel
set yrange [5e-6:0.2]
set format y '$numbers'
set ylabel '$frequency' offset 0.5,0
END
		series "$scene" 2
		cat <<END
unset title
set tmargin at screen 0.54
set bmargin at screen 0.24
set xtics ('5' 5, '9' 9, '12' 12, '16' 16)
set xlabel 'Modes' offset 0,0.6
set yrange [5e-4:1]
set ylabel '$amplitude' offset 0.5,0
END
		series "$scene" 3
		i=$((i + 1)) numbers='' frequency='' amplitude=''
	done
	cat <<END
set lmargin at screen 0.05
set rmargin at screen 0.95
set tmargin at screen 0.02
set bmargin at screen 0.01
unset border; unset tics; unset grid; unset xlabel; unset ylabel; unset title; unset logscale
set yrange [0:1]
set key at screen 0.5,0.02 center bottom horizontal maxcols 2 samplen 2.5
plot NaN with linespoints lt 1 pt 7 ps 0.5 title 'raw: the lowest modes, others at rest', \\
	NaN with linespoints lt 2 pt 7 ps 0.5 title 'condensed: the lowest, others following', \\
	NaN with linespoints lt 3 pt 7 ps 0.5 title 'chosen, others following', \\
	NaN with points lt 7 pt 6 ps 0.6 title 'folds or peaks missing or extra'
unset multiplot
END
} | gnuplot >"$target/convergence.svg"
echo "$target/convergence.svg"

# Error over processor time, from the table that bench/trade.py measures in half an hour. A picture of doc/commands.md.
python3 "$SRCDIR/bench/trade.py" draw "$SRCDIR/notebooks-data/trade.tsv" "$target/trade.svg"
echo "$target/trade.svg"

# A travelling cable: both holds over the speed, B Table 5.3; the Campbell diagram of B Figure 5.5; the Irvine
# diagrams at six speeds of B Figure 5.4.
scenes=$SRCDIR/notebooks-data/scenes
hawser=${BUILD:-.}/hawser
"$hawser" statics "$scenes/b-table-5.3.yaml" --quiet --speeds --points 41 --plot "$target/travel-holds.svg"
echo "$target/travel-holds.svg"
"$hawser" campbell "$scenes/b-table-5.3.yaml" --quiet --plot "$target/campbell.svg"
echo "$target/campbell.svg"
"$hawser" irvine "$scenes/b-table-5.2.yaml" --quiet --speeds "0, 3, 5, 8, 10, 12" --plot "$target/irvine-speeds.svg"
echo "$target/irvine-speeds.svg"

# Travelling cables: response, braking, jumps.
sh "$SRCDIR/doc/figures-travel.sh" "$target/travel"

# The picture of README.md, by its own scene and command: doc/response.svg is a copy.
sed -n '/^    \$ cat >stay.yaml/,/^    END/p' "$SRCDIR/README.md" | sed '1d; $d; s/^    //' >"$target/stay.yaml"
"$hawser" frf "$target/stay.yaml" --from 0.98w1 --to 1.02w1 --branches 1 --scale linear -q --plot "$target/response.svg"
echo "$target/response.svg"

# Spans with attachments and moving ends.
sh "$SRCDIR/doc/figures-spans.sh" "$target/spans"

# The equilibria of four bars; the picture of theory-net.md is a copy.
"$hawser" statics "$scenes/net-bars.yaml" --equilibria 2000 -q --plot "$target/net-bars.svg"
echo "$target/net-bars.svg"
"$hawser" modes "$scenes/net-table-3-1.yaml" -q --plot "$target/net-modes.svg" >"$target/net-modes.txt"
echo "$target/net-modes.svg"
profile=${BUILD:-.}/bench/net-profile
[ -x "$profile" ] || { echo "figures.sh: no $profile: run make bench/net-profile in the build folder" >&2; exit 1; }
OPENBLAS_NUM_THREADS=1 "$profile" -p >"$table"
# percents X: the stairs over a column; a method has one colour, and starts at straight cables are dashed
percents() {
	awk -v x="$1" -v table="$table" '/^#/ {
		method = $2; sub(/\/.*/, "", method)
		if (!(method in colour))
			colour[method] = ++colours
		printf "%s table index %d using %d:3 with steps lw %s dt %s lt %d title \"%s\"", n ? ", \\\n" : "plot", n, x, \
			n ? 1.6 : 3, $2 ~ /chord|two-sided$|regularised$|descent/ ? "(6,4)" : 1, colour[method], $2
		n++ }
		END { print "" }' "$table"
}
{
	cat <<END
table = '$table'
set encoding utf8
set terminal svg size 850,360 enhanced font 'sans-serif,12' background '#ffffff'
set linetype 1 lc rgb 'black'
set linetype 9 lc rgb '#8C564B'
set border 3 lw 0.8 lc rgb '#404040'
set tics nomirror out scale 0.6
set grid lw 0.5 lc rgb '#d8d8d8' dt solid
set logscale x
set format x '10^{%L}'
set yrange [0:103]
set multiplot
set tmargin at screen 0.96
set bmargin at screen 0.20
set lmargin at screen 0.11
set rmargin at screen 0.42
set ylabel 'Cables solved (%)'
set xlabel 'Processor time, over that of the fastest'
set key off
END
	percents 1
	cat <<END
set lmargin at screen 0.46
set rmargin at screen 0.77
unset ylabel
set xlabel 'Number of iterations'
set key at screen 0.99,0.95 right top Left reverse samplen 2
END
	percents 2
	echo "unset multiplot"
} | gnuplot >"$target/net-profile.svg"
echo "$target/net-profile.svg"

# Travelling beams: all figures of D chapter 9.
sh "$SRCDIR/doc/figures-beam.sh" "$target/beam"

# Maps: tongues of a fluctuating speed, and the slowest decay over speed and tension.
"$hawser" map "$scenes/b-table-5.4.yaml" --quiet -n 6 --x Omega=0.5w1:5w1 --y travel.fluctuation=0:8 \
	--quantity multiplier --plot "$target/map-tongues.svg"
echo "$target/map-tongues.svg"
"$hawser" map "$scenes/b-table-5.4.yaml" --quiet -n 6 --set "tension={T0: 80 kN}" --x travel.speed=0:140 \
	--y "tension.T0=5 kN:100 kN" --plot "$target/map-speed.svg"
echo "$target/map-speed.svg"

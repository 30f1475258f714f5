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

# Convergence in the number of modes on B Table 4.4, line 2, against the full-order model: the raw model
# stalls, the condensed one converges. The picture of README.md.
hawser=${BUILD:-.}/hawser
"$hawser" compare "${SRCDIR:?names the source directory}/notebooks-data/scenes/b-table-4.4-line-2.yaml" --quiet \
	--limit 600 --fidelities "raw 5, raw 7, raw 9, raw 12, condensed 5, condensed 7, condensed 9, \
condensed 12, condensed 16, full 12" --plot "$target/convergence.svg" --tsv "$target/convergence.tsv"
echo "$target/convergence.svg"

#!/bin/sh
# Every figure of D chapter 9 again, from scenes: sh figures-beam.sh FOLDER; figures.sh calls it. Tables
# stand beside the pictures.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
target=${1:?give the folder for the figures}
scenes=${SRCDIR:?names the source directory}/notebooks-data/scenes
hawser=${BUILD:-.}/hawser
mkdir -p "$target"

# figure NAME SCENE OPTIONS...
figure() {
	name=$1 scene=$2
	shift 2
	"$hawser" beam "$scenes/d-figure-$scene.yaml" --quiet "$@" --plot "$target/d-figure-$name.svg" \
		--tsv "$target/d-figure-$name.tsv" 2>"$target/warnings" || { cat "$target/warnings" >&2; exit 1; }
	echo "$target/d-figure-$name.svg"
}
figure 9.1 9.1 --vary beam.rho=0,10 --to 4 -n 1
figure 9.2 9.2 --vary beam.rho=0,10 --boundary beam.mu --from 0.01 --to 20
figure 9.3 9.3 --boundary beam.slenderness --from 1.5 --to 50
figure 9.4 9.4 --to 3 -n 1
figure 9.5 9.5 --vary beam.c=0,5,10 --to 3 -n 1
figure 9.6 9.5 --boundary beam.c --to 30 --bifurcation
figure 9.8 9.8 --vary beam.rho=0,10 --boundary beam.theta --from 1e-4 --to 10
figure 9.10 9.10 --vary beam.v=3.26,3.297 --until 50
figure 9.11 9.11 --vary beam.v=2.37,2.38723 --until 50

# 9.7: a string's own scale has rho = 10/mu_s; both axes of D's figure are plain numbers
"$hawser" beam "$scenes/d-figure-9.7.yaml" --quiet --boundary beam.rho --from 0.01 --to 0.999 \
	--tsv "$target/d-figure-9.7.tsv"
{
	cat <<END
set encoding utf8
set terminal svg size 567,397 enhanced font 'sans-serif,12' background '#ffffff' linewidth 1.3
set border 3 lw 0.8 lc rgb '#404040'
set tics nomirror out scale 0.6
set grid lw 0.5 lc rgb '#d8d8d8' dt solid
set key bottom right
set xrange [0:100]
set yrange [0:1.1]
set xlabel 'Scaled end tension {/Symbol m}_{/:Italic s} (–)'
set ylabel 'Speed {/:Italic v} (–)'
plot 1 with lines lw 1.6 lc rgb '#0072B2' title 'level', \\
	'$target/d-figure-9.7.tsv' every ::1 using (10/\$2):3 with lines lw 1.6 lc rgb '#D55E00' title 'upright'
END
} | gnuplot >"$target/d-figure-9.7.svg"
echo "$target/d-figure-9.7.svg"

# 9.9: error of the safe speed against the number of functions, and against time, for the three methods
table=$target/d-figure-9.9.tsv
exact=$("$hawser" beam "$scenes/d-figure-9.9.yaml" --basis 40 --json - | tr ',' '\n' |
	sed -n 's/.*"v_crit": *//p' | head -n 1)
: >"$table"
for method in legendre sine hermite; do
	printf '# %s: size, functions, relative error of v_crit, s\n' "$method" >>"$table"
	for size in 3 4 5 6 7 9 12 16 24 32 48 64 96; do
		functions=$size
		[ "$method" != hermite ] || functions=$((2*size))
		"$hawser" beam "$scenes/d-figure-9.9.yaml" -n 1 --method "$method" --basis "$size" --json - |
			tr ',' '\n' | awk -v exact="$exact" -v size="$size" -v functions="$functions" '
				/"v_crit":/ { v = $NF } /wall_time_secs/ { t = $NF; sub(/[}].*/, "", t) }
				END { e = v/exact - 1; if (e < 0) e = -e; print size, functions, e + 1e-17, t }' >>"$table"
	done
	printf '\n\n' >>"$table"
done
{
	cat <<END
set encoding utf8
set terminal svg size 640,330 enhanced font 'sans-serif,12' background '#ffffff' linewidth 1.3
set border 3 lw 0.8 lc rgb '#404040'
set tics nomirror out scale 0.6
set grid lw 0.5 lc rgb '#d8d8d8' dt solid
set linetype 1 lc rgb '#0072B2'
set linetype 2 lc rgb '#D55E00'
set linetype 3 lc rgb '#009E73'
set logscale xy
set format y '10^{%L}'
set yrange [1e-16:1]
set key bottom left samplen 1.5
set multiplot layout 1,2
set xlabel 'Functions (–)'
set ylabel 'Relative error of the safe speed'
plot for [i = 0:2] '$table' index i using 2:3 with linespoints lt i + 1 pt 7 ps 0.5 \\
	title word('Legendre sines Hermite', i + 1)
set key off
set format x '10^{%L}'
set xlabel 'Wall time of the command (s)'
unset ylabel
plot for [i = 0:2] '$table' index i using 4:3 with points lt i + 1 pt 7 ps 0.5
unset multiplot
END
} | gnuplot >"$target/d-figure-9.9.svg"
echo "$target/d-figure-9.9.svg"
rm -f "$target/warnings"

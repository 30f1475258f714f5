#!/bin/sh
# The figures of doc/theory-travel-rom.md, after Bertrand (2022), Figures 5.6 to 5.16; figures.sh calls it.
# Needs gnuplot and python3. Writes into the folder given as argument.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
target=${1:?give the folder for the figures}
hawser=${BUILD:-.}/hawser
scenes=${SRCDIR:?names the source directory}/notebooks-data/scenes
mkdir -p "$target"
export OPENBLAS_NUM_THREADS=1

# curves JSON FILE: Omega/w1, stable, half the sum of squares of Omega*u_j (kinetic energy where all
# coordinates pass zero together, scaled), and the coordinates' amplitudes, one row a point
curves() {
	python3 -c '
import json, sys
result = json.load(open(sys.argv[1]))
w1 = result["natural_frequencies"][0]
last = None
for p in result["points"]:
    u = p["coordinates"]
    row = (sum((p["Omega"]*a)**2 for a in u)/2, *u)
    if last is not None and last != p["stable"]:
        print(p["Omega"]/w1, int(last), *row, end="\n\n")
    last = p["stable"]
    print(p["Omega"]/w1, int(last), *row)
' "$1" >"$2"
}

style() {
	cat <<END
set encoding utf8
set terminal svg size $1 enhanced font 'sans-serif,12' background '#ffffff' linewidth 1.2
set border 3 lw 0.8 lc rgb '#404040'
set tics nomirror out scale 0.6
set grid lw 0.5 lc rgb '#d8d8d8' dt solid
set xlabel 'Forcing frequency over the first natural one, {/Symbol W}/{/Symbol w}_1'
stable(column) = \$2 == 1 ? column : NaN
END
}

# Figure 5.6: the speed alone excites it
"$hawser" frf "$scenes/b-table-5.4.yaml" --from 0.5w1 --to 4.5w1 --unstable 9 --quiet --json "$target/5.6.json" \
	--tsv "$target/5.6.tsv"
curves "$target/5.6.json" "$target/5.6.txt"
{
	style 760,380
	cat <<END
set ylabel 'Amplitude of coordinate, m' offset 0.5,0
set logscale y
set format y '10^{%L}'
set yrange [1e-6:*]
set key outside right
plot for [j in '2 3 6 7'] '$target/5.6.txt' using 1:(column(int(j) + 3)) with lines lw 1.3 \\
	title 'mode '.j.', in plane'
END
} | gnuplot >"$target/travel-5.6-speed.svg"

# Figures 5.7 to 5.10: first and last seconds
for Omega in 1.03 3.3; do
	"$hawser" integrate "$scenes/b-table-5.4.yaml" --Omega "${Omega}w1" --until 400 --every 0.05 --quiet \
		--tsv "$target/5.7-$Omega.tsv"
	{
		style 760,320
		cat <<END
set datafile separator '\t'
set xlabel 'Time, s'
set multiplot layout 1,2 title '{/Symbol W} = $Omega {/Symbol w}_1'
set key bottom center outside horizontal
set ylabel 'y, mm'
plot [0:20] '$target/5.7-$Omega.tsv' using 1:(1e3*\$3) with lines lw 0.8 title 'quarter-span', \\
	'' using 1:(1e3*\$6) with lines lw 0.8 title 'mid-span'
unset ylabel
plot [390:400] '$target/5.7-$Omega.tsv' using 1:(1e3*\$3) with lines lw 0.8 title 'quarter-span', \\
	'' using 1:(1e3*\$6) with lines lw 0.8 title 'mid-span'
unset multiplot
END
	} | gnuplot >"$target/travel-5.7-$Omega.svg"
done

# Figure 5.11: braking in 10 s, and an emergency stop
for time in 10 1; do
	"$hawser" integrate "$scenes/b-table-5.5.yaml" --set "travel.braking=$time" --until 20 --every 0.02 \
		--quiet --tsv "$target/5.11-$time.tsv"
done
{
	style 760,360
	cat <<END
set datafile separator '\t'
set multiplot layout 1,2
set xlabel 'Time, s'
set ylabel 'y from the steady state, mm'
set key off
set title 'braking within 10 s'
plot for [c in '3 6 9'] '$target/5.11-10.tsv' using 1:(1e3*column(int(c))) with lines lw 1
set title 'within 1 s'
unset ylabel
set key bottom right
plot '$target/5.11-1.tsv' using 1:(1e3*\$3) with lines lw 1 title 'quarter-span', \\
	'' using 1:(1e3*\$6) with lines lw 1 title 'mid-span', \\
	'' using 1:(1e3*\$9) with lines lw 1 title 'three quarters'
unset multiplot
END
} | gnuplot >"$target/travel-5.11-braking.svg"

# Figures 5.13 to 5.16 as printed, and with a tenth of the damping, taken in time units of 1/w1
light='damping.rayleigh={mass: 0.04550184 1/s, stiffness: 0.0014065365 s}'
for case in printed light; do
	set --
	[ $case = printed ] || set -- --set "$light"
	"$hawser" frf "$scenes/b-table-5.6.yaml" --from 0.5w1 --to 4.5w1 --unstable 9 --sweep both --quiet \
		--json "$target/5.16-$case.json" --tsv "$target/5.16-$case.tsv" --plot "$target/travel-5.16-$case.svg" "$@"
	curves "$target/5.16-$case.json" "$target/5.16-$case.txt"
	{
		style 760,520
		cat <<END
set multiplot layout 2,2
set logscale y
set format y '10^{%L}'
set key off
do for [j in '2 3 6'] {
	set ylabel 'mode '.j.', m'
	plot '$target/5.16-$case.txt' using 1:(stable(column(int(j) + 3))) with lines lc 1 lw 1.2, \\
		'' using 1:(\$2 == 0 ? column(int(j) + 3) : NaN) with lines lc 7 lw 1.2 dt 2
}
set ylabel 'kinetic energy, scaled'
plot '$target/5.16-$case.txt' using 1:(stable(\$3)) with lines lc 1 lw 1.2, \\
	'' using 1:(\$2 == 0 ? \$3 : NaN) with lines lc 7 lw 1.2 dt 2
unset multiplot
END
	} | gnuplot >"$target/travel-5.13-$case.svg"
done
{
	style 560,460
	cat <<END
set xlabel '{/Symbol W}/{/Symbol w}_1'
set ylabel 'mode 2, m'
set zlabel 'mode 6, m' rotate
set xyplane 0
set view 62,35
set key off
splot '$target/5.16-light.txt' using 1:5:(stable(\$9)) with lines lc 1 lw 1.2, \\
	'' using 1:5:(\$2 == 0 ? \$9 : NaN) with lines lc 7 lw 1.2 dt 2
END
} | gnuplot >"$target/travel-5.14.svg"
ls "$target"/travel-*.svg

#!/bin/sh
# hawser sweep: rows are those of the command run alone, digit for digit, for each kind of scene; the same bytes with any number of
# processes and from a checkpoint; variations without result; refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scenes=$top/notebooks-data/scenes
for scene in chairlift rod-bend net-pendulum ropeway-small tow-orbit b-table-5.4; do
	cp "$scenes/$scene.yaml" .
done

# alone SCENE KEY VALUE UNIT COMMAND...: the last row of the table of the command at this value is the row of the sweep.
alone() {
	scene=$1 key=$2 value=$3 unit=$4
	shift 4
	run sweep $scene.yaml --over "$key=$value $unit,1.01 $unit" --last -- "$@"
	sed '/^#/d' "$scratch/out" | sed -n '2s/[^	]*	[^	]*	//p' >"$scratch/swept"
	run "$@" $scene.yaml --set "$key=$value $unit"
	try "$scene: the last row of $1" test "$(sed -n '$p' "$scratch/out")" = "$(cat "$scratch/swept")"
}
alone chairlift tension.T0 81.37 kN statics --points 3
alone rod-bend 'loads[0].force[2]' 412.7 N statics
alone net-pendulum cables.c.length0 2.13 m statics
alone ropeway-small ropeway.rope.rho 3.97 kg/m statics --spans
alone tow-orbit tow.orbit.speed 18.3 m/s tow steady
alone b-table-5.4 travel.speed 3.21 m/s modes -n 2

works "a grid" sweep chairlift.yaml --over "tension.T0=60 kN:100 kN:5" --over span.h=0,10 -j 1 --reproducible -- statics
cp "$scratch/out" one.tsv
works "with three processes" sweep chairlift.yaml --over "tension.T0=60 kN:100 kN:5" --over span.h=0,10 -j 3 \
	--reproducible --checkpoint part --json grid.json --tsv three.tsv -- statics
try "  same bytes" cmp one.tsv three.tsv
size=$(wc -c <part)
head -c $((size*2/3)) part >cut
works "continued from two thirds of a checkpoint" sweep chairlift.yaml --over "tension.T0=60 kN:100 kN:5" \
	--over span.h=0,10 --checkpoint cut --reproducible -- statics
try "  same bytes" cmp one.tsv "$scratch/out"
refuses 1 "the checkpoint cut is of another sweep: scene, command, variations or columns differ: remove it, or name another file" \
	sweep chairlift.yaml --over "tension.T0=60 kN:100 kN:6" --checkpoint cut -- statics
"$HAWSER" statics chairlift.yaml --set "tension.T0=70 kN" --set span.h=10 --json alone.json --quiet
python "values are those of JSON alone, with their units" <<'EOF'
import json, sys
grid, alone = json.load(open("grid.json")), json.load(open("alone.json"))
row = [r for r in grid["rows"] if r["tension.T0_kN"] == 70 and r["span.h_m"] == 10]
good = len(row) == 1 and grid["variations"] == 10 == len(grid["rows"]) and grid["failed"] == 0
for name in ("sag_m", "T1_N", "V0_N", "irvine", "length0_m"):
    good = good and row[0][name] == alone[name.rsplit("_", 1)[0] if name != "irvine" else name]
sys.exit(not good)
EOF

run sweep chairlift.yaml --over "tension.T0=60 kN:100 kN:5" --over span.h=0,10 --part 2/3 --checkpoint second -- statics
try "part 2 of 3 has its variations in a checkpoint" test "$status $(cat "$scratch/out")" = "0 part 2 of 3: 3 variations in second"
run sweep chairlift.yaml --over "tension.T0=1 kN,80 kN" --part 1/2 --checkpoint failing -q -- statics
try "a part tells what has no result, and ends as a whole sweep does" test "$status $(grep -c \
	"no result of 1 of 1 variations of this part; the first, tension.T0 = 1 kN: the tension T0" "$scratch/err")" = "2 1"
grid="sweep chairlift.yaml --over tension.T0=60kN:100kN:5 --over span.h=0,10 --reproducible"
# shellcheck disable=SC2086 # words
{
	for k in 1 2 3; do
		"$HAWSER" $grid --part $k/3 --checkpoint part$k -q -- statics
	done
	run merge part3 part1 part2 --checkpoint joined
	try "parts are joined" test "$status $(cat "$scratch/out")" = "0 10 results of 3 checkpoints are in joined"
	cp joined before
	"$HAWSER" $grid --checkpoint joined -- statics >parts.tsv 2>"$scratch/err"
	try "  same bytes" cmp one.tsv parts.tsv
	try "  nothing was left to compute" cmp before joined
	refuses 1 "the checkpoint joined exists: name a new file, or remove it" merge part1 part2 --checkpoint joined
	"$HAWSER" merge part1 part3 --checkpoint lacking -q
	"$HAWSER" $grid --checkpoint lacking -- statics >parts.tsv 2>"$scratch/err"
	try "  same bytes where a part is missing" cmp one.tsv parts.tsv
	"$HAWSER" sweep chairlift.yaml --over span.h=0,10 --part 1/2 --checkpoint other -q -- statics
	head -c 14 part1 >begun
	refuses 1 "begun is no checkpoint of a sweep: its first line is damaged" merge begun part2 --checkpoint x
	sed '3s/^S 0/S 1/' part1 >damaged # the first result
	refuses_like 4 "the checkpoint damaged is damaged at byte 83, and has results behind it" merge part2 damaged --checkpoint x
	# shellcheck disable=SC2086 # words
	refuses_like 4 "the checkpoint damaged is damaged at byte 83" $grid --part 1/3 --checkpoint damaged -- statics
	refuses 1 "part1 is the checkpoint of another sweep than the first file: scene, command, variations or columns differ" \
		merge other part1 --checkpoint x
	echo hawser-sweep-1 >damaged
	refuses 1 "damaged is no checkpoint of a sweep: its first line is damaged" merge damaged --checkpoint x
	echo hawser-sweep-1 "$(printf %064d 0)" 99999999999 >damaged
	refuses 1 "damaged is no checkpoint of a sweep: its first line is damaged" merge damaged --checkpoint x
}
if [ -n "${HAWSER_LONG-}" ] && command -v mpirun >/dev/null; then
	export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
	mpirun -n 3 --oversubscribe "$HAWSER" sweep chairlift.yaml --over "tension.T0=60 kN:100 kN:5" --over span.h=0,10 \
		--reproducible --tsv ranks.tsv --quiet -- statics
	try "three ranks write the same bytes" cmp one.tsv ranks.tsv
fi

printf '# a study\ntension.T0 (kN)\tspan.h\n80\t10 m\n1\t0 m\n90\t5 m\n' >list.tsv
run sweep chairlift.yaml --list list.tsv --keep sag -- statics
try "one of three has no equilibrium: exit status 2" test $status -eq 2
try "  its row has the status alone, the others have values" \
	test "$(sed '/^#/d; /^tension/d' "$scratch/out" | awk -F '\t' '{ printf "%s:%s:%s ", $1, $3, $4 != "" }')" = "80:0:1 1:2:0 90:0:1 "
try "  the message is in the comments and on standard error" \
	test "$(cat "$scratch/out" "$scratch/err" | grep -c 'tension.T0 = 1 kN, span.h = 0 m: .*below the least one')" -eq 2

sweep="sweep chairlift.yaml --over tension.T0=60000:100000:3"
refuses 1 "nothing is computed: no variation can be read; the first, tension.TO = 6: unknown key tension.TO: did you mean T0? tension takes H, T0, T1, length0, sag, branch, state" \
	sweep chairlift.yaml --over tension.TO=6,7 -- statics
refuses_like 1 '^hawser: --keep sga: the result of statics has no such column; it has model, H_N,' $sweep --keep sga -- statics
refuses_like 1 'it has no|has no such list; there is table, modes' sweep b-table-5.4.yaml --over travel.speed=1 --rows mode -- modes -n 1
refuses_like 1 "--tsv: each variation would write this file again" $sweep -- statics --tsv x
refuses_like 1 "KEY=FROM:TO:POINTS" sweep chairlift.yaml --over "tension.T0=60:100 kN:3" -- statics
refuses_like 1 "with 2 to 10000000 points" sweep chairlift.yaml --over "tension.T0=60 kN:100 kN:4294967298" -- statics
refuses 1 "--over: value 2 of tension.T0 has more than 308 characters: put it into the scene" \
	sweep chairlift.yaml --over "tension.T0=1,$(printf %0320d 0)" -- statics
refuses_like 1 "some values of tension.T0 have a unit" sweep chairlift.yaml --over "tension.T0=60,100 kN" -- statics
refuses_like 1 "--over tension.T0=0:1:3:log: from 0 to 1 there are no equal ratios" sweep chairlift.yaml --over tension.T0=0:1:3:log -- statics
refuses 1 "--set tension.T0=7: the sweep varies this key: give it once" $sweep -- statics --set tension.T0=7
refuses_like 1 "a bracket of the key is open or empty" sweep rod-bend.yaml --over "loads[0.force[2]=1,2" -- statics
refuses_like 1 "tension.T0 is varied twice" $sweep --over tension.T0=1,2 -- statics
refuses_like 1 "the command is missing" $sweep
refuses_like 1 'nothing is computed: no variation can be read; the first, tension.T0 = 6 kg: tension.T0: "6 kg"' \
	sweep chairlift.yaml --over "tension.T0=6 kg:60 kg:5000" -- statics
# one syntax: a range, a list in brackets, a list
for values in "60 kN:100 kN:2:log" "[60 kN, 100 kN]" "60 kN,100 kN"; do
	works "values $values" sweep chairlift.yaml --over "tension.T0=$values" --keep sag --tsv values.tsv -- statics
	try "  are 60 and 100 kN" test "$(sed '/^#/d; /^tension/d' values.tsv | cut -f 1 | tr '\n' ' ')" = "60 100 "
done
works "a list of one key" sweep chairlift.yaml --over "load.per_length=[0,1,0]" --keep sag --tsv values.tsv -- statics
try "  is one value" test "$(grep -c '^.0,1,0.' values.tsv)" -eq 1
refuses 1 "report has no result of one scene to put into a table" $sweep -- report
done_testing

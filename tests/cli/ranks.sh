#!/bin/sh
# hawser map by several processes: ranks of mpirun, parts and merge, give the bytes of one process; so does a map whose rank
# was killed and that is continued by others. HAWSER_LONG=1: that map has 1000 x 1000
# points, of which all are computed.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
cat >hill.json <<'END'
{"hawser_rom": 1, "n": 2, "D": [[0.02, 0], [0, 0.03]], "K": [[1, 0], [0, 2.3]],
 "harmonics": [{"k": 1, "phase": "cos", "K": [[1, 0.2], [0.2, 1.1]], "f": [0.1, 0.2]}]}
END
cat >duffing.json <<'END'
{"hawser_rom": 1, "n": 1, "D": [[0.1]], "K": [[1]], "C": [[0, 0, 0, 0, 0.5]],
 "harmonics": [{"k": 1, "phase": "cos", "f": [0.4]}]}
END
stability="map hill.json --x Omega=0.8:4 --y factor.load=0:0.5 --points 30x22 --quantity multiplier --reproducible -q"
amplitude="map duffing.json --x Omega=0.5:2 --y factor.load=0.5:2 --points 8x5 --quantity amplitude --reproducible -q"
basin="map duffing.json --x u1=-2:2 --y v1=-2:2 --Omega 1.4 --points 10x8 --quantity basin --reproducible -q"

# one KIND: the result of one process
one() {
	eval "command=\$$1"
	# shellcheck disable=SC2086,SC2154 # words; by eval
	run $command --threads 1 --tsv "$1.tsv" --json "$1.json"
	try "$1: one process" said 0
}
# same TEXT KIND FILE: the table and the JSON in FILE.tsv and FILE.json are those of one process
same() {
	if cmp "$2.tsv" "$3.tsv" && cmp "$2.json" "$3.json"; then echo; else echo "differs"; fi >"$scratch/why" 2>&1
	grep -v '^$' "$scratch/why" | nothing "$1"
}
for kind in stability amplitude basin; do
	one $kind
done

# --- parts
# parts KIND N: all parts, joined, and the result
parts() {
	eval "command=\$$1"
	k=0
	rm -f part*.map all.map
	while [ $k -lt "$2" ]; do
		k=$((k + 1))
		# shellcheck disable=SC2086
		"$HAWSER" $command --part $k/"$2" --checkpoint part$k.map || echo "part $k failed"
	done 2>&1 | nothing "$1: $2 parts"
	run merge part*.map --checkpoint all.map
	try "$1: the parts are joined" said 0
	cp all.map before.map
	# shellcheck disable=SC2086
	run $command --checkpoint all.map --tsv parted.tsv --json parted.json
	same "$1: the bytes of one process after $2 parts" "$1" parted
}
parts stability 3
try "few points are left by the parts" test $((20*($(wc -l <all.map) - $(wc -l <before.map)))) -lt "$(wc -l <all.map)"
parts amplitude 2
try "nothing is left by parts of rows" cmp all.map before.map
parts basin 2
printf 'broken' >>part1.map
run merge part2.map part1.map part1.map --checkpoint twice.map -q
# shellcheck disable=SC2086
run $basin --checkpoint twice.map --tsv parted.tsv --json parted.json
same "files in any order, twice, one cut" basin parted

# shellcheck disable=SC2086
{
refuses 1 '--part 0/3: write K/N, such as 2/8: part 2 of 8; N is at most 10000' $stability --part 0/3 --checkpoint a
refuses 1 '--part 1/3: the results of a part are kept in a checkpoint: write --checkpoint FILE, a file of its own for each part' \
	$stability --part 1/3
refuses 1 '--tsv: a part has no result: join the checkpoints of all parts with hawser merge, and give this option to the map that continues from that' \
	$stability --part 1/3 --checkpoint a --tsv b
}
refuses 1 '--checkpoint is missing: write --checkpoint FILE, the new file' merge part1.map
refuses 1 'the checkpoint all.map exists: name a new file, or remove it' merge part1.map --checkpoint all.map
refuses 1 'hill.json is no checkpoint: name files that hawser map or sweep --checkpoint wrote' merge hill.json --checkpoint b
refuses 1 'hill.json is no checkpoint of a map, as the first file is: name files that hawser map or sweep --checkpoint wrote' \
	merge part1.map hill.json --checkpoint b
refuses 1 'cannot open the checkpoint none.map: No such file or directory' merge none.map --checkpoint b
"$HAWSER" map hill.json --x Omega=0.8:4 --y factor.load=0:0.5 --points 4x4 -q --checkpoint other.map >/dev/null
refuses 1 'other.map belongs to another map than part1.map: another scene, quantity, range or setting; name the parts of one map' \
	merge part1.map other.map --checkpoint b
{ sed -n 1,2p part2.map; echo bad; sed -n 3p part2.map; } >damaged.map
refuses 4 'the checkpoint damaged.map is damaged in line 3: compute this part again' merge damaged.map --checkpoint b
try "nothing is left of a join that failed" test ! -e b

# --- HDF5
# has FILE TABLE GROUP: each column of the table, bit by bit, since 17 digits name a double
has() {
	grep -v '^#' "$2" >rows
	head -n 1 rows | tr '\t' '\n' >columns
	k=0
	while read -r column; do
		k=$((k + 1))
		tail -n +2 rows | cut -f $k >want
		h5dump -y -w 1 -m %.17g -d "/$3/$column" "$1" | sed -n '/DATA {/,$ s/^ *"\{0,1\}\([^ "},]*\)"\{0,1\},\{0,1\}$/\1/p' |
			sed 's/^nan$//' | head -n "$(wc -l <want)" >got
		cmp want got || diff want got | head -n 3
	done <columns >"$scratch/hdf5" 2>&1
	test -s columns && nothing "HDF5 has the table $2" <"$scratch/hdf5"
}
# shellcheck disable=SC2086
{
	refuses 1 '--hdf5: a part has no result: join the checkpoints of all parts with hawser merge, and give this option to the map that continues from that' \
		$stability --part 1/3 --checkpoint a --hdf5 b
	run $stability --tsv points.tsv --boundary lines.tsv --hdf5 points.h5
}
if grep -q 'built without HDF5\|be loaded' "$scratch/err" || ! command -v h5dump >/dev/null; then
	skip "HDF5 or h5dump is not there"
else
	try "HDF5 is written" said 0
	has points.h5 points.tsv points
	has points.h5 lines.tsv boundaries
	# shellcheck disable=SC2086
	run $amplitude --boundary events.tsv --hdf5 rows.h5
	try "with --hdf5 no table is printed" test ! -s "$scratch/out"
	has rows.h5 events.tsv boundaries
	for fact in "x.to=4" "x.key=\"Omega\"" "scene.sha256=\"$(sha256sum hill.json | cut -d' ' -f1)\"" "command=\"hawser $stability --tsv points.tsv --boundary lines.tsv --hdf5 points.h5\""; do
		h5dump -a "${fact%%=*}" points.h5 | tr -d '\n' | grep -qF "(0): ${fact#*=}"
		try "HDF5 states ${fact%%=*}" test $? = 0
	done
	# shellcheck disable=SC2086
	(trap '' XFSZ; ulimit -f 20; exec "$HAWSER" $stability --hdf5 full.h5) >"$scratch/out" 2>"$scratch/err"
	try "no room: status 4, a message, no file" test "$? $(cat "$scratch/err") $(ls full.h5* 2>/dev/null)" = \
		"4 hawser: cannot write full.h5 as HDF5: is there room on the disk? "
	# shellcheck disable=SC2086
	refuses 1 '--hdf5 -: HDF5 is written to a regular file only' $stability --hdf5 -
fi

# --- ranks
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl_base_warn_component_unused=0 OMPI_MCA_btl=^tcp
with() {
	ranks=$1
	shift
	timeout 120 mpirun -n "$ranks" --oversubscribe "$HAWSER" "$@" >"$scratch/out" 2>"$scratch/err"
	status=$?
}
# shellcheck disable=SC2086,SC2154
with 3 $amplitude --threads 2 --tsv ranks.tsv --json ranks.json
if ! command -v mpirun >/dev/null || grep -q 'built without MPI\|libopenmpi3' "$scratch/err"; then
	skip "mpirun or MPI in hawser is not there: $(head -c 200 "$scratch/err" | tr '\n' ' ')"
	done_testing
	exit 0
fi
try "amplitude: three ranks" said 0
same "amplitude: three ranks write the bytes of one process" amplitude ranks
if [ -n "${HAWSER_LONG:-}" ]; then # each start of MPI takes half a second
	for kind in stability basin; do
		eval "command=\$$kind"
		# shellcheck disable=SC2086
		with 3 $command --threads 2 --tsv ranks.tsv --json ranks.json
		try "$kind: three ranks" said 0
		same "$kind: three ranks write the bytes of one process" $kind ranks
	done
	with 2 map - --x Omega=1:2 --y factor.load=0:1
	try "a scene on standard input" grep -q 'several ranks cannot read the scene from standard input' "$scratch/err"
	with 3 map none.json --x Omega=1:2 --y factor.load=0:1
	try "an error is told once" test "$(grep -c '^hawser:' "$scratch/err")" = 1
fi

# A worker is killed when the checkpoint has some points.
side=40 half=500
[ -z "${HAWSER_LONG:-}" ] || side=1000 half=503000
slow="map hill.json --x Omega=0.8:4 --y factor.load=0:0.5 --points ${side}x$side
	--quantity multiplier --coarse 1 --reproducible -q"
# shellcheck disable=SC2086
{
	run $slow --tsv slow.tsv --json slow.json
	mpirun -n 3 --oversubscribe sh -c 'echo $$ >rank.$OMPI_COMM_WORLD_RANK; exec "$@"' sh "$HAWSER" $slow \
		--checkpoint slow.map --tsv killed.tsv >"$scratch/out" 2>"$scratch/err" &
	mpi=$!
	while kill -0 $mpi 2>/dev/null; do
		[ ! -e slow.map ] || kill -STOP "$(cat rank.1)" # the map does not end without its points
		[ ! -e slow.map ] || [ "$(wc -l <slow.map)" -lt $half ] || break
		sleep 0.05
	done
	kill -9 "$(cat rank.1)"
	wait $mpi
	status=$?
}
try "a rank that was killed: status" test $status -ne 0
try "a rank that was killed is named" grep -q '^hawser: rank 1 (process [0-9]* on .*) has ended before its work was done.*; the points so far are in the checkpoint slow.map: start the map again, with any number of ranks' "$scratch/err"
try "this is told once" test "$(grep -c '^hawser:' "$scratch/err")" = 1
try "it wrote no result" test ! -e killed.tsv
# shellcheck disable=SC2086
with 2 $slow --checkpoint slow.map --tsv again.tsv --json again.json
try "continued with two ranks" said 0
same "continued with two ranks: the bytes of one process" slow again
done_testing

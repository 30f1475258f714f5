#!/bin/sh
# A disk that is full, a limit on the size of files, a pipe that its reader closes, a folder that may not be
# written, a write that is interrupted: told, and nothing left behind.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
big="--points 4000"

# limited BLOCKS ARGUMENTS: run with files no longer than so many blocks of 512 bytes (of 1024 in some shells).
limited() {
	(ulimit -f "$1"; shift; exec "$HAWSER" "$@") <"$scratch/in" >"$scratch/out" 2>"$scratch/err"
	status=$?
	: >"$scratch/out"
}
for output in --tsv --json; do
	limited 64 statics "$chairlift" $big $output out.file
	try "$output beyond the limit of a file's size" \
		exactly 4 "hawser: cannot write out.file: File too large"
	try "leaves nothing" holds ""
done
echo old >out.tsv
limited 64 statics "$chairlift" $big --tsv out.tsv
try "over an old file" exactly 4 "hawser: cannot write out.tsv: File too large"
try "which is as it was" test "$(cat out.tsv)" = old
rm out.tsv
limited 64 statics "$chairlift" $big
try "standard output" exactly 4 "hawser: cannot write standard output: File too large"

# every command tells of a full disk, on standard output and on a file
short="--from 0.5 --to 0.52"
if [ -w /dev/full ]; then
	while read -r line; do
		set -f
		# shellcheck disable=SC2086
		eval "set -- $line"
		set +f
		"$HAWSER" "$@" >/dev/full 2>"$scratch/err"
		status=$?
		: >"$scratch/out"
		try "$1: a full disk" exactly 4 \
			"hawser: cannot write standard output: No space left on device"
		refuses 4 "cannot write /dev/full: No space left on device" "$@" --json /dev/full
	done <<-END
		statics "$chairlift" --points 2
		modes "$chairlift" -n 2
		irvine "$chairlift" --points 3 -n 2
		campbell "$top/notebooks-data/scenes/b-table-5.3.yaml" -n 1 --points 2 --to 10
		rom "$chairlift" -n 2
		integrate "$duffing" --Omega 1 --until 1 --every 0.5
		frf "$duffing" $short
		folds "$duffing" --starts 0
		map "$duffing" --x Omega=1:2 --y factor.load=1:2 --quantity amplitude --points 3x3 --threads 1
		plan "$chairlift" --fidelities "raw 1"
	END
	refuses 4 "cannot write /dev/full: No space left on device" rom "$duffing" --json /dev/full
	# a picture takes no numbers with it
	ln -s /dev/full full.svg
	"$HAWSER" statics "$chairlift" --points 2 --plot full.svg >rows 2>"$scratch/err"
	status=$?
	: >"$scratch/out"
	try "a picture on a full disk" like 4 "cannot write .*full.svg: No space left on device"
	try "its numbers are printed" grep -q '^# closure' rows
	try "and its rows" grep -q '^[0-9]' rows
	rm -f rows full.svg
else
	skip "there is no /dev/full"
fi
try "and leaves nothing" holds ""

# a checkpoint on a full disk: what it has is good
map="map $duffing --x Omega=1:2 --y factor.load=1:2 --points 13x13 --coarse 1 --threads 1"
works "a map" $map --tsv whole.tsv -q
limited 8 $map --checkpoint check --tsv out.tsv -q
try "a checkpoint beyond the limit" like 4 "cannot write the checkpoint check: File too large"
try "keeps its points and no more" holds "check whole.tsv "
works "the map goes on from it" $map --checkpoint check --tsv out.tsv -q
for f in out whole; do grep -v '^#' $f.tsv >$f; done
try "to the same rows" cmp out whole
rm -f check out* whole*

# a reader that has had enough; and one, where SIGPIPE is ignored
for line in "statics $chairlift $big --tsv -" "statics $chairlift $big --json -" \
	"frf $duffing --from 0.5 --to 1.4 --step 1e-3" "statics --help"; do
	# shellcheck disable=SC2086
	{ "$HAWSER" $line 2>"$scratch/err"; echo $? >../status; } | head -n 1 >/dev/null
	try "a closed pipe: ${line%% *}" test ! -s "$scratch/err"
done
(trap '' PIPE; "$HAWSER" statics "$chairlift" $big 2>"$scratch/err"; echo $? >../status) |
	head -n 1 >/dev/null
status=$(cat ../status)
: >"$scratch/out"
try "a closed pipe without SIGPIPE" exactly 4 "hawser: cannot write standard output: Broken pipe"

# a folder that may not be written; root may write anywhere, so it goes as somebody else
as=
if [ "$(id -u)" -eq 0 ]; then
	as="setpriv --reuid=65534 --regid=65534 --clear-groups"
	chmod 755 "$scratch" .
	$as true 2>/dev/null && $as "$HAWSER" --version >/dev/null 2>&1 || as=none
fi
if [ "$as" != none ]; then
	chmod 555 .
	cp "$chairlift" ../scene.yaml
	chmod 644 ../scene.yaml
	for line in "statics ../scene.yaml --tsv out.tsv" "rom ../scene.yaml --json out.json" \
		"frf ../scene.yaml --from 0.6w1 --to 0.7w1 --json out.json"; do
		# shellcheck disable=SC2086
		(exec $as "$HAWSER" $line) <"$scratch/in" >"$scratch/out" 2>"$scratch/err"
		status=$?
		try "a read-only folder: ${line%% *}" \
			exactly 4 "hawser: cannot write out.${line##*.}: Permission denied"
	done
	(exec $as "$HAWSER" map ../scene.yaml --x Omega=1:2 --y factor.load=1:2 --points 3x3 \
		--checkpoint check) <"$scratch/in" >"$scratch/out" 2>"$scratch/err"
	status=$?
	try "and a checkpoint" like 4 "cannot open the checkpoint check: Permission denied"
	chmod 755 .
	try "nothing is left in it" holds ""
else
	skip "root writes read-only folders, and can't be somebody else here"
fi

# interrupted while a slow reader takes the result
if command -v python3 >/dev/null; then
	cat >../check.py <<'END'
import os, signal, subprocess, sys, time
hawser, fifo = sys.argv[1], "../slow"
os.mkfifo(fifo)
reader = os.open(fifo, os.O_RDONLY | os.O_NONBLOCK)
run = subprocess.Popen([hawser] + sys.argv[2:] + ["--tsv", fifo], stdout=subprocess.DEVNULL,
                       stderr=subprocess.PIPE)
time.sleep(1.5)
if run.poll() is not None:
    sys.exit("it ended by itself: " + run.communicate()[1].decode())
# the first may be taken as a wish for what there is so far, which is then written; the next is not
for again in range(5):
    run.send_signal(signal.SIGTERM)
    try:
        err = run.communicate(timeout=5)[1]
        break
    except subprocess.TimeoutExpired:
        pass
else:
    run.kill()
    sys.exit("it does not end")
if run.returncode not in (-signal.SIGTERM, 128 + signal.SIGTERM, 4):
    sys.exit("status %d, %s" % (run.returncode, err.decode()))
END
	try "a write to a pipe that nobody reads is interrupted" \
		python3 -S ../check.py "$HAWSER" statics "$chairlift" $big
	rm -f ../slow
	try "and one of a command that minds Ctrl-C" python3 -S ../check.py "$HAWSER" \
		frf "$duffing" --from 0.5 --to 1.4 --step 1e-3
else
	skip "python3 is not installed"
fi
try "nothing is left" holds ""
done_testing

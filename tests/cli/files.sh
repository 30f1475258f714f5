#!/bin/sh
# Files appear whole or not at all, under the name, the mode and the link the user expects.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

refuses 4 "cannot write missing/out.json: No such file or directory" \
	statics "$chairlift" --json missing/out.json
refuses 4 "cannot write missing/out.tsv: No such file or directory" \
	frf "$chairlift" --tsv missing/out.tsv
refuses 4 "cannot write missing/model.json: No such file or directory" \
	rom "$chairlift" --json missing/model.json
refuses 4 "cannot write missing/out.svg: No such file or directory" \
	statics "$chairlift" --plot missing/out.svg
refuses_like 4 "cannot write .*missing" rom "$chairlift" --export auto missing/stem
refuses 1 "cannot tell the kind of picture from the name out.gif: it must end in .svg, .png, .pdf, .eps or .tex, \
or .gp for a script of gnuplot (or be - for SVG on standard output)" statics "$chairlift" --plot out.gif
refuses 1 "--json and --tsv both write to standard output" \
	statics "$chairlift" --json - --tsv -
refuses 1 "--tsv and --plot both write to a.svg" statics "$chairlift" --tsv a.svg --plot a.svg
cp "$chairlift" ../scene.yaml
refuses 1 "--tsv would overwrite the input ../scene.yaml" statics ../scene.yaml --tsv ../scene.yaml
try "which it has not" cmp ../scene.yaml "$chairlift"
refuses 1 "--json .././scene.yaml would overwrite the input ../scene.yaml, which is the same file" \
	statics ../scene.yaml --json .././scene.yaml
ln -s scene.yaml ../link.yaml
refuses 1 "--json ../link.yaml would overwrite the input ../scene.yaml, which is the same file" \
	statics ../scene.yaml --json ../link.yaml
cp "$chairlift" "$scratch/in"
refuses 1 "--json ../in would overwrite the input on standard input, which is the same file" \
	statics - --json ../in
: >"$scratch/in"
refuses 1 "--json a.svg and --plot ../work/a.svg both write to the same file" \
	statics "$chairlift" --json a.svg --plot ../work/a.svg
for ending in scene.auto scene.f90 c.scene; do
	cp "$chairlift" ../$ending
	refuses 1 "--export would overwrite the input ../$ending" \
		rom ../$ending --export auto ../scene
	refuses 1 "--json ./../$ending and --export ../$ending both write to the same file" \
		rom "$chairlift" --export auto ../scene --json ./../$ending
	try "../$ending is left alone" cmp ../$ending "$chairlift"
	rm ../$ending
done
try "nor were these carried out" cmp ../scene.yaml "$chairlift"
try "none of these left a file" holds ""

HAWSER_GNUPLOT=/nonexistent
export HAWSER_GNUPLOT
refuses 4 "cannot draw: no gnuplot program found at HAWSER_GNUPLOT=/nonexistent; install gnuplot \
(Debian: gnuplot-nox), or write the numbers with --tsv" frf "$chairlift" --plot out.svg --tsv out.tsv
try "a missing gnuplot stops before anything is written" holds ""
printf '#!/bin/sh\necho part of a picture\necho "something is wrong" >&2\nexit 3\n' >../gnuplot
chmod +x ../gnuplot
HAWSER_GNUPLOT=$scratch/gnuplot
refuses 4 "$scratch/gnuplot failed with status 3 (something is wrong); no picture is written" \
	statics "$chairlift" --plot out.svg --json out.json
try "a failing gnuplot leaves the numbers" holds "out.json "
rm out.json
printf '#!/bin/sh\nkill -9 $$\n' >../gnuplot
refuses 4 "$scratch/gnuplot was ended by signal 9; no picture is written" \
	statics "$chairlift" --plot out.svg --tsv out.tsv
try "so does a killed one" holds "out.tsv "
rm out.tsv
unset HAWSER_GNUPLOT

unserved
umask 027
works "a new file" statics "$chairlift" --tsv out.tsv
try "has the mode of the umask" test "$(stat -c %a out.tsv)" = 640
try "without other output than the summary" test "$(grep -vc '^#' "$scratch/out")" -eq 0
chmod 604 out.tsv
ln -s out.tsv link.tsv
works "through a link" statics "$chairlift" --tsv link.tsv -q
try "a link stays one" test -L link.tsv
try "an old file keeps its mode" test "$(stat -c %a out.tsv)" = 604
try "--quiet prints no summary" test ! -s "$scratch/out"
rm out.tsv link.tsv
if [ "$(id -u)" -ne 0 ]; then
	: >kept.tsv
	chmod 444 kept.tsv
	refuses 4 "cannot write kept.tsv: Permission denied" statics "$chairlift" --tsv kept.tsv
	rm -f kept.tsv
else
	skip "root writes read-only files"
fi
if [ -w /dev/full ]; then
	"$HAWSER" statics "$chairlift" >/dev/full 2>"$scratch/err"
	status=$?
	: >"$scratch/out"
	try "a full device" exactly 4 "hawser: cannot write standard output: No space left on device"
	refuses 4 "cannot write /dev/full: No space left on device" \
		statics "$chairlift" --tsv /dev/full
	"$HAWSER" --help >/dev/full 2>"$scratch/err"
	status=$?
	try "which --help notices too" \
		exactly 4 "hawser: cannot write standard output: No space left on device"
else
	skip "there is no /dev/full"
fi
works "/dev/stdout is written as it is" statics "$chairlift" --tsv /dev/stdout --points 2
try "with its table" test "$(grep -vc '^#' "$scratch/out")" -eq 3

# a reader that has had enough: the end by SIGPIPE that the shell expects, without a word
"$HAWSER" statics "$chairlift" --points 100000 2>"$scratch/err" | head -n 1 >/dev/null
try "a closed pipe is no error to talk about" test ! -s "$scratch/err"

# standard input, for scenes and models
cp "$chairlift" "$scratch/in"
works "a scene on standard input" statics - --points 2
"$HAWSER" statics "$chairlift" --points 2 | grep -v '^#' >rows
grep -v '^#' "$scratch/out" | try "gives the same rows" diff - rows
works "frf takes one too" frf - --to 0.7w1
cp "$duffing" "$scratch/in"
works "a model on standard input" frf - --from 0.5 --to 2
"$HAWSER" frf "$duffing" --from 0.5 --to 2 | grep -v '^#' >rows
grep -v '^#' "$scratch/out" | try "gives the same rows" diff - rows
printf '{"cable": {"EA": 4e8, "rho": 6}, "span": {"d": 250, "h": 10}, "tension": {"T0": 8e4}}' \
	>"$scratch/in"
works "a scene written as JSON is no model" integrate - --until 1 --every 0.5
# nothing but n and K makes a model; a pipe is read once
plain='{"n": 1, "K": [[1]], "harmonics": [{"k": 1, "phase": "cos", "f": [0.1]}], "D": [[0.1]]}'
printf '%s' "$plain" >../plain.json
works "a model needs no mark" frf ../plain.json --from 0.5 --to 2
grep -v '^#' "$scratch/out" >rows
mkfifo ../pipe
printf '%s' "$plain" >../pipe &
works "a model out of a pipe" frf ../pipe --from 0.5 --to 2
wait $!
grep -v '^#' "$scratch/out" | try "gives the same rows" diff rows -
cat "$chairlift" >../pipe &
works "a scene out of a pipe" integrate ../pipe --Omega 0.9w1 --until 1 --every 0.5
wait $!
echo '{"n": 1, "K": [[1, 2]]}' >../pipe &
refuses_like 1 '^hawser: \.\./pipe: K\[0\]' frf ../pipe
wait $!
cat "$chairlift" >../pipe &
works "for statics too" statics ../pipe --points 2
wait $!
cat "$chairlift" >"$scratch/in"
run frf /dev/stdin --to 0.7w1
try "and a scene as /dev/stdin" said 0
: >"$scratch/in"
rm rows
try "nothing is left" holds ""
done_testing

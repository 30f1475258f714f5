#!/bin/sh
# hawser frf --beside: a second response in the picture, from its JSON result.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

works "a response with folds" frf "$duffing" --from 0.6 --to 1.8 --json the-same.json -q
refuses 1 "--beside needs --plot or --gp: give that" frf "$duffing" --beside the-same.json
refuses 1 "--beside - and the input - are both standard input: give one of them as a file" \
	frf - --beside - --plot a.svg
refuses 1 "--beside $duffing: that is no result of hawser frf with points, as --json writes it" \
	frf "$duffing" --beside "$duffing" --plot a.svg
refuses 1 'cannot read none.json: No such file or directory' frf "$duffing" --beside none.json --plot a.svg
refuses 1 "--beside the-same.json: that response has no units, and this model has them: give one of the same kind" \
	frf "$chairlift" --beside the-same.json --plot a.svg

if ! command -v gnuplot >/dev/null; then
	skip "gnuplot is not installed"
	done_testing
	exit
fi

# The pale line of a response beside itself goes through the places of its own solid and dashed lines.
works "a response beside itself" frf "$duffing" --from 0.6 --to 1.8 --beside the-same.json --plot same.svg -q
cat >places.py <<'END'
import re, sys
text = open(sys.argv[1], encoding="utf-8").read()
lines = [(stroke, {tuple(map(float, p)) for p in re.findall(r"[ML]?(-?[\d.]+),(-?[\d.]+)", d)})
         for stroke, d in re.findall(r"<path stroke='([^']*)'[^>]*? d='([^']*)'", text)]
def places(colour):
    return set().union(*[p for stroke, p in lines if stroke.replace(" ", "") == colour])
pale, own = places("rgb(166,203,227)"), places("rgb(0,114,178)")
assert len(pale) > 100, (len(pale), sorted({stroke for stroke, _ in lines}))
far = [p for p in pale if min(abs(p[0] - q[0]) + abs(p[1] - q[1]) for q in own) > 1.0]
# only the ends of the line in the legend, and points beside the folds, where own lines end at the event
assert len(far) <= 6, far
assert "the same" in text
END
try "it has the same places, and its name" python3 -IS places.py same.svg

# Another number of modes, and units: raw and condensed.
works "raw" frf "$chairlift" --from 0.6w1 --to 0.9w1 --json raw-5-modes.json -q
works "condensed, beside it" frf "$chairlift" -n 3 --set model.condense=static --from 0.6w1 --to 0.9w1 \
	--beside raw-5-modes.json --backbone 1 --plot both.svg -q
try "both are named" sh -c "grep -q 'raw 5 modes, quarter-span' both.svg && grep -q 'backbone, mid-span' both.svg"

sed 's/_mid"/_elsewhere"/g; s/_quarter"/_elsewhere"/g; s/three_/at_/g' raw-5-modes.json >elsewhere.json
run frf "$chairlift" -n 3 --from 0.6w1 --to 0.7w1 --beside elsewhere.json --plot a.svg -q
try "points of other names: a warning" grep -q 'has no displacement of a point that this model has' "$scratch/err"
done_testing

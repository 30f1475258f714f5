#!/bin/sh
# What every command that takes a model says of a model that is not good enough: on standard error, in the
# key `warnings` of its JSON, and in a few words in its picture.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
sketched

cat >off.yaml <<'END'
cable: {EA: 4 MN, rho: 2}
span: {d: 60, h: 3}
tension: {sag: 2}
damping: {ratio: 2 %}
load: {frame: local, per_length: [0, 1.5, 1]}
model: {modes: 1, energy: quartic}
END
plane="--x Omega=0.9w1:1.1w1 --y factor.load=0.5:1"
beyond="--x Omega=20w1:21w1 --y factor.load=0.5:1"
row=0
# what is said; words in the picture, or - where it takes too long; the command line
while IFS='|' read -r said brief line; do
	row=$((row + 1))
	test "$brief" = - || line="$line --gp $row.gp"
	# shellcheck disable=SC2086 # words
	run $line --json $row.json </dev/null
	cp "$scratch/err" $row.err
	try "$line" test "$status" = 0
	try "  says: $said" grep -q "^hawser: warning: .*$said" $row.err
	test "$brief" = - || try "  in the picture: $brief" grep -q "$brief" $row.gp
done <<TABLE
may be off by|may be off by|frf off.yaml --from 0.9w1 --to 1.1w1
modes above|beyond the modes|frf off.yaml --from 20w1 --to 21w1
may be off by|may be off by|orbit 1.json#1
may be off by|may be off by|locus off.yaml --over factor.load=0.5:1 --from 0.9w1 --to 1.1w1
may be off by|may be off by|folds off.yaml --from 0.9w1 --to 1.1w1 --load-from 0.5 --no-isolas
may be off by|may be off by|map off.yaml $plane --points 4x4 --quantity amplitude
may be off by|may be off by|mms off.yaml
may be off by|may be off by|integrate off.yaml --Omega 1w1 --until 40T
moves by up to|moves further|nnm off.yaml
no response was found|-|hill off.yaml $plane --lines 2 --samples 20
modes above|beyond the modes|integrate off.yaml --Omega 20w1 --until 10T
modes above|beyond the modes|map off.yaml $beyond --points 4x4
empty: |empty|map off.yaml $plane --points 4x4
slack: |slack|integrate off.yaml --Omega 1w1 --until 60T --set load.per_length[1]=20
TABLE
python "the same in JSON" <<'END'
import json
for k in range(1, 15):
    said = [line.rstrip("\n")[len("hawser: warning: "):] for line in open(f"{k}.err")]
    assert said and json.load(open(f"{k}.json"))["warnings"] == said, (k, said)
END
done_testing

#!/bin/sh
# The full-order model of a scene: what rom tells of it, that it moves as the reduced one does where the
# load is small, and what is refused.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
exact="--set model.energy=exact"

# --- its size
works "hawser rom" rom "$chairlift" $exact
try "48 coordinates by default" grep -q '^# 48 coordinates, 1 harmonics' "$scratch/out"
try "the method says so" grep -q '^# method: exact strain energy.*full order' "$scratch/out"
grep -E '^(Q|C)' "$scratch/out" | nothing "no tensors"
works "with a basis" rom "$chairlift" $exact --set model.basis=9
try "27 coordinates" grep -q '^# 27 coordinates' "$scratch/out"

# --- its motion: a thousandth of the load, where both models are nearly linear
small="--set load.per_length=[8e-4,8e-4,8e-4] --Omega 1.5w1 --until 3T --every 0.25T"
works "integrate, full order" integrate "$chairlift" $exact --set model.basis=20 $small --tsv full.tsv
works "integrate, 25 modes" integrate "$chairlift" --set model.condense=static -n 25 $small \
	--tsv reduced.tsv
python "the two agree" <<'END'
import csv
def column(name, which):
    rows = csv.DictReader([l for l in open(name) if not l.startswith("#")], delimiter="\t")
    return [float(r[which]) for r in rows]
for which in "y_mid_m", "z_mid_m", "z_quarter_m":
    a, b = column("full.tsv", which), column("reduced.tsv", which)
    assert len(a) == len(b) == 13
    worst = max(abs(x - y) for x, y in zip(a, b)) / max(abs(x) for x in b)
    assert 0 < worst < 5e-3, (which, worst)
END

# --- what is refused
rm -f full.tsv reduced.tsv
refuses_like 1 "can't be written as a reduced-model file" rom "$chairlift" $exact --json model.json
refuses_like 1 "can't be exported" rom "$chairlift" $exact --export auto span
refuses_like 1 "model.basis" frf "$chairlift" $exact -n 7
refuses_like 1 "give 1 to 33" rom "$chairlift" $exact --set model.basis=34
refuses_like 1 "quartic" rom "$chairlift" --set model.energy=cubic
try "no file was written" holds ""
done_testing

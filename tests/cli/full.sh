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
small="--set load.per_length=[8e-4,8e-4,8e-4] --Omega 1.5w1 --until 0.5T --every 0.125T"
works "integrate, full order" integrate "$chairlift" $exact --set model.basis=14 $small --tsv full.tsv
works "integrate, 18 modes" integrate "$chairlift" --set model.condense=static -n 18 $small \
	--tsv reduced.tsv
python "the two agree" <<'END'
import csv
def column(name, which):
    rows = csv.DictReader([l for l in open(name) if not l.startswith("#")], delimiter="\t")
    return [float(r[which]) for r in rows]
for which in "y_mid_m", "z_mid_m", "z_quarter_m":
    a, b = column("full.tsv", which), column("reduced.tsv", which)
    assert len(a) == len(b) == 5
    worst = max(abs(x - y) for x, y in zip(a, b)) / max(abs(x) for x in b)
    assert 0 < worst < 5e-3, (which, worst)
END

# --- a basis that does not hold the linear modes up to twice the range is stated, or refused
deep=$top/notebooks-data/scenes/deep-sag.yaml
short="--from 0.95w1 --to 1.02w1 --step 0.2 --max-points 3"
run frf "$chairlift" $exact --set model.basis=3 $short --json basis.json --tsv basis.tsv
try "three functions (status $status)" test "$status" -eq 0
try "their error is a warning" grep -q "warning: 3 functions a component are off by 3.2e-02 at most" \
	"$scratch/err"
try "and a comment" grep -q '^# basis: 3 functions.*up to 2.9.* rad/s (out-of-plane mode 2)' basis.tsv
python "and true" <<'END'
import json, math
basis = json.load(open("basis.json"))["basis"]
assert basis["functions"] == 3
# the second mode out of the plane, by this basis and truly (hawser modes)
with open("basis.tsv") as f:
    has = [float(l.split("=")[1].split()[0]) for l in f if l.startswith("# natural frequency")]
truth = 2.8975072322718156
assert any(math.isclose(basis["frequency_error"], w/truth - 1, rel_tol=1e-6) for w in has), (basis, has)
END
refuses_like 3 "full-order model of 1 functions a component is off by .* in-plane mode 1" \
	frf "$deep" $exact --set model.basis=1
refuses_like 3 "off by 2.7e\+01 .* in-plane mode 1, 0.96178 rad/s" integrate "$deep" $exact \
	--set model.basis=1 --Omega 0.5 --until 1
rm -f basis.json basis.tsv

# --- what is refused
rm -f full.tsv reduced.tsv
refuses_like 1 "can't be written as a reduced-model file" rom "$chairlift" $exact --json model.json
refuses_like 1 "can't be exported" rom "$chairlift" $exact --export auto span
refuses_like 1 "model.basis" frf "$chairlift" $exact -n 7
refuses_like 1 "give 1 to 33" rom "$chairlift" $exact --set model.basis=34
refuses_like 1 "quartic" rom "$chairlift" --set model.energy=cubic
try "no file was written" holds ""
done_testing

#!/bin/sh
# A value that looks like a slip is a warning, --quiet or not, and changes no result; scenes that are in order
# have none. What looks like a slip: tests/unit/test-plausible.c.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

run statics "$chairlift" --set cable.EA=400 -q --tsv slip.tsv
try "EA: 400: status 0" test "$status" -eq 0
try "one warning, with key, value and suspicion" test "$(cat "$scratch/err")" = "hawser: warning: cable.EA = 400 N \
looks wrong: the speed of sound along the cable, sqrt(EA/rho), is 8.16 m/s (plausible: 100 to 15000 m/s); it would be \
plausible with 400 MN"
run statics "$chairlift" --set tension.T0=80
try "T0: 80: the warning stands before the error" test "$status" -eq 2 -a \
	"$(sed -n '1s/.*plausible with //p;2s/ = .*//p' "$scratch/err")" = "80 kN
hawser: the tension T0 at end A"
run modes "$chairlift" --set tension.H=30 -q --json slip.json
try "modes" grep -q 'tension.H = 30 N' "$scratch/err"
sed 's/8e-1/8e5/' >loads.yaml <<END
{cable: {EA: 400e6, rho: 6}, span: {d: 250, h: 10}, tension: {T0: 80e3}, loads: [{per_length: [0, 1, 0]},
  {per_length: [0, 0, 8e-1], harmonic: 2}]}
END
run statics loads.yaml -q
try "a load of a list" grep -q 'loads.1.per_length = 800000 N/m looks wrong: .* plausible with 0.8 N/m' "$scratch/err"
run check "$top/notebooks-data/scenes/d-figure-9.10.yaml" --set beam.v=1e6
try "a beam without dimensions has none" test "$status" -eq 0 -a ! -s "$scratch/err"

for scene in "$top"/notebooks-data/scenes/*.yaml; do
	case ${scene##*/} in
		net-*|rod-*|ropeway-*) run check "$scene" ;; # statics computes for seconds
		*) run statics "$scene" -q ;;
	esac
	[ "$status" -eq 0 ] || run check "$scene"
	[ -z "$(grep 'looks* wrong' "$scratch/err")" ] || echo "${scene##*/}: $(cat "$scratch/err")"
done | nothing "no scene of the tables has a warning"
done_testing

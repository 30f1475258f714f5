#!/bin/sh
# hawser integrate --after and --lyapunov: rows after a transient, stroboscopic sections, exponents.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
cat >ueda.json <<'EOF'
{"hawser_rom": 1, "n": 1, "D": [[0.05]], "K": [[0]], "C": [[0, 0, 0, 0, 1.0]],
 "harmonics": [{"k": 1, "f": [7.5]}]}
EOF
cat >duffing.json <<'EOF'
{"hawser_rom": 1, "n": 1, "D": [[0.2]], "K": [[1]], "C": [[0, 0, 0, 0, 0.4]],
 "harmonics": [{"k": 1, "f": [0.5]}]}
EOF
cat >span.yaml <<'EOF'
cable: {EA: 20 MN, rho: 3 kg/m}
span: {d: 120 m, h: 20 m}
tension: {T0: 15 kN}
damping: {alpha: 0.5 kg/m/s}
model: {modes: 3, condense: none, inertia: none}
EOF
printf 't_s\tB_y_m\n' >still.tsv
for t in 0 100 200 300 400 500 600 700 800 900; do printf "%s\t0\n" $t >>still.tsv; done
works "all rows" integrate duffing.json --Omega 1.1 --until 40T --every 1T
works "rows after a transient" integrate duffing.json --Omega 1.1 --until 40T --every 1T --after 30T
run integrate duffing.json --Omega 1.1 --until 40T --every 1T
tail -1 "$scratch/out" | cut -c1-16 >all
run integrate duffing.json --Omega 1.1 --until 40T --every 1T --after 30T
tail -1 "$scratch/out" | cut -c1-16 >later
try "end with the same state" cmp all later
try "and are eleven" test "$(grep -vc '^#' "$scratch/out")" = 12
works "continued" integrate duffing.json --Omega 1.1 --until 20T --json half.json -q
run integrate duffing.json --Omega 1.1 --until 40T --every 1T --after 30T --continue half.json
tail -1 "$scratch/out" | cut -c1-12 >later
cut -c1-12 all >short
try "ends with the same state" cmp short later
run integrate ueda.json --Omega 1 --until 600T --after 50T --every 1T --lyapunov --rtol 1e-7 --json ueda.out
works "a section in a picture" integrate ueda.json --Omega 1 --until 300T --every 1T --rtol 1e-7 --plot ueda.svg -q
try "of points" grep -q 'use xlink:href=.#gpPt6. transform' ueda.svg
try "of chaos" grep -q '"lyapunov": {"exponent": \[0.[01]' ueda.out
try "of so many periods" grep -q '"lyapunov_periods": 495' ueda.out
run integrate duffing.json --Omega 1.1 --until 400T --every 1T --lyapunov
try "half of the run, settled" \
	grep -q '^# largest Lyapunov exponent -0.\(1\|0999\).* from 1[78][0-9] periods' "$scratch/out"
refuses_like 1 "over 100 periods or more, and there are 20" integrate duffing.json --Omega 1.1 --until 40T --lyapunov
refuses_like 1 "before its end, --until" integrate duffing.json --Omega 1.1 --until 40T --after 50T
refuses_like 1 "--Omega-to does not go with --after" integrate duffing.json --Omega 1 --Omega-to 2 --until 40T --after 5T
refuses_like 1 "--Omega-to does not go with --lyapunov" integrate duffing.json --Omega 1 --Omega-to 2 --until 400T --lyapunov
refuses_like 1 "by a table over time" integrate span.yaml --motion still.tsv --until 800 --every 10 --lyapunov
done_testing

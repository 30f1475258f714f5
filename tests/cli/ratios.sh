#!/bin/sh
# A list of damping ratios with what a scene may have beside it: each mode, let go by itself, decays with its ratio.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
try_scene() {
	cat >s.yaml <<END
cable: {EA: 60 MN, rho: 8.2 kg/m$2}
span: {d: 240 m, h: 38 m}
tension: {T0: 210 kN}
damping: {ratio: [0.004, 0.02, 0.009]}
model: {modes: 4, condense: static}
$3
END
	for mode in 0 1 2 3; do
		python "state $mode" <<END
import json
u = [0.0]*4
u[$mode] = 1e-6
json.dump({"state": u + [0.0]*4}, open("start.json", "w"))
END
		works "$1: mode $mode is let go" integrate s.yaml --initial start.json --until 12 --every 0.02 --json run$mode.json -q
	done
	python "$1: and decays with its ratio" <<'END'
import json, math
for mode, ratio in enumerate((0.004, 0.02, 0.009, 0.009)):
    r = json.load(open("run%d.json" % mode))
    t, u = r["times"], [s[mode] for s in r["states"]]
    # crossings of zero give the period, the extremes between them (by parabolas) the decrement
    tops = []
    for a, b, c, when in zip(u, u[1:], u[2:], t[1:]):
        if abs(b) >= abs(a) and abs(b) > abs(c) and when > 0.5:
            bend = a - 2*b + c
            tops.append(abs(b - (a - c)**2/(8*bend)))
    decrement = math.log(tops[0]/tops[-1])/(len(tops) - 1)  # of half a period
    found = decrement/math.hypot(math.pi, decrement)
    assert len(tops) > 5 and abs(found/ratio - 1) < 2e-3, (mode, ratio, found)
END
}
try_scene "a mass and a spring" "" "attach: [{at: 40 %, mass: 300 kg}, {at: 70 %, spring: [0, 2 kN/m, 1 kN/m]}]"
try_scene "bending and clamped ends" ", EI: 200 kN.m2" "ends: {A: clamped, B: clamped}"
try_scene "elastic supports" "" "support: {B: {stiffness: [20 MN/m, 20 MN/m, 5 MN/m], mass: 50 kg}}"
done_testing

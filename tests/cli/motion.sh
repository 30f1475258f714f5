#!/bin/sh
# hawser integrate --motion and --load: ends and loads that move as tables say, together with harmonic
# loads, and what is refused.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
cat >span.yaml <<'EOF'
cable: {EA: 20 MN, rho: 3 kg/m}
span: {d: 120 m, h: 20 m}
tension: {T0: 15 kN}
damping: {alpha: 0.5 kg/m/s}
model: {modes: 6, condense: none, inertia: none}
EOF
sed 's/^model/loads: [{frame: local, per_length: [0, 2, 0]}]\nmodel/' span.yaml >list.yaml
sed 's/condense: none/condense: static/' span.yaml >condensed.yaml
python "tables" <<'END'
import math
W = 1.3
def write(name, head, row, start=0.0, step=0.02, rows=601):
    with open(name, "w") as f:
        f.write("\t".join(head) + "\n")
        for i in range(rows):
            t = start + step*i
            f.write("\t".join("%r" % v for v in [t] + row(t)) + "\n")
write("ends.tsv", ["t_s", "A_z_m", "B_x_m", "B_y_m"],
      lambda t: [0.05*math.cos(W*t + 0.4), 0.02*math.cos(W*t - 1), -0.03*math.cos(W*t - 1)])
write("pulse.tsv", ["t_s", "B_y_m"], lambda t: [0.1*math.sin(max(t, 0)/2)**4], start=-2.0, rows=801)
write("load.tsv", ["t_s", "n_N_m"], lambda t: [2*math.cos(W*t)], rows=701)
write("later.tsv", ["t_s", "B_y_m"], lambda t: [0.1*t], start=1.0)
END
# The states, or with another key what it has, of results are the same; the last one is not.
cat >same.py <<'END'
import json, sys
def flat(v):
    if isinstance(v, dict):
        v = [v[k] for k in sorted(v)]
    return sum(map(flat, v), []) if isinstance(v, list) else [v] if isinstance(v, (int, float)) else []
for key in sys.argv[3].split(","):
    a, b = (flat(json.load(open(n + ".json"))[key]) for n in sys.argv[1:3])
    size = max(map(abs, a))
    assert len(a) == len(b) > 100 and all(abs(x - y) < 1e-6*size for x, y in zip(a, b)), key
END
same() {
	if command -v python3 >/dev/null; then
		try "$1" python3 -S same.py "$2" "$3" "$4"
	else
		skip "$1: python3 is not installed"
	fi
}
span="integrate span.yaml --until 6 --every 0.5"
harmonic="--Omega 1.3 --set support.A.motion=[0,0,0.05] --set support.A.phase=0.4 --set support.B.motion=[0.02,-0.03,0]"
# shellcheck disable=SC2086 # words
{
works "a harmonic motion" $span $harmonic --set support.B.phase=-1 --json harmonic.json -q
run $span --motion ends.tsv --json ends.json
try "the same by a table, which begins with a jump" \
	grep -q 'warning: motion: at t = 0 s the ends already move, with 0.03.* m/s; the cable is taken to move along' \
	"$scratch/err"
same "states, displacements, velocities and tensions are the same" harmonic ends states,probes
works "a pulse, from rest, without a warning" $span --motion pulse.tsv --json pulse.json -q
works "a load over time beside it" $span --motion pulse.tsv --load load.tsv --json both.json -q
works "the same as a harmonic load" $span --motion pulse.tsv --Omega 1.3 --set load.frame=local \
	--set load.per_length=[0,2,0] --json beside.json -q
same "the same motion" both beside states,probes
works "a load over time and the list of loads" integrate list.yaml --until 6 --every 0.5 --load load.tsv \
	--Omega 1.3 --json list.json -q
works "are twice that load" $span --Omega 1.3 --set load.frame=local --set load.per_length=[0,4,0] \
	--json twice.json -q
same "the same motion with the list" list twice states,probes
refuses 1 "the model is forced: give its frequency with --Omega, such as --Omega 0.9w1" \
	integrate list.yaml --until 6 --load load.tsv
works "a run is continued" $span --motion pulse.tsv --continue pulse.json --until 7 --json last.json -q
works "full order" $span --until 2 --motion pulse.tsv --set model.energy=exact --set model.basis=3 -q
works "condensed, with elastic supports" integrate condensed.yaml --until 2 --every 0.5 --motion pulse.tsv \
	--set support.B.stiffness=[1e6,2e6,3e6] -q
refuses 1 "the run is from t = 0 to 20 s, and the history of the ends from -2 to 14 s: end the run before it, or \
extend the history" $span --until 20 --motion pulse.tsv
refuses_like 1 "the history of the ends from 1 to 13 s" $span --motion later.tsv
refuses_like 1 "moves the ends, and so does support.B.motion of the scene" $span --motion ends.tsv \
	--set support.B.motion=[0,0.01,0] --Omega 1
refuses_like 1 "[-]-motion ends.tsv does not go with modes: auto" $span --set model.modes=auto --motion ends.tsv
refuses_like 1 "[-]-motion ends.tsv does not go with travel" $span --set travel.speed=3 --set travel.hold=tension \
	--motion ends.tsv
works "a model" rom span.yaml --json model.json -q
refuses_like 1 "[-]-motion ends.tsv does not go with a reduced-model file" integrate model.json --motion ends.tsv
refuses_like 1 "damping.drag = 0.3 kg/m\^2 is for a cable with supports at rest" $span --motion ends.tsv \
	--set damping.drag=0.3
}
printf 't_s y_m\n0 1\n1 2\n' >bad.tsv
refuses 1 "bad.tsv: unknown column y_m: the columns can be t_s, A_x_m, A_y_m, A_z_m, B_x_m, B_y_m, B_z_m" \
	integrate span.yaml --motion bad.tsv
done_testing

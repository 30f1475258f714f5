#!/bin/sh
# Wind on a net: one of a single cable is the span, at rest, in damped modes, in limit cycles and their stability; the motion
# of its mesh, whose ledger has the work of the wind; sections of cables of their own, and from files.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

wind="{speed: 6, density: 1.225, diameter: 0.032, drag: [1, 0.2, 1.5], lift: [0.1, -1.8, 0, 8]}"
cat >span.yaml <<END
cable: {EA: 25 MN, rho: 2}
span: {d: 300, h: 0}
tension: {length0: 300.11}
damping: {ratio: 0.005}
wind: $wind
model: {modes: 4}
END
cat >net.yaml <<END
nodes: {A: [0, 0, 0], B: [300, 0, 0]}
cables: [{name: c, from: A, to: B, EA: 25 MN, rho: 2, length0: 300.11, elements: 64}]
supports: {A: fixed, B: fixed}
damping: {ratio: 0.005}
wind: $wind
END
for s in span net; do
	works "statics of the $s" statics $s.yaml --json $s.st -q
	works "damped modes of the $s" modes $s.yaml -n 4 --over wind.speed=3:4:2 --json $s.mo -q
	works "limit cycles of the $s" frf $s.yaml -n 4 --over wind.speed=3:4.7 --branches 2 --json $s.cy -q
done
python "a net of one cable is the span" <<'END'
import json
def near(a, b, e):
    assert abs(a - b) <= e*abs(b), (a, b, a/b - 1)
span, net = ({e: json.load(open(n + e)) for e in (".st", ".mo", ".cy")} for n in ("span", "net"))
near(-net[".st"]["reactions"]["A"][2], 105.878808, 1e-4)  # pull_A of the span
assert len(net[".mo"]["events"]) == len(span[".mo"]["events"]) == 2
for a, b in zip(net[".mo"]["events"], span[".mo"]["events"]):
    near(a["value"], b["value"], 5e-6)
    near(a["frequency"], b["frequency"], 5e-6)
    assert (a["plane"], a["number"]) == (b["plane"], b["number"])
a, b = net[".cy"]["branches"], span[".cy"]["branches"]
near(a[0]["points"][-1]["amplitude"]["y_c_mid"], b[0]["points"][-1]["amplitude"]["y_mid"], 1e-5)
for e, f in zip(a[1]["events"], b[1]["events"]):
    assert e["kind"] == f["kind"] == "torus"
    near(e["parameter"], f["parameter"], 5e-5)
END

# A motion of the mesh and one of modes with the whole force of the wind.
damp="s/^damping.*/damping: {alpha: 0.048}/"
{ sed "$damp" net.yaml; echo "loads: {c: {per_length: [0, 0.3, 0], harmonic: {Omega: 2.2}}}"; } >forced.yaml
{ sed "$damp; s/modes: 4/modes: 24/" span.yaml; echo "load: {frame: global, per_length: [0, 0.3, 0]}"; } >by-modes.yaml
works "a motion of the mesh" integrate forced.yaml --set dynamics.step=0.01 --until 9 --every 3 --json mesh -q
works "the same by modes" integrate by-modes.yaml --set wind.form=exact --Omega 2.2 --until 9 --every 3 --json modes -q
python "they agree, the ledger closes, and the wind works" <<'END'
import json
mesh, modes = (json.load(open(n)) for n in ("mesh", "modes"))
a, b = [x[1] for x in mesh["probes"]["c:0.5"]["x"]], modes["probes"]["mid"]["y"]
assert max(abs(x - a[0] - y) for x, y in zip(a, b)) < 2e-3*max(map(abs, b)), (a, b)
work, lost = mesh["energy"]["work"][-1], mesh["energy"]["dissipated"][-1]
assert mesh["energy"]["closure"] < 1e-9 and work > 0 and lost > 0, (mesh["energy"]["closure"], work, lost)
END

# The same section as the cable's own, as a table, and as a file in degrees.
python "a table and a file of it" <<'END'
from math import pi
rows = [(a*pi/180, 1 + 0.2*a*pi/180, 0.1 - 1.8*a*pi/180) for a in range(-40, 41, 4)]
open("rows", "w").write(str([list(r) for r in rows]))
open("section.csv", "w").write("angle_deg, C_D, C_L\n" +
                               "".join("%.17g, %.17g, %.17g # measured\n" % (a*180/pi, d, l) for a, d, l in rows))
END
own="cables.c.wind={diameter: 0.032, table: section.csv}"
works "a file" statics net.yaml --set wind.drag= --set wind.lift= --set wind.diameter= --set "$own" --json file -q
works "a list" statics net.yaml --set wind.drag= --set wind.lift= --set "wind.table=$(cat rows)" --json list -q
works "a span with the file" statics span.yaml --set wind.drag= --set wind.lift= --set wind.table=section.csv --json with -q
python "they are the same" <<'END'
import json
a, b = (json.load(open(n))["reactions"]["A"] for n in ("file", "list"))
assert all(abs(x - y) < 1e-9*abs(y) for x, y in zip(a, b)), (a, b)
assert len(json.load(open("with"))["scene"]["wind"]["table"]) == 21
END
none="--set wind.drag= --set wind.lift= --set"
printf '# angle, drag, lift\n0 1\n' >lines
denies "a file that is none" 1 "none\.csv: No such file" statics span.yaml $none wind.table=none.csv
denies "a line of two numbers" 1 "lines:2: a line must have 3 numbers" statics net.yaml $none wind.table=lines
denies "wakes of a net" 1 "nets have no wind.wake: remove it, or describe the cable" statics net.yaml --set "wind.wake={at: 8}"
denies "wind and water" 1 "wind contradicts water" statics net.yaml --set "water={density: 1000}"
denies "a wind that passes by" 1 "the wind passes by all cables, since none has a diameter" statics net.yaml --set wind.diameter=0
denies "a section's file that is none" 1 "cables\.c\.wind\.table: none\.csv: No such file" statics net.yaml \
	--set "cables.c.wind={diameter: 0.032, table: none.csv}" --set wind.drag= --set wind.lift= --set wind.diameter=
denies "a section without a wind" 1 "cable c has wind, and the scene has none" statics net.yaml --set wind= --set "$own"
done_testing

#!/bin/sh
# hawser integrate of rods: text, JSON, VTK, picture, states, moving ends, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >rod.yaml <<'END'
kind: rod
rod: {length: 2 m, EA: 10 kN, GA: [4 kN, 3 kN], EI: [2 N.m^2, 3 N.m^2], GJ: 2 N.m^2, rho: 1 kg/m, inertia: [2e-3 kg.m, 1e-3 kg.m, 1e-3 kg.m], elements: 6}
start: {hold: hinged, path: path.txt}
damping: {alpha: 0.2 s^-1}
loads:
  - {at: end, force: [2 N, 0 N, 1 N], factor: [[0 s, 1], [0.1 s, 1], [0.1 s, 0]]}
END
printf '# t x y z\n0 1 0 0\n0.1 1.02 0 0\n0.3 1.1 0 0.05\n1 1 0 0\n' >path.txt
run="integrate rod.yaml --until 0.4 --every 0.05 -q"
works "a rod that hangs from a moving hinge" $run --json all.json --tsv all.tsv --plot all.svg --vtk all --animate all.gif --frames 4 --probe start,0.5,end
works "its first half" integrate rod.yaml --until 0.2 --every 0.05 -q --state half --no-error
works "and its second" $run --initial half --json rest.json
python "JSON, table, VTK, states" <<'END'
import json
r, s = json.load(open("all.json")), json.load(open("rest.json"))
assert r["scene"]["kind"] == "rod" and r["scheme"] == "alpha" and len(r["times"]) == 9
assert 0 < r["step_error"] < 1e-3 and 0 < r["mesh_error"] < 0.2 and s["step_error"] is None
x = r["probes"]["start"]["x"]
assert x[0] == [0, 0, 0] and abs(x[2][0] - 0.02) < 1e-12, x
# at its equilibrium at first, but for the motion of the hinge: the top bears weight, load, and the damping of a node
v = r["probes"]["end"]["v"][0]
assert v == r["probes"]["start"]["v"][0] and abs(r["energy"]["kinetic"][0] - sum(c*c for c in v)) < 1e-12
f = r["start"]["force"][0]
assert all(abs(a - b - 0.2*2/12*c) < 1e-6 for a, b, c in zip(f, [-2, 2*9.81, -1], v)), f
# bit by bit, but for the probes
for key in ("kinetic", "strain", "work", "support", "damped"):
    assert s["energy"][key] == r["energy"][key][4:], key
e = {k: v for k, v in r["energy"].items() if k != "closure"}
total = [e["kinetic"][i] + e["strain"][i] + e["height"][i] - e["work"][i] - e["support"][i] + e["damped"][i] + e["lost"][i] for i in range(9)]
assert max(total) - min(total) < 1e-9, total
assert r["energy"]["closure"] < 1e-2
lines = [l for l in open("all.tsv") if not l.startswith("#")]
assert lines[0].split("\t")[:6] == ["t_s", "start_x_m", "start_y_m", "start_z_m", "start_T_N", "start_M_Nm"], lines[0]
assert len(lines) == 10
assert "POINTS 7 double" in open("all-00008.vtk").read() and "all-00008.vtk" in open("all.vtk.series").read()
assert "Place at start" in open("all.svg").read()
END

refused() { # what, status, words, sed, arguments
	what=$1 status=$2 words=$3 change=$4
	shift 4
	sed "$change" rod.yaml >bad.yaml
	denies "$what" "$status" "$words" integrate bad.yaml -q "$@"
}
refused "no end" 1 "the scene is a rod: give the end of its motion" ''
refused "no mass" 1 "rod.rho is 0: what moves needs a mass" 's/rho: 1 /rho: 0 /' --until 1
refused "no inertia" 1 "rod.inertia is missing" 's/, inertia: .*kg.m\]//' --until 1
refused "an option of models" 1 "--Omega is for spans, nets, ropeways and reduced models" '' --until 1 --Omega 3
refused "another scheme" 1 "the scheme.* of rods" '' --until 1 --method gauss
refused "a probe beyond the end" 1 "the rod ends at 2 m" '' --until 1 --probe 3
refused "no probe" 1 "at most 64 places" '' --until 1 --probe ,
refused "a path that is too short" 1 "is given from 0 s to 1 s, and the run is from 0 to 2 s" '' --until 2
refused "a path that is not there" 1 "cannot be read" 's/path.txt/none.txt/' --until 1
refused "a path of a free end" 1 "start.path: the end is free" 's/hinged/free/' --until 1
refused "a spin of a hinge" 1 "an end that spins must be held by its axes" 's/path: path.txt/spin: {axis: [0, 1, 0], speed: 1 rad\/s}/' --until 1
refused "a spin without axis" 1 "start.spin.axis is missing" 's/hinged, path: path.txt/clamped, spin: {speed: 1 rad\/s}/' --until 1
refused "rest, and an end elsewhere" 1 "dynamics.from is rest, and the end" 's/^damping.*/dynamics: {from: rest}\nend: {at: [1 m, 0 m, 0 m], hold: hinged}/' --until 1
refused "the state of another rod" 1 "is no state of this rod" 's/elements: 6/elements: 7/' --until 1 --initial half
refused "no state" 1 "cannot read the state" '' --until 1 --initial none
refused "an end before the state" 1 "is the state at 0.2 s" '' --until 0.1 --initial half
refused "rows without end" 1 "rows are more than" '' --until 1 --every 1e-9
refused "an element that folds" 2 "turns by pi or more" 's/2 N, 0 N, 1 N\], factor: .*/0 N, 0 N, 0 N], moment: [0 N.m, 0 N.m, 90 N.m], factor: [[0 s, 0], [1 s, 1]]}/; s/elements: 6/elements: 2/' --until 1 --no-error
refused "a node that turns too far in a step" 3 "turns by more than 2 rad in a step" 's/hinged, path: path.txt/clamped, spin: {axis: [1, 0, 0], speed: 1e9 rad\/s}/; s/^damping/g: 0 m\/s^2\ndamping/' --until 0.1 --step 0.01 --no-error
denies "an option of rods" 1 "--no-error is for rods, and .* is a span" integrate "$SRCDIR/notebooks-data/scenes/chairlift.yaml" --no-error
denies "another state file, before the run" 4 "cannot write none/state: No such file" $run --state none/state --until 1e9 --no-error
done_testing

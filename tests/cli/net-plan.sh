#!/bin/sh
# hawser plan of nets: what is modelled and what not, warnings, errors of the mesh, costs, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# As in a batch system: with it, the clock of a process (not that of a thread) stands still between ticks.
ulimit -S -t 1000

# A net in the plane x, y under a load in it; with an axis for z it is in space.
scene() {
	cat <<END
kind: net
nodes: {A: [0 m, 0 m, 0 m], J: {}, B: [60 m, 4 m, 0 m]}
cables:
  - {name: a, from: A, to: J, EA: 2 MN, rho: 1.1 kg/m, length0: 33 m, elements: 10}
  - {name: b, from: J, to: B, EA: 2 MN, rho: 1.1 kg/m, length0: 29 m}
supports: {A: fixed, B: fixed}
masses: {J: 20 kg}
loads: {J: {force: [10 N, -80 N, $1 N], harmonic: {Omega: 1.7 rad/s}}}
damping: {alpha: 0.02 kg/m/s}
END
}
scene 0 >plane.yaml
scene 5 >space.yaml
works "a plan as text" plan plane.yaml
for line in "no   motion out of the plane *nothing drives it: integrate builds no unknowns along z, 58 instead of 87" \
	"no   compression" "no   bending, torsion" "yes  slack members *none" "yes  harmonic loads *1," \
	"cables.\*.elements *10 to 20 *default" "g *9.81 m/s^2 *default" "dynamics.scheme *energy *default" \
	"statics *automatic" "modes *subspace" "integrate *energy *58" "a net of 3 nodes (2 supports) and 2 cables"; do
	try "  $line" grep -q -e "$line" "$scratch/out"
done
works "as JSON" plan plane.yaml --until "3 s" --json plan.json --tsv plan.tsv -q
works "the statics it speaks of" statics plane.yaml --method catenary --profile --json exact.json -q
works "and of the mesh" statics plane.yaml --profile --json mesh.json -q
works "the motion" integrate plane.yaml --until "3 s" --json motion.json -q
works "the motion in space" integrate space.yaml --until "3 s" --json space.json -q
python "they are those that commands have" <<'END'
import json, math
plan, exact, mesh, motion, space = [json.load(open(n + ".json")) for n in ("plan", "exact", "mesh", "motion", "space")]
assert plan["kind"] == "net" and plan["until"] == 3 and plan["unknowns"] == 87 and plan["catenary_unknowns"] == 3
for cable in plan["cables"]:
    a, b = [x["profile"][cable["name"]] for x in (mesh, exact)]
    off = max(math.dist(p[1:4], q[1:4]) for p, q in zip(a, b))
    assert abs(cable["position_error"] - off) <= 1e-9 + 1e-6*off, (cable, off)
    assert cable["elements_wanted"] == math.ceil(cable["elements"]*math.sqrt(off/(1e-3*cable["reach"])))
jobs = {job["name"]: job for job in plan["jobs"]}
assert all(0 < job["least_time_secs"] <= job["time_secs"] <= job["most_time_secs"] for job in jobs.values())
assert jobs["integrate"]["unknowns"] == motion["stats"]["unknowns"] == 58 and space["stats"]["unknowns"] == 87
assert motion["still"] == ["z"] and space["still"] == []
assert jobs["integrate"]["count"] == motion["stats"]["steps"] and jobs["integrate"]["time_by"] == "run"
assert abs(plan["step"] - 3/motion["stats"]["steps"]) < 1e-9
END
works "other numbers of elements" plan plane.yaml --set cables.a.elements=20 --set cables.b.elements=40 --json finer.json -q
python "the error of the mesh is of second order" <<'END'
import json
a, b = [[c["position_error"] for c in json.load(open(n))["cables"]] for n in ("plan.json", "finer.json")]
assert all(3.8 < x/y < 4.2 for x, y in zip(a, b)), (a, b)
END
works "the same bytes again" plan plane.yaml --reproducible --json one.json -q
works "and again" plan plane.yaml --reproducible --json two.json -q
try "they are equal" cmp one.json two.json

warns() {
	called=$1 saying=$2
	shift 2
	works "$called" plan "$@"
	try "  says so" grep -q -e "$saying" "$scratch/out"
}
sed -e '/^supports/s/.*/supports: {A: fixed, B: {fixed: [x, y]}}/' -e 's/, A: fixed//' plane.yaml >loose.yaml
sed -i '/^supports/s/.*/supports: {B: {fixed: [x, y]}}/' loose.yaml
warns "a support that is missing" "no support in direction z" loose.yaml
warns "a strain of 30 %" "strained by more than 10 %: a, b" plane.yaml --set cables.a.EA=900 --set cables.b.EA=900
warns "a coarse mesh" "the mesh is coarse" plane.yaml --set cables.a.elements=2
warns "no mass" "no mass: the inner nodes of a" plane.yaml --set cables.a.rho=0
warns "as good as weightless" "as good as weightless: a" plane.yaml --set cables.a.rho=1e-6 --set cables.a.elements=1
warns "a short wave" "times as many elements" plane.yaml --set loads.J.harmonic.Omega=200 --until "1 s"
omega=$(sed -n 's/.*"first_omega": \([0-9.]*\).*/\1/p' plan.json)
warns "a load at a mode" "within 0.0 % of mode 1" plane.yaml --set "loads.J.harmonic.Omega=$omega"
sed 's/^loads.*/loads: {J: [0, -80, 900]}/' plane.yaml >still.yaml
warns "loads across the plane" "loads across the vertical plane of the supports are" still.yaml
try "and nothing that moves" grep -q "nothing sets the net in motion" "$scratch/out"
sed -e 's/60 m, 4 m, 0 m/48 m, 4 m, 36 m/' -e 's/force: \[10 N, -80 N, 0 N/force: [8 N, -80 N, 6 N/' plane.yaml >turned.yaml
warns "a plane that is not along an axis" "turn the axes of the scene" turned.yaml
printf 'kind: net\nnodes: {A: [0, 0, 0], J: {}, B: [0, -5, 0]}\ncables:\n' >slack.yaml
for cable in "{name: a, from: A, to: J, EA: 1 MN, rho: 0.001 kg/m, length0: 1 m, elements: 1}" \
	"{name: b, from: J, to: B, EA: 1 MN, rho: 0.001 kg/m, length0: 5 m, elements: 1}"; do
	echo "  - $cable"
done >>slack.yaml
printf 'supports: {A: fixed, B: fixed}\nmasses: {J: 9 kg}\n' >>slack.yaml
warns "a slack cable" "slack in the equilibrium: b" slack.yaml

denies "an option of spans" 1 "\-\-fidelities is for spans, and .* is a net" plan plane.yaml --fidelities "raw 5"
denies "an option of nets" 1 "\-\-until is for nets" plan "$chairlift" --until "3 s"
denies "an unknown scheme" 1 "the schemes of nets are" plan plane.yaml --method gauss
denies "a negative time" 1 "until" plan plane.yaml --until "-3 s"
done_testing

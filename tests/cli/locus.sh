#!/bin/sh
# hawser locus: bifurcations in two parameters, against folds, and against responses by shooting of models
# that have the other value of the parameter.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
sketched

duffing="$SRCDIR/notebooks-data/scenes/duffing.json"

# model NAME LOAD DAMPING: the models with both multiplied
model() {
	case $1 in
	cascade) echo '{"n": 1, "K": [[1]], "D": [[0.4*d]], "Q": [[0, 0, 0, -1]],
	"harmonics": [{"k": 1, "phase": "cos", "f": [0.25*p]}]}' ;;
	string) echo '{"n": 2, "K": [[1, 0], [0, 1.02]], "D": [[0.02*d, 0], [0, 0.02*d]],
	"C": [[0, 0, 0, 0, 0.5], [0, 0, 1, 1, 0.5], [1, 1, 1, 1, 0.5], [1, 0, 0, 1, 0.5]],
	"harmonics": [{"k": 1, "phase": "cos", "f": [0.03*p, 0]}]}' ;;
	pair) echo '{"n": 2, "D": [[0.015*d, 0], [0, 0.03*d]], "K": [[1, 0], [0, 4]], "C": [[0, 0, 0, 0, 0.5]],
	"Q": [[0, 0, 1, 2], [1, 0, 0, 1]], "harmonics": [{"k": 1, "f": [0.01*p, 0]}]}' ;;
	mathieu) echo '{"n": 1, "D": [[0.05*d]], "K": [[1]], "C": [[0, 0, 0, 0, 0.5]],
	"harmonics": [{"k": 1, "phase": "cos", "K": [[0.3*p]]}]}' ;;
	esac | python3 -S -c "import re, sys
print(re.sub(r'([0-9.]+)\*([pd])', lambda m: repr(float(m[1])*{'p': $2, 'd': $3}[m[2]]), sys.stdin.read()))"
}
for name in cascade string pair mathieu; do model $name 1 1 >$name.json; done
model cascade 1.5 1 >cascade-other.json
model string 1 0.6 >string-other.json
model pair 1.3 1 >pair-other.json
model mathieu 1.6 1 >mathieu-other.json

works "folds" locus "$duffing" --from 0.8 --to 1.8 --over factor.load=0.05:2 --json fold.json --tsv fold.tsv -q
works "the same by folds" folds "$duffing" --from 0.8 --to 1.8 --load-from 0.05 --starts 0 --json folds.json -q
works "period doublings" locus cascade.json --kind period-doubling --from 1.6 --to 0.7 \
	--over factor.load=0.9:1.5 --json cascade-locus.json -q
works "whirling" locus string.json --kind branch-point --from 0.9 --to 1.4 \
	--over factor.damping=0.6:2 --json string-locus.json --plot whirling.svg -q
works "tori" locus pair.json --kind torus --from 0.9 --to 1.1 --over factor.load=0.5:1.3 --json pair-locus.json -q
works "parametric excitation" locus mathieu.json --kind period-doubling --from 1.5 --to 2.5 \
	--over factor.load=0.2:1.6 --json mathieu-locus.json -q
works "the cascade, other load" frf cascade-other.json --from 1.6 --to 0.7 --method shooting --json cascade-frf.json -q
works "the string, other damping" frf string-other.json --from 0.9 --to 2 --method shooting --json string-frf.json -q
works "the pair, other load" frf pair-other.json --from 0.9 --to 1.1 --method shooting --json pair-frf.json -q
works "Mathieu, other load" frf mathieu-other.json --from 1.5 --to 2.5 --method shooting --json mathieu-frf.json -q
chairlift="$SRCDIR/notebooks-data/scenes/chairlift.yaml"
works "a number of a scene" locus "$chairlift" --kind torus --from 2.8 --to 3.1 --over tension.T0=80e3:80.2e3 \
	--at 80e3 --json scene-locus.json -q
works "the scene with the other tension" frf "$chairlift" --set tension.T0="80.2 kN" --from 2.8 --to 3.1 \
	--json scene-frf.json -q
python "the cusp; ends of curves are events of the other models" <<'END'
import json, math
fold, folds = json.load(open("fold.json")), json.load(open("folds.json"))
cusp, = [e for c in fold["curves"] for e in c["events"] if e["kind"] == "cusp"]
other, = [e for c in folds["curves"] for e in c["events"] if e["kind"] == "cusp"]
assert abs(cusp["Omega"]/other["Omega"] - 1) < 1e-8 and abs(cusp["parameter"]/other["load"] - 1) < 1e-8
found = {"cascade": (1.5, 1), "string": (0.6, 2), "pair": (1.3, 2), "mathieu": (1.6, 2)}
for name, (value, least) in found.items():
    locus, frf = json.load(open(name + "-locus.json")), json.load(open(name + "-frf.json"))
    assert locus["not_followed"] == 0, name
    ends = [c["points"][k] for c in locus["curves"] for k in (0, -1) if c["points"][k]["parameter"] == value]
    events = [e["Omega"] for e in frf["events"] if e["kind"] == locus["kind"]]
    gaps = [min(abs(p["Omega"]/e - 1) for e in events) for p in ends]
    assert len(ends) >= least and max(gaps) < 1e-8, (name, gaps, events)
    for p in (p for c in locus["curves"] for p in c["points"]):
        assert p["residual"] < 1e-9 and p["truncation"] < 1e-9
curve, = json.load(open("scene-locus.json"))["curves"]
here, = [p["Omega"] for p in (curve["points"][0], curve["points"][-1]) if p["parameter"] == 80.2e3]
torus, = [e["Omega"] for e in json.load(open("scene-frf.json"))["events"] if e["kind"] == "torus"]
assert abs(here/torus - 1) < 1e-9, (here, torus)
string, mathieu, pair = (json.load(open(name + "-locus.json")) for name in ("string", "mathieu", "pair"))
names = {e["kind"] for c in string["curves"] for e in c["events"]}
assert {"degenerate-branch-point", "branch-fold"} <= names, names
# the tongue's tip: to first order the excitation 0.3 p/2 balances the damping 0.05, at twice the frequency
low = min((p for c in mathieu["curves"] for p in c["points"]), key=lambda p: p["parameter"])
assert abs(low["parameter"] - 1/3) < 2e-3 and abs(low["Omega"] - 2) < 5e-3, low
assert all(0 < p["angle"] < math.pi for c in pair["curves"] for p in c["points"])
END
# Two fold curves of the chairlift turn sharply where they nearly meet, beside two cusps.
if [ -n "${HAWSER_LONG:-}" ]; then
	for step in 0.01 0.02 0.05 0.1 0.2; do
		works "folds of the chairlift, steps of $step" locus "$chairlift" --from 1.3 --to 4.7 \
			--over factor.load=0.7:1.3 --step "$step" --json near.json -q
		python "the same curves" <<-'END'
		import json
		found = json.load(open("near.json"))
		cusps = sorted(e["Omega"] for c in found["curves"] for e in c["events"] if e["kind"] == "cusp")
		assert found["not_followed"] == 0 and len(found["curves"]) == 11 and len(cusps) == 2, cusps
		assert abs(cusps[0]/2.63381358 - 1) < 1e-7 and abs(cusps[1]/2.63983507 - 1) < 1e-7, cusps
		END
	done
fi
try "special points in the table" grep -q "^# curve 1: cusp at Omega = 1.0441742290. rad/s\|^# curve 1: cusp at Omega = 1.0441742290" fold.tsv
try "and in the picture" grep -q "degenerate-branch-point" whirling.svg

refuses 1 "--kind slack: write fold, period-doubling, torus, branch-point, resonance or hopf" locus cascade.json --kind slack
refuses 1 "--at big: write a number, in SI units" locus "$duffing" --from 0.8 --to 1.8 --at big
refuses_like 1 "outside its range" locus "$duffing" --from 0.8 --to 1.8 --at 3
refuses_like 2 "has no torus in this range" locus "$duffing" --from 0.8 --to 1.8 --kind torus
pair=$SRCDIR/tests/reference/pair-2to1.json
works "folds of two curves" folds "$pair" --from 0.9 --to 1.1 --load-to 1 --starts 0 --json folds.json -q
works "as loci" locus "$pair" --from 0.9 --to 1.1 --over factor.load=0.01:1 --json up.json -q
works "as loci from the other end" locus "$pair" --from 1.1 --to 0.9 --over factor.load=0.01:1 --json down.json -q
python "folds and locus find the same cusps, whichever end the response begins at" <<'END'
import json
cusps = lambda name: sorted((e["Omega"], e.get("load", e.get("parameter"))) for c in json.load(open(name + ".json"))["curves"]
                            for e in c["events"] if e["kind"] == "cusp")
right = cusps("folds")
assert len(right) == 2, right
for name in "up", "down":
    found = cusps(name)
    assert len(found) == 2 and all(abs(a[i]/b[i] - 1) < 1e-6 for a, b in zip(found, right) for i in (0, 1)), (name, found, right)
END
# A stay that whirls: its torus points are on a branch, to which a label leads.
cat >stay.yaml <<'END'
cable: {EA: 150 MN, rho: 12 kg/m}
span: {d: 80 m, h: 35 m}
tension: {T0: 600 kN}
damping: {ratio: 0.2 %}
load: {frame: local, per_length: [0, 0, 1.5 N/m]}
model: {modes: 4, energy: quartic}
END
works "a stay whirls" frf stay.yaml --from 0.98w1 --to 1.02w1 --branches 1 --json whirls.json -q
works "under more load" frf stay.yaml --from 0.98w1 --to 1.02w1 --branches 1 --set 'load.per_length=[0, 0, 1.575 N/m]' --json more.json -q
python "a label on the branch" <<'END'
import json
branch, = json.load(open("whirls.json"))["branches"]
open("inside", "w").write(str([p["label"] for p in branch["points"][1:-1] if "label" in p][0]))
END
refuses_like 2 "has no torus in this range" locus stay.yaml --kind torus --from 0.98w1 --to 1.02w1
works "torus points from a label" locus stay.yaml --kind torus --from 0.98w1 --to 1.02w1 --over factor.load=0.95:1.05 \
	--from-label "whirls.json#$(cat inside)" --json whirling-locus.json -q
python "which end at those of the other load" <<'END'
import json
curve, = json.load(open("whirling-locus.json"))["curves"]
torus, = [e["Omega"] for b in json.load(open("more.json"))["branches"] for e in b["events"] if e["kind"] == "torus"]
end, = [p["Omega"] for p in (curve["points"][0], curve["points"][-1]) if p["parameter"] == 1.05]
assert abs(end/torus - 1) < 1e-8, (end, torus)
END
# an outside program found that the start depended on the tolerance
for tolerance in 1e-7 1e-9 1e-10 1e-11; do
	works "branch points with tolerance $tolerance" locus "$SRCDIR/tests/reference/one-to-three.json" --from 0.7 --to 1.8 \
		--kind branch-point --over factor.load=0.5:2 --tolerance $tolerance --json "points-$tolerance.json" -q
done
python "the branch points do not depend on the tolerance" <<'END'
import json
ends = []
for tolerance in "1e-7", "1e-9", "1e-10", "1e-11":
    result = json.load(open("points-%s.json" % tolerance))
    assert len(result["curves"]) == 1 and result["not_followed"] == 0, tolerance
    ends.append([e["Omega"] for e in result["curves"][0]["events"] if e["kind"] in ("start", "degenerate-branch-point")])
    assert len(ends[-1]) == 2 and max(abs(a/b - 1) for a, b in zip(ends[0], ends[-1])) < 1e-6, ends
END
done_testing

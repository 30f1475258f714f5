#!/bin/sh
# hawser frf: labels of points and events, and runs that begin at one.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >pair.json <<'END'
{"n": 2, "K": [[1, 0], [0, 2.2]], "D": [[0.05, 0], [0, 0.06]],
 "C": [[0, 0, 0, 0, 0.5], [0, 0, 1, 1, 0.3], [1, 1, 1, 1, 0.4], [1, 0, 0, 1, 0.3]],
 "harmonics": [{"k": 1, "phase": "cos", "f": [0.12, 0.04]}]}
END
cat >cascade.json <<'END'
{"n": 1, "K": [[1]], "D": [[0.4]], "Q": [[0, 0, 0, -1]], "harmonics": [{"k": 1, "phase": "cos", "f": [0.25]}]}
END
works "a curve" frf pair.json --from 0.5 --to 2 --json pair-frf.json --tsv pair.tsv -q
works "branches" frf cascade.json --from 1.6 --to 0.7 --step 0.01 --branches 2 --json cascade-frf.json -q
works "a cable" frf "$chairlift" -n 3 --set model.inertia=none --from 1.48 --to 1.41 --json cable-frf.json -q
cat >lib.py <<'END'
import json
def load(name):
    return json.load(open(name + ".json"))
def labels(result):
    return {row["label"]: row for branch in [result] + result.get("branches", [])
            for row in branch["points"] + branch["events"] if "label" in row}
def gap(a, b):
    return max(abs(x - y) for x, y in zip(a["state"], b["state"]))/max(map(abs, b["state"]))
END
python "labels are numbered along the branches; all have states; the table names those of events" <<'END'
import sys; sys.path.insert(0, ".")
from lib import *
for name in "pair-frf", "cascade-frf", "cable-frf":
    result = load(name)
    found = labels(result)
    assert sorted(found) == list(range(1, len(found) + 1))
    for branch in [result] + result.get("branches", []):
        order = [(p["arc"], p["label"]) for p in branch["points"] if "label" in p]
        order += [(branch["points"][e["after"]]["arc"] + 1e-9, e["label"]) for e in branch["events"]]
        assert [label for arc, label in sorted(order)] == sorted(label for arc, label in order)
        assert all("label" in branch["points"][i] for i in (0, 10, -1))
    assert all("state" in row for row in found.values())
events = load("pair-frf")["events"]
lines = [line for line in open("pair.tsv") if line.startswith("# event: fold")]
assert len(lines) == 2 and all(line.rstrip().endswith(f", label {e['label']}") for line, e in zip(lines, events))
open("fold", "w").write(str(events[0]["label"]))
END
begin() { # begin NAME METHOD FROM TO RESULT#LABEL
	works "$2 from $5 towards $4" frf "${5%-frf*}.json" --from "$3" --to "$4" --method "$2" --from-label "$5" --json "$1.json" -q
}
begin up shooting 0.5 2 pair-frf.json#8
begin down balance 2 0.5 pair-frf.json#8
begin grows shooting 0.5 2 "pair-frf.json#$(cat fold)"
begin shrinks balance 2 0.5 "pair-frf.json#$(cat fold)"
begin double shooting 1.6 0.7 cascade-frf.json#16
python "curves that begin at labels are the first ones: same ends, same folds; and the first motion is the label's" <<'END'
import sys; sys.path.insert(0, ".")
from lib import *
pair, cascade, fold = load("pair-frf"), load("cascade-frf"), int(open("fold").read())
for name, whole, label, near in (("up", pair, 8, 1e-9), ("down", pair, 8, 1e-9), ("grows", pair, fold, 1e-3),
                                 ("shrinks", pair, fold, 1e-3), ("double", cascade, 16, 1e-9)):
    result = load(name)
    assert gap(result["points"][0], labels(whole)[label]) < near, name
    ends = [b["points"][i] for b in [whole] + whole.get("branches", []) for i in (0, -1)]
    last = result["points"][-1]
    assert min(gap(last, end) for end in ends if abs(end["Omega"] - last["Omega"]) < 1e-9) < 1e-8, name
    for event in result["events"]:
        assert min(abs(event["Omega"] - e["Omega"]) for e in labels(whole).values() if "kind" in e) < 1e-8, name
assert len(load("up")["events"]) == 2 and len(load("down")["events"]) == 0
assert load("grows")["points"][-1]["Omega"] != load("shrinks")["points"][-1]["Omega"]
END

works "a motion of two periods in time" integrate cascade.json --initial cascade-frf.json#16 --until 4T --every 1T \
	--json time.json -q
python "closes after these and has the label's frequency" <<'END'
import sys; sys.path.insert(0, ".")
from lib import *
run, label = load("time"), labels(load("cascade-frf"))[16]
close = [max(abs(a - b) for a, b in zip(run["states"][0], run["states"][k])) for k in (1, 2, 4)]
assert close[0] > 0.1 and max(close[1:]) < 1e-9, close
assert abs(run["Omega"] - label["Omega"]) < 1e-12
END

works "the motion at a label" orbit cascade.json --from-label cascade-frf.json#16 --json orbit.json --tsv orbit.tsv \
	--plot orbit.svg -q
works "of a cable" orbit "$chairlift" -n 3 --set model.inertia=none --from-label cable-frf.json#3 --json cable.json -q
python "closes; its Fourier coefficients give its state; multipliers have the product of the damping" <<'END'
import sys; sys.path.insert(0, ".")
from math import exp, pi
from lib import *
for name, source, label, decay in ("orbit", "cascade-frf", 16, 0.4), ("cable", "cable-frf", 3, None):
    run, at = load(name), labels(load(source))[label]
    orbit, n = run["orbit"], len(at["state"])//2
    assert orbit["label"] == label and orbit["period"] == (2 if name == "orbit" else 1)
    assert orbit["closure"] < 1e-8, orbit["closure"]
    assert len(run["times"]) == 513
    period = 2*pi*orbit["period"]/at["Omega"]
    assert abs(run["times"][256]/period - 1) < 1e-12
    for j in range(n):  # Parseval
        u = [row[j] for row in run["states"][:256]]
        amplitude = [h["amplitude"][j] for h in orbit["harmonics"]]
        power = amplitude[0]**2 + sum(a*a for a in amplitude[1:])/2
        assert abs(power/(sum(x*x for x in u)/256) - 1) < 1e-4, (power, j)
    assert len(orbit["multipliers"]) == 2*n
    if decay:
        whole = sum(m["log_modulus"] for m in orbit["multipliers"])
        assert abs(whole/(-decay*period) - 1) < 1e-8, whole
lines = open("orbit.tsv").read()
assert "# label 16: a motion of 2 periods of the load" in lines and "# multiplier 2: modulus " in lines
END
cat >softer.json <<'END'
{"n": 1, "K": [[1]], "D": [[0.05]], "C": [[0, 0, 0, 0, 0.4]], "harmonics": [{"k": 1, "K": [[-0.3]]}]}
END
works "two doublings of rest" frf softer.json --from 1.6 --to 2.5 --branches 1 --json softer-frf.json -q
python "labels of events" <<'END'
import json
result = json.load(open("softer-frf.json"))
for name, label in zip(("lower", "upper"), (e["label"] for e in result["events"])):
    open(name, "w").write(f"softer-frf.json#{label}")
pair = json.load(open("pair-frf.json"))
open("fold-label", "w").write(str([e["label"] for e in pair["events"] if e["kind"] == "fold"][0]))
END
works "the lower one" orbit "$(cat lower)" --json lower.json --tsv lower.tsv -q
works "the upper one" orbit "$(cat upper)" --json upper.json -q
works "a fold" orbit pair.json --from-label "pair-frf.json#$(cat fold-label)" --json fold-orbit.json -q
python "normal forms of events" <<'END'
import json
lower, upper, fold = (json.load(open(n + ".json"))["orbit"]["normal_form"] for n in ("lower", "upper", "fold-orbit"))
assert lower["verdict"] == "supercritical" and abs(lower["coefficient"] - 1.60679426) < 1e-6, lower
assert upper["verdict"] == "subcritical" and abs(upper["coefficient"] + 4.68729434) < 1e-6, upper
assert fold["verdict"] == "quadratic" and fold["coefficient"] > 0 and fold["error"] < 1e-4*fold["coefficient"], fold
assert "normal_form" not in json.load(open("orbit.json"))["orbit"]
assert "# normal form: supercritical, coefficient 1.60679" in open("lower.tsv").read()
END
refuses 1 "which motion? write hawser orbit FILE#LABEL, with a label of a JSON result of hawser frf" orbit cascade.json
works "the motion at a label alone" orbit cascade-frf.json#16 --json alone.json -q
python "is that of the model which the result names" <<'END'
import json
a, b = (json.load(open(n + ".json")) for n in ("orbit", "alone"))
assert a["orbit"] == b["orbit"] and a["states"] == b["states"]
END
sed 's/"model_file": "[^"]*"/"model_file": "gone.json"/' cascade-frf.json >moved.json
refuses 1 "moved.json names a scene or model that is not found here, gone.json: write SCENE --from-label moved.json#16, with the scene or model file of that result" \
	orbit moved.json#16
sed 's/"model_file": "[^"]*"/"file": 1/' cascade-frf.json >nameless.json
refuses_like 1 "nameless.json names no scene: write SCENE" orbit nameless.json#16
refuses_like 1 "its state is not one of this model" orbit pair.json --from-label cascade-frf.json#2

works "over the damping" frf "$chairlift" -n 3 --set model.inertia=none --over damping.alpha=0.08:0.1 --max-points 11 \
	--from-label cable-frf.json#3 --json damping.json -q
works "over the tension, backwards" frf "$chairlift" -n 3 --set model.inertia=none --over "tension.T0=81 kN:79 kN" \
	--step 0.1 --tolerance 1e-7 --max-points 11 --from-label cable-frf.json#3 --json tension.json -q
python "begin at the label's motion" <<'END'
import sys; sys.path.insert(0, ".")
from lib import *
label = labels(load("cable-frf"))[3]
for name, value in ("damping", 0.08), ("tension", 80e3):
    first = load(name)["points"][0]
    assert abs(first["parameter"]/value - 1) < 1e-12 and abs(first["Omega"]/label["Omega"] - 1) < 1e-12
    assert gap(first, label) < 1e-6, (name, gap(first, label))
    second = labels(load(name))[2]
    open(name, "w").write(f"{'damping.alpha' if name == 'damping' else 'tension.T0'}={second['parameter']!r}")
END
for name in damping tension; do
	works "and back to the frequency ($name)" frf "$chairlift" -n 3 --set model.inertia=none --set "$(cat $name)" --from 1.48 \
		--to 1.41 --max-points 3 --from-label $name.json#2 --json back.json -q
done
works "over the same key again" frf "$chairlift" -n 3 --set model.inertia=none --over damping.alpha=0.1:0.05 \
	--from-label damping.json#2 --max-points 3 -q

python "results with defects" <<'END'
import sys; sys.path.insert(0, ".")
from lib import *
result = load("pair-frf")
rows = labels(result)
del rows[2]["state"]
rows[3]["Omega"] = "fast"
rows[4]["state"] = [-x for x in rows[4]["state"]]
rows[5]["tension"] = {"min": -2.0, "max": 3.0}
rows[6]["kind"] = "branch-point"
json.dump(result, open("defects.json", "w"))
END
refuses 1 "--from-label pair-frf.json: write FILE#LABEL, with a label of that result" frf pair.json --from-label pair-frf.json
refuses 1 "--from-label pair-frf.json#x: write FILE#LABEL, with a label of that result" frf pair.json --from-label pair-frf.json#x
refuses_like 1 "--from-label pair-frf.json#99: that result has the labels 1 to " frf pair.json --from-label pair-frf.json#99
refuses 1 "--from-label pair.json#1: that is no result of hawser frf with labels, as --json writes it" \
	frf pair.json --from-label pair.json#1
refuses 1 "--from-label does not go with --at: leave out one of them" \
	frf pair.json --from-label pair-frf.json#2 --at 1
refuses_like 1 "its state is not one of this model" frf cascade.json --from-label pair-frf.json#2
refuses 1 "--from-label pair-frf.json#2: that motion is at Omega = $(python3 -S - <<'END'
import sys; sys.path.insert(0, ".")
from lib import *
print("%.9g" % labels(load("pair-frf"))[2]["Omega"])
END
), which is not in the range: give a range that has it" frf pair.json --from 1.9 --to 2 --from-label pair-frf.json#2
refuses 1 "--from-label cable-frf.json#3: that is a result of another scene, with another value of damping.alpha" \
	frf "$chairlift" -n 3 --set model.inertia=none --set damping.alpha=0.1 --from-label cable-frf.json#3
refuses 1 "--initial cable-frf.json#3: that is a result of another scene, with another value of damping.alpha" \
	integrate "$chairlift" -n 3 --set model.inertia=none --set damping.alpha=0.1 --initial cable-frf.json#3
refuses_like 1 "add --set with this value, or follow it with --over damping.alpha" \
	frf "$chairlift" -n 3 --set model.inertia=none --from-label damping.json#2
refuses 1 "--from-label cable-frf.json#3: a state has as many coordinates as the model, and model.modes: auto makes several; \
give a number of modes" frf "$chairlift" --set model.modes=auto --from-label cable-frf.json#3
refuses_like 1 "this point has no motion: take a label beside it" frf pair.json --from-label defects.json#2
refuses_like 1 "that result is damaged: this label has no frequency, period or parameter" \
	frf pair.json --from-label defects.json#3
refuses_like 1 "this model has no such motion; the nearest is off by 2 of its size" \
	frf pair.json --from 0.5 --to 2 --max-points 2 --from-label defects.json#4
refuses_like 1 "there the cable is slack: take a label before, or --slack follow" \
	frf pair.json --from-label defects.json#5
refuses_like 1 "at a branch point two curves cross" frf pair.json --from-label defects.json#6
refuses_like 1 "at a fold the motion can't be followed in another parameter" \
	frf pair.json --over factor.load=0.5:2 --from-label "pair-frf.json#$(cat fold)"
refuses_like 1 "the motion of the label is at Omega = .*: leave --Omega out" \
	frf pair.json --over factor.load=0.5:2 --Omega 1.77 --from-label pair-frf.json#2
refuses 1 "loci of motions of 2 periods of the load are those of their folds, period doublings, tori and branch points, and begin \
at such a motion: give a label of one (--from-label)" \
	locus cascade.json --kind resonance --from 1.6 --to 0.7 --from-label cascade-frf.json#16
works "a motion of two periods over a key" frf cascade.json --over factor.load=0.9:1.1 --from-label cascade-frf.json#16 \
	--json slow-over.json -q
works "its period doubling over the load and the frequency" locus cascade.json --kind period-doubling --from 1.6 --to 0.7 \
	--over factor.load=0.9:1.1 --step 0.1 --from-label cascade-frf.json#16 --json slow-locus.json --tsv slow-locus.tsv -q
cat >last.py <<'END'
import sys; sys.path.insert(0, ".")
from lib import *
curve, = load(sys.argv[1])["curves"]
last = max(curve["points"], key=lambda p: p["parameter"])
END
python "its last point" <<'END'
import sys; sys.argv = ["", "slow-locus"]
exec(open("last.py").read())
open("last", "w").write(repr(last["Omega"]))
END
works "branches over the load there" frf cascade.json --over factor.load=0.9:1.2 --Omega "$(cat last)" --branches 1 \
	--json slow-branches.json -q
works "one alone, from its label" frf cascade.json --over factor.load=0.9:1.2 --switch "slow-branches.json#$(python3 -S - <<'END'
import sys; sys.path.insert(0, ".")
from lib import *
print(load("slow-branches")["events"][0]["label"])
END
)" --json slow-switch.json -q
python "the branches' own doublings are at the locus" <<'END'
import sys; sys.argv = ["", "slow-locus"]
exec(open("last.py").read())
over, all, alone = map(load, ("slow-over", "slow-branches", "slow-switch"))
assert over["period"] == 2 and gap(over["points"][0], labels(load("cascade-frf"))[16]) < 1e-6
assert load("slow-locus")["period"] == 2 and "# motions of 2 periods of the load\n" in open("slow-locus.tsv").read()
assert last["parameter"] == 1.1 and [b["period"] for b in all["branches"]] == [2]
first, second = all["events"][0], all["branches"][0]["events"][0]
assert all["branches"][0]["born_at"] == first["parameter"] < last["parameter"]
for event in second, alone["events"][0]:
    assert event["kind"] == "period-doubling" and abs(event["parameter"]/1.1 - 1) < 1e-9, event
END
cat >half.json <<'END'
{"n": 1, "periods": 2, "K": [[1]], "D": [[0.4]], "Q": [[0, 0, 0, -1]],
 "harmonics": [{"k": 2, "phase": "cos", "f": [0.25]}]}
END
cat >first.json <<'END'
{"hawser_rom": 1, "n": 2, "first_order": true, "parameters": {"A": 0.4, "B": 1.2, "a": 0.05},
 "K": [["B + 1", 0], ["-B", 0]], "terms": [[0, [0, 0, 1], [], -1], [1, [0, 0, 1], [], 1]],
 "harmonics": [{"k": 0, "f": ["A", 0]}, {"k": 1, "f": ["a", 0]}]}
END
works "a model of two periods" frf half.json --from 1.6 --to 0.7 --step 0.01 --branches 2 --json half-frf.json -q
works "from its label" frf half.json --from 1.6 --to 0.7 --step 0.01 --from-label half-frf.json#16 --json half-label.json -q
works "the motion at it" orbit half.json --from-label half-frf.json#16 --json half-orbit.json -q
works "a model with parameters" frf first.json --from 3 --to 0.9 --branches 1 --json first-frf.json -q
works "from its label over one of them" frf first.json --over a=0.05:0.06 --max-points 3 --from-label first-frf.json#3 --json over-a.json -q
works "a motion of it, by the file alone" orbit over-a.json#2 -q
python "models of several periods and with parameters have labels" <<'END'
import sys; sys.path.insert(0, ".")
from lib import *
half, again, orbit, first, over = map(load, ("half-frf", "half-label", "half-orbit", "first-frf", "over-a"))
assert half["period"] == 2 and [b["period"] for b in half["branches"]] == [2, 4]
assert half["events"][0]["kind"] == "branch-point" and half["branches"][1]["born"] == half["branches"][0]["events"][0]["Omega"]
cascade = load("cascade-frf")
for b, c in zip(half["branches"], cascade["branches"]):
    assert abs(b["events"][0]["Omega"]/c["events"][0]["Omega"] - 1) < 1e-9
assert again["period"] == 2 and gap(again["points"][0], labels(half)[16]) < 1e-9
assert orbit["orbit"]["period"] == 2 and orbit["orbit"]["closure"] < 1e-8
assert first["parameters"] == {"A": 0.4, "B": 1.2, "a": 0.05} and first["branches"][0]["period"] == 2
assert abs(over["points"][0]["parameter"] - 0.05) < 1e-15 and gap(over["points"][0], labels(first)[3]) < 1e-6
END
refuses 1 "--from-label first-frf.json#3: that is a result of another model, with another value of a" \
	frf first.json --from 3 --to 0.9 --set a=0.06 --from-label first-frf.json#3
works "every third point" frf pair.json --from 0.5 --to 2 --label-every 3 --json third.json -q
works "events alone" frf pair.json --from 0.5 --to 2 --label-every 0 --json alone.json --tsv alone.tsv -q
python "have a label, as asked for; the motions are the same" <<'END'
import sys; sys.path.insert(0, ".")
from lib import *
tenth, third, alone = map(load, ("pair-frf", "third", "alone"))
last = len(tenth["points"]) - 1
for result, every in (tenth, 10), (third, 3), (alone, 0):
    want = [i for i in range(last + 1) if every and (i % every == 0 or i == last)]
    assert [i for i, p in enumerate(result["points"]) if "label" in p] == want
    assert sorted(labels(result)) == list(range(1, len(want) + len(result["events"]) + 1))
    assert [p["Omega"] for p in result["points"]] == [p["Omega"] for p in tenth["points"]]
assert [e["label"] for e in alone["events"]] == [1, 2]
assert "label 2" in open("alone.tsv").read()
END
works "a run from such a label" frf pair.json --from 0.5 --to 2 --from-label third.json#2 --json from-third.json -q
works "a part of it" frf pair.json --from 0.5 --to 2 --label-every 0 --max-points 25 --json part.json -q
works "goes on" frf pair.json --from 0.5 --to 2 --continue part.json --json on.json -q
refuses 1 "--label-every -1: must be at least 0" frf pair.json --from 0.5 --to 2 --label-every -1
# equilibria and limit cycles over a parameter
own="$SRCDIR/tests/reference/autonomous/adaptx.json"
works "a part of equilibria" frf "$own" --over a=1.5:0.6 --label-every 0 --max-points 30 --json own-part.json -q
works "goes on to its end" frf "$own" --over a=1.5:0.6 --label-every 0 --continue own-part.json --json own-rest.json -q
works "cycles from its Hopf point" frf "$own" --over a=1.5:0.6 --switch own-rest.json#1 --max-points 40 --json own-cycles.json -q
works "go on, too" frf "$own" --over a=1.5:0.6 --continue own-cycles.json --json own-more.json -q
works "or from a label, the other way" frf "$own" --over a=0.6:1.5 --from-label own-cycles.json#3 --json own-back.json -q
python "the same events as in one run" <<'END'
import sys; sys.path.insert(0, ".")
from lib import *
rest, cycles, more, back = map(load, ("own-rest", "own-cycles", "own-more", "own-back"))
assert rest["points"][0]["parameter"] < 1.5 and [e["kind"] for e in rest["events"]] == ["hopf"], rest["events"]
assert more["points"][0]["parameter"] == cycles["points"][-1]["parameter"] and more["end"] == "end of the range"
assert [e["kind"] for e in more["events"]] == ["period-doubling"]
assert abs(more["events"][0]["parameter"] - 0.630302006158) < 1e-9
assert back["end"] == "hopf" and abs(back["events"][-1]["parameter"] - 1) < 1e-9
END
refuses 1 "--continue own-more.json: that curve is complete (end of the range): begin another one" \
	frf "$own" --over a=1.5:0.6 --continue own-more.json
refuses 1 "--continue own-cycles.json: that curve is over a: continue it over the same key" \
	frf "$own" --over b=0.5:2 --continue own-cycles.json
refuses_like 1 "no branch begins there: .* or a Hopf point over the same parameter" \
	frf "$own" --over a=1.5:0.6 --switch own-cycles.json#1
works "the labels of --switch are those of the result" frf cascade.json --from 1.6 --to 0.7 --step 0.01 --label-every 0 \
	--switch 1 --json switched.json -q
done_testing

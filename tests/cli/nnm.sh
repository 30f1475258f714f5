#!/bin/sh
# hawser nnm: nonlinear normal modes, their tongues and branches.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
sketched

scenes="$SRCDIR/notebooks-data/scenes"
works "the two masses" nnm "$scenes/two-masses.json" --energy-to 1e4 --json masses.json --tsv masses.tsv \
	--plot tongue.svg -q
works "three periods" nnm "$scenes/two-masses.json" --mode 2 --energy-to 20 --periods 3 --branches 1 \
	--json three.json -q
works "a span" nnm "$scenes/chairlift.yaml" --branches 1 --from 0.5w1 --to 1.2w1 --json span.json -q
works "its backbone beside the response" frf "$scenes/chairlift.yaml" --from 0.9w1 --to 1.05w1 --backbone 1 \
	--json backbone.json -q
python "tongue, branches, and the same span by two commands" <<'END'
import json, math
masses, three, span = (json.load(open(name + ".json")) for name in ("masses", "three", "span"))
curve, = masses["curves"]
energy = [p["energy"] for p in curve["points"]]
assert min(b - a for a, b in zip(energy, energy[1:])) < 0 < 1e4 <= energy[-1], "the curve has no tongue"
assert curve["end"] == "the largest energy" and curve["parent"] == 0
assert all(p["residual"] < 1e-9 and p["mesh"] <= 1e-9 and p["energy_gap"] < 1e-8 for p in curve["points"])
assert abs(curve["points"][0]["Omega"] - 1) < 0.01 and any(p["unstable"] for p in curve["points"])
first, *branches = three["curves"]
assert len(first["branch_points"]) == 2 and len(branches) >= 2 and three["not_followed"] == 0
assert all(b["parent"] == 1 and b["branch_point"] in (1, 2) for b in branches)
own = span["curves"][0]["points"]
other = json.load(open("backbone.json"))["backbone"]["points"]
def at(points, energy):  # between points, by a cubic
    k = next(i for i in range(1, len(points) - 2) if points[i]["energy"] <= energy <= points[i + 1]["energy"])
    four = points[k - 1:k + 3]
    return sum(p["Omega"]*math.prod((energy - q["energy"])/(p["energy"] - q["energy"]) for q in four if q is not p)
               for p in four)
for p in other[len(other)//2:-2:5]:
    if p["energy"] < own[-3]["energy"]:
        assert abs(at(own, p["energy"])/p["Omega"] - 1) < 1e-6, (p["Omega"], at(own, p["energy"]))
END
try "one row a motion" awk -F '\t' '!/^#/ { n++ } END { exit !(n > 200) }' masses.tsv
try "the picture is in order" grep -q "Energy" tongue.svg

refuses 1 "--mode 3: the model has modes 1 to 2" nnm "$scenes/two-masses.json" --mode 3
refuses_like 1 "travelling cable's., and without symmetry" nnm "$scenes/b-table-5.4.yaml"
refuses_like 1 "--mode 0: must be at least 1" nnm "$scenes/two-masses.json" --mode 0
refuses_like 1 "frequencies of modes 1 and 2 differ by" nnm "$scenes/two-masses.json" --quadrature 2
works "whirling" nnm "$scenes/chairlift.yaml" --mode 2 --branches 1 --json whirl.json --tsv whirl.tsv -q
python "it begins on the plane motion, and is never at rest" <<'END'
import json
whirl = json.load(open("whirl.json"))
plane, *others = whirl["curves"]
assert set(plane["signs"]) == {1} and any(b["turned"] for b in plane["branch_points"])
assert any(-1 in c["signs"] for c in others) and whirl["not_followed"] == 0
assert all(p["residual"] < 1e-9 and p["mesh"] <= 1e-9 and p["energy_gap"] < 1e-8 for c in others for p in c["points"])
END
try "the table names it" grep -q "where whirling begins" whirl.tsv
sed 's/h: 5 m/h: 0 m/; s/modes: 9.*/modes: 4/' "$scenes/b-table-5.4.yaml" >level.yaml
works "a level travelling span" nnm level.yaml --mode 2 --max-points 60 --json level.json -q
python "its modes of the plane are a quarter of a period apart" <<'END'
import json
curve, = json.load(open("level.json"))["curves"]
assert {1, -1} <= set(curve["signs"]) and curve["points"][-1]["energy_gap"] < 1e-8
END
for step in 0.05 0.03; do
	"$HAWSER" nnm "$scenes/level-two-to-one.yaml" -n 4 --step $step --json "level$step.json" -q 2>/dev/null
	"$HAWSER" nnm "$scenes/conductor.yaml" -n 4 --step $step --json "conductor$step.json" -q 2>/dev/null
done
python "branch points do not depend on the steps" <<'END'
import json
for name, first in ("level", 3), ("conductor", 3):
    a, b = (json.load(open(name + step + ".json"))["curves"][0]["branch_points"][:first] for step in ("0.05", "0.03"))
    assert len(a) == first and all(abs(p["energy"]/q["energy"] - 1) < 5e-6 for p, q in zip(a, b)), (a, b)
END
refuses_like 1 "branches" nnm "$scenes/two-masses.json" --branches -1
done_testing

#!/bin/sh
# hawser frf --tori: quasi-periodic motions beyond torus points, against a stroboscopic section.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

rayleigh="$top/notebooks-data/scenes/rayleigh.json"
works "tori" frf "$rayleigh" --from 1.1 --to 1.4 --tori --json tori.json --tsv tori.tsv --plot tori.svg -q
works "the range in the other direction" \
	frf "$rayleigh" --from 1.4 --to 1.1 --tori --json back.json -q
works "the motion at the end of the range" \
	integrate "$rayleigh" --Omega 1.4 --every 1T --after 60T --until 1060T --json section.json -q
works "the same, in steps" \
	integrate "$rayleigh" --Omega 1.4 --every 0.01T --after 60T --until 360T --json steps.json -q
python "curve, table, picture; rotation number and amplitudes are those of the section" <<'END'
import json, math
result, back = json.load(open("tori.json")), json.load(open("back.json"))
curve, other = result["tori"][0], back["tori"][0]
event = [e for e in result["events"] if e["kind"] == "torus"]
assert len(result["tori"]) == len(event) == 1 and curve["from"] == event[0]["Omega"] and "to" not in curve
assert curve["end"] == other["end"] == "range" and "lost" not in curve
last = curve["points"][-1]
assert last["Omega"] == other["points"][-1]["Omega"] == 1.4
assert abs(last["rotation"] - other["points"][-1]["rotation"]) < 1e-5
assert all(p["stable"] and p["growth"] < 0 and p["error"] <= 1e-6 for p in curve["points"])
assert abs(last["second"] - last["rotation"]*1.4/(2*math.pi)) < 1e-12
states = json.load(open("section.json"))["states"]
mean = [sum(s[k] for s in states)/len(states) for k in (0, 1)]
angle = [math.atan2(s[1] - mean[1], s[0] - mean[0]) for s in states]
turn = sum((b - a + math.pi) % (2*math.pi) - math.pi for a, b in zip(angle, angle[1:]))
rho = abs(turn)/(len(angle) - 1)
wanted = abs((last["rotation"] + math.pi) % (2*math.pi) - math.pi)
assert abs(rho - wanted) < 2*math.pi/1000, (rho, wanted)
u = [abs(s[0]) for s in json.load(open("steps.json"))["states"]]
tops = [max(u[k:k + 101]) for k in range(0, len(u) - 100, 100)]
assert abs(max(tops) - last["coordinates"][0]) < 2e-3, (max(tops), last["coordinates"])
assert -2e-3 < min(tops) - last["coordinates_least"][0] < 0.03, (min(tops), last["coordinates_least"])
rows = [line.rstrip("\n").split("\t") for line in open("tori.tsv") if not line.startswith("#")]
at = rows[0].index("tori")
assert rows[0][at + 1] == "extreme"
sides = [row[at + 1] for row in rows[1:] if row[at] == "1"]
assert sides.count("1") == sides.count("-1") == len(curve["points"])
assert any("tori 1: end: range" in line for line in open("tori.tsv"))
assert ">tori<" in open("tori.svg").read()
END
label=$(python3 -S -c "import json; print([e['label'] for e in json.load(open('tori.json'))['events'] if e['kind'] == 'torus'][0])")
works "its torus point" orbit "$rayleigh" --from-label "tori.json#$label" --json point.json -q
if [ -n "${HAWSER_LONG:-}" ]; then
	for eps in 0.5 0.8; do
		works "unstable tori" frf "$top/notebooks-data/scenes/parametric-duffing.json" --set eps=$eps --from 1.3851 --to 1.75 --tori \
			--json hard.json -q
		label=$(python3 -S -c "import json; print([e['label'] for e in json.load(open('hard.json'))['events'] if e['kind'] == 'torus'][0])")
		works "their torus point" orbit "$top/notebooks-data/scenes/parametric-duffing.json" --set eps=$eps \
			--from-label "hard.json#$label" --json hard-point.json -q
		python "is subcritical" <<'END'
import json
assert json.load(open("hard-point.json"))["orbit"]["normal_form"]["verdict"] == "subcritical"
assert not any(p["stable"] for p in json.load(open("hard.json"))["tori"][0]["points"][:3])
END
	done
fi
python "its normal form says that they are stable" <<'END'
import json
assert json.load(open("point.json"))["orbit"]["normal_form"]["verdict"] == "supercritical"
assert json.load(open("tori.json"))["tori"][0]["points"][0]["stable"]
END
works "no torus point" frf "$duffing" --from 0.5 --to 0.6 --tori -q --tsv none.tsv
try "and that is said" grep -q "tori: none, since no torus point was located" none.tsv
works "tori over the load" frf "$rayleigh" --over factor.load=1.5:1 --Omega 1.3 --tori --json over.json --tsv over.tsv -q
works "and over the frequency to there" frf "$rayleigh" --from 1.2 --to 1.3 --tori --json there.json -q
python "end at the same torus" <<'END'
import json
over, there = (json.load(open(name))["tori"][0] for name in ("over.json", "there.json"))
p, q = over["points"][-1], there["points"][-1]
assert p["parameter"] == 1 and abs(p["Omega"]/1.3 - 1) < 1e-12 and over["from"] > 1 and over["end"] == there["end"] == "range"
assert abs(p["rotation"] - q["rotation"]) < 1e-9 and abs(p["coordinates"][0] - q["coordinates"][0]) < 1e-4
assert any(line.startswith("# tori 1: from the torus point of branch 1 at factor.load = 1.249") for line in open("over.tsv"))
END
refuses_like 1 "use shooting or balance" frf "$rayleigh" --tori --method multiple-scales
if [ -n "${HAWSER_LONG:-}" ]; then
	works "tori between two torus points of an internal resonance" frf "$top/tests/reference/pair-2to1.json" --from 0.95 --to 1.05 \
		--tori --json pair.json -q
	python "one curve joins both, and its ends are theirs" <<'END'
import json
result = json.load(open("pair.json"))
ends = [e["Omega"] for branch in [result] + result.get("branches", []) for e in branch["events"] if e["kind"] == "torus"]
curve, = result["tori"]
assert len(ends) == 2 and curve["end"] == "torus-point" and curve["from"] in ends
# extrapolated where the other torus point is on another branch
assert max(abs(a - b) for a, b in zip(sorted([curve["from"], curve["to"]]), sorted(ends))) < 1e-6
last, first = curve["points"][-1], curve["points"][0]
for p in first, last:
    assert 0.8 < p["coordinates_least"][0]/p["coordinates"][0] <= 1
stable = [p["stable"] for p in curve["points"]]
assert stable[0] and stable[-1] and not all(stable)
# SSMTool's example of this system (TwoToOneIRs) prints 20 folds and 20 period doublings of tori of its reduced model of third
# order, along the curve. The full system has all its folds in this order, up to that truncation, and changes of stability at
# 19 doublings; the one at 1.0106 follows a fold so closely that there is no torus between them.
folds = (.98877, .98350, .98622, .97799, .98412, .98269, .99036, .98900, 1.0050, 1.0049, 1.0101, 1.0096, 1.0139, 1.0134, 1.0183,
         1.0122, 1.0155, 1.0106, 1.0123, 1.0089)
doublings = (.98374, .98621, .97818, .98407, .98554, .99025, .99351, .99766, 1.0006, 1.0031, 1.0050, 1.0072, 1.0097, 1.0119,
             1.0135, 1.0183, 1.0122, 1.0155, 1.0122)
w = [p["Omega"] for p in curve["points"]]
if w[0] > w[-1]:
    w.reverse(), stable.reverse()
turns = [b for a, b, c in zip(w, w[1:], w[2:]) if (b - a)*(c - b) < 0]
assert len(turns) == len(folds) and max(abs(a - b) for a, b in zip(turns, folds)) < 4e-4, turns
for printed in doublings:
    assert any(stable[i] != stable[i + 1] and min(w[i:i + 2]) - 4e-4 < printed < max(w[i:i + 2]) + 4e-4
               for i in range(len(w) - 1)), printed
END
fi
done_testing

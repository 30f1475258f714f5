#!/bin/sh
# hawser frf --branches: the branches that begin at bifurcations.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >cascade.json <<'END'
{"n": 1, "K": [[1]], "D": [[0.4]], "Q": [[0, 0, 0, -1]], "harmonics": [{"k": 1, "phase": "cos", "f": [0.25]}]}
END
cat >string.json <<'END'
{"n": 2, "K": [[1, 0], [0, 1.02]], "D": [[0.02, 0], [0, 0.02]],
 "C": [[0, 0, 0, 0, 0.5], [0, 0, 1, 1, 0.5], [1, 1, 1, 1, 0.5], [1, 0, 0, 1, 0.5]],
 "harmonics": [{"k": 1, "phase": "cos", "f": [0.03, 0]}]}
END
works "a cascade" frf cascade.json --from 1.6 --to 0.7 --step 0.01 --branches 2 --json cascade-frf.json --tsv c.tsv \
	--plot c.svg -q
works "whirling" frf string.json --from 0.9 --to 1.4 --branches 1 --json string-frf.json -q
works "by harmonic balance" frf string.json --from 0.9 --to 1.4 --branches 1 --method balance --json balance.json -q
works "none" frf string.json --from 0.9 --to 1.4 --json plain.json -q
python "periods, parents, and where they begin" <<'END'
import json
cascade, string, balance, plain = (json.load(open(name)) for name in
                                   ("cascade-frf.json", "string-frf.json", "balance.json", "plain.json"))
born = [b for b in cascade["branches"] if "parent" in b]
assert [(b["period"], b["parent"]) for b in born] == [(2, 1), (4, 2)], [(b["period"], b["parent"]) for b in born]
assert born[0]["born"] == cascade["events"][0]["Omega"] and born[1]["born"] == born[0]["events"][0]["Omega"]
for b in born:
    assert abs(b["points"][0]["Omega"]/b["born"] - 1) < 1e-3 and b["points"][0]["stable"]
assert "branches" not in plain and not any("period" in b for b in plain.get("branches", []))
for result in string, balance:
    whirl = [b for b in result["branches"] if "parent" in b][0]
    assert whirl["period"] == 1 and max(p["coordinates"][1] for p in whirl["points"]) > 0.5
    assert abs(whirl["born"] - result["events"][0]["Omega"]) < 1e-9
    assert max(p["Omega"] for p in whirl["points"]) > 1.18
end = [e["Omega"] for e in string["events"] if e["kind"] == "branch-point"][1]
for result in string, balance:
    points = [e["Omega"] for e in result["branches"][0]["events"] if e["kind"] == "branch-point"]
    assert len(points) == 1 and abs(points[0] - end) < 1e-8, points
    assert result["branches"][0]["end"] == "meets a branch"
assert abs(string["branches"][0]["born"] - balance["branches"][0]["born"]) < 1e-8
rows = [line.rstrip("\n").split("\t") for line in open("c.tsv") if not line.startswith("#")]
assert rows[0][-1] == "branch" and {r[-1] for r in rows[1:]} == {"1", "2", "3"}
assert sum("of period 4, from branch 2 at Omega = " in line for line in open("c.tsv")) == 1
END
works "by harmonic balance from another label" frf cascade.json --from 1.6 --to 0.7 --step 0.01 --switch cascade-frf.json#15 \
	--method balance --json elsewhere.json --tsv elsewhere.tsv -q
works "one label" frf string.json --from 0.9 --to 1.4 --switch 20 --json one.json -q
run frf string.json --from 0.9 --to 1.4 --switch plain.json#20 --json whirl.json -q
try "whirling from its label, where stability begins undecided" like 0 '^hawser: warning: stability: [0-9]* of [0-9]* points have multipliers'
works "two periods" frf cascade.json --from 1.6 --to 0.7 --step 0.01 --period 2 --json twice.json -q
works "four, from a motion of two" frf cascade.json --from 1.6 --to 0.7 --step 0.01 --from-label cascade-frf.json#16 \
	--period 4 --json four.json -q
python "are the same branches" <<'END'
import json
load = lambda name: json.load(open(name + ".json"))
cascade, elsewhere, one, whirl, twice, four, plain = map(load, ("cascade-frf", "elsewhere", "one", "whirl", "twice", "four",
                                                                "plain"))
kinds = {e["label"]: e["kind"] for b in [cascade] + cascade["branches"] for e in b["events"]}
assert kinds[15] == "period-doubling", kinds
assert elsewhere["period"] == 4 and "period" not in cascade and four["period"] == 4 and twice["period"] == 2
assert abs(elsewhere["events"][0]["Omega"]/cascade["branches"][1]["events"][0]["Omega"] - 1) < 1e-9
assert "# motions of 4 periods of the load\n" in open("elsewhere.tsv")
assert [(e["kind"], round(e["Omega"], 8)) for e in twice["events"]] == [("branch-point", round(cascade["events"][0]["Omega"], 8))]
second = plain["events"][2]
assert second["label"] == 20 and len(one["branches"]) == 1 and one["branches"][0]["born"] == second["Omega"]
for a, b in zip(one["branches"][0]["events"], whirl["events"]):
    assert a["kind"] == b["kind"] and abs(a["Omega"]/b["Omega"] - 1) < 1e-8, (a, b)
assert max(p["coordinates"][1] for p in whirl["points"]) > 0.5
END
refuses 1 "--switch 16: no branch begins there: give the label of a period doubling, a branch point or a Hopf point of this response, \
which its table's head lists" frf string.json --from 0.9 --to 1.4 --switch 16 -q
refuses 1 "--switch plain.json#16: no branch begins there: give the label of a period doubling or a branch point of a \
response over the frequency" frf string.json --from 0.9 --to 1.4 --switch plain.json#16
refuses 1 "--switch plain.json#20: that event is at Omega = 1.18545252, which is not in the range: give a range that has it" \
	frf string.json --from 0.9 --to 1.1 --switch plain.json#20
refuses 1 "--switch x: write a label of this response, or FILE#LABEL" frf string.json --switch x
refuses 1 "--switch plain.json#20 says where to start, and so does --at: give one of them" \
	frf string.json --switch plain.json#20 --at 1
refuses 1 "--period 3: the motion at --from-label cascade-frf.json#16 has 2 periods of the load: give a multiple" \
	frf cascade.json --from 1.6 --to 0.7 --from-label cascade-frf.json#16 --period 3
refuses 1 "--period 2: modes are chosen for motions of one period of the load: give a number of modes" \
	frf "$chairlift" --set model.modes=auto --period 2
refuses 1 "--switch cascade-frf.json#15: no branch begins there: give the label of a period doubling or a branch point over the same \
parameter" frf cascade.json --over factor.load=1:2 --switch cascade-frf.json#15
cat >mathieu.json <<'END'
{"n": 1, "K": [[1]], "D": [[0.05]], "C": [[0, 0, 0, 0, 0.5]], "harmonics": [{"k": 1, "phase": "cos", "K": [[0.3]]}]}
END
works "parametric excitation" frf mathieu.json --from 1.5 --to 2.5 --json mathieu-frf.json -q
run frf string.json --from 0.9 --to 1.4 --method multiple-scales --branches 1 --json scales.json --tsv scales.tsv -q
try "a branch that is not found: a warning" grep -q "^hawser: warning: the branch beside the branch-point at Omega = \
1.03160469 (branch 1) was not found: no orbit of another branch was found" "$scratch/err"
run frf cascade.json --from 1.6 --to 0.7 --step 0.01 --branches 6 --tolerance 3e-3 --json lost.json --tsv lost.tsv -q
try "a branch that is lost: a warning" grep -q "^hawser: warning: branch 2, from the period-doubling at Omega = " \
	"$scratch/err"
python "rest begins its branches by itself; what is missing is said in all results" <<'END'
import json
mathieu, scales, lost = (json.load(open(name + ".json")) for name in ("mathieu-frf", "scales", "lost"))
assert max(p["coordinates"][0] for p in mathieu["points"]) == 0
assert [(b["period"], b["parent"]) for b in mathieu["branches"]] == [(2, 1), (2, 1)]
for b, e in zip(mathieu["branches"], mathieu["events"]):
    assert b["born"] == e["Omega"] and e["kind"] == "period-doubling" and abs(b["points"][0]["Omega"]/b["born"] - 1) < 1e-4
    assert max(p["coordinates"][0] for p in b["points"]) > 0.5
assert [b["points"][5]["stable"] for b in mathieu["branches"]] == [True, False]
for result, name, count, text in ((scales, "scales", 2, "was not found: no orbit"), (lost, "lost", 1, "is incomplete: at Omega")):
    assert len(result["warnings"]) == count and all(text in w for w in result["warnings"]), result["warnings"]
    assert sum(line.startswith("# warning: ") and text in line for line in open(name + ".tsv")) == count
END
works "whirling over a key" frf string.json --over factor.load=3:0.3 --Omega 1.1 --branches 1 --json whirl-over.json -q
works "its locus" locus string.json --kind branch-point --from 0.9 --to 1.4 --over factor.load=0.5:1.5 --json whirl-locus.json -q
python "begins at the locus" <<'END'
import json
over, locus = (json.load(open(f"whirl-{name}.json")) for name in ("over", "locus"))
born = [b["born_at"] for b in over["branches"]]
assert born and max(p["coordinates"][1] for p in over["branches"][0]["points"]) > 0.1, born
for at in born:
    near = []
    for curve in locus["curves"]:
        p = curve["points"]
        for a, b in zip(p, p[1:]):
            if (a["Omega"] - 1.1)*(b["Omega"] - 1.1) <= 0:
                near.append(a["parameter"] + (b["parameter"] - a["parameter"])*(1.1 - a["Omega"])/(b["Omega"] - a["Omega"]))
    assert min(abs(x - at) for x in near) < 1e-3, (at, near)
END
refuses_like 1 "--branches" frf cascade.json --branches -1
done_testing

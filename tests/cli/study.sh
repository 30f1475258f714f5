#!/bin/sh
# plan and compare: what comes out, the same figures by two routes, and what is refused on the way.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scene=$top/notebooks-data/scenes/b-table-4.4-line-2.yaml

works "plan, for people" plan "$scene" --limit 0.1 --fidelities "raw 1"
for section in Modelled "Primary resonances" Fidelities "Settings in use"; do
	try "plan: $section" grep -q "^$section" "$scratch/out"
done
works "plan, for programs" plan "$scene" --limit 0.2 --fidelities "raw 1-2, full 2" --tsv plan.tsv \
	--json plan.json
python "a plan: every setting once, marked as the user's or a default; sizes as built" <<'END'
import csv, json
plan = json.load(open("plan.json"))
by = {s["name"]: s["by"] for s in plan["settings"]}
assert len(by) == len(plan["settings"])
assert by["cable.EA"] == "user" and by["model.condense"] == "user" and by["g"] == "default"
assert by["model.tolerance"] == "default" and by["--tolerance"] == "default"
assert "tension.H" not in by, "the scene has no such key"
assert [f["name"] for f in plan["fidelities"]] == ["raw 1", "raw 2", "full 2", "hawser frf"]
assert plan["fidelities"][2]["unknowns"] == 6
assert [d["why"] for d in plan["decisions"] if d["subject"] == "forces from strains"][0].startswith("from ")
assert all(d["why"] for d in plan["decisions"]) and any(not d["modelled"] for d in plan["decisions"])
assert plan["resonances"][0]["mode"] == 1 and plan["resonances"][0]["folds"] == 2
lines = [l for l in open("plan.tsv") if not l.startswith("#")]
rows = list(csv.DictReader(lines, delimiter="\t"))
for row, f in zip(rows, plan["fidelities"]):
    assert row["fidelity"] == f["name"] and int(row["Q_entries"]) == f["Q_entries"]
    assert float(row["time_s"]) == f["time_secs"] > 0
    assert row["time_is"] == f["time_is"] == "estimate"
    assert f["time_is"] == "estimate" or f["most_time_secs"] is None and f["least_time_secs"] == f["time_secs"]
assert rows[0]["Omega_error"] == "missing", "mode 6 resonates in the range"
END
works "a load that is small is linear: no folds, hardly an error" plan "$scene" --limit 0.1 --json small.json \
	--to 1.2w1 --fidelities "raw 4" --set 'load.per_length=[1e-4, 1e-4, 1e-4]'
python "as the plan says" <<'END'
import json
plan = json.load(open("small.json"))
assert all(r["folds"] == 0 for r in plan["resonances"])
assert plan["fidelities"][0]["Omega_error"] < 1e-6, plan["fidelities"][0]
END
sed '/^load:/,/per_length/d' "$scene" >unloaded.yaml
works "no load: a plan without estimates" plan unloaded.yaml --json unloaded.json
python "says that there is no response" <<'END'
import json
plan = json.load(open("unloaded.json"))
assert not plan["resonances"] and plan["fidelities"][0]["time_secs"] is None
assert plan["fidelities"][0]["time_is"] == ""
assert any(d["subject"] == "forced response" and not d["modelled"] for d in plan["decisions"])
END
refuses 1 "unloaded.yaml: there is no load, so there is no response to compare: add a section load" \
	compare unloaded.yaml
refuses 1 "$chairlift: damping.drag is quadratic, and the fidelities compared have linear damping: set damping.drag=0" \
	compare "$chairlift" --from 1.2 --to 1.7 --set damping.drag=0.1
run rom "$chairlift" --set damping.drag=0.1 -q
try "rom warns of drag" grep -q "warning: damping.drag is no part of these entries" "$scratch/err"

range="--from 0.93w1 --to 1.1w1"
wide="--from 0.85w1 --to 1.2w1 --step 0.02"
picture=
command -v gnuplot >/dev/null && picture="--plot work.svg"
# shellcheck disable=SC2086 # words
works "compare" compare "$scene" $range --fidelities "multiple-scales, raw 2,condensed 1, condensed:2" \
	--landmarks --tsv landmarks.tsv --json compare.json $picture
# shellcheck disable=SC2086
rough "the same response by frf" frf "$scene" $range -n 2 --set model.condense=static --set model.energy=quartic --json frf.json
python "a comparison: counts add up, errors are those of the landmarks, folds those of frf" <<'END'
import csv, json, math
result = json.load(open("compare.json"))
runs = {f["name"]: f for f in result["fidelities"]}
assert result["reference"] == "condensed 2" and runs["condensed 2"]["role"] == "reference"
assert all(r["outcome"] == "complete" for r in runs.values())
assert all((r["role"] == "reference") == (n == "condensed 2") for n, r in runs.items())
assert all(r["planned_secs"] > 0 for r in runs.values())
assert all(r["planned_is"] == "estimate" for r in runs.values())
ends = [r["Omega_end"] for r in runs.values() if r["points"]]
assert all(abs(e/result["to"] - 1) < 1e-12 for e in ends), ends
reference = runs["condensed 2"]
for run in runs.values():
    for kind, name in (("fold", "folds"), ("peak", "peaks")):
        own = [l for l in run["landmarks"] if l["kind"] == kind]
        matched = [l for l in own if l["partner"] is not None]
        assert run[name]["matched"] == len(matched)
        assert run[name]["extra"] == len(own) - len(matched)
        assert run[name]["missing"] == sum(l["kind"] == kind for l in reference["landmarks"]) - len(matched)
        for l in matched:
            other = reference["landmarks"][l["partner"]]
            assert l["kind"] == other["kind"] and l.get("axis") == other.get("axis")
            assert math.isclose(l["Omega_error"], l["Omega"]/other["Omega"] - 1, abs_tol=1e-15)
        worst = max((abs(l["Omega_error"]) for l in matched), default=None)
        assert (run[name]["Omega_error"] is None) == (worst is None)
        assert worst is None or abs(run[name]["Omega_error"]) == worst
assert reference["folds"]["Omega_error"] == 0 and reference["tension_error"] == 0
assert runs["raw 2"]["tension_error"] != 0
assert runs["multiple-scales 16"]["points"] == 0 and runs["multiple-scales 16"]["tension"] is None
folds = [e["Omega"] for e in json.load(open("frf.json"))["events"] if e["kind"] == "fold"]
ours = [l["Omega"] for l in reference["landmarks"] if l["kind"] == "fold"]
assert len(folds) == len(ours) > 0
assert all(abs(a/b - 1) < 1e-9 for a, b in zip(folds, ours)), (folds, ours)
rows = list(csv.DictReader((l for l in open("landmarks.tsv") if not l.startswith("#")), delimiter="\t"))
raw = [r for r in rows if r["fidelity"] == "raw 2"]
assert {r["outcome"] for r in rows} <= {"matched", "missing", "extra"}
assert sum(r["outcome"] == "missing" for r in raw) + sum(r["outcome"] == "matched" for r in raw) == \
    len(reference["landmarks"])
END

narrow="--from 0.9w1 --to 0.92w1 --step 0.05"
# a fidelity that cannot be had is told of; a reference that cannot is an error
# shellcheck disable=SC2086
works "one fails" compare "$scene" $narrow --fidelities "raw 1, raw 101, condensed 1"
try "its row says so" grep -q "^raw 101	compared	failed" "$scratch/out"
try "and a comment why" grep -q "^# raw 101 failed: " "$scratch/out"
# shellcheck disable=SC2086
run compare "$scene" $narrow --fidelities "raw 1" --reference "raw 101"
try "the reference fails" test "$status" -ne 0 -a ! -s "$scratch/out" -a -s "$scratch/err"

# which one is the reference: one that converges before one that does not; an accuracy before a model
# that the plan has further off
reference() {
	want=$1
	# shellcheck disable=SC2086
	works "among $2" compare "$scene" ${3-$narrow} --fidelities "$2"
	try "the reference is $want" grep -q "^$want	reference	complete" "$scratch/out"
}
reference "condensed 3" "auto 5, condensed 3, condensed 2"
reference "auto 5%" "auto 5, condensed 1, raw 2" "--from 0.98w1 --to 1.02w1 --step 0.05"
reference "condensed 1" "condensed 1, raw 3"

# a curve that a limit cuts is told of in its row, and has no reference to be
# shellcheck disable=SC2086
works "a limit of points" compare "$scene" $wide --fidelities "raw 3, condensed 1" --max-points 70 \
	--json cut.json --tsv cut.tsv
try "is told" grep -q "^# raw 3 ended before the range did, at Omega .*: max-points" cut.tsv
python "in the row of the one that is cut" <<'END'
import csv, json
runs = {f["name"]: f for f in json.load(open("cut.json"))["fidelities"]}
assert runs["raw 3"]["outcome"] == "cut" and runs["raw 3"]["points"] == 70
assert runs["condensed 1"]["outcome"] == "complete" and runs["condensed 1"]["points"] < 70
rows = list(csv.DictReader((l for l in open("cut.tsv") if not l.startswith("#")), delimiter="\t"))
assert {r["fidelity"]: r["outcome"] for r in rows} == {n: r["outcome"] for n, r in runs.items()}
assert all(float(r["Omega_end_rad_s"]) == runs[r["fidelity"]]["Omega_end"] for r in rows)
END
# shellcheck disable=SC2086
refuses_like 3 "reference, condensed 1, was cut \\(max-points\\) after 40 points; of the range from 1.06638 to 1.50548 rad/s it got to 1\\.[0-9]+: .*raise --max-points" \
	compare "$scene" $wide --fidelities "raw 1, condensed 1" --max-points 40
# shellcheck disable=SC2086
refuses_like 3 "was cut \\(the time limit\\) .*raise --limit, or name another --reference" \
	compare "$scene" $narrow --fidelities "raw 1, condensed 1" --limit 1e-6
# shellcheck disable=SC2086
refuses_like 3 "auto 5%, was cut \\(the time limit\\)" \
	compare "$scene" $narrow --fidelities "raw 1, auto 5" --limit 1e-6
# The limit is one of processor time, and the reference has as many times that as there are fidelities: with
# 0.6 times what it takes it is complete beside four others.
limit=$(sed -n 's/.*"processor_secs": \([0-9.e-]*\).*/\1/p' compare.json | sort -g | tail -n 1 |
	awk '{ print 0.6*$1 }')
# shellcheck disable=SC2086
works "a share of the limit of $limit s" compare "$scene" $range --limit "$limit" \
	--fidelities "multiple-scales 1, multiple-scales 2, multiple-scales 3, raw 1, condensed 2"
try "the reference is complete" grep -q "^condensed 2	reference	complete" "$scratch/out"
# A process that is stopped for longer than the limit has not used it up.
if [ -n "${HAWSER_LONG-}" ]; then
	# shellcheck disable=SC2086
	(trap '' USR1; exec "$HAWSER" compare "$scene" $range --fidelities "raw 2, condensed 9" --limit 3 \
		>stopped.tsv 2>asked) & pid=$!
	until grep -q points asked; do kill -USR1 $pid && sleep 0.02 || break; done
	kill -STOP $pid; sleep 7; kill -CONT $pid; wait $pid
	try "a busy machine does not shorten the limit" grep -q "^condensed 9	reference	complete" stopped.tsv
fi
if terminals; then
python "what it will cost is said on a terminal before it starts" <<END
import os, pty, subprocess
master, slave = pty.openpty()
subprocess.run(["$HAWSER", "compare", "$scene", "--from", "0.9w1", "--to", "0.92w1",
                "--fidelities", "raw 1, condensed 1"], stdout=subprocess.DEVNULL, stderr=slave, check=True)
os.close(slave)
said = os.read(master, 4096).decode()
assert said.startswith("2 fidelities, reference condensed 1: some 0.") and "--limit" in said, said
END
else
	skip "what it will cost is said on a terminal: $no_terminal"
fi
if [ -n "$picture" ]; then
	try "the picture shows the fidelities" grep -q "multiple-scales" work.svg
	works "nothing in common" compare "$scene" --from 0.5w1 --to 0.55w1 \
		--step 0.05 --fidelities "raw 1, raw 2" --plot none.svg -q
	try "the picture says so" grep -q "Nothing that a fidelity found" none.svg
fi
done_testing

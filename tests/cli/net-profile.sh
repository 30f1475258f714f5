#!/bin/sh
# hawser compare statics: methods on random cables and on scenes, tables, JSON, pictures, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >slack.yaml <<'END2'
kind: net
nodes: {A: [0 m, 0 m, 0 m], J: {}, B: [31 m, 4 m, 0 m]}
cables:
  - {name: a, from: A, to: J, EA: 20 MN, rho: 1.2 kg/m, length0: 17 m, elements: 6}
  - {name: b, from: J, to: B, EA: 20 MN, rho: 1.2 kg/m, length0: 19 m, elements: 6}
  - {name: long, from: A, to: B, EA: 2 MN, rho: 0.3 kg/m, length0: 50 m, elements: 8}
supports: {A: fixed, B: fixed}
END2
sed 's/length0: 17 m/tension: 2 kN/' slack.yaml >tension.yaml
sed 's/length0: 17 m/length0: 15 m/' slack.yaml >taut.yaml
few="--nets 4 --seed 5 --steps 100"
# shellcheck disable=SC2086 # words
works "random cables" compare statics $few --profile --tsv profile.tsv --json few.json --plot few.svg -q
# shellcheck disable=SC2086
works "each" compare statics $few --each --reproducible --tsv each.tsv --json each.json -q
works "two scenes" compare statics slack.yaml taut.yaml --steps 300 --each --tsv two.tsv --json two.json -q
works "one method" compare statics slack.yaml --method mixed --reproducible --json one.json --plot one.svg -q
works "a table" compare statics slack.yaml --steps 300
sed '/^#/d' "$scratch/out" >slack.tsv
try "from scene to answer" grep -qE '^# slack.yaml: read in [0-9.]* ms, solved in [0-9.]* ms \(automatic\): [0-9.]* ms from scene to answer$' "$scratch/out"
try "relaxation" grep -qE '^# slack.yaml: relaxation (takes|gives up after) [0-9.e+]* ms, [0-9.e+]* times as long as automatic$' "$scratch/out"
try "the scenes" grep -q '^# scene: taut.yaml$' two.tsv
try "the legend of the picture" grep -q 'regularised/density: ' few.svg
try "two panels" grep -q 'Processor time, over that of the fastest' few.svg
try "no times in a reproducible one" test "$(grep -c 'Processor time' one.svg)" -eq 0

python "the results" <<'END2'
import csv, json
load = lambda name: json.load(open(name))
table = lambda name: list(csv.DictReader((line for line in open(name) if line[0] != "#"), delimiter="\t"))
few, each, two = load("few.json"), load("each.json"), load("two.json")
assert few["scene"] is None and few["nets"] == 4 and few["seed"] == 5 and "each" not in few
assert [row["method"] for row in table("slack.tsv")] == [m["name"] for m in few["methods"]]
for m in few["methods"]:
    assert m["solved"] + m["compressed"] + m["failed"] == 4 and m["wrong"] == 0 and m["success"] == m["solved"]/4
    mine = [row for row in each["each"] if row["method"] == m["name"]]
    assert [row["net"] for row in mine] == list(range(1, 5))
    for end in ("solved", "compressed", "failed"):
        assert m[end] == sum(row["end"] == end for row in mine)
    solved = sorted(row["iterations"] for row in mine if row["end"] == "solved")
    assert m["iterations"]["max"] == (solved[-1] if solved else None)
    assert m["iterations"]["median"] == (solved[(len(solved) - 1)//2] if solved else None)
    assert all(row["angle"] <= 1e-5 and row["residual"] <= 1e-5 for row in mine if row["end"] == "solved")
    curve = few["profile"]["iterations"][m["name"]]
    assert abs(curve[-1] - m["success"]) < 1e-12 and curve == sorted(curve)
    assert each["profile"]["time"][m["name"]][0] is None
    timed = few["profile"]["time"][m["name"]]
    assert abs(timed[0] - m["best"]) < 1e-12 and abs(timed[-1] - m["success"]) < 1e-12
    if m["name"] in ("automatic", "interior-point", "mixed", "mixed/chord", "forces"):
        assert m["solved"] == 4 and m["seconds"]["median"] <= m["seconds"]["p90"] <= m["seconds"]["max"]
assert sum(m["best"] for m in few["methods"]) >= 1
assert [float(row["solved"]) for row in table("slack.tsv")][:3] == [1, 1, 1]
rows = table("profile.tsv")
assert [float(row["time_mixed"]) for row in rows] == few["profile"]["time"]["mixed"]
assert float(rows[0]["within"]) == 1 and "iterations_two-sided/density" in rows[0]
rows = table("each.tsv")
assert len(rows) == 4*len(few["methods"]) and 10 <= int(rows[0]["elements"]) <= 100 and float(rows[0]["d_m"]) >= 1
assert two["scene"] == {"name": "slack.yaml", "kind": "net", "more": ["taut.yaml"]} and two["nets"] == 2
assert [row["scene"] for row in two["each"]][::len(two["methods"])] == ["slack.yaml", "taut.yaml"]
assert all(m["solved"] == 2 for m in two["methods"] if m["name"] in ("automatic", "interior-point", "forces"))
assert [m["name"] for m in load("one.json")["methods"]] == ["mixed"]
END2

span=$top/notebooks-data/scenes/b-table-4.3-line-2.yaml
refuses 1 "$span is no scene of a net: that is one with kind: net (man hawser-scene, NETS)" compare statics "$span"
refuses 1 "tension.yaml: cable a has no length0: methods are compared on nets whose lengths are known; hawser statics gives those that go with a tension, a force density or a sag" \
	compare statics slack.yaml tension.yaml
refuses 1 "--nets and --seed are of random cables, which are compared without SCENE" compare statics slack.yaml --nets 3
refuses 1 "--set changes a scene, and there is no SCENE" compare statics --nets 3 --set cables.a.EA=3
refuses 1 "--profile and --each are different tables: choose one" compare statics --nets 3 --profile --each
refuses 1 "there is no method newton in this comparison (hawser compare statics --help lists them)" compare statics --method newton
refuses_like 1 "would overwrite the input" compare statics slack.yaml taut.yaml --tsv taut.yaml
refuses_like 1 "nets" compare statics --nets 0
refuses_like 1 "noise" compare statics --nets 2 --noise 0
refuses 1 "2000000 nets are too many to compare: at most 1000000" compare statics --nets 2000000
refuses_like 1 "cannot read nosuch.yaml" compare statics nosuch.yaml
refuses_like 1 "unknown key" compare statics slack.yaml --set cables.a.EE=1
done_testing

#!/bin/sh
# hawser transient: tables, JSON, pictures, refusals with line, key and what to do.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
sketched

line=$SRCDIR/notebooks-data/scenes/ropeway-transient.yaml
works "a stop" transient "$line" --event stop --damping 0.1 --until 10 --json stop.json --tsv stop.tsv --plot stop.svg -q
works "  extremes of spans" transient "$line" --event stop --elements 3 --until "1 s" --spans --tsv spans.tsv -q
works "  and at towers" transient "$line" --event stop --elements 3 --until 1 --towers --tsv towers.tsv -q
works "a carrier passes" transient "$line" --pass p1 --lane down --json pass.json --tsv pass.tsv --plot pass.svg -q
python "JSON and tables" <<'END'
import json
stop, passing = (json.load(open(f + ".json")) for f in ("stop", "pass"))
assert abs(stop["stopped_at"] - 3.2) < 0.01 and stop["slips"] == 0
assert stop["energy"]["closure"] < 1e-10 and 0.0 < stop["error"]["force"] < 1000.0
assert len(stop["spans"]) == 6 and len(stop["towers"]) == 4 and len(stop["rows"]) == 501
row = stop["rows"][-1]
assert row["speed"] == 0.0 and abs(row["travelled"] - 6.4) < 1e-6
# the force that friction leaves open at rest is around that of the loads
assert abs(row["force"] - stop["rest_force"]) < 1500.0
for r in stop["rows"]:
    assert abs(r["slip_arc"] - r["needed_friction"]*3.14159265358979/0.2) < 1e-9
assert [s["name"] for s in stop["spans"][:3]] == ["bottom to p0", "p0 to p1", "p1 to top"]
states = [r["state"] for r in passing["passing"]]
order = [s for i, s in enumerate(states) if i == 0 or s != states[i - 1]]
assert order == ["span", "last", "arc", "first", "span"], order
tables = {name: [l.rstrip("\n").split("\t") for l in open(name + ".tsv") if l[0] != "#"]
          for name in ("stop", "spans", "towers", "pass")}
assert {n: len(t) for n, t in tables.items()} == {"stop": 502, "spans": 7, "towers": 5, "pass": 202}
END
try "pictures" test -s stop.svg -a -s pass.svg

works "a brake of given force" transient "$line" --event stop --set "ropeway.top.drive.brake={force: 20 kN}" --elements 3 --until 1 -q
works "a drive of limited force" transient "$line" --set ropeway.top.drive.force="6 kN" --set ropeway.top.drive.inertia=5000 --elements 3 --until 1 -q
run transient "$line" --event stop --tolerate --set ropeway.top.drive.friction=0.02 --elements 3 --until 1 -q
try "slip is a warning" grep -q "^hawser: warning: the rope slips on the whole drive bullwheel for" "$scratch/err"

# refused OPTIONS TEXT STATUS
refused() {
	run transient "$line" $1
	try "refused: $2" test "$status" -eq "$3"
	try "  says so" grep -q "$2" "$scratch/err"
}
refused "--event stop --elements 3 --set ropeway.top.drive.friction=0.02" "yaml: t = .* slips on the whole drive bullwheel" 2
refused "--set ropeway.top.drive.ramp=0" "top.drive, line 5, ramp is missing or 0" 1
refused "--elements 4" "give an odd number" 1
refused "--lane up" "lane needs --pass TOWER" 1
refused "--pass p1 --until 3" "does not go with --pass" 1
refused "--spans --towers" "does not go with --towers" 1
refused "--until 1 --every 3" "rows must be no further apart" 1
refused "--set ropeway.top.drive.brake.decelaration=1" "decelaration" 1
refused "--set ropeway.top.drive.brake.force=1e3" "deceleration and force" 1
refused "--pass p1 --set ropeway.towers=[]" "has no towers" 1
refused "--pass p1 --set ropeway.top.drive.speed=0" "rope that runs" 1
refused "--pass p1 --case empty" "has no carriers" 1
done_testing

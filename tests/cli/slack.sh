#!/bin/sh
# A response whose cable goes slack: where it ends, the same place read from the model's own curve, the
# branches that cover the rest, and the parts without a branch.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scene="$SRCDIR/notebooks-data/scenes/b-table-4.2.yaml --set model.modes=3 --set load.per_length=[0,0,40]"
range="--from 0.8w1 --to 1.4w1"
for method in shooting balance; do
	# shellcheck disable=SC2086 # words
	works "$method: the curve ends where the cable goes slack" frf $scene $range --method $method \
		--json "$method.json" --tsv "$method.tsv" --plot "$method.svg"
	try "$method: that is told" grep -q '^hawser: warning: slack: the least tension falls to zero at' \
		"$scratch/err"
	# shellcheck disable=SC2086
	works "$method: the model's curve goes on" frf $scene $range --method $method --slack follow \
		--step 0.002 --json "$method-follow.json"
done
python "the end is where the tension of the model's own curve is zero" <<'END'
import json

for method in "shooting", "balance":
	a, b = json.load(open(method + ".json")), json.load(open(method + "-follow.json"))
	event, last = a["events"][-1], a["points"][-1]
	assert a["end"] == "slack" == event["kind"] and event["located"] and 0 < event["error"] < 1e-6
	assert abs(last["tension"]["min_N"]) < 1e-6*last["tension"]["max_N"] and last["Omega_rad_s"] == event["Omega_rad_s"]
	assert all(p["tension"]["min_N"] > 0 for p in a["points"][:-1])
	# inverse interpolation in T through four points of the other curve
	T = [p["tension"]["min_N"] for p in b["points"]]
	k = next(k for k in range(len(T)) if T[k + 1] < 0)
	x, y = T[k - 1:k + 3], [p["Omega_rad_s"] for p in b["points"][k - 1:k + 3]]
	at = sum(y[i]*__import__("math").prod(x[j]/(x[j] - x[i]) for j in range(4) if j != i) for i in range(4))
	assert abs(at/event["Omega_rad_s"] - 1) < 2e-6, (at, event)
	assert b["end"] != "slack" and min(T) < 0 and "branches" not in b
END
python "from the other end the curve is another branch, and both have their rows" <<'END'
import json

for method in "shooting", "balance":
	a = json.load(open(method + ".json"))
	other = a["branches"][0]
	assert abs(other["points"][0]["Omega_rad_s"]/a["range_rad_s"][1] - 1) < 1e-12
	assert all(p["tension"]["min_N"] > -1e-6*p["tension"]["max_N"] for one in a["branches"] for p in one["points"])
	rows = [line.split("\t") for line in open(method + ".tsv") if line[0] != "#"]
	k = rows[0].index("branch")
	count = {str(i + 1): 0 for i in range(1 + len(a["branches"]))}
	for row in rows[1:]:
		count[row[k]] += 1
	assert list(count.values()) == [len(a["points"])] + [len(one["points"]) for one in a["branches"]], count
	covered = sorted((min(p["Omega_rad_s"] for p in one["points"]), max(p["Omega_rad_s"] for p in one["points"]))
	                 for one in [a] + a["branches"])
	lo, hi = a["range_rad_s"]
	for gap in a["gaps"]:
		assert not any(c[0] < 0.5*(gap["from_rad_s"] + gap["to_rad_s"]) < c[1] for c in covered)
	assert a["gaps"] and any("no periodic motion was found" in w for w in a["warnings"])
	picture = open(method + ".svg").read()
	assert "slack" in picture and "no branch found" in picture
END
# shellcheck disable=SC2086
fails 1 "a wrong word for --slack" frf $scene --slack stop
# shellcheck disable=SC2086
fails 1 "a curve that ends slack is complete" frf $scene $range --method shooting --continue shooting.json
# shellcheck disable=SC2086
works "it is followed on request" frf $scene $range --method shooting --continue shooting.json --slack follow \
	--max-points 5 --json on.json
finish

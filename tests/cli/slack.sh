#!/bin/sh
# A response whose cable goes slack: where it ends, the same place read from the model's own curve, the
# branches that cover the rest, and the parts without a branch.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
sketched

cat >slack.yaml <<'END'
cable: {EA: 4 MN, rho: 2}
span: {d: 60, h: 3}
tension: {sag: 2}
damping: {ratio: 2 %}
load: {frame: local, per_length: [0, 6, 0]}
model: {modes: 2}
END
scene=slack.yaml
range="--from 0.9w2 --to 1.6w2"
for method in shooting balance; do
	# shellcheck disable=SC2086 # words
	run frf $scene $range --method $method --json "$method.json" --tsv "$method.tsv" \
		--plot "$method.svg"
	try "$method: the curve ends where the cable goes slack" test "$status" = 0
	try "$method: that is told" grep -q '^hawser: warning: slack: the least tension falls to zero at' \
		"$scratch/err"
	# shellcheck disable=SC2086
	run frf $scene --from 1w2 --to 1.1w2 --method $method --slack follow --step 0.002 --json "$method-follow.json"
	try "$method: the model's curve goes on" test "$status" = 0
done
run frf $scene -n 4 --from 0.9w2 --to 1.6w2 --method balance --step 0.05 -q --peaks --tsv peaks.tsv --json many.json --plot many.svg
try "of errors of the model the largest is told, and its branch" \
	grep -q '^hawser: warning: branch 2: folds and peaks may be off by' "$scratch/err"
try "  and in the picture" grep -q 'may be off by' many.svg
try "  and where the cable goes slack" grep -q 'ends slack' shooting.svg
cp "$scratch/err" many.err
python "what standard error says is in JSON, and --peaks is a table of the peaks" <<'END'
import json
a = json.load(open("many.json"))
said = [line.rstrip("\n")[len("hawser: warning: "):] for line in open("many.err")]
assert len(said) > 1 and a["warnings"] == said, (a["warnings"], said)
rows = [line.rstrip("\n").split("\t") for line in open("peaks.tsv") if line[0] != "#"]
peaks = a["peaks"] + [p for one in a["branches"] for p in one["peaks"]]
assert rows[0][:4] == ["probe", "component", "coordinate", "Omega_rad_s"] and len(rows) == 1 + len(peaks)
for row, peak in zip(rows[1:], peaks, strict=True):
	assert row[1] == peak["component"] and row[0] == (peak["probe"] or "") and abs(float(row[3])/peak["Omega"] - 1) < 1e-14
	assert float(row[5 if peak["component"][0] == "T" else 4]) == peak["size"]
END
python "the end is where the tension of the model's own curve is zero" <<'END'
import json, math

for method in "shooting", "balance":
	a, b = json.load(open(method + ".json")), json.load(open(method + "-follow.json"))
	event, last = a["events"][-1], a["points"][-1]
	assert a["end"] == "slack" == event["kind"] and event["located"] and 0 < event["error"] < 1e-6
	assert abs(last["tension"]["min"]) < 1e-6*last["tension"]["max"] and last["Omega"] == event["Omega"]
	assert all(p["tension"]["min"] > 0 for p in a["points"][:-1])
	# inverse interpolation in T through four points of the other curve
	T = [p["tension"]["min"] for p in b["points"]]
	k = next(k for k in range(len(T)) if T[k + 1] < 0)
	x, y = T[k - 1:k + 3], [p["Omega"] for p in b["points"][k - 1:k + 3]]
	at = sum(y[i]*math.prod(x[j]/(x[j] - x[i]) for j in range(4) if j != i) for i in range(4))
	assert abs(at/event["Omega"] - 1) < 2e-6, (at, event)
	assert b["end"] == "end of the range" and min(T) < 0 and "branches" not in b
END
python "what is left of the range has branches of its own, and each has its rows" <<'END'
import json

for method in "shooting", "balance":
	a = json.load(open(method + ".json"))
	assert len(a["branches"]) == 2 and all(one["end"] == "slack" for one in a["branches"])
	assert all(p["tension"]["min"] > -1e-6*p["tension"]["max"] for one in a["branches"] for p in one["points"])
	assert all(0 < one["model_error"]["estimated"] <= 1 for one in [a] + a["branches"])
	rows = [line.rstrip("\n").split("\t") for line in open(method + ".tsv") if line[0] != "#"]
	k = rows[0].index("branch")
	count = {str(i + 1): 0 for i in range(1 + len(a["branches"]))}
	for row in rows[1:]:
		count[row[k]] += 1
	assert list(count.values()) == [len(a["points"])] + [len(one["points"]) for one in a["branches"]], count
	covered = sorted((min(p["Omega"] for p in one["points"]), max(p["Omega"] for p in one["points"]))
	                 for one in [a] + a["branches"])
	lo, hi = a["range"]
	for gap in a["gaps"]:
		assert not any(c[0] < 0.5*(gap["from"] + gap["to"]) < c[1] for c in covered)
	assert a["gaps"] and any("no periodic motion that keeps the cable taut was found" in w for w in a["warnings"])
	picture = open(method + ".svg").read()
	assert "slack" in picture and "no branch found" in picture
END
# shellcheck disable=SC2086
refuses_like 1 '--slack' frf $scene --slack stop
# shellcheck disable=SC2086
refuses_like 1 'that curve is complete [(]slack[)]' \
	frf $scene $range --method shooting --continue shooting.json
# shellcheck disable=SC2086
run frf $scene $range --method shooting --continue shooting.json --slack follow --max-points 5 \
	--json on.json
try "it is followed on request" test "$status" = 0
done_testing

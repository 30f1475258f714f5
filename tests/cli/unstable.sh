#!/bin/sh
# hawser frf --unstable: a branch ends where more multipliers are outside the unit circle.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

range="--from 1.1w1 --to 2.1w1"
# shellcheck disable=SC2086 # words
works "all of it" frf "$chairlift" $range --json all.json -q
# shellcheck disable=SC2086
works "at most one" frf "$chairlift" $range --unstable 1 --json one.json -q
refuses_like 1 "--unstable" frf "$chairlift" --unstable 0
python "the curve is that without the limit, up to the first point with two; others cover the rest" <<'END'
import json
all_of_it, one = json.load(open("all.json")), json.load(open("one.json"))
a, b = all_of_it["points"], one["points"]
first = next(i for i, p in enumerate(a) if p["unstable"] > 1)
assert one["end"] == "unstable" and len(b) == first + 1, (one["end"], len(b), first)
for p, q in zip(a, b):
    assert p["Omega"] == q["Omega"] and p["unstable"] == q["unstable"]
branches = [one] + one["branches"]
assert len(branches) > 1 and sum(x["end"] == "unstable" for x in branches) > 1
for x in branches:
    last = x["end"] == "unstable"
    # further branches begin anywhere, perhaps at such a motion
    assert all(p["unstable"] <= 1 for p in x["points"][1:len(x["points"]) - last]), x["end"]
    assert not last or x["points"][-1]["unstable"] > 1
low, high = one["range"]
covered = sorted((min(p["Omega"] for p in x["points"]), max(p["Omega"] for p in x["points"])) for x in branches)
covered += [(g["from"], g["to"]) for g in one["gaps"]]
reach = low
for lo, hi in sorted(covered):
    assert lo <= reach*(1 + 1e-9), (lo, reach)
    reach = max(reach, hi)
assert reach >= high*(1 - 1e-9)
END

# The orbits of large amplitude grow by up to 1e9 over a period, too much for shooting in one segment.
cat >escape.json <<'END'
{"n": 1, "K": [[1]], "D": [[0.02]], "Q": [[0, 0, 0, -1.0]],
 "harmonics": [{"k": 1, "phase": "cos", "f": [0.1]}]}
END
run frf escape.json --method shooting --segments 1 --unstable 1 --from 1.5 --to 0.25 \
	--tolerance 1e-3 --json lost.json -q
try "unstable motions that can't be followed are no error" test "$status" -eq 0
try "a warning" grep -q "among unstable motions, .*; the next could not be computed: " "$scratch/err"
python "the end is lost, with the reason; another branch goes on" <<'END'
import json
lost = json.load(open("lost.json"))
assert lost["end"] == "lost" and lost["points"][-1]["unstable"] == 1, lost["end"]
assert any("could not be computed" in text for text in lost["warnings"]), lost["warnings"]
branches = lost["branches"]
assert min(p["Omega"] for p in branches[0]["points"]) < 0.3 < lost["points"][-1]["Omega"]
END
done_testing

#!/bin/sh
# Multipliers of stiff orbits: a sagging cable swings by 27 m, and the fiftieth harmonic of its motion is
# near the frequency of a longitudinal coordinate, whose phase then matters. Harmonic balance, which
# resolves the phases of such coordinates only where it must, and shooting, which resolves all,
# agree that the motion is unstable beyond the fold; without these phases branch points appear that
# do not exist, and the motion seems stable.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scene="$SRCDIR/notebooks-data/scenes/deep-sag.yaml"
rough "past the fold by harmonic balance" frf "$scene" --method balance --from 0.51 --to 0.6 \
	--tolerance 1e-7 --step 0.2 --max-points 80 --multipliers --json balance.json --quiet
python "one fold, and no branch point" <<'END'
import json

curve = json.load(open("balance.json"))
assert [e["kind"] for e in curve["events"]] == ["fold"], curve["events"]
after = curve["events"][0]["after"]
assert all(p["unstable"] == (k > after) and not p.get("undecided") for k, p in enumerate(curve["points"]))
print(curve["points"][-1]["Omega"], file=open("last", "w"))
END
last=$(cat last)
run frf "$scene" --start balance.json --at "$last" --from 0.5 --to 0.6 --method shooting --max-points 2 \
	--multipliers --json shooting.json --quiet
try "the last orbit by shooting" test "$status" = 0
python "has the same multiplier outside" <<'END'
import json

a, b = json.load(open("balance.json"))["points"][-1], json.load(open("shooting.json"))["points"][0]
largest = [max(m["log_modulus"] for m in p["multipliers"]) for p in (a, b)]
assert a["unstable"] == b["unstable"] == 1 and abs(largest[0] - largest[1]) < 5e-3 < largest[1], largest
END
# dampers at a point: the damping that counts is between the coordinates, and the smallest multiplier e^-40
python "a model that is damped between its coordinates" <<'END'
import json

n = range(8)
json.dump({"hawser_rom": 1, "n": 8, "D": [[0.8 + 0.02*(i == j) for j in n] for i in n],
           "K": [[(1 + 0.3*i)**2*(i == j) for j in n] for i in n], "Q": [], "C": [[0, 0, 0, 0, 0.1]],
           "harmonics": [{"k": 1, "phase": "cos", "omega_power": 0, "f": [0.1] + 7*[0]}]}, open("damped.json", "w"))
END
works "its response by shooting" frf damped.json --method shooting --from 0.8 --to 1.2 --max-points 8 --json out.json -q
python "has all multipliers" <<'END'
import json

gaps = [p["certificate"]["liouville"] for p in json.load(open("out.json"))["points"]]
assert len(gaps) == 8 and max(gaps) < 1e-4, gaps
END
done_testing

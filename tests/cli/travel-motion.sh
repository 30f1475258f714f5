#!/bin/sh
# Travelling cables: responses to the speed alone, braking, plans, model files.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
speed=$top/notebooks-data/scenes/b-table-5.4.yaml
brake=$top/notebooks-data/scenes/b-table-5.5.yaml
load=$top/notebooks-data/scenes/b-table-5.6.yaml
light='damping.rayleigh={mass: 0.04550184, stiffness: 0.0014065365}'

works "a response to the speed alone" frf "$speed" --from 1.05w1 --to 1.2w1 --json frf.json
works "with modes to be chosen" frf "$speed" --set model.condense=static --set model.modes=auto \
	--from 1.05w1 --to 1.2w1 --json auto.json
works "a model" rom "$speed" --json rom.json
works "which is one for other commands" frf rom.json --from 1.05w1 --to 1.2w1 --json file.json
works "braking" integrate "$brake" --until 30 --every 0.5 --json brake.json
works "a model that brakes" rom "$brake" --json ramp.json
works "of which a file tells all" integrate ramp.json --until 30 --every 0.5 --json ramped.json
refuses_like 1 'changes once and for all' frf "$brake"
refuses_like 1 'changes once and for all' frf ramp.json
refuses_like 1 'travel.braking contradicts' frf "$speed" --set travel.braking=3
works "a plan" plan "$speed" --set model.condense=static --json plan.json
# rho v. L/2 = 5*600*80.1/2 N: what no transverse mode has, against the tension of the full order
stop='--set travel.speed=60 --set travel.braking=0.1 --until 0.5'
run integrate "$brake" $stop --json stop.json
try "an abrupt stop is warned of" grep -q '^hawser: warning: slack: of the tension' "$scratch/err"
run integrate "$brake" $stop --set model.energy=exact --set model.modes=10 \
	--json full.json
works "speed that changes a little" integrate "$speed" --Omega 5 --until 1 --json little.json
# full order, exact energy: 4113 N at least, and -2715 N where the braking takes 0.7 s
cat >guy.yaml <<'END'
cable: {EA: 14 MN, rho: 3.1}
span: {d: 90 m, h: 25 m}
tension: {T0: 6 kN}
travel: {speed: 18, hold: tension, braking: 3, final: 2}
model: {modes: 8}
END
run integrate guy.yaml --until 4 --every 0.02 --json guy.json
try "a braking without slack" test ! -s "$scratch/err"
run integrate guy.yaml --set travel.braking=0.7 --until 2 --every 0.02 --json quick.json
try "a quick braking is warned of" grep -q '^hawser: warning: slack: of the tension' "$scratch/err"
python "with the waves of its sudden start" <<'END'
import json
r, quick = json.load(open("guy.json")), json.load(open("quick.json"))
assert abs((r["tension"]["min"] - r["tension_of_speeding"])/4113 - 1) < 0.06, r["tension_of_speeding"]
assert quick["tension"]["min"] - quick["tension_of_speeding"] < -700
assert abs(quick["tension_of_speeding"]/6693 - 1) < 1e-3 # rho v. L
END
python "the tension that speeding takes" <<'END'
import json
def load(name): return json.load(open(name + ".json"))
stop, full, little = load("stop"), load("full"), load("little")
assert abs(stop["tension_of_speeding"] / 120150 - 1) < 2e-3 and stop["warnings"]
assert stop["tension"]["min"] > 7e4 and full["tension"]["min"] < -1e4 # the model's own says nothing
assert "tension_of_speeding" not in full and little["warnings"] == []
assert abs(little["tension_of_speeding"] / 200.26 - 1) < 2e-3 # twice 5*0.1*5*80.1/2
END
python "what motion adds" <<'END'
import json
def load(name): return json.load(open(name + ".json"))
frf, auto, file = load("frf"), load("auto"), load("file")
peak = lambda r: max(p["amplitude"]["y_mid"] for p in r["points"])
assert abs(peak(frf)/peak(file) - 1) < 1e-9, (peak(frf), peak(file))
assert abs(peak(auto)/peak(frf) - 1) < 0.02, (peak(auto), peak(frf))
assert abs(frf["points"][0]["tension"]["max"]/file["points"][0]["tension"]["max"] - 1) < 5e-3 # a file knows three points
rom = load("rom")
n = rom["n"]
assert [(h["k"], h["phase"], h["omega_power"]) for h in rom["harmonics"]] == \
    [(1, "sin", 0), (1, "cos", 1), (2, "cos", 0)]
assert 0 < rom["shapes"]["mach2"] < 1e-5
skew = max(abs(rom["D"][j][k] + rom["D"][k][j]) for j in range(n) for k in range(j))
assert skew == 0 and any(rom["D"][j][k] for j in range(n) for k in range(j))
a, b = load("brake")["states"], load("ramped")["states"]
assert max(abs(x - y) for x, y in zip(a[-1], b[-1])) < 1e-12
assert max(abs(x) for x in a[0]) == 0 and 1e-4 < max(abs(x) for x in a[-1]) < 1e-2
decided = {d["subject"]: d["modelled"] for d in load("plan")["decisions"]}
assert decided["gyroscopic terms"] and decided["harmonics of the speed"], decided
END

# Two solutions at one frequency, each found again in time.
works "coexisting solutions" frf "$load" --set "$light" --from 0.9w1 --to 1.4w1 --json two.json
python "their states" <<'END'
import json
points, Omega = json.load(open("two.json"))["points"], 6.4
found = [a for a, b in zip(points, points[1:]) if (a["Omega"] - Omega)*(b["Omega"] - Omega) <= 0]
assert [p["stable"] for p in found] == [True, False, True]
json.dump({"state": found[0]["state"]}, open("large.json", "w"))
json.dump([p["amplitude"]["y_mid"] for p in found], open("amplitudes.json", "w"))
END
works "from the large one" integrate "$load" --set "$light" --Omega 6.4 --until 120T --every 0.05T \
	--initial large.json --json a.json
works "from rest" integrate "$load" --set "$light" --Omega 6.4 --until 120T --every 0.05T --json b.json
python "both stay" <<'END'
import json
want = json.load(open("amplitudes.json"))
def settled(name):
    probe = json.load(open(name))["probes"]["mid"]
    return max(abs(y) for y in probe["y"][-41:])
assert abs(settled("a.json")/want[0] - 1) < 0.03 and abs(settled("b.json")/want[2] - 1) < 0.06
assert settled("a.json") > 8*settled("b.json")
END
done_testing

#!/bin/sh
# Scenes with a list of loads: messages, the model, responses, plan, maps.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >s.yaml <<'EOF'
cable: {EA: 20 MN, rho: 8 kg/m}
span: {d: 100 m, h: -20 m}
tension: {sag: 6 m}
damping: {ratio: 0.02}
model: {modes: 3}
loads:
  - {per_length: [0, 1 N/m, 0], from: 20 %, to: 40 %, harmonic: 2, phase: 90 degree}
  - {force: [0, 0, 20 N], at: 30 m, name: hand}
  - {per_length: [0, 0.5 N/m, 0], wave: 40 m}
EOF
refuses 1 "--set loads=3: loads must be a list of mappings, such as [{per_length: [0, 1 N/m, 0], from: 20 %, to: 40 %}]" \
	statics s.yaml --set loads=3
refuses_like 1 "loads\\[0\\] has both per_length and force" \
	statics s.yaml --set 'loads=[{per_length: [1, 0, 0], force: [1, 0, 0], at: 0.2}]'
refuses_like 1 "loads\\[0\\] has no effect: give it a per_length" statics s.yaml --set 'loads=[{harmonic: 2}]'
refuses_like 1 "loads\\[0\\] is a force without a point" statics s.yaml --set 'loads=[{force: [1, 0, 0]}]'
refuses_like 1 "loads\\[1\\]: from, to and wave are of a per_length" statics s.yaml --set loads.hand.wave=3
refuses_like 1 "loads\\[0\\]: at is the point of a force" statics s.yaml --set loads.0.at=0.3
refuses_like 1 "loads\\[0\\] acts from 0.5 to 0.4: give the end nearer to A first" \
	statics s.yaml --set loads.0.from=0.5
refuses_like 1 "loads.0 acts from 60 m to .* m: give the end" rom s.yaml --set 'loads.0.from=60 m'
refuses_like 1 "loads.1.at: 200 m is beyond the end of the cable" rom s.yaml --set 'loads.hand.at=200 m'
refuses_like 1 "loads.2.wave: 0.5 m is less than 1/200 of the cable" rom s.yaml --set loads.2.wave=0.5
refuses_like 1 "loads.0..harmonic: 21 is not a whole number from 1 to 20" statics s.yaml --set loads.0.harmonic=21
refuses_like 1 "loads.0.harmonic is 2: modes are weighed with loads of the frequency Omega only" \
	frf s.yaml --set model.modes=auto --from 1 --to 1.2

works "model" rom s.yaml --json rom.json -q
works "response" frf rom.json --from 2.6 --to 2.4 --max-points 5 --json frf.json -q
works "in time" integrate rom.json --Omega 2.4 --until 1 --json run.json -q
run plan s.yaml --limit 0.1 --fidelities "raw 1" --json plan.json -q
try "plan" test "$status" -eq 0
try "says what it does not foresee" grep -q "harmonic is 2: the plan foresees resonances of loads of the frequency" \
	"$scratch/err"
if python3 -S -c '' 2>/dev/null; then
	cat >check.py <<'EOF'
import json
r = json.load(open("rom.json"))
assert sorted((h["k"], h["phase"]) for h in r["harmonics"][:3]) == [(1, "cos"), (1, "sin"), (2, "sin")]
echo = r["scene"]["loads"]
assert echo[1] == {"force": [0, 0, 20], "at_m": 30, "frame": "global", "harmonic": 1, "phase": 0, "name": "hand"}
assert echo[2]["wave"] == 40 and echo[0]["from"] == 0.2
EOF
	try "the model has the harmonics of the loads" python3 -S check.py
else
	skip "python3 is not there"
fi
done_testing

#!/bin/sh
# hawser integrate of rods with a winch: text, JSON, picture, states, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >winch.yaml <<'END'
kind: rod
rod:
  - {length: 4 m, EA: 10 kN, GA: 4 kN, EI: 0.2 N.m^2, GJ: 0.2 N.m^2, rho: 0.5 kg/m, inertia: [2e-5 kg.m, 1e-5 kg.m, 1e-5 kg.m], elements: 6}
  - {length: 0.3 m, EA: 10 kN, GA: 4 kN, EI: 20 N.m^2, GJ: 20 N.m^2, rho: 5 kg/m, inertia: [2e-3 kg.m, 1e-3 kg.m, 1e-3 kg.m], elements: 1}
start: {hold: hinged, tangent: [0, -1, 0], normal: [1, 0, 0], winch: {times: [0 s, 0.1 s, 0.3 s], speeds: [0.5 m/s, 0.8 m/s, 0.6 m/s]}}
damping: {alpha: 0.2 s^-1}
loads:
  - {at: end, force: [2 N, 0 N, 1 N]}
END
run="integrate winch.yaml --until 0.4 --every 0.1 --step 0.01 -q"
works "a rod that is paid out" $run --json all.json --tsv all.tsv --plot all.svg --probe start,2,end
works "its first half" integrate winch.yaml --until 0.2 --every 0.1 --step 0.01 -q --state half --no-error
works "and its second" $run --initial half --json rest.json
python "JSON, table, states" <<'END'
import json
r, s = json.load(open("all.json")), json.load(open("rest.json"))
l = r["length"]
assert abs(l[1] - 4.365) < 1e-12 and abs(l[3] - 4.505) < 1e-12 and abs(l[4] - 4.565) < 1e-12, l
assert r["probes"]["2"]["s"] == 2 and r["step_error"] < 1e-3
for key in ("kinetic", "strain", "work", "support", "damped", "winch"):
    assert s["energy"][key] == r["energy"][key][2:], key
assert s["length"] == l[2:]
e = r["energy"]
total = [e["kinetic"][i] + e["strain"][i] + e["height"][i] - e["work"][i] - e["support"][i] - e["winch"][i] + e["damped"][i] + e["lost"][i] for i in range(5)]
assert max(total) - min(total) < 1e-9 and e["closure"] < 1e-3, (total, e["closure"])
assert e["winch"][4] < -1, "it brakes"
# at first as the equilibrium lengthens: the end goes along the rope, at the speed of the winch
v = r["probes"]["end"]["v"][0]
assert abs(sum(c*c for c in v)**0.5 - 0.5) < 5e-3 and v[1] < -0.49, v
lines = [l for l in open("all.tsv") if not l.startswith("#")]
assert lines[0].split()[-2:] == ["winch_J", "length_m"], lines[0]
assert "length" in open("all.svg").read()
END

refused() { # what, status, words, sed
	sed "$4" winch.yaml >bad.yaml
	denies "$1" "$2" "$3" integrate bad.yaml -q --until 0.4 --step 0.01 --no-error
}
refused "a winch at a free start" 1 "start.winch: the start is free" 's/hold: hinged/hold: free/'
refused "two ways to give the speed" 1 "bad.yaml:5:.*start.winch.times: the speed is given by start.winch.speed" 's/times:/speed: 1 m\/s, times:/'
refused "no speeds" 1 "start.winch: give speed, or times with either" 's/, speeds: .*\]}}/}}/'
refused "too few speeds" 1 "start.winch.speeds: 2 numbers for 3 times" 's/, 0.6 m.s\]/]/'
refused "one time" 1 "start.winch.times must be a list of at least two" 's/times: .*, speeds/times: 3 s, speeds/'
refused "times that fall" 1 "0.1 s comes after 0.2 s: times must grow" 's/\[0 s, 0.1/[0.2 s, 0.1/'
refused "a misspelt key" 1 "bad.yaml:5:.*start.winch.*length" 's/speeds:/length:/'
refused "another unit" 1 "bad.yaml:5:.*start.winch.speeds" 's/0.8 m.s/0.8 m/'
refused "a length that is not the rod's" 1 "winch.lengths: at 0 s it is 3 m, and the first segment has 4 m" 's/speeds: .*\]}}/lengths: [3 m, 3 m, 4 m]}}/'
refused "hauled in too far" 1 "at 0.[0-9]* s the winch leaves 0.[0-9]* m of the first segment, less than 0.2 m" 's/times.*\]}}/speed: -12 m\/s}}/'
refused "a load within the segment" 1 "loads.i0: 1 m is within the first segment, of 4 m" 's/at: end/at: 1 m/'
refused "faster than waves" 2 "pays out or hauls in 80 m/s, faster than waves run there" 's/times.*\]}}/speed: 80 m\/s}}/'
sed 's/0.8 m/0.81 m/' winch.yaml >bad.yaml
denies "a state of another winch" 1 "is a state with .* m of the first segment at 0.2 s" integrate bad.yaml -q --until 0.4 --every 0.1 --step 0.01 --initial half
done_testing

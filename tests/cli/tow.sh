#!/bin/sh
# hawser tow: rows, JSON, a picture, VTK, standard input, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scene=$SRCDIR/notebooks-data/scenes/tow-u-turn.yaml
works "with a mesh error" tow "$scene" --until 4 --every 0.5 --set cable.segments.0.elements=6 --check \
	--json turn.json --plot turn.svg --vtk turn -q
python "JSON" <<'END'
import json, math
turn = json.load(open("turn.json"))
assert len(turn["times"]) == len(turn["tilt"]) == len(turn["tension_top"]) == len(turn["body"]["position"]) == 9
assert turn["times"][-1] == 4 and len(turn["energy"]["kinetic"]) == 9 and len(turn["range"]) == 6
assert abs(turn["closure"]) < 1e-5 and 0 < turn["step_error"] < 1e-2 and 0 < turn["mesh_error"] < 1e-3
assert turn["raised"] == 6 # EI is 1.96 of the 13.9 N m^2 of 500 N and elements of 10 m/6
r = turn["range"][0]
assert r["least"] <= r["mean"] <= r["most"] and abs(turn["tension_top"][0] - 499.36) < 0.01
q = turn["body"]["attitude"][-1]
assert abs(sum(v*v for v in q) - 1) < 1e-12
axis_y = -(q[0]**2 - q[1]**2 + q[2]**2 - q[3]**2)
assert abs(math.acos(-axis_y) - turn["tilt"][-1]) < 1e-6
END
try "the ranges in the picture" grep -q 'seen from above' turn.svg
try "VTK" test -s turn-00008.vtk -a -s turn.vtk.series
same() {
	"$HAWSER" tow - --until 1 -q <"$scene" | grep -v "^# [sm]" >stdin.tsv
	"$HAWSER" tow "$scene" --until 1 -q | grep -v "^# [sm]" | cmp - stdin.tsv
}
try "standard input" same

# a run in two parts, with vortices: the rows are those of one run
sed 's/elements: 20,/elements: 6, shedding: {lift: 0.6, strouhal: 0.22},/' "$scene" >shed.yaml
parts() {
	few="tow shed.yaml --every 0.1 -q"
	"$HAWSER" $few --until 1 | grep -v "^#" >whole.tsv &&
		"$HAWSER" $few --until 0.5 --state half | grep -v "^#" >halves.tsv &&
		"$HAWSER" $few --until 1 --initial half | grep -v "^#" | sed 1,2d >>halves.tsv && cmp whole.tsv halves.tsv
}
try "in two parts as in one, bit by bit" parts
refuses 1 "half is the state at 0.5 s, and the motion is to end at 0.5 s: --until counts as the path does" \
	tow shed.yaml --until 0.5 --initial half
refuses 1 "half is no state of this cable with 20 elements: give a file that a run of this scene has written with --state" \
	tow "$scene" --until 1 --initial half
refuses 1 "--check does not go with --initial: leave out one of them" \
	tow "$scene" --until 1 --initial half --check

works "animation" tow shed.yaml --every "250 ms" --until 1 -q --animate turn.gif --frames 3
try "  three frames" python3 -S -c 'import sys; d = open("turn.gif", "rb").read()
sys.exit(d[:6] != b"GIF89a" or d.count(bytes([0x21, 0xf9, 4])) != 3)'
refuses 1 "--animate turn.png: an animation is a GIF, whose name must end in .gif" \
	tow shed.yaml --until 1 --animate turn.png

# bad MESSAGE SCENE [OPTION ...]: a scene given as text
bad() {
	message=$1
	printf '%s\n' "$2" >bad.yaml
	shift 2
	refuses 1 "$message" tow bad.yaml "$@"
}
cable='cable: {segments: [{length: 9 m, rho: 1 kg/m, diameter: 1 cm, EA: 1 MN, EI: 2 N m^2, drag: {normal: 1.2}}]}'
bad 'a path of constant speed has no end: give --until, the time (s) at which the motion ends' "tow: {speed: 3}
$cable
air: {density: 1.2}"
bad 'cable.segments[0].EA is missing: a motion needs the axial stiffness EA (N) and the bending stiffness EI (N m^2); of a round cable of modulus E and diameter d they are E pi d^2/4 and E pi d^4/64' 'tow: {speed: 3}
cable: {segments: [{length: 9 m, rho: 1 kg/m, EI: 2}]}' --until 1
bad 'cable.segments[0].rho is 0: a motion needs a mass per length (kg/m)' 'tow: {speed: 3}
cable: {segments: [{length: 9 m, rho: 0, EA: 1 MN, EI: 2}]}
body: {mass: 3}' --until 1
bad 'the scene has no cable: add, for example, cable: {segments: [{length: 14 m, rho: 58 g/m, diameter: 8 mm, EA: 200 kN, EI: 0.8 N m^2, drag: {normal: 1.2}}]}' 'tow: {speed: 3}' --until 1
bad "--until 3 s is after the path's end at 1 s" 'tow: {waypoints: [[0, 0, 0, 0], [1, 1, 0, 0]], minimise: none}' --until 3
bad "--until 1 s is not after the path's beginning at 2 s" 'tow: {waypoints: [[2, 0, 0, 0], [3, 1, 0, 0]], minimise: none}' --until 1
bad '--every 1e-09 s makes more than 1000000 samples: give a longer one' "tow: {speed: 3}
$cable
air: {density: 1.2}" --until 1 --every 1e-9
bad '--rho-inf 2: must be at most 1' "tow: {speed: 3}" --rho-inf 2
bad 'bad.yaml:4:1: the body and the cable below the top of cable.segments[0] weigh 981088 N, which stretches it by 0.981 of its length (EA 1e+06 N): give a larger EA, or a smaller mass' "tow: {speed: 3}
$cable
air: {density: 1.2}
body: {mass: 100000}"
bad 'bad.yaml:2:42: cable.segments[0].shedding needs the diameter, which is not given' 'tow: {speed: 3}
cable: {segments: [{length: 9 m, rho: 1, shedding: {lift: 0.6, strouhal: 0.22}}]}'
bad '--step 0.01 s is too long for vortex shedding of 220 Hz at 0 s, which it would show at a wrong frequency or not at all: give at most 0.000227 s (20 steps a period), or leave --step out' "tow: {speed: 10}
cable: {segments: [{length: 9 m, rho: 1, EA: 1 MN, EI: 2, diameter: 1 cm, shedding: {lift: 0.6, strouhal: 0.22}}]}
air: {density: 1.2}
body: {mass: 900}" --until 1 --step 0.01 --every 0.01 --set tow.speed=10
printf '0 1 0 0\n1 2 0 0\n0.5 1 0 0\n' >wind.txt
bad 'wind.txt:3: t is 0.5 s, but that of the waypoint before it is 1 s: times must increase' "tow: {speed: 3}
$cable
air: {density: 1.2,  file: wind.txt}"
bad 'bad.yaml:3:19: air.file, a wind, in air of density 0 has no effect: give the density, such as 1.2 kg/m^3, or no wind' "tow: {speed: 3}
$cable
air: {density: 0, file: wind.txt}"
bad 'bad.yaml:3:35: air has wind and file: remove one of them' "tow: {speed: 3}
$cable
air: {density: 1, file: wind.txt, wind: [1, 0, 0]}"

# a cable that is paid out: at the end it is as a longer one
cat >winch.yaml <<'END'
tow: {speed: 13 m/s}
cable: {segments: [{length: 4 m, rho: 0.3 kg/m, diameter: 1 cm, EA: 300 kN, EI: 0.5 N m^2, drag: {normal: 30}, elements: 6}]}
air: {density: 1.2}
body: {mass: 20 kg, CdA: 1 m^2}
winch: {times: [0 s, 2 s, 3 s], speeds: [0 m/s, 1 m/s, 0 m/s]}
END
works "paid out" tow winch.yaml --until 30 --every 10 --step 0.05 --json out.json -q
works "as long" tow steady winch.yaml --set cable.segments.0.length=5.5 --json steady.json -q
python "the longer cable" <<'END'
import json
r, s = json.load(open("out.json")), json.load(open("steady.json"))
assert all(abs(a - b) < 1e-12 for a, b in zip(r["length"], [4, 5.5, 5.5, 5.5])) and r["energy"]["winch"][-1] < -100 and abs(r["closure"]) < 1e-5, r
# ranges are over the time, and so are their places: the length is 5.5 m but for the first 3 of 30 s
assert 5.4 < 12/11*r["range"][5]["s"] < 5.43, r["range"][5]
x = [a - b for a, b in zip(r["body"]["position"][-1], r["top"][-1])]
assert all(abs(a - b) < 0.02 for a, b in zip(x, s["body"]["position"])), (x, s["body"]["position"])
END
refuses 1 "the winch begins with 1 m/s at 0 s, and the motion with a steady state: give winch.rise, or speeds from 0" \
	tow winch.yaml --until 1 --set "winch.speeds=[1 m/s, 1 m/s, 0 m/s]"
done_testing

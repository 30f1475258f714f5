#!/bin/sh
# hawser trajectory: text, JSON, tables that are read again, pictures, refusals with their places.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scenes=$SRCDIR/notebooks-data/scenes
turn=$scenes/d-section-5.2.5.yaml

works "D 5.2.5" trajectory "$turn" --points 201 --json turn.json --tsv turn.tsv --plot turn.svg -q
sed '/^# scene:/d; s/error [0-9.]*e-16/error 0/' turn.tsv | head -n 4 >text
cat >want <<'END'
# hawser 0.1.0 trajectory
# method: polynomials by one banded system
# 4 waypoints from t = 0 s to 100 s; minimised: snap
# integral of the squared snap = 0.001819070118 m^2/s^7; derivatives are continuous up to order 6; estimated relative error 0
END
try "the first lines, exactly" diff text want
works "D 5.2.4" trajectory "$scenes/d-section-5.2.4.yaml" --points 3 --json halt.json -q
works "D 5.2.6" trajectory "$scenes/d-section-5.2.6.yaml" --points 11 --json round.json -q
works "D 5.2.2" trajectory "$scenes/d-section-5.2.2.yaml" --to 40 --points 3 --json forward.json -q
# The table is a path itself: its waypoints and, between them, nearly the same path.
printf 'tow: {file: turn.tsv, ends: [velocity, acceleration, jerk]}\n' >again.yaml
works "a table as a path" trajectory again.yaml --points 333 --json again.json -q
works "the same of the scene" trajectory "$turn" --points 333 --json same.json -q
printf 'tow: {orbit: {radius: 50 m, speed: -36 km/h, centre: [1, 2, 3]}}\n' >orbit.yaml
works "an orbit" trajectory orbit.yaml --points 5 --json orbit.json -q
python "JSON" <<'END'
import json
turn, halt, round_, forward = (json.load(open(f + ".json")) for f in ("turn", "halt", "round", "forward"))
at = lambda r, t: min(r["points"], key=lambda p: abs(p["t"] - t))
assert turn["kind"] == "waypoints" and turn["minimise"] == "snap" and turn["smooth"] == 6 and turn["error"] < 1e-14
assert abs(at(turn, 30)["velocity"][0] - 7.4162) < 5e-5 and [w["t"] for w in turn["waypoints"]] == [0, 30, 70, 100]
assert abs(at(halt, 50)["position"][0] - 192.930) < 5e-4 and abs(at(halt, 50)["velocity"][2] - 7.3315) < 5e-5
assert abs(at(round_, 30)["velocity"][0] - 6.3538) < 5e-5 and abs(at(round_, 30)["velocity"][2] + 1.8876) < 5e-5
assert abs(forward["largest"]["acceleration"] - 1.617) < 5e-4 and forward["kind"] == "straight" and "minimise" not in forward
assert abs(forward["points"][2]["position"][0] - 8*(40 - 10.157)) < 4e-3
again, same = json.load(open("again.json")), json.load(open("same.json"))
for p, q in zip(again["points"], same["points"]):
    assert max(abs(a - b) for a, b in zip(p["position"], q["position"])) < 1e-6
orbit = json.load(open("orbit.json"))
assert orbit["points"][0]["position"] == [51, 2, 3] and abs(orbit["points"][1]["position"][2] + 47) < 1e-9
assert abs(orbit["largest"]["acceleration"] - 2) < 1e-12 and abs(orbit["points"][-1]["t"] - 31.41592653589793) < 1e-12
END
try "a picture" grep -q 'seen from above' turn.svg

# --- refusals ---

# bad MESSAGE SCENE [ARGUMENTS]: a scene given as text
bad() {
	printf '%s\n' "$2" >bad.yaml
	message=$1
	shift 2
	refuses 1 "$message" trajectory bad.yaml "$@"
}
way='tow: {waypoints: [[0 s, 0, 0, 0], [1 s, 1, 0, 0]'
bad 'bad.yaml:1:51: tow: the time of waypoint 2 is 1 s, but the waypoint before it is at 1 s: times must increase' \
	"$way, [1 s, 2, 0, 0]]}"
bad 'bad.yaml:1:7: tow: 2 waypoints with 0 given derivatives do not determine a path of least snap, which needs 4 of both: give more waypoints, or ends such as [velocity, acceleration]' "$way]}"
bad 'bad.yaml:1:52: tow.waypoints[2]: "2 m" has a wrong unit "m", not convertible to s: give a number in s, or with a unit that converts to s' "$way, [2 m, 2, 0, 0]]}"
bad 'bad.yaml:1:60: tow.waypoints[2]: ".nan" is not a number (NaN): give a number in m, or with a unit that converts to m' "$way, [2 s, 2, .nan, 0]]}"
bad 'bad.yaml:1:51: tow.waypoints[2] must be [t, x, y, z] in s and m, or a mapping with t, at and derivatives, such as {t: 30 s, at: [100 m, 0, 0], velocity: [6 m/s, 0, 0]}' "$way, [2 s, 2, 0]]}"
bad 'bad.yaml:1:59: tow.ends: "velocty" must be velocity, acceleration, jerk or snap' "$way], ends: [velocty]}"
bad 'bad.yaml:1:7: unknown key tow.waypionts: did you mean waypoints? tow takes waypoints, file, speed, orbit, minimise, ends, start, ramp, law, hinge' 'tow: {waypionts: []}'
bad 'bad.yaml:1:21: tow has speed and orbit: give one of waypoints, file, speed and orbit' \
	'tow: {speed: 3 m/s, orbit: {radius: 1, speed: 2}}'
bad 'bad.yaml:1:19: tow.minimise is of waypoints and files, and the path is given by speed: remove one of them' \
	'tow: {speed: 3,   minimise: jerk}'
bad 'bad.yaml:1:23: tow.orbit.radius: "-3 m" is out of range: it must be > 0, in m' 'tow: {orbit: {radius: -3 m, speed: 2}}'
bad 'the range of time is from 3 s to 2 s: --from must be less than --to' "tow: {speed: 3}" --from 3 --to 2
bad 'the path is defined from 0 to inf s, and not at -1 s' "tow: {speed: 3}" --from -1 --to 2
printf '0 0 0 0\n1 1 0 0\n# a comment\n1 2 0 0\n' >path.txt
bad 'path.txt:4: t is 1 s, but that of the waypoint before it is 1 s: times must increase' 'tow: {file: path.txt}'
printf '0 0 0 0\n1 1 zero 0\n' >path.txt
bad 'path.txt:2: y_m is "zero", but must be a finite number' 'tow: {file: path.txt}'
printf 't_s x_m z_m\n0 0 0\n' >path.txt
bad 'path.txt:1: no column y_m: a line of a path is t x y z in s and m, or the columns have the names t_s, x_m, y_m and z_m' 'tow: {file: path.txt}'
bad 'cannot open none.txt: No such file or directory' 'tow: {file: none.txt}'
printf '%s, [2 s, 3, 0, 0]], minimise: none}\n' "$way" >rough.yaml
run trajectory rough.yaml --points 2
try "a velocity that jumps is a warning" grep -q 'warning: the velocity of the path jumps' "$scratch/err"
done_testing

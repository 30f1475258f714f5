#!/bin/sh
# hawser tow steady: text, JSON, pictures, refusals with their places.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scenes=$SRCDIR/notebooks-data/scenes
works "D 5.3" tow steady "$scenes/d-section-5.3.yaml" --json ring.json --plot ring.svg -q
works "D 5.2.3" tow steady "$scenes/d-section-5.2.3.yaml" --json small.json -q
works "EI that the mesh does not show" tow steady "$scenes/d-section-5.2.3.yaml" --set "cable.segments.0.EI=1e-7 N m^2" -q
try "is told" grep -q '^# EI is below 1 % of T h^2 in 400 of 400 elements' "$scratch/out"
works "an orbit" tow steady "$scenes/tow-orbit.yaml" --json orbit.json --tsv orbit.tsv --plot orbit.svg -q
python "JSON" <<'END'
import json, math
ring, small, orbit = (json.load(open(f + ".json")) for f in ("ring", "small", "orbit"))
assert abs(ring["tilt"] + 0.5129) < 5e-5 and abs(ring["tension_top"] - 5752) < 1
assert 0 < ring["ring_error"] < 1e-3 and ring["mesh_error"] < 30*ring["ring_error"] and "ring_error" not in orbit
assert abs(small["tilt"] + 0.07164) < 5e-6 and small["bent"] and not ring["bent"] and ring["residual"] < 1e-12
q, a = ring["body"]["attitude"], ring["tilt"]
assert abs(q[0] - math.cos(a/2)) < 1e-12 and abs(q[3] - math.sin(a/2)) < 1e-12
p, e = ring["body"]["position"], ring["end"]
assert abs(math.dist(p, e) - 16) < 1e-9 and len(ring["shape"]) == 101 and ring["shape"][0] == [0, 0, 0, 0]
assert abs(orbit["depth"] - 76.854) < 5e-4 and abs(orbit["radius"] - 131.738) < 5e-4
assert abs(math.degrees(orbit["lag"]) - 27.629) < 5e-4 and orbit["others"] == []
s, x, y, z = orbit["shape"][-1]
assert s == 100 and abs(math.hypot(x, z) - orbit["radius"]) < 1e-9 and abs(y + orbit["depth"]) < 1e-9
END
try "the orbit's text" grep -q '^# orbit: radius of the free end = 131.738' orbit.tsv
try "pictures" grep -q 'seen from above' ring.svg orbit.svg

# bad MESSAGE SCENE: a scene given as text
bad() {
	printf '%s\n' "$2" >bad.yaml
	refuses 1 "$1" tow steady bad.yaml
}
cable='cable: {segments: [{length: 9 m, rho: 1 kg/m, diameter: 1 cm, drag: {normal: 1.2}}]}'
bad 'bad.yaml:1:1: cable or body has drag, but the section air is missing: give air: {density: 1.2 kg/m^3}' \
	"tow: {speed: 3}
$cable"
bad 'bad.yaml:3:19: air.wind in air of density 0 has no effect: give the density, such as 1.2 kg/m^3, or no wind' \
	"tow: {speed: 3}
$cable
air: {density: 0, wind: [3, 0, 0]}"
bad 'bad.yaml:2:47: unknown key cable.segments[0].diametre: did you mean diameter? cable.segments[0] takes length, EA, EI, GJ, GA, rho, diameter, elements, drag, added_mass, shedding' \
	'tow: {speed: 3}
cable: {segments: [{length: 9 m, rho: 1 kg/m, diametre: 1 cm}]}'
bad 'bad.yaml:2:39: cable.segments[0].rho: "1 kg" has a wrong unit "kg", not convertible to kg/m: give a number in kg/m, or with a unit that converts to kg/m' \
	'tow: {speed: 3}
cable: {segments: [{length: 9 m, rho: 1 kg, diameter: 1 cm}]}'
bad 'an orbit in a horizontal wind has no steady state: the flow changes along the circle; leave air.wind out, or give a vertical one' \
	"tow: {orbit: {radius: 9, speed: 3}}
$cable
air: {density: 1.2, wind: [3, 0, 0]}"
bad 'a path through waypoints has no steady state: give tow.speed or tow.orbit' \
	'tow: {waypoints: [[0, 0, 0, 0], [1, 1, 0, 0]], minimise: none}'
bad 'bad.yaml:4:31: body.ring.tube, the radius of the tube, must be less than the radius of the ring' \
	"tow: {speed: 3}
$cable
air: {density: 1.2}
body:      {                  ring: {radius: 1, tube: 2, mass: 3, offset: 1}}"
printf 'tow: {speed: 3}\n' >bad.yaml
refuses 1 'bad.yaml is a towed body, which hawser statics does not take; these commands do: trajectory, tow, tow steady' statics bad.yaml
# Newton's method from the string fails: GJ and EI grow
cat >light.yaml <<'END'
tow: {orbit: {radius: 7.2389 m, speed: 7.7826 m/s}}
cable: {segments: [{length: 185.33 m, rho: 1.6177 kg/m, diameter: 18.464 mm, EA: 9.0059 MN, EI: 191.88 N m^2,
	elements: 50, drag: {normal: 1.2, tangential: 0.02}}]}
air: {density: 1.2}
body: {ring: {radius: 0.3257 m, tube: 3.183 cm, mass: 1.393 kg, offset: 0.3327 m, drag: {normal: 1.2}}}
END
works "a light ring on a long stiff cable in a tight orbit" tow steady light.yaml -q
# elements that are longer than the orbit is wide; none that is bent is found: what to do
long='rho: 0.52251 kg/m, diameter: 0.020342 m, EA: 2.0868e+06 N, elements: 20, drag: {normal: 1.2, tangential: 0.02}'
tight="tow: {orbit: {radius: 5.4152 m, speed: 16.862 m/s}}
air: {density: 1.2}
body: {joint: free, ring: {radius: 1.565 m, tube: 0.006892 m, mass: 19.13 kg, offset: 0.3899 m, drag: {normal: 1.2}}}"
printf '%s\n' "$tight" "cable: {segments: [{length: 291.92 m, $long}]}" >string.yaml
refuses_like 3 '20 elements are too few: halving them moves a point by' tow steady string.yaml
printf '%s\n' "$tight" "cable: {segments: [{length: 291.92 m, EI: 54, $long}]}" >bent.yaml
refuses_like 3 'as a string it turns by up to 0.96 rad in an element; give cable.segments.elements more, for example 637, or' \
	tow steady bent.yaml
printf '%s\n' "tow: {orbit: {radius: 5.1328 m, speed: 47.685 m/s}}" "air: {density: 1.2}" \
	"cable: {segments: [{length: 174.79 m, EI: 20, $long}]}" >coil.yaml
refuses_like 3 'as a string it is a coil that turns by' tow steady coil.yaml
done_testing

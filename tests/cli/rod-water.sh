#!/bin/sh
# Rods and towed bodies in water: statics and motion, columns, units, states, standard input, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >rod.yaml <<'END'
kind: rod
rod: {length: 62 m, rho: 18 kg/m, EA: 20 MN, GA: 8 MN, EI: 2 kN m^2, GJ: 2 kN m^2, inertia: [2e-2 kg m, 1e-2 kg m, 1e-2 kg m],
      elements: 12, diameter: 0.12 m, drag: {normal: 1.2, tangential: 0.02}, added_mass: {normal: 1}}
start: {at: [0 m, -30 m, 0 m], tangent: [1, 0, 0], hold: hinged}
end: {at: [50 m, 2 m, 0 m], hold: hinged}
water: {density: 1025 kg/m^3, depth: 60 m, current: {table: [[-60 m, 0.1 m/s, 0, 0], [0 m, 0.5 m/s, 0, 0.3 m/s]]},
        waves: {height: 3 m, period: 8 s, heading: 0.4 rad}, ramp: 4 s}
END
works "what the scene has" check rod.yaml
try "its water" grep -q 'water: below y = 0 m, with a current, with waves' "$scratch/out"
works "a rod in a current" statics rod.yaml --json st.json --tsv st.tsv -q
run="integrate rod.yaml --until 4 --every 0.5 -q"
works "in waves" $run --json all.json --tsv all.tsv --animate all.gif --frames 4 --no-error
works "the first half" integrate rod.yaml --until 2 --every 0.5 -q --state half --no-error
works "and the second" $run --initial half --json rest.json
"$HAWSER" integrate - --until 4 --every 0.5 -q --no-error --json in.json <rod.yaml >/dev/null
try "from standard input" test $? = 0
python "statics, motion, states" <<'END'
import json
st, r, s, i = (json.load(open(n + ".json")) for n in ("st", "all", "rest", "in"))
assert 59 < st["wet"] < 60 and st["stable"] is None, st["wet"]
lines = [l for l in open("st.tsv") if not l.startswith("#")]
assert any(l.startswith("# wet = ") for l in open("st.tsv")) and len(lines) == 14
# the start bears what it bears at rest
assert all(abs(a - b) < 1e-5 for a, b in zip(st["start"]["force"], r["start"]["force"][0]))
e = r["energy"]
table = [l.rstrip("\n").split("\t") for l in open("all.tsv") if not l.startswith("#")]
at = table[0].index("water_J")
assert e["water"] == [float(row[at]) for row in table[1:]] and e["water"][0] == 0
total = [sum(e[k][j] for k in ("kinetic", "strain", "height", "lost")) - e["work"][j] - e["support"][j] - e["water"][j]
         for j in range(9)]
assert max(total) - min(total) < 1e-8, total
assert e["closure"] < 1e-3 and max(map(abs, e["water"])) > 1
for key in ("kinetic", "strain", "water", "support"): # bit by bit
    assert s["energy"][key] == e[key][4:], (key, s["energy"][key], e[key])
assert i["energy"] == e
END

refused() { # what, words, sed
	sed "$3" rod.yaml >bad.yaml
	denies "$1" 1 "$2" integrate bad.yaml --until 1 -q
	denies "$1" 1 "$2" statics bad.yaml -q
}
refused "waves without a depth" 'bad.yaml:7:.*waves need water.depth' 's/depth: 60 m, //'
refused "no diameter" 'bad.yaml:2:.*rod has no diameter, which its buoyancy and its drag' 's/diameter: 0.12 m, //'
refused "no water" 'rod has drag, and the scene has no water' '/^water/,$d'
refused "a start below the bed" 'bad.yaml:4:.*start.at is at y = -61 m, below the bed' 's/-30 m/-61 m/'
refused "an end below the bed" 'bad.yaml:5:.*end.at is at y = -62 m, below the bed' 's/50 m, 2 m/50 m, -62 m/'
refused "a winch in water" 'start.winch in water: the added mass' '/^start/s/hinged}/hinged, winch: {speed: 0.1 m\/s}}/'
refused "waves that break" 'bad.yaml:7:.*waves of 8 s break at a height' 's/height: 3 m/height: 15 m/'
refused "no density" 'water.density is missing' 's/density: 1025 kg.m^3, //'
refused "a current of a word" 'water.current' 's/current: {table.*/current: fast,/'

cat >tow.yaml <<'END'
tow: {speed: 1.5 m/s, start: [0 m, -2 m, 0 m]}
cable:
  segments:
    - {length: 40 m, rho: 1.2 kg/m, EA: 200 kN, EI: 20 N m^2, elements: 10, diameter: 0.02 m, drag: {normal: 1.2, tangential: 0.015}, added_mass: {normal: 1}}
body: {mass: 300 kg, volume: 0.2 m^3, CdA: 0.3 m^2, added_mass: 0.5, inertia: 1 kg m^2}
water: {density: 1025 kg/m^3, depth: 100 m, current: [0.2 m/s, 0, 0.1 m/s], waves: {height: 3 m, period: 7 s}, ramp: 3 s}
END
works "a towed body" check tow.yaml
try "  and its water" grep -q 'water: below y = 0 m, with a current, with waves' "$scratch/out"
works "its steady state" tow steady tow.yaml --json steady.json -q
run="tow tow.yaml --until 4 --every 0.5 -q"
works "its motion in waves" $run --json all.json --animate tow.gif --frames 4
works "its first half" tow tow.yaml --until 2 --every 0.5 -q --state half
works "its second half" $run --initial half --json rest.json
works "without waves" $run --set water.waves= --json calm.json
python "the motion begins in the steady state, goes on bit by bit, and waves move it" <<'END'
import json
steady, r, s, calm = (json.load(open(n + ".json")) for n in ("steady", "all", "rest", "calm"))
b = r["body"]["position"]
assert all(abs(x - y) < 1e-2 for x, y in zip(steady["body"]["position"], b[0]))
# half the density, CdA and the square of the flow; the weight in water
u = (0.2 - 1.5, 0.1)
pull = [0.5*1025*0.3*(u[0]**2 + u[1]**2)**0.5*v for v in u]
force = steady["body"]["force"]
assert all(abs(x - y) < 1e-9 for x, y in zip(force, (pull[0], (205 - 300)*9.81, pull[1]))), force
assert abs(steady["tension_top"]/r["tension_top"][0] - 1) < 2e-4, (steady["tension_top"], r["tension_top"][0])
assert s["body"]["position"] == b[4:] and s["energy"]["air"] == r["energy"]["air"][4:]
c = calm["body"]["position"]
assert all(abs(x - y - d) < 1e-6 for x, y, d in zip(c[-1], c[0], (6, 0, 0))), c
assert max(abs(x - y) for x, y in zip(b[-1], c[-1])) > 1e-2
assert abs(r["closure"]) < 1e-5, r["closure"]
END
lost() { # what, words, sed
	sed "$3" tow.yaml >bad.yaml
	denies "$1" 1 "$2" tow steady bad.yaml -q
}
lost "air and water" 'the scene has air and water' '$s/$/\nair: {density: 1.2 kg\/m^3}/'
lost "a winch in water" 'winch in water: the added mass' '$s/$/\nwinch: {speed: 1 m\/s, rise: 1 s}/'
lost "a ring in water" 'body.ring in water' 's/^body: .*/body: {ring: {radius: 1 m, tube: 2 cm, mass: 10 kg, offset: 1 m}}/'
lost "volume without water" 'body.volume is of a mass in water' 's/, added_mass: {normal: 1}//; s/^water/air/; s/, depth.*/}/'
lost "added mass without water" 'segments\[0\].added_mass is of water' 's/^water/air/; s/, depth.*/}/; s/volume: 0.2 m^3, //; s/, added_mass: 0.5//'
lost "shedding in water" 'shedding in water: the lift' 's/elements: 10/shedding: {lift: 1, strouhal: 0.2}/'
lost "no diameter in water" 'segments\[0\] has no diameter' 's/diameter: 0.02 m, //'
lost "an orbit in water" 'the steady state of an orbit in water is not known' 's/^tow.*/tow: {orbit: {radius: 30 m, speed: 1 m\/s}}/'
lost "waves without a depth" 'waves need water.depth' 's/depth: 100 m, //'

done_testing

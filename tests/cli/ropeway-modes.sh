#!/bin/sh
# hawser modes of ropeways: own numbers, carriage and bullwheels, contact, shapes, pictures, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
sketched

scenes=$SRCDIR/notebooks-data/scenes
small=$scenes/ropeway-small.yaml
bouquet=$scenes/ropeway-bouquet.yaml
one="--set ropeway.down=off"
works "slip" modes "$small" $one --contact slip --json slip.json --tsv slip.tsv --plot slip.svg -q
works "stick, which a rope at rest does" modes "$small" $one -n 5 --json stick.json --plot stick.svg -q
works "a carriage" modes "$small" $one --contact slip --set ropeway.bottom.mass=40000 --json carriage.json -q
works "the Bouquet line" modes "$bouquet" $one --sliding rest --contact slip -n 4 --json bouquet.json -q
works "  stick" modes "$bouquet" $one --sliding rest -n 3 --json held.json -q
python "numbers of an independent mesh" <<'END2'
# 14 frequencies of the small ropeway to their 5 digits; the first with a carriage is 1.39703 (doc/theory-ropeway-modes.md).
# On the Bouquet line that mesh has its carriers at its nodes, 0.1 to 0.2 m apart.
import json
def near(name, want, tolerance):
    modes = json.load(open(name))["modes"]
    assert len(modes) >= len(want)
    for m, text in zip(modes, want):
        assert abs(m["omega"]/float(text[:-1]) - 1) < tolerance, (name, m["omega"], text)
        assert m["plane"] == ("in-plane" if text[-1] == "p" else "out-of-plane")
        assert 0 <= m["residual"] < 1e-9
near("slip.json", "2.1127p 2.1299z 2.1307z 2.5235p 2.8393z 3.4201p".split(), 3e-5)
near("stick.json", "2.1299z 2.1307z 2.8393z 3.1099p 3.1804p".split(), 3e-5)
near("carriage.json", "1.39703p 2.1129p 2.1299z 2.1307z 2.6178p".split(), 5e-5)
near("bouquet.json", "1.4071z 1.5411p 1.7994z 2.0158p".split(), 2e-4)
near("held.json", "1.4071z 1.7994z 2.4504p".split(), 3e-4)
for name in ("slip.json", "carriage.json"):
    result = json.load(open(name))
    for m in result["modes"]:
        shares = [s["share"] for s in m["spans"]]
        assert [s["name"] for s in m["spans"]] == ["bottom to p0", "p0 to p1", "p1 to top"]
        assert abs(sum(shares) + m["sheaves_share"] + m["bodies_share"] - 1) < 1e-9
        assert m["span_share"] == max(shares) and m["span"] == m["spans"][shares.index(max(shares))]["name"]
    assert result["contact"] == "slip"
body = json.load(open("carriage.json"))["modes"][0]["bodies"]
assert [b["name"] for b in body] == ["carriage"] and body[0]["mass"] == 20000 and body[0]["share"] > 0.5
assert json.load(open("stick.json"))["contact"] == "stick"
# B Figures 6.8 and 6.9: out of the plane single spans, the longest first; in it coupled, .77 and .22 of the
# motion in the spans of 172 m and 144 m in the first one
first, second, third = json.load(open("bouquet.json"))["modes"][:3]
assert first["span"] == "p3 to p4" and third["span"] == "p5 to p6" and min(first["span_share"], third["span_share"]) > 0.9999
shares = {s["name"]: s["share"] for s in second["spans"]}
assert abs(shares["p3 to p4"] - 0.77) < 0.005 and abs(shares["p5 to p6"] - 0.22) < 0.005, shares
END2
try "contact is told apart in the pictures" grep -q 'the rope slips' slip.svg
try "  and sticks" grep -q 'the rope sticks' stick.svg
try "  and in the table" grep -q '^# contact: slip: as given$' slip.tsv
try "the carriage without mass is told" grep -q '^# the carriage does not move: the scene gives no bottom.mass$' slip.tsv

coasts="ropeway.top.drive={inertia: 500}"
works "a loop that coasts" modes "$small" --case empty --contact slip --set "$coasts" -n 3 --json coasts.json -q
works "  with carriers, which climb" modes "$small" --contact slip --set "$coasts" -n 3 --json climbs.json -q
works "  on sheaves that roll" modes "$small" --case empty --contact roll --set "$coasts" -n 3 --json rolls.json -q \
	--set ropeway.towers.p0.inertia=2000 --set ropeway.towers.p1.inertia=2000
works "sheaves that roll" modes "$small" $one --contact roll -n 3 --json light.json -q
works "  with inertia" modes "$small" $one --contact roll -n 3 --json heavy.json -q \
	--set ropeway.towers.p0.inertia=20000 --set ropeway.towers.p1.inertia=20000
for phase in 18.2 18.4; do
	works "  the drive's force at phase $phase m" statics "$small" --sliding rest --set ropeway.carriers.phase=$phase \
		--json at-$phase.json -q
done
works "a rope that runs" modes "$bouquet" -n 2 --shapes --points 9 --json runs.json --plot runs.svg -q
works "  slowly" modes "$bouquet" -n 2 --set ropeway.top.drive.speed=0.001 --json slow.json -q
works "  at rest" modes "$bouquet" -n 2 --sliding rest --contact slip --set ropeway.sliding=rest --json rest.json -q
works "shapes" modes "$small" --shapes --points 5 -n 2 --tsv shapes.tsv --json shapes.json -q
python "a rope without carriers circulates freely; frequencies fall with inertia; a running rope" <<'END2'
import json
def omega(name): return [m["omega"] for m in json.load(open(name))["modes"]]
assert omega("coasts.json")[0] == 0 and omega("coasts.json")[1] > 2
assert omega("rolls.json")[0] == 0
# the loaded loop: stiffness from the force of the drive by the phase, mass of the rope and of the carriers
force, (mode, *_) = [json.load(open("at-%s.json" % p)) for p in (18.2, 18.4)], json.load(open("climbs.json"))["modes"]
mass = 4*force[0]["loop0"] + 8*(400 + 250) + 500/2.5**2
K = (force[1]["drive"]["force"] - force[0]["drive"]["force"])/0.2
assert abs(mode["omega"]/(K/mass)**0.5 - 1) < 5e-4, (mode["omega"], (K/mass)**0.5)
slip, light, heavy = (omega(n)[0] for n in ("slip.json", "light.json", "heavy.json"))
assert heavy < light and abs(light/slip - 1) < 1e-3
runs, slow, rest = (json.load(open(n)) for n in ("runs.json", "slow.json", "rest.json"))
assert runs["contact"] == "slip" and runs["speed"] == 4
for m in runs["modes"]:
    assert m["re"] == 0 and m["im"] == m["omega"] and 0.4 < m["downstream"] < 0.6
assert len(runs["shapes"]["S"]) == 18 and len(runs["shapes"]["modes"][0]["P"]["im"]) == 18
assert runs["shapes"]["lane"][0] == "up" and runs["shapes"]["lane"][9] == "down"
shape = json.load(open("shapes.json"))["shapes"]
assert abs(shape["x"][4] - 300) < 1e-9 and all(abs(m["B"][i]) < 1e-9 for m in shape["modes"] for i in (0, 4, 5, 9))
assert max(map(abs, shape["modes"][0]["B"])) > 0.5
END2
try "the picture of a rope that runs" grep -q 'a quarter period later' runs.svg

denies "stick, and a rope that runs" 1 "contact.modes is stick, but the rope runs at 4 m/s (ropeway.top.drive.speed)" modes \
	"$bouquet" --contact stick
denies "an unknown contact" 1 "must be one of slip, stick, roll" modes "$bouquet" --contact stik
denies "an option of spans" 1 "\-\-damped is for spans and nets, and .* is a ropeway" modes "$small" --damped
denies "an option of nets" 1 "\-\-vtk is for nets, and .* is a ropeway" modes "$small" --vtk a.vtk
denies "an option of ropeways" 1 "\-\-contact is for nets, spans over obstacles and ropeways, and .* is a span" modes "$chairlift" --contact slip
denies "too many modes" 1 "ask for 1 to 500" modes "$small" -n 1000
denies "a tower that is too low" 2 "lifts off the support battery of tower p0 at\|lifts off the support battery of tower p0, line 7" modes "$small" --set 'ropeway.towers.p0.at=[80 m, 5 m]'
(cat "$small"; echo 'contact: {modes: stuck}') >word.yaml
denies "an unknown word" 1 'word.yaml:10:18: contact.modes: "stuck" must be auto, slip, stick or roll' modes word.yaml
(cat "$small"; echo 'contact: {mode: stick}') >key.yaml
denies "an unknown key" 1 "key.yaml:10:.*unknown key contact.mode: did you mean modes?" modes key.yaml
(cat "$small"; echo 'contact: {modes: slip}') >own.yaml
works "the contact of the scene" modes own.yaml $one -n 1 --json own.json -q
try "  is taken" grep -q '"contact": "slip"' own.json
denies "inertia of a point" 1 "towers.p0.inertia: a sheave of the radius 0 does not turn" modes "$small" \
	--set 'ropeway.towers.p0.radius=0 m' --set ropeway.towers.p0.inertia=3
denies "inertia without a radius" 1 "bottom.inertia with bottom.radius = 0" modes "$small" --set ropeway.bottom.radius=0 \
	--set ropeway.bottom.inertia=3
denies "a wrong unit" 1 'drive.inertia: "3 kg"' modes "$small" --set 'ropeway.top.drive.inertia=3 kg'
denies "a negative mass" 1 "bottom.mass" modes "$small" --set ropeway.bottom.mass=-3
done_testing

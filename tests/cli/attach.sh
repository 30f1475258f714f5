#!/bin/sh
# Attachments: the scene's list, overrides of it, statics, and what refuses them.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scene=$top/notebooks-data/scenes/ropeway-carriers.yaml

# --- the scene
sed 's/^# .*//' "$scene" >s.yaml
refuses 1 "--set attach=3: attach must be a list of mappings, such as [{at: 40 %, mass: 20 kg}]" \
	statics s.yaml --set attach=3
refuses 1 "--set attach=[4]: attach[0] must be a mapping, such as {at: 40 %, mass: 20 kg}" \
	statics s.yaml --set 'attach=[4]'
refuses_like 1 "attach\\[0\\].at is missing: give a fraction of the length such as 40 %, or a length such as 12 m" \
	statics s.yaml --set 'attach=[{mass: 3}]'
refuses_like 1 'attach.0..at: "40" is not between the ends: give a fraction' \
	statics s.yaml --set 'attach=[{at: 40, mass: 3}]'
refuses_like 1 'attach.0..at: "1 kg" is no position: give a fraction' \
	statics s.yaml --set 'attach=[{at: 1 kg, mass: 3}]'
refuses_like 1 "attach\\[0\\] has no effect: give it a mass, a force, a spring, a damper or an absorber" \
	statics s.yaml --set 'attach=[{at: 0.4}]'
refuses_like 1 "duplicate key at, already given" statics s.yaml --set 'attach=[{at: 0.4, at: 0.5}]'
refuses_like 1 "attach.0..name: \"12\" is no name" statics s.yaml --set 'attach=[{at: 0.4, mass: 1, name: 12}]'
refuses_like 1 "attach\\[0\\] and attach\\[1\\] have the same name a" \
	statics s.yaml --set 'attach=[{at: 0.4, mass: 1, name: a}, {at: 0.5, mass: 1, name: a}]'
refuses_like 1 "attach\\[0\\] and attach\\[1\\] are at the same point" \
	statics s.yaml --set 'attach=[{at: 0.4, mass: 1}, {at: 0.4, mass: 1}]'
refuses_like 1 "attach contradicts travel" statics s.yaml --set 'travel={speed: 1, hold: length}'
refuses_like 1 "unknown key attach.0..mas: did you mean mass. attach.0. takes at, mass" \
	statics s.yaml --set attach.carrier-1.mas=2
refuses_like 1 "attach has 4 items, numbered from 0, and none has the number or name 7: its names are carrier-1" \
	statics s.yaml --set attach.7.mass=3
many=$(awk 'BEGIN {for (i = 1; i < 34; i++) printf("%s{at: %g, mass: 1}", (i > 1 ? ", " : ""), i/40)}')
refuses_like 1 "attach has more than 32 items" statics s.yaml --set "attach=[$many]"

# --- statics
works "four carriers" statics "$scene" --points 11 --json four.json --tsv four.tsv
works "one is empty" statics "$scene" --points 11 --set attach.carrier-2.mass=0 \
	--set 'attach.1.damper=[0, 1 kN.s/m, 0]' --json empty.json
works "at lengths" statics "$scene" --points 11 --json metres.json \
	--set tension.length0=242.77340036766697 --set 'attach.0.at=33.988276051473377 m'
python "jumps of the vertical force are the weights" <<'END'
import json
r = json.load(open("four.json"))
marks = r["attachments"]
assert [m["name"] for m in marks] == ["carrier-%d" % i for i in (1, 2, 3, 4)]
V = r["V0"]
S = 0.0
for m in marks:
    V += 8.2*9.81*(m["S"] - S)
    S = m["S"]
    assert abs(r["H"]*m["slope_before"] - V) < 1e-8*V
    V += 9.81*820
    assert abs(r["H"]*m["slope_after"] - V) < 1e-8*V
    assert abs(m["T_after"] - (r["H"]**2 + V**2)**0.5) < 1e-8*V
assert abs(V + 8.2*9.81*(r["length0"] - S) - r["V1"]) < 1e-8*V
assert abs(r["T0"] - 210000) < 1e-6 and r["closure"] < 1e-11
assert "# attachment carrier-3 at S = 150.5195" in open("four.tsv").read()
echo = r["scene"]["attach"]
assert echo[1]["at"] == 0.38 and echo[1]["mass"] == 820 and echo[1]["name"] == "carrier-2"
empty = json.load(open("empty.json"))
assert len(empty["attachments"]) == 4 and abs(empty["attachments"][1]["T_after"]/empty["attachments"][1]["T_before"] - 1) < 1e-14
metres = json.load(open("metres.json"))
assert abs(metres["T0"]/r["T0"] - 1) < 1e-10 and abs(metres["sag"]/r["sag"] - 1) < 1e-10
END
if command -v gnuplot >/dev/null; then
	works "the profile with carriers" statics "$scene" --plot carriers.svg -q
	try "it says what it shows" grep -q attachments carriers.svg
else
	skip "gnuplot is not installed"
fi

# --- modes
works "modes with carriers" modes "$scene" -n 6 --json modes.json
python "the carriers are heavy" <<'END'
import json
mode = json.load(open("modes.json"))["modes"]
# light cable between heavy masses: nearly 4 degrees of freedom in each plane
assert abs(mode[0]["omega"] - 1.25058) < 1e-4 and mode[0]["plane"] == "out-of-plane"
assert all(m["residual"] < 1e-12 for m in mode)
END
refuses_like 1 "the method fdm is for a cable without attachments" modes "$scene" --method fdm

# --- damped modes
stay=$top/notebooks-data/scenes/stay-damper.yaml
picture=
command -v gnuplot >/dev/null && picture="--plot size.svg"
works "damped modes" modes "$stay" --damped -n 6 --json damped-modes.json --tsv damped-modes.tsv -q
# shellcheck disable=SC2086 # words
works "over the size" modes "$stay" -n 2 --over 'attach.damper.damper[2]=3 kN.s/m:300 kN.s/m:11' --log \
	$picture --json size.json --tsv size.tsv -q
works "over the place" modes "$stay" -n 2 --over attach.0.at=0.01:0.05:3 --json place.json -q
works "with uniform damping" modes "$stay" --damped -n 2 --set damping.ratio=0.004 --json ratio.json -q
python "the largest damping is about half of the distance from the end" <<'END'
import json
r = json.load(open("damped-modes.json"))
assert len(r["damped"]) == 6 and "over" not in r
out = [m for m in r["damped"] if m["plane"] == "out-of-plane"]
assert all(m["damping_ratio"] > 0.005 for m in out) and all(abs(m["damping_ratio"]) < 1e-12 for m in r["damped"] if m not in out)
assert all(abs(m["damping_ratio"] + m["re"]/abs(complex(m["re"], m["omega"]))) < 1e-12 for m in out)
assert "creeps without oscillation" in open("damped-modes.tsv").read()
size = json.load(open("size.json"))
assert size["over"] == "attach.damper.damper[2]" and len(size["damped"]) == 22
first = [(m["damping_ratio"], m["value"]) for m in size["damped"] if m["plane"] == "out-of-plane" and m["number"] == 1]
assert len(first) == 11 and abs(max(first)[0]/0.02 - 1) < 0.08, max(first)
assert abs(first[1][1]/first[0][1] - 100**0.1) < 1e-9
assert "damped modes over attach.damper.damper[2], 11 values (N.s/m)" in open("size.tsv").read()
best, = size["best"]
assert (best["damping_ratio"], best["value"]) == max(first) and best["plane"] == "out-of-plane" and best["modes"] == 1
assert "best of these values for out-of-plane modes 1 to 1: attach" in open("size.tsv").read()
place = [m["damping_ratio"] for m in json.load(open("place.json"))["damped"] if m["plane"] == "out-of-plane" and m["number"] == 1]
assert len(place) == 3 and place[0] < 0.006
plain = [m["damping_ratio"] for m in json.load(open("ratio.json"))["damped"] if m["plane"] == "in-plane"]
assert all(abs(p - 0.004) < 1e-12 for p in plain)
END
works "places in metres" modes "$stay" -n 2 --set 'attach.damper.at=5 m' --over attach.damper.at=3:6:2 --tsv metres.tsv -q
try "they say so" grep -q "2 values (m)" metres.tsv
if command -v gnuplot >/dev/null; then
	try "the picture of the damping over the size says what it shows" grep -q "Damper along z" size.svg
	refuses_like 1 "give --over KEY=FROM:TO:POINTS" modes "$stay" --damped --plot no.svg
	works "nothing is damped" modes "$stay" -n 2 --set 'attach.0.damper=[0, 0, 1e-9]' --over attach.0.at=0.1:0.2:2 --plot none.svg -q
else
	skip "gnuplot is not installed"
fi
tmd='attach=[{at: 50 %, absorber_mass: 60 kg, absorber_stiffness: 2.3 kN/m, absorber_damping: 25 N.s/m, name: tmd}]'
works "an absorber" modes "$stay" --set "$tmd" --damped -n 4 --json tmd.json -q
works "and its weight" statics "$stay" --set "$tmd" --json tmd-statics.json -q
works "over its stiffness" modes "$stay" --set "$tmd" -n 4 --over attach.tmd.absorber_stiffness=2e3:3e3:2 --json over.json -q
python "absorbers" <<'END'
import json
r = json.load(open("tmd.json"))
a = r["scene"]["attach"][0]
assert a["absorber_mass"] == 60 and a["absorber_direction"] == [0, 1, 0]
first = [m for m in r["damped"] if m["plane"] == "in-plane"][:2]
assert len(first) == 2 and all(m["damping_ratio"] > 0.005 for m in first), first
assert [m["damping_ratio"] for m in r["damped"] if m["plane"] == "out-of-plane"][0] == 0
assert json.load(open("tmd-statics.json"))["attachments"][0]["mass"] == 60
assert len(json.load(open("over.json"))["damped"]) == 8
END
works "undamped modes with it" modes "$stay" --set "$tmd" -n 4 --json strokes.json -q
works "without a name" modes "$stay" --set "${tmd%, name: tmd*}}]" -n 4 --tsv strokes.tsv -q
works "in a sweep of the tension" irvine "$stay" --set "$tmd" -n 3 --points 5 --json irvine.json -q
python "strokes" <<'END'
import json
m = json.load(open("strokes.json"))["modes"]
for x in m:
    assert ("in-plane" == x["plane"]) == (abs(x["stroke"]["tmd"]) > 1e-5), x
assert m[0]["stroke"]["tmd"]*m[2]["stroke"]["tmd"] < 0 or m[0]["stroke"]["tmd"]*m[1]["stroke"]["tmd"] < 0
assert [line for line in open("strokes.tsv") if line.startswith("index")][0].rstrip().endswith("stroke_1")
END
refuses_like 1 "absorber_direction is oblique" modes "$stay" --set "$tmd" --set 'attach.tmd.absorber_direction=[0, 1, 1]'
works "which damped modes have" modes "$stay" --damped -n 2 --set "$tmd" --set 'attach.tmd.absorber_direction=[0, 1, 1]' -q
works "a model with it" rom "$stay" --set "$tmd" -n 4 --json model.json -q
works "and with the exact energy" integrate "$stay" --set "$tmd" --set model.energy=exact --set model.basis=6 --until 0.5 --Omega 6 --json exact.json -q
works "a nonlinear energy sink" frf "$stay" --set "$tmd" --set attach.tmd.absorber_cubic=40 -n 3 --set 'load={frame: global, per_length: [0, 2, 0]}' --from 0.9w1 --to 1.1w1 --json nes.json -q
python "strokes of responses" <<'END'
import json
m = json.load(open("model.json"))
assert m["shapes"]["name"][3] == "stroke_tmd" if "name" in m["shapes"] else True
r = json.load(open("nes.json"))
assert r["scene"]["attach"][0]["absorber_cubic"] == 40
assert max(p["amplitude"]["y_stroke_tmd"] for p in r["points"]) > 0
END
works "its response" frf --unstable 9 "$SRCDIR/notebooks-data/scenes/stay-sink.yaml" --from 5.9rad/s --to 6.6rad/s --json sink.json -q
if command -v gnuplot >/dev/null; then
	works "the picture" frf "$SRCDIR/notebooks-data/scenes/stay-sink.yaml" -n 2 --from 5.9rad/s --to 6rad/s --plot sink.svg -q
	try "has the stroke" grep -q "stroke sink\|stroke-sink" sink.svg
else
	skip "gnuplot is not installed"
fi
works "and without the cubic spring" frf "$SRCDIR/notebooks-data/scenes/stay-sink.yaml" --set attach.sink.absorber_cubic=0 --from 5.9rad/s --to 6.6rad/s --json soft.json -q
python "the amplitudes of sink and cable are in the relation of harmonic balance" <<'END'
import json
def points(name):
    return [(p["Omega"], p["amplitude"]["z_mid"], p["amplitude"]["z_stroke_sink"]) for p in json.load(open(name))["points"]]
m, k, k3, c = 60, 46, 80e3, 40
# m W^2 X = (k - m W^2 + 3/4 k3 S^2 + i W c) S up to the third harmonic, of which the linear one has none
for name, cubic, tolerance in (("sink.json", k3, 0.012), ("soft.json", 0, 1e-4)):
    worst = max(abs(m*w*w*x/abs((k - m*w*w + 0.75*cubic*s*s + 1j*w*c)*s) - 1) for w, x, s in points(name))
    assert worst < tolerance, (name, worst)
r = json.load(open("sink.json"))
assert 1e-5 < r["model_error"]["estimated"] < 2e-2, r["model_error"] # by the exact energy
assert {"fold", "torus"} <= {e["kind"] for e in r["events"]}, r["events"]
top = [max(x for _, x, _ in points(name)) for name in ("sink.json", "soft.json")]
assert 0.5 < top[0]/top[1] < 0.6, top
END
refuses_like 1 "modes are not weighed with absorbers" frf "$stay" --set "$tmd" --set 'load={frame: global, per_length: [0, 2, 0]}' --set model.modes=auto
refuses_like 1 "whose cubic spring alone does not hold it at rest" statics "$stay" --set 'attach=[{at: 50 %, absorber_mass: 60 kg, absorber_cubic: 3}]'
refuses_like 1 "has an incomplete absorber: give both" statics "$stay" --set 'attach=[{at: 50 %, absorber_mass: 60 kg}]'
refuses_like 1 "absorber without direction" statics "$stay" --set "$tmd" --set 'attach.tmd.absorber_direction=[0, 0, 0]'
refuses_like 1 "KEY=FROM:TO:POINTS" modes "$stay" --over attach.0.at=0.1
refuses_like 1 "KEY=FROM:TO:POINTS" modes "$stay" --over attach.0.at=0.1:0.2:1
run modes "$stay" --over "attach[0].at=[0.1, 0.2]" -n 2
sed '/^#/d' "$scratch/out" >"$scratch/listed"
run modes "$stay" --over attach.0.at=0.1:0.2:2 -n 2
try "a list and a range of the same values give the same modes" sh -c "sed '/^#/d' '$scratch/out' | cut -f 3-8 | diff - /dev/fd/3" 3<<END
$(cut -f 3-8 "$scratch/listed")
END
refuses_like 1 "log needs --over KEY=VALUES: give that" modes "$stay" --log
refuses_like 1 "shapes does not go with --damped" modes "$stay" --damped --shapes
refuses_like 1 "has 3 values" modes "$stay" --over attach.0.damper=1e3:2e3:3
refuses_like 1 "no equal ratios" modes "$stay" --over attach.0.mass=0:2:3 --log
refuses_like 1 "KEY=FROM:TO:POINTS" modes "$stay" --over attach.0.mass=2:2:3
refuses_like 1 "those of a cable at rest" modes "$top/notebooks-data/scenes/rope.yaml" --damped
refuses_like 2 "inextensible" modes "$stay" --damped --set cable.EA=.inf

# --- reduced models, responses, maps
works "a model with carriers" rom "$scene" --json model.json -q
works "a model with dampers" rom "$scene" --set 'attach.0.damper=[0, 8 kN.s/m, 8 kN.s/m]' --json damped.json -q
python "a shape for each damper, coupled by D" <<'END'
import json
r, d = json.load(open("model.json")), json.load(open("damped.json"))
shapes = [l for l in d["labels"] if l.startswith("damper shape")]
assert len(shapes) == 2 and not [l for l in r["labels"] if "damper" in l]
assert all(r["D"][j][k] == 0 for j in range(r["n"]) for k in range(r["n"]) if j != k)
at = d["labels"].index(shapes[0])
assert any(abs(d["D"][at][k]) > 0.1 for k in range(d["n"]) if k != at)
END
works "a response with a damper" frf "$stay" -n 4 --from 0.9w1 --to 0.901w1 --method balance --step 1 --set 'load={frame: global, per_length: [0, 0, 1e-3]}' \
	--json natural.json -q
python "its natural frequencies are those of the modes" <<'END'
import json
r = json.load(open("natural.json"))["natural_frequencies"]
assert len(r) == 4 and abs(r[3]/r[0] - 2) < 0.05, r
END
works "two modes" frf "$scene" -n 2 --set model.energy=quartic --from 0.5 --to 0.6 --step 0.3 --set 'load.per_length=[0, 0, 1e-3]' --json two.json -q
works "eight modes" frf "$scene" -n 8 --set model.energy=quartic --from 0.5 --to 0.6 --step 0.3 --set 'load.per_length=[0, 0, 1e-3]' --json twelve.json -q
works "two modes in the plane" frf "$scene" -n 3 --set model.energy=quartic --from 0.5 --to 0.6 --step 0.3 --set 'load.per_length=[0, 1e-3, 0]' --json in2.json -q
rough "eight modes in the plane" frf "$scene" -n 8 --set model.energy=quartic --from 0.5 --to 0.6 --step 0.3 --set 'load.per_length=[0, 1e-3, 0]' --json in12.json -q
python "the inertia of the masses is part of the response of the others" <<'END'
import json
for a, b, keys in (("two", "twelve", ("z_mid", "z_quarter")), ("in2", "in12", ("y_mid", "y_quarter"))):
    a, b = (json.load(open(n + ".json"))["points"] for n in (a, b))
    for p, q in ((a[0], b[0]), (a[-1], b[-1])):
        assert abs(p["Omega"] - q["Omega"]) < 1e-9
        for key in keys:
            assert abs(p["amplitude"][key]/q["amplitude"][key] - 1) < 3e-4, (key, p["amplitude"][key], q["amplitude"][key])
END
flat "a map of the place and the size of a damper" map "$scene" --quantity growth --points 4x3 \
	--set 'attach=[{at: 5 %, damper: [0, 30 kN.s/m, 1 kN.s/m], name: d}]' --x attach.d.at=0.02:0.1 \
	--y 'attach.d.damper[2]=1e4:3e4' -n 2 --json map.json
python "dampers damp" <<'END'
import json
value = json.load(open("map.json"))["points"]["value"]
# without the damper 0.005*2.27 = 0.0114; the further from the end, the more
assert all(v < -0.025 for v in value) and value[3] < value[2] < value[1] < value[0], value
END
spring='attach.0.spring=[0, 3e4, 1e4]'
works "springs and dampers, condensed" frf "$scene" -n 10 --set "$spring" --set 'attach.1.damper=[0, 2e3, 500]' \
	--from 1.80 --to 1.801 --step 1 --set 'load.per_length=[0, 2, 2]' --json springs.json -q
works "the full-order model" frf "$scene" --set "$spring" --set 'attach.1.damper=[0, 2e3, 500]' \
	--from 1.80 --to 1.801 --step 1 --set 'load.per_length=[0, 2, 2]' --set model.energy=exact --set model.basis=9 --json springs-full.json -q
python "agree" <<'END'
import json
a, b = (json.load(open(n))["points"] for n in ("springs.json", "springs-full.json"))
for p, q in ((a[0], b[0]), (a[-1], b[-1])):
    assert abs(p["Omega"] - q["Omega"]) < 1e-9
    for key in ("y_mid", "z_mid"):
        assert abs(p["amplitude"][key]/q["amplitude"][key] - 1) < 1e-3, (key, p["amplitude"][key], q["amplitude"][key])
END
# the coordinates of dampers have no lines of parametric resonance
rough "a map over Omega with a damper" map "$scene" --quantity multiplier --points 3x2 -n 3 \
	--set 'attach.0.damper=[0, 8 kN.s/m, 8 kN.s/m]' --x Omega=1:4 --y factor.load=1:20 --json lines.json -q
flat "where the damper vanishes" map "$scene" --quantity growth --points 2x2 -n 2 --x Omega=1:4 \
	--set 'attach.0.damper=[0, 8 kN.s/m, 0]' --y 'attach.0.damper[1]=0:9e3' -q
works "not condensed" rom "$scene" --set 'attach.0.spring=[0, 1e4, 0]' --set model.condense=none --json s.json -q
works "plan with a damper" plan "$scene" --fidelities "auto 5" --set 'attach.0.damper=[0, 1e3, 1e3]' --json damper.json -q
python "and what a damper adds" <<'END'
import json
plan = json.load(open("damper.json"))
why = {d["subject"]: d["why"] for d in plan["decisions"]}
assert why["dampers"].startswith("at 1 point:"), why
assert any("not weighed with dampers" in f["why"] for f in plan["fidelities"]), plan["fidelities"]
END
# A damper on the deck that moves end A, and the same cable seen from the deck: B moves, the damper is to ground, and every mass
# has the load rho a of the deck's acceleration (8.2 rad/s: 12 kg/m*0.02 m*8.2^2/s^2).
cat >deck.yaml <<'END'
cable: {EA: 150 MN, rho: 12 kg/m}
span: {d: 80 m, h: 35 m}
tension: {T0: 600 kN}
attach: [{at: 5 %, damper: [0, 20 kN.s/m, 20 kN.s/m], damper_to: A}]
support: {A: {motion: [0, 20 mm, 10 mm]}}
damping: {ratio: 0.2 %}
model: {modes: 4}
END
works "a damper on the deck" frf deck.yaml --from 8.2 --to 8.2001 --step 1 --json deck.json -q
works "seen from the deck" frf deck.yaml --set 'attach.0.damper_to=ground' --set 'support={B: {motion: [0, -20 mm, -10 mm]}}' \
	--set 'load={frame: global, per_length: [0, 16.1376, 8.0688]}' --from 8.2 --to 8.2001 --step 1 --json seen.json -q
works "over a period" orbit deck.json#1 --tsv deck.tsv -q
works "over a period of a result with --set" orbit seen.json#1 --tsv seen.tsv -q
python "is the same motion" <<'END'
import csv, math
a, b = (list(csv.DictReader((r for r in open(n) if r[0] != "#"), delimiter="\t")) for n in ("deck.tsv", "seen.tsv"))
for p, q in zip(a, b, strict=True):
    deck = 0.02*math.cos(8.2*float(p["t_s"]))
    for key, part in (("y_mid_m", 1), ("z_mid_m", 0.5), ("y_quarter_m", 1)):
        assert abs(float(p[key]) - float(q[key]) - part*deck) < 1e-12, (key, p[key], q[key])
END
works "plan with masses" plan "$scene" --fidelities "raw 1, condensed 1" --to 1.1w1 --json plan.json -q
works "plan with springs" plan "$scene" --set 'attach.0.spring=[0, 1e3, 0]' --fidelities 'condensed 1' --to 1.1w1 --json plan-springs.json -q

# --- what compares or sweeps cables without attachments
refuses_like 1 "models compares cables without attachments" statics "$scene" --models
refuses_like 1 "compares cables without attachments" statics "$scene" --model parabola
works "Irvine's diagram with carriers" irvine "$scene" -n 6 --points 5 --from 150kN --to 180kN --sweep T0 --json irvine.json -q
works "modes at its end" modes "$scene" -n 6 --set "tension={T0: 180 kN}" --json at.json -q
python "the sweep ends with these frequencies" <<'END'
import json
sweep, modes = json.load(open("irvine.json")), json.load(open("at.json"))
got = sorted(b["omega"][-1] for b in sweep["branches"])[:4]
want = [m["omega"] for m in modes["modes"]][:4]
assert all(abs(a/b - 1) < 1e-9 for a, b in zip(got, want)), (got, want)
END

# --- dead forces
force='attach=[{at: 30 %, mass: 20 kg}, {at: 60 %, force: [0, -500 N, 200 N], name: pull}]'
t0='{T0: 110 kN}'
works "a force from the side" statics "$scene" --set "$force" --set "tension=$t0" --json force.json -q
works "downwards, of a given H" irvine "$scene" --set 'attach=[{at: 60 %, force: [0, -500 N, 0]}]' -n 2 --points 3 -q
python "the echo has the force, and the weight is in the equilibrium" <<'END'
import json
r = json.load(open("force.json"))
assert r["scene"]["attach"][1]["force"] == [0, -500, 200] and "force" not in r["scene"]["attach"][0]
END
works "a model" rom "$scene" --set "$force" --set "tension=$t0" -q
refuses_like 1 "of a cable that attachments turn out of one plane, or pull" statics "$scene" --set "$force" --set 'tension={H: 100 kN}'
refuses_like 1 "attach.1..force: a cable that a force turns out of one plane" irvine "$scene" --set "$force" --set "tension=$t0"
refuses_like 1 "contradicts attach.force" modes "$scene" --set "$force" --set "tension=$t0" --set 'attach.pull.spring=[0, 1e3, 0]'
refuses_like 1 "or attach.force, take out of one plane" modes "$scene" --set "$force" --set "tension=$t0" --damped
refuses_like 1 "motion. of a cable that masses or springs in a wind, or attach.force" rom "$scene" --set "$force" --set "tension=$t0" --set 'support={B: {motion: [0, 1 cm, 0]}}'
refuses_like 1 "attachments are at rest, and a cable" irvine "$scene" -n 2 --points 3 --speeds "0, 3"
cat >across.yaml <<'END'
cable: {EA: 900 MN, rho: 45 kg/m}
span: {d: 120 m, h: 60 m}
tension: {T0: 3.2 MN}
g: 1e-6 m/s^2
attach: [{name: d, at: 3 %, damper: [0, 90 kN.s/m, 90 kN.s/m], damper_frame: local}]
load: {frame: local, per_length: [0, 4 N/m, 0]}
support: {B: {motion: [3 mm, -2 mm, 5 mm]}}
END
works "a damper across a taut stay" modes across.yaml -n 4 --damped --json across.json -q
for frame in local global; do
	works "equal ones along all axes, $frame" frf across.yaml --set "attach.0.damper=[90 kN.s/m, 90 kN.s/m, 90 kN.s/m]" \
		--set attach.0.damper_frame=$frame -n 3 --set g=9.81 --from 0.99w1 --to 1.01w1 --max-points 2 --json $frame.json -q
done
python "acts the same in both planes; equal ones have no axes" <<'END'
import json
modes = json.load(open("across.json"))["damped"]
for a, b in zip(modes[::2], modes[1::2]):
    assert abs(a["damping_ratio"]/b["damping_ratio"] - 1) < 1e-9 and a["damping_ratio"] > 0.014, (a, b)
one, other = (json.load(open(n + ".json"))["points"] for n in ("local", "global"))
for a, b in zip(one, other):
    assert abs(a["Omega"]/b["Omega"] - 1) < 1e-9 and abs(a["amplitude"]["y_mid"]/b["amplitude"]["y_mid"] - 1) < 1e-7, (a, b)
END
done_testing

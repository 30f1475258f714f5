#!/bin/sh
# hawser rom of ropeways: the model of both lanes and of one, its loads, what takes its file, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scenes=$SRCDIR/notebooks-data/scenes
small=$scenes/ropeway-small.yaml
up="--lane up" # whose figures are known
works "carriers that pass" rom "$small" $up -n 6 --damping 0.02 --json passing.json --tsv passing.tsv -q
works "a drive" rom "$small" $up -n 6 --damping 0.02 --ripple 0.01 --json drive.json -q
works "the other lane, stuck" rom "$small" -n 4 --lane down --contact stick --json stick.json -q
works "the modes of the lane" modes "$small" --set ropeway.down=off --contact slip -n 6 --json modes.json -q
works "smeared carriers" rom "$small" $up -n 1 --carriers smeared --json smeared.json -q
works "a response" frf passing.json --from 0.95w1 --to 1.02w1 --step 0.04 --json frf.json -q
rough "the same of the scene, with more modes" frf "$small" $up -n 6 --damping 0.02 --from 0.95w1 --to 1.02w1 --step 0.04 \
	--json scene.json --tsv scene.tsv --plot frf.svg -q
rough "  the motion at a label, by the modes and options of the result" orbit scene.json#1 --animate motion.gif --frames 8 \
	--tsv orbit.tsv -q
try "  frames" python3 -S -c 'import sys; d = open("motion.gif", "rb").read()
sys.exit(d[:6] != b"GIF89a" or d.count(bytes([0x21, 0xf9, 4])) != 8)'
works "the default range" rom "$small" $up -n 6 --export auto range -q
rough "a motion of the scene, by the name of the load" integrate "$small" $up -n 6 --damping 0.02 --load drive --ripple 0.01 \
	--Omega 2.5 --until 20 --every 1 --json named.json -q
works "the modes that matter, chosen" frf "$small" $up --damping 0.02 --from 2.12 --to 2.14 --step 0.2 --json chosen.json --tsv chosen.tsv -q
keep=$(sed -n 's/^# .* of 32 modes chosen: --keep //p' chosen.tsv)
[ -z "${HAWSER_LONG:-}" ] || works "  and kept" frf "$small" $up --keep "$keep" --damping 0.02 --from 2.12 --to 2.14 --step 0.2 --json kept.json -q
most=12 # 40 take 10 s
[ -z "${HAWSER_LONG:-}" ] || most=40
for n in 6 $most; do
	rough "the steady motion with $n modes" frf "$small" $up -n $n --damping 0.02 --load drive --ripple 0.01 --from 2.5 \
		--to 2.5001 --json $n.json -q
done
mv 6.json few.json && mv $most.json most.json
works "a motion" integrate drive.json --Omega 2.5 --until 20 --every 1 --json run.json -q
python "models of a lane" <<'END2'
import json, math, os
passing, drive, stick, smeared = (json.load(open(n + ".json")) for n in ("passing", "drive", "stick", "smeared"))
modes = json.load(open("modes.json"))["modes"]
time = drive["scale"]["time"]
for j, m in enumerate(modes): # carriers where the phase has them
    assert abs(math.sqrt(drive["K"][j][j])/time/m["omega"] - 1) < 1e-9, m
    assert abs(drive["D"][j][j]/math.sqrt(drive["K"][j][j]) - 0.04) < 1e-12
# weights smeared, mass where it is: but for the sag of the carriers' weights the same modes
first = lambda m: math.sqrt(m["K"][0][0])/m["scale"]["time"]/modes[0]["omega"] - 1
assert abs(first(passing)) < 2e-3 < 0.02 < first(smeared) < 0.03, (first(passing), first(smeared))
assert [(h["k"], h["phase"]) for h in passing["harmonics"][:7]] == \
    [(k, p) for k in (1, 2, 3) for p in ("cos", "sin")] + [(0, "cos")]
D = passing["harmonics"][6]["D"]
assert all(D[j][k] == -D[k][j] for j in range(6) for k in range(6)) and any(D[0])
assert any(drive["harmonics"][0]["f"])
assert [len(m["Q"]) > 10 and len(m["C"]) > 20 for m in (passing, drive)] == [True, True]
assert passing["shapes"]["names"] == ["span_1", "span_2", "span_3"]
assert stick["n"] == 4 + stick["second_order_shapes"]
points = json.load(open("frf.json"))["points"]
assert len(points) > 5 and all(p["amplitude"]["y_span_1"] > 0 for p in points)
scene, chosen = (json.load(open(n + ".json")) for n in ("scene", "chosen"))
assert chosen["model_error"]["estimated"] < 0.1, chosen["model_error"]
assert not os.path.exists("kept.json") or chosen["points"] == json.load(open("kept.json"))["points"]
w, top = scene["natural_frequencies"], math.sqrt(passing["K"][5][5])/passing["scale"]["time"] # of the last mode, before second-order shapes
ends = [float(word.partition("=")[2].strip(",").replace("D", "E")) for line in open("c.range") for word in line.split()
        if word.startswith(("RL0=", "RL1="))]
assert abs(ends[1]/ends[0] - 1.1*top/(0.6*min(w))) < 1e-9 and top < 3*min(w), ends
named, run = json.load(open("named.json")), json.load(open("run.json"))
assert len(run["states"]) == 21 and named["states"] == run["states"] and named["probes"] == run["probes"]
for a, b in zip(points, scene["points"], strict=True): # the file has the tensions of its shape points only
    assert a["Omega"] == b["Omega"] and a["amplitude"] == b["amplitude"] and a["contact"] == b["contact"]
# the error of a motion: of the file not known; with 40 modes the scene moves by 0.6 % less
assert "model_error" not in run and named["model_error"]["looked_at"] == 24, named["model_error"]
most = json.load(open("most.json"))["points"][0]["amplitude"]
few = json.load(open("few.json"))["points"][0]["amplitude"]
off = max(abs(few[k] - most[k]) for k in most)/max(most.values())
assert 1e-4 < off <= named["model_error"]["estimated"] <= 1.0, (off, named["model_error"])
assert scene["sheaves"] == ["p0", "p1"] and scene["model_error"]["looked_at"] == 24
# with 40 modes the peaks of the last span are 13 % lower, most by modes at twice the frequency of the load
assert 0.13 < scene["model_error"]["estimated"] <= 1.0 and scene["model_error"]["largest"] == 11, scene["model_error"]
c = [p["contact"]["least"] for p in scene["points"]]
assert max(c) < 1.0 and (min(c) < 0.0) == ("lift" in scene)
END2
try "the load is told" grep -q '^# load: weights of 3924 N that pass at 36.6 m' passing.tsv
try "  and where the rope leaves a sheave" grep -q '^# mode 1: .*in-plane; the rope leaves p0 at u = ' passing.tsv

# Both lanes with what joins them; physics-netrom.md, section 5, has the frequencies.
works "both lanes" rom "$small" --set ropeway.bottom.mass=6000 -n 6 --damping 0.02 --json both.json --tsv both.tsv -q
works "  under the drive" rom "$small" --set ropeway.bottom.mass=6000 -n 6 --load drive --ripple 0.01 --json pulled.json -q
works "  with one that is empty" rom "$small" --set ropeway.carriers.mass.down=0 -n 4 --json half.json -q
try "  their spans are told" grep -q '^# spans 1 to 3 are of lane up, 4 to 6 of lane down' both.tsv
try "  and their sheaves" grep -q 'the rope leaves p1 down at u = ' both.tsv
python "the carriage and the bullwheel join the lanes" <<'END2'
import json, math
both, pulled, half = (json.load(open(n + ".json")) for n in ("both", "pulled", "half"))
w = [math.sqrt(pulled["K"][j][j])/pulled["scale"]["time"] for j in range(6)]
for a, b in zip((w[0], w[1], w[4]), (1.97504911, 2.11429358, 2.37994083)):
    assert abs(a - b) < 1e-8, w
assert both["shapes"]["names"] == [f"span_{i}" for i in range(1, 7)]
assert both["contacts"]["names"] == ["p0 up", "p1 up", "p0 down", "p1 down"], both["contacts"]
assert any(both["harmonics"][0]["f"]) and any(pulled["harmonics"][0]["f"]) and any(half["harmonics"][0]["f"])
END2

# What follows has inertia: with 24 modes the peak is 1.426 m at 2.0925 rad/s, with 5 and without shapes 2.736 m at 2.0254.
cat >one.yaml <<'END2'
ropeway:
  rope: {EA: 40 MN, rho: 4 kg/m}
  bottom: {at: [0 m, 0 m], radius: 2.5 m, tension: {counterweight: 168 kN}, mass: 20 t}
  top: {at: [300 m, 58 m], radius: 2.5 m, drive: {friction: 0.2}}
  towers:
    - {at: [80 m, 17 m], battery: support, radius: 12 m}
    - {at: [220 m, 46 m], battery: support, radius: 12 m}
  carriers: {spacing: 90 m, mass: {up: 400 kg, down: 250 kg}, phase: 18.3 m}
  down: off
END2
works "inertia of what follows" rom one.yaml -n 5 --damping 0.05 --json one.json --tsv one.tsv -q
try "  is told" grep -q '^# inertia of what follows: .* of which 6 second-order shapes leave ' one.tsv
works "  its response" frf one.json --from 2.02 --to 2.12 --json one-frf.json -q
python "  has the frequency of one with 24 modes" <<'END2'
import json
peak = max(json.load(open("one-frf.json"))["points"], key=lambda p: p["amplitude"]["y_span_2"])
assert abs(peak["Omega"] - 2.0925) < 3e-3 and peak["amplitude"]["y_span_2"] < 2.1, peak["amplitude"]
END2

# The Coriolis forces are a damping that grows with Omega and does not vary in time: harmonic 0 of the model.
names="bouquet small transient running rest${HAWSER_LONG:+ gondola}"
for name in $names; do
	case $name in
	running) works "a rope that runs at 4 m/s" rom "$scenes/ropeway-bouquet.yaml" --load drive --ripple 0.01 -n 4 \
		--damping 0.02 --json m.json -q ;;
	rest) works "and one that its drive leaves at rest" rom "$scenes/ropeway-bouquet.yaml" --load drive --ripple 0.01 -n 7 \
		--contact stick --damping 0.02 --json m.json -q ;;
	*) works "a model of ropeway-$name" rom "$scenes/ropeway-$name.yaml" -n 4 --damping 0.02 --json m.json -q ;;
	esac
	for method in balance shooting; do
		works "multipliers by $method" frf m.json --method "$method" --from 0.6w1 --to 2w1 --step 1e-6 --max-points 2 \
			--tolerance 1e-13 --multipliers --json "$name-$method.json" -q
	done
done
python "multipliers by balance are those by shooting" <<'END2'
import json, cmath, glob, math
names = [name[:-13] for name in glob.glob("*-balance.json")]
assert len(names) > 4, names
for name in names:
    m = [[cmath.rect(math.exp(m["log_modulus"]), m["argument"]) for m in
          json.load(open(f"{name}-{method}.json"))["points"][0]["multipliers"]] for method in ("balance", "shooting")]
    assert len(m[0]) == len(m[1]) >= (14 if name == "rest" else 8)
    for z in m[0]:
        near = min(m[1], key=lambda other: abs(other - z))
        assert abs(near - z) < 1e-8, (name, z, near)
        m[1].remove(near)
END2

# A slow drive pulls the rope through all spans, which the lowest modes do not: finite differences of exact catenaries, by an outside
# program, give 0.642 and 0.813 mm along x in the middle of the last two spans.
cat >slow.yaml <<'END2'
ropeway:
  rope: {EA: 25917349.23, rho: 7.428947597}
  bottom: {at: [0, 0], radius: 2, tension: {counterweight: 129164.7139}}
  top: {at: [332.509611, 62.304222], radius: 2, drive: {speed: 0}}
  towers:
    - {at: [72.834026, 18.553047], radius: 23.484338}
    - {at: [202.398857, 44.232981], radius: 23.484338}
    - {at: [252.509611, 54.304222], radius: 23.484338}
  down: off
END2
works "a slow drive" rom slow.yaml --load drive --ripple 1e-3 --damping 0.02 --contact slip -n 4 --json slow.json -q
works "  its response" frf slow.json --from 0.1 --to 0.2 --step 1e-3 --max-points 2 --json slow-frf.json -q
python "  pulls the rope through all spans" <<'END2'
import json
a = json.load(open("slow-frf.json"))["points"][0]["amplitude"]
assert abs(a["x_span_3"] - 0.642e-3) < 1e-6 and abs(a["x_span_4"] - 0.813e-3) < 1e-6, a
END2

# Carriers that swing, and the same as a net, from the statics of the ropeway: frequencies, and how they bend with the energy.
cat >hangers.yaml <<'END2'
ropeway:
  rope: {EA: 40 MN, rho: 4 kg/m}
  bottom: {at: [0 m, 0 m], radius: 2.5 m, tension: {T0: 84 kN}}
  top: {at: [120 m, 25 m], radius: 2.5 m, drive: {friction: 0.2}}
  carriers: {spacing: 70 m, mass: {up: 400 kg, down: 250 kg}, phase: 18.3 m, hanger: 3.2 m}
  down: off
END2
cat >same.yaml <<'END2'
nodes: {A: [0, 0, 0], J1: [18, 4, 0], J2: [86, 18, 0], B: [120, 25, 0]}
supports: {A: fixed, B: fixed}
cables:
  - {from: A, to: J1, EA: 40 MN, rho: 4, length0: 18.3, elements: 10}
  - {from: J1, to: J2, EA: 40 MN, rho: 4, length0: 70, elements: 24}
  - {from: J2, to: B, EA: 40 MN, rho: 4, length0: 34.1326810456635, elements: 16}
masses: {J1: {mass: 400, hanger: 3.2}, J2: {mass: 400, hanger: 3.2}}
damping: {ratio: 0.05}
END2
swing="--carriers swinging --load drive --ripple 6e-3 --damping 0.05 -n 7"
for mode in 1 3 4 5; do
	works "a mode of the net" nnm same.yaml -n 7 --mode $mode --energy-to 0.05 --tsv net-$mode.tsv -q
	works "  and of the ropeway" nnm hangers.yaml $swing --mode $mode --energy-to 0.05 --tsv rope-$mode.tsv -q
done
works "  and under carriers that pass, whose weight is smeared" rom hangers.yaml --carriers swinging -n 7 --json swing.json --tsv swing.tsv -q
python "carriers swing as in a net" <<'END2'
import json, math
passing = json.load(open("swing.json"))
for mode in (1, 3, 4, 5):
    (w, bend), (other, bends) = ((a[0], (b[0] - a[0])/(b[1] - a[1])) for a, b in
        ([[float(x) for x in line.split("\t")[1:3]] for line in open(f"{n}-{mode}.tsv") if line[0] == "1"][::60]
         for n in ("net", "rope")))
    assert abs(w/other - 1) < 2e-7 and abs(bend/bends - 1) < 2e-5, (mode, w, other, bend, bends)
    own = math.sqrt(passing["K"][mode - 1][mode - 1])/passing["scale"]["time"]
    assert abs(own/w - 1) < 2e-3 or mode == 5, (mode, own, w) # a mode of the rope depends on how its weight is spread
END2
try "  is told" grep -q '^# 2 carriers swing on hangers of 3.2 m$' swing.tsv

denies "carriers without hangers" 1 "give the length by which they hang" rom "$small" --carriers swinging
denies "a drive without amplitude" 1 "give the amplitude of the rope's motion" rom "$small" --load drive
denies "an amplitude without drive" 1 "leave out one of --ripple and --load passing" rom "$small" --ripple 0.01 --load passing
denies "an unknown load" 1 "must be one of passing, drive" rom "$small" --load pasing
denies "an unknown lane" 1 "must be one of up, down, both" rom "$small" --lane dwn
denies "a lane that is not there" 1 "this ropeway has lane up only" rom "$small" --lane down --set ropeway.down=off
denies "no carriers" 1 "no carriers pass on the lanes" rom "$small" --case empty --set ropeway.carriers.empty=0
denies "no carriers on a lane" 1 "no carriers pass on lane down" rom "$small" --lane down --set ropeway.carriers.mass.down=0
denies "a smeared mass for each lane" 1 "the lanes have carriers of 400 kg and 250 kg" rom "$small" --carriers smeared
denies "a table of its load" 1 "must be one of passing, drive" integrate "$small" --load "$small" --Omega 1
denies "a table of its ends" 1 "does not go with a ropeway" integrate "$small" --motion "$small" --Omega 1
denies "a key of its scene as a parameter" 1 "a ropeway has the parameters factor.load" frf "$small" --over rope.rho=1:2 --Omega 1
denies "rolling sheaves" 1 "contact roll" rom "$small" --contact roll
denies "too large a damping" 1 "the damping ratio is 2" rom "$small" --damping 2
denies "too many modes" 1 "41 modes asked" rom "$small" -n 41
denies "an option of ropeways" 1 "\-\-ripple is for ropeways" rom "$chairlift" --ripple 1
denies "a picture" 1 "rom has no picture" rom "$small" --plot a.svg
denies "carriers neither here nor there" 1 "must be one of fixed, smeared, swinging" frf "$small" --carriers moving
denies "a list of modes that does not ascend" 1 "\-\-keep 4,1: give numbers of modes" rom "$small" --keep 4,1
denies "  or with their number" 1 "\-\-keep 1,4 says which modes are kept" rom "$small" --keep 1,4 -n 4
denies "an option of ropeways, with a model file" 1 "\-\-carriers is for ropeways" frf passing.json --carriers fixed
denies "a map of a mesh" 1 "\-\-vtk is for nets and rods, and .* is a ropeway" integrate "$small" --ripple 0.01 --vtk x
done_testing

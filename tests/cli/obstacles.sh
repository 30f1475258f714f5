#!/bin/sh
# hawser statics and modes of spans over obstacles: exact output, JSON, pictures, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scenes=$SRCDIR/notebooks-data/scenes
sheave=$scenes/b-table-3.5.yaml

works "B Table 3.5" statics "$sheave" --points 3 --json sheave.json --tsv sheave.tsv --plot sheave.svg -q
sed '/^# scene:/d; s/-*[0-9.]*e-[0-9]*/0/g' sheave.tsv | awk -F'\t' '
	/^#/ || /^S_m/ { print; next }
	{ for (i = 1; i <= NF; i++) printf("%s%.6f", (i > 1 ? " " : ""), $i + 1e-9); print "" }' >text
cat >want <<'END'
# hawser 0.1.0 statics
# method: catenaries and arcs, laid from end A
# g = 9.81 m/s^2; sliding: none
# T0 = 52444.5136 N at end A, T1 = 52444.5136 N at end B
# length0 = 301 m, length = 301.010502 m
# A to s0: H = 52295.977 N, sag = 0.311351 m
# s0 to B: H = 52126.5397 N, sag = 8.09058 m
# s0: T = 52712.9081 N before, 52711.1727 N behind; wrap = 0.274932345 rad from (48.744756, 4.920905) to (51.485244, 4.889087) m
# s0: reaction = [169.437358, 14595.604] N, least pressure = 5325.05 N/m
# s0: margin = 0.0274603; friction holds T behind from 51266.8526 to 54195.7532 N at this T before
# about to slide toward A: T0 = 53913.1394 N, T1 = 52432.4451 N, H = 53757.6335 N at A, 52114.3702 N at B
# about to slide toward B: T0 = 51009.0495 N, T1 = 52457.1815 N, H = 50867.2991 N at A, 52139.3135 N at B
# without obstacles: T0 = 58129.3349 N, T1 = 58129.3349 N, H = 57546.8069 N at A, 57546.8069 N at B
S_m	x_m	y_m	angle_rad	T_N	y_clear_m
0.000000 0.000000 0.000000 0.075281 52444.513623 0.000000
150.500000 149.725582 -4.781354 -0.046822 52183.730445 -10.680419
301.000000 300.000000 0.000000 0.110174 52444.513623 0.000000
END
try "the text, exactly" diff want text
python "JSON" <<'END'
import json, math
r = json.load(open("sheave.json"))
assert r["scene"]["kind"] == "span" and r["sliding"] == "none"
s, = r["obstacles"]
assert s["name"] == "s0" and s["touches"] and s["side"] == "above" and s["rotation"] == "locked"
# forces: ends, sheave and weight
for k, weight in ((0, 0.0), (1, 5.56*9.81*r["length0"])):
    assert abs(r["reaction_A"][k] + r["reaction_B"][k] + s["reaction"][k] - weight) < 1e-7
assert abs(s["wrap"] - (s["angle_in"] - s["angle_out"])) < 1e-15
assert abs(math.hypot(s["from"][0] - 50, s["from"][1] + 5) - 10) < 1e-9
assert abs(s["margin"] - (0.1*s["wrap"] - abs(math.log(s["T_out"]/s["T_in"])))) < 1e-12
assert [p["name"] for p in r["spans"]] == ["A to s0", "s0 to B"]
for p in r["spans"]:
    assert min(p["H_toward_A"], p["H_toward_B"]) < p["H"] < max(p["H_toward_A"], p["H_toward_B"])
assert r["toward_A"]["T0"] > r["T0"] > r["toward_B"]["T0"]
assert abs(r["clear"]["length0"] - 301) < 1e-9 and "why" not in r["clear"]
assert r["closure"] < 1e-9 and r["error"] < 1e-12 and len(r["profile"]) == 3
END
works "a table of the free parts" statics "$sheave" --spans --tsv spans.tsv -q
try "  of two" test "$(grep -c '^[As]0* to\|^s0 to' spans.tsv)" = 2
run statics "$scenes/b-table-2.1.yaml" --set 'obstacles.s0.circle.centre=[37.5 m, -8 m]' --json clear.json
try "a rope that passes clear" test "$status" -eq 0
try "  a warning has the distance" grep -q "does not touch obstacle s0: it passes at a distance of 2.653 m" "$scratch/err"
python "  is the rope without obstacles" <<'END'
import json
r = json.load(open("clear.json"))
assert r["obstacles"] == [{"name": "s0", "side": "above", "rotation": "locked", "touches": False,
                           "clearance": r["obstacles"][0]["clearance"]}]
assert abs(r["T0"]/r["clear"]["T0"] - 1) < 1e-12 and "toward_A" not in r
END
works "sliding" statics "$sheave" --set 'contact={sliding: toward-B}' --json sliding.json -q
python "  is the limit at rest" <<'END'
import json
rest, sliding = (json.load(open(n + ".json")) for n in ("sheave", "sliding"))
assert abs(sliding["T1"]/rest["toward_B"]["T1"] - 1) < 1e-12 and "toward_B" not in sliding
END
works "history: hauled tight, then paid out a little" statics "$sheave" --json history.json -q \
	--set 'contact={sliding: history, path: [310 m, 300.99995 m]}'
python "  is what sticks and slips make of it" <<'END'
import json
r, rest = (json.load(open(n + ".json")) for n in ("history", "sheave"))
assert r["sliding"] == "history" and len(r["path"]) == 41
first, tight, last = (r["path"][i] for i in (0, 20, 40))
# from the state without tangential forces the rope slips toward A, with all the friction
assert abs(first["T0"]/first["T1"] - 1) < 1e-12 and first["grip"] == first["slid"] == [0]
assert tight["grip"] == [-0.1] and tight["slid"][0] < -8 and tight["T0"] > tight["T1"]
# then it sticks: no rope passes, and friction is between its limits
assert last["slid"] == tight["slid"]
assert -0.1 < last["grip"][0] < 0.1 and r["toward_A"]["T0"] > r["T0"] > r["toward_B"]["T0"]
# so that rope and tension behind the circle are those of before; all the rope paid out is before it
assert abs(last["T1"]/tight["T1"] - 1) < 1e-3 and last["T0"] < tight["T0"]
assert abs(r["toward_A"]["T0"]/rest["toward_A"]["T0"] - 1) < 1e-12
END
denies "history without a path" 1 "history needs contact.path, a list of 1 to 100 values that tension.length0 had before" \
	statics "$sheave" --set 'contact={sliding: history}'
denies "a path without history" 1 "contact.path is of sliding: history" statics "$sheave" --set 'contact={path: [310 m]}'
denies "a winch at the other end" 1 "with tension.T0 the rope is paid in and out at end A" statics "$sheave" \
	--set 'tension={T0: 50 kN}' --set 'contact={sliding: history, path: [20 kN], winch: B}'
try "the picture has the rope without the obstacles" grep -q "without obstacles" sheave.svg

denies "a misspelt key" 1 "unknown key obstacles.s0.frction: did you mean friction" statics "$sheave" --set obstacles.s0.frction=1
denies "a wrong unit" 1 'wrong unit "kg"' statics "$sheave" --set "obstacles.s0.circle.radius=3 kg"
denies "an option of other scenes" 1 "\-\-models is for spans, and .* is a span over obstacles" statics "$sheave" --models
denies "the same of ropeways" 1 "\-\-worst is for ropeways, and .* is a span over obstacles" statics "$sheave" --worst
denies "a rope that is too short" 2 "shorter than the shortest way past the obstacles" statics "$scenes/b-table-2.1.yaml" --set obstacles.s0.side=below
# --- modes
works "slip" modes "$sheave" -n 4 --contact slip --json slip.json --tsv slip.tsv --plot modes.svg -q
works "  in the middle" modes "$sheave" --set 'obstacles.s0.circle.centre=[150 m, -8 m]' -n 4 --contact slip --json middle.json -q
works "stick, with friction" modes "$sheave" -n 8 --json stick.json -q
works "slip, without friction" modes "$sheave" --set obstacles.s0.friction=0 -n 4 --json smooth.json -q
works "a circle that turns" modes "$sheave" --set obstacles.s0.rotation=free -n 4 --json roll.json -q
works "shapes" modes "$sheave" -n 2 --points 5 --shapes --json shapes.json --tsv shapes.tsv -q
python "frequencies of an independent mesh" <<'END'
# B Table 3.6 does not say where the sheave is. The mesh has its points of contact at nodes, which is 1e-4 of a frequency
# (doc/theory-obstacles.md).
import json
def near(name, want):
    for m, text in zip(json.load(open(name))["modes"], want.split()):
        assert abs(m["omega"]/float(text[:-1]) - 1) < 1.3e-4, (name, m["omega"], text)
        assert m["plane"] == ("in-plane" if text[-1] == "p" else "out-of-plane") and m["residual"] < 1e-9
near("slip.json", "1.22338z 2.43481p 2.44519z 3.47141p")
near("middle.json", "1.49496p 1.52514z 1.52514z 3.03304p")
r = {n: json.load(open(n + ".json")) for n in ("slip", "stick", "smooth", "roll", "shapes")}
assert [r[n]["contact"] for n in r] == ["slip", "stick", "slip", "roll", "stick"]
assert all(abs(a["omega"]/b["omega"] - 1) < 1e-9 for a, b in zip(r["slip"]["modes"], r["smooth"]["modes"]))
assert [s["name"] for s in r["slip"]["modes"][0]["spans"]] == ["A to s0", "s0 to B"]
points = r["shapes"]["shapes"]
assert len(points["S"]) == 5 and len(points["modes"]) == 2 and "lane" not in points
END
python "stick: the spans between the points of contact, each as a scene" <<'END'
import json
r = json.load(open("sheave.json"))
for p, name in zip(r["spans"], ("left", "right")):
    with open(name + ".yaml", "w") as f:
        f.write("cable: {EA: 1.5 GN, rho: 5.56 kg/m}\nspan: {d: %.17g, h: %.17g}\ntension: {H: %.17g}\n"
                % (p["to"][0] - p["from"][0], p["to"][1] - p["from"][1], p["H"]))
END
# a warning says that this rope is too stiff for its mass
for part in left right; do
	run modes $part.yaml -n 8 --json $part.json -q
	try "  $part" test "$status" -eq 0
done
python "  have the same frequencies" <<'END'
import json
stick = json.load(open("stick.json"))["modes"]
parts = [m["omega"] for n in ("left", "right") for m in json.load(open(n + ".json"))["modes"]]
assert len(stick) == 8 and all(min(abs(m["omega"]/p - 1) for p in parts) < 1e-9 for m in stick), (stick, parts)
END
works "a rope that cannot stretch" modes "$sheave" --set cable.EA=.inf -n 4 --contact slip --json rigid.json -q
run modes "$sheave" --set cable.EA=1e15 -n 4 --contact slip --json nearly.json -q
python "  is the limit of a stiff one" <<'END'
import json
rigid, nearly = (json.load(open(n + ".json"))["modes"] for n in ("rigid", "nearly"))
assert all(abs(a["omega"]/b["omega"] - 1) < 1e-7 for a, b in zip(rigid, nearly)) and len(rigid) == 4
END
try "the picture names the contact" grep -q "obstacles: the rope slips" modes.svg
works "over the height of the circle" modes "$sheave" --over "obstacles.s0.circle.centre.1=-17 m:-5 m:7" --contact slip -n 4 \
	--json over.json --tsv over.tsv --plot over.svg -q
python "  frequencies are those of the scenes" <<'END'
import json
r, slip = json.load(open("over.json")), json.load(open("slip.json"))
assert r["swept"] == "obstacles.s0.circle.centre.1" and r["unit"] == "m" and "ended" not in r
s = r["stations"]
assert [x["value"] for x in s if not x["inserted"]] == [-17, -15, -13, -11, -9, -7, -5]
assert [s[0]["touched"], s[-1]["touched"]] == [0, 1]
assert all(abs(a["im"]/b["omega"] - 1) < 1e-9 for a, b in zip(sorted(s[-1]["eigenvalues"], key=lambda e: e["im"]), slip["modes"]))
assert {e["span"] for e in s[-1]["eigenvalues"]} == {"s0 to B"} and "lane" not in s[0]["eigenvalues"][0]
END
try "  where the rope comes to touch it is told" grep -q '^# between obstacles.s0.circle.centre.1 = -1[0-9.]* and -15.9[0-9]* m: 1 touched' over.tsv
try "  columns" grep -q '^obstacles.s0.circle.centre.1	branch	omega_rad_s	frequency_Hz	plane	span	span_share	residual$' over.tsv
denies "a key that is none" 1 "\-\-over obstacles.s0.circle.radus, at 1 m: unknown key obstacles.s0.circle.radus" modes "$sheave" \
	--over "obstacles.s0.circle.radus=1 m:2 m:3"
denies "a contact that is none" 1 "must be one of slip, stick" modes "$sheave" --contact roll
denies "stick without friction" 1 "has no friction, so that the rope does not stick to it" modes "$sheave" --set obstacles.s0.friction=0 --contact stick
denies "an option of ropeways" 1 "\-\-case is for ropeways" modes "$sheave" --case full
denies "an option of spans" 1 "is for spans and nets, and .* is a span over obstacles" modes "$sheave" --damped
for command in "frf" "rom" "integrate" "plan" "irvine" "campbell" "compare modes"; do
	denies "$command" 1 "b-table-3.5.yaml is a span over obstacles, which hawser .* does not take; these commands do: statics, modes" $command "$sheave"
done
denies "obstacles by --set" 1 "obstacles is a key of another kind of scenes (obstacles), and this one is read as a span" statics "$scenes/chairlift.yaml" --set "obstacles=[{circle: {centre: [1, 1], radius: 1}}]"
done_testing

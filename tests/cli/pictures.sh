#!/bin/sh
# Every picture in every format: made, of its kind, with units on its axes, and made the same twice.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

if ! command -v gnuplot >/dev/null; then
	skip "gnuplot is not installed"
	done_testing
	exit
fi

# draw NAME ARGUMENTS: PNG and PDF of two pictures only, the same picture twice of one a stage; of all with
# HAWSER_LONG
draw() {
	name=$1
	shift
	works "$name.svg" "$@" --plot "$name.svg" -q
	case $name in
		statics|modes) kinds="png pdf" ;;
		*) kinds=${HAWSER_LONG:+png pdf} ;;
	esac
	for kind in $kinds; do
		works "$name.$kind" "$@" --plot "$name.$kind" -q
		case $kind in
			png) try "$name.png is PNG" test "$(head -c 4 "$name.png" | od -An -c | tr -d ' ')" = '211PNG' ;;
			pdf) try "$name.pdf is PDF" test "$(head -c 4 "$name.pdf")" = %PDF ;;
		esac
	done
	case $name in
		statics|modes|waves|duffing) ;;
		*) [ -n "${HAWSER_LONG-}" ] || return 0 ;;
	esac
	works "$name to standard output" "$@" --plot -
	sed 's/^Produced by.*//' "$name.svg" >a
	sed 's/^Produced by.*//' "$scratch/out" | try "is the same SVG" diff - a
}

# What is looked for in the pictures, one check a line: the check, the picture's name, texts; done at the end by one
# python, whose start takes longer than a check.
ask() {
	printf '%s' "$1" >>"$scratch/asked"
	shift
	for word in "$@"; do printf '\t%s' "$word" >>"$scratch/asked"; done
	echo >>"$scratch/asked"
}

# shows NAME TEXT...: all of them are in the picture's text.
shows() {
	ask shows "$@"
}

# sound NAME: what viewers drop or clip: spaces at the ends of a text's elements are kept, no text stands
# on another or touches it (less than 0.4 em from end to end), and none leaves the picture. Letters have the
# widths of DejaVu Sans (in em), the widest of the usual fonts.
sound() {
	ask sound "$@"
}

# symbols NAME: no two kinds of points in the legend have the same symbol
symbols() {
	ask symbols "$@"
}

# look: the checks that were asked for
look() {
	if ! command -v python3 >/dev/null; then
		skip "python3 is not installed"
		return
	fi
	cat >"$scratch/look.py" <<'END'
import re, sys, xml.etree.ElementTree as tree
svg, space = "{http://www.w3.org/2000/svg}", "{http://www.w3.org/XML/1998/namespace}space"
narrow = {"ijl'|I": 0.29, " ,.:;/": 0.33, "ft()[]-–": 0.39, "r": 0.41, "sz": 0.53, "mMW%": 0.93, "w×=+<>": 0.83}
wide = {letter: em for letters, em in narrow.items() for letter in letters}

def shows(path, *texts):
    words = [" ".join("".join(t.itertext()).split()) for t in tree.parse(path).iter(svg + "text")]
    squeezed = "|".join(words).replace(" ", "")
    missing = [w for w in texts if w.replace(" ", "") not in squeezed]
    return missing and "not in %s: %s; there is %s" % (path, missing, squeezed)

def sound(path):
    root, wrong, boxes = tree.parse(path).getroot(), [], []
    width, height = (float(root.get(k)) for k in ("width", "height"))
    for g in root.iter(svg + "g"):
        text = g.find(svg + "text")
        if text is None:
            continue
        words = "".join(text.itertext())
        if text.get(space) != "preserve":
            wrong.append("loses spaces: " + words)
        at = re.match(r"translate\(([-0-9.]+),([-0-9.]+)\)(?: rotate\((-?[0-9]+))?", g.get("transform", ""))
        if not at or not words.strip():
            continue
        x, y, turn = float(at[1]), float(at[2]), at[3]
        size = float(g.get("font-size"))
        long = size*sum(wide.get(letter, 0.62) for letter in words.strip())
        back = {"start": 0, "middle": 0.5, "end": 1}[g.get("text-anchor")]*long
        box = ((x - back, y - 0.7*size, x - back + long, y) if not turn else
               (x - 0.7*size, y - long + back, x, y + back))
        if box[0] < 0 or box[1] < 0 or box[2] > width or box[3] > height:
            wrong.append("clipped: " + words)
        free = 0.2*size
        box = ((box[0] - free, box[1], box[2] + free, box[3]) if not turn else
               (box[0], box[1] - free, box[2], box[3] + free))
        for other, said in boxes:
            if box[0] < other[2] and other[0] < box[2] and box[1] < other[3] and other[1] < box[3]:
                wrong.append("%s on %s" % (words, said))
        boxes.append((box, words))
    return (not boxes or wrong) and "%s: %s" % (path, wrong or "no text")

def symbols(path):
    text, seen = open(path, encoding="utf-8").read(), {}
    for title, body in re.findall(r"<title>([^<]+)</title>(.*?)(?=<title>|\Z)", text, re.S):
        symbol = re.search(r"<use xlink:href='#(gpPt\d+)' [^>]*color='([^']*)'", body)
        if symbol and not title.startswith(("gnuplot", "$")):
            seen.setdefault(symbol.groups(), set()).add(title)
    return (not seen or any(len(titles) > 1 for titles in seen.values())) and "%s: %s" % (path, seen)

said = {"shows": "is well-formed and shows", "sound": "keeps spaces, clips nothing, overprints nothing",
        "symbols": "has a symbol for each kind of point"}
for line in open(sys.argv[1], encoding="utf-8"):
    kind, name, *texts = line.rstrip("\n").split("\t")
    try:
        why = {"shows": shows, "sound": sound, "symbols": symbols}[kind](name + ".svg", *texts)
    except Exception as error:
        why = repr(error)
    text = " ".join([name + ".svg", said[kind]] + texts)
    sys.stdout.buffer.write(("%d\t%s\t%s\n" % (bool(why), text, " ".join(str(why or "").split()))).encode())
END
	python3 -IS "$scratch/look.py" "$scratch/asked" >"$scratch/seen"
	try "every picture that was asked for was looked at" test "$(grep -c '' <"$scratch/seen")" -eq "$(grep -c '' <"$scratch/asked")"
	tab=$(printf '\t')
	while IFS=$tab read -r wrong text why; do
		printf '%s\n' "$why" >"$scratch/why"
		verdict "$wrong" "$text"
	done <"$scratch/seen"
}

draw statics statics "$chairlift"
sound statics
shows statics "Height y (m)" "Distance x (m)" "Tension T (kN)" chord cable
draw modes modes "$chairlift" -n 7
shows modes "Arclength S (m)" "axial P" "normal Q" "out of plane B" "1: 0.2307 Hz, out-of-plane" "7:" "P × "
# a caution in the legend
"$HAWSER" init stay >stay.yaml
run frf stay.yaml --from 20.2 --to 20.6 --plot beyond.svg -q
try "beyond the modes of the model" like 0 'the model knows no modes above'
shows beyond "beyond the modes of the model"
works "longitudinal modes" modes "$chairlift" -n 12 --set cable.EA="2.1 MN" --set tension.T0="100 kN" \
	--plot longitudinal.svg
shows longitudinal "longitudinal" "out-of-plane"
sound longitudinal
draw displaced modes "$chairlift" -n 3 --view profile
shows displaced "Distance x (m)" "at rest" "in the plane" "from above"
draw turning modes "$chairlift" -n 7 --set travel.hold=tension --set travel.speed="40 m/s"
shows turning "Arclength S (m)" "axial P" "normal Q" "out of plane B" real "imaginary part" "7:"
draw waves modes "$chairlift" -n 3 --set travel.hold=tension --set travel.speed="40 m/s" --view waves
shows waves "Leading component" "t = 0" "3/8 period" envelope downstream "upstream wave"
draw passing modes "$chairlift" -n 3 --set travel.hold=tension --set travel.speed="40 m/s" --view profile
shows passing "Distance x (m)" "steady state" "t = 0"
draw models statics "$chairlift" --models --points 40
sound models
shows models "Sag over span" "Relative error of sag" catenary inextensible parabola scene
draw curves statics "$chairlift" --compatibility --points 40
sound curves
shows curves "Weight ratio" "Elastic ratio" "Slope at end A" scene
works "compare.svg" compare modes "$chairlift" -n 1 --to 12 --plot compare.svg -q
shows compare "Time (ms); numbers: resolution" "Largest relative error of a frequency" spectral \
	"its own choice"
sound compare
works "fidelities" compare "$top/notebooks-data/scenes/b-table-4.5.yaml" --from 0.95w1 --to 1.1w1 \
	--fidelities "raw 1, condensed 1, condensed 2" --step 0.03 --plot fidelities.svg -q
shows fidelities "reference: condensed 2" "Frequency error of folds, peaks (–)" "raw (none found)"
sound fidelities
works "multiple scales" compare mms "$top/notebooks-data/scenes/b-table-4.5.yaml" -n 1 --levels 2 --step 0.05 \
	--set model.condense=static --plot scales.svg -q
shows scales "multiple scales, quarter-span" "multiple scales, mid-span"
sound scales
draw integrate integrate "$chairlift" --Omega 0.9w1 --until 12T
shows integrate "Time t (s)" "z, mid-span (m)" "y, mid-span (m)" "Velocity (m/s)" \
	"Frequency (Hz)" "Amplitude (m)" forcing
sound integrate
works "a small motion" integrate "$chairlift" --Omega 0.9w1 --until 5T --set 'load.per_length=[0, 0, 0.003]' \
	--plot small.svg -q
shows small "z, mid-span (mm)" "y, mid-span (µm)" "Velocity (mm/s)" "Amplitude (m)"
sound small
draw frf frf "$chairlift" --to 1.3w1
shows frf "Forcing frequency Ω (rad/s)" "Amplitude of z (m)" "Amplitude of y (m)" quarter-span \
	mid-span stable ω1
try "no unstable part, none in the legend" sh -c '! grep -q ">unstable *<" frf.svg'
draw duffing frf "$duffing" --from 0.5 --to 2
shows duffing "Amplitude of u1" "Forcing frequency Ω" fold stable unstable
try "a model without units shows none" sh -c '! grep -q rad/s duffing.svg'
works "with sweeps" frf "$duffing" --from 0.8 --to 1.5 --sweep both --sweep-points 20 \
	--plot sweep.svg --scale linear
shows sweep up-sweep down-sweep
sound sweep
symbols sweep
works "events that crowd" frf --unstable 9 "$chairlift" --plot crowd.svg -q
shows crowd "grey part, enlarged" fold torus peak
sound crowd
symbols crowd
try "a response without a crowd has no enlarged part" sh -c '! grep -q enlarged duffing.svg'
draw folds folds "$duffing" --from 0.8 --to 1.8 --starts 0
shows folds "Load, as a factor of the given one" "Forcing frequency Ω" "Amplitude of u1" cusp folds \
	"given load" stable unstable
try "no isola, none in the legend" sh -c '! grep -qE "isola|detached" folds.svg'
works "an isola" folds "$SRCDIR/tests/reference/absorber.json" --from 0.5 --to 3 --starts 0 --plot isola.svg
shows isola detached "isola centre" "curves join or part"

for name in modes displaced turning waves passing frf folds isola; do
	sound "$name"
done
works "steady states over the speed" statics "$top/notebooks-data/scenes/b-table-5.3.yaml" --speeds \
	--points 11 --plot speeds.svg -q
shows speeds "tension held: slack" "limit speed"
sound speeds
works "an Irvine diagram" irvine "$chairlift" -n 4 --points 40 --plot irvine.svg -q
shows irvine "Irvine parameter" "in plane" "out of plane" analytic
sound irvine

# without growth the Campbell diagram has no panels of zeros, and its colours are told
scenes=$top/notebooks-data/scenes
works "a Campbell diagram" campbell "$scenes/b-table-5.3.yaml" -n 2 --points 2 --spacing "60 m" \
	--set damping.ratio=0.01 --plot campbell.svg -q
shows campbell "in plane" "all real parts 0" "mode 1" excitation "limit speed"
try "no panel of zeros" sh -c '! grep -q "Real part" campbell.svg'
sound campbell

# a map's colours turn at the border of stability, and its axes name quantities
rough "a map" map "$scenes/b-table-5.4.yaml" -n 3 --x Omega=14:16 --y travel.fluctuation=0:8 \
	--quantity multiplier --points 12x12 --rest --plot map.svg -q
shows map "Amplitude of speed fluctuation V (m/s)" "Largest modulus of a multiplier (–)" stable unstable \
	"boundary of stability"
try "no raw key" sh -c '! grep -q "travel.fluctuation" map.svg'
sound map
try "browsers do not blur the colours" grep -q "<image style='image-rendering:pixelated' " map.svg

rough "a map of whole numbers" map "$scenes/b-table-5.4.yaml" -n 3 --x Omega=14:16 \
	--y travel.fluctuation=0:8 --quantity unstable --points 12x12 --rest --plot whole.svg -q
shows whole "Number of unstable multipliers (–)" unstable
try "the legend has the colour of the bar" sh -c \
	'[ "$(grep -ciE "fill *[=:] *.?rgb\( *241, *105, *19\)" whole.svg)" -ge 2 ]'
sound whole

# the unstable side is filled: polygons in that colour
works "Mathieu's plane" hill --mathieu --lines 3 --samples 60 --step 0.05 --plot mathieu.svg -q
shows mathieu unstable "multiplier +1" "characteristic values"
try "the unstable side is filled" sh -c '[ "$(grep -ci "fill *= *.rgb(246, *201, *168)" mathieu.svg)" -gt 50 ]'
sound mathieu

works "a tongue far narrower than the picture's rows are sampled" hill --mathieu --x delta=14:18 \
	--y epsilon=0:1 --lines 3 --samples 60 --step 0.05 --plot tongue.svg -q
shows tongue unstable
try "is not called stable" sh -c '! grep -qE "everywhere|no instability" tongue.svg'
works "a plane in which nothing was found" hill --mathieu --x delta=5:6 --y epsilon=0:0.2 --lines 3 \
	--samples 60 --plot calm.svg -q
shows calm "no instability found"

works "safe speeds" beam "$scenes/hoist-rope.yaml" --boundary beam.tension_end --from "5 kN" --to "40 kN" \
	--points 2 --basis 8 -n 2 --plot safe.svg -q
shows safe "Tension at the end (kN)" 40 "stable up to here"
try "no plain newtons" sh -c '! grep -q 40000 safe.svg'
sound safe
run beam "$scenes/d-figure-9.2.yaml" --vary beam.rho=0,10 --boundary beam.mu --from 5 --to 20 --points 2 --basis 8 \
	--plot weights.svg -q
try "boundaries of two beams are drawn (status $status)" test "$status" -eq 0
shows weights "ρ = 10, stable up to here" "Tension μ (–)" "Speed v (–)"
sound weights
works "motion of two beams" beam "$scenes/d-figure-9.10.yaml" --vary beam.v=3.26,3.297 --until 2 \
	--plot beams.svg -q
shows beams "v = 3.26" "Deflection y (–)" "Time t (–)"
sound beams
run beam "$scenes/d-figure-9.4.yaml" --to 3 -n 2 --points 20 --plot sweep9.svg -q
try "a beam's sweep is drawn (status $status)" test "$status" -eq 0
shows sweep9 "mode 1" "mode 2" "Imaginary part (–)" "Real part (–)"
sound sweep9

# in-plane load only: nothing moves in z, and no empty panel is drawn for it
works "a load in the plane" frf "$chairlift" --set 'load.per_length=[0, 0.8, 0]' --to 1.2w1 \
	--plot plane.svg
shows plane "Amplitude of y (m)"
try "no panel in which nothing moves" sh -c '! tr -d "\n" <plane.svg | grep -q "of *<[^>]*>z<"'

# names in a model file must not reach gnuplot as commands
cat >evil.json <<'END'
{"hawser_rom": 1, "n": 1, "D": [[0.05]], "K": [[1]], "labels": ["'; system \"touch pwned\"; '"],
 "harmonics": [{"k": 1, "phase": "cos", "omega_power": 0, "f": [0.18]}],
 "shapes": {"name": ["'; system \"touch pwned\"; '"], "s": [0.5], "tangent": [[1, 0]],
            "stretch": [1], "shape": [[[0, 1, 0]]], "slope": [[[0, 0, 0]]], "EA": 1}}
END
run frf evil.json --from 0.5 --to 2 --plot evil.svg
try "a hostile name is drawn or refused (status $status)" test "$status" -le 1
try "but not run" test ! -e pwned
run integrate evil.json --Omega 1 --plot evil2.svg
try "nor by integrate" test ! -e pwned
sed -e 's/"harmonics"/"C": [[0, 0, 0, 0, 0.1]], &/' -e 's/"name"/"names"/' evil.json >worse.json
run folds worse.json --from 0.8 --to 1.8 --starts 0 --plot evil3.svg
try "folds draws it (status $status)" test "$status" -eq 0
try "and does not run it either" test ! -e pwned
look
done_testing

#!/bin/sh
# hawser statics of ropeways: published and own numbers, worst values, load cases, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scenes=$SRCDIR/notebooks-data/scenes

works "B Tables 6.3 and 6.4" statics "$scenes/b-table-6.3.yaml" --json table.json -q
python "all 37 entries" <<'END2'
# B: Bertrand, 2022. Each column to half a unit of its last printed digit.
import json
result = json.load(open("table.json"))
T0 = "84 84 88.13 94.04 100.63 114.87 121.68 131.94 136.01".split()
L = "14.97 43.07 71.02 80.57 182.7 88.73 150.04 72.47 14.95".split()
eta = "-0.022 0.358 0.261 0.247 0.118 0.234 0.141 0.168 -0.013".split()
R = "1.84 -26.5 16.68 17.06 30.5 30.48 30.98 31.89 41.45 1.83".split()
entries = 0
def printed(got, text):
    global entries
    digit = 10.0**-len(text.partition(".")[2])
    assert abs(got - float(text)) <= 0.501*digit, (got, text)
    entries += 1
for span, a, b, c in zip(result["spans"], T0, L, eta):
    printed(span["T_from"]/1e3, a)
    printed(span["length0"], b)
    printed(span["eta"], c)
force = [result["reaction_bottom"]] + [t["reaction"] for t in result["towers"]] + [result["reaction_top"]]
for f, text in zip(force, R):
    printed(f[1]/1e3, text)
assert entries == 37
assert [t["battery"] for t in result["towers"]] == ["compression"] + 7*["support"]
END2

small=$scenes/ropeway-small.yaml
rough="--set ropeway.towers.p0.friction=0.03 --set ropeway.towers.p1.friction=0.03"
works "the small ropeway" statics "$small" --json small.json --tsv small.tsv --plot small.svg -q
works "  without carriers" statics "$small" --case empty --json bare.json -q
works "  with friction" statics "$small" $rough --json running.json -q
works "  the other way" statics "$small" $rough --sliding reverse --json reverse.json -q
works "  over the phases" statics "$small" --worst --phases 75 --json worst.json --tsv worst.tsv --plot worst.svg -q
python "numbers of an independent program" <<'END2'
# Computed by a program of other methods and without the weight of the rope on the sheaves, which its reactions
# lack, and which raises the friction.
import json, math
small, bare, running, reverse, worst = (json.load(open(n + ".json")) for n in
                                        ("small", "bare", "running", "reverse", "worst"))
def near(got, want, tolerance):
    assert abs(got - want) <= tolerance, (got, want)
def lacking(tower):
    """The force of the battery without the rope's weight on it."""
    return math.hypot(tower["T_in"]*math.cos(tower["angle_in"]) - tower["T_out"]*math.cos(tower["angle_out"]),
                      tower["T_in"]*math.sin(tower["angle_in"]) - tower["T_out"]*math.sin(tower["angle_out"]))
near(bare["length0"], 305.01722, 1e-5)
near(bare["T_top"], 86271.11, 0.05)
near(small["length0"], 305.36187, 1e-5)
near(small["T_top"], 91844.22, 0.1)
for result, R in ((bare, (4207.14, 8199.70)), (small, (14241.48, 20280.73))):
    for tower, want in zip(result["towers"], R):
        near(lacking(tower), want, 0.1)
near(running["T_top"], 92885, 8)
near(reverse["T_top"], 90804, 8)
near(running["drive"]["force"], 3853.8, 12)
near(running["drive"]["needed_friction"], 0.01349, 4e-5)
# 71 of 75 phases in that program: carriers near the points of contact are not among them
near(worst["worst"]["T_top"]["min"], 91573, 15)
near(worst["worst"]["T_top"]["max"], 93579, 30)
assert worst["worst"]["phases"] == 75 and len(worst["worst"]["towers"]) == 2
assert worst["phase"] == 18.3 and len(small["carriers"]) == 8 and len(small["down"]["carriers"]) == 8
own = running["drive"]
assert abs(own["force"] - (running["T_top"] - running["down"]["T_top"])) < 1e-9
assert abs(own["needed_friction"] - math.log(running["T_top"]/running["down"]["T_top"])/math.pi) < 1e-12
assert abs(own["margin"] + own["needed_friction"] - 0.2) < 1e-12
END2
try "a table of towers" test "$(grep -c '^[a-z]' small.tsv)" -eq 5
try "a table of worst values" grep -q '^lane	tower	T_max_N	T_max_phase_m' worst.tsv
try "the pictures" grep -q 'lane down' small.svg
try "  of worst values" grep -q 'least to largest over the phases' worst.svg

bouquet=$scenes/ropeway-bouquet.yaml
works "the Bouquet line" statics "$bouquet" --sliding rest --json bouquet.json -q
works "  running" statics "$bouquet" --json moves.json -q
set -- # a train of sheaves in place of each circle
for i in 1 2 3 4 5 6 7; do
	set -- "$@" --set "ropeway.towers.p$i.sheaves={count: 12, spacing: 0.4 m, radius: 0.15 m}"
done
works "  as trains of sheaves" statics "$bouquet" --sliding rest --json train.json -q "$@"
python "its tension, its reactions, equilibrium, the momentum of a running rope" <<'END2'
import json, math
rest, moves = json.load(open("bouquet.json")), json.load(open("moves.json"))
# an independent mesh, with its carriers at the nearest nodes: 115 790 N, and reactions without the weight of rope and
# carriers on the sheaves; one carrier is at p0
assert abs(rest["T_top"]/115790 - 1) < 5e-4
for tower, R in zip(rest["towers"], (-33.213, 15.582, 10.286, 18.424, 18.387, 19.474, 20.803, 32.182)):
    free = tower["T_in"]*math.sin(tower["angle_in"]) - tower["T_out"]*math.sin(tower["angle_out"])
    assert abs((free + (400*9.81 if tower["name"] == "p0" else 0))/1e3 - R) < 0.02, (free, R)
weight = 9.81*(4*rest["length0"] + 400*len(rest["carriers"]))
up = rest["reaction_bottom"][1] + rest["reaction_top"][1] + sum(t["reaction"][1] for t in rest["towers"])
assert abs(up/weight - 1) < 1e-10
train = json.load(open("train.json"))
assert abs(train["T_top"]/rest["T_top"] - 1) < 2e-4
for a, b in zip(train["towers"][1:], rest["towers"][1:]):
    assert abs(a["reaction"][1]/b["reaction"][1] - 1) < 0.02 and 1 < a["touches"] <= 12
    assert a["sheave_force"] < b["sheave_force"] and abs(a["wrap"] - b["wrap"]) < 0.5/12
assert abs(moves["counterweight"]["T0"] - (84000 + 64)/(1 - 64/40e6)) < 1e-6
assert moves["counterweight"]["force"] == 168000 and moves["T_top"] > rest["T_top"] > moves["down"]["T_top"]
END2
works "load cases" statics "$bouquet" --cases --phases 20 --tsv cases.tsv -q
try "  full, empty, up, down" test "$(sed -n 's/^\(full\|empty\|up\|down\)	.*/\1/p' cases.tsv | tr '\n' ' ')" = "full empty up down "
works "spans" statics "$small" --spans --tsv spans.tsv -q
try "  of both lanes" test "$(grep -c ' to ' spans.tsv)" -ge 6
works "a profile" statics "$small" --profile --tsv profile.tsv -q

# fixed carriages: the same rope length as the empty loop at this tension
python3 -S - "$small" >fixed.yaml <<'END2'
import sys
print(open(sys.argv[1]).read().replace("counterweight: 168 kN", "T_empty: 84 kN"))
END2
works "a fixed carriage" statics fixed.yaml --json fixed.json -q
works "  without carriers" statics fixed.yaml --case empty --json again.json -q
python "the loop keeps its length" <<'END2'
import json
fixed, again = json.load(open("fixed.json")), json.load(open("again.json"))
assert abs(fixed["loop0"] - again["loop0"]) < 1e-6 and abs(again["counterweight"]["T0"] - 84000) < 1
assert fixed["counterweight"]["T0"] > 90000 and fixed["counterweight"]["travel"] == 0
END2
works "  by its length" statics fixed.yaml --json length.json -q \
	--set "ropeway.bottom.tension={length0: $(python3 -S -c 'import json; print(repr(json.load(open("again.json"))["loop0"]))')}"
python "  the same state" <<'END2'
import json
a, b = json.load(open("fixed.json")), json.load(open("length.json"))
assert abs(a["T_top"]/b["T_top"] - 1) < 1e-6
END2

works "a plan" plan "$scenes/ropeway-gondola.yaml" --reproducible
try "  of a train" grep -q '^  trains of sheaves: 96 fixed sheaves$' "$scratch/out"
try "  and of its carriers" grep -q '^  carriers down: 20 of 650 kg' "$scratch/out"
denies "an option of the plans of spans" 1 "\-\-limit is for spans and nets, and .* is a ropeway" plan "$small" --limit 1
works "a plan as a table" plan "$small" --reproducible --tsv plan.tsv
try "the text stands in comments" grep -q '^# left out: bending stiffness of the rope: ' plan.tsv
try "the table has the lanes" sh -c 'tail -n 1 plan.tsv | grep -q "^down	2	8$"'
denies "a plan as JSON" 1 "the plan of a ropeway is a text" plan "$small" --json plan.json
denies "a battery that the rope does not press" 2 "case full, phase 18.3 m, lane up: .*p1" statics "$small" \
	--set ropeway.towers.p1.battery=compression
denies "a coefficient in per cent" 1 "towers.p0.friction: \"30\" is out of range: it must be from 0 to 10" statics "$small" \
	--set ropeway.towers.p0.friction=30
denies "too little tension" 2 "small.yaml: .*lane up: .*tension.counterweight = 2000 N sets" \
	statics "$small" --set "ropeway.bottom.tension={counterweight: 2 kN}"
denies "a tower that is too low" 2 "case full, phase 18.3 m, lane up: .*lifts off the support battery of tower p0, line 7, at (80, 5) m: it passes 4\.[0-9]* m above it" statics "$small" \
	--set 'ropeway.towers.p0.at=[80 m, 5 m]'
run statics "$small" --set 'ropeway.towers.p0.at=[80 m, 5 m]' --tolerate --json low.json -q
try "  is shown if it is to be" test "$status" -eq 0
try "  with a warning" grep -q "lane up: the rope does not press the battery of tower p0" "$scratch/err"
denies "a drive that slips" 2 "the rope slips on the drive bullwheel: .* drive.friction, line 5, is 0.005, 0.002096 too little" \
	statics "$small" --set ropeway.top.drive.friction=0.005
denies "a counterweight at its stop" 2 "the counterweight is at its stop: the carriage would be at 0.2565 m, 0.1565 m beyond" \
	statics "$small" --set 'ropeway.bottom.tension.travel=[-0.1 m, 0.1 m]'
denies "a phase of a sweep" 2 "case full, phase 0 m: the counterweight is at its stop" statics "$small" --worst \
	--set 'ropeway.bottom.tension.travel=[-0.1 m, 0.1 m]'
denies "too little tension" 2 "lane up: " statics "$small" --set 'ropeway.bottom.tension.counterweight=6 kN'
denies "a loop that is too long" 2 "the loop is too long" statics "$small" --set 'ropeway.bottom.tension={length0: 900 m}'
denies "a command of spans" 1 "is a ropeway, which hawser compare modes does not take" compare modes "$small"
denies "an option of spans" 1 "\-\-model is for spans, and .* is a ropeway" statics "$small" --model parabola
denies "an option of nets" 1 "\-\-method is for nets, and .* is a ropeway" statics "$small" --method cone
denies "an option of ropeways" 1 "\-\-worst is for ropeways, and .* is a span" statics \
	"$scenes/chairlift.yaml" --worst
denies "two tables" 1 "\-\-spans does not go with \-\-worst" statics "$small" --worst --spans
denies "an unknown case" 1 "must be one of full, empty, up, down" statics "$small" --case half
sed 's/battery: support, radius: 12 m}$/battery: support, radius: 12 m, frictoin: 0.1}/' "$small" >wrong.yaml
denies "an unknown key" 1 "wrong.yaml:7:.*unknown key towers.p0.frictoin: did you mean friction?" statics wrong.yaml
denies "a wrong unit" 1 'rope.EA: "40 m"' statics "$small" --set 'ropeway.rope.EA=40 m'
denies "towers out of order" 1 "give the towers by x" statics "$small" --set 'ropeway.towers.p1.at=[50 m, 40 m]'
denies "no place" 1 "towers.p1.at has 1 value, but must be a list of 2 numbers in m (\[x, y\] of the summit of its battery" statics "$small" \
	--set 'ropeway.towers.p1.at=[50 m]'
denies "two tensions" 1 "tension.T0 contradicts .*tension.counterweight in the same override" statics "$small" \
	--set 'ropeway.bottom.tension={counterweight: 168 kN, T0: 84 kN}'
works "  one in the place of the other" check "$small" --set 'ropeway.bottom.tension.T0=84 kN'
denies "a word" 1 '"sometimes" must be running, rest or reverse' statics "$small" --set ropeway.sliding=sometimes
denies "carriers without end" 1 "puts more than" statics "$small" --set 'ropeway.carriers.spacing=1 mm'
done_testing

#!/bin/sh
# hawser folds: the least load of three cables whose range cuts a branch, whichever end comes first.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# At 0.4 of the load frf has folds in this range, none of them at the full load.
cat >stay.yaml <<'END'
cable: {EA: 1800 MN, rho: 78}
span: {d: 180, h: 87}
tension: {T0: 5200 kN}
damping: {ratio: 0.2 %}
load: {frame: local, per_length: [0, 25, 18]}
END
cat >fibre.yaml <<'END'
cable: {EA: 40 kN, rho: 0.15}
span: {d: 30, h: 1.5}
tension: {H: 1.2 kN}
damping: {ratio: 0.6 %}
load: {frame: global, per_length: [0.05, 0.25, 0.3]}
END
cat >short.yaml <<'END'
cable: {EA: 90 kN, rho: 4 g/m}
span: {d: 0.5, h: 0.04}
tension: {T1: 30 N}
damping: {ratio: 0.4 %}
load: {frame: local, per_length: [0, 0.03, 0.02]}
END
works "a stay" folds stay.yaml -n 5 --from 0.9w1 --to 1.1w2 --no-isolas --json stay.json -q
# the third of a kind takes as long as the other two
[ -z "${HAWSER_LONG:-}" ] || works "a fibre rope" folds fibre.yaml -n 6 --from 0.9w1 --to 1.15w2 --no-isolas -q --json fibre.json
works "a short span" folds short.yaml -n 4 --from 0.9w1 --to 1.08w2 --no-isolas --json short.json --tsv short.tsv -q
works "a short span, from the other end" folds short.yaml -n 4 --from 1.08w2 --to 0.9w1 \
	--no-isolas --json trohs.json -q
python "the least loads, whichever end comes first" <<'END'
import json, os
r = {name: json.load(open(name + ".json")) for name in ("stay", "fibre", "short", "trohs") if os.path.exists(name + ".json")}
assert len(r) == 3 + bool(os.environ.get("HAWSER_LONG"))
for name, load, omega in (("stay", 0.10928966, 4.129865), ("fibre", 0.1779702, 9.6095665),
                          ("short", 0.15484598, 546.28084), ("trohs", 0.15484598, 546.28084)):
    if name not in r:
        continue
    assert abs(r[name]["least_load"] - load) < 1e-6*load, (name, r[name]["least_load"])
    assert abs(r[name]["least_Omega"] - omega) < 1e-6*omega, (name, r[name]["least_Omega"])
    assert r[name]["least_kind"] == "cusp" and r[name]["nearly_linear"], name
    below = [s for s in r[name]["searched"] if s["load"] < load]
    assert len(below) > 1 and all(s["folds"] == 0 for s in below), name
# the second pair of folds of the stay, too, which has left the range at the full load
assert sorted(round(c["least_load"], 6) for c in r["stay"]["curves"]) == [0.10929, 0.148698]
END
try "the table says what was searched" \
	grep -q '^# searched: load factor 0.150201, Omega .* rad/s, from both ends: 0 folds$' short.tsv
try "and where jumps begin" grep -q '^# jumps begin at load factor 0.154845.*(cusp)$' short.tsv
# A span that swings out of its plane in two ways, each nearly the mirror image of the other: the load in
# the plane tells them apart. Both are found, whatever the tolerance.
cp "$SRCDIR/notebooks-data/scenes/b-table-4.5.yaml" images.yaml
works "images" folds images.yaml --starts 0 --json images.json -q
works "images, more accurate" folds images.yaml --starts 0 --tolerance 1e-9 --json images-9.json -q
python "both isolas and both cusps beside them, by harmonic balance" <<'END'
import json
for name, tolerance in (("images", 1e-7), ("images-9", 1e-9)):
    r = json.load(open(name + ".json"))
    least = sorted(c["least_load"] for c in r["curves"])
    # by hawser frf, shooting with --tolerance 1e-12, from a motion on either isola at the load itself
    for fold in (1.6352312856337, 1.7587657188131, 1.6352367771680, 1.7587632273895):
        found = min(abs(e["Omega"]/fold - 1) for i in r["isolas"] for e in i["events"])
        assert found < tolerance, (name, fold, found)
    assert len(r["curves"]) == 7 and len(r["isolas"]) == 2, (name, least)
    assert len(set(round(l, 7) for l in least)) == 7, (name, least)
    # two curves nearly meet: their ends at the largest load, as by steps of a tenth, are not exchanged
    ends = sorted(sorted(c["points"][p]["Omega"] for p in (0, -1)) for c in r["curves"])
    for pair in ((1.5934816, 2.4450990), (2.0509397, 2.4905721)):
        assert any(max(abs(a - b) for a, b in zip(pair, end)) < 1e-6 for end in ends), (name, pair, ends)
    # hawser frf has as many at this load: no step crosses the gap of a broken pitchfork at Omega 1.644
    assert [s["folds"] for s in r["searched"] if s["load"] == 2.0] == [10] and not r["not_followed"], name
END
# without the load in the plane they are exact images, of one curve
works "exact images" folds images.yaml --starts 0 --load-to 1.5 --json exact.json -q \
	--set 'load.per_length=[0, 0, 0.3]'
python "which has none of its own" <<'END'
import json
least = sorted(c["least_load"] for c in json.load(open("exact.json"))["curves"])
assert all(b - a > 1e-6*a for a, b in zip(least, least[1:])), least
END

# the response at 0.4 of the load, to compare: the folds that the stay's curves pass there
works "the stay at 0.4 of its load" frf stay.yaml -n 5 --from 0.9w1 --to 1.1w2 --json frf.json -q \
	--set 'load.per_length=[0, 10, 7.2]'
python "it has four folds, all above the cusps" <<'END'
import json
folds = sorted(e["Omega"] for e in json.load(open("frf.json"))["events"] if e["kind"] == "fold")
assert len(folds) == 4 and abs(folds[0] - 4.1278) < 1e-3 and abs(folds[3] - 4.2762) < 1e-3, folds
END

# without damping every multiplier of a stable motion is on the unit circle: undecided, as in frf
cat >undamped.json <<'END'
{"hawser_rom":1,"n":1,"K":[[1]],"C":[[0,0,0,0,0.1]],"harmonics":[{"k":1,"f":[0.1]}]}
END
works "a model without damping" folds undamped.json --from 1.6 --to 0.8 --load-from 0.5 --load-to 1.5 -q \
	--json circle.json
works "its response by frf" frf undamped.json --from 1.6 --to 0.8 --method balance --step 0.02 -q \
	--json curve.json
python "says at which points stability is undecided" <<'END'
import json
points = json.load(open("circle.json"))["response"]["points"]
curve = json.load(open("curve.json"))["points"]
for rows in (points, curve):
    assert all(p["undecided"] == (2 if p["unstable"] == 0 else 0) for p in rows), rows[0]
    assert len({p["unstable"] for p in rows}) == 2
END

# A closed curve none of whose folds is on a fold curve from the responses: outside use found it from random
# states, 1.014 to 2.095. The motion is checked by Runge and Kutta's method.
cat >isola.json <<'END'
{"hawser_rom": 1, "n": 2, "K": [[1.0, 0.0], [0.0, 9.428]], "D": [[0.01843, 0.0], [0.0, 0.08047]],
"Q": [[1, 1, 1, -0.2757], [1, 1, 1, -0.2757], [1, 1, 1, -0.2757], [0, 0, 1, -0.3195], [0, 0, 1,
-0.3195], [1, 0, 0, -0.3195], [0, 1, 1, 0.4488], [1, 0, 1, 0.4488], [1, 0, 1, 0.4488], [0, 1, 1,
0.0004991], [1, 0, 1, 0.0004991], [1, 0, 1, 0.0004991]], "C": [[0, 0, 0, 0, 0.0211], [0, 0, 1, 1,
0.09948], [0, 0, 0, 0, 0.1086], [1, 1, 0, 0, 0.09948], [1, 1, 1, 1, 1.876], [1, 1, 1, 1, 0.1086]],
"harmonics": [{"k": 1, "f": [0.1, 0.1123]}, {"k": 2, "K": [[-0.295, 0.0], [0.0, 0.1764]]}]}
END
works "a large isola" folds isola.json --from 0.9 --to 2.3 --load-from 0.9 --load-to 1.01 --starts 12 -q \
	--json isola-found.json --tsv isola.tsv
works "without the search" folds isola.json --from 0.9 --to 2.3 --load-from 0.9 --load-to 1.01 --starts 0 -q \
	--json isola-none.json --tsv none.tsv
python "is found by pseudo-random motions only" <<'END'
import json, math
model, found = json.load(open("isola.json")), json.load(open("isola-found.json"))
isola, = found["isolas"]
omega = [p["Omega"] for p in isola["points"]]
assert isola["end"] == "curve closed" and abs(min(omega) - 1.014) < 1e-3 and abs(max(omega) - 2.095) < 1e-3
search = found["isola_search"]
assert search["starts"] == 12 and search["frequencies"] == 3 and search["found"] == 1, search
assert search["known"] + search["lost"] < 12
assert json.load(open("isola-none.json"))["isolas"] == []
point = next(p for p in isola["points"] if p["stable"])
W, x = point["Omega"], point["state"]
def slope(t, x):
    a = [f*math.cos(W*t) for f in model["harmonics"][0]["f"]]
    for i in range(2):
        for j in range(2):
            a[i] -= model["K"][i][j]*x[j] + model["D"][i][j]*x[2 + j]
            a[i] -= model["harmonics"][1]["K"][i][j]*x[j]*math.cos(2*W*t)
    for i, j, k, c in model["Q"]:
        a[i] -= c*x[j]*x[k]
    for i, j, k, l, c in model["C"]:
        a[i] -= c*x[j]*x[k]*x[l]
    return x[2:] + a
h = 2*math.pi/W/1000
y = x
for n in range(1000):
    a = slope(n*h, y)
    b = slope((n + 0.5)*h, [p + h/2*q for p, q in zip(y, a)])
    c = slope((n + 0.5)*h, [p + h/2*q for p, q in zip(y, b)])
    d = slope((n + 1)*h, [p + h*q for p, q in zip(y, c)])
    y = [p + h/6*(A + 2*B + 2*C + D) for p, A, B, C, D in zip(y, a, b, c, d)]
assert max(abs(p - q) for p, q in zip(x, y)) < 1e-6, (x, y)
END
python "a motion of it" <<'END'
import json
point = next(p for p in json.load(open("isola-found.json"))["isolas"][0]["points"] if p["stable"])
json.dump({"state": point["state"]}, open("isola-state.json", "w"))
open("isola-omega", "w").write(repr(point["Omega"]))
END
works "its response" frf isola.json --start isola-state.json --at "$(cat isola-omega)" --from 0.9 --to 2.3 --json isola-frf.json -q
works "its folds" folds isola.json --from 0.9 --to 2.3 --load-from 0.1 --load-to 1.2 --from-label isola-frf.json#1 \
	--json isola-folds.json --tsv isola-folds.tsv -q
works "a map with it" map isola.json --quantity amplitude --x Omega=0.9:2.3 --y factor.load=0.9:1.1 --points 15x3 \
	--from-label isola-frf.json#1 --json isola-map.json -q
works "and without" map isola.json --quantity amplitude --x Omega=0.9:2.3 --y factor.load=0.9:1.1 --points 15x3 \
	--json isola-not.json -q
python "where the detached curve is, the map has two responses more" <<'END'
import json
load = lambda name: json.load(open(f"isola-{name}.json"))
curve, = load("folds")["curves"]
assert [e["kind"] for e in curve["events"] if e["kind"] != "nominal"] == ["isola-centre"], curve["events"]
nominal = sorted(e["Omega"] for e in curve["events"] if e["kind"] == "nominal")
ends = sorted(e["Omega"] for e in load("frf")["events"] if e["kind"] == "fold")
assert len(nominal) == 2 and all(abs(a/b - 1) < 1e-8 for a, b in zip(nominal, ends)), (nominal, ends)
folds = [(p["load"], p["Omega"]) for p in curve["points"]]
assert "# folds: those of the response through isola-frf.json#1 only" in open("isola-folds.tsv").read()
more = 0
for (x, y), a, b in zip(((x, y) for y in (0.9, 1.0, 1.1) for x in [0.9 + 0.1*i for i in range(15)]),
                        load("map")["points"]["branches"], load("not")["points"]["branches"]):
    if y == 1.0:
        assert a - b == (2 if ends[0] < x < ends[1] else 0), (x, y, a, b)
    more += a > b
assert 30 <= more <= 33, more
END
refuses 1 "--from-label isola-frf.json#1: that motion is at Omega = 1.13333333, which is not in the range: give a range that has it" \
	map isola.json --quantity amplitude --x Omega=1.5:2.3 --y factor.load=0.9:1.1 --from-label isola-frf.json#1
refuses 1 "--from-label is for the quantity amplitude: the quantity basin is of one response" \
	map isola.json --quantity basin --x u1=0:1 --y u2=0:1 --Omega 1 --from-label isola-frf.json#1
cat >hardly.json <<'END'
{"hawser_rom": 1, "n": 1, "D": [[0.05]], "K": [[1]], "C": [[0, 0, 0, 0, 0.1]], "harmonics": [{"k": 1, "f": [0.01]}]}
END
works "a response without folds" frf hardly.json --from 0.6 --to 3 --json hardly-frf.json -q
refuses_like 2 "the response through that motion has no fold between Omega 0.6 and 3 at the model's own load" \
	folds hardly.json --from 0.6 --to 3 --from-label hardly-frf.json#1
refuses_like 3 "no fold was found, but the response at load factor 1 ended at Omega 0.6" \
	folds hardly.json --from 0.6 --to 3 --from-label hardly-frf.json#1 --max-points 5
refuses_like 3 "; and further gaps: raise --max-points" folds hardly.json --max-points 5
try "the table says what was searched" grep -q '^# isolas: looked for by 12 pseudo-random motions at 3 ' isola.tsv
try "or that nothing was" grep -q '^# isolas: not looked for by pseudo-random motions' none.tsv
done_testing

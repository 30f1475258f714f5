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
works "a fibre rope" folds fibre.yaml -n 6 --from 0.9w1 --to 1.15w2 --no-isolas -q \
	--json fibre.json --tsv fibre.tsv
works "a short span" folds short.yaml -n 4 --from 0.9w1 --to 1.08w2 --no-isolas --json short.json -q
works "a short span, from the other end" folds short.yaml -n 4 --from 1.08w2 --to 0.9w1 \
	--no-isolas --json trohs.json -q
python "the least loads, whichever end comes first" <<'END'
import json
r = {name: json.load(open(name + ".json")) for name in ("stay", "fibre", "short", "trohs")}
for name, load, omega in (("stay", 0.10928966, 4.129865), ("fibre", 0.1779702, 9.6095665),
                          ("short", 0.15484598, 546.28084), ("trohs", 0.15484598, 546.28084)):
    assert abs(r[name]["least_load"] - load) < 1e-6*load, (name, r[name]["least_load"])
    assert abs(r[name]["least_Omega"] - omega) < 1e-6*omega, (name, r[name]["least_Omega"])
    assert r[name]["least_kind"] == "cusp" and r[name]["nearly_linear"], name
    below = [s for s in r[name]["searched"] if s["load"] < load]
    assert len(below) > 1 and all(s["folds"] == 0 for s in below), name
# the second pair of folds of the stay, too, which has left the range at the full load
assert sorted(round(c["least_load"], 6) for c in r["stay"]["curves"]) == [0.10929, 0.148698]
END
try "the table says what was searched" \
	grep -q '^# searched: load factor 0.172631, Omega .* rad/s, from both ends: 0 folds$' fibre.tsv
try "and where jumps begin" grep -q '^# jumps begin at load factor 0.17797.*(cusp)$' fibre.tsv
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
done_testing

#!/bin/sh
# Own models from the command line: parameters with --set and --over, and what refuses them.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >named.json <<'JSON'
{"hawser_rom": 1, "n": 1, "parameters": {"eps": 0.1, "F": 0.18}, "K": [[1]], "D": [[0.05]],
 "C": [[0, 0, 0, 0, "eps"]], "harmonics": [{"k": 1, "f": ["F"]}]}
JSON
sed 's/"C": \[\[0, 0, 0, 0, "eps"\]\]/"terms": [[0, [0, 0, 0], [], "eps"]]/' named.json >terms.json
sed 's/"eps"\]/0.37]/; s/"parameters.*0.18}, //; s/"F"/0.18/' named.json >plain.json
for model in named terms; do
	run frf $model.json --over eps=0.02:0.56 --Omega 1.2 --json $model-over.json --tsv - -q
	try "$model over eps" said 0
	grep "event: fold" "$scratch/out" | sed "s/.*eps = \([^ ]*\).*/\1/; q" >fold
	works "$model with another eps" frf $model.json --set eps=0.37 --from 0.8 --to 2.2 --json $model-set.json -q
done
works "named over F" frf named.json --over F=0.05:0.45 --Omega 1.2 --json named-F.json -q
works "the same written out" frf plain.json --from 0.8 --to 2.2 --json plain-set.json -q
try "the parameter at a fold" test -s fold
works "and its response" frf named.json --set eps="$(cat fold)" --from 1 --to 2.5 --json there.json -q
works "a model with numbers for its parameters" rom terms.json --set F=0.3 --json written.json -q
python "agree" <<'PY'
import json
def events(name, key):
    return [(e["kind"], e[key]) for e in json.load(open(name))["events"]]
def same(a, b, tolerance):
    assert len(a) == len(b) and len(a) == 2, (a, b)
    for (k, x), (l, y) in zip(a, b):
        assert k == l and abs(x/y - 1) < tolerance, (a, b)
same(events("named-set.json", "Omega"), events("plain-set.json", "Omega"), 1e-9)
same(events("terms-set.json", "Omega"), events("plain-set.json", "Omega"), 1e-8)
same(events("named-over.json", "parameter"), events("terms-over.json", "parameter"), 1e-8)
# of both parameters, eps F^2 alone matters
same([(k, 0.1*F*F/0.18**2) for k, F in events("named-F.json", "parameter")], events("terms-over.json", "parameter"), 1e-8)
assert min(abs(w/1.2 - 1) for k, w in events("there.json", "Omega")) < 1e-8
assert json.load(open("written.json"))["harmonics"][0]["f"] == [0.3]
PY

# --- nothing excites it ---

cycles=$SRCDIR/tests/reference/autonomous
works "equilibria and limit cycles" frf "$cycles/adaptx.json" --over a=1.1:0.9 --branches 1 --json cycles.json -q
python "the Hopf point, its cycles, and where they end" <<'END'
import json, math
result = json.load(open("cycles.json"))
event, branch = result["events"][0], result["branches"][0]
assert event["kind"] == "hopf" and abs(event["parameter"] - 1) < 1e-9 and abs(event["l1"] + 0.3) < 1e-9, event
assert abs(2*math.pi/branch["points"][-1]["Omega"] - 6.306235057458) < 1e-7, branch["points"][-1]
assert branch["points"][-1]["trivial"] < 1e-8 and branch["born_at"] == event["parameter"]
END
echo '{"state": [1, 0]}' >state.json
works "a limit cycle from a state" frf "$cycles/vdp.json" --over mu=1:1.1 --start state.json --json vdp.json -q
refuses 1 "limit cycles are followed by shooting or by harmonic balance: leave out --method" \
	frf "$cycles/vdp.json" --over mu=-1:1 --method multiple-scales
echo '[0.5, 0.1, 0.1, 0.5]' >start.json
refuses_like 1 "limit cycles of a model that may be rotated are followed by shooting" \
	frf "$cycles/o2.json" --over mu=0.3:0.5 --start start.json --method balance
refuses_like 1 "the model has no forcing: .* with --over KEY=FROM:TO" frf "$cycles/vdp.json"

refuses 1 "--set ep=1: named.json has these parameters: eps, F" frf named.json --set ep=1
refuses 1 "--set eps=1 kg: write NAME=NUMBER for a parameter of a model file" frf named.json --set "eps=1 kg"
refuses 1 "named.json has no parameter ep; its parameters are: eps, F" frf named.json --over ep=1:2 --Omega 1
only="takes models with D, K, Q and C only; this one has terms besides, which hawser frf, hawser integrate, hawser locus (--over a \
parameter, --kind fold and others) and hawser map --quantity amplitude take"
refuses 1 "a search for folds $only" folds terms.json --from 1 --to 2
refuses 1 "the method of multiple scales $only" mms terms.json
refuses 1 "a backbone $only" frf terms.json --backbone 1
refuses 1 "this method for orbits $only" frf terms.json --method multiple-scales
works "terms by balance" frf terms.json --over F=0.05:0.45 --Omega 1.2 --method balance --json balance-F.json -q
python "agree with shooting" <<'PY'
import json
a, b = ([(e["kind"], e["parameter"]) for e in json.load(open(f"{name}-F.json"))["events"]]
        for name in ("balance", "named"))
assert len(a) == 2 and all(k == l and abs(x/y - 1) < 1e-8 for (k, x), (l, y) in zip(a, b)), (a, b)
PY
refuses 1 "a map or the stability of rest $only" hill terms.json --x Omega=1:2 --y factor.load=0.5:1
refuses 1 "a map or the stability of rest $only" map terms.json --x Omega=1:2 --y factor.load=0.5:1
refuses 1 "the stability of rest $only" hill terms.json --Omega 1.1 --rest
for model in named terms; do
	works "locus of $model" locus $model.json --kind fold --over F=0.01:0.3 --at 0.18 --from 0.8 --to 2.2 --json $model-locus.json -q
done
rayleigh=$top/notebooks-data/scenes/rayleigh.json
works "a locus of torus points with velocities cubed" locus "$rayleigh" --kind torus --over F=0.4:0.6 --at 0.5 --near 1.23 \
	--from 0.5 --to 2 --json torus-locus.json -q
works "and one of its points" frf "$rayleigh" --set F=0.6 --from 1.1 --to 1.5 --json torus-frf.json -q
cat >general.json <<'JSON'
{"n": 1, "parameters": {"a": 0.3}, "K": [[1]], "D": [[0.05]],
 "terms": [[0, [0, 0, 0], [], "a"], [0, [], [0, 0, 0], 0.1], [0, [0, 0, 0, 0, 0], [], 0.2]],
 "harmonics": [{"k": 1, "K": [[-0.3]], "f": [0.05]}]}
JSON
works "doublings that change from sub- to supercritical" locus general.json --kind period-doubling --over a=-0.1:0.1 --at 0.1 \
	--from 1.6 --to 2.5 --json general-locus.json -q
for a in -0.029054276161 -0.027054276161; do
	[ -n "${HAWSER_LONG:-}" ] || continue
	works "its response" frf general.json --set a=$a --from 1.6 --to 2 --json general-frf.json -q
	label=$(python3 -S -c "import json; print([e['label'] for e in json.load(open('general-frf.json'))['events']][0])")
	works "the normal form" orbit general.json --from-label "general-frf.json#$label" --set a=$a --json form$a.json -q
done
if [ -n "${HAWSER_LONG:-}" ]; then
	duffing=$top/notebooks-data/scenes/parametric-duffing.json
	works "tori that change from super- to subcritical" locus "$duffing" --kind torus --over mu=0.01:0.3 --at 0.3 \
		--from 1.3851 --to 2.2507 --json chenciner.json -q
	for at in 0.99 1.01; do
		mu=$(python3 -S -c "import json
print([repr($at*e['parameter']) for c in json.load(open('chenciner.json'))['curves'] for e in c['events'] if e['kind'] == 'chenciner'][0])")
		works "a response beside it" frf "$duffing" --set "mu=$mu" --from 1.7 --to 1.8 --json beside.json -q
		label=$(python3 -S -c "import json
print([e['label'] for e in json.load(open('beside.json'))['events'] if e['kind'] == 'torus'][0])")
		works "its normal form" orbit "$duffing" --from-label "beside.json#$label" --set "mu=$mu" --json "torus-$at.json" -q
	done
	python "the coefficient of the period map is zero between them" <<'PY'
import json
a, b = (json.load(open(f"torus-{at}.json"))["orbit"]["normal_form"]["coefficient"] for at in ("0.99", "1.01"))
assert a < -4e-5 and b > 4e-5 and abs(a + b) < 2e-6, (a, b)
PY
fi
python "loci of terms are those of tensors, and of responses" <<'PY'
import glob, json
load = lambda name: json.load(open(name + ".json"))
for a, b in zip(load("named-locus")["curves"], load("terms-locus")["curves"], strict=True):
    assert [e["kind"] for e in a["events"]] == [e["kind"] for e in b["events"]] and "cusp" in [e["kind"] for e in a["events"]]
    for x, y in zip(a["events"], b["events"]):
        assert abs(x["Omega"]/y["Omega"] - 1) < 1e-9 and abs(x["parameter"]/y["parameter"] - 1) < 1e-8, (x, y)
ends = [p["Omega"] for c in load("torus-locus")["curves"] for p in c["points"] if abs(p["parameter"] - 0.6) < 1e-12]
torus = [e["Omega"] for e in load("torus-frf")["events"] if e["kind"] == "torus"]
assert len(ends) == 1 and min(abs(w/ends[0] - 1) for w in torus) < 1e-8, (ends, torus)
found = [e["parameter"] for c in load("general-locus")["curves"] for e in c["events"] if e["kind"] == "generalised-period-doubling"]
assert len(found) == 2 and abs(found[0] + 0.028054276) < 1e-6 and abs(found[1] - 0.045278095) < 1e-6, found
# the coefficient of the period map, which shares no code with the locus, is zero there
forms = sorted(json.load(open(name))["orbit"]["normal_form"]["coefficient"] for name in glob.glob("form-*.json"))
assert not forms or abs(sum(forms)) < 1e-6 and forms[1] > 3e-3, forms
PY
for format in auto coco matcont bifurcationkit; do
	works "terms for $format" rom terms.json --export $format "to_$format" -q
done
refuses 1 "\"2x\" can't name a function: use a letter, then up to 59 letters, digits and _" \
	rom terms.json --export coco 2x
refuses 1 "only models with polynomial equations and periodic forces are exported: this one has the exact strain energy: \
take model.energy: quartic" rom "$chairlift" --set model.energy=exact --set model.basis=3 --export coco x
refuses 1 "only models with polynomial equations and periodic forces are exported: this one has a ramp \
(travel.braking)" rom "$top/notebooks-data/scenes/b-table-4.2.yaml" -n 2 \
	--set "travel={speed: 5 m/s, hold: tension, final: 4 m/s, braking: 10 s}" --export matcont x
cat >first.json <<'JSON'
{"hawser_rom": 1, "n": 2, "first_order": true, "parameters": {"A": 0.4, "B": 1.2, "a": 0.05},
 "K": [["B + 1", 0], ["-B", 0]], "terms": [[0, [0, 0, 1], [], -1], [1, [0, 0, 1], [], 1]],
 "harmonics": [{"k": 0, "f": ["A", 0]}, {"k": 1, "f": ["a", 0]}]}
JSON
echo '{"hawser_rom": 1, "n": 1, "first_order": true, "K": [[1]], "harmonics": [{"k": 1, "f": [1]}]}' >linear.json
works "a Brusselator" integrate first.json --Omega 0.8 --until 100T --every 100T --json first-time.json -q
run frf first.json --from 3 --to 2.5 --json first-response.json -q
try "its response, of which no motion is stable" like 0 'stability: none of these [0-9]* motions is stable'
works "over B" frf first.json --Omega 3 --over B=1.14:1.18 --json first-over.json -q
works "with half the load" frf first.json --set a=0.025 --Omega 3 --over B=1.14:1.18 --json first-half.json -q
python "its Hopf bifurcation at B = 1 + A^2 is a torus point, which the load moves by its square" <<'PY'
import json
run = json.load(open("first-time.json"))
assert max(abs(x) for x in run["states"][-1]) < 10
moved = []
for name in ("first-over.json", "first-half.json"):
    torus = [e["parameter"] for e in json.load(open(name))["events"] if e["kind"] == "torus"]
    assert len(torus) == 1, torus
    moved.append(torus[0] - 1.16)
assert 0 < moved[0] < 0.003 and abs(moved[0]/moved[1] - 4) < 0.02, moved
PY
refuses 1 "a model of first_order has no damping that factor.damping multiplies: name a number of the file as a parameter" \
	frf first.json --over factor.damping=1:2 --Omega 1
refuses 1 "--from 0.6w1: the model has no natural frequency; write a number" frf first.json
refuses 1 "a model of first_order has no free undamped motions" frf linear.json --from 1 --to 2 --backbone 1
cat >half.json <<'JSON'
{"hawser_rom": 1, "n": 1, "periods": 2, "K": [[1]], "D": [[0.05]], "C": [[0, 0, 0, 0, 0.1]],
 "harmonics": [{"k": 2, "f": [0.18]}, {"k": 3, "f": [0.1]}]}
JSON
works "two periods" frf half.json --from 1 --to 1.1 --json half-response.json -q
works "written" rom half.json --json half-again.json -q
python "in the frequency of the user" <<'PY'
import json
result = json.load(open("half-response.json"))
assert abs(result["points"][0]["Omega"] - 1) < 1e-12 and abs(result["points"][-1]["Omega"] - 1.1) < 1e-12
assert json.load(open("half-again.json"))["periods"] == 2
PY
more="takes models of one period, and this one has periods 2: write the harmonics as multiples of Omega/2, and give \
frequencies of that"
refuses 1 "a search for folds $more" folds half.json --from 1 --to 2
refuses 1 "the method of multiple scales $more" mms half.json --mode 1
refuses 1 "an export $more" rom half.json --export auto x
refuses 1 "an export $more" rom half.json --export coco x
refuses 1 "a map or the stability of rest $more" map half.json --x Omega=1:2 --y factor.load=0.5:1
refuses 1 "the stability of rest $more" hill half.json --Omega 1.1 --rest
refuses 1 "the search for Lyapunov exponents $more" \
	integrate half.json --Omega 1.1 --until 200T --every 1T --lyapunov
done_testing

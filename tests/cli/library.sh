#!/bin/sh
# hawser frf and integrate with --model-library: examples/duffing.c, against the model file.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

if ! command -v "${CC%% *}" >/dev/null 2>&1 && ! command -v cc >/dev/null 2>&1; then
	skip "no compiler here"
	done_testing
	exit
fi
build() {
	${CC:-cc} -shared -fPIC -O2 -Wall -Wextra -Werror -std=c11 "-I$top/include" "$1" -o "$2" -lm
}
try "the example compiles" build "$top/examples/duffing.c" duffing.so
sed 's/return &plugin/return plugin.n ? NULL : \&plugin/' "$top/examples/duffing.c" >none.c
sed 's/hawser_plugin(void)/some_plugin(void)/' "$top/examples/duffing.c" |
	sed 's/^const struct hawser_plugin \*some/const struct hawser_plugin *some_plugin(void);\n&/' >unnamed.c
sed 's/-1.0 - 3.0/-1.0 - 2.0/' "$top/examples/duffing.c" >wrong.c
for name in none unnamed wrong; do
	try "and $name" build $name.c $name.so
done
cat >duffing.json <<'JSON'
{"hawser_rom": 1, "n": 1, "parameters": {"eps": 0.1, "F": 0.18}, "K": [[1]], "D": [[0.05]], "C": [[0, 0, 0, 0, "eps"]],
 "harmonics": [{"k": 1, "f": ["F"]}]}
JSON
works "its response" frf --model-library duffing.so --from 0.5 --to 2 --set eps=0.2 --json response.json -q
works "over a parameter" frf --model-library ./duffing.so --over eps=0.02:1 --Omega 1.2 --json over.json -q
works "in time" integrate --model-library duffing.so --Omega 1.1 --until 20 --every 20 --rtol 1e-12 --json time.json -q
works "of the file" frf duffing.json --from 0.5 --to 2 --set eps=0.2 --method shooting --json file-response.json -q
works "of the file over a parameter" frf duffing.json --over eps=0.02:1 --Omega 1.2 --method shooting \
	--json file-over.json -q
works "of the file in time" integrate duffing.json --Omega 1.1 --until 20 --every 20 --rtol 1e-12 --json file-time.json -q
python "agree" <<'PY'
import json
def events(name, key):
    return [(e["kind"], e[key]) for e in json.load(open(name))["events"]]
for name, key in (("response", "Omega"), ("over", "parameter")):
    a, b = events(name + ".json", key), events("file-" + name + ".json", key)
    assert len(a) == len(b) == 2, (a, b)
    for (k, x), (l, y) in zip(a, b):
        assert k == l == "fold" and abs(x/y - 1) < 1e-9, (a, b)
a, b = (json.load(open(n))["states"][-1] for n in ("time.json", "file-time.json"))
assert max(abs(x - y) for x, y in zip(a, b)) < 1e-10, (a, b)
PY

sed 's/{0.05, 0.1, 0.18}/{0.4, -1.0, 0.25}/; s/u\[0\]\*u\[0\]\*u\[0\];/u[0]*u[0];/; s/3.0\*p\[EPS\]\*u\[0\]\*u\[0\]/2.0*p[EPS]*u[0]/' \
	"$top/examples/duffing.c" >cascade.c
try "a quadratic one" build cascade.c cascade.so
echo '{"n": 1, "K": [[1]], "D": [[0.4]], "Q": [[0, 0, 0, -1]], "harmonics": [{"k": 1, "f": [0.25]}]}' >cascade.json
works "its branches" frf --model-library cascade.so --from 1.6 --to 0.7 --step 0.01 --branches 3 --json branches.json -q
works "those of the file" frf cascade.json --from 1.6 --to 0.7 --step 0.01 --branches 3 --method shooting \
	--json file-branches.json -q
works "from a label" frf --model-library cascade.so --from 1.6 --to 0.7 --step 0.01 --from-label branches.json#16 \
	--json label.json -q
python "agree" <<'PY'
import json
own, file, label = (json.load(open(name)) for name in ("branches.json", "file-branches.json", "label.json"))
assert [b["period"] for b in own["branches"]] == [b["period"] for b in file["branches"]] == [2, 4, 8]
for a, b in zip([own] + own["branches"], [file] + file["branches"]):
    assert abs(a["events"][0]["Omega"]/b["events"][0]["Omega"] - 1) < 1e-9
assert label["period"] == 2 and own["parameters"]["delta"] == 0.4
PY
refuses 1 "--from-label branches.json#16: that is a result of another model, with another value of delta" \
	frf --model-library cascade.so --from 1.6 --to 0.7 --set delta=0.3 --from-label branches.json#16

refuses_like 1 "--model-library nothing.so: .*nothing.so" frf --model-library nothing.so
refuses 1 "--model-library unnamed.so does not define hawser_plugin(), which hawser/plugin.h describes" \
	frf --model-library unnamed.so
refuses 1 "none.so: its function hawser_plugin returned no struct hawser_plugin" \
	frf --model-library none.so
refuses_like 1 "wrong.so: by_u\[0\]\[0\] of its function is .*: correct the derivative" frf --model-library wrong.so
refuses 1 "--model-library duffing.so is the model, and so is duffing.json: give one of them" \
	frf duffing.json --model-library duffing.so
refuses 1 "duffing.so is a library: --modes applies to scenes only" frf --model-library duffing.so -n 3
refuses 1 "--set size=3: duffing.so has these parameters: delta, eps, F" \
	frf --model-library duffing.so --set size=3
refuses 1 "duffing.so has no parameter size; its parameters are: delta, eps, F" \
	frf --model-library duffing.so --over size=3:4 --Omega 1
only="takes models with D, K, Q and C only; this one is a function, which hawser frf (by shooting), hawser integrate, hawser locus \
(--over a parameter, --kind fold and others) and hawser map --quantity amplitude take"
refuses 1 "a factor of load or damping $only" frf --model-library duffing.so --over factor.load=1:2 --Omega 1
refuses 1 "a backbone $only" frf --model-library duffing.so --from 0.5 --to 1 --backbone 1
refuses_like 1 "unknown option --model-library" folds --model-library duffing.so
refuses 1 "a locus of resonances $only" locus --model-library duffing.so --kind resonance --over eps=0.1:1 --from 0.5 --to 2
refuses 1 "a factor of load or damping $only" \
	map --model-library duffing.so --quantity amplitude --x Omega=0.5:2 --y factor.load=0.5:1
works "a locus" locus --model-library duffing.so --over eps=0.1:0.6 --from 0.5 --to 2 --step 0.1 --json locus.json -q
works "of the file" locus duffing.json --over eps=0.1:0.6 --from 0.5 --to 2 --step 0.1 --json file-locus.json -q
over="--x eps=0.1:0.3 --y F=0.1:0.3 --Omega 1.2 --points 3x3"
works "a map" map --model-library duffing.so --quantity amplitude $over --json map.json -q
works "of the file" map duffing.json --quantity amplitude $over --json file-map.json -q
python "agree" <<'PY'
import json
load = lambda name: json.load(open(name + ".json"))
a, b = (load(name)["curves"] for name in ("locus", "file-locus"))
assert len(a) == len(b) and [len(c["points"]) for c in a] == [len(c["points"]) for c in b]
for c, d in zip(a, b):
    for p, q in zip(c["points"], d["points"]):
        assert abs(p["Omega"]/q["Omega"] - 1) < 1e-9 and abs(p["parameter"]/q["parameter"] - 1) < 1e-9, (p, q)
a, b = (load(name)["points"] for name in ("map", "file-map"))
assert a["branches"] == b["branches"] and a["branches"].count(3) > 2, a["branches"]
assert all(abs(x/y - 1) < 1e-8 for x, y in zip(a["value"], b["value"]))
PY
done_testing

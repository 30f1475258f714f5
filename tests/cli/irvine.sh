#!/bin/sh
# hawser irvine: its tables and JSON, its units, its pictures, and what it refuses.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scene=$top/notebooks-data/scenes/b-table-4.1-case-3.yaml

# --- results
draws=$(command -v gnuplot >/dev/null && echo --plot ../picture.svg)
# shellcheck disable=SC2086 # words
works "a sweep of H" irvine "$scene" --points 20 --tsv H.tsv --json H.json $draws
works "of T0, in Hz" irvine "$scene" --sweep T0 --from "40 kN" --to 5e3 --points 20 -n 6 --unit Hz \
	--tsv T0.tsv --json T0.json
works "of the sag, periods" irvine "$scene" --sweep sag --points 20 -n 4 --unit s --tsv sag.tsv
works "a level span" irvine "$scene" --set span.h=0 --points 20 --unit rad/s --json level.json \
	--tsv level.tsv
python "tables load and have their columns" <<'END'
import csv, math
expected = {
    "H": ["H_N", "irvine", "irvine_source", "inserted", "in_1_normalised"],
    "T0": ["T0_N", "irvine", "irvine_source", "H_N", "inserted", "in_1_Hz"],
    "sag": ["sag_m", "irvine", "irvine_source", "H_N", "inserted", "in_1_s"],
    "level": ["H_N", "irvine", "irvine_source", "inserted", "in_1_rad_s"],
}
for name, columns in expected.items():
    lines = [l for l in open(name + ".tsv") if not l.startswith("#")]
    rows = list(csv.DictReader(lines, delimiter="\t"))
    assert list(rows[0])[:len(columns)] == columns, list(rows[0])
    assert len(rows) >= 20 and sum(r["inserted"] == "0" for r in rows) == 20
    for r in rows:
        assert all(math.isfinite(float(v)) for v in r.values())
    lam = [float(r["irvine_source"]) for r in rows]
    assert lam == sorted(lam)
    if name != "T0":
        assert abs(lam[0] / math.pi - 0.1) < 1e-6 and abs(lam[-1] / math.pi - 10) < 1e-5
END
python "the JSON has its keys, and the table says the same in its unit" <<'END'
import csv, json, math
def table(name):
    lines = [l for l in open(name + ".tsv") if not l.startswith("#")]
    return list(csv.DictReader(lines, delimiter="\t"))
for name, sweep, count in ("H", "H", 10), ("T0", "T0", 6), ("level", "H", 10):
    r, rows = json.load(open(name + ".json")), table(name)
    for key in ("command", "version", "scene", "method", "sweep", "least_correlation", "stations",
                "branches", "crossovers", "stats"):
        assert key in r, key
    assert r["command"] == "irvine" and r["sweep"] == sweep and r["method"] == "spectral"
    assert len(r["branches"]) == count and len(r["stations"]) == len(rows)
    number = {"in-plane": 0, "out-of-plane": 0}
    for b in r["branches"]:
        number[b["plane"]] += 1
        assert b["number"] == number[b["plane"]]
        assert len(b["omega"]) == len(b["symmetry"]) == len(b["family"]) == len(rows)
        for row, station, omega in zip(rows, r["stations"], b["omega"]):
            column = {"in-plane": "in", "out-of-plane": "out"}[b["plane"]] + "_%d_" % b["number"]
            scale, unit = {"H": (station["string"], "normalised"), "T0": (2 * math.pi, "Hz"),
                           "level": (1, "rad_s")}[name]
            assert abs(float(row[column + unit]) * scale / omega - 1) < 1e-12
            assert float(row[sweep + "_N"]) == station["value"]
    comments = [l for l in open(name + ".tsv") if l.startswith(("# crossing:", "# veering:"))]
    assert len(comments) == len(r["crossovers"]) > 0
    for c in r["crossovers"]:
        for key in ("plane", "value", "H", "irvine", "irvine_source", "omega", "gap",
                    "relative_gap"):
            assert key in c, key
        assert len(c["numbers"]) == 2 and abs(c["gap"] / c["omega"] - c["relative_gap"]) < 1e-9
    kinds = {c["kind"] for c in r["crossovers"]}
    assert kinds == ({"crossing", "veering"} if name == "level" else {"veering"}), kinds
first = next(c for c in json.load(open("level.json"))["crossovers"] if c["numbers"] == [1, 2])
assert first["kind"] == "crossing" and abs(first["irvine"] / math.pi / 2 - 1) < 0.03
END
run irvine "$scene" --points 5 -n 2
try "without a file the table is printed" grep -q '^H_N	irvine	irvine_source' "$scratch/out"
run irvine "$scene" --set tension.H="5 kN" --points 5 -n 2
grep -v '^# *set:\|the scene itself: ' "$scratch/out" >a
run irvine "$scene" --points 5 -n 2
try "the scene's own tension does not matter" sh -c 'grep -v "the scene itself: " "$1" | diff a -' - "$scratch/out"
run irvine "$scene" --set tension="{T0: 5 MN}" --set cable.EA="1 GN" --points 5 -n 2
try "but the range contains it" awk '/^# the scene itself: H = / {H = $7} /^# sweep: H from / {from = $5}
	END {exit !(H > 4.8e6 && from/H > 1.25 - 1e-9 && from/H < 1.25 + 1e-9)}' "$scratch/out"
cp "$scene" "$scratch/in"
works "a scene on standard input" irvine - --points 5 -n 2

# --- what it refuses
rm -f ./*
refuses 1 "irvine needs a SCENE (hawser irvine --help)" irvine
refuses 1 "--sweep L: must be one of H, T0, T1, length0, sag" irvine "$scene" --sweep L
refuses 1 "--over time: must be one of lambda, value" irvine "$scene" --over time
refuses 1 "--unit rpm: must be one of normalised, rad/s, Hz, s" irvine "$scene" --unit rpm
refuses_like 1 '--method foo: must be one of .*spectral' irvine "$scene" --method foo
refuses 1 "--from -3: must be greater than zero and finite" irvine "$scene" --from -3
refuses 1 "--to .inf: must be greater than zero and finite" irvine "$scene" --to .inf
refuses_like 1 '--from: .*3 m.* wrong' irvine "$scene" --from "3 m"
refuses_like 1 '--to: .*3 N.* wrong' irvine "$scene" --sweep sag --to "3 N"
refuses 1 "--points 1: must be at least 2" irvine "$scene" --points 1
refuses 1 "--modes 0: must be at least 1" irvine "$scene" -n 0
refuses 1 "H from 5000 to 5000: give two different positive values" irvine "$scene" --from 5e3 \
	--to "5 kN"
refuses_like 1 '501 branches' irvine "$scene" -n 501
refuses_like 2 'least one' irvine "$scene" --sweep T0 --from 5e3 --to 10 --json out.json
refuses_like 2 'inextensible' irvine "$scene" --set cable.EA=.inf --tsv out.tsv
refuses_like 1 '\.svg' irvine "$scene" --plot out.jpg
try "and no file" holds ""

# --- pictures
if command -v gnuplot >/dev/null; then
	for kind in png pdf; do
		works "picture.$kind" irvine "$scene" --points 2 -n 1 --plot "picture.$kind" -q
	done
	try "the picture says what it shows" sh -c 'for w in "in plane" "out of plane" veering Irvine \
		Frequency; do grep -q "$w" ../picture.svg || exit 1; done'
	works "over a length" irvine "$scene" --sweep length0 --over value --unit s --points 3 -n 1 \
		--plot length.svg -q
	try "the picture has its unit" grep -q 'Unstretched length (m)' length.svg
	works "over a narrow range" irvine "$scene" --from 1e4 --to 1.0001e4 --points 2 -n 3 \
		--plot narrow.svg -q
	try "its abscissa has labels, all different" sh -c 'grep -o "[0-9]*\.[0-9]*</tspan>" narrow.svg |
		sort >labels; test "$(grep -c "[0-9]\.[0-9][0-9]" labels)" -ge 3 && test -z "$(uniq -d labels)"'
	run irvine "$scene" --points 2 -n 1 --plot -
	try "a picture on standard output" grep -q '<svg' "$scratch/out"
	run modes --list-methods
	if grep -q '^analytic$' "$scratch/out"; then
		try "analytic curves are in the picture" grep -q analytic ../picture.svg
	else
		try "without the analytic method none are in the picture" \
			sh -c '! grep -q analytic ../picture.svg'
	fi
else
	skip "gnuplot is not installed"
fi
done_testing

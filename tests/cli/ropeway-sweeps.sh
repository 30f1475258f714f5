#!/bin/sh
# hawser campbell, irvine and modes --over of ropeways: branches, crossings and veerings, ends, refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
sketched

small=$SRCDIR/notebooks-data/scenes/ropeway-small.yaml
one="--set ropeway.down=off --contact slip"
works "over the tension" irvine "$small" $one -n 8 --points 7 --json tension.json --tsv tension.tsv --plot tension.svg -q
works "  back, in another step" irvine "$small" $one -n 8 --points 2 --from "180 kN" --to "130 kN" --json back.json -q
works "  modes at a value" modes "$small" $one -n 12 --set "ropeway.bottom.tension.counterweight=168 kN" --json at.json -q
works "over the height of a tower" modes "$small" $one -n 6 --over "ropeway.towers.p0.at.1=15 m:20 m:3" --json height.json \
	--plot height.svg -q
works "over the phase" modes "$small" $one -n 4 --over ropeway.carriers.phase=0:36.6:4 --json phase.json -q
works "over the speed" campbell "$small" -n 6 --points 5 --json speed.json --tsv speed.tsv --plot speed.svg -q
works "  modes at a speed" modes "$small" -n 6 --set ropeway.top.drive.speed=10 --json runs.json -q
works "a sweep that ends" modes "$small" -n 3 --set ropeway.down=off --over "ropeway.towers.p0.at.1=15 m:4 m:6" --json ends.json \
	--tsv ends.tsv -q
python "branches, crossovers, periods, ends" <<'END2'
import json
tension, back, at, height, phase, speed, runs, ends = (json.load(open(n + ".json")) for n in
	"tension back at height phase speed runs ends".split())
def branch(result, b, key="stations"):
    return [s["eigenvalues"][b]["im"] for s in result[key]]
# the frequencies at a value are those of the modes there
(s,) = [s for s in tension["stations"] if abs(s["value"] - 168e3) < 1]
own = sorted(m["omega"] for m in at["modes"])
for e in s["eigenvalues"]:
    assert min(abs(e["im"]/w - 1) for w in own) < 1e-9
# both ways and in other steps the same crossovers of the lowest eight branches
def found(r, kind):
    return sorted(c["value"] for c in r["crossovers"] if c["kind"] == kind and None not in c["branches"]
                  and c["omega"] < 3.8)
for kind in ("veering", "crossing"):
    a, b = ([v for v in found(r, kind) if 130e3 < v < 180e3] for r in (tension, back))
    assert len(a) >= 1 and all(min(abs(x/y - 1) for y in b) < 3e-6 for x in a), (kind, a, b)
# a veering: the branches in the plane keep their order; the gap is that at the value itself
(veer,) = [c for c in tension["crossovers"] if c["kind"] == "veering" and None not in c["branches"]]
below, above = (branch(tension, b - 1) for b in veer["branches"])
assert all(x < y for x, y in zip(below, above))
json.dump([veer["value"], veer["omega"], veer["relative_gap"]], open("veer", "w"))
for c in tension["crossovers"]:
    if c["kind"] == "crossing":
        x, y = (branch(tension, b - 1) for b in c["branches"])
        assert (x[0] - y[0])*(x[-1] - y[-1]) < 0 and c["relative_gap"] == 0
# after one spacing the line is as before: the same frequencies, in some order
first, last = (sorted(e["im"] for e in phase["stations"][i]["eigenvalues"]) for i in (0, -1))
assert all(abs(x/y - 1) < 1e-6 for x, y in zip(first, last)), (first, last)
assert [s["speed"] for s in speed["speeds"]][::4] == [0, 10]
fast = [e["im"] for e in speed["speeds"][-1]["eigenvalues"]]
assert all(abs(x/m["omega"] - 1) < 1e-9 for x, m in zip(sorted(fast), runs["modes"]))
assert all(s["eigenvalues"][0]["plane"] == "in-plane" for s in speed["speeds"])
# where multiples of the frequency at which carriers pass meet the branches
pi = 3.141592653589793
v = [s["speed"] for s in speed["speeds"]]
sides = [(n, b) for b in range(6) for n in (1, 2, 3) for i in range(1, len(v))
         if (branch(speed, b, "speeds")[i - 1] - 2*pi*n*v[i - 1]/36.6)*(branch(speed, b, "speeds")[i] - 2*pi*n*v[i]/36.6) < 0]
assert speed["spacing"] == 36.6 and len(sides) > 4
assert sorted((r["harmonic"], r["branch"] - 1) for r in speed["resonances"]) == sorted(sides)
for r in speed["resonances"]:
    assert abs(2*pi*r["harmonic"]*r["speed"]/36.6/r["omega"] - 1) < 1e-9
    assert min(abs(r["omega"]/w - 1) for w in branch(speed, r["branch"] - 1, "speeds")) < 2e-3
assert branch(speed, 0, "speeds")[-1] < branch(speed, 0, "speeds")[0]
assert height["stations"][0]["value"] == 15 and height["swept"] == "ropeway.towers.p0.at.1" and height["unit"] == "m"
assert 4 < ends["ended"]["value"] < 10 and "lifts off" in ends["ended"]["why"] and len(ends["stations"]) == 3
END2
value=$(python3 -S -c 'import json; print(repr(json.load(open("veer"))[0]))' 2>/dev/null)
works "the modes at a veering" modes "$small" $one -n 12 --set "ropeway.bottom.tension.counterweight=$value" --json veered.json -q
python "  have its gap" <<'END2'
import json
value, omega, gap = json.load(open("veer"))
w = sorted(m["omega"] for m in json.load(open("veered.json"))["modes"] if m["plane"] == "in-plane")
i = min(range(len(w) - 1), key=lambda i: abs(0.5*(w[i] + w[i + 1]) - omega))
assert abs((w[i + 1] - w[i])/omega/gap - 1) < 1e-4 and 1e-4 < gap < 0.02
END2
try "the pictures" grep -q 'veering' tension.svg
try "  of the speed" grep -q 'passing of carriers' speed.svg
try "  of the height" grep -q 'in-plane' height.svg
try "the table" grep -q '^counterweight_N	branch	omega_rad_s	frequency_Hz	plane	lane	span	span_share	residual$' tension.tsv
try "  of speeds" grep -q '^speed_m_s	branch' speed.tsv
try "the end is told" grep -q '^# the sweep ends before ropeway.towers.p0.at.1 = 8.4 m: .*case full' ends.tsv

denies "an option of spans" 1 "\-\-sweep is for spans" irvine "$small" --sweep T0
denies "an option of ropeways" 1 "\-\-contact is for ropeways" campbell "$chairlift" --contact slip
denies "stick, and a rope that runs" 1 "contact.modes is stick, but the rope runs" campbell "$small" --contact stick --from 1 --points 2
denies "another unit" 1 "KEY=FROM:TO:POINTS" modes "$small" --over "ropeway.towers.p0.at.1=15 m:20:5"
denies "one point" 1 "with 2 to 2000 points" modes "$small" --over ropeway.carriers.phase=0:36:1
denies "an unknown key" 1 "\-\-over ropeway.carriers.phas, at 0: unknown key ropeway.carriers.phas" modes "$small" --over ropeway.carriers.phas=0:36:3
denies "shapes of a sweep" 1 "shapes does not go with --over" modes "$small" --over ropeway.carriers.phase=0:36:3 --shapes
denies "no range" 1 "are both" irvine "$small" --from 3e5 --to "300 kN"
denies "ratios of 0" 1 "no equal ratios" modes "$small" --over ropeway.carriers.phase=0:36:3 --log
denies "a unit of spans" 1 "must be one of rad/s, Hz\|must be rad/s or Hz" irvine "$small" --unit normalised
try "resonances are listed, and marked" grep -q '^# resonance: harmonic 3 with branch 1 (in-plane) at 4.0[0-9]* m/s' speed.tsv
try "  in the picture" grep -q "[>']resonance[<']" speed.svg
denies "no first solution" 2 "lifts off" modes "$small" --over "ropeway.towers.p0.at.1=4 m:15 m:3"
done_testing

#!/bin/sh
# hawser identify: the values from which frequencies were computed, tables as they come, what is refused.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >span.yaml <<'END'
cable: {EA: 95 MN, rho: 7.3 kg/m}
span: {d: 310 m, h: -42 m}
tension: {T0: 61 kN}
END
works "frequencies" modes span.yaml -n 7 --set tension.T0=58.5kN --tsv modes.tsv -q
works "the table of hawser modes as it is" identify span.yaml modes.tsv --free tension.T0,cable.EA --json a.json \
	--tsv a.tsv --fitted fitted.yaml -q
python "the values are found" <<'END'
import json
r = json.load(open("a.json"))
T0, EA = r["parameters"]
assert T0["key"] == "tension.T0" and abs(T0["value"] - 58.5e3) < 1e-3 and T0["start"] == 61e3 and T0["unit"] == "N"
assert abs(EA["value"]/95e6 - 1) < 1e-6 and r["freedom"] == 5 and r["chi2"] is None and r["spread"] < 1e-9
assert [f["index"] for f in r["frequencies"]] == [1, 2, 3, 4, 5, 6, 7] and not any(f["matched"] for f in r["frequencies"])
END
works "the fitted scene" modes fitted.yaml -n 7 --tsv again.tsv -q
python "has the same frequencies" <<'END'
def column(name):
    lines = [l.split("\t") for l in open(name) if l[0] != "#"]
    return [float(l[1]) for l in lines[1:]]
assert all(abs(a/b - 1) < 1e-8 for a, b in zip(column("modes.tsv"), column("again.tsv")))
END
python "a table of frequencies only" <<'END'
rows = [l.split("\t") for l in open("modes.tsv") if l[0] != "#"]
at, plane = rows[0].index("frequency_Hz"), rows[0].index("plane")
with open("bare.tsv", "w") as f:
    f.write("# two modes are not measured\n" + "".join(r[at] + "\n" for r in rows[1:8] if r[0] not in "35"))
with open("planes.csv", "w") as f:
    f.write("plane, frequency_Hz, deviation_Hz, number\n")
    for k, r in enumerate(rows[1:8]):
        f.write("%s, %.6f, 0.001, -\n" % (r[plane], float(r[at])*(1.003 if k == 4 else 1)))
with open("sure.csv", "w") as f:
    f.write("frequency_Hz, deviation_Hz, index\n")
    for k, r in enumerate(rows[1:8]):
        f.write("%.6f, 0.00001, %d\n" % (float(r[at])*(1.003 if k == 4 else 1), k + 1))
END
run identify span.yaml bare.tsv --free tension.T0 --set "tension.T0=45 kN" --json b.json --plot b.svg -q
try "without anything known of the modes" test "$status" -eq 0
python "modes are found, from a start 23 % off" <<'END'
import json
r = json.load(open("b.json"))
assert abs(r["parameters"][0]["value"] - 58.5e3) < 30 and r["skipped"] <= 3
assert all(f["matched"] for f in r["frequencies"])
END
try "a picture" grep -q "Measured frequency" b.svg
works "deviations and planes, with commas" identify span.yaml planes.csv --free tension.T0 --json c.json -q
python "chi2 and its probability" <<'END'
import json
r = json.load(open("c.json"))
assert r["freedom"] == 6 and 0 < r["chi2"] < 3 and 0.8 < r["probability"] < 1 and r["parameters"][0]["low"] < 58.5e3
END
run identify span.yaml sure.csv --free tension.T0 -q
try "deviations that explain nothing" grep -q "larger than the deviations explain" "$scratch/err"

carriers=$top/notebooks-data/scenes/ropeway-carriers.yaml
works "modes with a lighter carrier" modes "$carriers" -n 8 --set attach.carrier-2.mass="700 kg" --tsv carriers.tsv -q
works "the mass of a carrier" identify "$carriers" carriers.tsv --free attach.carrier-2.mass --json mass.json -q
python "is found, in kg" <<'END'
import json
mass = json.load(open("mass.json"))["parameters"][0]
assert abs(mass["value"] - 700) < 1e-4 and mass["start"] == 820 and mass["unit"] == "kg"
END

refuses 1 "identify needs --free KEY,...: the parameters to be fitted, such as --free tension.T0" identify span.yaml modes.tsv
refuses 1 "identify needs a SCENE and a table of FREQUENCIES (hawser identify --help)" identify span.yaml --free g
refuses_like 1 "one or none|takes one SCENE FREQUENCIES" identify span.yaml modes.tsv third --free g
refuses_like 1 "tension.T0 and cable.EA and cable.rho only change these frequencies together" \
	identify span.yaml modes.tsv --free tension.T0,cable.EA,cable.rho
refuses_like 1 "unknown key|no key|tension.TO" identify span.yaml modes.tsv --free tension.TO
echo "0.1 0.2" >two.tsv
refuses_like 1 "1 measured frequencies for 2 free parameters" identify span.yaml two.tsv --free tension.T0,cable.EA
printf 'frequency_Hz plane\n0.2 sideways\n' >bad.tsv
refuses 1 'bad.tsv:2: the plane "sideways": write in-plane, out-of-plane, or - if it is not known' \
	identify span.yaml bad.tsv --free tension.T0
printf 'frequency_Hz index\n0.2 1.5\n' >bad.tsv
refuses_like 1 "bad.tsv:2: 1.5 in column 2: the number of a mode is from 1 to 100" identify span.yaml bad.tsv --free g
printf 'frequency_Hz index\n0.2\n' >bad.tsv
refuses_like 1 "bad.tsv:2: 1 of 2 columns" identify span.yaml bad.tsv --free g
printf '0.2x\n' >bad.tsv
refuses_like 1 'bad.tsv:1: "0.2x" in column 1 is not a number' identify span.yaml bad.tsv --free g
printf 'f\n0.2\n' >bad.tsv
refuses_like 1 "bad.tsv:1: no column of frequencies" identify span.yaml bad.tsv --free g
: >bad.tsv
refuses 1 "bad.tsv has no frequencies" identify span.yaml bad.tsv --free g
refuses_like 1 "free twice" identify span.yaml modes.tsv --free g,g
refuses_like 2 "below the least one" identify span.yaml modes.tsv --free tension.T0 --set "tension.T0=1 kN"
done_testing

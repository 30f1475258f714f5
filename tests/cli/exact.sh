#!/bin/sh
# model.energy: auto: a response for which an energy of degree 4 is not good enough is that of the exact
# energy, whatever number of modes is asked for.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# A footbridge cable (sag over span 0.079) that swings by 1.09 m.
cat >footbridge.yaml <<'END'
cable: {EA: 280 MN, rho: 28 kg/m}
span: {d: 104 m, h: 2.5 m}
tension: {sag: 8.2 m}
damping: {ratio: 0.8 %}
load: {frame: global, per_length: [0, 0.7 N/m, 0.6 N/m]}
END
range="--from 0.97w1 --to 1.001w1 --step 0.2"

works "frf takes the exact energy" frf footbridge.yaml $range --json exact.json --tsv exact.tsv --label-every 1
try "says so, and how wrong the modes are" grep -q \
	'^# with an energy of degree 4 the motion is off by about 0.0[56]' exact.tsv
try "in whose place" grep -q \
	'^# exact energy on 6 functions a component, 18 coordinates, in place of the model.s 5 modes' exact.tsv
python "its peak is that of an outside chain of 64 exact bars" <<'END'
import json
of = json.load(open("exact.json"))
peak = next(p for p in of["peaks"] if p["probe"] == "mid" and p["component"] == "z")
assert abs(peak["size"]/1.0901 - 1) < 2e-3, peak
assert abs(peak["Omega"]/1.2144 - 1) < 3e-4, peak
assert of["scene"]["model"]["energy"] == "exact" and of["scene"]["model"]["basis"] == 6
assert 0 < of["model_error"]["estimated"] < 0.01
END
if [ -n "${HAWSER_LONG:-}" ]; then
	# Five modes have folds between 0.437 and 2 times five times this load (hawser folds); the exact energy has none.
	sed 's/0.7 N/3.5 N/; s/0.6 N/3 N/' footbridge.yaml >five.yaml
	run locus five.yaml --from 0.97w1 --to 1.1w1
	try "locus takes it too, and finds no fold" like 2 'has no fold in this range'
	works "orbit takes a label of it" orbit "exact.json#2" --tsv orbit.tsv
	try "by the same model" grep -q '18 coordinates\|u_18' orbit.tsv
	# an energy of degree 4 is further off with 16 modes than with 5
	works "with 16 modes" frf footbridge.yaml -n 16 $range --json more.json
	python "the response is the same" <<'END'
import json
a, b = (json.load(open(name))["peaks"] for name in ("exact.json", "more.json"))
assert len(a) == len(b) and all(abs(p["size"]/q["size"] - 1) < 1e-3 for p, q in zip(a, b)), (a, b)
END
fi

rough "model.energy: quartic" frf footbridge.yaml $range --set model.energy=quartic --json quartic.json
python "stays, is off by 4 %, and its estimate says so" <<'END'
import json
of = json.load(open("quartic.json"))
peak = max(p["amplitude"]["z_mid"] for p in of["points"])
assert abs(peak/1.0901 - 1) > 0.03 and of["model_error"]["estimated"] > 0.05, (peak, of["model_error"])
END

# A wave of 60 m is 10 half waves: 6 functions do not hold it, 18 do.
run frf "$top/tests/reference/wave.yaml" --from 1.3 --to 1.31 --max-points 2 --set model.energy=exact \
	--set model.basis=6 -q --json wave.json
try "a basis that lacks the load says so" like 0 \
	'^hawser: warning: 6 functions a component are off by .*, and lack 8.9e-01 of the static response to the load$'
python "and the result has the part" <<'END'
import json
assert 0.88 < json.load(open("wave.json"))["basis"]["load_lacking"] < 0.9
END
works "rom takes what the load needs" rom "$top/tests/reference/wave.yaml" --set model.energy=exact --tsv wave.tsv
try "18 functions" grep -q '^# 54 coordinates' wave.tsv
# The first orbit, to which the load is raised, is at the frequency asked for, where a map has its first point.
run frf "$top/notebooks-data/scenes/conductor.yaml" --set "temperature.change=7.5 K" --set model.energy=exact \
	--set model.basis=4 --from 0.98 --to 1.164 --max-points 2 -q --json first.json
python "a response begins where it was asked to" <<'END'
import json
assert abs(json.load(open("first.json"))["points"][0]["Omega"]/0.98 - 1) < 1e-14
END
done_testing

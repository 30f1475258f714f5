#!/bin/sh
# model.modes: auto in the commands that make a model, and what they refuse; the tension in results.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scene=$top/notebooks-data/scenes/b-table-5.4-at-rest.yaml
auto='--set model.condense=static --set model.modes=auto --set model.accuracy=2%'
range='--from 0.9w1 --to 1.3w1'

# shellcheck disable=SC2086 # words
works "a response" frf "$scene" $auto $range --json frf.json --tsv frf.tsv
# shellcheck disable=SC2086
works "a model" rom "$scene" $auto $range --json rom.json
works "which is one for other commands" rom rom.json
# shellcheck disable=SC2086
works "a history" integrate "$scene" $auto --Omega 1w1 --until 1T --every 0.5T --json time.json
# shellcheck disable=SC2086
works "modes" modes "$scene" $auto --tsv modes.tsv
python "what was chosen is told" <<'END'
import csv, json
frf = json.load(open("frf.json"))
assert frf["scene"]["model"]["modes"] == "auto" and frf["scene"]["model"]["accuracy"] == 0.02
a = frf["accuracy"]
kept = [m for m in a["modes"] if m["kept"]]
assert a["reached"] and a["estimated"] <= a["asked"] == 0.02
assert len(kept) == a["kept"] == len(frf["points"][0]["coordinates"]) == a["tried"][-1]["modes"]
assert kept[0]["plane"] == "out-of-plane" and kept[0]["index"] == 1
reasons = {"direct", "parametric", "internal", "dynamic"}
assert all(m["reason"] in reasons for m in kept)
assert all(m["reason"] in ("condensed", "not excited") for m in a["modes"] if not m["kept"])
assert "moved" not in a["tried"][0] and all("moved" in t for t in a["tried"][1:])
comments = [l for l in open("frf.tsv") if l.startswith("#")]
assert any("accuracy: asked 0.02" in l for l in comments)
assert sum(l.startswith("# u_") for l in comments) == a["kept"]
rom = json.load(open("rom.json"))
assert rom["n"] == rom["accuracy"]["kept"] and len(rom["labels"]) == rom["n"]
assert json.load(open("time.json"))["accuracy"]["kept"] > 0
rows = list(csv.DictReader((l for l in open("modes.tsv") if l[0] != "#"), delimiter="\t"))
assert len(rows) == 12
# tension
T0 = 80e3
for p in frf["points"]:
    assert 0 < p["tension"]["min"] < p["tension"]["max"]
assert frf["warnings"] == []
rows = list(csv.DictReader((l for l in open("frf.tsv") if l[0] != "#"), delimiter="\t"))
assert float(rows[3]["T_min_N"]) == frf["points"][3]["tension"]["min"]
END

# a cable that is shaken in its plane until it goes slack
slack='--set model.energy=exact --set model.basis=4 --set load.per_length=[0,30,0]'
# shellcheck disable=SC2086
run integrate "$chairlift" $slack --Omega 3.98 --until 1T --json slack.json
try "a slack cable is warned of" grep -q '^hawser: warning: slack: .* N at t = ' "$scratch/err"
python "in JSON too" <<'END'
import json
s = json.load(open("slack.json"))
assert s["tension"]["min"] < 0 and s["warnings"][0].startswith("slack: ")
END

# shellcheck disable=SC2086
refuses_like 1 'auto chooses the modes to keep and condenses the others: it goes with' \
	frf "$scene" --set model.condense=none --set model.modes=auto $range
# shellcheck disable=SC2086
refuses_like 1 'a state has as many coordinates as the model' frf "$scene" $auto $range --start x.json
# shellcheck disable=SC2086
refuses_like 1 'the model is forced: give its frequency' integrate "$scene" $auto
refuses_like 1 '"some" must be a whole number, or auto' frf "$scene" --set model.modes=some
# ten seconds
if [ -n "${HAWSER_LONG:-}" ]; then
	refuses_like 3 'known to .* only with the .* coordinates of the last of .* models, not to 1e-07' \
		frf "$chairlift" --set model.modes=auto --set model.condense=static --set model.accuracy=1e-7 \
		--set 'load.per_length=[0,0,0.001]' --from 0.95w1 --to 1.05w1 --tolerance 1e-6
fi

# Fifteen seconds. Attachments divide a cable into elements that share the functions of a basis out: 6 and 8 functions
# give the same model, whose agreement with itself once was stated as an error of nothing.
if [ -n "${HAWSER_LONG:-}" ]; then
cat >carried.yaml <<'END'
cable: {EA: 32 MN, rho: 5.83 kg/m}
span: {d: 292.9 m, h: 173.5 m}
tension: {T0: 160.3 kN}
damping: {ratio: 0.005}
load: {frame: global, per_length: [0, 1.48 N/m, 0]}
attach: [{at: 13.05 %, mass: 383.9 kg}, {at: 37.64 %, spring: [0, 3.678 kN/m, 2.475 kN/m]}]
model: {modes: auto, accuracy: 3 %}
END
works "bases that attachments divide" frf carried.yaml --from 0.9w1 --to 1.1w1 --json carried.json
python "are compared with larger ones only" <<'END'
import json
a = json.load(open("carried.json"))["accuracy"]
full = [t for t in a["tried"] if t["full_order"]]
assert a["full_order"] and len(full) > 1 and all(t["moved"] > 0 for t in full), full
assert all(t["modes"] < u["modes"] for t, u in zip(full, full[1:])), full
END
fi

# Modes above those that a model keeps or knows: 100 of a scene, four times its highest frequency of a file.
weak='--set load.per_length=[0.0004,0.0005,0.0005] --set model.condense=static'
run frf "$chairlift" $weak --set model.modes=3 --from 35w1 --to 35.02w1 --max-points 2 --json far.json
try "a forcing frequency far above all known modes is warned of" \
	grep -q '^hawser: warning: the frequency of the forces reaches .* the model knows no modes above' "$scratch/err"
try "and the error of the model is not known" grep -q '"estimated": null' far.json
run rom "$chairlift" $weak --set model.modes=1 --json one.json
run frf one.json --from 5w1 --to 5.02w1 --max-points 2 --json file.json
try "the same of a model file" grep -q 'give the scene in place of its model$' "$scratch/err"
works "and not within its reach" frf one.json --from 2w1 --to 2.02w1 --max-points 2 --json near.json
rough "of the scene neither" frf "$chairlift" $weak --set model.modes=1 --from 5w1 --to 5.02w1 --max-points 2 --json scene.json
rough "nor of a motion of it" orbit "$chairlift" $weak --set model.modes=1 --from-label scene.json#1 --json orbit.json -q
python "which moves as the response does" <<'END'
import json
size = json.load(open("scene.json"))["points"][0]["amplitude"]
run = json.load(open("orbit.json"))["probes"]
for name in "quarter", "mid":
    for axis in "yz":
        own = max(map(abs, run[name][axis]))
        assert abs(own/size[f"{axis}_{name}"] - 1) < 1e-3, (name, axis, own)
END
done_testing

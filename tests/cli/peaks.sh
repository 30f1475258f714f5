#!/bin/sh
# The located peaks of a response: a closed form, runs in far shorter steps, what tables and pictures say.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >linear.json <<'END'
{"hawser_rom": 1, "n": 1, "D": [[0.2385]], "K": [[1.7]], "harmonics": [{"k": 1, "f": [0.31]}]}
END
cat >deep.yaml <<'END'
cable: {EA: 40 MN, rho: 18}
span: {d: 120, h: -6}
tension: {sag: 30}
damping: {alpha: 1.5}
load: {frame: local, per_length: [0, 2, 3]}
model: {modes: auto, accuracy: 1 %}
END
works "a linear oscillator" frf linear.json --from 0.6 --to 2 --json linear-frf.json
works "Duffing's oscillator" frf "$duffing" --from 0.5 --to 2 --json duffing.json
works "in short steps" frf "$duffing" --from 0.5 --to 2 --step 0.001 --json duffing-fine.json
# With modes: auto, whose curve is one of such a model (choice.sh), in the long run.
kinds="${HAWSER_LONG:+auto }5"
for kind in $kinds; do
	range="--from 0.85w1 --to 1.2w1 --set model.modes=$kind --set model.energy=quartic"
	# shellcheck disable=SC2086 # words
	works "deep sag, $kind modes" frf deep.yaml $range --json "$kind.json" --tsv "$kind.tsv" \
		--plot "$kind.svg"
	# shellcheck disable=SC2086
	works "in short steps" frf deep.yaml $range --step 0.01 --json "$kind-fine.json"
done
python "peaks are where they are said to be" <<'END'
import json, math, os

def change(p):
    return abs(p["size"] - p.get("at_rest", 0.0))

def agree(coarse, fine, largest):
    assert len(coarse) == len(fine) > 0, (len(coarse), len(fine))
    for p, q in zip(coarse, fine):
        assert (p["probe"], p["component"]) == (q["probe"], q["component"])
        off = abs(p["Omega"]/q["Omega"] - 1), abs(change(p)/change(q) - 1)
        assert off[0] <= p["Omega_error"] + q["Omega_error"], (p, q)
        assert off[1] <= p["size_error"] + q["size_error"], (p, q)
        assert p["stable"] == q["stable"], (p, q)
        assert max(off) < largest, (p, q)

f, d, k = 0.31, 0.2385, 1.7
[p] = json.load(open("linear-frf.json"))["peaks"]
assert p["probe"] is None and p["component"] == "u_1" and p["stable"]
assert abs(p["Omega"]/math.sqrt(k - d*d/2) - 1) <= p["Omega_error"] < 1e-3, p
assert abs(p["size"]*d*math.sqrt(k - d*d/4)/f - 1) <= p["size_error"] < 1e-3, p

agree(json.load(open("duffing.json"))["peaks"], json.load(open("duffing-fine.json"))["peaks"], 1e-4)
kinds = ["auto", "5"] if os.environ.get("HAWSER_LONG") else ["5"]
for kind in kinds:
    r = json.load(open(kind + ".json"))
    agree(r["peaks"], json.load(open(kind + "-fine.json"))["peaks"], 2e-4)
    names = {(p["probe"], p["component"]) for p in r["peaks"]}
    assert {("mid", "z"), ("mid", "y"), (None, "T_max"), (None, "T_min")} <= names
    z = [p for p in r["peaks"] if p["probe"] == "mid" and p["component"] == "z"][0]
    rows = [q["amplitude"]["z_mid"] for q in r["points"]]
    # the highest row is far lower than the peak is known
    assert z["size_error"] < 2e-4 and max(rows) <= z["size"]*(1 + z["size_error"])
    comments = [l for l in open(kind + ".tsv") if l.startswith("# peak: ")]
    assert len(comments) == len(r["peaks"])
    assert any(l.startswith("# peak: z_mid = 4.04") for l in comments)
    assert "peak" in open(kind + ".svg").read()
    assert max(p["Omega_error"] for p in r["peaks"] if p["component"] == "z") < 2e-4
END
done_testing

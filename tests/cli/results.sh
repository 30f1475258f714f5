#!/bin/sh
# What comes out: tables that load, the keys of the JSON contract, SI units, and the same answer by two
# routes wherever the program offers two.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# --- the tables, read as a user of Python would
works "statics" statics "$chairlift" --points 5 --tsv statics.tsv --json statics.json
works "modes" modes "$chairlift" --tsv modes.tsv --json modes.json
works "modes --shapes" modes "$chairlift" --shapes --points 9 --tsv shapes.tsv --json shapes.json
works "rom" rom "$chairlift" --json model.json --tsv rom.tsv
works "integrate" integrate "$chairlift" --Omega 0.9w1 --until 4T --every 0.05T \
	--tsv integrate.tsv --json integrate.json
works "integrate --spectrum" integrate "$chairlift" --Omega 0.9w1 --until 16T --every 0.05T \
	--spectrum --tsv spectrum.tsv --json spectrum.json
works "frf" frf "$chairlift" --to 1.2w1 --multipliers --tsv frf.tsv --json frf.json
works "frf --sweep" frf "$duffing" --from 0.8 --to 1.5 --sweep both --sweep-points 5 \
	--tsv sweep.tsv --json sweep.json
works "folds" folds "$duffing" --from 0.8 --to 1.8 --tsv folds.tsv --json folds.json
python "tables load with csv, have units in their names and numbers in their rows" <<'END'
import csv, math
words = {"plane", "family", "symmetry", "tensor", "kind"}
empty = {"j", "k", "l", "m", "stable", "unstable", "mesh", "error", "liouville", "u_1", "residual",
         "truncation", "harmonics"}
expected = {
    "statics": ["S_m", "x_m", "y_m", "T_N", "slope"],
    "modes": ["index", "omega_rad_s", "frequency_Hz", "plane", "family", "symmetry", "residual",
              "axial_share", "normal_share", "out_of_plane_share", "participation_x",
              "participation_y", "participation_z", "effective_mass_x", "effective_mass_y",
              "effective_mass_z"],
    "shapes": ["S_m"] + ["%s_%d" % (c, k) for k in range(1, 6) for c in "PQBabc"],
    "rom": ["tensor", "j", "k", "l", "m", "value"],
    "integrate": ["t_s", "x_quarter_m", "y_mid_m", "vz_three_quarter_m_s", "T_mid_N", "u_5_m",
                  "v_1_m_s", "energy_J"],
    "spectrum": ["frequency_Hz", "z_mid_m"],
    "frf": ["Omega_rad_s", "stable", "unstable", "y_mid_m", "z_quarter_m", "u_1_m", "residual",
            "mesh", "error", "liouville"],
    "sweep": ["Omega", "stable", "u_1", "sweep"],
    "folds": ["curve", "Omega", "load_factor", "kind", "u_1", "residual", "truncation", "harmonics"],
}
for name, columns in expected.items():
    lines = open(name + ".tsv").read().split("\n")
    assert lines[0].startswith("# hawser "), name
    comments = [line for line in lines if line.startswith("#")]
    assert any(line.startswith("# method: ") for line in comments), name
    assert name in ("sweep", "folds") or any(line == "# g = 9.81 m/s^2" for line in comments), name
    assert lines[:len(comments)] == comments, "comments come first in " + name
    rows = list(csv.DictReader(lines[len(comments):], delimiter="\t"))
    assert rows, name
    for column in columns:
        assert column in rows[0], (name, column)
    for row in rows:
        assert None not in row and None not in row.values(), (name, row)
        for column, text in row.items():
            if column in words or (column in empty and text == ""):
                continue
            assert math.isfinite(float(text)), (name, column, text)
END
# half of a second for the start of both
if [ -n "${HAWSER_LONG:-}" ]; then
python "numpy and pandas read them too, where they are installed" <<'END'
try:
    import site
    site.main()
    import numpy
except ImportError:
    numpy = None
try:
    import pandas
except ImportError:
    pandas = None
if numpy:
    # as doc/commands.md and the manual pages say
    def read(name, **more):
        return numpy.genfromtxt((r for r in open(name) if r[0] != '#'), delimiter='\t', names=True,
                                encoding='utf-8', **more)
    rows = read("statics.tsv")
    assert rows.shape == (5,) and len(rows.dtype.names) == 5
    assert all(numpy.isfinite(rows[name]).all() for name in rows.dtype.names)
    rows = read("frf.tsv", dtype=None)
    assert (rows["y_mid_m"] > 0).all()
    with open("frf.tsv") as table:
        names = next(r for r in table if r[0] != '#').rstrip("\n").split("\t")
    assert list(rows.dtype.names) == names, rows.dtype.names
if pandas:
    table = pandas.read_csv("frf.tsv", sep="\t", comment="#")
    assert (table["y_mid_m"] > 0).all()
END
fi

# --- the JSON contract
python "every result has command, version, scene and wall time" <<'END'
import json
for name in ["statics", "modes", "rom", "integrate", "frf"]:
    result = json.load(open("model.json" if name == "rom" else name + ".json"))
    assert result["command"] == name and result["version"], name
    assert result["stats"]["wall_time_secs"] > 0, name
    if name == "integrate":
        assert result["model_error"]["estimated"] is None and "condense" in result["model_error"]["reason"]
    scene = result["scene"]
    assert scene["cable"] == {"EA": 4e8, "rho": 6.0, "EI": 0.0} and scene["span"] == {"d": 250.0, "h": 10.0}
    assert scene["tension"]["T0"] == 8e4 and scene["damping"] == {"alpha": 0.08}
    assert scene["load"]["per_length"] == [0.8] * 3 and scene["load"]["extent"] == [0.0, 1.0]
    assert scene["g"] == 9.81 and scene["model"]["modes"] == 5
END
python "statics: the keys, and equilibrium" <<'END'
import json, math
r = json.load(open("statics.json"))
for key in ["H", "T0", "T1", "V0", "V1", "eta", "length0", "length", "epsilon", "delta", "sag",
            "irvine", "irvine_source", "closure", "profile"]:
    assert key in r, key
weight = 6 * 9.81 * r["length0"]
assert abs(r["V1"] - r["V0"] - weight) < 1e-9 * weight
assert abs(math.hypot(r["H"], r["V1"]) - r["T1"]) < 1e-9 * r["T1"]
assert abs(r["T0"] - 8e4) < 1e-6 and r["closure"] < 1e-9
assert len(r["profile"]) == 5 and r["profile"][-1][1:3] == [250.0, 10.0]
END
python "modes: the keys, units and shapes" <<'END'
import json, math
r = json.load(open("shapes.json"))
assert r["method"] and len(r["modes"]) == 5
for k, mode in enumerate(r["modes"]):
    assert mode["index"] == k + 1 and mode["plane"] in ("in-plane", "out-of-plane")
    assert mode["family"] in ("transverse", "longitudinal") and mode["symmetry"]
    assert abs(mode["omega"] - 2 * math.pi * mode["frequency"]) < 1e-12 and mode["residual"] < 1e-9
# first out-of-plane mode: a taut string's n/(2d)*sqrt(H/rho), a little less for the sag
string = math.sqrt(79891.37 / 6) / 500
assert abs(r["modes"][0]["frequency"] / string - 1) < 2e-3
assert len(r["shapes"]["S"]) == 9 and len(r["shapes"]["modes"]) == 5
assert abs(r["shapes"]["modes"][0]["B"][4] - math.sqrt(2)) < 1e-2
assert "shapes" not in json.load(open("modes.json"))
END
python "integrate: the keys; probes and states tell the same story" <<'END'
import json, math
r = json.load(open("integrate.json"))
model = json.load(open("model.json"))
n = len(r["times"])
assert n == 81 and len(r["states"]) == n and len(r["energy"]) == n
assert all(len(state) == 10 for state in r["states"]) and r["states"][0] == [0.0] * 10
T = 2 * math.pi / r["Omega"]
assert abs(r["times"][-1] - 4 * T) < 1e-9 and r["end"] == "complete"
for probe in ["quarter", "mid", "three_quarter"]:
    for signal in ["x", "y", "z", "vx", "vy", "vz", "T"]:
        assert len(r["probes"][probe][signal]) == n, (probe, signal)
mid = r["probes"]["mid"]
# velocities are the derivatives of displacements (central differences, dt = T/20)
dt, k = T / 20, 50
slope = (8 * (mid["z"][k+1] - mid["z"][k-1]) - (mid["z"][k+2] - mid["z"][k-2])) / (12 * dt)
assert abs(slope - mid["vz"][k]) < 2e-2 * max(map(abs, mid["vz"])), (slope, mid["vz"][k])
# at rest the tension is the static one, and energy is zero
assert abs(mid["T"][0] - 79955.6) < 1.0 and r["energy"][0] == 0.0
# kinetic energy of the modes in SI: mass of unit norm rho*d
k = 30
kinetic = 0.5 * 6 * 250 * sum(v * v for v in r["states"][k][5:])
assert 0 < kinetic < r["energy"][k]
spectrum = json.load(open("spectrum.json"))["spectrum"]
peak = max(range(1, len(spectrum["frequency"])), key=lambda i: spectrum["z_mid"][i])
# bins are 1/(8 T) apart: the forcing or the first mode, 0.9 of each other
assert 0.8 < spectrum["frequency"][peak] * T < 1.25
END
python "frf: the keys, certificates and ends" <<'END'
import json, csv, math
r = json.load(open("frf.json"))
w1 = json.load(open("modes.json"))["modes"][0]["omega"]
assert abs(r["range"][0] - 0.6 * w1) < 1e-12 * w1 and abs(r["range"][1] - 1.2 * w1) < 1e-12 * w1
assert abs(r["natural_frequencies"][0] - w1) < 1e-12
first, last = r["points"][0], r["points"][-1]
assert abs(first["Omega"] / (0.6 * w1) - 1) < 1e-12 and r["end"]
for p in r["points"]:
    assert p["stable"] == (p["unstable"] == 0)
    assert set(p["certificate"]) == {"residual", "mesh", "error", "liouville"}
    assert p["certificate"]["residual"] < 1e-8 and p["certificate"]["liouville"] < 1e-5
    assert len(p["coordinates"]) == 5 and len(p["state"]) == 10 and len(p["multipliers"]) == 10
    # sum of log|multipliers| is -alpha/rho * T * n
    T = 2 * math.pi / p["Omega"]
    total = sum(m["log_modulus"] for m in p["multipliers"])
    assert abs(total + 5 * 0.08 / 6 * T) < 1e-4, total
    for key in ["x_quarter", "y_mid", "z_three_quarter"]:
        assert p["amplitude"][key] >= 0
    assert 0.9 * abs(p["state"][0]) <= p["coordinates"][0] * (1 + 1e-9)
lines = [l for l in open("frf.tsv").read().split("\n") if not l.startswith("#")]
rows = list(csv.DictReader(lines, delimiter="\t"))
assert len(rows) == len(r["points"])
for row, p in zip(rows, r["points"]):
    assert float(row["y_mid_m"]) == p["amplitude"]["y_mid"]
    assert float(row["Omega_rad_s"]) == p["Omega"]
END
python "frf: published folds of a Duffing oscillator, and the sweeps' jumps" <<'END'
import json
r = json.load(open("sweep.json"))
# NLvib, example 01
folds = sorted(e["Omega"] for e in r["events"] if e["kind"] == "fold" and not e["suspected"])
assert len(folds) == 2
assert abs(folds[0] - 1.115700252) < 2e-9 and abs(folds[1] - 1.269601956) < 2e-9
assert r["si"] is False and r["scene"]["model_file"].endswith("duffing-nlvib-01.json")
up, down = r["sweeps"]
assert up["direction"] == "up" and down["direction"] == "down"
assert [p["Omega"] for p in up["points"]] == sorted(p["Omega"] for p in up["points"])
at = lambda sweep, w: min(sweep["points"], key=lambda p: abs(p["Omega"] - w))["coordinates"][0]
assert at(up, 1.15) > 2 * at(down, 1.15)
END
python "folds: the load at which jumps begin, the passages, and rows that follow each other" <<'END'
import csv, json
r = json.load(open("folds.json"))
folds = sorted(e["Omega"] for e in r["response"]["events"] if e["kind"] == "fold")
(curve,) = r["curves"]
nominal = sorted(e["Omega"] for e in curve["events"] if e["kind"] == "nominal")
assert all(abs(a - b) < 1e-8 for a, b in zip(folds, nominal)) and len(folds) == len(nominal) == 2
(cusp,) = [e for e in curve["events"] if e["kind"] == "cusp"]
# AUTO-07p; see tests/reference/test-folds.c
assert abs(cusp["load"] - 0.29961728591) < 1e-9 and cusp["minimum"] == 1
assert r["least_load"] == curve["least_load"] == cusp["load"] and curve["least_kind"] == "cusp"
assert curve["points"][0]["load"] == curve["points"][-1]["load"] == r["load_range"][1] == 2
assert r["isolas"] == [] and r["not_followed"] == [] and r["si"] is False
lines = [l for l in open("folds.tsv").read().split("\n") if not l.startswith("#")]
rows = list(csv.DictReader(lines, delimiter="\t"))
assert len(rows) == len(curve["points"]) + len(curve["events"])
at = [i for i, row in enumerate(rows) if row["kind"] == "cusp"][0]
assert float(rows[at]["load_factor"]) == cusp["load"]
assert all(float(rows[at + k]["load_factor"]) > cusp["load"] for k in (-1, 1))
assert rows[at - 1]["kind"] == rows[at + 1]["kind"] == "fold"
END

# --- two routes to one answer
python "frequencies: 0.3 Hz is 0.6 pi rad/s" <<END
import json, math, subprocess
def range_of(a, b):
    out = subprocess.run(["$HAWSER", "frf", "$chairlift", "--from", a, "--to", b, "--json", "-",
                          "--max-points", "2"], stdout=subprocess.PIPE, check=True).stdout
    return json.loads(out)["range"]
a, b = range_of("0.15 Hz", "0.16 Hz"), range_of(repr(0.3 * math.pi), "%r rad/s" % (0.32 * math.pi))
assert all(abs(x - y) < 1e-12 for x, y in zip(a, b)), (a, b)
END
run frf "$chairlift" --to 1.2w1 --json - --max-points 30
cp "$scratch/out" scene.json
run frf model.json --to 1.2w1 --json - --max-points 30
cp "$scratch/out" file.json
python "a scene and the model file made from it have the same response" <<'END'
import json
a, b = json.load(open("scene.json")), json.load(open("file.json"))
assert len(a["points"]) == len(b["points"]) == 30 and b["si"] is True
for p, q in zip(a["points"], b["points"]):
    assert abs(p["Omega"] - q["Omega"]) < 1e-6
    assert abs(p["amplitude"]["z_mid"] - q["amplitude"]["z_mid"]) < 1e-5 * p["amplitude"]["z_mid"]
END
run integrate "$duffing" --Omega 1 --until 4T --every 0.5T --json whole.json
run integrate "$duffing" --Omega 1 --until 2T --every 0.5T --json half.json
run integrate "$duffing" --Omega 1 --until 2T --every 0.5T --initial half.json --json rest.json
python "a run continued from its last state is the whole run" <<'END'
import json
whole, rest = json.load(open("whole.json")), json.load(open("rest.json"))
for a, b in zip(whole["states"][-1], rest["states"][-1]):
    assert abs(a - b) < 1e-8, (a, b)
END
python "a state of the response is periodic: integrated over one period it returns" <<END
import json, subprocess
points = json.load(open("frf.json"))["points"]
p = points[len(points) // 2]
json.dump({"u": p["state"][:5], "v": p["state"][5:]}, open("state.json", "w"))
out = subprocess.run(["$HAWSER", "integrate", "$chairlift", "--Omega", repr(p["Omega"]), "--until",
                      "1T", "--every", "1T", "--initial", "state.json", "--json", "-"],
                     stdout=subprocess.PIPE, check=True).stdout
last = json.loads(out)["states"][-1]
size = max(map(abs, p["state"]))
assert max(abs(a - b) for a, b in zip(last, p["state"])) < 1e-7 * size
END
printf '# a state\n1.5, 0\n' >state.txt
echo '[1.5, 0]' >list.json
run integrate "$duffing" --Omega 1 --until 1 --every 0.5 --initial state.txt -q
grep -v '^#' "$scratch/out" >a
run integrate "$duffing" --Omega 1 --until 1 --every 0.5 --initial list.json -q
grep -v '^#' "$scratch/out" | try "a state as text and as JSON" diff - a

# --- ends of a response
run frf "$duffing" --from 0.5 --to 2 --max-points 5
try "says that --max-points ended it" grep -q '^# end: .*--max-points' "$scratch/out"
run frf "$duffing" --from 2 --to 0.5 -q --json down.json
python "a range may be followed downwards" <<'END'
import json
r = json.load(open("down.json"))
assert r["points"][0]["Omega"] == 2.0 and abs(r["points"][-1]["Omega"] - 0.5) < 1e-9
assert sum(e["kind"] == "fold" for e in r["events"]) == 2
END

# --- static models, and the curves of one cable
works "statics --models" statics "$chairlift" --models --tsv models.tsv --json models.json
works "statics --compatibility" statics "$chairlift" --compatibility --from "5 kN" --to 500000 \
	--points 7 --tsv curves.tsv --json curves.json
works "statics --model parabola" statics "$chairlift" --model parabola --json parabola.json
works "statics --model inextensible" statics "$chairlift" --model inextensible --json stiff.json
python "statics: the models and their errors, the curves" <<'END'
import csv, json, math
def rows(name):
    lines = [l for l in open(name).read().split("\n") if not l.startswith("#")]
    return list(csv.DictReader(lines, delimiter="\t"))
exact = json.load(open("statics.json"))
r = json.load(open("models.json"))
assert all(r[k] == exact[k] for k in ["H", "T0", "T1", "length0", "sag", "irvine"])
assert exact["model"] == "catenary" and len(r["profile"]) == 201
models = {m["name"]: m for m in r["models"]}
assert list(models) == ["catenary", "inextensible", "parabola"] and all(m["solved"] for m in r["models"])
assert all(abs(v) < 1e-12 for v in models["catenary"]["error"].values())
for name, other in [("parabola", json.load(open("parabola.json"))),
                    ("inextensible", json.load(open("stiff.json")))]:
    m = models[name]
    assert other["model"] == name and other["irvine"] is None and other["epsilon"] == 0
    for key in ["H", "T0", "T1", "length0", "length", "sag"]:
        assert m[key] == other[key], (name, key)
        assert abs(m["error"][key] - (m[key] / exact[key] - 1)) < 1e-15
    assert 0 < m["error"]["position"] < 0.02 and abs(other["T0"] - 80000) < 1e-6
    x, y = other["profile"][-1][1:3]
    assert abs(x - 250) < 1e-9 and abs(y - 10) < 1e-9
table = rows("models.tsv")
assert [t["model"] for t in table] == list(models)
assert float(table[2]["error_sag"]) == models["parabola"]["error"]["sag"]
curve, table = json.load(open("curves.json"))["compatibility"], rows("curves.tsv")
assert len(table) == 7 and list(curve) == ["H", "delta", "epsilon", "eta", "l", "T0", "T1", "length0", "sag"]
assert abs(curve["H"][0] - 5000) < 1e-9 and abs(curve["H"][-1] - 5e5) < 1e-6
for i, H in enumerate(curve["H"]):
    assert abs(curve["epsilon"][i] * 400e6 / H - 1) < 1e-14
    assert abs(curve["delta"][i] * H / (6 * 9.81 * 250) - 1) < 1e-14
    assert abs(math.hypot(1, curve["eta"][i]) * H / curve["T0"][i] - 1) < 1e-14
    assert float(table[i]["sag_m"]) == curve["sag"][i]
END
works "a model without a solution" statics "$chairlift" --set 'tension={length0: 250.1}' --models \
	--json none.json
python "says so, and why" <<'END'
import json
models = json.load(open("none.json"))["models"]
assert [m["solved"] for m in models] == [True, False, False]
assert all("chord" in m["why"] for m in models[1:])
END

# --- comparing methods
works "compare modes" compare modes "$chairlift" -n 3 --to 32 --tsv compare.tsv --json compare.json
python "compare modes: errors fall, the method's own choice is among them" <<'END'
import csv, json
r = json.load(open("compare.json"))
modes = json.load(open("modes.json"))["modes"]
assert r["command"] == "compare modes" and r["reference"]["uncertainty"] < 1e-12
assert all(abs(a / m["omega"] - 1) < 1e-10 for a, m in zip(r["reference"]["omega"], modes))
assert {m["name"] for m in r["methods"]} == {run["method"] for run in r["runs"]}
spectral = [run for run in r["runs"] if run["method"] == "spectral"]
assert [run["chosen_by_method"] for run in spectral] == [False] * (len(spectral) - 1) + [True]
own = spectral[-1]
assert own["frequency_error"] < 1e-10 and own["shape_error"] < 1e-8
assert spectral[0]["shape_error"] > 1e-6 > spectral[-2]["shape_error"]
for run in r["runs"]:
    assert len(run["modes"]) == 3 and run["time_secs"] > 0
    assert run["frequency_error"] == max(m["frequency_error"] for m in run["modes"])
    assert run["shape_error"] == max(m["shape_error"] for m in run["modes"])
lines = [l for l in open("compare.tsv").read().split("\n") if not l.startswith("#")]
rows = list(csv.DictReader(lines, delimiter="\t"))
assert len(rows) == len(r["runs"])
for row, run in zip(rows, r["runs"]):
    assert row["method"] == run["method"] and float(row["shape_error_3"]) == run["modes"][2]["shape_error"]
END

# --- a cable that travels
works "modes of a travelling cable" modes "$chairlift" --set travel.hold=tension --set travel.speed="40 m/s" --tsv travel.tsv \
	--json travel.json
works "their shapes" modes "$chairlift" --set travel.hold=tension --set travel.speed="40 m/s" -n 2 --shapes --points 9 \
	--tsv travel-shapes.tsv --json travel-shapes.json
works "at no speed" modes "$chairlift" --set travel.hold=tension --set travel.speed=0 --tsv still.tsv
python "modes of a travelling cable: keys, the taut string, the resting table at no speed" <<'END'
import csv, json, math
r = json.load(open("travel.json"))
assert r["command"] == "modes" and r["method"] == "spectral" and len(r["modes"]) == 5
t = r["travel"]
assert t["speed"] == 40 and abs(t["tension"] / 8e4 - 1) < 1e-12
assert abs(t["apparent_tension"] / ((1 - t["mach2"]) * 8e4 - 6 * 40**2) - 1) < 1e-12
lowest = r["modes"][0]
assert lowest["plane"] == "out-of-plane" and lowest["re"] == 0 and lowest["im"] == lowest["omega"]
string = math.sqrt(8e4 / 6) / (2 * 250) * (1 - 40**2 * 6 / 8e4)
assert abs(lowest["frequency"] / string - 1) < 1e-2, (lowest["frequency"], string)
assert all(0 < m["downstream"] < 0.5 and m["residual"] < 1e-10 and m["condition"] < 2.5 for m in r["modes"])
lines = [l for l in open("travel.tsv").read().split("\n") if not l.startswith("#")]
rows = list(csv.DictReader(lines, delimiter="\t"))
assert [float(row["omega_rad_s"]) for row in rows] == [m["omega"] for m in r["modes"]]
shapes = json.load(open("travel-shapes.json"))["shapes"]
assert len(shapes["S"]) == 9 and len(shapes["modes"]) == 2
B = shapes["modes"][0]["B"]
assert abs(math.hypot(B["re"][4], B["im"][4]) - math.sqrt(2)) < 2e-2 and min(B["im"]) < -0.1
header = [l for l in open("travel-shapes.tsv").read().split("\n") if not l.startswith("#")][0].split("\t")
assert header[:3] == ["S_m", "P_re_1", "P_im_1"] and len(header) == 25
def table(name):
    return [l for l in open(name).read().split("\n") if not l.startswith("#")]
assert table("still.tsv") == table("modes.tsv")
END
works "compare modes of a travelling cable" compare modes "$chairlift" -n 1 --to 14 \
	--set travel.hold=tension --set travel.speed="40 m/s" --json compare-travel.json
python "compares its three methods" <<'END'
import json
r = json.load(open("compare-travel.json"))
assert [m["name"] for m in r["methods"]] == ["spectral", "analytic", "fdm-source"]
best = {m["name"]: min(x["frequency_error"] for x in r["runs"] if x["method"] == m["name"])
        for m in r["methods"]}
assert best["spectral"] < 1e-12 < best["analytic"] < 1e-2 and best["fdm-source"] < 2e-2, best
END

# --- numbers that are not finite have no way out
works "an inextensible cable" statics "$chairlift" --set cable.EA=.inf --json inf.json
python "has null for Irvine's parameter, and says .inf in its scene" <<'END'
import json
def refuse(text):
    raise ValueError(text)
r = json.loads(open("inf.json").read(), parse_constant=refuse)
assert r["irvine"] is None and r["scene"]["cable"]["EA"] == ".inf" and r["epsilon"] == 0
END
works "modes --list-methods" modes --list-methods
try "names spectral" grep -q '^spectral$' "$scratch/out"
works "export for AUTO-07p" rom "$chairlift" --export auto chair
try "writes equations and constants" test -s chair.f90 -a -s c.chair
works "a curve with its summary" frf "$duffing" --from 0.5 --to 2
largest=$(sed -n 's/^# largest estimated error of a point: //p' "$scratch/out")
column=$(grep -v '^#' "$scratch/out" | awk -F '\t' '
	NR == 1 { for (i = 1; i <= NF; i++) if ($i == "error") k = i; next }
	$k + 0 > most { most = $k + 0 }
	END { printf "%.1e", most }')
try "the summary has the largest error of the column" test "$largest" = "$column"
# --- a spectrum of whole periods: |f/(1 - w^2 + 0.3 i w)| on the bins of w = 0.5 and 1.5
cat >linear.json <<'END'
{"hawser_rom": 1, "n": 1, "D": [[0.3]], "K": [[1]], "harmonics": [{"k": 1, "f": [0.3]},
 {"k": 3, "phase": "sin", "f": [0.5]}]}
END
works "a linear oscillator" integrate linear.json --Omega 0.5 --until 40T --every 0.2T --spectrum \
	--json tones.json --tsv tones.tsv -q
works "with the forcing on no bin" integrate linear.json --Omega 0.5 --until 40T --every 0.9 --spectrum \
	--json off.json --tsv off.tsv -q
python "amplitudes of both harmonics, exact on bins, and lower by spectrum_loss elsewhere" <<'END'
import json
exact = [abs(f/(1 - w*w + 0.3j*w)) for f, w in ((0.3, 0.5), (0.5, 1.5))]
def tones(name):
    r = json.load(open(name + ".json"))
    m = round(r["spectrum_periods"])
    # 5 rows a period: the third harmonic is seen as the second, which is said
    return [r["spectrum"]["u_1"][k*m] for k in (1, 2)], r["spectrum_periods"], r["spectrum_loss"]
values, periods, loss = tones("tones")
assert periods == 20 and loss == 0 and all(abs(v/e - 1) < 1e-9 for v, e in zip(values, exact)), (values, exact)
values, periods, loss = tones("off")
assert 0 < loss < 1e-3 and abs(values[0]/(exact[0]*(1 - loss)) - 1) < 1e-5, (values, periods, loss)
assert "no bin" in open("off.tsv").read() and "no bin" not in open("tones.tsv").read()
assert "aliasing" in open("tones.tsv").read() and "aliasing" not in open("off.tsv").read()
END
# --- damping, of the tables that other commands write: the largest displacement unless told otherwise
works "a small response" frf "$chairlift" --set 'load.per_length=[0, 0, 0.001]' --from 0.95w1 --to 1.05w1 \
	--tsv small.tsv -q
works "its half-power points" damping small.tsv --half-power --json largest.json -q
works "of the column by its name" damping small.tsv --half-power --x Omega_rad_s --y z_mid_m --json name.json -q
works "and by its number" damping small.tsv --half-power --y 9 --json number.json -q
works "of another" damping small.tsv --half-power --y z_quarter_m --json other.json -q
python "the ratio is that of the scene, alpha over twice rho omega" <<'END'
import json
largest, name, number, other = (json.load(open(n + ".json")) for n in ("largest", "name", "number", "other"))
assert largest["y"] == name["y"] == number["y"] == "z_mid_m" and largest["x"] == "Omega_rad_s", largest
assert largest["ratio"] == name["ratio"] == number["ratio"], (largest, name, number)
for result in (largest, other):
    assert abs(result["ratio"]/(0.08/(2*6*1.4492191952)) - 1) < 2e-3, result
END
works "a measured decay" damping "$top/notebooks-data/scenes/decay.tsv" --json decay.json -q
python "holds the ratio with which it was made" <<'END'
import json
decay = json.load(open("decay.json"))
assert decay["y"] == "z_m" and decay["ratio_low"] < 0.0046 < decay["ratio_high"], decay
assert decay["ratio_high"] - decay["ratio_low"] < 2e-4, decay
END
done_testing

#!/usr/bin/env python3
# At which load tension is lost: by a mesh of cable elements, which becomes slack, and by reduced models,
# whose tension falls below 0. The table of doc/theory-study.md, "Slack".
# Usage: bench/slack.py HAWSER [FOLDER]: the program, and the folder of the scenes.
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import os
import subprocess
import sys

hawser = sys.argv[1]
folder = sys.argv[2] if len(sys.argv) > 2 else "notebooks-data/scenes"
MODELS = "condensed 12, raw 12, full 10"
CASES = (  # scene, Omega, load per length (N/m) with %g for the load that grows, loads
    ("chairlift.yaml", "1w2", "[0, %g, 0]", (10, 15, 20, 24, 26, 28, 40)),
    ("b-table-4.3-line-2.yaml", "1w1", "[0, 0, %g]", (2, 4, 5, 6, 8, 20)),
    ("inclined.yaml", "0.9w2", "[0, %g, %g]", (6, 10, 11, 12, 16, 24)),
    ("deep-sag.yaml", "1w1", "[0, %g, 0]", (4, 8, 12, 14, 16, 20)),
)


def motion(scene, omega, load):
    command = [hawser, "compare", "motion", os.path.join(folder, scene), "--Omega", omega, "--until", "20T",
               "--fidelities", MODELS, "--set", "load.per_length=" + load, "--json", "-", "-q"]
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    if run.returncode:
        sys.exit(run.stderr.decode())
    return json.loads(run.stdout)["runs"]


def cell(run):
    text = "–" if run["tension"]["min"] is None else "%.1f" % (run["tension"]["min"]/1e3)
    if run["slack_at"] is not None:
        text += ", %.1f s" % run["slack_at"]
    return text + (" (fails)" if "failed" in run else "")


for scene, omega, load, loads in CASES:
    print("\n%s, Omega = %s, load %s N/m\n" % (scene, omega, load.replace("%g", "f")))
    print("| f | mesh | " + " | ".join(MODELS.split(", ")) + " |")
    print("| --- | --- | --- | --- | --- |")
    for f in loads:
        runs = motion(scene, omega, load % ((f,)*load.count("%g")))
        print("| %g | %s |" % (f, " | ".join(cell(run) for run in runs)), flush=True)

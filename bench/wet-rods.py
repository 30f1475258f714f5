#!/usr/bin/env python3
"""wet-rods.py HAWSER [COUNT [SEED]]: random lines in water, with currents and waves, as rods that hardly bend and as cables of nets
with as many elements. It prints the largest differences of the forces on the supports, over the largest of the line, of the place
of the middle in 15 s of waves, over the length, and what is not solved. SPDX-License-Identifier: GPL-3.0-or-later"""
import json
import os
import random
import subprocess
import sys
import tempfile

WATER, ELEMENTS = 1025.0, 40


def scenes(draw):
    """The same line as a rod and as a net."""
    span, low, high, aside = draw(20, 120), draw(-80, -20), draw(-15, 6), draw(-30, 30)
    length = (span**2 + (high - low)**2 + aside**2)**0.5*draw(1.01, 1.2)
    diameter = draw(0.03, 0.3)
    displaced = WATER*0.7854*diameter**2
    rho, EA, period = displaced*draw(1.2, 4), 10**draw(6, 7.5), draw(5, 10)
    EI = 1e-5*(rho - displaced)*9.81*length*(length/60)**2
    water = {"density": WATER, "depth": 90, "ramp": period,
             "current": {"table": [[-90, draw(-1, 1), 0, draw(-1, 1)], [0, draw(-1, 1), 0, draw(-1, 1)]]},
             "waves": {"height": draw(1, 3), "period": period, "heading": draw(0, 6)}}
    line = {"rho": rho, "EA": EA, "elements": ELEMENTS, "diameter": diameter,
            "drag": {"normal": draw(0.5, 2), "tangential": draw(0, 0.1)},
            "added_mass": {"normal": draw(0, 2), "tangential": draw(0, 0.5)}}
    ends = [0, low, 0], [span, high, aside]
    rod = {"kind": "rod", "water": water, "start": {"at": ends[0], "tangent": [1, 0.3, 0.1], "hold": "hinged"},
           "end": {"at": ends[1], "hold": "hinged"},
           "rod": {**line, "length": length, "GA": EA, "EI": EI, "GJ": EI, "inertia": [max(rho*EI/EA, 1e-5)]*3}}
    net = {"kind": "net", "water": water, "nodes": {"A": ends[0], "B": ends[1]}, "supports": {"A": "fixed", "B": "fixed"},
           "cables": [{**line, "name": "c", "from": "A", "to": "B", "length0": length}]}
    return rod, net, length


def results(hawser, scene, arguments):
    """JSON of a command, or what it says."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.yaml")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(scene, file)
        run = subprocess.run([hawser, arguments[0], path, *arguments[1:], "--json", "-", "-q"], capture_output=True, text=True,
                             check=False)
    return json.loads(run.stdout) if run.returncode == 0 else run.stderr.strip()


def largest(one, other):
    return max(abs(a - b) for p, q in zip(one, other) for a, b in zip(p, q))


def main():
    count, seed = (int(word) for word in (sys.argv[2:] + ["30", "1"][len(sys.argv) - 2:])[:2])
    draw, forces, places, failed = random.Random(seed).uniform, 0.0, 0.0, 0
    for case in range(count):
        rod, net, length = scenes(draw)
        move = ["integrate", "--until", "15", "--every", "3", "--step", "0.02", "--probe"]
        got = [results(sys.argv[1], rod, ["statics"]), results(sys.argv[1], net, ["statics"]),
               results(sys.argv[1], rod, [*move, str(0.5*length), "--no-error"]), results(sys.argv[1], net, [*move, "c:0.5"])]
        for text in got:
            if isinstance(text, str):
                failed += 1
                print(f"case {case}: {text}")
        if any(isinstance(text, str) for text in got):
            continue
        reaction = [got[1]["reactions"][name] for name in "AB"]
        scale = max(abs(value) for force in reaction for value in force)
        forces = max(forces, largest([got[0][end]["force"] for end in ("start", "end")], reaction)/scale)
        middle = [next(iter(motion["probes"].values()))["x"] for motion in got[2:]]
        places = max(places, largest(*middle)/length)
    print(f"{count} lines from seed {seed}: forces on supports differ by {forces:.1e} of the largest, "
          f"places of the middle by {places:.1e} of the length; not solved: {failed}")


main()

#!/usr/bin/env python3
# bench/moorings.py PROGRAM [COUNT [SEED]] - random moorings in water by hawser statics: how many are not solved, and the stated
# error of the tensions against meshes with two and four times as many elements. One to three parts, slack to taut, with currents that
# may change over the depth, buoys, and a bed with a slope under most; with --floating a third of the parts is lighter than water;
# with --beds all have a profile or a grid of random heights, which gives way under half of them.
# The stated error holds where that of twice the elements is within 1.5 times the one stated, plus 1e-6.
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import math
import random
import os
import subprocess
import sys
import tempfile
import time

WATER = 1025.0


def hills(r, depth, folder):
    """A bed with slopes up to some 0.3 between its points, just below the anchor at the origin."""
    n, m, step = r.randrange(8, 16), r.randrange(6, 11), r.uniform(0.3, 1.0)*depth
    at = (n//3, m//3)
    x, z = ([step*(i - k) for i in range(count)] for k, count in zip(at, (n, m)))
    y = [[-1.01*depth + ((i, j) != at)*r.uniform(-0.12, 0.12)*step for i in range(n)] for j in range(m)]
    x[0], x[-1], z[0], z[-1] = -20*depth, 20*depth, -20*depth, 20*depth
    bed = {"name": "bed", **({"stiffness": 10**r.uniform(5, 7)} if r.random() < 0.5 else {})}
    if r.random() < 0.5:
        bed["profile"] = [list(point) for point in zip(x, y[at[1]])]
        return bed
    bed["grid"] = os.path.join(folder, "bed.txt")
    with open(bed["grid"], "w") as to:
        to.writelines("%r %r %r\n" % (x[i], y[j][i], z[j]) for j in range(m) for i in range(n))
    return bed


def scene(seed, floating, beds=None):
    r = random.Random(seed)
    depth, bed = r.uniform(30, 400), r.random() < 0.7
    slope = r.uniform(-0.08, 0.08) if bed else 0.0
    span, aside = r.uniform(0.3, 3)*depth, r.uniform(-0.5, 0.5)*depth
    end = [span, r.choice((0.0, -5.0)), aside]
    parts = r.choice((1, 1, 2, 3))
    chord = math.hypot(math.hypot(span, aside), depth + end[1])
    ratio = r.choice((r.uniform(0.985, 1), r.uniform(1, 1.05), r.uniform(1.05, 1.5)))
    shares = [r.uniform(0.5, 1.5) for _ in range(parts)]
    net = {"kind": "net", "nodes": {"A": [0, -depth, 0]}, "supports": {"A": "fixed", "B": "fixed"}, "cables": [],
           "water": {"density": WATER, "current": [r.uniform(-1.5, 1.5), 0, r.uniform(-1.5, 1.5)]}}
    if r.random() < 0.5:
        net["water"]["current"] = {"table": [[-depth, 0.1, 0, 0], [-depth/3, 0.4, 0, r.uniform(-1, 1)],
                                             [0, r.uniform(-1.5, 1.5), 0, r.uniform(-1, 1)]]}
    buoys = {}
    for i in range(parts):
        d = r.uniform(0.02, 0.25)
        heavy = (r.uniform(1.2, 8), r.uniform(1.02, 1.2), r.uniform(0.6, 0.98))
        rho = WATER*math.pi/4*d*d*heavy[r.randrange(3 if floating else 2)]
        net["cables"].append({
            "name": "c%d" % i, "from": "N%d" % i if i else "A", "to": "N%d" % (i + 1) if i < parts - 1 else "B",
            "EA": 10**r.uniform(6, 9)*(d/0.1)**2, "rho": rho, "length0": shares[i]/sum(shares)*chord*ratio, "diameter": d,
            "elements": 30, "drag": {"normal": r.uniform(0.8, 2.4), "tangential": r.uniform(0, 0.4)}})
        if i < parts - 1:
            net["nodes"]["N%d" % (i + 1)] = {}
            if r.random() < 0.5:
                buoys["N%d" % (i + 1)] = {"mass": r.uniform(100, 2000), "volume": r.uniform(0.1, 5), "CdA": r.uniform(0, 3)}
    net["nodes"]["B"] = end
    if buoys:
        net["buoys"] = buoys
    if bed:
        net["obstacles"] = [{"plane": {"point": [0, -depth], "normal": [-slope, 1]}}]
    if beds:
        net["obstacles"] = [hills(random.Random(seed + 10**6), depth, beds)]
    return net


def solved(program, net, factor):
    for cable in net["cables"]:
        cable["elements"] = 30*factor
    run = subprocess.run([program, "statics", "-", "--json", "-", "--quiet"], input=json.dumps(net), capture_output=True, text=True,
                         timeout=300)
    return json.loads(run.stdout) if run.returncode == 0 else run.stderr.strip()


def distance(a, b):
    most = max(cable["T_max"] for cable in b["cables"])
    return max(abs(x[key] - y[key])/max(y["T_max"], 0.01*most)
               for x, y in zip(a["cables"], b["cables"]) for key in ("T_from", "T_to", "T_max", "T_min"))


def main():
    words = [word for word in sys.argv[1:] if word not in ("--floating", "--beds")]
    program, count = words[0], int(words[1]) if len(words) > 1 else 200
    first, failed, beyond, began = int(words[2]) if len(words) > 2 else 1, 0, 0, time.process_time()
    ratios = []
    folder = tempfile.TemporaryDirectory()
    for seed in range(first, first + count):
        net = scene(seed, "--floating" in sys.argv, folder.name if "--beds" in sys.argv else None)
        found = [solved(program, net, factor) for factor in (1, 2, 4)]
        lost = [one for one in found if isinstance(one, str)]
        if lost:
            failed += 1
            print("%d: %s" % (seed, lost[0]))
            continue
        stated = found[0]["mesh_error"]["tension"]
        true = [distance(found[0], found[2]), distance(found[1], found[2])]
        ratios.append(true[0]/max(stated, 1e-12))
        if true[0] > 1.5*stated + 1e-6:
            beyond += 1
            print("%d: stated %.1e, against four times the elements %.1e, of twice the elements %.1e" % (seed, stated, *true))
    ratios.sort()
    print("%d moorings: %d not solved, %d with an error beyond the stated one; true over stated: median %.2f, 95 %% below %.2f" % (
        count, failed, beyond, ratios[len(ratios)//2], ratios[int(0.95*len(ratios))]))
    return failed > 0


sys.exit(main())

#!/usr/bin/python3
"""bench/net-judge.py - energies of random nets by hawser statics against a cone program (cvxopt).

    bench/net-random -n 200 -w DIR && bench/net-judge.py HAWSER DIR [COUNT]

The least energy of a mesh is that of sum of EA/(2 L) p^2 - f.q subject to |d(q)| <= L + p, p >= 0, for
each element with unstretched length L: cvxopt shares no code with hawser. Lengths are scaled by the size
of the net, forces by the loads. A net is wrong if the energies differ by more than 1e-6 of the
loads and tensions times the size, where cvxopt says that it is optimal. The status is then 1.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import json
import math
import subprocess
import sys

from cvxopt import matrix, solvers, spmatrix

solvers.options.update(show_progress=False, abstol=1e-10, reltol=1e-10, feastol=1e-9, maxiters=200)


def mesh_of(scene):
    """Nodes with place, held axes and force, and elements (ends, EA, L)."""
    names = list(scene["nodes"])
    place = [list(scene["nodes"][name]) for name in names]
    held = [scene["supports"].get(name, {"fixed": []})["fixed"] for name in names]
    force = [[0.0, -scene["g"]*scene["masses"][name], 0.0] for name in names]
    per_length, elements = {}, []
    for name, load in scene["loads"].items():
        if isinstance(load, dict):
            per_length[name] = load["per_length"]
        else:
            force[names.index(name)] = [a + b for a, b in zip(force[names.index(name)], load)]
    for cable in scene["cables"]:
        n, length = cable["elements"], cable["length0"]/cable["elements"]
        p = list(per_length.get(cable["name"], [0.0]*3))
        p[1] -= scene["g"]*cable["rho"]
        last = names.index(cable["from"])
        for i in range(n):
            if i == n - 1:
                to = names.index(cable["to"])
            else:
                to = len(place)
                place.append([0.0]*3)
                held.append([])
                force.append([0.0]*3)
            for end in (last, to):
                force[end] = [a + 0.5*length*b for a, b in zip(force[end], p)]
            elements.append((last, to, cable["EA"], length))
            last = to
    return place, held, force, elements


def least_energy(scene):
    """Energy by cvxopt, J, its status, and the size of the net, m, and the loads, N."""
    place, held, force, elements = mesh_of(scene)
    size = max(max(length for *_, length in elements), max(abs(x) for q in place for x in q))
    loads = sum(abs(x) for f in force for x in f) or 1e-6*min(EA for _, _, EA, _ in elements)
    unknown, count = {}, 0
    for i, axes in enumerate(held):
        for k in range(3):
            if "xyz"[k] not in axes:
                unknown[i, k] = count
                count += 1
    total, m = count + len(elements), len(elements)
    P = spmatrix([EA/length*size/loads for _, _, EA, length in elements], range(count, total),
                 range(count, total), (total, total))
    c = matrix(0.0, (total, 1))
    for (i, k), at in unknown.items():
        c[at] = -force[i][k]/loads
    fixed = -sum(force[i][k]/loads*place[i][k]/size for i in range(len(place)) for k in range(3)
                 if (i, k) not in unknown)
    values, rows, columns, h = [], [], [], [0.0]*(5*m)

    def put(row, column, value):
        values.append(value)
        rows.append(row)
        columns.append(column)

    for e, (a, b, _, length) in enumerate(elements):
        put(e, count + e, -1.0)
        put(m + 4*e, count + e, -1.0)
        h[m + 4*e] = length/size
        for k in range(3):
            row = m + 4*e + 1 + k
            for node, sign in ((a, 1.0), (b, -1.0)):
                if (node, k) in unknown:
                    put(row, unknown[node, k], sign)
                else:
                    h[row] -= sign*place[node][k]/size
    G = spmatrix(values, rows, columns, (5*m, total))
    try:
        found = solvers.coneqp(P, c, G, matrix(h), {"l": m, "q": [4]*m, "s": []})
    except (ArithmeticError, ValueError):
        return math.nan, "failed", size, loads
    return (found["primal objective"] + fixed)*loads*size, found["status"], size, loads


def main():
    program, folder = sys.argv[1:3]
    paths = sorted(glob.glob(folder + "/net-*.json"), key=lambda p: int(p.split("-")[-1][:-5]))
    wrong = undecided = worst = 0
    paths = paths[:int(sys.argv[3])] if len(sys.argv) > 3 else paths
    for path in paths:
        with open(path, encoding="utf-8") as file:
            scene = json.load(file)
        run = subprocess.run([program, "statics", path, "--json", "-", "-q"], capture_output=True, text=True,
                             check=False)
        if run.returncode:
            print(path, run.stderr.strip())
            wrong += 1
            continue
        own = json.loads(run.stdout)
        energy, status, size, loads = least_energy(scene)
        if status != "optimal":
            undecided += 1
            continue
        scale = max([loads] + [cable["T_max"] for cable in own["cables"]])*size
        error = abs(own["energy"] - energy)/scale
        worst = max(worst, error)
        if not error <= 1e-6:
            print(f"{path}: {own['energy']:.9g} J, cvxopt {energy:.9g} J")
            wrong += 1
    print(f"{len(paths)} nets, {wrong} wrong or failed; {undecided} where cvxopt found no optimum; energies "
          f"differ by {worst:.1e} at most")
    return 1 if wrong else 0


sys.exit(main())

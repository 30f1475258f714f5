#!/usr/bin/env python3
"""Branches that begin at period doublings and branch points, by hawser frf --branches and by AUTO-07p.

For each case hawser computes everything from the scene or model file: statics, modes, tensors, response,
events, and all branches that begin on it. AUTO gets the exported model; it follows the response over the
same frequencies, switches at each event of the kind, and follows the branch as far as hawser's goes without
a turn. There the two motions are compared over their whole period: AUTO's states at its mesh points against
hawser's, interpolated by their Fourier series, at the same phase of the load. The largest difference is
printed, relative to the largest state of its kind (coordinate or velocity). Coordinates may change signs
together, since a branch and its mirror image are one to both programs.

Processor times are of the whole hawser process and of all AUTO runs, without compiling.

Exit status: 0; 1 where a branch was not found or a difference exceeds --agree; 2 when a program failed.
SPDX-License-Identifier: GPL-3.0-or-later"""
import argparse
import importlib.util
import json
import math
import os
import shutil
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
SPEC = importlib.util.spec_from_file_location("locus_auto", os.path.join(HERE, "locus-auto.py"))
locus_auto = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(locus_auto)
frf_auto, Failed, call = locus_auto.frf_auto, locus_auto.Failed, locus_auto.call

STAY = os.path.join(locus_auto.SCENES, "stay-anchorage.yaml")
# Two equal oscillators, one of them loaded: above a threshold the other one joins in (whirling).
WHIRL = {"n": 2, "K": [[1, 0], [0, 1]], "D": [[0.02, 0], [0, 0.02]],
         "C": [[0, 0, 0, 0, 0.7], [0, 0, 1, 1, 0.7], [1, 0, 0, 1, 0.7], [1, 1, 1, 1, 0.7]],
         "harmonics": [{"k": 1, "phase": "cos", "f": [0.02, 0]}]}
TYPE = {"period-doubling": 7, "branch-point": 6}
# name, model, frequencies, kind of the events at which the branches begin
CASES = [
    ("stay", STAY, "1.97w1", "2.03w1", "period-doubling"),
    ("x''+.4x'+x-x^2", locus_auto.CASCADE, "1.6", "0.7", "period-doubling"),
    ("two oscillators", WHIRL, "0.9", "1.3", "branch-point"),
]


class Motion:
    """A periodic motion as states at equal steps over its period."""

    def __init__(self, states, periods):
        self.states, self.periods = states, periods
        self.sizes = [max(abs(row[i]) for row in states) for i in range(len(states[0]))]

    def at(self, phase):
        """States at a phase of the load, in radians from 0 to 2 pi `periods`: trigonometric
        interpolation in barycentric form, for an even number of points."""
        count = len(self.states)
        angle = phase/self.periods
        weights = []
        for k in range(count):
            half = (angle - 2*math.pi*k/count)/2
            if abs(math.sin(half)) < 1e-14:
                return self.states[k]
            weights.append((-1)**k/math.tan(half))
        total = sum(weights)
        return [sum(w*row[i] for w, row in zip(weights, self.states))/total
                for i in range(len(self.states[0]))]


def labelled(points):
    """The last point with a label before Omega turns for the first time."""
    way = points[1]["Omega"] - points[0]["Omega"]
    last = None
    for before, point in zip(points, points[1:]):
        if (point["Omega"] - before["Omega"])*way <= 0:
            break
        last = point if "label" in point else last
    return last


def hawser_run(args, case, directory):
    """Branches (Omega of birth, Omega of a label, motion there), points, processor time."""
    _, model, start, end, kind = case
    path = os.path.join(directory, "frf.json")
    command = [args.hawser, "frf", locus_auto.model_file(model, directory), "--from", start, "--to", end,
               "--branches", "1", "--tolerance", "%g" % args.ours, "--json", path, "--quiet"]
    seconds = min(call(command)[1] for _ in range(args.repeat))
    with open(path) as stream:
        result = json.load(stream)
    born = [e["Omega"] for e in result["events"] if e["kind"] == kind]
    branches = []
    for branch in result["branches"]:
        last = labelled(branch["points"])
        orbit = os.path.join(directory, "orbit.json")
        if min(abs(branch["born"]/omega - 1) for omega in born) > 1e-6:
            continue
        call([args.hawser, "orbit", "%s#%d" % (path, last["label"]), "--json", orbit, "--quiet"])
        with open(orbit) as stream:
            found = json.load(stream)
        rows = found["states"]
        motion = Motion(rows[:(len(rows) - 1)//2], found["orbit"]["period"])
        branches.append((branch["born"], last["Omega"], motion))
    points = sum(len(b["points"]) for b in result["branches"]) + len(result["points"])
    return branches, points, seconds


def last_solution(path):
    """States [points][unknowns] of the last solution of fort.8."""
    with open(path) as stream:
        lines = stream.readlines()
    at, states = 0, []
    while at < len(lines):
        head = [int(word) for word in lines[at].split()]
        points, columns, follow = head[6], head[7], head[8]
        numbers = [float(w) for line in lines[at + 1:at + 1 + follow] for w in line.split()]
        states = [numbers[i*columns + 1:(i + 1)*columns] for i in range(points)]
        at += 1 + follow
    return states


def auto_branch(args, directory, label, reach, born):
    """States, in AUTO's units, at the mesh points of a branch where Omega is `reach`; points, time."""
    constants = os.path.join(directory, "fort.2")
    shutil.copy(os.path.join(directory, "response.8"), os.path.join(directory, "fort.3"))
    shutil.copy(os.path.join(directory, "c.first"), constants)
    locus_auto.change_constants(constants, {"IRS": "%d" % label, "ISW": "-1", "ISP": "0", "ILP": "0",
                                            "DS": "%g" % args.step, "EPSS": "%g" % args.tolerance})
    with open(constants, "a") as stream:
        stream.write("\nUZSTOP={1: [%.17g]}\nRL0=%.17g, RL1=%.17g\n" % (
            reach, 0.5*min(reach, born), 2*max(reach, born)))
    seconds = call(["./span"], cwd=directory, limit=args.limit)[1]
    found = locus_auto.rows(os.path.join(directory, "fort.7"))[0]
    if not found or abs(found[-1][2][0]/reach - 1) > 1e-8:
        return None, len(found), seconds
    return last_solution(os.path.join(directory, "fort.8")), len(found), seconds


def auto_run(args, case, branches, directory):
    """For each branch the states at its mesh points, in SI, or None; points, processor time."""
    _, model, start, end, kind = case
    record = os.path.join(directory, "model.json")
    call([args.hawser, "rom", locus_auto.model_file(model, directory), "--json", record, "--export", "auto",
          os.path.join(directory, "span"), "--from", start, "--to", end, "--tolerance",
          "%g" % args.tolerance, "--intervals", "%d" % args.intervals, "--quiet"])
    with open(record) as stream:
        scale = json.load(stream).get("scale", {})
    time, length = scale.get("time", 1.0), scale.get("length", 1.0)
    call(["gfortran", "-O2", "-fopenmp", "span.f90", *frf_auto.auto_objects(), "-o", "span"], cwd=directory)
    shutil.move(os.path.join(directory, "c.span"), os.path.join(directory, "c.first"))
    shutil.copy(os.path.join(directory, "c.first"), os.path.join(directory, "fort.2"))
    seconds = call(["./span"], cwd=directory, limit=args.limit)[1]
    found = locus_auto.rows(os.path.join(directory, "fort.7"))[0]
    os.replace(os.path.join(directory, "fort.8"), os.path.join(directory, "response.8"))
    points, states = len(found), []
    for born, reach, _ in branches:
        near = [(abs(row[0]/(born*time) - 1), label) for type_, label, row in found
                if label and abs(type_) % 10 == TYPE[kind]]
        rows, count, taken = None, 0, 0.0
        if near and min(near)[0] <= 1e-4:
            rows, count, taken = auto_branch(args, directory, min(near)[1], reach*time, born*time)
        points, seconds = points + count, seconds + taken
        half = len(rows[0])//2 - 1 if rows else 0
        units = [length]*half + [length/time]*half + [1, 1]
        states.append(rows and [[x*u for x, u in zip(row, units)] for row in rows])
    return states, points, seconds


def signs(states, motion):
    """Patterns of signs under which both motions may be images of each other: coordinates that
    change theirs together. All are tried, but for those that are not there at all."""
    count = len(states[0])//2 - 1
    moving = [i for i in range(count) if motion.sizes[i] > 1e-12*max(motion.sizes[:count])]
    for bits in range(2**len(moving)):
        pattern = [1]*count
        for k, i in enumerate(moving):
            pattern[i] = -1 if bits >> k & 1 else 1
        yield pattern


def difference(states, motion):
    """Largest difference of both motions over their period, relative."""
    count = len(states[0])//2 - 1
    scale = [max(motion.sizes[:count])]*count + [max(motion.sizes[count:])]*count
    best = math.inf
    for shift in range(motion.periods):
        pairs, turn, before = [], shift, None
        for row in states[::4]:
            phase = math.atan2(row[-2], row[-1])
            turn += before is not None and phase < before - math.pi
            before = phase
            pairs.append((row, motion.at((phase + 2*math.pi*turn) % (2*math.pi*motion.periods))))
        for pattern in signs(states, motion):
            worst = max(abs(pattern[i % count]*ours[i] - row[i])/scale[i]
                        for row, ours in pairs for i in range(2*count))
            best = min(best, worst)
    return best


def bench(args, case, directory):
    """One case; 1 where a branch is not found or differs."""
    branches, our_points, our_seconds = hawser_run(args, case, directory)
    states, their_points, their_seconds = auto_run(args, case, branches, directory)
    found = [(rows, motion) for rows, (_, _, motion) in zip(states, branches) if rows]
    gap = max((difference(rows, motion) for rows, motion in found), default=math.inf)
    missed = len(branches) - len(found)
    print("%-16s %-16s %8d %4d %6d %6d  %8.1e %8.2f %8.2f %7.1f" % (
        case[0], case[4], len(branches), missed, our_points, their_points, gap, our_seconds, their_seconds,
        their_seconds/our_seconds), flush=True)
    return missed > 0 or gap > args.agree


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--hawser", default="hawser", help="the program (hawser)")
    parser.add_argument("--case", type=int, help="number of one case, from 1 (all)")
    parser.add_argument("--ours", type=float, default=1e-9, help="hawser: --tolerance (1e-9)")
    parser.add_argument("--tolerance", type=float, default=1e-10, help="AUTO: EPSL, EPSU, EPSS (1e-10)")
    parser.add_argument("--intervals", type=int, default=60, help="AUTO: NTST (60)")
    parser.add_argument("--step", type=float, default=1e-3, help="AUTO: first step of the branch (1e-3)")
    parser.add_argument("--repeat", type=int, default=3, help="hawser runs, fastest counts (3)")
    parser.add_argument("--agree", type=float, default=1e-7, help="relative, in the states (1e-7)")
    parser.add_argument("--limit", type=float, default=1800, help="s allowed to an AUTO run")
    parser.add_argument("--keep", help="work in this directory and leave it")
    args = parser.parse_args()
    args.hawser = os.path.abspath(args.hawser) if os.sep in args.hawser else args.hawser
    print("%-16s %-16s %8s %4s %6s %6s  %8s %8s %8s %7s" % (
        "model", "begin at", "branches", "miss", "points", "AUTO's", "differ", "cpu s", "AUTO s", "ratio"))
    return locus_auto.run_cases(args, CASES, bench, "branches-auto")


if __name__ == "__main__":
    sys.exit(main())

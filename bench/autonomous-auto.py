#!/usr/bin/env python3
"""Equilibria, Hopf points and limit cycles of autonomous models by hawser frf --over and by AUTO-07p.

    bench/autonomous-auto.py [--hawser PROGRAM] [--case N] [--repeat N]

hawser does all from the model file: equilibria, events, the cycles, their multipliers and events. AUTO gets the exported
model (hawser rom --export auto --over); it follows the equilibria, then the cycles from their Hopf point, at rising tolerances and
mesh intervals (--runs). The wake oscillator is unstable at all parameters, so that AUTO is given a cycle that hawser has found.

`error` is the largest relative distance of the landmarks (folds, a period doubling, the period at the end of the
range) from numbers known to 1e-11, by collocation and by shooting of other programs. Processor times are of the whole process of hawser
and of all AUTO runs, without compiling. `ratio` is that of AUTO's first run that is at least as accurate, in parentheses that of its most accurate one
where none is.

Exit status: 0; 1 where hawser misses a landmark by more than 1e-6; 2 when a program failed.
SPDX-License-Identifier: GPL-3.0-or-later"""
import argparse
import importlib.util
import json
import math
import os
import re
import shutil
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SPEC = importlib.util.spec_from_file_location("locus_auto", os.path.join(HERE, "locus-auto.py"))
locus_auto = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(locus_auto)
frf_auto, Failed, call = locus_auto.frf_auto, locus_auto.Failed, locus_auto.call
MODELS = os.path.join(HERE, "..", "tests", "reference", "autonomous")

TYPE = {"fold": 5, "period-doubling": 7}
# model, key, range, first equilibrium or None, AUTO's largest step along cycles, {kind: values of the parameter}, period at the end or None
CASES = [
    ("brusselator", "B", (0.5, 3.0), None, 0.2, {}, 7.156919921180),
    ("adaptx", "a", (1.5, 0.6), None, 0.05, {"period-doubling": [0.630302006158]}, None),
    ("lorenz", "r", (26.0, 20.0), [math.sqrt(200.0/3.0), math.sqrt(200.0/3.0), 25.0], 0.5, {}, 0.876552253492),
    ("parkinson", "U", (1.0, 9.0), None, 0.1, {"fold": [6.2198121722, 4.1936879711]}, None),
    ("wake", "Ur", (4.0, 6.5), None, 0.1,
     {"fold": [4.79796645954, 4.72394978906, 5.44218513218, 5.28571255274]}, None),
    # the iced conductor of notebooks-data with 4, 8 and 16 modes, 8 to 32 states: the period at 6 m/s, by shooting
    ("conductor 4", "wind.speed", (2.0, 6.0), None, 0.2, {}, 2.643223605),
    ("conductor 8", "wind.speed", (2.0, 6.0), None, 0.2, {}, 2.641321472),
    ("conductor 16", "wind.speed", (2.0, 6.0), None, 0.2, {}, 2.641391041),
]
SCENE = os.path.join(HERE, "..", "notebooks-data", "scenes", "conductor-iced.yaml")


def model_of(name):
    """Its file, and options."""
    return [SCENE, "-n", name.split()[1]] if " " in name else [os.path.join(MODELS, name + ".json")]


def worst(found, landmarks):
    """found: {kind: values}."""
    errors = [min((abs(x/value - 1) for x in found.get(kind, [])), default=math.inf)
              for kind, values in landmarks.items() for value in values]
    return max(errors, default=0.0)


def time_unit(args, name):
    """Of the exported equations, s."""
    if " " not in name:
        return 1.0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "rom.json")
        call([args.hawser, "rom", *model_of(name), "--json", path, "--quiet"])
        with open(path, encoding="utf-8") as stream:
            return json.load(stream)["scale"]["time"]


def hawser_run(args, case, folder):
    """Error, points, processor time, and the first cycle's labelled motion where there is no Hopf point."""
    name, key, (low, high), rest, _, landmarks, period = case
    path, start = os.path.join(folder, "frf.json"), os.path.join(folder, "start")
    command = [args.hawser, "frf", *model_of(name), "--over", "%s=%r:%r" % (key, low, high),
               "--branches", "1", "--json", path, "--quiet"]
    if rest:
        with open(start, "w", encoding="utf-8") as to:
            to.write(" ".join("%r" % x for x in rest + [0.0]*len(rest)))
        command += ["--start", start]
    seconds = min(call(command)[1] for _ in range(args.repeat))
    with open(path, encoding="utf-8") as stream:
        result = json.load(stream)
    branch = result["branches"][0]
    found = {kind: [e["parameter"] for e in branch["events"] if e["kind"] == kind] for kind in TYPE}
    error = worst(found, landmarks)
    if period:
        last = branch["points"][-1]
        error = max(error, abs(2*math.pi/last["Omega"]/period - 1) if last["parameter"] == high else math.inf)
    return error, len(result["points"]) + len(branch["points"]), seconds, branch["points"][0]


def give_cycle(args, case, point, folder):
    """The cycle at a point as AUTO's span.dat: time, state; and its value of the parameter."""
    name, key = case[:2]
    start, out = os.path.join(folder, "start"), os.path.join(folder, "motion.json")
    with open(start, "w", encoding="utf-8") as to:
        to.write(" ".join("%r" % x for x in point["state"]))
    period = 2*math.pi/point["Omega"]
    call([args.hawser, "integrate", os.path.join(MODELS, name + ".json"), "--set", "%s=%r" % (key, point["parameter"]),
          "--initial", start, "--until", "%r" % period, "--every", "%r" % (period/400), "--json", out, "--quiet"])
    with open(out, encoding="utf-8") as stream:
        motion = json.load(stream)
    with open(os.path.join(folder, "span.dat"), "w", encoding="utf-8") as to:
        for t, state in zip(motion["times"], motion["states"]):
            to.write(" ".join("%.17g" % x for x in [t] + state) + "\n")
    return point["parameter"], period


def run(args, folder, changes, more=""):
    """One AUTO run: rows of fort.7, its processor time."""
    constants = os.path.join(folder, "fort.2")
    shutil.copy(os.path.join(folder, "c.span"), constants)
    locus_auto.change_constants(constants, changes)
    with open(constants, "a", encoding="utf-8") as stream:
        stream.write(more)
    seconds = call(["./span"], cwd=folder, limit=args.limit)[1]
    return locus_auto.rows(os.path.join(folder, "fort.7"))[0], seconds


def set_start(folder, rest):
    """The equilibrium in STPNT."""
    path = os.path.join(folder, "span.f90")
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    for j, x in enumerate(rest):
        text = re.sub(r"U\(%d\) = \S+" % (j + 1), "U(%d) = %sD0" % (j + 1, repr(x)), text)
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text)


def auto_run(args, case, tolerance, intervals, first, folder):
    """Error, points, processor time."""
    name, key, (low, high), rest, step, landmarks, period = case
    call([args.hawser, "rom", *model_of(name), "--export", "auto", os.path.join(folder, "span"),
          "--over", "%s=%r:%r" % (key, low, high), "--tolerance", "%g" % tolerance, "--intervals", "%d" % intervals,
          "--quiet"])
    if rest:
        set_start(folder, rest)
    call(["gfortran", "-O2", "-fopenmp", "span.f90", *frf_auto.auto_objects(), "-o", "span"], cwd=folder)
    cycles = {"IPS": "2", "ICP": "[1,11]", "DS": "%g" % (0.1*step), "DSMIN": "%g" % (1e-5*step), "DSMAX": "%g" % step,
              "NMX": "3000"}
    end = "UZSTOP={1: [%.17g]}\n" % high
    if first:
        at, length = give_cycle(args, case, first, folder)
        found, seconds = run(args, folder, {**cycles, "DS": "%g" % (0.1*step)},
                             "\ndat='span'\nPAR={1: %.17g, 2: 1.0, 3: 1.0, 11: %.17g}\n" % (at, length) + end)
    else:
        found, seconds = run(args, folder, {})
        hopf = [label for kind, label, _ in found if kind == 3]
        if not hopf:
            raise Failed("AUTO finds no Hopf point of %s" % name)
        points = len(found)
        os.replace(os.path.join(folder, "fort.8"), os.path.join(folder, "fort.3"))
        found, more = run(args, folder, {**cycles, "IRS": "%d" % hopf[0]}, end)
        seconds, found = seconds + more, found + [None]*points
    rows = [row for row in found if row]
    events = {kind: [row[0] for type_, _, row in rows if abs(type_) % 10 == number] for kind, number in TYPE.items()}
    error = worst(events, landmarks)
    if period:
        unit = time_unit(args, name)
        error = max(error, min((abs(unit*row[-1]/period - 1) for _, _, row in rows if abs(row[0]/high - 1) < 1e-6),
                               default=math.inf))
    return error, len(found), seconds


def bench(args, case):
    with tempfile.TemporaryDirectory() as folder:
        ours = hawser_run(args, case, folder)
        hopf = case[0] != "wake"
        text = ("%-12s hawser %26d %9.1e %8.2f" % (case[0], ours[1], ours[0], ours[2]))
        print(text)
        ratio, best = None, (math.inf, 0.0)
        for choice in args.runs.split():
            tolerance, intervals = choice.split("/")
            theirs = auto_run(args, case, float(tolerance), int(intervals), None if hopf else ours[3], folder)
            better = ratio is None and theirs[0] <= ours[0]
            ratio = theirs[2]/ours[2] if better else ratio
            best = min(best, (theirs[0], theirs[2]/ours[2]))
            print("%-12s AUTO %-10s %17d %9.1e %8.2f%s" % ("", choice, theirs[1], theirs[0], theirs[2],
                                                          " %7.1f" % ratio if better else ""), flush=True)
        if ratio is None:
            print("%-12s most accurate AUTO run: %31s(%.1f)" % ("", "", best[1]))
    return not ours[0] < 1e-6


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hawser", default="./hawser")
    parser.add_argument("--case", type=int, help="only this one, from 1")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--runs", default="1e-7/20 1e-8/40 1e-10/80 1e-11/160", help="AUTO's tolerances/mesh intervals")
    parser.add_argument("--limit", type=float, default=300.0)
    args = parser.parse_args()
    args.hawser = os.path.abspath(args.hawser)
    bad = 0
    print("%-12s %-15s %17s %9s %8s %7s" % ("model", "program", "points", "error", "cpu s", "ratio"))
    try:
        for i, case in enumerate(CASES, 1):
            if args.case in (None, i):
                bad += bench(args, case)
    except Failed as failure:
        print(failure, file=sys.stderr)
        return 2
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())

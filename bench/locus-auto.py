#!/usr/bin/env python3
"""Bifurcations in two parameters by hawser locus and by AUTO-07p, on the same model, in one run.

For each case hawser computes everything from the scene or model file: statics, modes, tensors, response,
events, and the curves of all events of a kind, both ways. AUTO gets the exported model at the middle
value of the parameter; it follows the response over the same frequencies, then the curve of each such
event both ways to the ends of the parameter's range. Compared are the frequencies at these ends.

Processor times are of the whole hawser process, and of all AUTO runs without compiling.

Exit status: 0; 1 where a curve of AUTO has no partner, or an end differs by more than --agree; 2 when a
program failed.
SPDX-License-Identifier: GPL-3.0-or-later"""
import argparse
import importlib.util
import json
import os
import shutil
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SPEC = importlib.util.spec_from_file_location("frf_auto", os.path.join(HERE, "frf-auto.py"))
frf_auto = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(frf_auto)
Failed, call, change_constants = frf_auto.Failed, frf_auto.call, frf_auto.change_constants

SCENES = os.path.join(HERE, "..", "notebooks-data", "scenes")
CHAIRLIFT = os.path.join(SCENES, "chairlift.yaml")
CASCADE = {"n": 1, "K": [[1]], "D": [[0.4]], "Q": [[0, 0, 0, -1]],
           "harmonics": [{"k": 1, "phase": "cos", "f": [0.3]}]}
PARAMETER = {"factor.load": 2, "factor.damping": 3}
TYPE = {"fold": 5, "period-doubling": 7, "torus": 8}
# name, model, --set, kind, frequencies, parameter, its range
HEAVY = ["--set", "load.per_length=[1.2 N/m, 1.2 N/m, 1.2 N/m]"]
CASES = [
    ("chairlift", CHAIRLIFT, [], "fold", "2.7", "3.1", "factor.load", 0.7, 1.3),
    ("chairlift", CHAIRLIFT, [], "fold", "2.7", "3.1", "factor.damping", 0.7, 1.3),
    ("chairlift", CHAIRLIFT, [], "torus", "2.7", "3.1", "factor.load", 0.9, 1.1),
    ("chairlift", CHAIRLIFT, [], "torus", "2.7", "3.1", "factor.damping", 0.9, 1.1),
    ("chairlift, load 1.5", CHAIRLIFT, HEAVY, "period-doubling", "2.7", "3.1", "factor.load", 0.97, 1.03),
    ("chairlift, load 1.5", CHAIRLIFT, HEAVY, "period-doubling", "2.7", "3.1", "factor.damping", 0.97,
     1.03),
    ("x''+.4x'+x-x^2", CASCADE, [], "period-doubling", "1.6", "0.7", "factor.load", 0.8, 1.2),
    ("x''+.4x'+x-x^2", CASCADE, [], "period-doubling", "1.6", "0.7", "factor.damping", 0.8, 1.1),
]


def model_file(model, directory):
    """Path of a model that is a scene's path or a dictionary."""
    if isinstance(model, str):
        return model
    path = os.path.join(directory, "own.json")
    with open(path, "w") as stream:
        json.dump(model, stream)
    return path


def hawser_run(args, case, directory):
    """Curves [[(parameter, Omega) of each end]], points, processor time."""
    _, model, changes, kind, start, end, key, low, high = case
    path = os.path.join(directory, "locus.json")
    command = [args.hawser, "locus", model_file(model, directory), *changes, "--kind", kind, "--from", start,
               "--to", end, "--over", "%s=%g:%g" % (key, low, high), "--json", path, "--quiet"]
    seconds = min(call(command)[1] for _ in range(args.repeat))
    with open(path) as stream:
        result = json.load(stream)
    ends = [(c["points"][k]["parameter"], c["points"][k]["Omega"]) for c in result["curves"]
            for k in (0, -1)]
    return ends, sum(len(c["points"]) for c in result["curves"]), seconds


def rows(path):
    """(type, label, columns from the fifth) of the points of fort.7, and names of these columns."""
    found, names = [], []
    with open(path) as stream:
        for line in stream:
            word = line.split()
            if len(word) > 5 and word[0] == "0" and word[1] == "PT":
                names = line.replace("MAX U(", "MAXU(").replace("MIN U(", "MINU(").split()[4:]
            elif len(word) > 5 and word[0] != "0":
                found.append((int(word[2]), int(word[3]), [float(x) for x in word[4:]]))
    return found, names


def auto_curve(args, directory, label, numbers, case, sign):
    """The curve of one event, one way: its last (parameter, Omega scaled), points, processor time."""
    _, _, _, kind, _, _, key, low, high = case
    seconds, last = 0.0, None
    for start in (label, None):  # the first run makes the extended system only
        shutil.copy(os.path.join(directory, "c.first"), os.path.join(directory, "fort.2"))
        step = args.dsmax*(high - low)
        change_constants(os.path.join(directory, "fort.2"), {
            "IRS": "%d" % (start or last[1]), "ISW": "2", "ILP": "0", "ISP": "0",
            "ICP": "[%s]" % ", ".join(str(i) for i in numbers), "DS": "%g" % (0.1*sign*step),
            "DSMAX": "%g" % step, "DSMIN": "%g" % (1e-6*step), "EPSL": "%g" % args.tolerance,
            "EPSU": "%g" % args.tolerance, "EPSS": "%g" % args.tolerance, "NTST": "%d" % args.intervals})
        with open(os.path.join(directory, "fort.2"), "a") as stream:
            stream.write("\nUZSTOP={%d: [%.17g, %.17g]}\n" % (PARAMETER[key], low, high))
        seconds += call(["./span"], cwd=directory, limit=args.limit)[1]
        found, names = rows(os.path.join(directory, "fort.7"))
        if not found:
            return None, 0, seconds
        last = found[-1]
        os.replace(os.path.join(directory, "fort.8"), os.path.join(directory, "fort.3"))
    column = names.index("load" if key == "factor.load" else "damping")
    return (last[2][column], last[2][0]), len(found), seconds


def auto_run(args, case, directory):
    """As hawser_run."""
    _, model, changes, kind, start, end, key, _, _ = case
    model = model_file(model, directory)
    record = os.path.join(directory, "model.json")
    call([args.hawser, "rom", model, *changes, "--json", record, "--export", "auto",
          os.path.join(directory, "span"), "--from", start, "--to", end, "--tolerance",
          "%g" % args.tolerance, "--intervals", "%d" % args.intervals, "--quiet"])
    with open(record) as stream:
        per_omega = 1/json.load(stream).get("scale", {}).get("time", 1.0)
    call(["gfortran", "-O2", "-fopenmp", "span.f90", *frf_auto.auto_objects(), "-o", "span"], cwd=directory)
    shutil.move(os.path.join(directory, "c.span"), os.path.join(directory, "c.first"))
    shutil.copy(os.path.join(directory, "c.first"), os.path.join(directory, "fort.2"))
    seconds = call(["./span"], cwd=directory, limit=args.limit)[1]
    labels = [label for type_, label, _ in rows(os.path.join(directory, "fort.7"))[0]
              if type_ > 0 and type_ % 10 == TYPE[kind] or type_ < 0 and label and -type_ % 10 == TYPE[kind]]
    os.replace(os.path.join(directory, "fort.8"), os.path.join(directory, "response.8"))
    numbers = [1, PARAMETER[key], 11] + ([12] if kind == "torus" else [])
    ends, points = [], 0
    for label in labels:
        for sign in (1, -1):
            shutil.copy(os.path.join(directory, "response.8"), os.path.join(directory, "fort.3"))
            last, count, taken = auto_curve(args, directory, label, numbers, case, sign)
            seconds, points = seconds + taken, points + count
            if last:
                ends.append((last[0], last[1]*per_omega))
    return ends, points, seconds


def bench(args, case, directory):
    """One case; 1 where something of AUTO's is not found or differs."""
    ours, our_points, our_seconds = hawser_run(args, case, directory)
    theirs, their_points, their_seconds = auto_run(args, case, directory)
    worst, missed, early = 0.0, 0, 0
    for value, omega in theirs:
        if min(abs(value - end) for end in case[-2:]) > 1e-6:
            early += 1  # AUTO ended within the range: at a frequency's end, or without convergence
            continue
        gap = min((abs(o/omega - 1) for p, o in ours if abs(p - value) < 1e-6), default=1.0)
        missed += gap > args.same
        worst = worst if gap > args.same else max(worst, gap)
    print("%-20s %-16s %-15s %3d %4d %5d %7d  %8.1e %8.2f %8.2f %7.1f" % (
        case[0], case[3], case[6], len(theirs) - early, missed, our_points, their_points, worst, our_seconds,
        their_seconds, their_seconds/our_seconds), flush=True)
    if early:
        print("%20s %d of AUTO's runs ended within the range" % ("", early))
    return missed > 0 or worst > args.agree or len(theirs) == early


def run_cases(args, cases, one, name):
    """Exit status of one(args, case, directory) for all cases, or for that of --case, in a folder that
    goes, or in --keep."""
    status = 0
    for number, case in enumerate(cases, 1):
        if args.case and number != args.case:
            continue
        try:
            with tempfile.TemporaryDirectory() as directory:
                if args.keep:
                    os.makedirs(args.keep, exist_ok=True)
                status |= one(args, case, args.keep or directory)
        except Failed as error:
            print("%s: %s" % (name, error), file=sys.stderr)
            return 2
    return status


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--hawser", default="hawser", help="the program (hawser)")
    parser.add_argument("--case", type=int, help="number of one case, from 1 (all)")
    parser.add_argument("--tolerance", type=float, default=1e-10, help="AUTO: EPSL, EPSU, EPSS (1e-10)")
    parser.add_argument("--intervals", type=int, default=60, help="AUTO: NTST (60)")
    parser.add_argument("--dsmax", type=float, default=0.05, help="AUTO: DSMAX over the range (0.05)")
    parser.add_argument("--repeat", type=int, default=3, help="hawser runs, fastest counts (3)")
    parser.add_argument("--agree", type=float, default=1e-8, help="relative, in Omega (1e-8)")
    parser.add_argument("--same", type=float, default=1e-5, help="relative, of ends of one curve (1e-5)")
    parser.add_argument("--limit", type=float, default=1800, help="s allowed to an AUTO run")
    parser.add_argument("--keep", help="work in this directory and leave it")
    args = parser.parse_args()
    args.hawser = os.path.abspath(args.hawser) if os.sep in args.hawser else args.hawser
    print("%-20s %-16s %-15s %s %s %s %s  %8s %8s %8s %7s" % (
        "model", "kind", "over", "end", "miss", "points", "AUTO's", "differ", "cpu s", "AUTO s", "ratio"))
    return run_cases(args, CASES, bench, "locus-auto")


if __name__ == "__main__":
    sys.exit(main())

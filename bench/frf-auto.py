#!/usr/bin/env python3
"""The frequency response of a span by hawser and by AUTO-07p, on the same model, in one run.

hawser exports its reduced model as AUTO equations; AUTO follows the response at a loose and at a
tight tolerance; hawser does its whole work (statics, modes, tensors, curve, multipliers, events)
from the scene. The events of all runs are matched, then the wall times are set side by side.

AUTO is run as it is meant to be run by hand: the exported file is compiled with gfortran and linked
with AUTO's objects; compiling is timed apart. Threads are 1 unless asked otherwise: AUTO's OpenMP
loops wait actively, so that more threads than idle cores make it slower, not faster.

The tight AUTO run judges. A loose one may stray to a neighbouring branch and find its events: what it found
and the tight run did not is listed and does not count.

Exit status: 0; 1 when the tight AUTO run found an event that hawser did not (or with another kind), or an
Omega differs by more than --agree, or AUTO left the branch; 2 when a program failed.
SPDX-License-Identifier: GPL-3.0-or-later"""
import argparse
import glob
import json
import os
import re
import subprocess
import sys
import tempfile
import time

KINDS = {5: "fold", 6: "branch-point", 7: "period-doubling", 8: "torus"}
SAME = 3e-5  # events of one kind closer than this, relative, are the same event


class Failed(Exception):
    pass


class Run:
    """One traced response: its name, events [(kind, Omega)], points, times (wall, processor)."""

    def __init__(self, name, events, points, times, note=""):
        self.name, self.events, self.points = name, events, points
        (self.secs, self.cpu_secs), self.note = times, note
        self.astray = False  # left the branch: its events say nothing about the others'


def call(command, cwd=None, threads=1, limit=1800, log=None):
    """Run a command; its wall and processor time in s."""
    env = dict(os.environ, OMP_NUM_THREADS=str(threads), OPENBLAS_NUM_THREADS="1")
    start, before = time.monotonic(), os.times()
    try:
        done = subprocess.run(command, cwd=cwd, env=env, timeout=limit, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    except FileNotFoundError as error:
        raise Failed(str(error)) from error
    except subprocess.TimeoutExpired as error:
        raise Failed("%s: not done after %g s" % (command[0], limit)) from error
    secs, after = time.monotonic() - start, os.times()
    cpu_secs = (after.children_user - before.children_user
                + after.children_system - before.children_system)
    if log:
        with open(log, "w") as stream:
            stream.write(done.stdout)
    if done.returncode != 0:
        raise Failed("%s: status %d\n%s" % (" ".join(command), done.returncode,
                                            done.stdout[-2000:]))
    return secs, cpu_secs


# --- hawser

def hawser_frf(args, directory, tolerance):
    """The whole run from the scene, the fastest of a few."""
    path = os.path.join(directory, "frf.json")
    command = [args.hawser, "frf", args.scene, "--from", args.start, "--to", args.end,
               "--tolerance", "%g" % tolerance, "--json", path, "--quiet"]
    times = min(call(command) for _ in range(args.repeat))
    with open(path) as stream:
        result = json.load(stream)
    events = [(event["kind"], event["Omega"]) for event in result["events"]]
    suspected = sum(bool(event.get("suspected")) for event in result["events"])
    note = "%d suspected" % suspected if suspected else ""
    return Run("hawser %g" % tolerance, events, len(result["points"]), times,
               note), result["points"][-1]["Omega"]


def export(args, directory, tolerance, intervals):
    """Write model.json, the equations and constants; the scaled-to-rad/s factor."""
    model = os.path.join(directory, "model.json")
    call([args.hawser, "rom", args.scene, "--json", model, "--export", "auto",
          os.path.join(directory, "span"), "--from", args.start, "--to", args.end,
          "--tolerance", "%g" % tolerance, "--intervals", "%d" % intervals, "--quiet"])
    with open(model) as stream:
        return 1/json.load(stream).get("scale", {}).get("time", 1.0)


# --- AUTO

def change_constants(path, changes):
    """Replace `NAME = value` in an AUTO constants file, or add it."""
    with open(path) as stream:
        text = stream.read()
    for name, value in changes.items():
        old = r"\b%s\s*=\s*(\{[^}]*\}|\[[^\]]*\]|[^,\s]+)" % name
        text, found = re.subn(old, "%s=%s" % (name, value), text)
        if not found:
            text += "%s=%s\n" % (name, value)
    with open(path, "w") as stream:
        stream.write(text)


def weights(path, states):
    """Weights of the states in AUTO's arclength, where the constants file has none: modal
    coordinates are some 1e-3, Omega is some units, and unweighted AUTO leaves the branch."""
    with open(path) as stream:
        text = stream.read()
    weighted = re.search(r"\bTHU\s*=\s*\{\s*1\s*:", text)
    if weighted or not states:
        return {}
    unknowns = int(re.search(r"\bNDIM\s*=\s*(\d+)", text).group(1))
    listed = ["%d:%g" % (i, states) for i in range(1, unknowns - 1)]
    listed += ["%d:0.0" % i for i in (unknowns - 1, unknowns)]  # the forcing's own pair
    return {"THU": "{%s}" % ", ".join(listed)}


def auto_objects():
    """AUTO's object files, from $AUTO_DIR or where Debian puts them."""
    root = os.environ.get("AUTO_DIR", "/usr/lib/auto-07p")
    objects = sorted(glob.glob(os.path.join(root, "lib", "*.o")))
    if not objects:
        raise Failed("no AUTO-07p object files in %s/lib (set AUTO_DIR)" % root)
    return objects


def read_branch(path, per_omega):
    """Events, number of points and last Omega of fort.7, whose columns are branch, point, type,
    label, Omega, ..."""
    events, points, end = [], 0, None
    with open(path) as stream:
        for line in stream:
            word = line.split()
            if len(word) < 6 or word[0] == "0":
                continue
            points += 1
            kind = int(word[2]) % 10 if int(word[2]) > 0 else int(word[2])
            if kind in KINDS:
                events.append((KINDS[kind], float(word[4])*per_omega))
            end = float(word[4])*per_omega
    return events, points, end


def auto_run(args, directory, name, tolerance, intervals, reach):
    """Export, compile, follow. `reach` is the range's end in rad/s."""
    per_omega = export(args, directory, tolerance, intervals)
    changes = {"EPSS": "%g" % (100*tolerance)}
    if args.dsmax:
        changes["DSMAX"] = "%g" % args.dsmax
    constants = os.path.join(directory, "c.span")
    set_here = weights(constants, args.weight)
    change_constants(constants, {**changes, **set_here})
    compiling, _ = call(["gfortran", "-O2", "-fopenmp", "span.f90", *auto_objects(), "-o", "span"],
                        cwd=directory)
    os.replace(constants, os.path.join(directory, "fort.2"))
    times = call(["./span"], cwd=directory, threads=args.threads, limit=args.limit,
                 log=os.path.join(directory, name + ".log"))
    events, points, end = read_branch(os.path.join(directory, "fort.7"), per_omega)
    note = "compiled in %.1f s, not counted" % compiling
    if set_here:
        note += "; states weighted by %g in its arclength" % args.weight
    run = Run("AUTO %g/%d" % (tolerance, intervals), events, points, times, note)
    run.astray = not end or abs(end/reach - 1) > 0.01
    if run.astray:
        run.note += "; DID NOT REACH THE END OF THE RANGE"
    return run


# --- side by side

def match(run, reference):
    """For every reference event its Omega in `run` (or None), and the events left over."""
    left, found = list(run.events), []
    for kind, omega in reference:
        near = [e for e in left if e[0] == kind and abs(e[1]/omega - 1) < SAME]
        best = min(near, key=lambda e: abs(e[1]/omega - 1), default=None)
        if best:
            left.remove(best)
        found.append(best[1] if best else None)
    return found, left


def all_events(runs):
    """Events of the first run in order, then what only others found."""
    events = list(runs[0].events)
    for run in runs[1:]:
        events += [] if run.astray else match(run, events)[1]
    return events


def show_events(runs, events, columns):
    print("%-16s" % "event" + "".join("%20s" % run.name for run in runs) + "  rad/s")
    for i, (kind, _) in enumerate(events):
        cells = ["%20s" % ("%.12g" % c[i] if c[i] is not None else "missed") for c in columns]
        print("%-16s" % kind + "".join(cells))


def worst(a, b, events, kinds=None):
    """Largest relative difference of two columns, over the events that both have."""
    both = [abs(x/y - 1) for x, y, e in zip(a, b, events)
            if x is not None and y is not None and (kinds is None or e[0] in kinds)]
    return max(both, default=float("nan"))


def counts(run):
    kinds = [kind for kind, _ in run.events]
    return ", ".join("%d %s" % (kinds.count(k), k) for k in KINDS.values() if k in kinds)


def show_runs(runs, events, columns):
    """One line a run: what it found, how far from the tight AUTO, how long."""
    print("\n%-16s %8s %9s %9s   %-14s %s" % ("run", "points", "wall s", "cpu s", "folds vs",
                                             "found"))
    print("%-16s %8s %9s %9s   %-14s" % ("", "", "", "", runs[-1].name))
    for run, column in zip(runs, columns):
        error = worst(column, columns[-1], events, {"fold"})
        print("%-16s %8d %9.3f %9.3f   %-14.1e %s%s" % (
            run.name, run.points, run.secs, run.cpu_secs, error, counts(run),
            "; " + run.note if run.note else ""))
    ours = [run for run in runs if run.name.startswith("hawser")]
    theirs = [run for run in runs if run not in ours]
    print()
    for a in ours:
        for b in theirs:
            print("%s is %.1f times faster than %s (processor time %.1f)" % (
                a.name, b.secs/a.secs, b.name, b.cpu_secs/a.cpu_secs))


def judge(args, runs, events, columns):
    """Does hawser have every event that the tight AUTO run (the last) found, and where?"""
    good = True
    for run, column in zip(runs, columns):
        if not run.name.startswith("hawser"):
            continue
        for other, theirs in zip(runs, columns):
            if other.name.startswith("hawser"):
                continue
            if other.astray:
                print("%s left the branch: nothing to compare" % other.name)
                good = False
                continue
            lost = [e for e, a, b, c in zip(events, column, theirs, columns[-1])
                    if a is None and b is not None and c is not None]
            strayed = [e for e, a, b, c in zip(events, column, theirs, columns[-1])
                       if a is None and b is not None and c is None]
            extra = [e for e, a, b in zip(events, column, theirs) if a is not None and b is None]
            gap = worst(column, theirs, events)
            for kind, omega in lost:
                print("%s lacks the %s at %.10g that %s found" % (run.name, kind, omega,
                                                                 other.name))
            for kind, omega in strayed:
                print("%s alone has the %s at %.10g, which %s does not have" % (
                    other.name, kind, omega, runs[-1].name))
            for kind, omega in extra:
                print("%s silently missed the %s at %.10g" % (other.name, kind, omega))
            print("%s against %s: largest relative difference in Omega %.1e" % (
                run.name, other.name, gap))
            good = good and not lost and gap <= args.agree
    return good


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--hawser", default="hawser", help="the program (hawser)")
    parser.add_argument("--scene", required=True)
    parser.add_argument("--from", dest="start", default="0.6w1")
    parser.add_argument("--to", dest="end", default="3.3w1")
    parser.add_argument("--tolerances", default="1e-9,1e-8",
                        help="of hawser's runs, the one to judge first (1e-9,1e-8)")
    parser.add_argument("--loose", default="1e-7,40", help="AUTO: EPSL=EPSU, NTST (1e-7,40)")
    parser.add_argument("--tight", default="1e-9,80", help="AUTO: EPSL=EPSU, NTST (1e-9,80)")
    parser.add_argument("--dsmax", type=float, help="AUTO's DSMAX (as exported)")
    parser.add_argument("--weight", type=float, default=1e6,
                        help="AUTO's THU of the states where none was exported; 0: none (1e6)")
    parser.add_argument("--threads", type=int, default=1, help="of AUTO (1)")
    parser.add_argument("--limit", type=float, default=1800, help="s allowed to an AUTO run")
    parser.add_argument("--repeat", type=int, default=3, help="hawser runs, fastest counts (3)")
    parser.add_argument("--agree", type=float, default=1e-6, help="relative, in Omega (1e-6)")
    parser.add_argument("--keep", help="work in this directory and leave it")
    args = parser.parse_args()
    args.hawser = os.path.abspath(args.hawser) if os.sep in args.hawser else args.hawser
    return args


def bench(args, directory):
    runs = []
    for tolerance in args.tolerances.split(","):
        run, reach = hawser_frf(args, directory, float(tolerance))
        runs.append(run)
    for name in ("loose", "tight"):
        tolerance, intervals = getattr(args, name).split(",")
        runs.append(auto_run(args, directory, name, float(tolerance), int(intervals), reach))
    events = all_events(runs)
    columns = [match(run, events)[0] for run in runs]
    print("frf-auto: %s, Omega from %s to %s; AUTO on %d thread(s), load average %.2f" % (
        os.path.basename(args.scene), args.start, args.end, args.threads, os.getloadavg()[0]))
    show_events(runs, events, columns)
    show_runs(runs, events, columns)
    return judge(args, runs, events, columns)


def main():
    args = arguments()
    try:
        if args.keep:
            os.makedirs(args.keep, exist_ok=True)
            return 0 if bench(args, os.path.abspath(args.keep)) else 1
        with tempfile.TemporaryDirectory() as directory:
            return 0 if bench(args, directory) else 1
    except Failed as error:
        print("frf-auto: %s" % error, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())

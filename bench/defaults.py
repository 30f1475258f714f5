#!/usr/bin/env python3
# bench/defaults.py HAWSER SCENE...: every command with its defaults on every one of these scenes that it takes
# (as `hawser check` says), one thread. A line a run: seconds of processor time, "limit" where it took LIMIT (60) of
# them, status, first warning. Then for each command and for all: median, the ninth of ten and the largest.
# `--command NAME` runs that one alone; repeatable. Maps need axes: those of NEEDED.
# With `frf` the time that `hawser plan` foresees for it is beside, and last how many runs lie within its bounds.
# Runs of status 1 (what the command asks for is missing, or it does not apply) are left out.
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import json
import os
import re
import resource
import statistics
import subprocess
import sys
import tempfile

# What a command can't do without.
NEEDED = {
    "map": ["--x", "Omega=0.9w1:1.1w1", "--y", "factor.load=0.5:1"],
    "hill": ["--x", "Omega=0.9w1:1.1w1", "--y", "factor.load=0.5:1"],
}
# They need a result or a measurement, or they measure others.
LEFT_OUT = {"orbit", "identify", "compare", "compare modes", "compare mms", "compare motion", "compare statics"}


def run(words, limit):
    """Seconds of processor time of this command, its status (None: ended at the limit) and what it says."""
    env = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        status = subprocess.run(words, stdout=out, stderr=err, env=env, stdin=subprocess.DEVNULL, preexec_fn=lambda:
                                resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))).returncode
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        out.seek(0)
        err.seek(0)
        texts = out.read().decode(errors="replace"), err.read().decode(errors="replace")
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return seconds, status if status >= 0 else None, *texts


def taken(hawser, scene):
    text = run([hawser, "check", scene], 60)[2]
    found = re.search(r"^commands that take it: (.*)$", text, re.M)
    return found.group(1).split(", ") if found else []


def foreseen(hawser, scene):
    """Least, estimated and largest seconds of `hawser frf`, by the plan of the scene; None: it has no plan."""
    text = run([hawser, "plan", scene, "-q", "--json", "-"], 60)[2]
    rows = json.loads(text).get("fidelities", []) if text else []
    return next(([row[key] for key in ("least_time_secs", "time_secs", "most_time_secs")] for row in rows
                 if row.get("name") == "hawser frf"), None)


def summary(name, times):
    ordered = sorted(times)
    print(f"{name:14s} {len(times):4d} {statistics.median(ordered):8.2f} {ordered[(9*len(ordered) - 1)//10]:8.2f} "
          f"{ordered[-1]:8.2f}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("hawser")
    parser.add_argument("scene", nargs="+")
    parser.add_argument("--command", action="append")
    parser.add_argument("--limit", type=int, default=60)
    given = parser.parse_args()
    times, within = {}, []
    for scene in given.scene:
        for command in taken(given.hawser, scene):
            if command in LEFT_OUT or given.command and command not in given.command:
                continue
            words = [given.hawser, *command.split(), scene, *NEEDED.get(command, []), "-q"]
            seconds, status, _, said = run(words, given.limit)
            if status == 1:
                continue
            times.setdefault(command, []).append(seconds)
            plan = foreseen(given.hawser, scene) if command == "frf" else None
            if plan:
                within.append(plan[0] <= seconds <= plan[2])
                said = f"planned {plan[1]:.2g} s  {said}"
            print(f"{command:12s} {os.path.basename(scene):28s} {seconds:7.2f} s  "
                  f"{'limit' if status is None else f'status {status}'}  {said.partition(chr(10))[0][:120]}", flush=True)
    print(f"\n{'command':14s} {'runs':>4s} {'median':>8s} {'9 of 10':>8s} {'largest':>8s}   s")
    for command in times:
        summary(command, times[command])
    summary("all", [seconds for runs in times.values() for seconds in runs])
    if within:
        print(f"plan: {sum(within)} of {len(within)} responses within a factor of 3")


if __name__ == "__main__":
    sys.exit(main())

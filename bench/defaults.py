#!/usr/bin/env python3
# bench/defaults.py HAWSER SCENE...: every command with its defaults on every one of these scenes that it takes
# (as `hawser check` says), one thread. A line a run: seconds of processor time, "limit" where it took LIMIT (60) of
# them, status, first warning. Then for each command and for all: median, the ninth of ten and the largest.
# `--command NAME` runs that one alone; repeatable. Maps need axes: those of NEEDED. `--random COUNT` adds as many scenes
# of bench/practical.py (of `--seed`, 1), every second one over the range about its resonance.
# With `frf` the time that `hawser plan` foresees for it is beside, and last the quantiles of the ratio and how many runs
# lie within its bounds; and of all runs how many took less than 1 s, and which more than 5 s.
# Runs of status 1 (what the command asks for is missing, or it does not apply) are left out.
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import json
import os
import random
import re
import resource
import statistics
import subprocess
import sys
import tempfile

import practical

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


def foreseen(hawser, scene, span):
    """Least, estimated and largest seconds of `hawser frf`, by the plan of the scene; None: it has no plan."""
    text = run([hawser, "plan", scene, *span, "-q", "--json", "-"], 60)[2]
    rows = json.loads(text).get("fidelities", []) if text else []
    return next(([row[key] for key in ("least_time_secs", "time_secs", "most_time_secs")] for row in rows
                 if row.get("name") == "hawser frf"), None)


def drawn(count, seed, folder):
    """Scenes of bench/practical.py, and the words of their ranges."""
    found = []
    for number in range(count):
        chance = random.Random(seed*100003 + number)
        kind = list(practical.KINDS)[number % len(practical.KINDS)]
        text, mode = practical.draw(chance, kind)
        found.append((os.path.join(folder, f"{kind}-{number}"), practical.about(mode) if number % 2 else []))
        with open(found[-1][0], "w", encoding="utf-8") as stream:
            stream.write(text)
    return found


def summary(name, times):
    ordered = sorted(times)
    print(f"{name:14s} {len(times):4d} {statistics.median(ordered):8.2f} {ordered[(9*len(ordered) - 1)//10]:8.2f} "
          f"{ordered[-1]:8.2f}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("hawser")
    parser.add_argument("scene", nargs="*")
    parser.add_argument("--command", action="append")
    parser.add_argument("--limit", type=int, default=60)
    parser.add_argument("--random", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    times, ratios, long, folder = {}, [], [], tempfile.TemporaryDirectory()
    for scene, span in [(scene, []) for scene in given.scene] + drawn(given.random, given.seed, folder.name):
        for command in taken(given.hawser, scene):
            if command in LEFT_OUT or given.command and command not in given.command:
                continue
            words = [given.hawser, *command.split(), scene, *NEEDED.get(command, span if command == "frf" else []), "-q"]
            seconds, status, _, said = run(words, given.limit)
            if status == 1:
                continue
            times.setdefault(command, []).append(seconds)
            if seconds > 5.0:
                long.append(f"{command} {os.path.basename(scene)}")
            plan = foreseen(given.hawser, scene, span) if command == "frf" else None
            if plan and status is not None:
                ratios.append((seconds/plan[1], plan[0] <= seconds <= plan[2]))
                said = f"planned {plan[1]:.2g} s{'' if ratios[-1][1] else ' BEYOND'}  {said}"
            print(f"{command:12s} {os.path.basename(scene):28s} {seconds:7.2f} s  "
                  f"{'limit' if status is None else f'status {status}'}  {said.partition(chr(10))[0][:120]}", flush=True)
    print(f"\n{'command':14s} {'runs':>4s} {'median':>8s} {'9 of 10':>8s} {'largest':>8s}   s")
    for command in times:
        summary(command, times[command])
    every = [seconds for runs in times.values() for seconds in runs]
    summary("all", every)
    print(f"{sum(seconds < 1.0 for seconds in every)} of {len(every)} runs under 1 s; over 5 s: {', '.join(long) or 'none'}")
    if ratios:
        ordered = sorted(ratio for ratio, _ in ratios)
        print(f"plan: {sum(within for _, within in ratios)} of {len(ratios)} responses within a factor of 3; real over planned "
              f"time: {ordered[len(ordered)//20]:.2f} (5 %), {ordered[len(ordered)//2]:.2f} (median), "
              f"{ordered[-1 - len(ordered)//20]:.2f} (95 %)")


if __name__ == "__main__":
    sys.exit(main())

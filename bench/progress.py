#!/usr/bin/env python3
# bench/progress.py HAWSER COMMAND...: how near the time left is that progress shows on a terminal. Each COMMAND is one
# argument, such as "frf chairlift.yaml -n 16"; without any, those of RUNS, in notebooks-data/scenes. A line a run:
# seconds, lines of progress from a tenth of the run on (and after the first second), the part of them with a time left,
# the part of these within a factor of 2 of the time that was really left (or within 1 s), the least, the median and the
# largest of their ratios, the longest time without a line, and how often the percent fell. On a busy machine the times left are as uneven as what it gives to the run.
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import pty
import re
import shlex
import sys
import time

RUNS = (
    "frf b-table-4.4-line-2.yaml -n 16", "frf deep-sag.yaml -n 12 --set model.energy=quartic", "frf b-table-5.6.yaml",
    "frf chairlift.yaml -n 16 --from 0.6w1 --to 3.3w1", "frf deep-sag.yaml", "frf conductor.yaml",
    "frf conductor-towers.yaml", "frf ropeway-gondola.yaml",
    "folds chairlift.yaml", "folds b-table-4.2.yaml", "folds conductor.yaml", "locus b-table-4.3-line-2.yaml",
    "locus conductor.yaml", "campbell b-table-5.4.yaml", "campbell ropeway-gondola.yaml", "nnm deep-sag.yaml",
    "map chairlift.yaml --x Omega=0.9w1:1.1w1 --y factor.load=0.5:1 --points 64x64 --threads 1",
    "map chairlift.yaml --x Omega=0.8w1:2.2w1 --y load.per_length[2]=0.1:4 --quantity amplitude --points 40x40 --threads 1",
    "map conductor.yaml --x Omega=0.9w1:1.1w1 --y factor.load=0.5:1 --threads 1",
    "hill chairlift.yaml --x Omega=0.9w1:1.1w1 --y factor.load=0.5:1",
    "integrate chairlift.yaml --Omega w1 --until 20000T --every T",
)
LIMIT = 60


def watch(words):
    """(second, what progress says) of each line, and the seconds of the run."""
    pid, terminal = pty.fork()
    if pid == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        os.environ["OPENBLAS_NUM_THREADS"] = "1"
        os.execvp(words[0], words)
    began, lines = time.monotonic(), []
    while time.monotonic() - began < LIMIT:
        try:
            text = os.read(terminal, 4096)
        except OSError:
            break
        if not text:
            break
        lines += [(time.monotonic() - began, line) for line in re.split(r"[\r\n]+", text.decode(errors="replace")) if line]
    seconds = time.monotonic() - began
    try:
        os.kill(pid, 9)
    except ProcessLookupError:
        pass
    os.waitpid(pid, 0)
    return lines, seconds


def main():
    hawser, runs = os.path.abspath(sys.argv[1]), sys.argv[2:]
    if not runs:
        runs = RUNS
        os.chdir(os.path.join(os.path.dirname(__file__), "..", "notebooks-data", "scenes"))
    for run in runs:
        lines, seconds = watch([hawser, *shlex.split(run)])
        lines = [(at, line) for at, line in lines if "warning" not in line]
        times = [0, *(at for at, line in lines), seconds]
        silent = max(after - before for before, after in zip(times, times[1:]))
        percent = [int(found.group(1)) for _, line in lines if (found := re.search(r"(\d+) %", line))]
        falls = sum(after < before for before, after in zip(percent, percent[1:]))
        lines = [(at, line) for at, line in lines if max(1, 0.1*seconds) <= at < seconds - 0.5]
        told = [(at, float(found.group(1))) for at, line in lines if (found := re.search(r"about (\d+) s left", line))]
        ratios = sorted(left/(seconds - at) for at, left in told) or [float("nan")]
        near = sum(abs(left - (seconds - at)) <= 1 or 0.5 <= left/(seconds - at) <= 2 for at, left in told)
        print(f"{seconds:6.1f} s{'+' if seconds >= LIMIT else ' '} {len(lines):5d} lines, {len(told)/max(1, len(lines)):4.0%} with a "
              f"time, {near/max(1, len(told)):4.0%} of these near ({ratios[0]:.2f}, {ratios[len(ratios)//2]:.2f}, "
              f"{ratios[-1]:.2f}), silent for {silent:.1f} s, {falls} falls  {run}", flush=True)


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""What a variation of hawser sweep costs: time and memory beside calls of the program, one and two
processes, two ranks of mpirun.

First the table of one process is verified: rows equal the command run alone, digit for digit, and tables
of several processes and ranks have the same bytes. Then wall and processor time are stated.

    python3 bench/sweep.py --hawser ./hawser --scenes ../notebooks-data/scenes

Exit status: 0; 1 when a result is wrong.
SPDX-License-Identifier: GPL-3.0-or-later"""
import argparse
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time

CHECKED = 5  # rows that are compared with the command run alone
STUDIES = (  # scene, key, range, number, columns, command
    ("chairlift.yaml", "tension.T0", "60 kN:100 kN", 2000, "sag,T1", ["statics"]),
    ("ropeway-small.yaml", "ropeway.rope.rho", "3 kg/m:5 kg/m", 200, "T_top", ["statics"]),
    ("tow-orbit.yaml", "tow.orbit.speed", "15 m/s:25 m/s", 200, "tilt,tension_top", ["tow", "steady"]),
    ("b-table-4.2.yaml", "damping.alpha", "0.05 kg/m/s:0.2 kg/m/s", 24, "Omega,size_m",
     ["frf", "--from", "0.8w1", "--to", "1.4w1"]),
)


def timed(words, **more):
    """Standard output, wall and processor seconds, and the largest memory of a process so far, MB."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    began = time.perf_counter()
    done = subprocess.run(words, stdout=subprocess.PIPE, check=False, **more)
    wall = time.perf_counter() - began
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if done.returncode:
        sys.exit(f"{' '.join(words)}: exit status {done.returncode}")
    return done.stdout.decode(), wall, used, after.ru_maxrss/1024


def rows_of(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return [line.split("\t") for line in lines[1:]]


def same_alone(bench, scene, key, command, columns, rows, unit):
    """Whether rows are those of sweeps of one value each by a fresh process."""
    for row in rows[::max(1, len(rows)//CHECKED)]:
        text = timed([bench.hawser, "sweep", scene, "--over", f"{key}={row[0]} {unit}", "--keep", columns,
                      "--", *command], cwd=bench.scenes)[0]
        if rows_of(text)[0] != row:
            return False
    return True


def study(bench, scene, key, values, number, columns, command):
    unit = values.split(":")[0].split(" ", 1)[1]
    words = [bench.hawser, "sweep", scene, "--over", f"{key}={values}:{number}", "--keep", columns,
             "--reproducible"]
    one, wall, used, memory = timed([*words, "-j", "1", "--", *command], cwd=bench.scenes)
    first = {row[0]: row for row in reversed(rows_of(one))}
    good = len(first) == number and same_alone(bench, scene, key, command, columns,
                                               list(first.values()), unit)
    two, wall_2, used_2, _ = timed([*words, "-j", "2", "--", *command], cwd=bench.scenes)
    good = good and two == one
    line = (f"{' '.join(command[:2]) if command[0] == 'tow' else command[0]:11s} {scene:20s} {number:5d} "
            f"{1000*wall/number:8.2f} {1000*used/number:8.2f} {1000*wall_2/number:8.2f} "
            f"{1000*used_2/number:8.2f}")
    if bench.mpirun:
        ranks, wall_r, used_r, _ = timed([bench.mpirun, "-n", "2", "--oversubscribe", *words, "--",
                                          *command], cwd=bench.scenes)
        good = good and ranks == one
        line += f" {1000*wall_r/number:8.2f} {1000*used_r/number:8.2f}"
    print(f"{line} {memory:7.0f}  {'same bytes' if good else 'WRONG'}", flush=True)
    return good


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--hawser", default="./hawser")
    parser.add_argument("--scenes", default="../notebooks-data/scenes")
    bench = parser.parse_args()
    bench.hawser = os.path.realpath(bench.hawser)
    bench.mpirun = shutil.which("mpirun")
    os.environ.setdefault("OMPI_ALLOW_RUN_AS_ROOT", "1")
    os.environ.setdefault("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")
    os.environ.setdefault("TMPDIR", tempfile.gettempdir())
    print("ms of wall time and of processor time a variation: one process, two, two ranks; MB of memory")
    print(f"{'command':11s} {'scene':20s} {'':5s} {'1 wall':>8s} {'cpu':>8s} {'2 wall':>8s} {'cpu':>8s} "
          f"{'ranks':>8s} {'cpu':>8s} {'MB':>7s}")
    good = True
    for row in STUDIES:
        good = study(bench, *row) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())

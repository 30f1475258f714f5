#!/usr/bin/env python3
"""bench/ranks-map.py [POINTS [RANKS...]]: what it costs to share a map among ranks; run it in the build folder.

A map of POINTS x POINTS (500), all computed, by one process with one thread and by 2 and 3 ranks of one thread. The results must have the
same bytes. Then wall time, processor time of all ranks, and the efficiency: processor time of one process over that of all ranks, without
that of starting them (of a map of 3 x 3 points). It counts what sharing adds, also on a machine that is busy; on idle processors it is
the speed-up over their number, but for the time in which ranks wait.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import subprocess
import sys
import tempfile
import time

points = int(sys.argv[1]) if len(sys.argv) > 1 else 500
numbers = [int(word) for word in sys.argv[2:]] or [2, 3]
os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", LD_LIBRARY_PATH=".libs", OMP_NUM_THREADS="1")
model = {"hawser_rom": 1, "n": 2, "D": [[0.02, 0], [0, 0.03]], "K": [[1, 0], [0, 2.3]],
         "harmonics": [{"k": 1, "phase": "cos", "K": [[1, 0.2], [0.2, 1.1]], "f": [0.1, 0.2]}]}


def times(ranks, count, result):
    before, began = os.times(), time.monotonic()
    starter = ["mpirun", "-n", str(ranks), "--oversubscribe"] if ranks > 1 else []
    subprocess.run(starter + [".libs/hawser", "map", scene, "--x", "Omega=0.8:4", "--y", "factor.load=0:0.5", "--points",
                              f"{count}x{count}", "--quantity", "multiplier", "--coarse", "1", "-q", "--tsv", result], check=True)
    after = os.times()
    return time.monotonic() - began, after[2] + after[3] - before[2] - before[3]


with tempfile.TemporaryDirectory() as folder:
    scene = folder + "/model.json"
    with open(scene, "w") as file:
        json.dump(model, file)
    wall, alone = times(1, points, folder + "/1")
    print(f"1 process: {wall:.2f} s wall, {alone:.2f} s processor, {1e6*alone/points**2:.1f} us a point")
    for ranks in numbers:
        start = min(times(ranks, 3, folder + "/start")[1] for _ in range(3))
        wall, used = times(ranks, points, folder + "/n")
        with open(folder + "/1", "rb") as one, open(folder + "/n", "rb") as other:
            assert one.read() == other.read(), "the results differ"
        print(f"{ranks} ranks: {wall:.2f} s wall, {used:.2f} s processor, {start:.2f} s of it to start them; "
              f"{1e6*(used - start - alone)/points**2:.2f} us more a point; efficiency {alone/(used - start):.3f}")

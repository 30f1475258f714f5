"""The time of a call from Python: through the library, and by starting the program. First the numbers by both
routes are compared.

    HAWSER=.libs/hawser HAWSER_LIBRARY=.libs/libhawser.so PYTHONPATH=../python python3 ../bench/python.py [REPEATS]

SPDX-License-Identifier: GPL-3.0-or-later
"""
import pathlib
import sys
import time

import numpy as np

import hawser

SCENE = str(pathlib.Path(__file__).resolve().parent.parent / "notebooks-data" / "scenes" / "chairlift.yaml")
REPEATS = int(sys.argv[1]) if len(sys.argv) > 1 else 9


def median(job):
    """Median of the wall time, s."""
    times = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        job()
        times.append(time.perf_counter() - begin)
    return float(np.median(times))


def distance(a, b):
    return float(np.max(np.abs(np.asarray(a) - np.asarray(b))/np.abs(b)))


scene = hawser.Scene(SCENE)
model = hawser.Model(hawser.Modes(scene))
branch = model.respond("0.9w1", "1.1w1")
jobs = [
    ("statics", lambda: hawser.Statics(SCENE), lambda: hawser.run("statics", SCENE),
     lambda a, b: distance(a.sag, b.json["sag"])),
    ("modes", lambda: hawser.Modes(SCENE, n=5), lambda: hawser.run("modes", SCENE, n=5),
     lambda a, b: distance(a.omega_si, b["omega_rad_s"])),
    ("frf", lambda: hawser.Model(SCENE).respond("0.9w1", "1.1w1"),
     lambda: hawser.run("frf", SCENE, from_="0.9w1", to="1.1w1", set={"model.energy": "quartic"}),
     lambda a, b: distance(a.omega_si, b["Omega_rad_s"])),
]
print("job      distance  library_ms  program_ms")
for name, library, program, compare in jobs:
    gap = compare(library(), program())
    if not gap < 1e-10:
        sys.exit(f"{name}: the two routes differ by {gap:.1e}")
    print(f"{name:8} {gap:8.1e}  {1e3*median(library):10.2f}  {1e3*median(program):10.2f}")

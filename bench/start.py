#!/usr/bin/env python3
"""bench/start.py [PROGRAM]: what a start of hawser costs, as it is and with libraries that it loads only when they are used.

Processor time of `hawser --version` in ms: least, quarter and median of 60 starts each, in turn. Run it in the build folder.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import sys

program = sys.argv[1] if len(sys.argv) > 1 else ".libs/hawser"
base = dict(os.environ, LD_LIBRARY_PATH=".libs")
kinds = {"as it is": base}
for name in ("libmpi.so.40", "libhdf5_serial.so.103"):
    kinds["with " + name] = dict(base, LD_PRELOAD=name)


def start(environment):
    process = os.fork()
    if process == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        os.execve(program, ["hawser", "--version"], environment)
    used = os.wait4(process, 0)[2]
    return 1e3*(used.ru_utime + used.ru_stime)


times = {name: [] for name in kinds}
for _ in range(60):
    for name, environment in kinds.items():
        times[name].append(start(environment))
for name, all_of in times.items():
    all_of.sort()
    print(f"{name:28} {all_of[0]:6.1f} {all_of[15]:6.1f} {all_of[30]:6.1f}")

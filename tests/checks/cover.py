#!/usr/bin/env python3
"""cover.py COUNTS RESULTS [ALWAYS...]: which tests reach what no cheaper ones reach; for `make check-cover`.

COUNTS has a folder for each test, with what its programs reached (cover.c); RESULTS is the table of tests/run, with their times;
the programs are below the current folder. Tests are taken in the order of new blocks of the sources a second, those of
ALWAYS first, until REACHED of all blocks that any test reaches are reached. Of the others, those that take time go to standard
output, as the list tests/unsanitized.txt: the name, its seconds, and how many blocks no chosen test reaches. The sum goes to standard error.
"""
# SPDX-License-Identifier: GPL-3.0-or-later

import array
import bisect
import glob
import os
import subprocess
import sys

REACHED = 0.97
# A test that takes less is run anyway.
CHEAP_SECS = 0.3
# Seconds that starting a test takes, beside its own.
START_SECS = 0.03


def functions(program):
    """Addresses and names of a program's functions, in order."""
    places = [program, *glob.glob(os.path.join("tests", program)), *glob.glob(os.path.join("tests", "*", program))]
    path = next(filter(os.path.isfile, places))
    lines = subprocess.run(["nm", path], check=True, capture_output=True, text=True).stdout.split("\n")
    return sorted((int(row[0], 16), row[2]) for row in map(str.split, lines) if len(row) == 3 and row[1] in "tT")


def named(program, path, numbers):
    """The number of each block: two programs have the same function when its name and the places of its blocks are the same."""
    places = array.array("I")
    with open(path, "rb") as file:
        places.frombytes(file.read())
    known = functions(program)
    begins = [i for i, place in enumerate(places) if place & 1] + [len(places)]
    blocks = []
    for begin, end in zip(begins, begins[1:]):
        shape = tuple(place // 2 - places[begin] // 2 for place in places[begin:end])
        name = known[bisect.bisect_right(known, (places[begin] // 2, "~")) - 1][1]
        blocks += [numbers.setdefault((name, shape, i), len(numbers)) for i in range(end - begin)]
    return blocks


def reached(folder, programs, numbers):
    """The blocks of the sources that a test reaches, as numbers."""
    blocks = set()
    for program in os.listdir(folder) if os.path.isdir(folder) else []:
        path = os.path.join(folder, program)
        if path.endswith(".pcs"):
            continue
        if program not in programs:
            programs[program] = named(program, path + ".pcs", numbers)
        with open(path, "rb") as file:
            blocks.update(number for number, count in zip(programs[program], file.read()) if count)
    return blocks


def main():
    """Read the counts, choose, and print."""
    counts, results, always = sys.argv[1], sys.argv[2], sys.argv[3:]
    with open(results, encoding="utf-8") as table:
        seconds = {row[0]: float(row[5]) for row in (line.split("\t") for line in table) if row[0] != "test"}
    programs, numbers = {}, {}
    reach = {test: reached(os.path.join(counts, test), programs, numbers) for test in seconds}
    missing, spent, chosen = set().union(*reach.values()), 0.0, 0
    every = len(missing)
    while len(missing) > (1 - REACHED) * every:
        test = max(reach, key=lambda name: (name in always, len(reach[name] & missing) / (seconds[name] + START_SECS)))
        missing -= reach.pop(test)
        spent += seconds[test]
        chosen += 1
    for test in sorted(reach):
        if seconds[test] < CHEAP_SECS:
            spent, chosen = spent + seconds[test], chosen + 1
            missing -= reach.pop(test)
    for test in sorted(reach):
        print("%-28s %4.1f s, %3d blocks of %d that no other reaches" %
              (test, seconds[test], len(reach[test] & missing), every))
    print("%d of %d tests, %.0f of %.0f s, reach %.1f %% of the %d blocks that all reach" %
          (chosen, len(seconds), spent, sum(seconds.values()), 100 - 100 * len(missing) / every, every),
          file=sys.stderr)


if __name__ == "__main__":
    main()

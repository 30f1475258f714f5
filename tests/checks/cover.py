#!/usr/bin/env python3
"""cover.py COUNTS RESULTS [ALWAYS...]: which tests reach what no cheaper ones reach; for `make check-cover`.

COUNTS has a folder for each test, with the files .gcda that it left (tests/run -g); RESULTS is the table of tests/run, with
their times. Tests are taken in the order of new arcs of the sources a second, those of ALWAYS first, until REACHED of all arcs that
any test reaches are reached. Of the others, those that take time go to standard output, as the list tests/unsanitized.txt: the
name, its seconds, and how many arcs no chosen test reaches. The sum goes to standard error.
"""
# SPDX-License-Identifier: GPL-3.0-or-later

import os
import struct
import sys

REACHED = 0.97
# A test that takes less is run anyway.
CHEAP_SECS = 0.3
# Seconds that starting a test takes, beside its own.
START_SECS = 0.03
# Records of a .gcda file: tag, length in bytes (negative: nothing but zeros), data; after magic, version, stamp, checksum.
HEADER_WORDS = 4
FUNCTION, ARCS = 0x01000000, 0x01A10000


def counted(path):
    """The arcs that a .gcda file counts: pairs of function and arc."""
    with open(path, "rb") as file:
        data = file.read()
    words = struct.unpack("<%dI" % (len(data) // 4), data[: len(data) // 4 * 4])
    at, function = HEADER_WORDS, 0
    while at + 1 < len(words) and words[at]:
        tag, length = words[at], struct.unpack("<i", struct.pack("<I", words[at + 1]))[0]
        at += 2
        if tag == FUNCTION and length > 0:
            function = words[at]
        if tag == ARCS and length > 0:
            for arc in range(length // 8):
                if words[at + 2 * arc] or words[at + 2 * arc + 1]:
                    yield function, arc
        at += max(length, 0) // 4


def reached(folder, numbers):
    """The arcs of the sources that a test reaches, as numbers."""
    arcs = set()
    for place, _, files in os.walk(folder):
        if "/src/" not in place:
            continue
        for name in files:
            source = os.path.join(place.split("/src/")[-1], name).replace(".libs/", "")
            for function, arc in counted(os.path.join(place, name)):
                arcs.add(numbers.setdefault((source, function, arc), len(numbers)))
    return arcs


def main():
    """Read the counts, choose, and print."""
    counts, results, always = sys.argv[1], sys.argv[2], sys.argv[3:]
    with open(results, encoding="utf-8") as table:
        seconds = {row[0]: float(row[5]) for row in (line.split("\t") for line in table) if row[0] != "test"}
    numbers = {}
    reach = {test: reached(os.path.join(counts, test), numbers) for test in seconds}
    missing, spent, chosen = set(range(len(numbers))), 0.0, 0
    while len(missing) > (1 - REACHED) * len(numbers):
        test = max(reach, key=lambda name: (name in always, len(reach[name] & missing) / (seconds[name] + START_SECS)))
        missing -= reach.pop(test)
        spent += seconds[test]
        chosen += 1
    for test in sorted(reach):
        if seconds[test] < CHEAP_SECS:
            spent, chosen = spent + seconds[test], chosen + 1
            missing -= reach.pop(test)
    for test in sorted(reach):
        print("%-28s %4.1f s, %3d arcs of %d that no other reaches" %
              (test, seconds[test], len(reach[test] & missing), len(numbers)))
    print("%d of %d tests, %.0f of %.0f s, reach %.1f %% of the %d arcs that all reach" %
          (chosen, len(seconds), spent, sum(seconds.values()), 100 - 100 * len(missing) / len(numbers), len(numbers)),
          file=sys.stderr)


if __name__ == "__main__":
    main()

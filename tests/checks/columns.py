# tests/checks/columns.py - names that `hawser help columns COMMAND` lists and the manual page of the
# command lacks. SPDX-License-Identifier: GPL-3.0-or-later
#
# Arguments: the folder of the pages, and a list for each command, in a file of its name. A column may be in the
# page with or without its unit; KEY is one that the user names; of "x_PROBE_m" and "u_J_m" the page has an
# instance, such as u_1_m, or the part before the capitals.
import os
import re
import sys

WITHOUT = ("check", "completion", "init", "merge", "schema")  # they have no table
UNITS = ("rad_s_m2", "rad_s", "m_s", "1_s", "m", "N", "s", "J", "Hz", "rad", "bytes")


def words_of(command):
    path = os.path.join(sys.argv[1], f"hawser-{command.split()[0]}.1")
    page = open(path, encoding="utf-8").read().replace(r"\-", "-").replace(r"\(dq", '"')
    return set(re.findall(r"[A-Za-z][A-Za-z0-9_]*", re.sub(r"\\f[A-Z]", "", page)))


def known(name, words):
    if name == "KEY" or name in words or any(
            name.endswith("_" + unit) and name[:-len(unit) - 1] in words for unit in UNITS):
        return True
    stem = re.split(r"(?<=_)[A-Z]+(?:_|$)", name)[0]
    return stem != name and any(word.startswith(stem) for word in words)


for path in sys.argv[2:]:
    command, listed = os.path.basename(path), 0
    words = words_of(command)
    for line in open(path, encoding="utf-8"):
        entry = re.match(r"\s+(\S+(?:, \S+)*)\s\s", line)
        if entry:
            listed += 1
            for name in re.split(r"[., ]+", entry.group(1)):
                if not known(name, words):
                    print(f"{command}: {name}")
    if not listed and command not in WITHOUT:
        print(f"{command}: nothing is listed")

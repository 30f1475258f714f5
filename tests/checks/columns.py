# tests/checks/columns.py - names that `hawser help columns COMMAND` lists and the manual page of the
# command lacks. SPDX-License-Identifier: GPL-3.0-or-later
#
# Standard input: the list; argument: the page. A column may be in the page with or without its unit;
# KEY is one that the user names; of "x_PROBE_m" and "u_J_m" the page has an instance, such as u_1_m, or the part before the capitals.
import re
import sys

page = open(sys.argv[1], encoding="utf-8").read()
page = page.replace(r"\-", "-").replace(r"\(dq", '"')
page = re.sub(r"\\f[A-Z]", "", page)
words = set(re.findall(r"[A-Za-z][A-Za-z0-9_]*", page))
units = ("rad_s_m2", "rad_s", "m_s", "1_s", "m", "N", "s", "J", "Hz", "rad", "bytes")


def known(name):
    if name == "KEY" or name in words or any(
            name.endswith("_" + unit) and name[:-len(unit) - 1] in words for unit in units):
        return True
    stem = re.split(r"(?<=_)[A-Z]+(?:_|$)", name)[0]
    return stem != name and any(word.startswith(stem) for word in words)


listed = 0
for line in sys.stdin:
    entry = re.match(r"\s+(\S+(?:, \S+)*)\s\s", line)
    if not entry:
        continue
    listed += 1
    for name in re.split(r"[., ]+", entry.group(1)):
        if not known(name):
            print(name)
if not listed:
    print("nothing is listed")

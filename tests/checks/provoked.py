# tests/checks/provoked.py BUILD - which messages no test provoked, after the suite has run in the build folder
# BUILD that counts lines (gcc --coverage); `make check-provoked` calls it, from the top of the source tree.
# What can't be provoked from outside stands in tests/checks/provoked.txt, with why: a message is one of
# those where a line of the list is a part of it. One line a finding; the last line counts.
# SPDX-License-Identifier: GPL-3.0-or-later
import glob
import json
import os
import subprocess
import sys

build = sys.argv[1]
here = os.getcwd()
count = {}
for data in sorted(glob.glob(build + "/src/**/*.gcda", recursive=True)):
    text = subprocess.run(["gcov", "--json-format", "--stdout", os.path.basename(data)], check=True,
                          cwd=os.path.dirname(data), capture_output=True).stdout
    for line in text.splitlines():
        for file in json.loads(line)["files"]:
            name = os.path.relpath(os.path.join(build, file["file"]), here) \
                if not os.path.isabs(file["file"]) else os.path.relpath(file["file"], here)
            for at in file["lines"]:
                key = name, at["line_number"]
                count[key] = count.get(key, 0) + at["count"]

excused = {}
for line in open("tests/checks/provoked.txt", encoding="utf-8"):
    if line.strip() and not line.startswith("#"):
        part, _, why = line.rstrip("\n").partition(" | ")
        excused[part] = why
places = subprocess.run([sys.executable, "tests/checks/messages.py", "places"], check=True,
                        capture_output=True, text=True).stdout.splitlines()
provoked, missed, used = set(), [], set()
for place in places:
    name, first, last, message = place.split(":", 3)
    if any(count.get((name, n), 0) for n in range(int(first), int(last) + 1)):
        provoked.add(message)
    else:
        missed.append((name, first, message))
bad = 0
for name, first, message in missed:
    parts = [part for part in excused if part in message]
    used.update(parts)
    if not parts:
        bad += 1
        print("%s:%s: no test provokes: %s" % (name, first, message))
for part, why in excused.items():
    if not why or part not in used:
        bad += 1
        print("tests/checks/provoked.txt: %s: %s" % (part, "says no reason" if not why else
                                                     "was provoked, or is no message"))
print("%d places of messages: %d provoked, %d excused, %d findings" % (
    len(places), len(places) - len(missed), len(missed) - sum(
        not any(part in m for part in excused) for _, _, m in missed), bad))
sys.exit(bad > 0)

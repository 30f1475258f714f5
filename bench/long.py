#!/usr/bin/env python3
"""Long and large runs: 10^5 points of a response, 10^7 steps in time, maps of 1000 x 1000 points.

Each is run through, then again, interrupted on its way (a signal as soon as the progress that it is asked
for, by SIGUSR1, says half; a map is killed outright as its checkpoint has half its lines) and continued. A
row tells points or steps, wall time, processor time, peak resident memory, memory a point, and whether the
interrupted and continued run is the same: the same bytes, or how far off.

Exit status: 0; 1 when a continued run is not the same; 2 when a program failed.
SPDX-License-Identifier: GPL-3.0-or-later"""
import argparse
import hashlib
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time

TWO = {"hawser_rom": 1, "n": 2, "D": [[0.02, 0], [0, 0.03]], "K": [[1, 0], [0, 4.3]],
       "Q": [[0, 0, 1, 0.1], [1, 0, 0, 0.05]],
       "C": [[0, 0, 0, 0, 1.0], [1, 1, 1, 1, 0.7], [0, 0, 1, 1, 0.3], [1, 0, 0, 1, 0.3]],
       "harmonics": [{"k": 1, "phase": "cos", "f": [0.1, 0.05]}]}
FREE = {key: TWO[key] for key in ("hawser_rom", "n", "K", "Q", "C")}
HILL = {"hawser_rom": 1, "n": 2, "D": [[0.02, 0], [0, 0.03]], "K": [[1, 0], [0, 2.3]],
        "harmonics": [{"k": 1, "phase": "cos", "K": [[1, 0.2], [0.2, 1.1]], "f": [0.1, 0.2]}]}
AXES = ["--x", "Omega=0.8:4", "--y", "factor.load=0:0.5", "--quantity", "multiplier"]


# Run by a Python without its libraries, smaller than the program: the peak of a process counts what it was
# before it became the program. Tells the usage on standard output.
LAUNCHER = """
import os, sys
pid = os.fork()
if not pid:
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    os.execv(sys.argv[1], sys.argv[1:])
_, status, use = os.wait4(pid, 0)
print(os.waitstatus_to_exitcode(status), use.ru_utime + use.ru_stime, use.ru_maxrss*1024)
"""


class Failed(Exception):
    pass


class Bench:
    def __init__(self, hawser, only):
        self.hawser, self.only, self.bad = os.path.abspath(hawser), only, 0
        self.empty = self.run(["--version"])[2]

    def start(self, arguments):
        def begin():  # a shell may have SIGINT ignored in the background; SIGUSR1 until there is a handler
            signal.signal(signal.SIGINT, signal.SIG_DFL)
            signal.signal(signal.SIGUSR1, signal.SIG_IGN)
        return subprocess.Popen([self.hawser] + arguments, stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, preexec_fn=begin)

    def end(self, run, want):
        err = run.communicate()[1]
        if run.returncode != want:
            raise Failed("status %d: %s" % (run.returncode, err.decode()))

    def run(self, arguments):
        """Wall and processor seconds, peak resident bytes."""
        began = time.time()
        run = subprocess.run([sys.executable, "-I", "-S", "-c", LAUNCHER, self.hawser] + arguments,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        status, cpu, peak = run.stdout.split()
        if int(status):
            raise Failed("status %s: %s" % (status, run.stderr))
        return time.time() - began, float(cpu), int(peak)

    def interrupt(self, arguments, pattern, target, number=signal.SIGINT):
        """Ended by `number` once a line of progress has a count of `target`."""
        run = self.start(arguments)
        os.set_blocking(run.stderr.fileno(), False)
        done, text = 0, ""
        while done < target and run.poll() is None:
            run.send_signal(signal.SIGUSR1)
            time.sleep(0.002)
            text += (run.stderr.read() or b"").decode()
            done = max([int(count) for count in re.findall(pattern, text)] or [0])
        run.send_signal(number)
        os.set_blocking(run.stderr.fileno(), True)
        self.end(run, 128 + number)

    def row(self, name, count, unit, cost, points, same):
        wall, cpu, peak = cost
        each = "%.0f" % ((peak - self.empty)/points) if points > 1000 else "-"
        print("%-44s %9d %-6s %7.1f %7.1f %8.1f %7s  %s" % (name, count, unit, wall, cpu, peak/2**20, each,
                                                         same), flush=True)
        self.bad += same.startswith("NO")


def load(name):
    with open(name) as stream:
        return json.load(stream)


def digest(name):
    with open(name, "rb") as stream:
        return hashlib.sha256(stream.read()).hexdigest()


def response(bench, name, arguments, points):
    if bench.only not in name:
        return
    arguments = ["frf"] + arguments + ["--max-points", str(points), "-q"]
    cost = bench.run(arguments + ["--json", "whole.json"])
    whole = load("whole.json")
    bench.interrupt(arguments + ["--json", "part.json"], r"frf: (\d+) points", len(whole["points"])//2)
    part = load("part.json")
    bench.run(arguments + ["--continue", "part.json", "--json", "rest.json"])
    rest = load("rest.json")
    first, second = len(part["points"]), len(rest["points"])
    events = [(e["kind"], e["Omega"]) for e in part["events"] + rest["events"]]
    wanted = [(e["kind"], e["Omega"]) for e in whole["events"]]
    count = min(len(events), len(wanted))
    gap = max([abs(a[1]/b[1] - 1) for a, b in zip(events, wanted)] or [0])
    same = [a[0] for a in events[:count]] == [b[0] for b in wanted[:count]] and gap < 1e-8
    same &= part["end"] == "interrupted" and count == len(wanted)
    bench.row(name, len(whole["points"]), "points", cost, len(whole["points"]),
              "%s, cut at %d, %d more: %d events, to %.0e" % ("yes" if same else "NO", first, second, count,
                                                             gap))


def integration(bench, name, model, method, until, every, forcing):
    if bench.only not in name:
        return
    arguments = ["integrate", model, "--method", method, "--until", until, "--every", every, "-q"]
    arguments += ["--Omega", "1.1"] if forcing else ["--rtol", "1e-13", "--initial", "start"]
    cost = bench.run(arguments + ["--json", "whole.json"])
    whole = load("whole.json")
    bench.interrupt(arguments + ["--json", "part.json"], r", (\d+) rows", len(whole["times"])//2)
    part = load("part.json")
    arguments = arguments if forcing else arguments[:-2]
    bench.run(arguments + ["--continue", "part.json", "--json", "rest.json"])
    rest = load("rest.json")
    times = part["times"][:-1] + rest["times"]
    states = part["states"][:-1] + rest["states"]
    size = [max(abs(state[k]) for state in whole["states"]) for k in range(4)]
    gap = max(abs(a - b)/s for x, y in zip(states, whole["states"]) for a, b, s in zip(x, y, size))
    same = times == whole["times"] and part["end"] == "interrupted"
    note = "%s, cut at row %d of %d: same times, off by %.0e" % (
        "yes" if same else "NO", len(part["times"]), len(times), gap)
    if not forcing:
        energy = whole["energy"]
        note += "; energy kept to %.0e" % max(abs(e/energy[0] - 1) for e in energy)
    bench.row(name, whole["stats"]["steps"], "steps", cost, 0, note)


def mapping(bench, name, arguments, points, cells):
    if bench.only not in name:
        return
    arguments = ["map"] + arguments + ["--points", points, "--reproducible", "-q"]
    cost = bench.run(arguments + ["--tsv", "whole.tsv", "--json", "whole.json"])
    if os.path.exists("kept"):
        os.remove("kept")
    bench.run(arguments + ["--tsv", "again.tsv", "--checkpoint", "kept", "--threads", "1"])
    same = digest("whole.tsv") == digest("again.tsv")
    full = os.path.getsize("kept")
    os.remove("kept")
    run = bench.start(arguments + ["--tsv", "again.tsv", "--checkpoint", "kept"])
    while run.poll() is None and (not os.path.exists("kept") or os.path.getsize("kept") < full/2):
        time.sleep(0.001)
    run.kill()
    bench.end(run, -signal.SIGKILL)
    cut = os.path.getsize("kept")
    bench.run(arguments + ["--tsv", "again.tsv", "--json", "again.json", "--checkpoint", "kept"])
    same &= digest("whole.tsv") == digest("again.tsv") and digest("whole.json") == digest("again.json")
    computed = load("whole.json")["stats"]["computed"]
    os.remove("kept")
    bench.row(name, computed, "points", cost, cells,
              "%s, killed at %.0f %% of a checkpoint of %.0f MB: %s" % (
                  "yes" if same else "NO", 100*cut/full, full/1e6,
                  "the same bytes" if same else "other bytes"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--hawser", default="./hawser")
    parser.add_argument("--srcdir", default=os.environ.get("SRCDIR", "."))
    parser.add_argument("--only", default="", help="runs whose name has this in it")
    parser.add_argument("--short", type=float, default=1.0, help="so many times fewer points and steps")
    options = parser.parse_args()
    top, short = os.path.abspath(options.srcdir), options.short
    bench = Bench(options.hawser, options.only)
    print("peak of a program that only says its version: %.1f MB" % (bench.empty/2**20))
    print("%-44s %9s %-6s %7s %7s %8s %7s  %s" % ("run", "", "", "wall s", "cpu s", "peak MB", "B/point",
                                                 "interrupted and continued the same?"))
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for name, model in ("two.json", TWO), ("free.json", FREE), ("hill.json", HILL):
            with open(name, "w") as stream:
                json.dump(model, stream)
        with open("start", "w") as stream:
            stream.write("0.3 0.2 0 0.1\n")
        points = int(1e5/short)
        response(bench, "frf, Duffing's oscillator",
                 [top + "/tests/reference/duffing-nlvib-01.json", "--from", "0.5", "--to", "2", "--step",
                  "%g" % (1.18e-5*short)], points)
        response(bench, "frf, chairlift span",
                 [top + "/notebooks-data/scenes/b-table-4.2.yaml", "--step", "%g" % (2.32e-5*short)], points)
        for method, turns in ("gauss", 5.56e5), ("adams", 6.2e4):
            integration(bench, "integrate, two coordinates, forced, " + method, "two.json", method,
                        "%gT" % (turns/short), "%gT" % (turns/1000/short), True)
        for method, turns in ("gauss", 2.83e5), ("adams", 4.65e4):
            integration(bench, "integrate, two, free, rtol 1e-13, " + method, "free.json", method,
                        "%gT" % (turns/short), "%gT" % (turns/1000/short), False)
        side = int(1000/short**0.5)
        mapping(bench, "map %d x %d, adaptive" % (side, side), ["hill.json"] + AXES,
                "%dx%d" % (side, side), side**2)
        mapping(bench, "map %d x %d, every point" % (side, side), ["hill.json"] + AXES + ["--coarse", "1"],
                "%dx%d" % (side, side), side**2)
    return 1 if bench.bad else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (Failed, OSError) as error:
        print("long.py: %s" % error, file=sys.stderr)
        sys.exit(2)

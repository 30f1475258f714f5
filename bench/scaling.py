#!/usr/bin/env python3
"""What converged models cost: responses with many condensed modes, modes chosen by accuracy and full
order, `rom` with 60 modes, boundaries of `hill`; beside the processor time that is the goal.

Each line runs the program with a limit of processor time, verifies the result, then states its time. A
response is verified by its own certificate: the sum of the logarithms of its multipliers against the
mean damping (Liouville), points computed again by another method, and errors of points and events.
What exceeds the limit is stated as such; it is no failure, since a goal is not a promise.

Exit status: 0; 1 when a result is wrong; 2 with --held when a goal is missed.
SPDX-License-Identifier: GPL-3.0-or-later"""
import argparse
import json
import math
import os
import resource
import subprocess
import sys
import tempfile

LIOUVILLE = 1e-3  # largest gap of the logarithms
SAMPLED = 1e-6    # largest distance of points that another method computes again, relative, or
STATED = 0.1      # this part of the stated error of the model, after which orbits of a default are as accurate
ERROR = 0.05      # largest estimated error of a point: what hawser itself accepts
SIZES = (5, 10, 20, 40, 60)
EARLY, LATE = 15, 45  # points of the two runs whose difference is the time of a point


class Outcome:
    """Processor seconds, peak memory in MB, the parsed result or None, and what is wrong or None."""

    def __init__(self, seconds, memory, result, wrong):
        self.seconds, self.memory, self.result, self.wrong = seconds, memory, result, wrong


def limit_processor(seconds):
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))


def run(bench, words):
    """One run of the program; its processor time and memory are those of its process alone."""
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        command = [bench.hawser] + words + ["--quiet", "--json", file.name]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                   preexec_fn=lambda: limit_processor(bench.limit))
        message = process.stderr.read().decode().strip()
        _, status, usage = os.wait4(process.pid, 0)
        process.stderr.close()
        process.returncode = os.waitstatus_to_exitcode(status)
        seconds = usage.ru_utime + usage.ru_stime
        if process.returncode < 0:
            return Outcome(seconds, usage.ru_maxrss/1024, None, f"not ended after {bench.limit} s")
        if process.returncode > 0:
            last = message.splitlines()[-1][:60] if message else ""
            return Outcome(seconds, usage.ru_maxrss/1024, None, f"status {process.returncode}: {last}")
        with open(file.name, encoding="utf-8") as text:
            return Outcome(seconds, usage.ru_maxrss/1024, json.load(text), None)


def points_of(result):
    """The points of all branches of a response."""
    return result["points"] + [point for branch in result.get("branches", [])
                               for point in branch["points"]]


def verify(result):
    """What is wrong with a response, or None."""
    certificates = [point["certificate"] for point in points_of(result)]
    gap = max(c["liouville"] for c in certificates)
    error = max(c["error"] for c in certificates)
    sample = result.get("sample", {"gap": 0.0, "disagreements": 0})
    if not gap <= LIOUVILLE:
        return f"Liouville gap {gap:.1e}"
    if not error <= ERROR:
        return f"error of a point {error:.1e}"
    if not sample["gap"] <= max(SAMPLED, STATED*(result.get("model_error", {}).get("estimated") or 0.0)):
        return f"another method differs by {sample['gap']:.1e}"
    if sample["disagreements"] > 1:
        return f"{sample['disagreements']} points of other stability by another method"
    return None


def response(bench, words):
    outcome = run(bench, ["frf"] + words)
    if outcome.result is not None and (wrong := verify(outcome.result)):
        bench.failed = True
        outcome.wrong = "WRONG: " + wrong
    return outcome


def condensed(bench, n):
    return [bench.scene("b-table-4.2"), "--set", "model.condense=static", "-n", str(n)]


class Bench:
    def __init__(self, options):
        self.hawser, self.limit, self.srcdir = options.hawser, options.limit, options.srcdir
        self.failed = self.missed = False

    def scene(self, name):
        return os.path.join(self.srcdir, "notebooks-data", "scenes", name + ".yaml")

    def show(self, what, goal, moonshot, value, unit, note):
        met = value is not None and value <= goal
        self.missed |= not met
        measured = "-" if value is None else f"{value:.3g} {unit}"
        print(f"{what:<52} {goal:g} {unit:<5} {moonshot or '':<9} {measured:<12} "
              f"{'met' if met else 'missed':<7} {note}", flush=True)

    def timed(self, what, goal, moonshot, words):
        outcome = response(self, words)
        note = outcome.wrong
        if note is None:
            events = len(outcome.result["events"])
            events += sum(len(b["events"]) for b in outcome.result.get("branches", []))
            note = f"{len(points_of(outcome.result))} points, {events} events"
        else:
            note += f" ({outcome.seconds:.1f} s)"
        self.show(what, goal, moonshot, None if outcome.wrong else outcome.seconds, "s", note)


def a_point(bench):
    outcome = response(bench, condensed(bench, 20) + ["--from", "0.9w1", "--to", "1.2w1"])
    value = None
    note = outcome.wrong
    if note is None:
        count = len(points_of(outcome.result))
        value = 1e3*outcome.seconds/count
        note = f"{count} points in {outcome.seconds:.1f} s, events included"
    bench.show("a point near resonance, 20 condensed modes", 20, "5 ms", value, "ms", note)


def growth(bench):
    """The exponent of the time of a point, by least squares over the logarithms of both."""
    times = []
    for n in SIZES:
        seconds = []
        for count in (EARLY, LATE):
            outcome = response(bench, condensed(bench, n) + ["--from", "1.15w1", "--to", "0.9w1",
                                                             "--max-points", str(count)])
            if outcome.wrong:
                break
            seconds.append(outcome.seconds)
        if len(seconds) == 2 and seconds[1] > seconds[0]:
            times.append((n, (seconds[1] - seconds[0])/(LATE - EARLY)))
    value = None
    if len(times) > 1:
        x = [math.log(n) for n, _ in times]
        y = [math.log(t) for _, t in times]
        mx, my = sum(x)/len(x), sum(y)/len(y)
        value = sum((a - mx)*(b - my) for a, b in zip(x, y))/sum((a - mx)**2 for a in x)
    note = ", ".join(f"{n}: {1e3*t:.3g} ms" for n, t in times)
    bench.show("exponent of the time per point, 5 to 60 modes", 2.5, "1.5", value, "", note)


def model(bench):
    outcome = run(bench, ["rom", bench.scene("b-table-4.2"), "-n", "60"])
    note = outcome.wrong
    if note is None and outcome.result["n"] < 60:
        bench.failed = True
        note = "WRONG: fewer modes than asked for"
    value = None if note else outcome.seconds
    bench.show("rom with 60 modes", 0.5, "", value, "s", note or f"{outcome.memory:.0f} MB (goal 60)")


def boundaries(bench):
    outcome = run(bench, ["hill", bench.scene("b-table-5.4"), "-n", "6", "--x", "Omega=0.5w1:5w1",
                          "--y", "factor.load=0:80"])
    value, note = None, outcome.wrong
    if note is None:
        count = sum(len(b["points"]) for b in outcome.result["boundaries"])
        if count > 0:
            value = 1e6*outcome.seconds/count
        note = f"{count} points"
    bench.show("hill, a point of a boundary", 50, "", value, "us", note)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--hawser", default="./hawser", help="the program (./hawser)")
    parser.add_argument("--srcdir", default=".", help="folder of the sources (.)")
    parser.add_argument("--limit", type=int, default=120, help="processor seconds of a run (120)")
    parser.add_argument("--only", default="", help="lines that contain this word")
    parser.add_argument("--held", action="store_true", help="status 2 where a goal is missed")
    options = parser.parse_args()
    bench = Bench(options)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    static = [bench.scene("b-table-4.2"), "--set", "model.condense=static"]
    auto = static + ["--set", "model.modes=auto", "--set"]
    line2 = [bench.scene("b-table-4.4-line-2"), "--set", "model.energy=exact", "--set",
             "model.basis=10", "--from", "0.8w1", "--to", "1.6w1", "--step", "0.02", "--tolerance",
             "1e-6"]
    deep = [bench.scene("deep-sag"), "--set", "model.energy=exact", "--set", "model.basis=14",
            "--from", "0.9w1", "--to", "1.2w1", "--tolerance", "1e-6"]
    lines = [
        ("point", lambda: a_point(bench)),
        ("growth", lambda: growth(bench)),
        ("chairlift", lambda: bench.timed("frf chairlift, 16 condensed, 0.6-3.3 w1", 5, "1.5 s",
                                          static + ["-n", "16"])),
        ("chairlift-9", lambda: bench.timed("frf chairlift, 9 condensed, 0.9-1.2 w1", 1, "", static +
                                            ["-n", "9", "--from", "0.9w1", "--to", "1.2w1"])),
        ("deep-sag", lambda: bench.timed("frf deep-sag.yaml, all defaults", 5, "2 s",
                                         [bench.scene("deep-sag")])),
        ("auto", lambda: bench.timed("frf chairlift, modes auto, 0.5 %", 10, "3 s",
                                     auto + ["model.accuracy=0.5 %"])),
        ("auto-fine", lambda: bench.timed("frf chairlift, modes auto, 0.05 %", 10, "3 s",
                                          auto + ["model.accuracy=0.05 %"])),
        ("full", lambda: bench.timed("full order, B Table 4.4 line 2, 30 coordinates", 1, "0.4 s",
                                     line2)),
        ("full-deep-sag", lambda: bench.timed("full order, deep sag, 42 coordinates, 0.9-1.2 w1", 20,
                                              "5 s", deep)),
        ("raw", lambda: bench.timed("frf chairlift, raw", 0.25, "0.1 s",
                                    [bench.scene("b-table-4.2")])),
        ("rom", lambda: model(bench)),
        ("hill", lambda: boundaries(bench)),
    ]
    print(f"{'what':<52} goal    moonshot  measured     ")
    for name, line in lines:
        if options.only in name:
            line()
    return 1 if bench.failed else 2 if options.held and bench.missed else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# Is the response that nobody chose a model for right? Random cables, each about its first four natural
# frequencies: the largest motion and its frequency by `hawser frf` with all defaults, against the exact
# energy on many functions a component.
#
# Cables: sag 1/1000 to 1/4 of the span, EA/H 100 to 1e5, up to 75 degrees, some with masses or springs;
# loads that move a linear cable by up to half its sag or a twentieth of the span.
# A line each: cable, mode, seconds of processor time, model, stated error, error of amplitude and
# frequency. What the reference refuses (slack, no steady answer) is counted and left out. At the end a
# table of the errors.
#
# Usage: bench/backbones.py HAWSER [CABLES [SEED [FUNCTIONS [SECONDS]]]] (10, 1, 20, 600; processor time of
# a run)
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import math
import os
import random
import signal
import subprocess
import sys
import tempfile

hawser = sys.argv[1]
count = int(sys.argv[2]) if len(sys.argv) > 2 else 10
seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
functions = int(sys.argv[4]) if len(sys.argv) > 4 else 20
longest = int(sys.argv[5]) if len(sys.argv) > 5 else 600
folder = tempfile.mkdtemp()
scene = os.path.join(folder, "scene.yaml")
result = os.path.join(folder, "result.json")


def logarithmic(chance, low, high):
    return math.exp(chance.uniform(math.log(low), math.log(high)))


def draw(chance):
    sag = logarithmic(chance, 1e-3, 0.25)
    d = logarithmic(chance, 10.0, 500.0)
    h = 0.0 if chance.random() < 0.3 else d*math.tan(math.radians(chance.uniform(-75.0, 75.0)))
    rho = logarithmic(chance, 0.2, 50.0)
    H = rho*9.81*math.hypot(d, h)/(8.0*sag)
    EA = H*logarithmic(chance, 100.0, 1e5)
    ratio = logarithmic(chance, 0.003, 0.02)
    swing = chance.uniform(0.2, 1.0)*max(0.5*sag, 0.05)*d
    # of a string at its first resonance: 4 q/(pi rho w1^2 2 ratio)
    omega = math.pi/d*math.sqrt(H/rho)
    q = swing*0.25*math.pi*rho*omega*omega*2.0*ratio
    angle = chance.uniform(0.0, math.pi)
    text = "cable: {EA: %.9g, rho: %.9g}\nspan: {d: %.9g, h: %.9g}\ntension: {H: %.9g}\n" % (EA, rho, d, h, H)
    text += "damping: {ratio: %.9g}\n" % ratio
    text += "load: {frame: local, per_length: [0, %.9g, %.9g]}\n" % (q*math.cos(angle), q*math.sin(angle))
    kind = chance.random()
    if kind > 0.4:
        items = []
        number = chance.randint(1, 2)
        for i in range(number):
            at = (i + chance.uniform(0.2, 0.8))/number
            if kind < 0.75:
                items.append("{at: %.6g, mass: %.6g}" % (at, rho*d*logarithmic(chance, 0.01, 0.5)))
            else:
                k = H/d*logarithmic(chance, 0.1, 10.0)
                items.append("{at: %.6g, spring: [0, %.6g, %.6g]}" % (at, k, k))
        text += "attach: [%s]\n" % ", ".join(items)
    return text, "sag %.4f EA/H %.3g slope %.0f%s" % (sag, EA/H, math.degrees(math.atan2(h, d)),
                                                    "" if kind <= 0.4 else " masses" if kind < 0.75 else " springs")


def respond(mode, more):
    command = ["sh", "-c", 'ulimit -t %d; exec "$@"' % longest, "sh", hawser, "frf", scene,
               "--from", "%gw%d" % (0.85, mode), "--to", "%gw%d" % (1.2, mode), "-q", "--json", result] + more
    before = os.times()
    run = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False)
    after = os.times()
    seconds = after.children_user + after.children_system - before.children_user - before.children_system
    if run.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return None, "over %d s" % longest, seconds
    if run.returncode:
        return None, run.stderr.decode().strip().split("\n")[-1][:160], seconds
    with open(result, encoding="utf-8") as stream:
        return json.load(stream), "", seconds


def largest(answer):
    peaks = [p for p in answer["peaks"] if p["probe"] in ("quarter", "mid", "three_quarter") and
             p["component"] in ("y", "z") and p.get("stable", True)]
    return max(peaks, key=lambda p: p["size"]) if peaks else None


def model(answer):
    kind = answer["scene"].get("model", {})
    return "exact %s" % kind.get("basis") if kind.get("energy") == "exact" else "modes"


print("hawser frf, each of the first four resonances: defaults against exact energy, %d functions" % functions)
done = wrong = left = beyond = 0
errors = {"amplitude": [], "frequency": [], "seconds": []}


def quantiles(name):
    values = sorted(errors[name])
    print("%-10s median %.1e, nine of ten %.1e, largest %.1e" %
          (name, values[len(values)//2], values[9*len(values)//10], values[-1]))


for number in range(count):
    chance = random.Random(seed*100003 + number)
    text, what = draw(chance)
    with open(scene, "w", encoding="utf-8") as stream:
        stream.write(text)
    for mode in range(1, 5):
        own, why, seconds = respond(mode, [])
        if not own:
            print("%3d w%d %6.1f s  %s: no answer: %s" % (number, mode, seconds, what, why), flush=True)
            left += 1
            continue
        exact, why, longer = respond(mode, ["--set", "model.energy=exact", "--set", "model.basis=%d" % functions])
        a, b = largest(own), largest(exact) if exact else None
        if not b or not a:
            print("%3d w%d %6.1f s  %s: no reference: %s" % (number, mode, seconds, what, why or "no peak"), flush=True)
            left += 1
            continue
        stated = own["model_error"].get("estimated") if own.get("model_error") else None
        size, omega = abs(a["size"]/b["size"] - 1.0), abs(a["Omega"]/b["Omega"] - 1.0)
        done += 1
        for name, value in ("amplitude", size), ("frequency", omega), ("seconds", seconds):
            errors[name].append(value)
        bad = size > 0.01 or omega > 0.001
        wrong += bad
        beyond += stated is not None and max(size, omega) > stated
        print("%3d w%d %6.1f s (%.0f)  %s: %s, stated %s, amplitude %.1e, frequency %.1e%s%s" %
              (number, mode, seconds, longer, what, model(own), "%.1e" % stated if stated is not None else "-", size,
               omega, " BEYOND 1 %, 0.1 %" if bad else "", "" if not own["warnings"] else ", warned"), flush=True)
print("%d resonances, %d beyond 1 %% or 0.1 %%, %d beyond the stated error, %d left out" % (done, wrong, beyond, left))
for column in errors if done else ():
    quantiles(column)

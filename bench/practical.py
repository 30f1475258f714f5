#!/usr/bin/env python3
# bench/practical.py HAWSER [SCENES [SEED [FIRST [WORD]]]] (40, 1, 0): is the response of ordinary cables right by default?
#
# Random conductors, stays, guys, spans of chairlifts, mooring lines in air, hoist ropes and cables of footbridges, in
# turn, each near its first or second resonance: `hawser frf` with all defaults against the exact energy on MORE
# functions a component than that took itself, at least FEWEST. A scene depends on the seed and its number alone. With
# WORDs of EXTRA, such as absorber+masses, the kinds of cables for which these are usual have them besides; with a number,
# each scene has so many of them, which are drawn.
#
# Both largest peaks and all folds of a stable branch: a line each scene with the seconds of processor time, the largest
# true error of these (of an amplitude or a frequency, relative), the stated error, and what is wrong. "lost": a peak or
# fold has no counterpart within FAR in frequency, but for two folds that are no farther from each other than the stated
# error, which may be none. Only what lies in the ranges that both answered for is compared.
# Last: how many are beyond the stated error, the ninth of ten of stated over true error and of the seconds.
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import math
import os
import random
import resource
import subprocess
import sys
import tempfile

FEWEST, MORE = 18, 4
LONGEST = 150  # s of processor time of a run
FAR = 0.03
SURE = 1e-4    # true errors below this are those of the reference


def logarithmic(chance, low, high):
    return math.exp(chance.uniform(math.log(low), math.log(high)))


# name: EA of 1 kg/m of rope in MN; kg/m; m of the distance; degrees of the slope; sag over the length of the chord;
# damping ratio; part of the load that lies across the plane of the cable, least and most
KINDS = {
    "conductor": ((14, 22), (0.8, 2.2), (200, 500), (-6, 6), (0.015, 0.045), (0.003, 0.01), (0, 1)),
    "stay": ((21, 25), (30, 90), (60, 220), (22, 60), (2e-4, 1.5e-3), (0.001, 0.005), (0, 1)),
    "guy": ((16, 22), (1.5, 6), (60, 250), (40, 60), (2e-3, 2e-2), (0.002, 0.01), (0, 1)),
    "chairlift": ((16, 20), (5, 9), (80, 300), (5, 35), (0.008, 0.03), (0.005, 0.02), (0, 0.7)),
    "mooring": ((8, 20), (20, 120), (150, 600), (15, 60), (0.03, 0.12), (0.01, 0.03), (0, 1)),
    "hoist": ((14, 20), (3, 9), (100, 500), (82, 88), (1e-4, 2e-3), (0.003, 0.02), (0.3, 1)),
    "footbridge": ((18, 22), (20, 60), (40, 140), (-3, 3), (0.05, 0.11), (0.004, 0.01), (0, 1)),
}


# What a word adds: a damping ratio, and what it writes into sections of the scene. A load by itself has the section "load".
def damper(chance, of):
    """A third to three times as large as is best for the first mode of a taut string."""
    at = chance.uniform(0.01, 0.05)
    size = logarithmic(chance, 0.03, 0.3)*of["rho"]*of["chord"]*of["omega"]/at
    return 0.5*at, {"attach": f"{{at: {at:.4g}, damper: [0, {size:.5g}, {size:.5g}]}}"}


def deck(chance, of):
    turn, moved = chance.uniform(0.0, math.pi), of["swing"]*of["ratio"]
    return 0.0, {"support": f"B: {{motion: [0, {moved*math.cos(turn):.5g}, {moved*math.sin(turn):.5g}]}}", "load": ""}


def wind(chance, of):
    return 0.0, {"wind": f"speed: {chance.uniform(3, 20):.4g}, density: 1.225, "
                         f"diameter: {0.02*math.sqrt(of['rho']):.4g}, drag: [{chance.uniform(0.7, 1.2):.3g}]"}


def steady(chance, of):
    return of["omega"]*of["chord"]/math.pi*chance.uniform(0.02, 0.3)


def travel(chance, of):
    return 0.0, {"travel": f"speed: {steady(chance, of):.5g}, hold: tension"}


def speed(chance, of):
    mean = steady(chance, of)
    return 0.0, {"travel": f"speed: {mean:.5g}, fluctuation: {mean*chance.uniform(0.01, 0.1):.4g}, hold: tension"}


def absorber(chance, of):
    mass, at = of["rho"]*of["chord"]*chance.uniform(0.005, 0.03), chance.uniform(0.1, 0.5)
    k = mass*of["omega"]**2*chance.uniform(0.8, 1.2)
    return 0.02, {"attach": f"{{at: {at:.4g}, absorber_mass: {mass:.5g}, absorber_stiffness: {k:.5g}, "
                            f"absorber_damping: {0.2*mass*of['omega']:.5g}, absorber_direction: [0, 1, 0]}}"}


def supports(chance, of):
    k = ", ".join(f"{of['H']/of['chord']*logarithmic(chance, 30, 1000):.5g}" for _ in range(3))
    return 0.0, {"support": f"B: {{stiffness: [{k}]}}"}


def masses(chance, of):
    mass, at = of["rho"]*of["chord"]*logarithmic(chance, 0.003, 0.1), chance.uniform(0.1, 0.9)
    return 0.0, {"attach": f"{{at: {at:.4g}, mass: {mass:.5g}}}"}


def springs(chance, of):
    k, at = of["H"]/of["chord"]*logarithmic(chance, 0.1, 10), chance.uniform(0.05, 0.95)
    return 0.0, {"attach": f"{{at: {at:.4g}, spring: [0, {k:.5g}, {k:.5g}]}}"}


def bending(chance, of):
    """Boundary layers of 1e-3 to 0.03 of the length."""
    end = chance.choice(("", "A: clamped, B: clamped", "B: clamped"))
    layer = of["chord"]*logarithmic(chance, 1e-3, 0.03)
    return 0.0, {"cable": f"EI: {of['H']*layer**2:.5g}", **({"ends": end} if end else {})}


def ice(chance, of):
    return 0.0, {"load.static": f"mass: {of['rho']*chance.uniform(0.1, 0.8):.4g}"}


def gale(chance, of):
    return 0.0, {"load.static": f"per_length: [0, 0, {9.81*of['rho']*chance.uniform(0.1, 0.8):.4g}]"}


def temperature(chance, of):
    return 0.0, {"temperature": f"change: {chance.uniform(-40, 40):.3g}, expansion: 1.2e-5"}


def drag(chance, of):
    return 0.0, {"damping": f"drag: {logarithmic(chance, 0.1, 1.0)*0.02*math.sqrt(of['rho']):.4g}"}


def wave(chance, of):
    return 0.0, {"loads": f"{{per_length: [0, {0.3*of['q']:.4g}, 0], wave: {of['chord']*chance.uniform(0.3, 2):.4g}}}"}


# word: the kinds of cables, and a function that gives what it adds
EXTRA = {"damper": (("stay", "guy"), damper), "deck": (("stay", "footbridge"), deck),
         "wind": (("conductor", "stay", "guy", "chairlift"), wind), "speed": (("chairlift", "hoist"), speed),
         "absorber": (("stay", "conductor"), absorber), "supports": (("conductor", "stay", "guy"), supports),
         "masses": (KINDS, masses), "springs": (KINDS, springs), "bending": (KINDS, bending), "ice": (KINDS, ice),
         "gale": (KINDS, gale), "temperature": (KINDS, temperature), "drag": (KINDS, drag), "wave": (KINDS, wave),
         "travel": (("chairlift", "hoist"), travel)}
# what a scene can't have together, and what the mixture would replace
AGAINST = {"speed travel": "speed travel masses springs damper absorber wind deck supports bending",
           "supports": "deck wind bending", "wind": "deck drag", "wind gale ice": "wind gale ice",
           "wind gale": "springs damper absorber", "bending": "absorber"}


def kinds_of(words):
    return [kind for kind in KINDS if all(kind in EXTRA[word][0] for word in words)]


def some(chance, count):
    """Words that go together."""
    while True:
        words = chance.sample(sorted(EXTRA), count)
        if kinds_of(words) and not any(a in left.split() and b in right.split() and a != b
                                       for left, right in AGAINST.items() for a in words for b in words):
            return words


def section(name, parts):
    if name in ("attach", "loads"):
        return f"{name}: [{', '.join(parts)}]\n"
    return f"{name}: {{{', '.join(parts)}}}\n"


def draw(chance, kind, extra=()):
    stiff, mass, long, slope, sags, ratios, across = KINDS[kind]
    rho = logarithmic(chance, *mass)
    chord = chance.uniform(*long)
    angle = math.radians(chance.uniform(*slope))
    sag = logarithmic(chance, *sags)
    d, h = chord*math.cos(angle), chord*math.sin(angle)
    # of a parabola, whose sag is across the chord: the part of the weight there
    H = rho*9.81*chord*math.cos(angle)**2/(8.0*sag)
    ratio = logarithmic(chance, *ratios)
    # the motion of a linear string at its first resonance: up to half the sag, or a hundredth of the chord
    swing = chance.uniform(0.1, 1.0)*max(0.5*sag, 0.01)*chord
    omega = math.pi/chord*math.sqrt(H/math.cos(angle)/rho)
    q = swing*0.25*math.pi*rho*omega*omega*2.0*ratio
    turn = chance.uniform(*across)*0.5*math.pi
    of = {"rho": rho, "chord": chord, "H": H, "ratio": ratio, "swing": swing, "omega": omega, "q": q}
    parts = {}
    for word in extra:
        more, lines = EXTRA[word][1](chance, of)
        q += of["q"]*more/ratio
        for name, text in lines.items():
            parts.setdefault(name, []).append(text)
    EA = 1e6*rho*chance.uniform(*stiff)
    first = {"cable": [f"EA: {EA:.6g}, rho: {rho:.6g}"], "span": [f"d: {d:.6g}, h: {h:.6g}"], "tension": [f"H: {H:.6g}"],
             "damping": [f"ratio: {ratio:.4g}"]}
    load = [] if "load" in parts else [f"frame: local, per_length: [0, {q*math.cos(turn):.5g}, {q*math.sin(turn):.5g}]"]
    still = parts.pop("load.static", [])
    parts["load"] = load + ([f"static: {{{', '.join(still)}}}"] if still else [])
    text = "".join(section(name, first.get(name, []) + parts.get(name, []))
                   for name in dict.fromkeys([*first, *parts]) if first.get(name) or parts.get(name))
    return text, chance.choice((1, 1, 2))


def about(mode):
    """The range about a resonance."""
    return ["--from", f"0.85w{mode}", "--to", f"1.2w{mode}"]


def respond(hawser, folder, scene, more):
    """The answer, or None and why not; seconds of processor time."""
    result = os.path.join(folder, "result.json")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run([hawser, "frf", scene, "-q", "--json", result, *more], stdout=subprocess.DEVNULL,
                         stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, check=False,
                         env=dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1"), preexec_fn=lambda:
                         resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST + 1)))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if run.returncode:
        said = run.stderr.decode(errors="replace").strip().split("\n")[-1]
        return None, said[:100] if run.returncode > 0 else f"over {LONGEST} s", seconds
    with open(result, encoding="utf-8") as stream:
        return json.load(stream), "", seconds


def peak_of(p):
    return f"peak {p['component']} {p['probe']}", p["Omega"], p["size"], p["Omega_error"] + p["size_error"]


def landmarks(answer, lo, hi):
    """(kind, Omega, size, error by which it is read) of both largest stable peaks of a probe, and of the folds of
    stable motions."""
    peaks = sorted((p for p in answer["peaks"] if p["component"] in ("x", "y", "z") and p.get("stable") and lo < p["Omega"] < hi),
                   key=lambda p: -p["size"])
    found = [peak_of(p) for p in peaks[:2]]
    found += [("fold", e["Omega"], None, 0.0) for e in answer["events"]
              if e["kind"] == "fold" and 0 in (e["unstable_before"], e["unstable_after"]) and lo < e["Omega"] < hi]
    return found


def counterparts(answer):
    return ([peak_of(p) for p in answer["peaks"]] +
            [("fold", e["Omega"], None, 0.0) for e in answer["events"] if e["kind"] == "fold"])


def distance(a, b):
    apart = abs(b[1]/a[1] - 1.0)
    return apart if a[2] is None else max(apart, abs(b[2]/a[2] - 1.0))


def is_paired(mark, marks, within):
    return mark[0] == "fold" and any(other is not mark and other[0] == "fold" and abs(other[1]/mark[1] - 1.0) <= within
                                     for other in marks)


def compare(own, exact):
    """Largest error of the landmarks, None without any; less what the reference is read by; those that have no
    counterpart."""
    stated = (own["model_error"] or {}).get("estimated") or 0.0
    lo = max(own["range"][0], exact["range"][0])*(1.0 + 1e-6)
    hi = min(own["range"][1], exact["range"][1])*(1.0 - 1e-6)
    worst, sure, lost = None, 0.0, []
    for one, other in ((own, exact), (exact, own)):
        beside = counterparts(other)
        marks = landmarks(one, lo, hi)
        for mark in marks:
            near = [(distance(mark, b), b) for b in beside if b[0] == mark[0] and abs(b[1]/mark[1] - 1.0) <= FAR]
            if near:
                apart, b = min(near)
                worst = max(worst or 0.0, apart)
                sure = max(sure, apart - (mark if one is exact else b)[3])
            elif not is_paired(mark, marks, stated):
                lost.append(f"{mark[0]} at {mark[1]:.5g}" + (" (of the reference)" if one is exact else ""))
    return worst, sure, lost


def model(answer):
    kind = answer["scene"].get("model", {})
    return f"exact {kind.get('basis')}" if kind.get("energy") == "exact" else "modes"


def main():
    hawser = os.path.abspath(sys.argv[1])
    count, seed, first = (int(sys.argv[k]) if len(sys.argv) > k else default for k, default in ((2, 40), (3, 1), (4, 0)))
    asked = sys.argv[5] if len(sys.argv) > 5 else ""
    words = [] if asked.isdigit() else asked.split("+") if asked else []
    folder = tempfile.mkdtemp()
    scene = os.path.join(folder, "scene.yaml")
    beyond = losses = left = 0
    seconds, ratios = [], []
    for number in range(first, first + count):
        chance = random.Random(seed*100003 + number)
        these = some(chance, int(asked)) if asked.isdigit() else words
        kinds = kinds_of(these)
        kind = kinds[number % len(kinds)]
        text, mode = draw(chance, kind, these)
        with open(scene, "w", encoding="utf-8") as stream:
            stream.write(text)
        head = f"{number:3d} {kind:10s} w{mode}" + (f" {'+'.join(these):24s}" if asked.isdigit() else "")
        own, why, took = respond(hawser, folder, scene, about(mode))
        seconds.append(took)
        if not own:
            left += 1
            print(f"{head} {took:6.1f} s  no answer: {why}", flush=True)
            continue
        functions = max(FEWEST, MORE + (own["scene"]["model"]["basis"] if model(own) != "modes" else 0))
        exact, why, longer = respond(hawser, folder, scene, about(mode) + [
            "--set", "model.energy=exact", "--set", f"model.basis={functions}", "--tolerance", "1e-7"])
        head += f" {took:6.1f} s ({longer:.0f})  {model(own):8s}"
        if not exact:
            left += 1
            print(f"{head} no reference: {why}", flush=True)
            continue
        error, sure, lost = compare(own, exact)
        stated = (own["model_error"] or {}).get("estimated")
        known = stated is not None and error is not None
        wrong = ["BEYOND"] if known and sure > max(stated, SURE) else []
        beyond += bool(wrong)
        losses += bool(lost)
        if known and not wrong:
            ratios.append(stated/max(error, SURE))
        wrong += [f"lost: {', '.join(lost)}"] if lost else []
        wrong += [f"{len(own['warnings'])} warnings"] if own["warnings"] else []
        true, said = ("-" if error is None else f"{error:.1e}" for error in (error, stated))
        print(f"{head} true {true} stated {said:7s} {'; '.join(wrong)}", flush=True)
    seconds.sort()
    ratios.sort()
    ninth = (9*len(seconds) - 1)//10
    print(f"{count} scenes: {beyond} beyond the stated error, {losses} with a peak or fold lost, {left} left out; seconds: "
          f"median {seconds[len(seconds)//2]:.1f}, nine of ten {seconds[ninth]:.1f}, largest {seconds[-1]:.1f}" +
          (f"; stated over true error: median {ratios[len(ratios)//2]:.1f}, nine of ten "
           f"{ratios[(9*len(ratios) - 1)//10]:.1f}" if ratios else ""))


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
"""bench/nets.py - the stated error of responses of random nets against a finer mesh.

    bench/nets.py HAWSER [NETS] [SEED] [FOLDER]

Spans in a row on insulators, stays with cross-ties, meshes of cells, and masses on anchors: 2 to 30
cables, taut, with modes of nearly equal frequencies. The load is such that the amplitude near the first
resonance is some hundredths of a span. hawser frf states the error of each with 6 to 12 modes; the truth
is what the same model's folds and peaks are off from those of a mesh with twice as many elements, as
corrected there. A line a net: stated error, true one, their ratio, the estimate without correction over
the true one, folds and peaks found of all, seconds of processor time; then the counts. The status is 1 if
a stated error is smaller than the true one. FOLDER: the scenes are written there.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import math
import os
import random
import resource
import subprocess
import sys
import tempfile

PARTS = 24  # elements of a cable: as many as models have by default
LIMIT = 60  # s a response
SAME = 5e-4  # Omega of a fold or peak in both meshes; farther apart they are two


class Net:
    """A scene of kind net under construction."""

    def __init__(self, mass, tension, slope, rate):
        self.nodes, self.supports, self.cables, self.loads = {}, {}, [], {}
        self.masses, self.mass, self.tension, self.slope, self.rate = {}, mass, tension, slope, rate

    def node(self, name, place, held=False):
        """A node, held or not."""
        self.nodes[name] = [round(x, 6) for x in place]
        if held:
            self.supports[name] = "fixed"
        return name

    def cable(self, a, b, tension=None, mass=None, parts=PARTS):
        """A cable whose tension is about the given one when it is straight."""
        tension = tension or self.tension
        mass = self.mass if mass is None else mass
        stiffness = max(600.0*tension, 1e6)
        span = math.dist(self.nodes[a], self.nodes[b])
        name = f"c{len(self.cables) + 1}"
        self.cables.append({"name": name, "from": a, "to": b, "EA": stiffness, "rho": mass,
                            "length0": round(span/(1.0 + tension/stiffness), 9), "elements": parts})
        return name

    def force(self, name, span, direction):
        """The load per length that gives the slope near the resonance of a span."""
        omega = math.pi/span*math.sqrt(self.tension/self.mass)
        force = self.slope*span/math.pi*self.mass*omega*self.rate*omega*math.pi/4.0
        self.loads[name] = {"per_length": [force*x for x in direction], "harmonic": {"multiple": 1}}

    def scene(self, factor, omega):
        """The scene with a multiple of the elements; omega: of the first mode, for the damping."""
        cables = [dict(c, elements=c["elements"]*(factor if c["elements"] > 1 else 1))
                  for c in self.cables]
        scene = {"nodes": self.nodes, "supports": self.supports, "cables": cables, "loads": self.loads,
                 "damping": {"rayleigh": {"mass": self.rate*omega}}}
        if self.masses:
            scene["masses"] = self.masses
        return scene


def row(rng, net):
    """Spans in a row, held by insulators."""
    spans, at, last = rng.randint(2, 6), 0.0, net.node("A", [0.0, 0.0, 0.0], True)
    longest = ("", 0.0)
    for i in range(1, spans + 1):
        length = rng.uniform(150.0, 350.0)
        at += length
        end = net.node(f"J{i}", [at, 0.0, 0.0], i == spans)
        name = net.cable(last, end)
        longest = max(longest, (name, length), key=lambda x: x[1])
        if i < spans:
            height = rng.uniform(1.5, 4.0)
            net.node(f"P{i}", [at, height, 0.0], True)
            net.cable(f"P{i}", end, 0.2*net.tension, rng.uniform(5.0, 20.0))
        last = end
    net.force(longest[0], longest[1], [0.0, 1.0, rng.choice([0.0, 1.0])])
    return longest[1]


def stays(rng, net):
    """Cables beside each other with cross-ties."""
    count, ties = rng.randint(2, 4), rng.randint(1, 2)
    span = rng.uniform(60.0, 160.0)
    for i in range(count):
        height = -5.0*i
        last = net.node(f"A{i}", [0.0, height, 0.0], True)
        for k in range(ties):
            next_one = net.node(f"J{i}_{k}", [span*(k + 1)/(ties + 1.3), height, 0.0])
            net.cable(last, next_one)
            last = next_one
        net.cable(last, net.node(f"B{i}", [span, height, 0.0], True))
    for k in range(ties):
        for i in range(count - 1):
            net.cable(f"J{i}_{k}", f"J{i + 1}_{k}", 0.06*net.tension, 0.2*net.mass, 1)
        net.node(f"G{k}", [net.nodes[f"J0_{k}"][0], 6.0, 0.0], True)
        net.node(f"H{k}", [net.nodes[f"J0_{k}"][0], -5.0*count - 1.0, 0.0], True)
        net.cable(f"G{k}", f"J0_{k}", 0.06*net.tension, 0.2*net.mass, 1)
        net.cable(f"J{count - 1}_{k}", f"H{k}", 0.06*net.tension, 0.2*net.mass, 1)
    for cable in net.cables[:ties + 1]:
        net.force(cable["name"], span, [0.0, 1.0, rng.choice([0.0, 0.5])])
    return span


def cells(rng, net):
    """A flat mesh, held at its edge."""
    m, n, side = rng.randint(2, 4), rng.randint(2, 4), rng.uniform(4.0, 12.0)
    for i in range(m + 1):
        for j in range(n + 1):
            net.node(f"n{i}{j}", [side*i, 0.0, side*j], i in (0, m) or j in (0, n))
    for i in range(m + 1):
        for j in range(n + 1):
            for k, l in ((i + 1, j), (i, j + 1)):
                a, b = f"n{i}{j}", f"n{k}{l}"
                if b in net.nodes and not (a in net.supports and b in net.supports):
                    net.cable(a, b)
    span = side*min(m, n)
    net.force(net.cables[0]["name"], span, [0.0, rng.uniform(2.0, 4.0), 0.0])
    return span


def anchors(rng, net):
    """A mass on three to six cables."""
    count, radius = rng.randint(3, 6), rng.uniform(30.0, 80.0)
    net.node("M", [0.0, 0.0, 0.0])
    net.masses["M"] = round(rng.uniform(0.1, 0.6)*net.mass*radius, 3)
    for i in range(count):
        angle = 2.0*math.pi*i/count
        depth = rng.choice([1.0, -1.0])*radius if i % 2 else -radius
        net.node(f"P{i}", [radius*math.cos(angle), depth, radius*math.sin(angle)], True)
        net.cable("M", f"P{i}")
    if all(net.nodes[f"P{i}"][1] < 0.0 for i in range(count)):
        net.loads["M"] = [0.0, net.tension*count/math.sqrt(2.0), 0.0]
    net.force(net.cables[0]["name"], radius*math.sqrt(2.0), [1.0, 0.0, rng.choice([0.0, 1.0])])
    return radius*math.sqrt(2.0)


def random_net(rng):
    """A net, and the frequency for its damping."""
    mass = 10.0**rng.uniform(0.0, 1.5)
    net = Net(mass, 9.81*mass*10.0**rng.uniform(2.3, 3.3), rng.uniform(0.008, 0.03),
              rng.uniform(0.01, 0.05))
    span = rng.choice([row, stays, cells, anchors])(rng, net)
    return net, math.pi/span*math.sqrt(net.tension/net.mass)


def respond(hawser, scene, path, modes):
    """The result of frf, and its processor time."""
    with open(path, "w", encoding="utf-8") as file:
        json.dump(scene, file)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        run = subprocess.run([hawser, "frf", path, "-n", str(modes), "--from", "0.94w1", "--to", "1.06w2",
                              "--method", "balance", "--certificate", "yes", "--quiet", "--json", "-"],
                             check=False, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return {"failed": f"not done in {LIMIT} s", "time": LIMIT}
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = json.loads(run.stdout) if run.returncode == 0 else {"failed": run.stderr.strip()}
    result["time"] = after.ru_utime - before.ru_utime
    return result


def truth(first, second):
    """Largest distance of the first model from the second mesh over the landmarks of both."""
    most, common = 0.0, 0
    for own in first["certified"]["landmarks"]:
        same = [other for other in second["certified"]["landmarks"]
                if own["Omega_mesh"] and other["Omega_mesh"] and
                all(own.get(k) == other.get(k) for k in ("kind", "probe", "component"))]
        other = min(same, key=lambda x: abs(x["Omega_mesh"] - own["Omega_mesh"]), default=None)
        if not other or abs(own["Omega_mesh"]/other["Omega_mesh"] - 1.0) > SAME:
            continue
        off = abs(other["Omega_mesh"]/own["Omega"] - 1.0)
        if own["kind"] == "peak":
            off = max(off, abs(other["size_mesh"]/own["size"] - 1.0))
        most, common = max(most, off), common + 1
    return most, common


def main():
    """All nets."""
    hawser, count, seed = sys.argv[1], 100, 1
    if len(sys.argv) > 2:
        count = int(sys.argv[2])
    if len(sys.argv) > 3:
        seed = int(sys.argv[3])
    folder = sys.argv[4] if len(sys.argv) > 4 else tempfile.mkdtemp()
    judged = held = tight = partly = none = 0
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    for k in range(2*count):
        rng = random.Random(1000*seed + k)
        net, omega = random_net(rng)
        modes = rng.randint(6, 12)
        path = os.path.join(folder, f"net-{k}.json")
        first = respond(hawser, net.scene(1, omega), path, modes)
        if judged + partly + none == count:
            break
        if "is slack at rest" in first.get("failed", ""):
            continue
        second = respond(hawser, net.scene(2, omega), path[:-5] + "-fine.json", modes)
        bad = first.get("failed") or second.get("failed")
        if bad or "certified" not in first or "certified" not in second:
            none += 1
            print(f"net {k}: {len(net.cables)} cables: {bad or 'no folds or peaks'}", flush=True)
            continue
        true, common = truth(first, second)
        all_of = len(first["certified"]["landmarks"])
        found = all_of - first["certified"]["refused"]
        stated, before = first["model_error"]["estimated"], first["model_error"].get("before")
        if found < all_of or not common:
            partly += 1
        else:
            judged += 1
            held += stated >= true
            tight += stated <= 3.0*true
        print(f"net {k}: {len(net.cables):2d} cables, {modes:2d} modes, stated {stated:.2e} true {true:.2e} "
              f"ratio {stated/(true or 1.0):6.2f} estimate {(before or stated)/(true or 1.0):8.2f}, "
              f"{found} of {all_of}, {first['time']:.2f} s", flush=True)
    print(f"{judged + partly + none} nets that are taut: {judged} with all folds and peaks found, of which "
          f"{held} within the stated error and {tight} stated at most three times too large; {partly} with "
          f"some that are not found, {none} without a response, folds or peaks")
    sys.exit(held < judged)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Random autonomous models: Hopf points against eigenvalues, limit cycles against time integration.

    bench/autonomous.py build/.libs/hawser MODELS FIRST_SEED

A model has 1 to 12 coordinates, stiffness and damping that change with a parameter p, gyroscopic and (every second one)
follower forces, cubic stiffness, cubic damping, quintic damping, and mixed terms. Of its equilibrium u = 0:

- the unstable eigenvalues are counted at 2001 values of p; where the count changes, halving gives each value. hawser must find
  these events, no others, at the same values within 1e-7 and of the same kind (two eigenvalues: Hopf), over p up and down;
- cycles of two branches (--branches 1) are integrated over their period by a Runge-Kutta method: they must close within 1e-5.

Exit status: 0; 1 when something differs. Needs numpy.
SPDX-License-Identifier: GPL-3.0-or-later"""
import json
import subprocess
import sys
import tempfile
import time

import numpy as np

LOW, HIGH = -1.0, 1.5
GRID = 2001
NARROW = 1e-12
SAME = 1e-7
CLOSED = 1e-5


class Model:
    def __init__(self, seed):
        rng = np.random.default_rng(seed)
        n = self.n = int(rng.integers(1, 13))
        self.K = np.diag(rng.uniform(0.5, 9.0, n))
        follower = rng.normal(0.0, 1.0, (n, n))
        self.F = 0.5*(follower - follower.T)*(seed % 2)
        gyro = rng.normal(0.0, 0.3, (n, n))
        self.D = np.diag(rng.uniform(0.02, 0.4, n)) + 0.5*(gyro - gyro.T)
        S = rng.normal(0.0, 0.3, (n, n))
        self.S = np.where(np.eye(n) > 0, -abs(S), S)
        pick = lambda: int(rng.integers(n))
        self.terms = [[j, [], [j]*3, float(rng.uniform(0.1, 1.0))] for j in range(n)]
        self.terms += [[j, [], [j]*5, float(rng.uniform(0.0, 0.3))] for j in range(n)]
        self.terms += [[pick(), [pick(), pick()], [pick()], float(rng.normal(0.0, 0.5))] for _ in range(3)]
        self.terms += [[j, [j]*3, [], float(rng.uniform(-0.5, 1.0))] for j in range(n)]

        def places(of_u, of_v):
            found = list(of_u) + [n + i for i in of_v]
            return found + [2*n]*(5 - len(found))
        self.row = np.array([term[0] for term in self.terms])
        self.place = np.array([places(term[1], term[2]) for term in self.terms])  # in the state and a 1 behind it
        self.value = np.array([term[3] for term in self.terms])

    def file(self, path):
        matrix = lambda A, B: [["%r+p*(%r)" % (float(a), float(b)) for a, b in zip(x, y)] for x, y in zip(A, B)]
        with open(path, "w", encoding="utf-8") as to:
            json.dump({"hawser_rom": 1, "n": self.n, "parameters": {"p": 0.0}, "K": matrix(self.K, self.F),
                       "D": matrix(self.D, self.S), "terms": self.terms}, to)

    def unstable(self, p):
        n = self.n
        A = np.block([[np.zeros((n, n)), np.eye(n)], [-(self.K + p*self.F), -(self.D + p*self.S)]])
        return int((np.linalg.eigvals(A).real > 0).sum())

    def rate(self, x, p):
        u, v = x[:self.n], x[self.n:]
        product = self.value*np.append(x, 1.0)[self.place].prod(axis=1)
        a = -(self.K + p*self.F) @ u - (self.D + p*self.S) @ v - np.bincount(self.row, product, self.n)
        return np.concatenate([v, a])

    def between(self, a, b, counts):
        """[(p, change of the count)] from a to b: halves, until each change is that of one eigenvalue or one pair."""
        if counts[0] == counts[1]:
            return []
        if b - a < NARROW:
            return [(0.5*(a + b), counts[1] - counts[0])]
        c = 0.5*(a + b)
        middle = self.unstable(c)
        return self.between(a, c, (counts[0], middle)) + self.between(c, b, (middle, counts[1]))

    def events(self):
        """[(p, change of the count)]"""
        grid = np.linspace(LOW, HIGH, GRID)
        counts = [self.unstable(p) for p in grid]
        return [event for i in range(1, GRID)
                for event in self.between(grid[i - 1], grid[i], counts[i - 1:i + 1])]

    def gap(self, point):
        """How far the cycle is from closed, relative, by a Runge-Kutta method."""
        x0, p, period = np.array(point["state"]), point["parameter"], 2.0*np.pi/point["Omega"]
        steps = max(600, point.get("steps", 0)*10)
        x, h = x0.copy(), period/steps
        for _ in range(steps):
            k1 = self.rate(x, p)
            k2 = self.rate(x + 0.5*h*k1, p)
            k3 = self.rate(x + 0.5*h*k2, p)
            x = x + h/6.0*(k1 + 2.0*k2 + 2.0*k3 + self.rate(x + h*k3, p))
        return np.linalg.norm(x - x0)/np.linalg.norm(x0)


def hawser(program, path, span, *more):
    out = subprocess.run(["timeout", "300", program, "frf", path, "--over", "p=%r:%r" % span, "-q", "--json", "-", *more],
                         capture_output=True, text=True, check=False)
    return json.loads(out.stdout) if out.stdout else None


def differ(found, wanted):
    got = sorted((e["parameter"], e["kind"]) for e in found)
    return len(got) != len(wanted) or any(
        abs(g[0] - w[0]) > SAME or (g[1] == "hopf") != (abs(w[1]) == 2) for g, w in zip(got, wanted))


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program, models = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 20
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    runs = events = cycles = bad = 0
    began = time.time()
    with tempfile.TemporaryDirectory() as folder:
        path = folder + "/model.json"
        for seed in range(first, first + models):
            model = Model(seed)
            model.file(path)
            wanted = model.events()
            events += len(wanted)
            for span in ((LOW, HIGH), (HIGH, LOW)):
                result = hawser(program, path, span)
                runs += 1
                if result is None or differ(result["events"], wanted):
                    bad += 1
                    print("seed %d, n %d, from %g: events %s, eigenvalues say %s" % (
                        seed, model.n, span[0], result and [(e["parameter"], e["kind"]) for e in result["events"]], wanted))
            result = hawser(program, path, (-0.2, 0.6), "--branches", "1", "--max-points", "150")
            for branch in result.get("branches", [])[:2] if result else []:
                for point in {len(branch["points"])//3, len(branch["points"]) - 1}:
                    gap = model.gap(branch["points"][point])
                    cycles += 1
                    if not gap < CLOSED:
                        bad += 1
                        print("seed %d, n %d: a cycle at p = %g is off by %.1e" % (
                            seed, model.n, branch["points"][point]["parameter"], gap))
    print("%d models, %d runs, %d events, %d cycles: %d differ, %.0f s" % (models, runs, events, cycles, bad,
                                                                          time.time() - began))
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())

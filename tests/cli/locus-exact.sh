#!/bin/sh
# hawser locus against closed forms. Two equal coordinates on a circle, with the cubic force a r^2 x and a
# circular load, move on a circle; with N = r^2, sigma = w^2 - Omega^2, c = d Omega
#     N ((sigma + a N)^2 + c^2) = f^2,   folds: 3 a^2 N^2 + 4 sigma a N + sigma^2 + c^2 = 0
# and in the rotating frame the torus is a Hopf bifurcation of four equations: for a < 0 at
#     N = - B/a (1 - sqrt(1 - w^2/B)),   B = d^2 + 4 Omega^2,   nu^2 = sigma + 2 a N + 2 Omega^2
# with multipliers exp(+-2 pi i nu/Omega). Pairs that are not coupled meet where both have a bifurcation.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
export PYTHONPATH=. PYTHONDONTWRITEBYTECODE=1

cat >exact.py <<'END'
import cmath, json, math

class Pair:
    """Two coordinates on a circle."""
    def __init__(self, w, d, a, f):
        self.w, self.d, self.a, self.f = w, d, a, f

    def load(self, Omega, N):
        """The factor of the load at which the circle has this N."""
        return math.sqrt(N*((self.w**2 - Omega**2 + self.a*N)**2 + (self.d*Omega)**2))/self.f

    def fold(self, Omega, side):
        s = self.w**2 - Omega**2
        root = math.sqrt(s*s - 3*(self.d*Omega)**2)
        return self.load(Omega, (side*root - 2*s)/(3*self.a))

    def cusp(self):
        Omega = (math.sqrt(3)*self.d + math.sqrt(3*self.d**2 + 4*self.w**2))/2
        return Omega, math.sqrt(8*(self.d*Omega)**3/(3*math.sqrt(3)*self.a))/self.f

    def hopf(self, Omega):
        """Its N and its frequency in the rotating frame."""
        B = self.d**2 + 4*Omega**2
        N = -B/self.a*(1 - math.sqrt(1 - self.w**2/B))
        nu2 = self.w**2 + Omega**2 + 2*self.a*N
        return N, math.sqrt(max(nu2, 0))

    def torus(self, Omega):
        return self.load(Omega, self.hopf(Omega)[0])

    def lyapunov(self, Omega):
        """The first Lyapunov coefficient from the four equations of the rotating frame."""
        N, nu = self.hopf(Omega)
        a, d, W, s = -self.a, self.d, math.sqrt(N), self.w**2 - Omega**2
        J = [[0, 0, 1, 0], [0, 0, 0, 1], [3*a*N - s, d*Omega, -d, 2*Omega], [-d*Omega, a*N - s, -2*Omega, -d]]
        B = lambda x, y: [0, 0, 2*a*W*(3*x[0]*y[0] + x[1]*y[1]), 2*a*W*(x[0]*y[1] + x[1]*y[0])]
        C = lambda x, y, z: [0, 0,
            2*a*(3*x[0]*y[0]*z[0] + x[0]*y[1]*z[1] + x[1]*y[0]*z[1] + x[1]*y[1]*z[0]),
            2*a*(3*x[1]*y[1]*z[1] + x[1]*y[0]*z[0] + x[0]*y[1]*z[0] + x[0]*y[0]*z[1])]
        less = lambda x: [[J[i][j] - (x if i == j else 0) for j in range(4)] for i in range(4)]
        q, p = null(less(1j*nu)), null([list(column) for column in zip(*less(1j*nu))])
        dot = lambda x, y: sum(u*v for u, v in zip(x, y))
        r = [z.conjugate() for z in q]
        h, k = solve(J, [-x for x in B(q, r)]), solve(less(2j*nu), [-x/2 for x in B(q, q)])
        return ((dot(p, B(q, h)) + dot(p, B(r, k)) + dot(p, C(q, q, r))/2)/dot(p, q)).real

def solve(A, b):
    n = len(b)
    M = [list(map(complex, row)) + [complex(x)] for row, x in zip(A, b)]
    for k in range(n):
        best = max(range(k, n), key=lambda i: abs(M[i][k]))
        M[k], M[best] = M[best], M[k]
        for i in range(k + 1, n):
            factor = M[i][k]/M[k][k]
            M[i] = [x - factor*y for x, y in zip(M[i], M[k])]
    x = [0]*n
    for k in reversed(range(n)):
        x[k] = (M[k][n] - sum(M[k][j]*x[j] for j in range(k + 1, n)))/M[k][k]
    return x

def null(A):
    n = len(A)
    rows = [list(row) + [math.sin(1 + i)] for i, row in enumerate(A)]
    return solve(rows + [[math.cos(2 + i) for i in range(n)] + [0]], [0]*n + [1])[:n]

def root(f, low, high):
    sign = f(low) < 0
    assert (f(high) < 0) != sign
    for _ in range(100):
        middle = (low + high)/2
        low, high = (middle, high) if (f(middle) < 0) == sign else (low, middle)
    return low

def write(name, pairs, swing=None):
    """The model of these pairs, and of a parametrically excited coordinate (damping, stiffness)."""
    n = 2*len(pairs) + bool(swing)
    K, D = ([[0.0]*n for _ in range(n)] for _ in range(2))
    C, f = [], [[0.0]*n, [0.0]*n]
    for at, pair in enumerate(pairs):
        for i in (2*at, 2*at + 1):
            o = 4*at + 1 - i
            K[i][i], D[i][i] = pair.w**2, pair.d
            C += [[i, i, i, i, pair.a], [i, i, o, o, pair.a]]
            f[i - 2*at][i] = pair.f
    first = {"k": 1, "phase": "cos", "f": f[0]}
    if swing:
        first["K"] = [[0.0]*n for _ in range(n)]
        K[-1][-1], D[-1][-1], first["K"][-1][-1] = 1.0, *swing
        C.append([n - 1]*4 + [0.5])
    with open(name, "w") as stream:
        json.dump({"n": n, "K": K, "D": D, "C": C,
                   "harmonics": [first, {"k": 1, "phase": "sin", "f": f[1]}]}, stream)

HARD, SOFT = Pair(1, 0.1, 0.5, 0.2), Pair(1, 0.1, -0.5, 1)
OTHER, THIRD, FOURTH = Pair(1, 0.1, 0.5, 0.3), Pair(1.1, 0.2, -0.5, 1.04), Pair(1.9, 0.1, 0.5, 0.4)
if __name__ == "__main__":
    write("hard.json", [HARD])
    write("soft.json", [SOFT])
    with open("hard.json") as stream: # load and damping as parameters of the file
        named = json.load(stream)
    named.update(hawser_rom=1, parameters={"F": HARD.f, "c": HARD.d}, D=[["c", 0], [0, "c"]])
    for harmonic in named["harmonics"]:
        harmonic["f"] = ["F" if x else 0 for x in harmonic["f"]]
    with open("named.json", "w") as stream:
        json.dump(named, stream)
    write("both.json", [OTHER, SOFT])
    write("tori.json", [SOFT, THIRD])
    write("flip.json", [FOURTH], (0.05, 0.3))
    for load in (1, 1.173, 1.179):
        with open("tipped-%g.json" % load, "w") as stream:
            json.dump({"n": 1, "K": [[1]], "D": [[0.1]], "Q": [[0, 0, 0, 1]], "C": [[0, 0, 0, 0, 0.5]],
                       "harmonics": [{"k": 1, "phase": "cos", "f": [0.5*load]}]}, stream)
END
python "models" <exact.py
cat >result.py <<'END'
import json
class Locus:
    def __init__(self, name):
        self.result = json.load(open(name + ".json"))
        assert self.result["not_followed"] == 0
        self.events = [e for c in self.result["curves"] for e in c["events"]]
        self.points = [p for c in self.result["curves"] for p in c["points"]]
    def of(self, kind):
        return [(e["Omega"], e["parameter"]) for e in self.events if e["kind"] == kind]
def near(a, b, most):
    assert max(abs(x/y - 1) for x, y in zip(a, b)) < most, (a, b)
END

works "folds" locus hard.json --from 0.8 --to 2 --over factor.load=0.1:2 --json hard-l.json -q
works "folds in load and damping" locus hard.json --over factor.damping=0.5:3.5 --and factor.load=0.3:3 \
	--Omega 1.3 --json plane-l.json --plot plane.svg -q
works "the same, exchanged" locus hard.json --over factor.load=0.3:3 --and factor.damping=3.5:0.5 --Omega 1.3 \
	--at 1.7 --tsv plane.tsv --json turned-l.json -q
works "in two parameters of the file" locus named.json --over c=0.05:0.35 --at 0.05 --and F=0.06:0.6 --Omega 1.3 \
	--json named-l.json -q
chairlift=$SRCDIR/notebooks-data/scenes/chairlift.yaml
works "a scene, over damping and load" locus "$chairlift" --kind torus --over damping.alpha=0.08:0.085 \
	--and factor.load=0.1:1.3 --Omega 2.915 --step 0.2 --json alpha-l.json -q
jump=$SRCDIR/notebooks-data/scenes/b-table-4.4-line-2.yaml
fold="-n 1 --set model.condense=static --Omega 1.298 --step 0.3"
# shellcheck disable=SC2086 # words
rough "a scene, over two of its keys" locus "$jump" $fold --over damping.alpha=0.2:0.204 \
	--and tension.T0=80.3kN:80.5kN --json keys-l.json -q
# shellcheck disable=SC2086
rough "the same, with a factor of the damping" locus "$jump" $fold --over factor.damping=1:1.02 \
	--and tension.T0=80.3kN:80.5kN --json factor-l.json -q
works "the scene with the other damping" frf "$chairlift" --set damping.alpha="0.085 kg/m/s" \
	--over factor.load=0.1:1.3 --Omega 2.915 --json alpha.json -q
works "its response from the other end" frf "$chairlift" --set damping.alpha="0.085 kg/m/s" \
	--over factor.load=1.3:0.805 --Omega 2.915 --json beyond.json -q
works "tori" locus soft.json --kind torus --from 3 --to 0.5 --over factor.load=0.05:5 --json soft-l.json -q
works "folds beside a torus" locus both.json --from 2 --to 1.2 --over factor.load=1:2 --at 1.7 --json both-f.json -q
works "tori beside a fold" locus both.json --kind torus --from 2 --to 1.2 --over factor.load=1:2 --at 1.7 \
	--json both-t.json -q
works "two tori" locus tori.json --kind torus --from 2 --to 1.06 --over factor.load=0.6:2 --at 1.7 \
	--json tori-l.json -q
works "folds beside period doublings" locus flip.json --from 1.9 --to 2.4 --over factor.load=0.4:1.5 \
	--json flip-f.json -q
works "period doublings beside folds" locus flip.json --kind period-doubling --from 1.9 --to 2.4 \
	--over factor.load=0.4:1.5 --json flip-p.json -q
works "generalised period doublings" locus tipped-1.json --kind period-doubling --from 3.5 --to 0.7 \
	--over factor.load=0.3:6 --at 2 --json tipped-l.json -q
works "a branch, less load" frf tipped-1.173.json --from 1.8 --to 1.6 --branches 1 --json less.json -q
works "a branch, more load" frf tipped-1.179.json --from 1.8 --to 1.6 --branches 1 --json more.json -q

python "folds and their cusp" <<'END'
from exact import *
from result import *
locus = Locus("hard-l")
near(locus.of("cusp")[0], HARD.cusp(), 1e-10)
for p in locus.points:
    O = p["Omega"]
    if O > HARD.cusp()[0]*(1 + 1e-9): # at the cusp both sides are the same
        assert min(abs(HARD.fold(O, side)/p["parameter"] - 1) for side in (1, -1)) < 1e-10
END
python "folds at one frequency, over load and damping" <<'END'
from exact import *
from result import *
c = (1.3**2 - 1)/math.sqrt(3)
cusp = math.sqrt(8*c**3/(3*math.sqrt(3)*HARD.a))/HARD.f, c/1.3/HARD.d # load, damping
plane, turned = Locus("plane-l"), Locus("turned-l")
event, = [e for e in plane.events if e["kind"] == "cusp"]
near((event["first"], event["parameter"]), cusp, 1e-10)
for locus, load, damping in ((plane, "first", "parameter"), (turned, "parameter", "first")):
    assert len(locus.points) > 20 and locus.result["Omega"] == 1.3
    for p in locus.points:
        other = Pair(HARD.w, HARD.d*p[damping], HARD.a, HARD.f)
        if p[damping] < cusp[1]*(1 - 1e-9):
            assert min(abs(other.fold(1.3, side)/p[load] - 1) for side in (1, -1)) < 1e-10
named = Locus("named-l") # begins at an end of the range, where the curve ends again: one curve
assert len(named.result["curves"]) == 1
event, = [e for e in named.events if e["kind"] == "cusp"]
near((event["first"], event["parameter"]), (cusp[0]*HARD.f, cusp[1]*HARD.d), 1e-10)
assert len(named.points) > 20
for p in named.points:
    if p["parameter"] < cusp[1]*HARD.d*(1 - 1e-9):
        other = Pair(HARD.w, p["parameter"], HARD.a, HARD.f)
        assert min(abs(other.fold(1.3, side)*HARD.f/p["first"] - 1) for side in (1, -1)) < 1e-10
END
python "a torus of a scene" <<'END'
from result import *
torus = [e["parameter"] for name in ("alpha", "beyond") for e in json.load(open(name + ".json"))["events"]
         if e["kind"] == "torus"]
ends = [p["first"] for p in Locus("alpha-l").points if p["parameter"] == 0.085]
assert len(ends) == 2 and all(min(abs(x/t - 1) for t in torus) < 1e-8 for x in ends), (ends, torus)
END
python "a fold over two keys of a scene" <<'END'
from result import *
ends = [sorted(p["first"] for p in Locus(name).points if abs(p["parameter"]/last - 1) < 1e-12)
        for name, last in (("keys-l", 0.204), ("factor-l", 1.02))]
assert len(ends[0]) >= 1 and len(ends[0]) == len(ends[1]), ends
assert all(abs(a/b - 1) < 1e-9 for a, b in zip(*ends)), ends
END
try "the table" grep -q "^# Omega = 1.3$" plane.tsv
try "the picture" grep -q "cusp" plane.svg
refuses 1 "--Omega needs --and KEY=FROM:TO: give that" \
	locus hard.json --Omega 1.3
refuses 1 "--and does not go with --near: leave out one of them" \
	locus hard.json --and factor.damping=1:2 --Omega 1.3 --near 1
refuses 1 "--over and --and are both over factor.load: name two parameters" \
	locus hard.json --and factor.load=1:2 --Omega 1.3
python "tori, their angles, their resonances, which they pass on a circle, and the Chenciner point" <<'END'
from exact import *
from result import *
locus = Locus("soft-l")
for p in locus.points:
    N, nu = SOFT.hopf(p["Omega"])
    if p["Omega"] > 0.58: # the load stays nearly the same towards the end, 1:1
        angle = abs(math.remainder(2*math.pi*nu/p["Omega"], 2*math.pi))
        assert abs(angle - p["angle"]) < 1e-8 and abs(SOFT.torus(p["Omega"])/p["parameter"] - 1) < 1e-10
kappa = lambda O: SOFT.hopf(O)[1]/O
for kind, parts in {"1:4": (1/4, 3/4), "1:3": (1/3, 2/3), "1:2": (1/2,)}.items():
    found = locus.of(kind)
    assert len(found) == len(parts)
    for part, event in zip(parts, sorted(found)):
        O = root(lambda O: kappa(O) - part, 0.576, 1)
        near(event, (O, SOFT.torus(O)), 1e-10)
O = root(lambda O: SOFT.w**2 + O**2 + 2*SOFT.a*SOFT.hopf(O)[0], 0.55, 0.6)
near(locus.of("1:1")[0], (O, SOFT.torus(O)), 1e-8)
O = root(SOFT.lyapunov, 1.5, 2.8)
# one alone: beside 1:1 the sign of the coefficient was that of round-off, under some kernels
chenciner, = locus.of("chenciner")
near(chenciner, (O, SOFT.torus(O)), 1e-10)
END
python "where two bifurcations meet" <<'END'
from exact import *
from result import *
O = root(lambda O: SOFT.torus(O) - OTHER.fold(O, -1), 1.2, 1.6)
for name in ("both-f", "both-t"):
    near(Locus(name).of("fold-torus")[0], (O, SOFT.torus(O)), 1e-10)
O = root(lambda O: SOFT.torus(O) - THIRD.torus(O), 1.2, 1.4)
both = Locus("tori-l").of("torus-torus")
assert len(both) == 2
for event in both:
    near(event, (O, SOFT.torus(O)), 1e-10)
a, b = Locus("flip-f").of("fold-flip"), Locus("flip-p").of("fold-flip")
assert len(a) >= 1 and len(a) == len(b), (a, b)
for x, y in zip(sorted(a), sorted(b)):
    near(x, y, 1e-8)
    assert min(abs(FOURTH.fold(x[0], side)/x[1] - 1) for side in (1, -1)) < 1e-9
END
python "beyond a generalised period doubling the branch goes the other way" <<'END'
from result import *
event, = [e for e in Locus("tipped-l").of("generalised-period-doubling") if abs(e[0] - 1.7) < 0.01]
bends = []
for name in ("less", "more"):
    branch = json.load(open(name + ".json"))["branches"][0]
    bends.append(branch["points"][2]["Omega"] - branch["born"])
assert bends[0] < 0 < bends[1]
# the bend is proportional to the coefficient
assert abs(1.173 + 0.006*bends[0]/(bends[0] - bends[1]) - event[1]) < 3e-4, (bends, event)
END
done_testing

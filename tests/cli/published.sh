#!/bin/sh
# Printed bifurcations of forced systems by other programs.
#
# The periodic predator-prey model of Kuznetsov, Muratori and Rinaldi (Int. J. Bifurcation and Chaos 2 (1992) 117), an
# example of MATCONT and of BifurcationKit.jl: x' = r x (1 - x/K) - p x y, y' = e p x y - d y, p = a/(b + x), with
# b = b0 (1 + eps cos(2 pi t)). As a model of hawser w = 1/(b + x) is a third coordinate: w' = -w^2 (b' + x') - k (w (b + x) - 1),
# whose last term is zero on every periodic motion. The motions have two periods of the load.
#
# BifurcationKit's page "Periodic predator-prey model" prints, on a curve of folds in (eps, b0), a 1:1 resonance (both
# multipliers are 1): by shooting at eps = 0.60338213 (documentation of 0.3.0), by collocation at 0.56579871 (0.3.6) and
# 0.56581407 (0.4.13). Here it is at 0.603072: that by shooting is right to 5e-4; at 0.56581407 the other multiplier is
# 0.891. The product of the two is computed by a formula of Runge and Kutta of the original equations below.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >model.py <<'END'
import json, sys
r, a, d, k, eps = 6.28, 12.56, 6.28, 5.0, float(sys.argv[1])
json.dump({"hawser_rom": 1, "n": 3, "first_order": True, "parameters": {"b0": 0.18, "eps": eps},
           "K": [[-r, 0, 0], [0, d, 0], [0, 0, f"{k}*b0"]],
           "terms": [[0, [0, 0], [], r], [0, [0, 1, 2], [], a], [1, [0, 1, 2], [], -a], [2, [2, 0], [], k],
                     [2, [2, 2, 0], [], r], [2, [2, 2, 0, 0], [], -r], [2, [2, 2, 2, 0, 1], [], -a]],
           "harmonics": [{"k": 0, "f": [0, 0, k]},
                         {"k": 2, "phase": "cos", "K": [[0, 0, 0], [0, 0, 0], [0, 0, f"{k}*b0*eps"]]},
                         {"k": 2, "phase": "sin", "omega_power": 1, "terms": [[2, [2, 2], [], "-2*b0*eps"]]}]},
          open("prey.json", "w"))
END
begin() { # begin EPS START STATE
	python3 -S model.py "$1"
	echo "{\"state\": [$3]}" >start.json
	works "eps $1" frf prey.json --over b0="$2":0.174 --Omega 3.141592653589793 --start start.json --step 0.2 \
		--max-points 30 --json "fold-$1.json" -q
}
begin 0.603 0.179 "0.022116, 0.1903, 3.235692, -0.035225, -1.024042, 0.368791"
begin 0.6032 0.179 "0.022116, 0.1903, 3.235692, -0.035225, -1.024042, 0.368791"
[ -z "${HAWSER_LONG:-}" ] || begin 0.56581407 0.181 "0.023462, 0.196928, 3.258663, -0.04522, -1.047603, 0.480185"
python "the 1:1 resonance on a curve of folds: by shooting of another program to 5e-4, not by its collocation" <<'END'
import json, os
from math import cos, exp, log, pi
def closes(x, y, b0, eps, steps=2000):
    """The motion after two periods, and the logarithm of the product of its multipliers."""
    r, a, d = 6.28, 12.56, 6.28
    def f(t, s):
        b = b0*(1 + eps*cos(2*pi*t)); p = a*s[0]/(b + s[0])
        return (r*(1 - s[0])*s[0] - p*s[1], p*s[1] - d*s[1], r*(1 - 2*s[0]) - a*s[1]*b/(b + s[0])**2 + p - d)
    s, h = (x, y, 0.0), 1.0/steps
    add = lambda s, g, k: tuple(u + g*v for u, v in zip(s, k))
    for i in range(2*steps):
        t = i*h
        k1 = f(t, s); k2 = f(t + h/2, add(s, h/2, k1)); k3 = f(t + h/2, add(s, h/2, k2)); k4 = f(t + h, add(s, h, k3))
        s = tuple(u + h/6*(p + 2*q + 2*v + w) for u, p, q, v, w in zip(s, k1, k2, k3, k4))
    return s
product = {}
long = os.path.exists("fold-0.56581407.json")
for eps in (0.603, 0.6032) + (0.56581407,)*long:
    fold = [e for e in json.load(open(f"fold-{eps}.json"))["events"] if e["kind"] == "fold"][0]
    x, y = fold["state"][:2]
    end = closes(x, y, fold["parameter"], eps)
    assert abs(end[0] - x) < 1e-8 and abs(end[1] - y) < 1e-8, (eps, end)
    product[eps] = end[2]
at = 0.603 + 0.0002*product[0.603]/(product[0.603] - product[0.6032])
assert abs(at - 0.603072) < 2e-6, at
assert abs(at/0.60338213 - 1) < 6e-4, at
assert not long or abs(exp(product[0.56581407]) - 0.8911) < 1e-4, product
END

# Examples of SSMTool 2.4 (Jain, Li, Thurnher and Haller), events of the full systems as COCO finds and prints them, with five
# digits. Its nonlinear Mathieu equation x" + 0.1 x' + x - 0.1 x^3 = eps (x - 0.1 x^3) cos(Omega t): the branch points of rest
# and the fold of motions of two periods, at eps 0.21 and 0.22. Its reduced model of order 5 has them at 1.9651, 2.0299 and
# 1.7828 for eps 0.21: that is its truncation. Its self-excited oscillators with x2'^3: four folds.
for eps in ${HAWSER_LONG:+0.21} 0.22; do
	echo '{"n": 1, "K": [[1]], "D": [[0.1]], "terms": [[0, [0, 0, 0], [], -0.1]], "harmonics": [{"k": 1, "phase": "cos",
 "K": [[-EPS]], "terms": [[0, [0, 0, 0], [], 0.1EPS]]}]}' | sed "s/0.1EPS/0.0${eps#0.}/; s/EPS/$eps/" >mathieu.json
	works "a nonlinear Mathieu equation" frf mathieu.json --from 2.5967 --to 1.598 --json mathieu-$eps.json -q
	label=$(python3 -S -c "import json
print([e['label'] for e in json.load(open('mathieu-$eps.json'))['branches'][0]['events'] if e['kind'] == 'fold'][0])")
	works "the motion at its fold" orbit mathieu.json --from-label mathieu-$eps.json#$label --json fold-$eps.json -q
done
cat >self.json <<'END'
{"n": 2, "K": [[5, -4], [-2, 2]], "D": [[0, 0], [0, -0.01]],
 "terms": [[0, [0, 0, 0], [], 0.1], [1, [], [1, 1, 1], 0.05]],
 "harmonics": [{"k": 1, "phase": "cos", "f": [0.02, 0]}, {"k": 2, "phase": "cos", "K": [[-0.08, 0.08], [0.04, -0.04]]}]}
END
works "self-excited oscillators" frf self.json --unstable 9 --from 2.4593 --to 2.7002 --json self-frf.json -q
python "to the printed digits" <<'END'
import json, os
for eps, points, fold, size in (("0.21", (2.0282, 1.9641), 1.8013, 1.5612), ("0.22", (2.0418, 1.9502), 1.6200, 2.1110)):
    if not os.path.exists(f"mathieu-{eps}.json"):
        continue
    result = json.load(open(f"mathieu-{eps}.json"))
    assert [e["kind"] for e in result["events"]] == 2*["period-doubling"] and len(result["branches"]) == 1
    for e, printed in zip(result["events"], points):
        assert abs(e["Omega"] - printed) < 6e-5, (e["Omega"], printed)
    branch = result["branches"][0]
    assert branch["end"] == "at rest" and [e["kind"] for e in branch["events"]] == ["fold", "branch-point"]
    assert abs(branch["events"][0]["Omega"] - fold) < 6e-5 and abs(branch["events"][1]["Omega"] - points[1]) < 6e-5
    most = max(abs(row[0]) for row in json.load(open(f"fold-{eps}.json"))["states"])
    assert abs(most/size - 1) < 1e-3, most
folds = [e["Omega"] for e in json.load(open("self-frf.json"))["events"] if e["kind"] == "fold"]
assert len(folds) == 4 and all(abs(f - p) < 6e-5 for f, p in zip(folds, (2.6173, 2.5856, 2.6129, 2.6014))), folds
END
done_testing

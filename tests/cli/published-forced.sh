#!/bin/sh
# Bifurcations of forced and parametrically excited oscillators that the examples of SSMTool 2.4 (Jain, Li, Thurnher and
# Haller) print. Those of the full systems are computed there by COCO (collocation) and printed with five digits: here every
# digit agrees. Those of reduced models of third order are approximations: there, the difference must be that of a
# truncation, which vanishes with the load. HAWSER_LONG=1 for all but two responses.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scenes=$top/notebooks-data/scenes
duffing=$scenes/parametric-duffing.json
: >table
# response NAME "PRINTED EVENTS" frf ARGUMENTS...: fold 1.0 torus 2.0 ... in the order of the curve
response() {
	name=$1
	echo "$1 $2" >>table
	shift 2
	works "$name" frf "$@" --json "$name.json" -q
}

# Szabelski and Warminski's coupled oscillators (J. Sound and Vibration 187 (1995) 595), self-excited, damped by
# velocities cubed, modulated in their linear and cubic coupling.
response duffing-0.5 "torus 1.7330 fold 1.8810 fold 1.7695 fold 1.9474 fold 1.8539" "$duffing" --from 1.3851 --to 2.2507
# Li and Shaw's parametric amplifiers (Nonlinear Dynamics 102 (2020) 2433), two of them, with velocities cubed
response amplifier-0.15 "fold 1.1023 fold 1.0291 fold 1.1215 fold 1.0980" "$scenes/parametric-amplifier.json" --from 0.9 --to 1.2
if [ -n "${HAWSER_LONG:-}" ]; then
	for method in shooting balance; do
		response "duffing-0.8-$method" "torus 1.7038 fold 1.9187 fold 1.7375 fold 2.0081 fold 1.9149" "$duffing" \
			--set eps=0.8 --from 1.3851 --to 2.2507 --method $method
		response "amplifier-0.05-$method" "fold 1.0814 fold 1.0797" "$scenes/parametric-amplifier.json" --set mu=0.05 \
			--from 0.9 --to 1.2 --method $method
		response "amplifier-0.08-$method" "fold 1.0626 fold 1.0498 fold 1.0891 fold 1.0843" \
			"$scenes/parametric-amplifier.json" --set mu=0.083333333333333333 --from 0.9 --to 1.2 --method $method
		response "amplifier-0.12-$method" "fold 1.0807 fold 1.0389 fold 1.1035 fold 1.0908" \
			"$scenes/parametric-amplifier.json" --set mu=0.11666666666666667 --from 0.9 --to 1.2 --method $method
	done
	# the isola at eps 0.2: a motion of eps 0.5 is followed there
	label=$(python3 -S -c "import json
print(max((p['label'] for p in json.load(open('duffing-0.5.json'))['points'] if p.get('label') and
           p['coordinates'][0] > 2.8 and p['Omega'] < 1.85 and p['coordinates'][1] > 2.9)))")
	works "towards the isola" frf "$duffing" --from-label "duffing-0.5.json#$label" --over eps=0.5:0.2 --json over.json -q
	label=$(python3 -S -c "import json; print(json.load(open('over.json'))['points'][-1]['label'])")
	response isola "fold 1.8801 fold 1.7660 torus 1.7706 fold 1.8472 fold 1.8038" "$duffing" --from-label "over.json#$label" \
		--set eps=0.2 --from 1.3851 --to 2.2507
	python3 -S - <<'END'
import json
from math import pi
# Coupled Mathieu equations, eps 0.265 and 0.275
def write(name, **model):
    json.dump(dict(hawser_rom=1, n=len(model["K"]), **model), open(name, "w"))
def cube(j, c, a, b): # c (x_a - x_b)^3 in equation j
    return [[j, a, a, a, c], [j, a, a, b, -3*c], [j, a, b, b, 3*c], [j, b, b, b, -c]]
for eps in (0.265, 0.275):
    write(f"mathieu-{eps}.in", K=[[2, -1], [-1, 2]], D=[[0.1, -0.05], [-0.05, 0.1]],
          C=[[0, 0, 0, 0, 0.1], [1, 1, 1, 1, 0.1]] + cube(0, 0.1, 0, 1) + cube(1, 0.1, 1, 0),
          harmonics=[{"k": 1, "K": [[eps, -eps], [-eps, eps]]}])
# Three oscillators of one frequency
write("three.in", K=[[1, 0, 0], [0, 1, 0], [0, 0, 1]], D=[[5e-4, 0, 0], [0, 1e-3, 0], [0, 0, 1.5e-3]],
      C=cube(0, 1e-3, 0, 1) + cube(1, 1e-3, 1, 0) + cube(1, 1e-3, 1, 2) + cube(2, 1e-3, 2, 1),
      harmonics=[{"k": 1, "f": [5e-3, 0, 0]}])
# An axially moving beam of ten modes: with the viscous part of the stretching, u_j v_j u_i, and without
EI, P, EA, mass, eta, g = 30e9*0.04*0.03**3/12, 67.5e3, 30e9*0.04*0.03, 7680*0.04*0.03, 1e-4, 0.5128
kf2, k12, alpha, n = EI/P, EA/P, eta*EI/(mass*P)**0.5, range(1, 11)
for name in ("beam", "beam-viscous"):
    write(name + ".in", K=[[kf2*(i*pi)**4 - (g*g - 1)*(i*pi)**2 if i == j else 0 for j in n] for i in n],
          D=[[alpha*(i*pi)**4 if i == j else 4*g*i*j/(i*i - j*j)*(1 - (-1)**(i + j)) for j in n] for i in n],
          C=[[i - 1, j - 1, j - 1, i - 1, 0.25*k12*pi**4*i*i*j*j] for i in n for j in n],
          terms=[[i - 1, [j - 1, i - 1], [j - 1], 0.5*alpha*k12/kf2*pi**4*i*i*j*j] for i in n for j in n
                 if name == "beam-viscous"],
          harmonics=[{"k": 1, "omega_power": 2, "f": [1.5e-4*(1 - (-1)**i)/(i*pi) for i in n]}])
# Two oscillators, 1:2
for eps in (1e-3, 3e-3, 5e-3, 7e-3):
    write(f"pair-{eps}.in", K=[[1, 0], [0, 4]], D=[[5e-3, 0], [0, 1e-2]], Q=[[0, 0, 1, 1], [1, 0, 0, 1]],
          harmonics=[{"k": 1, "f": [eps, 0]}])
END
	response mathieu-0.265 "period-doubling 3.4290 period-doubling 3.4894" mathieu-0.265.in --from 3.35 --to 4.1
	response mathieu-0.275 "period-doubling 3.4070 period-doubling 3.5111" mathieu-0.275.in --from 3.35 --to 4.1
	response beam "fold 3.2822 fold 3.2482" beam.in --from 3.1315 --to 3.3232 --method balance
	response beam-viscous "fold 3.2720 fold 3.2480" beam-viscous.in --from 3.1315 --to 3.3232 --method balance
	works "three oscillators" frf three.in --from 0.995 --to 1.016 --json three.json -q
	for eps in 0.001 0.003 0.005 0.007; do
		works "two oscillators" frf pair-$eps.in --from 0.7 --to 1.1 --json pair-$eps.json -q
	done
fi
cat >check.py <<'END'
import json, os
def events(name, key="events"):
    return [(e["kind"], e["Omega"]) for e in json.load(open(name + ".json"))[key]]
def same(found, printed):
    assert [k for k, _ in found] == [k for k, _ in printed], (found, printed)
    return max(abs(a - b) for (_, a), (_, b) in zip(found, printed))
count = 0
for line in open("table"):
    name, *rest = line.split()
    printed = list(zip(rest[::2], map(float, rest[1::2])))
    assert same(events(name), printed) < 5.1e-5, (name, events(name), printed)
    count += len(printed)
assert count >= 9
if os.path.exists("three.json"):
    for eps, fold in (("0.265", 3.5452), ("0.275", 3.7029)):
        branch, = json.load(open(f"mathieu-{eps}.json"))["branches"]
        assert abs(branch["events"][0]["Omega"] - fold) < 5.1e-5, branch["events"]
    # the full system's two folds; of the reduced model also those at small amplitude, to their digits; the torus and
    # the fold at the largest amplitude are its truncation
    found = [w for _, w in events("three")]
    assert same(events("three"), [("fold", 1.0025), ("fold", 1.0018), ("torus", 1.0021), ("torus", found[3]),
                                  ("fold", 1.0150), ("fold", 1.0031)]) < 5.1e-5, found
    assert abs(found[3] - 1.0150) < 5e-4
    reduced = {"0.001": (0.98772, 0.98600, 0.99801, 1.0018, 1.0126, 1.0118),
               "0.003": (0.97768, 0.95395, 0.99432, 1.0050, 1.0317, 1.0211),
               "0.005": (0.97078, 0.91154, 0.99205, 1.0067, 1.0472, 1.0272),
               "0.007": (0.96512, 0.85580, 0.99021, 1.0080, 1.0596, 1.0320)}
    kinds = ["fold", "fold", "torus", "torus", "fold", "fold"]
    for eps, printed in reduced.items():
        found = events("pair-" + eps)
        assert [k for k, _ in found] == kinds, found
        gap = [abs(w - p) for (_, w), p in zip(found, printed)]
        # tori and the folds of small motions; the folds of large ones have four times the amplitude
        assert max(gap[2], gap[3]) < 5e-5 + 0.012*float(eps), (eps, gap)
        assert max(gap[0], gap[5]) < 5e-5 + 0.045*float(eps), (eps, gap)
END
python "every printed digit" <check.py
done_testing

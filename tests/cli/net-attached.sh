#!/bin/sh
# Springs, dampers and absorbers at nodes of nets. SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# A mass between two strings without mass: with an absorber it has two degrees of freedom.
cat >two.yaml <<'END'
kind: net
g: 0
nodes: {A: [0, 0, 0], J: {}, B: [80, 0, 0]}
cables:
  - {name: c1, from: A, to: J, EA: 1 MN, rho: 0, length0: 39.2 m, elements: 1}
  - {name: c2, from: J, to: B, EA: 1 MN, rho: 0, length0: 39.2 m, elements: 1}
supports: {A: fixed, B: fixed}
masses: {J: 23.85 kg}
springs: {J: [0, 70 N/m, 0]}
dampers: {J: [0, 1.7 N.s/m, 0]}
absorbers:
  - {name: tmd, at: J, mass: 3.1 kg, stiffness: 124 N/m, damping: 7.3 N.s/m}
loads: {J: {force: [0, 0.2, 0], harmonic: {multiple: 1}}}
END
# The stay of the manual page, in two parts, and as a span.
cat >net.yaml <<'END'
kind: net
nodes: {A: [0, 0, 0], J: {}, B: [80, 35, 0]}
cables:
  - {name: c1, from: A, to: J, EA: 150 MN, rho: 12, length0: 30.1 m, elements: 32}
  - {name: c2, from: J, to: B, EA: 150 MN, rho: 12, length0: 56.87 m, elements: 64}
supports: {A: fixed, B: fixed}
springs: {J: [0, 300 N/m, 500 N/m]}
absorbers: [{at: J, mass: 40 kg, frequency: 7.745966692414834 rad/s, direction: [0.3, 1, 0]}]
END
cat >span.yaml <<'END'
cable: {EA: 150 MN, rho: 12}
span: {d: 80, h: 35}
tension: {length0: 86.97}
attach:
  - {at: 30.1 m, absorber_mass: 40 kg, absorber_stiffness: 2400, absorber_direction: [0.3, 1, 0], spring: [0, 300, 500]}
END
works "a response with an absorber" frf two.yaml -n 3 --from 5.5 --to 8 --json two.json -q
for step in 4 2; do
	works "its motion by $step ms" integrate two.yaml --until 3 --every 1 --step ${step}ms --probe J --set loads.J.harmonic.Omega=6.4 \
		--json motion$step.json -q
done
works "modes of a net with an absorber" rom net.yaml -n 8 --json net.json -q
works "  and of a span" modes span.yaml -n 8 --json span.json -q
python "absorbers, springs and dampers" <<'END'
import json, cmath
M, m, c, k, C, F = 23.85, 3.1, 7.3, 124.0, 1.7, 0.2
K = 2*1e6*(40/39.2 - 1)/40 + 70 # T/l of both strings, and the spring
def amplitude(w):
    own = -w*w*m*(k + 1j*w*c)/(k - w*w*m + 1j*w*c)
    return abs(F/(K - w*w*M + 1j*w*C + own))
def peak(low, high): # of a unimodal function
    for _ in range(200):
        a, b = low + (high - low)/3, high - (high - low)/3
        low, high = (a, high) if amplitude(a) < amplitude(b) else (low, b)
    return low
certified = json.load(open("two.json"))["certified"]
mesh = [l for l in certified["landmarks"] if l.get("probe") == "J" and l["component"] == "y"]
assert len(mesh) == 2 and certified["refused"] == 0, certified
for l in mesh:
    w = peak(l["Omega_mesh"] - 0.1, l["Omega_mesh"] + 0.1)
    assert abs(l["Omega_mesh"]/w - 1) < 1e-5 and abs(l["size_mesh"]/amplitude(w) - 1) < 1e-5, (l, w, amplitude(w))
w, steps = 6.4, 2000
def rate(t, y):
    u, s, v, r = y
    pull = k*s + c*r
    a = (F*cmath.cos(w*t).real - K*u - C*v + pull)/M
    return [v, r, a, -pull/m - a]
y, h = [0.0]*4, 3/steps
for i in range(steps):
    a = rate(i*h, y)
    b = rate(i*h + h/2, [p + h/2*q for p, q in zip(y, a)])
    d = rate(i*h + h/2, [p + h/2*q for p, q in zip(y, b)])
    e = rate(i*h + h, [p + h*q for p, q in zip(y, d)])
    y = [p + h/6*(q1 + 2*q2 + 2*q3 + q4) for p, q1, q2, q3, q4 in zip(y, a, b, d, e)]
far, near = (json.load(open(f"motion{step}.json")) for step in (4, 2))
both = [run["probes"]["J"]["x"][-1][1] for run in (far, near)]
assert abs((4*both[1] - both[0])/3/y[0] - 1) < 1e-6, (both, y) # steps of second order
assert near["energy"]["closure"] < 1e-7*near["energy"]["work"][-1], near["energy"]
rom = json.load(open("net.json"))
omega = sorted(rom["K"][i][i]**0.5/rom["scale"]["time"] for i in range(8))
span = [q["omega"] for q in json.load(open("span.json"))["modes"]]
assert max(abs(a/b - 1) for a, b in zip(omega[:3], span)) < 2e-8, (omega, span)
END
# A carrier as a pendulum beside a mass on the rope, by its key, and as a node on a short stiff cable.
sed '/^springs/,$d' net.yaml >bare.yaml
{ cat bare.yaml; echo 'masses: {J: {mass: 320 kg, hanger: 1.7 m}}'; } >hangs.yaml
sed 's/J: {}/J: {}, M: {}/; s/^supports/  - {name: h, from: J, to: M, EA: 4 GN, rho: 0, length0: 1.7 m, elements: 1}\n&/' bare.yaml >cable.yaml
echo 'masses: {M: 320 kg}' >>cable.yaml
works "a pendulum" modes hangs.yaml -n 6 --json hangs.json -q
works "  on a cable" modes cable.yaml -n 6 --json cable.json -q
works "  between strings" modes two.yaml -n 2 --set g=9.81 --set "masses={J: {mass: 11 kg, hanger: 2.385 m}}" --json strings.json -q \
	--set absorbers= --set springs= --set dampers=
python "is one" <<'END'
import json
key, cable = ([q["omega"] for q in json.load(open(n + ".json"))["modes"]] for n in ("hangs", "cable"))
assert max(abs(a/b - 1) for a, b in zip(key, cable)) < 1e-6, (key, cable)
# a rope's point without mass: the springs 2 T/l and m g/L behind each other; T by bisection on the sag
low, high = 0.0, 10.0
for _ in range(100):
    sag = (low + high)/2
    l = (40**2 + sag**2)**0.5
    T = 1e6*(l/39.2 - 1)
    low, high = (sag, high) if 2*T*sag/l < 11*9.81 else (low, sag)
aside = (1/(1/(2*T/l) + 1/(11*9.81/2.385))/11)**0.5
omega = json.load(open("strings.json"))["modes"][0]["omega"]
assert abs(omega/aside - 1) < 1e-6, (omega, aside)
END
# The same stay as a span and as a net, each corrected in a mesh of its own.
sed '/^attach/,$d' span.yaml >both.yaml
cat >>both.yaml <<'END'
attach:
  - {name: tmd, at: 30.1 m, absorber_mass: 30 kg, absorber_stiffness: 1900, absorber_damping: 40, absorber_direction: [0, 0, 1],
     spring: [0, 300, 500], damper: [0, 20, 30]}
damping: {alpha: 0.4}
loads: [{per_length: [0, 0, 1.5], from: 30.1 m}]
END
sed '/^springs/,$d' net.yaml >parts.yaml
cat >>parts.yaml <<'END'
springs: {J: [0, 300, 500]}
dampers: {J: [0, 20, 30]}
absorbers: [{name: tmd, at: J, mass: 30 kg, stiffness: 1900, damping: 40, direction: [0, 0, 1]}]
damping: {alpha: 0.4}
loads: {c2: {per_length: [0, 0, 1.5], harmonic: {multiple: 1}}}
END
works "a span with attachments in its mesh" frf both.yaml -n 4 --from 6.9 --to 9.4 --certificate yes --json both.json -q
works "  and as a net" frf parts.yaml -n 4 --from 6.9 --to 9.4 --json parts.json -q
python "agree" <<'END'
import json
both, parts = (json.load(open(n + ".json"))["certified"] for n in ("both", "parts"))
stroke = lambda r: [(l["Omega_mesh"], l["size_mesh"]) for l in r["landmarks"] if l.get("probe") == "stroke_tmd"]
assert both["refused"] == parts["refused"] == 0 and stroke(both), both
for a, b in zip(stroke(both), stroke(parts)):
    assert abs(a[0]/b[0] - 1) < 5e-6 and abs(a[1]/b[1] - 1) < 5e-5, (a, b)
END
# Damping ratios are those of the modes whose absorbers are held: in the mesh as with the exact energy.
rated='--set damping.ratio=0.004 --from 6.9 --to 9.4'
works "ratios in the mesh" frf both.yaml -n 4 $rated --certificate yes --json mesh.json -q
works "  and with the exact energy" frf both.yaml $rated --set model.energy=exact --set model.basis=14 --json exact.json -q
python "agree" <<'END'
import json
mesh, exact = json.load(open("mesh.json"))["certified"], json.load(open("exact.json"))["peaks"]
found = [l for l in mesh["landmarks"] if l["kind"] == "peak"]
assert mesh["refused"] == 0 and any(l["probe"] == "stroke_tmd" for l in found), mesh
for l in found:
    top = min((p for p in exact if (p["probe"], p["component"]) == (l["probe"], l["component"])),
              key=lambda p: abs(p["Omega"] - l["Omega_mesh"]))
    assert abs(l["Omega_mesh"]/top["Omega"] - 1) < 1e-4 and abs(l["size_mesh"]/top["size"] - 1) < 2e-4, (l, top)
END
denies "a pendulum without weight" 1 "g is 0, and a mass on a hanger is a pendulum by its weight" check hangs.yaml --set g=0
denies "with a name that is taken" 1 "its hanger makes the node J_load and the cable J_hanger, whose names are taken" check hangs.yaml \
	--set cables.c1.name=J_hanger
denies "an absorber without a spring" 1 "absorbers\[0\] needs stiffness or frequency, and not both" check net.yaml \
	--set 'absorbers=[{at: J, mass: 3}]'
denies "without a direction" 1 "absorbers\[0\].direction has no length" check net.yaml --set 'absorbers[0].direction=[0, 0, 0]'
denies "at no node" 1 "absorbers\[0\]: there is no node Q" check net.yaml --set 'absorbers[0].at=Q'
denies "beside obstacles" 1 "obstacles contradict absorbers and springs" check net.yaml \
	--set 'obstacles=[{plane: {point: [0, -100, 0], normal: [0, 1, 0]}}]'
denies "a damper that drives" 1 "out of range: it must be >= 0, in N.s/m" check two.yaml --set "dampers={J: [0, -1, 0]}"
denies "a scheme that has none" 1 "the scheme cvode does not know springs, dampers and absorbers of nodes" integrate two.yaml \
	--method cvode --until 1 --every 1 --set loads.J.harmonic.Omega=6.4
done_testing

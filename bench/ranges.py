#!/usr/bin/env python3
# bench/ranges.py HAWSER [DAMPING] ("ratio: 0.8 %"): what is off at the range of a reduced model?
#
# Seven cables, their first motion out of the plane, loads for which the peak of 5 modes lies at 0.9 and 1.5 times the
# range that `hawser rom` states: that peak and its frequency against the exact energy on 10 functions a component. With
# DAMPING "alpha" the same rate as 0.8 % of the first mode of a string, from the mass alone.
# SPDX-License-Identifier: GPL-3.0-or-later
import json
import math
import os
import re
import subprocess
import sys
import tempfile

hawser = os.path.abspath(sys.argv[1])
damping = sys.argv[2] if len(sys.argv) > 2 else "ratio: 0.8 %"
# d, h in m, sag/span, EA/H, kg/m
CABLES = ((104, 2.5, 0.079, 6100, 28), (300, 0, 0.03, 2000, 1.5), (200, 120, 0.06, 3000, 40), (80, 0, 0.12, 8000, 20),
          (300, 20, 0.15, 5000, 2), (150, 150, 0.1, 4000, 10), (400, 0, 0.05, 1000, 1))
folder = tempfile.mkdtemp()
scene, answer = (os.path.join(folder, name) for name in ("scene.yaml", "answer.json"))


def peak(load, *keys):
    """Largest height and its frequency of z at mid-span, or None."""
    run = subprocess.run([hawser, "frf", scene, "-q", "--json", answer, "--from", "0.93w1", "--to", "1.09w1", "--certificate",
                          "no", "--unstable", "9", "--set", f"load.per_length=[0, 0, {load}]", *keys],
                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    if run.returncode:
        return None
    with open(answer, encoding="utf-8") as stream:
        found = [p for p in json.load(stream)["peaks"] if p["component"] == "z" and p["probe"] == "mid"]
    return max(((p["size"], p["Omega"]) for p in found), default=None)


def peak_at(height, load):
    """The peak of the modes whose height is within 3 % of this, and its load."""
    for _ in range(5):
        own = peak(load, "-n", "5", "--set", "model.energy=quartic")
        if not own or abs(own[0]/height - 1.0) < 0.03:
            return own, load
        load *= min(max(height/own[0], 0.2), 5.0)
    return None, load


for d, h, sag, stiff, rho in CABLES:
    H = rho*9.81*math.hypot(d, h)/(8.0*sag)
    rate = f"alpha: {0.016*math.pi/d*math.sqrt(H/rho):.6g}" if damping == "alpha" else damping
    with open(scene, "w", encoding="utf-8") as stream:
        stream.write(f"cable: {{EA: {H*stiff:.6g}, rho: {rho}}}\nspan: {{d: {d}, h: {h}}}\ntension: {{H: {H:.6g}}}\n"
                     f"damping: {{{rate}}}\nload: {{frame: local, per_length: [0, 0, 1]}}\n")
    told = subprocess.run([hawser, "rom", scene, "-n", "5"], capture_output=True, text=True, check=True).stdout
    reach = float(re.search(r"\(out-of-plane 1\): (\S+) m", told).group(1))
    for part in (0.9, 1.5):
        own, load = peak_at(part*reach, 0.01*rho)
        exact = own and peak(load, "--set", "model.energy=exact", "--set", "model.basis=10")
        print(f"sag/span {sag:5g}  {part} of {reach:.3g} m: " + (
            f"height {own[0]/exact[0] - 1.0:8.1e}, frequency {own[1]/exact[1] - 1.0:8.1e}" if exact else "no peak"), flush=True)

#!/usr/bin/env python3
"""Floquet multipliers of ropeways by harmonic balance and by shooting, which share no code beyond the model: shipped scenes and random
ones, carriers that pass and a rope moved by its drive. The forces of Coriolis of a running rope are in both.

    bench/ropeway-multipliers.py HAWSER [RANDOM [SEED [SCENE ...]]]
"""
import cmath
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

CLOSE = 1e-8
SCENES = Path(__file__).resolve().parent.parent/"notebooks-data/scenes"
PLACES = (("0.7w1", "w1"), ("0.9995w3", "1.1w3"))
LOADS = (["--load", "passing"], ["--load", "drive", "--ripple", "0.01"])


def line(chance):
    """A line of one to four towers on a slope with some curvature, running at up to 7 m/s."""
    towers = chance.randint(1, 4)
    x = [0.0]
    for _ in range(towers + 1):
        x.append(x[-1] + chance.uniform(40.0, 160.0))
    slope, bend = chance.uniform(0.05, 0.5), chance.uniform(0.02, 0.1)
    at = [[s, slope*s + bend*4.0*s*(x[-1] - s)/x[-1]] for s in x]
    rho = chance.uniform(3.0, 9.0)
    spacing = chance.uniform(25.0, 70.0)
    mass = chance.uniform(100.0, 700.0)
    tension = 9.81*(rho + mass/spacing)*x[-1]/(towers + 1)*chance.uniform(2.0, 6.0)
    rows = "".join(f"    - {{at: [{a:.4f}, {b:.4f}], radius: {chance.uniform(4.0, 25.0):.3f}}}\n" for a, b in at[1:-1])
    return (f"ropeway:\n  rope: {{EA: {tension*chance.uniform(150.0, 900.0):.6g}, rho: {rho:.4f}}}\n"
            f"  bottom: {{at: [0, 0], radius: 2, tension: {{counterweight: {2.0*tension:.6g}}}}}\n"
            f"  top: {{at: [{at[-1][0]:.4f}, {at[-1][1]:.4f}], radius: 2, drive: {{speed: {chance.uniform(0.0, 7.0):.3f}}}}}\n"
            f"  towers:\n{rows}"
            f"  carriers: {{spacing: {spacing:.4f}, mass: {mass:.2f}, phase: {chance.uniform(0.0, spacing):.4f}}}\n")


def multipliers(program, model, method, place):
    answer = subprocess.run([program, "frf", model, "--method", method, "--from", place[0], "--to", place[1], "--step", "1e-6",
                             "--max-points", "2", "--tolerance", "1e-11", "--multipliers", "--json", "-", "-q"],
                            capture_output=True, text=True, check=False)
    if answer.returncode:
        raise ValueError(answer.stderr.strip())
    point = json.loads(answer.stdout)["points"][0]
    return [cmath.rect(math.exp(m["log_modulus"]), m["argument"]) for m in point["multipliers"]]


def farthest(first, second):
    """Largest distance of a multiplier of the first set from its partner in the second."""
    most, rest = 0.0, list(second)
    for z in first:
        near = min(rest, key=lambda other: abs(other - z))
        rest.remove(near)
        most = max(most, abs(near - z))
    return most


def compare(program, scene, options, model):
    made = subprocess.run([program, "rom", scene, *options, "--damping", "0.02", "--json", model, "-q"], capture_output=True, text=True,
                          check=False)
    if made.returncode:
        return made.stderr.strip()
    return max(farthest(*(multipliers(program, model, method, place) for method in ("balance", "shooting"))) for place in PLACES)


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    chance = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    named = sys.argv[4:] or sorted(str(p) for p in [*SCENES.glob("ropeway-*.yaml"), *SCENES.glob("b-table-6*.yaml")]
                                   if p.name != "ropeway-carriers.yaml")
    broken = 0
    with tempfile.TemporaryDirectory() as folder:
        model = str(Path(folder)/"model.json")
        drawn = []
        for i in range(count):
            drawn.append(str(Path(folder)/f"random-{i}.yaml"))
            Path(drawn[-1]).write_text(line(chance), encoding="utf-8")
        for scene in named + drawn:
            for load in LOADS:
                # Without second-order shapes: the steps of shooting are those of the orbit, which the multipliers of the fastest shapes
                # have a larger error with, as the Liouville gap of its points says; balance takes steps for them.
                options = [*load, "-n", str(chance.randint(13, 16))]
                if "random" in scene:
                    options += ["--contact", chance.choice(["slip", "stick"])]
                most = compare(program, scene, options, model)
                broken |= not isinstance(most, str) and most > CLOSE
                print(f"{Path(scene).name} {' '.join(options)}: {most if isinstance(most, str) else f'{most:.1e}'}", flush=True)
    return broken


if __name__ == "__main__":
    sys.exit(main())

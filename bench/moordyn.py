#!/usr/bin/env python3
"""Three mooring lines whose fairleads move as in a storm, by hawser and by MoorDyn: error and processor time.

    bench/moordyn.py build/.libs/hawser libmoordyn.so [SECONDS]     (LD_LIBRARY_PATH=$PWD/build/.libs)
    bench/moordyn.py build/.libs/hawser libmoordyn.so layouts

Chains of 880 m in 200 m of water, 24 to 80 elements each, on the bed; no waves at the lines themselves. The fairleads have the surge and
heave of a JONSWAP sea of 5 m and 11 s (40 components), which MoorDyn is given at each of its steps, and hawser as a table. The reference is
hawser with 160 elements and short steps, over the first 60 s. Errors are those of the fairlead tensions after 20 s, without their
mean, over their standard deviation. Processor times are those of the
steps alone: of hawser, the difference to a run of one step. Without MoorDyn nothing is done.

`layouts`: other lines whose upper end moves in that way, from 180 to 240 s. Of each program the difference of the tension there between a mesh and
twice as many elements, and the difference of both programs on the finer ones, over the standard deviation. MoorDyn's tension is that of the last
element, without the inertia and the drag of its upper half; so the last difference is to hawser's in the middle of that element.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import ctypes
import json
import math
import os
import random
import resource
import subprocess
import sys
import tempfile
import time

ANGLES = (math.pi/3, math.pi, -math.pi/3)
ANCHORS = [(837.6*math.cos(a), 837.6*math.sin(a)) for a in ANGLES]
FAIRLEADS = [(5.2*math.cos(a), 5.2*math.sin(a)) for a in ANGLES]
EVERY = 0.25  # s, between rows
SETTLED = 180  # s: until then MoorDyn comes to rest, which it does not begin at: of a lazy wave, 1 % is left after 60 s


def sea():
    """(amplitude, frequency, phase) of the surge."""
    draw, peak, found = random.Random(3), 2*math.pi/11, []
    for i in range(40):
        w = peak*(0.5 + 2.0*(i + draw.random())/40)
        s = 0.07 if w < peak else 0.09
        density = w**-5*math.exp(-1.25*(peak/w)**4)*3.3**math.exp(-((w - peak)/(s*peak))**2/2)
        found.append((density, w, draw.random()*2*math.pi))
    whole = sum(one[0] for one in found)
    return [(math.sqrt(2*one[0]/whole)*5/4, one[1], one[2]) for one in found]


SEA = sea()


def motion(t):
    """Surge and heave (m) and their rates."""
    q = min(t/20, 1.0)
    p, rate = q**3*(10 - 15*q + 6*q*q), 30*(q*(1 - q))**2/20
    s = sum(a*math.cos(w*t + f) for a, w, f in SEA)
    c = sum(a*math.sin(w*t + f) for a, w, f in SEA)
    ds = -sum(a*w*math.sin(w*t + f) for a, w, f in SEA)
    dc = sum(a*w*math.cos(w*t + f) for a, w, f in SEA)
    return p*s, 0.7*p*c, p*ds + rate*s, 0.7*(p*dc + rate*c)


# Types of lines (diameter, mass, EA, damping, EI, drag and added mass, normal and tangential), points (kind, place, mass, volume, CdA,
# Ca) and lines (type, ends, length, elements); the last point moves.
LAYOUTS = {
    "clump weight": (200, ["chain 0.0766 113.35 753.6e6 -0.5 0 2 1 0.4 0"],
                     [("Fixed", 800, 0, -200, 0, 0, 0, 0), ("Free", 200, 0, -160, 8000, 2, 3, 0.5), ("Coupled", 0, 0, -14, 0, 0, 0, 0)],
                     [("chain", 1, 2, 610, 30), ("chain", 2, 3, 265, 14)]),
    "taut polyester": (1000, ["rope 0.16 22 60e6 -0.5 0 1.2 1 0.02 0"],
                       [("Fixed", 1000, 0, -1000, 0, 0, 0, 0), ("Coupled", 0, 0, -20, 0, 0, 0, 0)], [("rope", 1, 2, 1375, 40)]),
    "lazy wave": (150, ["riser 0.25 80 300e6 -0.5 0 1.1 1 0.02 0", "float 0.6 190 300e6 -0.5 0 1.1 1 0.02 0"],
                  [("Fixed", 170, 0, -120, 0, 0, 0, 0), ("Free", 130, 0, -80, 0, 0, 0, 0), ("Free", 85, 0, -70, 0, 0, 0, 0),
                   ("Coupled", 0, 0, -10, 0, 0, 0, 0)], [("riser", 1, 2, 70, 16), ("float", 2, 3, 60, 14), ("riser", 3, 4, 130, 28)]),
    "buoy on the line": (300, ["chain 0.08 120 500e6 -0.5 0 2 1 0.4 0", "wire 0.06 15 150e6 -0.5 0 1.2 1 0.02 0"],
                         [("Fixed", 700, 0, -300, 0, 0, 0, 0), ("Free", 150, 0, -90, 2000, 12, 5, 0.5),
                          ("Coupled", 0, 0, -15, 0, 0, 0, 0)], [("chain", 1, 2, 610, 36), ("wire", 2, 3, 172, 12)])}


STORM = (200, ["chain 0.0766 113.35 753.6e6 -0.5 0 2 1 0.4 0"], [("Fixed", x, y, -200, 0, 0, 0, 0) for x, y in ANCHORS] +
         [("Coupled", x, y, -14, 0, 0, 0, 0) for x, y in FAIRLEADS], [("chain", i, i + 3, 880, 1) for i in (1, 2, 3)])


def write(layout, finer, step, scheme="RK2"):
    """The file of MoorDyn, which hawser init --from reads too; lines with so many times their elements."""
    depth, types, points, lines = layout
    rows = ["Storm", "--- LINE TYPES ---", "names", "units"] + types + ["--- POINTS ---", "names", "units"]
    rows += ["%d %s %.9g %.9g %.9g %g %g %g %g" % ((i + 1,) + one) for i, one in enumerate(points)]
    rows += ["--- LINES ---", "names", "units"]
    rows += ["%d %s %d %d %g %d -" % (i + 1, one[0], one[1], one[2], one[3], one[4]*finer) for i, one in enumerate(lines)]
    rows += ["--- OPTIONS ---", "%.12g dtM" % step, scheme + " tScheme", "3e6 kBot", "3e5 cBot", "1025 rho", "%g WtrDpth" % depth, "9.81 g",
             "1 disableOutput", "1 disableOutTime", "--- OUTPUTS ---", "FairTen1", "--- need this line ---"]
    with open("storm.txt", "w") as to:
        to.write("\n".join(rows) + "\n")


def moordyn_layout(library, layout, finer, until):
    """Rows (t, tension of the last line at its upper end)."""
    _, types, points, lines = layout
    pace = {one.split()[0]: math.sqrt(float(one.split()[2])/float(one.split()[3])) for one in types}
    step = min(0.3*one[3]/(one[4]*finer)*pace[one[0]] for one in lines)
    step = EVERY/math.ceil(EVERY/step)
    write(layout, finer, step)
    library.MoorDyn_Create.restype = library.MoorDyn_GetLine.restype = ctypes.c_void_p
    system = ctypes.c_void_p(library.MoorDyn_Create(b"storm.txt"))
    three, (x, y, z) = ctypes.c_double*3, points[-1][1:4]
    force, t, T, dt = three(), ctypes.c_double(), ctypes.c_double(), ctypes.c_double(step)
    if library.MoorDyn_Init(system, three(x, y, z), three()):
        sys.exit("moordyn: it does not begin")
    line, rows, each = ctypes.c_void_p(library.MoorDyn_GetLine(system, len(lines))), [], round(EVERY/step)
    for i in range(1, round(until/step) + 1):
        surge, heave, along, up = motion((i - 1)*step)
        if library.MoorDyn_Step(system, three(x + surge, y, z + heave), three(along, 0, up), force, ctypes.byref(t), ctypes.byref(dt)):
            break
        if i % each == 0:
            library.MoorDyn_GetLineFairTen(line, ctypes.byref(T))
            rows.append([i*step] + [T.value]*3)
    library.MoorDyn_Close(system)
    return rows


def hawser_layout(program, layout, finer, until):
    """Rows (t, tension at the upper end, tension in the middle of the last element)."""
    write(layout, finer, 0.01)
    end, lines = "P%d" % len(layout[2]), layout[3]
    return run_hawser(program, end, 0.025, until, "%s,L%d:%.12g" % (end, len(lines), 1 - 0.5/(lines[-1][4]*finer)))[0]


def compare(program, library):
    table = ["layout\telements\tof hawser\tof MoorDyn\tof both\tmean_kN\tdeviation_kN"]
    quiet = os.dup(1)
    for name, layout in LAYOUTS.items():
        own = [hawser_layout(program, layout, finer, 240.0) for finer in (1, 2)]
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        other = [moordyn_layout(library, layout, finer, 240.0) for finer in (1, 2)]
        os.dup2(quiet, 1)
        late = [row[1] for row in own[1] if row[0] > SETTLED]
        mean = sum(late)/len(late)
        table.append("%s\t%d\t%.4f\t%.4f\t%.4f\t%.2f\t%.2f" % (
            name, sum(one[4] for one in layout[3]), error(*[[[row[0]] + [row[1]]*3 for row in one] for one in own], SETTLED),
            error(other[0], other[1], SETTLED), error([[row[0]] + [row[2]]*3 for row in own[1]], other[1], SETTLED),
            mean/1e3, math.sqrt(sum((one - mean)**2 for one in late)/len(late))/1e3))
    print("\n".join(table))


def of_moordyn(library, elements, step, scheme, until):
    """Rows (t, three tensions), and the processor time."""
    write(STORM, elements, step, scheme)
    library.MoorDyn_Create.restype = library.MoorDyn_GetLine.restype = ctypes.c_void_p
    system = ctypes.c_void_p(library.MoorDyn_Create(b"storm.txt"))
    nine = ctypes.c_double*9
    force, t, T, dt = nine(), ctypes.c_double(), ctypes.c_double(), ctypes.c_double(step)
    if library.MoorDyn_Init(system, nine(*[v for x, y in FAIRLEADS for v in (x, y, -14.0)]), nine()):
        sys.exit("moordyn: it does not begin")
    lines = [ctypes.c_void_p(library.MoorDyn_GetLine(system, i + 1)) for i in range(3)]
    given = []
    for i in range(round(until/step)):
        surge, heave, along, up = motion(i*step)
        given.append((nine(*[v for x, y in FAIRLEADS for v in (x + surge, y, -14 + heave)]), nine(*[along, 0, up]*3)))
    rows, spent, each = [], 0.0, round(EVERY/step)
    for i, (x, v) in enumerate(given, 1):
        start = time.process_time()
        failed = library.MoorDyn_Step(system, x, v, force, ctypes.byref(t), ctypes.byref(dt))
        spent += time.process_time() - start
        if failed:
            break
        if i % each == 0:
            rows.append([i*step])
            for line in lines:
                library.MoorDyn_GetLineFairTen(line, ctypes.byref(T))
                rows[-1].append(T.value)
    library.MoorDyn_Close(system)
    return rows, spent


def run_hawser(program, ends, step, until, probes=None):
    """Of storm.txt, whose points `ends` move: rows (t, tensions of these or of `probes`), and the processor time."""
    scene = subprocess.run([program, "init", "--from", "storm.txt"], capture_output=True, text=True, check=True).stdout
    for name in ends.split(","):
        scene = scene.replace("  %s: fixed" % name, "  %s: {table: motion.txt}" % name)
    with open("motion.txt", "w") as to:
        for i in range(round(until/0.05) + 3):
            to.write("%.2f %.9f %.9f 0\n" % ((i*0.05,) + motion(i*0.05)[:2]))
    with open("storm.yaml", "w") as to:
        to.write(scene)
    spent = []
    for end in (step, until):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([program, "integrate", "storm.yaml", "--until", str(end), "--step", str(step), "--every", str(min(EVERY, end)),
                        "--probe", probes or ends, "-q", "--json", "storm.json"], check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        spent.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    with open("storm.json") as result:
        found = json.load(result)
    tension = [one["T"] for one in found["probes"].values()]
    return [[t] + [one[i] for one in tension] for i, t in enumerate(found["times"])], spent[1] - spent[0]


def of_hawser(program, elements, step, until):
    write(STORM, elements, 0.01)
    return run_hawser(program, "P4,P5,P6", step, until)


def error(rows, reference, after=20):
    known, worst = {round(row[0], 3): row for row in reference}, 0.0
    for k in (1, 2, 3):
        pairs = [(row[k], known[round(row[0], 3)][k]) for row in rows if row[0] > after and round(row[0], 3) in known]
        mean = sum(a - b for a, b in pairs)/len(pairs)
        size = sum(b for _, b in pairs)/len(pairs)
        worst = max(worst, math.sqrt(sum((a - b - mean)**2 for a, b in pairs)/sum((b - size)**2 for _, b in pairs)))
    return worst


def main():
    if len(sys.argv) < 3 or not os.path.exists(sys.argv[2]):
        sys.exit("skipped: bench/moordyn.py build/.libs/hawser libmoordyn.so")
    program, library = os.path.abspath(sys.argv[1]), ctypes.CDLL(os.path.abspath(sys.argv[2]))
    layouts = sys.argv[3:] == ["layouts"]
    until = float(sys.argv[3]) if len(sys.argv) > 3 and not layouts else 600.0
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        if layouts:
            compare(program, library)
            return
        quiet = os.dup(1)  # MoorDyn writes to standard output
        table = ["program\telements\tstep_s\terror\tprocessor_s"]
        reference, _ = of_hawser(program, 160, 0.0125, 60.0)
        for elements, steps in ((24, (0.25,)), (36, (0.125,)), (40, (0.05, 0.125)), (80, (0.05,))):
            for step in steps:
                rows, spent = of_hawser(program, elements, step, until)
                table.append("hawser\t%d\t%g\t%.4f\t%.2f" % (elements, step, error(rows, reference), spent))
        for elements, runs in ((40, ((0.005, "RK2"), (1/140, "RK2"), (0.01, "RK4"))), (80, ((0.0025, "RK2"), (1/240, "RK2")))):
            for step, scheme in runs:
                os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
                rows, spent = of_moordyn(library, elements, step, scheme, until)
                os.dup2(quiet, 1)
                table.append("MoorDyn %s\t%d\t%.4g\t%.4f\t%.2f" % (scheme, elements, step, error(rows, reference), spent))
        print("\n".join(table))


main()

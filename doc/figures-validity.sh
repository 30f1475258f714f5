#!/bin/sh
# The figure of doc/robustness.md, validity.svg, and the table under it: every program that sweeps parameters
# to their ends (tests/extremes/sweep.h) is run and its points are drawn. figures.sh doesn't call it; with
# HAWSER_LONG=1, as in the note, it takes more than an hour. Needs gnuplot, python3 and the programs of `make
# check`. Writes into the folder given as argument; validity.tsv there is used if it exists.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
target=${1:?give the folder for the figures}
build=${BUILD:-.}
mkdir -p "$target"
export OPENBLAS_NUM_THREADS=1 PYTHONUTF8=1

rows=$target/validity.tsv
if [ ! -s "$rows" ]; then
	for program in "$build"/tests/extremes/test-*sweep*; do
		case $program in
		*.o | *.log | *.trs) continue ;;
		esac
		HAWSER_VALIDITY=$rows "$program" >/dev/null || echo "$program: not all is right" >&2
	done
fi

# The panels as boxes (equal neighbours are one), their tics as gnuplot's commands, and the table.
python3 - "$rows" "$target" <<'END'
import math, sys
from collections import OrderedDict

rows, target = sys.argv[1:]
# stage, first axis (across), second (up), title
panels = [
    ("statics/H", "delta", "extensibility", "statics from H"),
    ("statics/length0", "length0", "extensibility", "statics from length0"),
    ("statics/T0", "tension", "extensibility", "statics from T0"),
    ("statics/sag", "sag", "slope", "statics from the sag"),
    ("travel/T0", "pace", "extensibility", "travelling, T0 held"),
    ("travel/H", "pace", "slope", "travelling, H held"),
    ("modes/spectral", "delta", "epsilon", "modes: spectral"),
    ("modes/analytic", "delta", "epsilon", "modes: analytic"),
    ("modes/chain", "delta", "epsilon", "modes: chain, 300 points"),
    ("modes/fdm", "delta", "epsilon", "modes: fdm, 300 points"),
    ("modes/meeting", "aside", "slope", "modes where two meet"),
    ("gyroscopic/spectral", "pace", "extensibility", "travelling modes: spectral"),
    ("gyroscopic/analytic", "pace", "extensibility", "travelling modes: analytic"),
    ("gyroscopic/fdm-source", "pace", "extensibility", "travelling modes: fdm-source"),
    ("beam/level", "drag", "theta", "beam: legendre"),
    ("beam/static", "inertia", "theta", "beam: static speeds"),
    ("rom", "delta", "epsilon", "tensors of the model"),
    ("frf balance", "Omega", "damping", "response: balance"),
    ("frf shooting", "Omega", "damping", "response: shooting"),
    ("loads of a taut span, 5 modes", "Omega", "load", "loads: a taut span"),
    ("loads of a sagging span, 5 modes", "Omega", "load", "loads: a sagging span"),
    ("mms", "Omega", "load", "multiple scales"),
    ("hill", "Omega", "damping", "multipliers"),
    ("mathieu", "inside", "epsilon", "beside Mathieu boundaries"),
    ("integrate adams", "Omega", "damping", "in time: adams"),
    ("integrate bdf", "Omega", "damping", "in time: bdf"),
    ("integrate gauss", "Omega", "damping", "in time: gauss"),
    ("folds, cusp", "damping", "cubic", "folds at a cusp"),
]
names = {"extensibility": "ρgd/EA", "epsilon": "ε", "delta": "δ", "length0": "length0/chord",
         "tension": "T0/ρgd", "sag": "sag/d", "slope": "h/d", "pace": "speed/limit", "drag": "c",
         "theta": "θ", "inertia": "r²", "aside": "off the meeting, H",
         "Omega": "Ω"}
colours = OrderedDict([
    ("right", 0x0b3c6f), ("1e-8", 0x3b8bc0), ("1e-4", 0xa9d4e8), ("as stated", 0xf3c26b),
    ("nothing", 0xe8e2da), ("refused", 0x9a9a9a), ("wrong", 0xd7191c)])

data, tally = {}, OrderedDict()
for line in open(rows):
    stage, a, x, b, y, outcome, error, stated = line.rstrip("\n").split("\t")
    error, stated = float(error), float(stated)
    t = tally.setdefault(stage, dict(points=0, right=0, beyond=0, refused=0, wrong=0, silent=0, worst=0.0))
    t["points"] += 1
    t[outcome] += 1
    if outcome == "right":
        t["silent"] += stated >= 1
        t["beyond"] += error > stated
        if stated < 1 and error > 0:
            t["worst"] = max(t["worst"], error/stated)
        kind = ("right" if error <= 1e-12 else "1e-8" if error <= 1e-8 else "1e-4" if error <= 1e-4
                else "nothing" if stated >= 1 else "as stated")
    else:
        kind = outcome
    data.setdefault((stage, a, b), {})[float(x), float(y)] = kind
    data.setdefault((stage, b, a), {})[float(y), float(x)] = kind

have = [p for p in panels if (p[0], p[1], p[2]) in data]
def power(k):
    return "1e%d" % k

def text(v):
    if v == 0:
        return "0"
    sign, k = "−" if v < 0 else "", math.log10(abs(v))
    if abs(k - round(k)) < 1e-9:
        return sign + ("%g" % abs(v) if -2 <= round(k) <= 3 else power(round(k)))
    if 0 < abs(v - 1) < 0.5e-2:
        k = math.log10(abs(v - 1))
        return "1" + ("+" if v > 1 else "−") + power(round(k)) if abs(k - round(k)) < 0.05 else None
    return sign + "%g" % abs(v) if len("%g" % v) <= 4 else None

def tics(values, least):
    out, last = [], -99
    labels = [text(v) for v in values]
    for i, label in enumerate(labels):
        if label is None:
            continue
        if i - last >= least or i == len(values) - 1:
            if i - last < least and out and i == len(values) - 1 and len(out) > 1:
                out.pop()
            out.append('"%s" %d' % (label, i))
            last = i
    return "(" + ", ".join(out) + ")"

columns = 5
with open(target + "/validity.gp", "w") as gp:
    lines = -(-len(have)//columns)
    height = 60 + 188*lines
    gp.write("set encoding utf8\nset terminal svg size 1060,%d noenhanced font 'sans-serif,11' "
             "background '#ffffff'\nset border 15 lw 0.6 lc rgb '#606060'\nset tics nomirror out scale 0.4\n"
             "unset key\nset style fill solid 1.0 noborder\nset multiplot\n" % height)
    for n, (stage, a, b, title) in enumerate(have):
        points = data[stage, a, b]
        xs, ys = (sorted(set(k[i] for k in points)) for i in (0, 1))
        name = target + "/validity-%d.txt" % n
        boxes = {}  # open ones: (first, last, kind): row where it began
        with open(name, "w") as out:
            for j in range(len(ys) + 1):
                i, here = 0, set()
                while j < len(ys) and i < len(xs):
                    kind, start = points.get((xs[i], ys[j])), i
                    while i < len(xs) and points.get((xs[i], ys[j])) == kind:
                        i += 1
                    if kind:
                        here.add((start, i, kind))
                for box in [box for box in boxes if box not in here]:
                    out.write("%g %g %g %g %d\n" % (box[0] - 0.5, box[1] - 0.5, boxes.pop(box) - 0.5, j - 0.5,
                                                    colours[box[2]]))
                for box in here:
                    boxes.setdefault(box, j)
        left, top = 66 + (n % columns)*205, 26 + (n//columns)*188
        gp.write("set lmargin at screen %.4f\nset rmargin at screen %.4f\nset tmargin at screen %.4f\n"
                 "set bmargin at screen %.4f\n" % (left/1060, (left + 130)/1060, 1 - top/height,
                                                   1 - (top + 120)/height))
        across, up = ("ε" if stage == "statics/H" and k == "extensibility" else names.get(k, k)
                      for k in (a, b))
        gp.write("set title '%s' offset 0,-0.7\nset xlabel '%s' offset 0,0.6\nset ylabel '%s' offset 1.2,0\n"
                 % (title, across, up))
        gp.write("set xtics %s\nset ytics %s\n" % (tics(xs, max(1, len(xs)/3.2)), tics(ys, len(ys)/5.0)))
        gp.write("plot [-0.5:%g] [-0.5:%g] '%s' using 1:3:1:2:3:4:5 with boxxyerror lc rgb variable\n"
                 % (len(xs) - 0.5, len(ys) - 0.5, name))
    labels = {"right": "true error up to 1e-12", "1e-8": "1e-8", "1e-4": "1e-4",
              "as stated": "larger, as stated", "nothing": "stated to be of no use (1 or more)",
              "refused": "refused, with a reason", "wrong": "wrong"}
    gp.write("unset title\nunset xlabel\nunset ylabel\nunset tics\nunset border\n"
             "set lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\n"
             "set tmargin at screen %.4f\n" % (26/height))
    at = 70
    for kind, colour in colours.items():
        if kind == "wrong" and not any(t["wrong"] for t in tally.values()):
            continue
        gp.write("set object rectangle from first %d,0.35 to first %d,0.85 fc rgb '#%06x' fs solid border "
                 "lc rgb '#606060'\n" % (at, at + 16, colour))
        gp.write("set label '%s' at first %d,0.6 left\n" % (labels[kind], at + 21))
        at += 45 + 6*len(labels[kind])
    gp.write("plot [0:1060] [0:1] NaN\nunset multiplot\n")

with open(target + "/validity.md", "w") as out:
    out.write("| stage/method | points | right | of no use | refused | beyond the estimate | worst true/stated |\n")
    out.write("| --- | --- | --- | --- | --- | --- | --- |\n")
    for stage, t in tally.items():
        out.write("| `%s` | %d | %d | %d | %d | %d | %.2g |\n" % (
            stage, t["points"], t["right"] - t["silent"], t["silent"], t["refused"], t["beyond"], t["worst"]))
END
gnuplot "$target/validity.gp" >"$target/validity.svg"
ls "$target"/validity.svg "$target"/validity.md

#!/usr/bin/env python3
"""Error over processor time of the ways to compute a response: raw models, condensed models, modes chosen
for an accuracy, full order, and `hawser frf` with all defaults, on six scenes of different kinds.

    trade.py measure TABLE [--only SCENE]   runs `hawser compare` on each scene and writes the table
    trade.py draw TABLE PICTURE.svg         draws it with gnuplot

The error is the distance of the whole response from a full-order one of a larger basis (the column
distance of `hawser compare`): the largest relative error of a fold or a peak, in frequency or in
amplitude, and of the curve between them. Each scene is verified before times are stated: the reference
must be complete, and the largest smaller basis that ended within the limit must be close to it. A
response that failed or did not end within the limit of processor time has no error in the table.

That of the default is the one of bench/practical.py: of the largest peaks and of the folds of stable motions, from
`hawser frf` with full order of that basis; its scene has no section "model".

Exit status: 0; 1 when a reference is not verified or a command fails.
SPDX-License-Identifier: GPL-3.0-or-later"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

import practical

FIDELITIES = ("raw 3, raw 4, raw 5, raw 7, raw 9, raw 12, condensed 3, condensed 4, condensed 5, condensed 7, "
              "condensed 9, condensed 12, condensed 16, auto 5, auto 2, auto 1, auto 0.5, auto 0.1")
LIMIT = 60    # processor seconds of a response
TOLERANCE = "1e-7"  # of orbits, relative: far below the errors compared; auto has its own
STEP = "0.01"       # longest step, as a part of the range
SETTLED = 2e-3  # largest distance of the largest other basis that ended from the reference

# name, file, title, from, to, bases of full order (the last is the reference), overrides. At their own
# load the cables of the first two become slack at the peak, which no model here describes.
SCENES = [
    ("b-table-4.2", "b-table-4.2", "chairlift, 0.3 load", "0.85w1", "1.2w1", (6, 8, 10, 12, 14),
     ["load.per_length=[0.24, 0.24, 0.24]"]),
    ("deep-sag", "deep-sag", "deep sag, 0.1 load", "0.85w1", "1.2w1", (8, 10, 12, 14),
     ["load.per_length=[0, 0.08, 0.08]"]),
    ("footbridge", "deep-sag", "footbridge, sag 8 m of 104 m", "0.85w1", "1.2w1", (6, 8, 10, 12, 14),
     ["cable.EA=280 MN", "cable.rho=28", "span.d=104", "span.h=2.5", "tension={sag: 8.2}",
      "damping={ratio: 0.8 %}", "load={frame: global, per_length: [0, 3.5, 3]}"]),
    ("conductor", "deep-sag", "conductor, sag 13 m of 420 m", "0.85w1", "1.2w1", (6, 8, 10, 12, 14),
     ["cable.EA=31.2 MN", "cable.rho=1.628", "span.d=420", "span.h=18", "tension={H: 27.5 kN}",
      "damping={ratio: 0.4 %}", "load={frame: global, per_length: [0, 0, 0.15]}"]),
    ("bridge-stay", "bridge-stay", "taut stay, 28° inclined", "0.9w1", "1.2w1", (6, 8, 10, 12, 14), []),
    ("inclined", "inclined", "31° inclined", "0.85w1", "1.2w1", (6, 8, 10, 12, 14), []),
]
METHODS = [("raw", "raw: the 3 to 12 lowest modes, others at rest", "#D55E00"),
           ("condensed", "condensed: the 3 to 16 lowest modes, others following", "#0072B2"),
           ("auto", "auto: modes chosen for 5 to 0.1 %", "#009E73"),
           ("full", "full order, 6 to 12 functions a component", "#606060"),
           ("default", "hawser frf, all defaults", "#000000")]
COLUMNS = ("scene", "from", "to", "method", "number", "coordinates", "outcome", "points", "distance",
           "processor_s", "folds_missing_or_extra")


def measure(options, scene):
    """The rows of one scene, and what is wrong with its reference or None."""
    name, file, _, low, high, bases, changes = scene
    full = [f"full {basis}" for basis in bases]
    path = os.path.join(options.srcdir, "notebooks-data", "scenes", file + ".yaml")
    command = [options.hawser, "compare", path, "--from", low, "--to", high, "--quiet", "--limit",
               str(options.limit), "--tolerance", TOLERANCE, "--step", STEP, "--fidelities", FIDELITIES + ", " + ", ".join(full),
               "--reference", full[-1]]
    for change in changes:
        command += ["--set", change]
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        subprocess.run(command + ["--json", file.name], check=True, stdout=subprocess.DEVNULL)
        with open(file.name, encoding="utf-8") as text:
            result = json.load(text)
    rows, wrong = [], f"no basis but {full[-1]} ended within the limit"
    for one in result["fidelities"]:
        distance = one.get("distance") if one["outcome"] in ("complete", "unreached", "returned") else None
        if one["name"] in full[:-1] and distance is not None:
            wrong = None if distance <= SETTLED else f"{one['name']} is {distance:.1e} from {full[-1]}"
        folds = one.get("folds", {"missing": 0, "extra": 0})
        seconds = one.get("processor_secs")
        rows.append((name, low, high, one["family"], f"{one['number']:g}", one.get("coordinates", ""),
                     one["outcome"], one.get("points", ""),
                     "" if distance is None else f"{distance:.3g}",
                     "" if seconds is None else f"{seconds:.3g}", folds["missing"] + folds["extra"]))
    return rows, wrong


def measure_default(options, scene):
    """The row of `hawser frf` with nothing said of a model."""
    name, file, _, low, high, bases, changes = scene
    with open(os.path.join(options.srcdir, "notebooks-data", "scenes", file + ".yaml"), encoding="utf-8") as text:
        plain = re.sub(r"^model:.*\n(?:[ \t#].*\n|\n)*", "", text.read(), flags=re.M)
    words = ["--from", low, "--to", high] + [word for change in changes for word in ("--set", change)]
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.yaml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(plain)
        own, why, seconds = practical.respond(options.hawser, folder, path, words)
        exact, _, _ = practical.respond(options.hawser, folder, path, words + [
            "--set", "model.energy=exact", "--set", f"model.basis={bases[-1]}", "--tolerance", TOLERANCE])
    distance, lost = practical.compare(own, exact) if own and exact else (None, [])
    return (name, low, high, "default", "0", "", "complete" if own else why, len(own["points"]) if own else "",
            "" if distance is None else f"{distance:.3g}", f"{seconds:.3g}", len(lost))


def measure_all(options):
    failed = False
    with open(options.table, "w", encoding="utf-8") as table:
        print("# error over processor time (one thread): bench/trade.py measure", file=table)
        print("# distance: from full order with the largest basis, whose own distance is empty", file=table)
        print(*COLUMNS, sep="\t", file=table)
        for scene in SCENES:
            if options.only and options.only != scene[0]:
                continue
            rows, wrong = measure(options, scene)
            rows.append(measure_default(options, scene))
            failed |= wrong is not None
            print(f"{scene[0]}: {'NOT VERIFIED: ' + wrong if wrong else 'reference verified'}")
            for row in rows:
                reference = row[3] == "full" and row[4] == f"{scene[5][-1]}"
                row = row[:8] + ("",) + row[9:] if reference else row
                print(*row, sep="\t", file=table)
                print(f"  {row[3] + ' ' + row[4]:<14} {row[6]:<11} error {row[8] or '-':<9} "
                      f"{row[9] or '-':>7} s", flush=True)
            table.flush()
            dominated(rows)
    return 1 if failed else 0


def dominated(rows):
    """State each raw model that is less accurate, or slower, than some converging one."""
    known = [(row[3], row[4], float(row[8]), float(row[9])) for row in rows if row[8] and row[9]]
    for method, number, error, seconds in known:
        if method != "raw":
            continue
        better = [f"{m} {n} ({e:.2g}, {s:.2g} s)" for m, n, e, s in known
                  if m != "raw" and e <= error and s <= seconds]
        print(f"  raw {number} ({error:.2g}, {seconds:.2g} s): " +
              (f"dominated by {', '.join(better[:3])}" if better else "NOT dominated"))


def read(table):
    """{scene: {method: [(seconds, error)]}} of the responses with an error."""
    found = {}
    with open(table, encoding="utf-8") as text:
        lines = [line.rstrip("\n").split("\t") for line in text if not line.startswith("#")]
    for line in lines[1:]:
        row = dict(zip(lines[0], line))
        if row["distance"] and row["processor_s"]:
            found.setdefault(row["scene"], {}).setdefault(row["method"], []).append(
                (float(row["processor_s"]), float(row["distance"])))
    return found


def symbol(method):
    return "pt 3 ps 1.1 lw 1.6" if method == "default" else "pt 7 ps 0.45"


def panel(name, title, place, curves):
    """gnuplot's commands for a scene; place: column and row."""
    left, top = 0.075 + 0.312*place[0], 0.94 - 0.435*place[1]
    yield f"set lmargin at screen {left:.4f}\nset rmargin at screen {left + 0.28:.4f}"
    yield f"set tmargin at screen {top:.4f}\nset bmargin at screen {top - 0.335:.4f}"
    yield f"set title '{title}' offset 0,-0.7"
    yield "set ylabel 'Error of the response' offset 1,0" if place[0] == 0 else "unset ylabel"
    yield "set xlabel 'Processor time (s)' offset 0,0.5" if place[1] == 1 else "unset xlabel"
    yield f"set format y '{'10^{%L}' if place[0] == 0 else ''}'"
    parts = []
    for k, (method, _, _) in enumerate(METHODS):
        if method in curves:
            block = f"$d{name}_{method}".replace("-", "_").replace(".", "_")
            yield f"{block} << END\n" + "\n".join(f"{t} {e}" for t, e in curves[method]) + "\nEND"
            parts.append(f"{block} with linespoints lt {k + 1} {symbol(method)}")
    yield "plot " + ", ".join(parts)


def draw(options):
    found = read(options.table)
    kind = "svg size 1000,640 enhanced font 'sans-serif,12' background '#ffffff' linewidth 1.3"
    if options.picture.endswith(".png"):
        kind = "pngcairo size 1000,640 enhanced font 'sans,10' linewidth 1.3"
    script = ["set encoding utf8", f"set terminal {kind}", f"set output '{options.picture}'"]
    script += [f"set linetype {k + 1} lc rgb '{colour}'" for k, (_, _, colour) in enumerate(METHODS)]
    script += ["set border 3 lw 0.8 lc rgb '#404040'", "set tics nomirror out scale 0.6",
               "set grid lw 0.5 lc rgb '#d8d8d8' dt solid", "set logscale xy", "set xrange [0.005:60]",
               "set yrange [1e-5:2]", "set format x '%g'", "set xtics (0.01, 0.1, 1, 10)", "set key off",
               "set multiplot"]
    for k, (name, _, title, *_) in enumerate(SCENES):
        script += panel(name, title, (k % 3, k//3), found.get(name, {}))
    keys = [f"NaN with linespoints lt {k + 1} {symbol(method)} title '{title}'"
            for k, (method, title, _) in enumerate(METHODS)]
    script += ["unset border", "unset tics", "unset grid", "unset xlabel", "unset ylabel", "unset title",
               "unset logscale", "set xrange [0:1]", "set yrange [0:1]", "set lmargin at screen 0.05",
               "set rmargin at screen 0.95", "set tmargin at screen 0.02", "set bmargin at screen 0.01",
               "set key at screen 0.5,0.02 center bottom horizontal maxcols 2 samplen 2.5 Left reverse width -6",
               "plot " + ", ".join(keys), "unset multiplot", "unset output"]
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(required=True)
    run = commands.add_parser("measure", help="run the program, write the table")
    run.add_argument("table")
    run.add_argument("--hawser", default="./hawser", help="the program (./hawser)")
    run.add_argument("--srcdir", default=".", help="folder of the sources (.)")
    run.add_argument("--limit", type=int, default=LIMIT, help=f"processor seconds of a response ({LIMIT})")
    run.add_argument("--only", default="", help="this scene alone")
    run.set_defaults(work=measure_all)
    picture = commands.add_parser("draw", help="draw the table with gnuplot")
    picture.add_argument("table")
    picture.add_argument("picture", help="a file that ends in .svg or .png")
    picture.set_defaults(work=draw)
    options = parser.parse_args()
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    return options.work(options)


if __name__ == "__main__":
    sys.exit(main())

#!/bin/sh
# --units in pictures: what gnuplot is given in chosen units is what it is given in SI, converted. A program that
# copies its input stands in for gnuplot, so that the "pictures" are scripts. Their plots are compared one by one:
# the unit at an axis of one picture, over that at the axis of the other, is the factor of its data, range and
# marks. And no unit of a chosen dimension is left in SI.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

if ! command -v python3 >/dev/null; then
	skip "python3 is not installed"
	done_testing
	exit
fi
printf '#!/bin/sh\nexec cat\n' >"$scratch/gnuplot"
chmod +x "$scratch/gnuplot"
HAWSER_GNUPLOT=$scratch/gnuplot
export HAWSER_GNUPLOT

cat >"$scratch/compare.py" <<'END'
import re, sys
turn = 6.283185307179586
# unit as it is drawn: its size in SI, and its dimension
pound = 4.4482216152605
size = {"m": (1, "L"), "mm": (1e-3, "L"), "µm": (1e-6, "L"), "ft": (0.3048, "L"), "s": (1, "T"), "min": (60, "T"),
        "N": (1, "F"), "kN": (1e3, "F"), "MN": (1e6, "F"), "lbf": (pound, "F"), "rad/s": (1, "W"), "Hz": (turn, "W"),
        "rpm": (turn/60, "W"), "m/s": (1, "V"), "mm/s": (1e-3, "V"), "µm/s": (1e-6, "V"), "ft/s": (0.3048, "V"),
        "1/s": (1, "R"), "1/min": (1/60, "R"), "J": (1, "E"), "ft lbf": (0.3048*pound, "E"), "–": (1, ""), "%": (1, ""),
        "N s/m": (1, "C"), "kN s/m": (1e3, "C"), "lbf s/ft": (pound/0.3048, "C"), "": (1, "")}
of_si = {"m", "mm", "µm", "s", "N", "kN", "MN", "rad/s", "Hz", "m/s", "mm/s", "µm/s", "1/s", "J", "N s/m", "kN s/m"}
number = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?"

def unit(title):
    """the unit at the end of an axis' title; None: that is no title of one"""
    found = re.search(r"\(([^()]*(?:\([^()]*\)[^()]*)*)\)$", title)
    return found.group(1) if found and found.group(1) in size else ""

def read(path):
    blocks, plots, now, x, y, words = {}, [], {}, None, "", []
    lines = iter(open(path, encoding="utf-8").read().split("\n"))
    for line in lines:
        begin = re.match(r"\$(\w+) << (\w+)$", line)
        if begin:
            rows = blocks[begin.group(1)] = []
            for row in lines:
                if row == begin.group(2):
                    break
                rows.append(row.split())
            continue
        label = re.match(r"set (xlabel|label(?: \d+)?|title) '((?:[^']|'')*)'", line)
        if label and label.group(1) == "xlabel":
            x = unit(label.group(2))
        elif label and label.group(1) == "label 1000":
            y = unit(label.group(2))
        elif label and label.group(2):
            words.append((label.group(1), label.group(2)))
            if label.group(1) == "label 1001":
                now["cb"] = unit(label.group(2))
        if line == "unset xlabel":
            x = None
        if line == "set autoscale x":
            now.pop("x", None)
        found = re.match(r"set ([xy])range \[(.*):(.*)\]", line)
        if found:
            now[found.group(1)] = found.group(2, 3)
        found = re.match(r"set arrow (?:\d+ )?from (?:first )?(%s)" % number, line)
        if found:
            now["arrow"] = (found.group(1),)
        if line.startswith("plot ") and not re.match(r"plot (NaN with|2)", line):
            plots.append(dict(now, x_range=now.get("x"), y_range=now.get("y"), x=x, y=y, cb=now.get("cb"), line=line))
    for k, plot in enumerate(plots):  # without a title: that of a panel below with the same range
        for below in plots[k + 1:]:
            if plot["x"] is None and below["x"] is not None and below["x_range"] == plot["x_range"]:
                plot["x"] = below["x"]
        plot["x"] = plot["x"] or ""
    return blocks, plots, words

def close(a, b, factor, where):
    try:
        a, b = float(a), float(b)
    except ValueError:
        if a != b:
            sys.exit("%s: %s, not %s" % (where, b, a))
        return
    if a != a and b != b:
        return
    if abs(a - b*factor) > tolerance*max(abs(a), abs(b*factor)) + 1e-13*abs(factor):
        sys.exit("%s: %g, of %g in SI: the factor is %g, not %g" % (where, b, a, a/b if b else 0.0, factor))

tolerance = 6e-3  # of ranges with three digits; data have seven at least

def compare(name, units):
    global tolerance
    si, us = read(name + ".png"), read(name + "-us.png")
    chosen = {size[u.strip().replace(".", " ")][1] for u in units.split(",")}
    chosen |= {"V"} if "L" in chosen else set()
    left = {u for u in of_si if size[u][1] in chosen}
    if len(si[1]) != len(us[1]) or not si[1]:
        sys.exit("%d plots, not %d" % (len(us[1]), len(si[1])))
    seen = set()
    for k, (a, b) in enumerate(zip(si[1], us[1])):
        where = "%s, plot %d" % (name, k + 1)
        factor = {}
        for axis in ("x", "y", "cb"):
            if a[axis] is None:
                continue
            if b[axis] in left:
                sys.exit("%s: the %s axis is still in %s" % (where, axis, b[axis]))
            factor[axis] = size[b[axis]][0]/size[a[axis]][0]
            seen.add(b[axis])
        for axis in "xy":
            for u, v in zip(a[axis + "_range"] or (), b[axis + "_range"] or ()):
                close(u, v, factor[axis], "%s, %s range" % (where, axis))
        for u, v in zip(a.get("arrow", ()), b.get("arrow", ())):
            close(u, v, factor["x"], where + ", arrow")
        uses = 0
        for piece, other in zip(re.split(r", (?=[$\d])", a["line"][5:]), re.split(r", (?=[$\d])", b["line"][5:])):
            block = re.match(r"\$(\w+)", piece)
            slope = re.match(r"(%s)\*x" % number, piece)
            if slope:
                close(slope.group(1), re.match(number, other).group(0), factor["y"]/factor["x"], where + ", line")
            if not block:
                continue
            using = re.search(r"using (\(.*?\):[^ ]+|[^ ]+)(?: with|$| )", piece)
            columns = [re.search(r"\$?(\d+)", c) for c in (using.group(1).replace(" ", "") if using else "1:2").split(":")]
            columns = [int(c.group(1)) for c in columns][:3]
            axes = list(zip(columns, ("x", "y", "cb") if a["cb"] is not None else ("x", "y")))
            for u, v in zip(si[0][block.group(1)], us[0][block.group(1)]):
                for column, axis in axes:
                    if len(u) < column:
                        continue
                    uses += 1
                    tolerance = 3e-6
                    close(u[column - 1], v[column - 1], factor[axis], "%s, $%s, column %d" % (where, block.group(1), column))
                    tolerance = 6e-3
        if not uses and a["line"] != "plot NaN notitle":  # a panel in which nothing is
            sys.exit(where + ": no data")
        if re.sub(number, "", a["line"]) != re.sub(number, "", b["line"]):
            sys.exit(where + ": other plots")
    if len(si[2]) != len(us[2]):
        sys.exit("%s: %d labels, not %d" % (name, len(us[2]), len(si[2])))
    spaced = re.compile(r"(%s) (rpm|Hz|ft/s|m/s|lb/ft|kg/m|lbf|N|ft|m)\b" % number)
    for (kind, a), (_, b) in zip(si[2], us[2]):
        for (u, au), (v, bu) in zip(spaced.findall(a), spaced.findall(b)):
            if bu in left:
                sys.exit("%s: still in SI: %s" % (name, b))
            close(u, v, size[bu][0]/size[au][0], "%s, label \"%s\"" % (name, b))
            seen.add(bu)
    missing = chosen - {size[u][1] for u in seen} - {"V"}
    if missing:
        sys.exit("%s: no unit of %s; there is %s" % (name, missing, sorted(seen)))

for line in open("pictures"):
    name, units = line.rstrip("\n").split("\t")
    with open(name + ".said", "w") as said:
        try:
            compare(name, units)
        except (SystemExit, KeyError, ValueError, FileNotFoundError, IndexError) as error:
            said.write(repr(error))
END

# same NAME "UNITS" ARGUMENTS
same() {
	name=$1
	units=$2
	shift 2
	run "$@" --plot "$name.png" -q
	[ "$status" -ne 0 ] || run "$@" --units "$units" --plot "$name-us.png" -q
	called 0 "$@"
	verdict "$status" "$words draws"
	printf '%s\t%s\n' "$name" "$units" >>pictures
}

scenes=$top/notebooks-data/scenes
travel="--set travel.hold=tension --set travel.speed=40"
printf 'frequency_Hz\tplane\n1.5\tin-plane\n3\tin-plane\n' >frequencies.tsv
same statics "ft, lbf" statics "$chairlift"
same turned "ft, lbf" statics "$chairlift" --set 'load.static.per_length=[0, -8, 12]'
same speeds "ft, lbf" statics "$scenes/b-table-5.3.yaml" --speeds --points 3
same cases "ft, lbf" statics "$scenes/conductor.yaml" --cases
same modes "ft, rpm" modes "$chairlift" -n 3
same profile "ft, rpm" modes "$chairlift" -n 3 --view profile
same turning "ft, rpm" modes "$chairlift" -n 3 $travel
same waves "ft, rpm" modes "$chairlift" -n 3 $travel --view waves
same passing "ft, rpm" modes "$chairlift" -n 3 $travel --view profile
same dampers "lbf.s/ft" modes "$scenes/stay-damper.yaml" -n 1 --over 'attach.damper.damper[2]=3e3:3e5:2'
same irvine "lbf, rpm" irvine "$chairlift" -n 1 --points 3 --over value --unit Hz
same periods "ft/s, min" irvine "$scenes/b-table-5.3.yaml" -n 1 --points 2 --speeds "0, 5" --unit s
same campbell "ft/s, rpm" campbell "$scenes/b-table-5.3.yaml" -n 1 --points 3 --to 20 --spacing "60 m"
same frf "ft, rpm" frf "$chairlift" --to 1.1w1 --max-points 6
same energy "ft.lbf, rpm" frf "$chairlift" --to 1.1w1 -n 2 --max-points 6 --backbone 1 --energy
same folds "ft, rpm" folds "$scenes/b-table-4.5.yaml" --set model.modes=1 --from 0.9w1 --to 1.1w1 --starts 0
same integrate "ft, rpm, min" integrate "$chairlift" --Omega 0.9w1 --until 1T
same map "rpm, ft/s, 1/min" map "$scenes/b-table-5.4.yaml" -n 2 --x Omega=14:16 --y travel.fluctuation=0:8 --points 3x3 \
	--quantity growth
same hill "rpm, ft/s" hill "$scenes/b-table-5.4.yaml" --set model.modes=1 --x Omega=14:16 --y travel.fluctuation=0:8 \
	--samples 5 --lines 5
same beam "ft/s, rpm, 1/min" beam "$scenes/hoist-rope.yaml" --to 60 --points 4 --basis 6
same boundary "lbf, ft/s" beam "$scenes/hoist-rope.yaml" --boundary beam.tension_end --from "5 kN" --to "40 kN" --basis 4
same motion "min, ft" beam "$scenes/hoist-rope.yaml" --until 0.1 --coordinates 3 --basis 6 --every 0.02
same identify "rpm" identify "$chairlift" frequencies.tsv --free tension.T0
python3 -IS "$scratch/compare.py"
is_same() {
	[ -e "$1.said" ] && [ ! -s "$1.said" ] || { cat "$1.said"; return 1; }
}
while IFS='	' read -r name units; do
	try "the picture $name in $units is that in SI, converted" is_same "$name"
done <pictures
done_testing

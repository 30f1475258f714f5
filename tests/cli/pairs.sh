#!/bin/sh
# Every command on scenes with every pair of features: it works, or refuses and names the file, a key or an option.
# No crash, no endless run, no number that is none. In the suite every second pair has one command, by
# turns, of those that take hundredths of a second; with HAWSER_LONG every pair has every command (a quarter of an hour).
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
export HAWSER
cat >pairs.py <<'END'
import itertools, json, os, re, shlex, subprocess, sys
BASE = {"cable": ["EA: 60 MN", "rho: 8.2 kg/m"], "span": ["d: 240 m", "h: 38 m"], "tension": ["T0: 210 kN"],
        "damping": ["ratio: 0.011"], "load": ["frame: global", "per_length: [0, 4 N/m, 3 N/m]"],
        "model": ["modes: 4", "condense: static"]}
# a key that is in both features of a pair makes no scene: such a pair is left out
FEATURES = {
    "mass": {"attach": ["{at: 40 %, mass: 300 kg}"]},
    "spring": {"attach": ["{at: 70 %, spring: [0, 2 kN/m, 1 kN/m]}"]},
    "damper": {"attach": ["{at: 5 %, damper: [0, 2 kN s/m, 1 kN s/m]}"]},
    "absorber": {"attach": ["{at: 30 %, absorber_mass: 20 kg, absorber_stiffness: 300 N/m}"]},
    "motion": {"support": ["motion: [5 mm, 10 mm, 5 mm]"]},
    "elastic": {"support": ["stiffness: [20 MN/m, 20 MN/m, 5 MN/m]", "mass: 50 kg"]},
    "bending": {"cable": ["EI: 200 kN.m2"], "ends": ["A: clamped", "B: clamped"]},
    "ice": {"load": ["static: {mass: 1 kg/m}"]},
    "wind": {"load": ["static: {per_length: [0, 0, 20 N/m]}"]},
    "warm": {"temperature": ["change: 20 K", "expansion: 1.2e-5"]},
    "drag": {"damping": ["drag: 0.02 kg/m2"]},
    "ratios": {"damping": ["ratio: [0.004, 0.02, 0.009]"]},
    "loads": {"loads": ["{force: [0, 0, 200 N], at: 30 %}",
                        "{per_length: [0, 2 N/m, 0], from: 20 %, to: 50 %, harmonic: 2}"]},
    "travel": {"travel": ["speed: 3 m/s", "hold: tension"]},
    "truncated": {"model": ["condense: none"]},
    "exact": {"model": ["energy: exact", "basis: 6"]},
}
QUICK = {
    "statics": "statics S", "modes": "modes S", "irvine": "irvine S -n 1 --points 2", "rom": "rom S",
    "hill": "hill S --Omega 2w1", "map": "map S --x Omega=1.9w1:2.1w1 --y factor.load=0:1 --points 2x2",
    "integrate": "integrate S --Omega 1.02w1 --until 1", "plan": 'plan S --limit 0.05 --fidelities "raw 1"',
    "frf": "frf S -n 2 --from 0.9w1 --to 0.91w1 --step 0.3 --tolerance 1e-5",
}
DEAR = {
    "frf": "frf S --from 0.9w1 --to 1.1w1 --tolerance 1e-5", "folds": "folds S --from 0.95w1 --to 1.05w1",
    "map": "map S --x Omega=1.9w1:2.1w1 --y factor.load=0:1 --points 4x4", "mms": "mms S",
    "integrate": "integrate S --Omega 1.02w1 --until 5", "plan": "plan S --limit 0.5 --from 0.9w1 --to 1.1w1",
    "compare": 'compare S --from 0.9w1 --to 1.1w1 --fidelities "raw 4, condensed 4" --limit 5',
}
# what a message may name: a file with a line, a key, an option
NAMED = re.compile(r"\bS:\d+|\b(cable|span|tension|damping|loads?|attach|support|ends|temperature|travel|model)"
                   r"(\[\d+\]|\.\d+|\.[AB])?\.[a-zA-Z]|\battach\b|(?<!\w)--[a-z]")


def scene(pair):
    parts, both = {k: dict(p.split(": ", 1) for p in v) for k, v in BASE.items()}, {}
    for feature in pair:
        for section, entries in FEATURES[feature].items():
            for e in entries:
                if section in ("attach", "loads"):
                    both.setdefault(section, []).append(e)
                    continue
                key, value = e.split(": ", 1)
                if (section, key) in both:
                    return None
                both[section, key] = value
                parts.setdefault(section, {})[key] = value
    text = "".join("%s: %s\n" % (s, "{" + ", ".join("%s: %s" % e for e in p.items()) + "}" if s != "support" else
                                 "{B: {" + ", ".join("%s: %s" % e for e in p.items()) + "}}") for s, p in parts.items())
    return text + "".join("%s: [%s]\n" % (s, ", ".join(both[s])) for s in ("attach", "loads") if s in both)


def refuse_constant(name):
    raise ValueError("the JSON has " + name)


def fault(line):
    args = [os.environ["HAWSER"]] + shlex.split(line) + ["--json", "out.json", "-q"]
    if os.path.exists("out.json"):
        os.remove("out.json")
    try:
        run = subprocess.run(args, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120)
    except subprocess.TimeoutExpired:
        return "took two minutes"
    text = run.stderr.strip()
    if run.returncode == 0:
        try:
            json.loads(open("out.json").read(), parse_constant=refuse_constant)
        except ValueError as e:
            return str(e)
        return "a table has nan" if re.search(r"\bnan\b", run.stdout) else ""
    if run.returncode not in (1, 2, 3) or not text.startswith("hawser: ") or "unknown option" in text:
        return "status %d: %s" % (run.returncode, text[-300:])
    return "" if NAMED.search(text) else "names neither file nor key: " + text[-300:]


pairs = [p for p in [(f,) for f in FEATURES] + list(itertools.combinations(FEATURES, 2)) if scene(p)]
long = bool(os.environ.get("HAWSER_LONG"))
commands = dict(QUICK, **DEAR) if long else QUICK
names, faults, runs = list(commands), [], 0
for i, pair in enumerate(pairs):
    if i % 2 and not long:
        continue
    with open("S", "w") as f:
        f.write(scene(pair))
    # 7 and the number of commands have no common factor, so that neighbours have different commands
    for name in names if long else [names[(7*i + i//len(names)) % len(names)]]:
        found = fault(commands[name])
        runs += 1
        if found:
            faults.append("%s, %s: %s" % ("+".join(pair), commands[name], found))
assert runs >= 60, runs
assert not faults, "\n".join(["%d of %d runs" % (len(faults), runs)] + faults)
END
python "every command works with every pair of features, or says what contradicts what" <pairs.py
done_testing

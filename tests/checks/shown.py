"""Runs the commands that README.md, pages of doc/ and the manual pages show, and compares what is shown with what is printed.

    HAWSER=build/hawser SRCDIR=. BUILDDIR=build MANDIR=build/man python3 tests/checks/shown.py [DOCUMENT...]

A command stands in a code block (indented by four blanks in Markdown, .EX or .nf in a manual page) behind "$ ";
a "\\" at its end or a here-document continues it. What follows up to the next "$ " is what it prints, on
standard output or standard error. All commands of a document run one after the other in one folder, which is a copy of the
folder of scenes, if its text says so; else it is empty.

Words are compared one by one, line breaks being blanks; "..." stands for any words. A number may differ by one
in its last shown digit, or by what the command leaves open (ACCURACY). Not compared are counts of work
and round-off: see `free` and ROUND_OFF.

What takes long (LONG) runs to its end with HAWSER_LONG=1 only. Otherwise it is started, and what still runs after
STARTED seconds of processor time counts as passed: its arguments and files were accepted. What reads a file that such a
command did not come to write is left out. Pictures are drawn with HAWSER_LONG=1 only; tests/cli/pictures.sh draws
each kind. HAWSER_PICTURES=FOLDER runs everything to its end as well, and keeps the pictures in FOLDER/DOCUMENT: make site
(doc/site) takes those of DOCUMENTS from there.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile

LONG = (r"hawser (map|campbell|compare|folds|frf|locus|hill|beam|integrate|mms)\b|hawser plan\b"
        r"|hawser irvine [\w.-]* --|hawser statics .*--(speeds|models)"
        r"|hawser identify .*--free [\w.]+,|hawser nnm\b|hawser modes .*--over"
        r"|hawser report\b|hawser sweep\b|hawser statics .*--cases|hawser transient .*--spans|hawser modes ropeway-bouquet")
STARTED = 0.03       # s of processor time; reading and checking a scene takes 0.01
LIMIT = 1800.0       # s of wall time, for a command that runs to its end
PRECISION = 1e-12    # relative, of what is computed to round-off
ROUND_OFF = 1e-8     # numbers below it are residuals and estimates of errors
ACCURACY = {"frf": 1e-6, "folds": 1e-6, "map": 1e-6, "hill": 1e-6,
            "irvine": 1e-8, "campbell": 1e-8, "beam": 1e-8}
COUNTED = re.compile(r"(steps|evaluations|Jacobians|points|modal)\b")
NUMBER = re.compile(r"([^\w.+-]*)([-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?)(?![\w.])(.*)", re.DOTALL)
INSTALLED = "/usr/local/share/hawser/scenes"
# Commands of README.md that other tests run: .ci/run does.
ELSEWHERE = re.compile(r"\./quickstart")
COPY = "copy of the folder of scenes"
DOCUMENTS = ("README.md", "doc/tutorial.md", "doc/tutorial-nets.md", "doc/tutorial-mooring.md", "doc/tutorial-galloping.md",
             "doc/tutorial-stay.md", "doc/tutorial-chairlift.md", "doc/tutorial-models.md", "doc/commands.md", "doc/gallery.md", "doc/moorings.md", "doc/water.md")

source = os.path.abspath(os.environ["SRCDIR"])
program = os.path.abspath(os.environ["HAWSER"])
pictures = os.environ.get("HAWSER_PICTURES", "")
long_run = bool(os.environ.get("HAWSER_LONG") or pictures)
verdicts = []
unwritten = set()    # files of commands that were only started


def verdict(passed, text, why=()):
    verdicts.append(passed)
    print("%s %d - %s" % ("ok" if passed else "not ok", len(verdicts), text))
    if not passed:
        for line in why:
            print("# " + line)
    sys.stdout.flush()


# --- documents

def blocks_of_markdown(text):
    """(number of the first line, lines) of each block that four blanks indent."""
    block, start = [], 0
    for number, line in enumerate(text.split("\n") + ["end"], 1):
        if line.startswith("    ") or (block and not line.strip()):
            start = start if block else number
            block.append(line[4:])
        elif block:
            yield start, block
            block = []


ESCAPES = ((r"\-", "-"), (r"\(dq", '"'), (r"\(aq", "'"), (r"\(ha", "^"), (r"\&", ""), (r"\e", "\\"))


def blocks_of_manual(text):
    """The same of a manual page: from .EX to .EE, and from .nf to .fi."""
    block, start = None, 0
    for number, line in enumerate(text.split("\n"), 1):
        if line.strip() in (".EX", ".nf"):
            block, start = [], number + 1
        elif line.strip() in (".EE", ".fi") and block is not None:
            yield start, block
            block = None
        elif block is not None and not line.startswith("."):
            for escape, plain in ESCAPES:
                line = line.replace(escape, plain)
            block.append(line)


def commands(start, block):
    """(line number, command, what is shown below it) of a block."""
    found, at = [], 0
    while at < len(block):
        line, number = block[at], start + at
        at += 1
        if not line.startswith("$ "):
            if found:
                found[-1][2].append(line)
            continue
        command = line[2:]
        end = re.search(r"<<\s*'?(\w+)", command)
        while at < len(block) and (command.endswith("\\") or end):
            command += "\n" + block[at]
            at += 1
            if end and block[at - 1] == end.group(1):
                break
        found.append((number, command, []))
    return found


# --- comparison

def words_of(text):
    return text.replace("…", "...").split()


def free(words, i):
    """Whether the number at i is a count of work, by the word after it."""
    return i + 1 < len(words) and COUNTED.match(words[i + 1])


def digit(number):
    """One in the last digit that is shown."""
    mantissa, _, exponent = number.lower().partition("e")
    return 10.0**(int(exponent or 0) - len(mantissa.partition(".")[2]))


def same_word(shown, i, word, accuracy):
    if shown[i] == word:
        return True
    ours, theirs = NUMBER.fullmatch(shown[i]), NUMBER.fullmatch(word)
    if not ours or not theirs or ours.group(1) != theirs.group(1) or ours.group(3) != theirs.group(3):
        return False
    a, b = float(ours.group(2)), float(theirs.group(2))
    if free(shown, i) or max(abs(a), abs(b)) < ROUND_OFF:
        return True
    whole = re.fullmatch(r"[-+]?\d+", ours.group(2)) and re.fullmatch(r"[-+]?\d+", theirs.group(2))
    return a == b if whole else abs(a - b) <= 1.001*max(digit(ours.group(2)), accuracy*abs(a))


def prefix(part, words, at, accuracy):
    """How many words of part stand at `at`."""
    i = 0
    while i < len(part) and at + i < len(words) and same_word(part, i, words[at + i], accuracy):
        i += 1
    return i


def differs(shown, printed, accuracy):
    """None, or what is shown and not printed. Each part between two "..." is taken where it first fits."""
    shown, printed = words_of(shown), words_of(printed)
    parts, at = [[]], 0
    for word in shown:
        if word == "...":
            parts.append([])
        else:
            parts[-1].append(word)
    for k, part in enumerate(parts):
        if k == len(parts) - 1 and k > 0 and part:
            places = [len(printed) - len(part)] if len(printed) - len(part) >= at else []
        else:
            places = [at] if k == 0 else range(at, len(printed) - len(part) + 1)
        best, longest = None, -1
        for place in places:
            length = prefix(part, printed, place, accuracy)
            if length > longest:
                best, longest = place, length
            if length == len(part):
                break
        if longest < len(part):
            return "shown: %s; printed: %s" % (" ".join(part[max(longest, 0):][:12]),
                                               " ".join(printed[(best or 0) + max(longest, 0):][:12]))
        at = best + len(part)
    return None if parts[-1] == [] and len(parts) > 1 or at == len(printed) else \
        "printed, not shown: " + " ".join(printed[at:][:12])


def can_tell():
    """The comparison itself: (shown, printed, whether they agree)."""
    cases = (("H = 79891.36957 N", "H = 79891.369572 N", True), ("H = 79891.36957 N", "H = 79891.36959 N", False),
             ("12 folds", "13 folds", False), ("868 points", "873 points", True), ("a ... c", "a b b c", True),
             ("a ... c", "a b b c d", False), ("a ...", "b a", False), ("... b", "a b", True), ("a", "a b", False),
             ("closure = 5.6e-14 m", "closure = 1.2e-13 m", True), ("a b", "a\nb", True), ("2.5 m", "2.5 N", False))
    return ["%r and %r" % case[:2] for case in cases if (differs(case[0], case[1], PRECISION) is None) != case[2]]


# --- running

JQ = r"""
import json, re, sys
at = json.loads(sys.stdin.read() or "null") or sys.exit()
for key in re.findall(r"\.(\w+)", sys.argv[1]):
    at = at[key]
print(json.dumps(at))
"""


def tools(folder):
    """A folder for PATH: hawser; jq for paths of keys, where there is none; without HAWSER_LONG a gnuplot that draws
    nothing, and an auto-07p."""
    def script(name, text):
        path = os.path.join(folder, name)
        with open(path, "w") as stream:
            stream.write(text)
        os.chmod(path, 0o755)
    os.mkdir(folder)
    script("hawser", '#!/bin/sh\n[ -z "$STARTED" ] || exec "%s" -IS "%s/started" "$@"\nexec "%s" "$@"\n'
           % (sys.executable, folder, program))
    script("started", "import os, signal, sys\nsignal.setitimer(signal.ITIMER_PROF, %g)\n"
                      "os.execv(%r, sys.argv)\n" % (STARTED, program))
    if not shutil.which("jq"):
        script("jq", "#!%s%s" % (sys.executable, JQ))
    if not long_run:
        script("gnuplot", "#!/bin/sh\necho picture\n")
        script("auto-07p", '#!/bin/sh\ntest -f "$1"\n')


def bare_words(command):
    """The words of a command that is nothing but one start of hawser: it needs no shell."""
    if not command.startswith("hawser ") or re.search(r"[|&;<>$`*?~#()\n]", re.sub(r"'[^']*'|(?<=\w)#(?=\d)", "", command)):
        return None
    return [program] + shlex.split(command)[1:]


def begin():
    signal.setitimer(signal.ITIMER_PROF, STARTED)


def run(command, folder, path, seconds, started=False):
    """Status (None where time was up), output, and the folder in which the command ended."""
    with tempfile.TemporaryFile() as output, tempfile.NamedTemporaryFile("r") as place:
        words = bare_words(command)
        wrapped = "trap 'pwd >\"%s\"' EXIT\n%s" % (place.name, command.replace(INSTALLED, os.path.join(
            source, "notebooks-data/scenes")))
        environment = dict(os.environ, PATH=path + os.pathsep + os.environ["PATH"], LC_ALL="C.UTF-8",
                           STARTED="1" if started else "", OMP_NUM_THREADS="1")
        environment.pop("MAKEFLAGS", None)
        process = subprocess.Popen(words or ["sh", "-c", wrapped], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                   stdout=output, stderr=subprocess.STDOUT, start_new_session=True,
                                   preexec_fn=begin if words and started else None)
        try:
            status = process.wait(seconds)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            status = None
        output.seek(0)
        return status, output.read().decode("utf-8", "replace"), place.read().strip() or folder


def check(name, number, command, shown, folder, path):
    """Runs one command; returns the folder for the next."""
    text = "%s:%d: %s" % (name, number, " ".join(command.split())[:100])
    started = not long_run and bool(re.search(LONG, command) or name == "gallery.md"
                                   or "hawser identify" in command and not any(line.strip() for line in shown))
    if unwritten.intersection(word.split("#")[0] for word in command.split()):
        print("ok %d # SKIP %s" % (len(verdicts) + 1, text))
        verdicts.append(True)
        return folder
    status, printed, place = run(command, folder, path, LIMIT, started)
    word = re.search(r"hawser (\w+)", command)
    if started and (status in (-signal.SIGPROF, 128 + signal.SIGPROF) or "Profiling timer expired" in printed):
        unwritten.update(re.findall(r"--(?:json|tsv|fitted|export auto) (\S+)", command))
        verdict(True, text + " (started)")
        return place
    if status != 0:
        verdict(False, text, ["time is up" if status is None else "exit status %d" % status]
                + printed.split("\n")[:8])
        return place
    why = any(line.strip() for line in shown) and \
        differs("\n".join(shown), printed, ACCURACY.get(word.group(1) if word else "", PRECISION))
    verdict(not why, text, [why] if why else [])
    return place


def copy(folder, target):
    """Without modes: the source tree may be read-only."""
    shutil.copytree(folder, target, copy_function=shutil.copyfile)
    for where, _, _ in os.walk(target):
        os.chmod(where, 0o755)


def prepare(name, text, scratch):
    folder = os.path.join(scratch, name)
    if COPY in " ".join(text.split()):
        copy(os.path.join(source, "notebooks-data/scenes"), folder)
    else:
        os.mkdir(folder)
    return folder


def keep(folder, target):
    """The pictures that a document's commands drew."""
    os.makedirs(target, exist_ok=True)
    for picture in glob.glob(os.path.join(folder, "*.svg")):
        shutil.copyfile(picture, os.path.join(target, os.path.basename(picture)))


def document(path, scratch):
    name = os.path.basename(path)
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    blocks = list((blocks_of_markdown if name.endswith(".md") else blocks_of_manual)(text))
    folder = prepare(name, text, scratch)
    unwritten.clear()
    bare = []
    for start, block in blocks:
        bare += ["%s:%d: %s" % (name, start + i, line) for i, line in enumerate(block)
                 if re.match(r"(\./)?hawser ", line)]
        found = commands(start, block)
        if not found and name == "README.md":
            bare += ["%s:%d: %s" % (name, start + i, line) for i, line in enumerate(block)
                     if line.strip() and not line.startswith(" ") and not ELSEWHERE.match(line)]
        for number, command, shown in found:
            folder = check(name, number, command, shown, folder, os.path.join(scratch, "bin"))
    if bare or name == "README.md":
        verdict(not bare, name + ': every command stands behind "$ "', bare)
    if pictures:
        keep(folder, os.path.join(pictures, name))


def table(name, scratch):
    """The last column of "What is measured" in bench/README.md: commands for the build folder. They are minutes long."""
    build = os.environ.get("BUILDDIR", os.getcwd())
    with open(os.path.join(source, name), encoding="utf-8") as stream:
        text = stream.read()
    for number, line in enumerate(text.split("\n"), 1):
        command = re.search(r"\| `([^`]+)` \|$", line)
        if not command or not long_run:
            continue
        words = command.group(1).replace("FOLDER", os.path.join(scratch, "figures"))
        status, printed, _ = run(words, build, os.path.join(scratch, "bin"), 2*LIMIT)
        verdict(status == 0, "%s:%d: %s" % (name, number, command.group(1)), printed.split("\n")[-8:])


def main():
    pages = glob.glob(os.path.join(source, "man", "*.[1-9]"))
    pages += glob.glob(os.path.join(os.environ.get("MANDIR", "man"), "*.[1-9]"))
    wrong = can_tell()
    verdict(not wrong, "the comparison tells what agrees from what does not", wrong)
    paths = sys.argv[1:] or [os.path.join(source, each) for each in DOCUMENTS] + sorted(set(map(os.path.abspath, pages)))
    with tempfile.TemporaryDirectory(prefix="hawser-shown.") as scratch:
        tools(os.path.join(scratch, "bin"))
        for path in paths:
            document(path, scratch)
        if not sys.argv[1:]:
            table("bench/README.md", scratch)
    print("1..%d" % len(verdicts))


main()

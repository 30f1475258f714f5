#!/bin/sh
# Ctrl-C and SIGTERM end a long run with what there is, marked as such, and leave nothing behind; SIGUSR1
# asks how far it is.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# A shell without job control starts background work with SIGINT ignored; Python puts it back.
if command -v python3 >/dev/null; then
	cat >../check.py <<'END'
import json, os, re, signal, subprocess, sys, time
hawser, number, output = sys.argv[1], getattr(signal, sys.argv[2]), sys.argv[3]

def begin():
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGUSR1, signal.SIG_IGN)  # until the program has its own mind of it

run = subprocess.Popen([hawser] + sys.argv[4:] + ["--json", output], stdout=subprocess.PIPE,
                       stderr=subprocess.PIPE, preexec_fn=begin)
os.set_blocking(run.stderr.fileno(), False)
text, done = "", 0
while done < 20 and run.poll() is None:
    run.send_signal(signal.SIGUSR1)
    time.sleep(0.01)
    text += (run.stderr.read() or b"").decode()
    done = max([0] + [int(n) for n in re.findall(r"(\d+) (?:points|rows)", text)])
os.set_blocking(run.stderr.fileno(), True)
if run.poll() is not None:
    sys.exit("it ended by itself: " + text)
run.send_signal(number)
out, err = run.communicate(timeout=600)
if run.returncode != 128 + number:
    sys.exit("status %d, %s" % (run.returncode, err.decode()))
left = r"(, about \d+ s left(, more than foreseen)?)?"
pattern = rf"frf: (\d+ %, )?\d+ points, \d+ events(, Omega \S+?)?{left}|integrate: (\d+ %, )?\d+ rows{left}"
for line in (text + err.decode()).splitlines():
    assert re.fullmatch(pattern, line), line
result = json.load(open(output))
if "points" in result:
    assert len(result["points"]) >= done and result["end"] == "interrupted", result["end"]
else:
    assert len(result["times"]) >= done and result["end"] == "interrupted", result["end"]
assert b"interrupted" in out, out
assert os.listdir(".") == [output], os.listdir(".")
os.remove(output)
END
	for signal in SIGINT SIGTERM; do
		try "frf, $signal" python3 -S ../check.py "$HAWSER" $signal out.json \
			frf "$chairlift" --step 1e-6 --max-points 100000000
		try "integrate, $signal" python3 -S ../check.py "$HAWSER" $signal out.json \
			integrate "$chairlift" --Omega 0.9w1 --until 1e6T --every 1T
	done
else
	skip "python3 is not installed"
fi
done_testing

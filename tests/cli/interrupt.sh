#!/bin/sh
# Ctrl-C and SIGTERM end a long run with what there is, marked as such, and leave nothing behind.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# A shell without job control starts background work with SIGINT ignored; Python puts it back.
if command -v python3 >/dev/null; then
	cat >../check.py <<'END'
import json, os, signal, subprocess, sys, time
hawser, number, output = sys.argv[1], getattr(signal, sys.argv[2]), sys.argv[3]
run = subprocess.Popen([hawser] + sys.argv[4:] + ["--json", output], stdout=subprocess.PIPE,
                       stderr=subprocess.PIPE,
                       preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
time.sleep(float(os.environ.get("PAUSE", "0.7")))
if run.poll() is not None:
    sys.exit("it ended by itself: " + run.communicate()[1].decode())
run.send_signal(number)
out, err = run.communicate(timeout=60)
if run.returncode != 128 + number:
    sys.exit("status %d, %s" % (run.returncode, err.decode()))
result = json.load(open(output))
if "points" in result:
    assert len(result["points"]) > 1 and result["end"] == "interrupted", result["end"]
else:
    assert len(result["times"]) > 1 and result["end"] == "interrupted", result["end"]
assert b"interrupted" in out, out
assert os.listdir(".") == [output], os.listdir(".")
os.remove(output)
END
	for signal in SIGINT SIGTERM; do
		try "frf, $signal" python3 ../check.py "$HAWSER" $signal out.json \
			frf "$chairlift" --step 1e-6
		try "integrate, $signal" python3 ../check.py "$HAWSER" $signal out.json \
			integrate "$chairlift" --Omega 0.9w1 --until 1e5T --every 1T
	done
else
	skip "python3 is not installed"
fi
done_testing

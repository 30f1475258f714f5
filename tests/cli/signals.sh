#!/bin/sh
# Ctrl-C, SIGTERM and SIGHUP end any command within a second, leave no half-written file, and the status is
# 128 + the signal. Here one command of each kind: one that looks, one that does not, input that does not
# come, and a gnuplot that does not end. With HAWSER_LONG=1 every command.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

command -v python3 >/dev/null || { skip "python3 is not installed"; done_testing; exit; }

# shellcheck disable=SC2016 # of the program
cat >../send.py <<'END'
import json, os, signal, subprocess, sys, time
number, after, files = getattr(signal, sys.argv[1]), float(sys.argv[2]), sys.argv[3].split()

def begin():  # a shell without job control starts background work with SIGINT ignored
    for n in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(n, signal.SIG_DFL)

run = subprocess.Popen(sys.argv[4:], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                       preexec_fn=begin)
def ready():  # it has its handlers, that of SIGALRM among them
    try:
        status = open("/proc/%d/status" % run.pid).read()
    except OSError:
        return True
    caught = [int(line.split()[1], 16) for line in status.splitlines() if line.startswith("SigCgt")]
    return not caught or caught[0] >> signal.SIGALRM - 1 & 1

def waited():  # seconds for which it was ready to run and the machine did something else
    try:
        return int(open("/proc/%d/schedstat" % run.pid).read().split()[1])*1e-9
    except OSError:
        return 0.0

def ended():
    return os.waitid(os.P_PID, run.pid, os.WEXITED | os.WNOWAIT | os.WNOHANG) is not None

until = time.monotonic() + 20
while not ready() and run.poll() is None and time.monotonic() < until:
    time.sleep(0.01)
time.sleep(after)
if run.poll() is not None:
    sys.exit("it ended by itself: %d %s" % (run.returncode, run.stderr.read().decode()))
busy = waited()
run.send_signal(number)
began = time.monotonic()
while not ended():
    if time.monotonic() - began > 20 + waited() - busy:
        run.kill()
        sys.exit("not ended after 20 s")
    time.sleep(0.005)
took = time.monotonic() - began - (waited() - busy)
run.wait()
left = sorted(os.listdir("."))
for name in left:
    if name not in files:
        sys.exit("left behind: " + name)
    if name.endswith(".json"):
        json.load(open(name))
    os.remove(name)
if run.returncode != 128 + number:
    sys.exit("status %d: %s" % (run.returncode, run.stderr.read().decode()))
if left and b"no result is written" in run.stderr.read():
    sys.exit("says that no result is written, and has written " + " ".join(left))
if took > 1:
    sys.exit("it took %.2f s" % took)
print("# %.2f s, %s" % (took, left or "nothing is written"))
END
# ends SIGNAL SECONDS "FILES IT MAY LEAVE" ARGUMENTS
ends() {
	signal=$1
	after=$2
	files=$3
	shift 3
	try "$signal: $(echo "$*" | sed "s|$top/||g")" python3 -S ../send.py "$signal" "$after" "$files" "$HAWSER" "$@"
}
scenes=$top/notebooks-data/scenes

ends SIGINT 0.3 out.json frf "$chairlift" --step 1e-6 --max-points 100000000 --json out.json
ends SIGTERM 0.1 out.json rom "$chairlift" --modes 60 --json out.json
ends SIGHUP 0.2 '' damping -

# The numbers of a result are written though its picture is not.
printf '#!/bin/sh\nexec sleep 30\n' >../slow
chmod +x ../slow
HAWSER_GNUPLOT=$scratch/slow
export HAWSER_GNUPLOT
ends SIGTERM 0.5 out.json statics "$chairlift" --plot out.svg --json out.json
unset HAWSER_GNUPLOT
# A table that nobody reads from standard output is given up; the file has been written before.
ends SIGTERM 0.5 out.json statics "$chairlift" --points 2000 --json out.json --tsv -

if [ -n "${HAWSER_LONG:-}" ]; then
	for signal in SIGINT SIGTERM; do
		ends $signal 0.3 out.json frf "$chairlift" --set model.modes=auto --set model.condense=static \
			--from 0.6w1 --to 12w1 --json out.json
		ends $signal 0.3 out.json integrate "$chairlift" --Omega 0.9w1 --until 1e6T --every 1T --json out.json
		ends $signal 0.3 out.json folds "$chairlift" -n 30 --from 0.6w1 --to 8w1 --json out.json
		ends $signal 0.3 out.json mms "$chairlift" --step 1e-7 --max-points 100000000 --json out.json
		ends $signal 0.3 out.json hill "$scenes/b-table-5.4.yaml" -n 12 --x Omega=0.5w1:9w1 \
			--y travel.fluctuation=0:8 --json out.json
		ends $signal 0.3 out.json map "$scenes/b-table-5.4.yaml" -n 6 --x Omega=0.5w1:5w1 \
			--y travel.fluctuation=0:8 --quantity multiplier --points 500x500 --json out.json
		ends $signal 0.3 '' plan "$chairlift" --set model.modes=auto --json out.json
		ends $signal 0.3 '' irvine "$chairlift" --points 100000 --json out.json
		ends $signal 0.3 '' campbell "$scenes/b-table-5.4.yaml" --points 100000 --json out.json
		ends $signal 0.3 '' beam "$scenes/d-figure-9.1.yaml" --points 100000 --to 10 --json out.json
		ends $signal 0.3 '' modes "$chairlift" -n 300 --basis 600 --json out.json
		ends $signal 0.3 out.json statics "$chairlift" --compatibility --points 100000 --json out.json
		ends $signal 0.3 out.json compare "$chairlift" --json out.json
		ends $signal 0.3 '' compare modes "$chairlift" --json out.json
		ends $signal 0.3 out.json compare mms "$chairlift" --step 1e-7 --json out.json
		ends $signal 0.3 '' rom "$chairlift" --modes 60 --export auto out
		ends $signal 0.3 '' frf - --from 0.6w1 --to 2w1
	done
fi
done_testing

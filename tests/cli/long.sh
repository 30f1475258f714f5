#!/bin/sh
# Long runs in pieces: a curve, a run in time and a map that were ended on their way are continued, and
# are then what they would have been; a checkpoint that somebody has damaged is told.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
cat >../two.json <<'EOF'
{"hawser_rom": 1, "n": 2, "D": [[0.02, 0], [0, 0.03]], "K": [[1, 0], [0, 4.3]],
 "Q": [[0, 0, 1, 0.1], [1, 0, 0, 0.05]],
 "C": [[0, 0, 0, 0, 1.0], [1, 1, 1, 1, 0.7], [0, 0, 1, 1, 0.3], [1, 0, 0, 1, 0.3]],
 "harmonics": [{"k": 1, "phase": "cos", "f": [0.1, 0.05]}]}
EOF
cat >../hill.json <<'EOF'
{"hawser_rom": 1, "n": 2, "D": [[0.02, 0], [0, 0.03]], "K": [[1, 0], [0, 2.3]],
 "harmonics": [{"k": 1, "phase": "cos", "K": [[1, 0.2], [0.2, 1.1]], "f": [0.1, 0.2]}]}
EOF

# --- a curve
curve="frf $duffing --from 0.5 --to 2 --step 0.001"
# shellcheck disable=SC2086 # words
{
works "a curve of a thousand points" $curve --json whole.json
works "its first 300" $curve --max-points 300 --json 0.json
works "300 more" $curve --max-points 300 --json 1.json --continue 0.json
works "300 more, with the fold between" $curve --max-points 300 --json 2.json --continue 1.json
works "and to the end" $curve --json 3.json --continue 2.json
refuses 1 "--continue 3.json: that curve is complete (end of the range): begin another one" \
	$curve --continue 3.json
refuses 1 "--continue does not go with --start: leave out one of them" \
	$curve --continue 0.json --start 1.json
refuses 1 "--continue does not go with --at: leave out one of them" \
	$curve --continue 0.json --at 1
refuses 1 "--continue - and the input - are both standard input: give one of them as a file" \
	frf - --continue -
refuses 1 "--continue $duffing: that is no result of hawser frf with a state to go on from, as --json \
writes it" $curve --continue "$duffing"
refuses 1 "cannot read nothing.json: No such file or directory" $curve --continue nothing.json
sed 's/"K": \[\[1,/"K": [[1.0001,/' ../two.json >../stiffer.json
works "a curve of two coordinates" frf ../two.json --from 0.9 --to 1.3 --max-points 20 --json two.json
refuses 1 "--continue two.json: that is a result of another model, with another value of natural \
frequencies; --start begins anew from its last state" frf ../stiffer.json --continue two.json
works "a curve of the chairlift" frf "$chairlift" --max-points 20 --json c.json
refuses 1 "--continue c.json: that is a result of another scene, with another value of damping.alpha; \
--start begins anew from its last state" frf "$chairlift" --set damping.alpha=0.1 --continue c.json
works "the same scene from elsewhere" frf "$chairlift" --set model.modes=5 --max-points 5 --continue c.json
refuses 1 "0.json: its last state is not one of this model; a state of this model is 4 numbers, u_1 to \
u_2 and then their velocities" frf ../two.json --continue 0.json
refuses 1 "--continue 0.json: a state has as many coordinates as the model, and model.modes: auto makes \
several; give a number of modes" frf "$chairlift" --set model.modes=auto --set model.condense=static \
	--continue 0.json
}
python "pieces join, and have the events of the whole" <<'END'
import json
piece = [json.load(open("%d.json" % k)) for k in range(4)]
whole = json.load(open("whole.json"))
assert len(whole["points"]) > 1000, len(whole["points"])
assert [p["end"] for p in piece] == 3*["max-points"] + ["end of the range"]
for a, b in zip(piece, piece[1:]):
    assert abs(a["points"][-1]["Omega"] - b["points"][0]["Omega"]) < 1e-14
    assert max(abs(x - y) for x, y in zip(a["points"][-1]["state"], b["points"][0]["state"])) < 1e-8
    assert a["points"][-1]["unstable"] == b["points"][0]["unstable"]
    # on, not back
    assert (b["points"][1]["Omega"] - b["points"][0]["Omega"])*a["direction"] > 0
events = [e for p in piece for e in p["events"]]
assert [e["kind"] for e in events] == [e["kind"] for e in whole["events"]] == ["fold", "fold"]
assert all(abs(a["Omega"]/b["Omega"] - 1) < 1e-9 for a, b in zip(events, whole["events"]))
assert [p["direction"] for p in piece] == [1, -1, 1, 1], "cut between the folds too"
END

# --- a run in time
for method in gauss adams bdf; do
	# shellcheck disable=SC2086 # words
	{
	run="integrate ../two.json --Omega 1.1 --method $method --every 1T"
	works "$method through" $run --until 60T --json whole.json
	works "$method, part" $run --until 23T --json part.json
	works "$method, on" $run --until 60T --json rest.json --continue part.json
	}
	python "$method: the same rows" <<'END'
import json
whole, part, rest = (json.load(open(name + ".json")) for name in ("whole", "part", "rest"))
assert part["times"][:-1] + rest["times"] == whole["times"], "to the last bit"
assert part["states"][-1] == rest["states"][0] and len(part["times"]) == 24
size = [max(abs(s[k]) for s in whole["states"]) for k in range(4)]
off = max(abs(a - b)/m for x, y in zip(part["states"][:-1] + rest["states"], whole["states"])
          for a, b, m in zip(x, y, size))
assert off < {"gauss": 1e-10, "adams": 1e-7, "bdf": 1e-6}[whole["method"]], off
END
done
refuses 1 "--continue part.json: that run has Omega = 1.1, and this one would have 1.2; --initial starts from \
its last state anew" integrate ../two.json --Omega 1.2 --continue part.json
refuses_like 1 'the run begins at t = 131\.[0-9]*: that must not be negative, and before its end' \
	integrate ../two.json --Omega 1.1 --until 20T --continue part.json
refuses 1 "--initial does not go with --continue: leave out one of them" \
	integrate ../two.json --Omega 1.1 --continue part.json --initial part.json
refuses 1 "--continue 0.json: that is no result of hawser integrate with a state to go on from, as --json \
writes it" integrate ../two.json --Omega 1.1 --continue 0.json
works "the last point of a curve is a state too" frf ../two.json --from 1 --to 1.1 --json end.json
works "to start from" integrate ../two.json --Omega 1.1 --until 30T --every 1T --initial end.json --json on.json
python "which is periodic" <<'END'
import json
states = json.load(open("on.json"))["states"]
assert max(abs(a - b) for s in states for a, b in zip(s, states[0])) < 1e-7
END

# a cable that is slowed down for 4 s: cut before that is over, and after
sed 's/^  fluctuation:.*//' "$top/notebooks-data/scenes/b-table-5.4.yaml" >../brake.yaml
run="integrate ../brake.yaml --set travel.braking=4 --every 0.5 --Omega 1 -n 3"
# shellcheck disable=SC2086 # words
works "braking, through" $run --until 5 --json whole.json
for cut in 2.5 4.5; do
	# shellcheck disable=SC2086 # words
	{
	works "braking, to $cut s" $run --until $cut --json part.json
	works "braking, on" $run --until 5 --json rest.json --continue part.json
	}
	refuses 1 "--continue part.json: that is a result of another scene, with another value of \
travel.braking; --initial begins anew from its last state" $run --set travel.braking=7 --continue part.json
	python "braking: the same motion" <<'END'
import json
whole, part, rest = (json.load(open(name + ".json")) for name in ("whole", "part", "rest"))
assert part["times"][:-1] + rest["times"] == whole["times"]
states, energy = part["states"][:-1] + rest["states"], part["energy"][:-1] + rest["energy"]
# the absolute tolerance, 1e-13, is of the length: 8e-12 m; 5e-12 m/s
assert max(abs(a - b) for x, y in zip(states, whole["states"]) for a, b in zip(x, y)) < 1e-11
assert max(abs(a - b) for a, b in zip(energy, whole["energy"])) < 1e-7*max(map(abs, whole["energy"]))
END
done

# --- a checkpoint in wrong hands
map="map ../hill.json --x Omega=0.8:4 --y factor.load=0:0.5 --points 25x19 --quantity multiplier --reproducible"
# shellcheck disable=SC2086 # words
{
works "a map" $map --tsv whole.tsv --json whole.json
works "the same with a checkpoint" $map --tsv again.tsv --checkpoint kept
try "gives the same bytes" cmp whole.tsv again.tsv
lines=$(grep -c '' kept)
head -n $((lines/2)) kept >half
for cut in 1 7 40; do
	cp half kept
	printf '0 1 3ff0000000000000 3ff0000000000000 3ff0000000000000' | head -c $cut >>kept
	works "a last line of $cut bytes" $map --tsv again.tsv --json again.json --checkpoint kept
	try "is computed again: the same table" cmp whole.tsv again.tsv
	try "and JSON" cmp whole.json again.json
	sort kept >sorted
	try "of each point once" test "$(sort -u sorted | grep -c '')" -eq "$lines"
done
: >kept
works "an empty checkpoint is a new one" $map --tsv again.tsv --checkpoint kept
try "the same again" cmp whole.tsv again.tsv
head -c 30 half >kept
works "so is one that ends within its head" $map --tsv again.tsv --checkpoint kept
try "the same still" cmp whole.tsv again.tsv
sed '100s/ [0-9a-f]/ x/' half >kept
cp kept bad
refuses 4 "the checkpoint kept is damaged in line 100: remove it" $map --checkpoint kept
try "and is left as it was" cmp bad kept
sed '1s/settings ./settings x/' half >kept
refuses_like 1 'kept (is no checkpoint of a map|belongs to another map)' $map --checkpoint kept
}
# a lock goes with the process that has it, however that ends
if command -v python3 >/dev/null; then
	cat >../lock.py <<'END'
import fcntl, os, signal, subprocess, sys
holder = subprocess.Popen([sys.executable, "-c", "import fcntl, time; f = open('half', 'a'); "
    "fcntl.flock(f, fcntl.LOCK_EX); print('has it', flush=True); time.sleep(600)"], stdout=subprocess.PIPE)
holder.stdout.readline()
run = lambda: subprocess.run(sys.argv[1:] + ["--checkpoint", "half"], stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE)
second = run()
assert second.returncode == 4 and second.stderr == (b"hawser: the checkpoint half is in use by another map "
    b"that is being computed: wait for it, or name another file\n"), second.stderr
assert second.stdout == b""
holder.kill()
holder.wait()
third = run()
assert third.returncode == 0, third.stderr
END
	# shellcheck disable=SC2086 # words
	try "a checkpoint that is in use is refused; a killed owner's is not" python3 -S ../lock.py "$HAWSER" $map \
		--tsv again.tsv
	try "and the map is the same" cmp whole.tsv again.tsv
	# progress where standard error is a terminal, and nothing where it is not
	cat >../terminal.py <<'END'
import os, pty, subprocess, sys
master, slave = pty.openpty()
run = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=slave)
os.close(slave)
text = b""
try:
    while True:
        piece = os.read(master, 65536)
        if not piece:
            break
        text += piece
except OSError:
    pass
assert run.returncode == 0
lines = text.split(b"\r\x1b[K")
assert lines[0] == b"" and lines[-1] == b"" and len(lines) > 2, lines
assert lines[1].startswith(sys.argv[2].encode() + b": "), lines
END
	for command in "$curve" "integrate ../two.json --Omega 1.1" "$map"; do
		if terminals; then
			# shellcheck disable=SC2086 # words
			try "${command%% *}: progress on a terminal" python3 -S ../terminal.py "$HAWSER" $command
		else
			skip "${command%% *}: progress on a terminal: $no_terminal"
		fi
	done
else
	skip "python3 is not installed"
fi
works "a slow sweep" integrate "$chairlift" --Omega 0.8w1 --Omega-to 0.9w1 --until 20T --every 0.5T --json swept.json \
	--tsv swept.tsv -q
python "its frequency" <<'END'
import json
r = json.load(open("swept.json"))
rows = [l.split("\t") for l in open("swept.tsv") if l[0] != "#"]
k = rows[0].index("Omega_rad_s")
assert float(rows[1][k]) == r["Omega"] and abs(float(rows[-1][k])/r["Omega_to"] - 1) < 1e-12
assert abs(r["Omega_to"]/r["Omega"] - 9/8) < 1e-9
END
refuses 1 "--continue swept.json: that run is a sweep, and its phase of the forcing is not known; --initial starts from its last state anew" \
	integrate "$chairlift" --Omega 0.8w1 --until 40T --continue swept.json
refuses 1 "--Omega-to needs --Omega FREQUENCY: give that" integrate "$chairlift" --Omega-to 0.9w1
refuses 1 "--Omega-to does not go with --spectrum: leave out one of them" \
	integrate "$chairlift" --Omega 0.8w1 --Omega-to 0.9w1 --spectrum
refuses 1 "--Omega-to 9 does not go with a travel speed that changes" \
	integrate "$top/notebooks-data/scenes/b-table-5.4.yaml" --Omega 5 --Omega-to 9
python "a harmonic load as a table" <<'END'
import math
Omega = 1.3
with open("load.tsv", "w") as f:
    f.write("t_s\te_N_m\tn_N_m\tz_N_m\n")
    for i in range(1001):
        p = 0.8*math.cos(Omega*0.02*i)
        f.write("%r\t%r\t%r\t%r\n" % (0.02*i, p, p, p))
END
raw="integrate $chairlift --set model.condense=none --every 0.5 --until 20"
works "a harmonic load" $raw --Omega 1.3 --json harmonic.json -q
works "and the same by a table" $raw --load load.tsv --json table.json -q
python "have the same motion" <<'END'
import json
a, b = (json.load(open(n + ".json")) for n in ("harmonic", "table"))
size = max(max(map(abs, s)) for s in a["states"])
assert len(a["states"]) == len(b["states"]) == 41 and b["Omega"] == 0
assert all(abs(x - y) < 1e-6*size for s, t in zip(a["states"], b["states"]) for x, y in zip(s, t))
END
works "at full order too" integrate "$chairlift" --set model.energy=exact --set model.basis=4 --load load.tsv --until 5 \
	--every 1 -q
refuses 1 "--load load.tsv replaces the harmonic load: leave out --Omega" $raw --Omega 1.3 --load load.tsv
refuses_like 1 "the history of the load from 0 to 20 s: end the run before it" $raw --until 21 --load load.tsv
refuses_like 1 "does not go with modes: auto" $raw --set model.modes=auto --load load.tsv
refuses_like 1 "does not go with a reduced-model file" integrate ../two.json --load load.tsv
refuses_like 1 "does not go with a travel speed that changes" \
	integrate "$top/notebooks-data/scenes/b-table-5.4.yaml" --load load.tsv
printf 't_s x_N_m\n0 1\n1 2\n' >bad.tsv
refuses 1 "bad.tsv: unknown column x_N_m: the columns can be t_s, e_N_m, n_N_m, z_N_m" $raw --load bad.tsv
printf 't_s\n0\n1\n' >bad.tsv
refuses_like 1 "bad.tsv needs a line of names above the numbers, with t_s and one or more" $raw --load bad.tsv
printf 't_s z_N_m\n0 1\n' >bad.tsv
refuses 1 "bad.tsv: give two rows or more" $raw --load bad.tsv
printf 't_s z_N_m\n0 1\n0 2\n' >bad.tsv
refuses_like 1 "the history has the time 0 in row 2: times must ascend" $raw --load bad.tsv
done_testing

#!/bin/sh
# hawser frf --over: motions followed in a parameter at one frequency.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

pair="$SRCDIR/tests/reference/pair-2to1.json"
works "over the load" frf "$pair" --over factor.load=0.05:1.5 --Omega 1.01 --json load.json --tsv load.tsv -q
works "a cable over its tension" frf "$chairlift" -n 3 --over "tension.T0=70 kN:73 kN" --Omega 1.42 --tolerance 1e-7 --step 0.1 \
	--set model.condense=static --json tension.json --tsv tension.tsv --plot tension.svg -q
python "the events are those of responses at their parameter, the table has the column" <<'END'
import json
load, tension = json.load(open("load.json")), json.load(open("tension.json"))
assert load["over"] == {"key": "factor.load", "unit": "", "from": 0.05, "to": 1.5}, load["over"]
assert tension["over"] == {"key": "tension.T0", "unit": "N", "from": 70e3, "to": 73e3}, tension["over"]
assert [e["kind"] for e in load["events"]] == ["fold", "fold", "torus"]
assert [e["kind"] for e in tension["events"]] == ["fold"]
for result in load, tension:
    assert len({p["Omega"] for p in result["points"]}) == 1
    assert all(abs(e["bracket"][0]/e["parameter"] - 1) < 0.1 for e in result["events"])
assert load["end"] == "end of the range" and tension["end"] == "returned", (load["end"], tension["end"])
assert abs(load["points"][-1]["parameter"]/1.5 - 1) < 1e-9
rows = [line.split("\t") for line in open("tension.tsv") if not line.startswith("#")]
assert rows[0][:2] == ["parameter", "Omega_rad_s"], rows[0]
assert float(rows[1][0]) == 70e3
assert any("event: fold at tension.T0 = " in line and " N (" in line for line in open("tension.tsv"))
assert "Tension at end A" in open("tension.svg").read()
fold = tension["events"][0]["parameter"]
open("fold", "w").write(f"tension.T0={fold!r}")
END
rough "the response at the tension of the fold" frf "$chairlift" -n 3 --set "$(cat fold)" --set model.condense=static --set model.inertia=none --set model.energy=quartic \
	--from 1.48 --to 1.41 --json response.json -q
python "has a fold at this frequency" <<'END'
import json
events = json.load(open("response.json"))["events"]
assert min(abs(e["Omega"]/1.42 - 1) for e in events if e["kind"] == "fold") < 1e-6, events
END

refuses 1 "--over factor.load=1:2 follows the motion at one frequency: give it with --Omega" \
	frf "$pair" --over factor.load=1:2
refuses 1 "--Omega needs --over KEY=FROM:TO: give that" frf "$pair" --Omega 1
refuses 1 "--over does not go with --from: leave out one of them" \
	frf "$pair" --over factor.load=1:2 --Omega 1 --from 0.5
refuses 1 "--over factor.size: write factor.load, factor.damping or a key of the scene; Omega is followed without --over" \
	frf "$pair" --over factor.size=1:2 --Omega 1
refuses 1 "--over cable.EA: this reduced-model file has the parameters factor.load and factor.damping only: give the scene, or \
name parameters in the file" \
	frf "$pair" --over cable.EA=1:2 --Omega 1
refuses 1 "--over model.modes: settings of the model are no parameters of the cable: hawser compare compares models" \
	frf "$chairlift" --over model.modes=2:5 --Omega 1
refuses 1 "--over: model.modes: auto chooses for a range of frequencies: give a number of modes with -n" \
	frf "$chairlift" --over tension.T0=1:2 --Omega 1 --set model.modes=auto
refuses 1 "motions are followed in a parameter by harmonic balance, or by shooting: leave out --method" \
	frf "$pair" --over factor.load=1:2 --Omega 1 --method multiple-scales
refuses_like 1 "tension.T0 as a parameter needs a model of a given number of modes" \
	frf "$chairlift" --over tension.T0=7e4:8e4 --Omega 1 --set model.energy=exact --set model.basis=3
refuses_like 1 "there is no key tension.X" frf "$chairlift" --over tension.X=1:2 --Omega 1
refuses_like 1 "must be finite and different" frf "$pair" --over factor.load=1:1 --Omega 1
done_testing

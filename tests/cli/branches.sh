#!/bin/sh
# hawser frf --branches: the branches that begin at bifurcations.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

cat >cascade.json <<'END'
{"n": 1, "K": [[1]], "D": [[0.4]], "Q": [[0, 0, 0, -1]], "harmonics": [{"k": 1, "phase": "cos", "f": [0.25]}]}
END
cat >string.json <<'END'
{"n": 2, "K": [[1, 0], [0, 1.02]], "D": [[0.02, 0], [0, 0.02]],
 "C": [[0, 0, 0, 0, 0.5], [0, 0, 1, 1, 0.5], [1, 1, 1, 1, 0.5], [1, 0, 0, 1, 0.5]],
 "harmonics": [{"k": 1, "phase": "cos", "f": [0.03, 0]}]}
END
works "a cascade" frf cascade.json --from 1.6 --to 0.7 --step 0.01 --branches 2 --json cascade-frf.json --tsv c.tsv \
	--plot c.svg -q
works "whirling" frf string.json --from 0.9 --to 1.4 --branches 1 --json string-frf.json -q
works "by harmonic balance" frf string.json --from 0.9 --to 1.4 --branches 1 --method balance --json balance.json -q
works "none" frf string.json --from 0.9 --to 1.4 --json plain.json -q
python "periods, parents, and where they begin" <<'END'
import json
cascade, string, balance, plain = (json.load(open(name)) for name in
                                   ("cascade-frf.json", "string-frf.json", "balance.json", "plain.json"))
born = [b for b in cascade["branches"] if "parent" in b]
assert [(b["period"], b["parent"]) for b in born] == [(2, 1), (4, 2)], [(b["period"], b["parent"]) for b in born]
assert born[0]["born"] == cascade["events"][0]["Omega"] and born[1]["born"] == born[0]["events"][0]["Omega"]
for b in born:
    assert abs(b["points"][0]["Omega"]/b["born"] - 1) < 1e-3 and b["points"][0]["stable"]
assert "branches" not in plain and not any("period" in b for b in plain.get("branches", []))
for result in string, balance:
    whirl = [b for b in result["branches"] if "parent" in b][0]
    assert whirl["period"] == 1 and max(p["coordinates"][1] for p in whirl["points"]) > 0.5
    assert abs(whirl["born"] - result["events"][0]["Omega"]) < 1e-9
    assert max(p["Omega"] for p in whirl["points"]) > 1.18
ends = [e["Omega"] for e in string["events"] if e["kind"] == "branch-point"]
assert any(abs(e["Omega"] - ends[1]) < 1e-4 for e in string["branches"][0]["events"])
assert abs(string["branches"][0]["born"] - balance["branches"][0]["born"]) < 1e-8
rows = [line.rstrip("\n").split("\t") for line in open("c.tsv") if not line.startswith("#")]
assert rows[0][-1] == "branch" and {r[-1] for r in rows[1:]} == {"1", "2", "3"}
assert sum("of period 4, from branch 2 at Omega = " in line for line in open("c.tsv")) == 1
END
refuses 1 "--over factor.load=1:2 follows one motion at one frequency: leave out --branches" \
	frf cascade.json --over factor.load=1:2 --Omega 1 --branches 1
refuses_like 1 "--branches" frf cascade.json --branches -1
done_testing

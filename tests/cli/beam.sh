#!/bin/sh
# hawser beam: what it prints, writes and warns of.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scenes=$top/notebooks-data/scenes
cd "$scratch" || exit 1

# key FILE NAME: the first number of that name
key() {
	tr ',' '\n' <"$1" | sed -n "s/.*\"$2\": *\\([^ }]*\\).*/\\1/p" | head -n 1
}
near() {
	awk -v a="$1" -v b="$2" -v e="$3" 'BEGIN { d = a - b; exit !((d < 0 ? -d : d) <= e) }'
}

works "eigenvalues" beam "$scenes/d-figure-9.9.yaml" -q --json r.json
try "v_crit of D 9.4" near "$(key r.json v_crit)" 10.2322 5e-5
try "and v_bif" near "$(key r.json v_bif)" 10.2322 5e-5
try "eigenvalues are there" grep -q '"eigenvalues"' r.json
works "sweep" beam "$scenes/second-stable-region.yaml" -q --from 20.5 --to 21.5 --points 5 -n 4 --tsv s.tsv
try "the region above the divergence is stable" grep -q '^# calm at v = 20.96374054' s.tsv
try "up to the flutter" grep -q '^# flutter at v = 21.2787890' s.tsv
run beam "$scenes/d-figure-9.8.yaml" -q --boundary beam.theta --from 0.4 --to 0.5 --points 2 --tsv b.tsv
try "it ends where the column buckles" grep -q '^# left end: at 0.44381043.* reaches speed 0' b.tsv
run beam "$scenes/d-figure-9.11.yaml" -q --set beam.v=2.38723 --until 40 --tolerance 1e-5 --json m.json
try "grows at 0.068, as D 9.5 has it" near "$(key m.json growth)" 0.068 1e-3
printf '0 0\n0.5 0.02\n1 0\n' >shape
works "motion from a file" beam "$scenes/d-figure-9.10.yaml" -q --until 1 --every 0.1 --initial shape --tsv f.tsv
try "it begins there" awk '!/^#/ && $1 == 0 { d = $2 - 0.02; exit !(d < 1e-3 && d > -1e-3) }' f.tsv
run beam "$scenes/d-figure-9.1.yaml" -q
try "a slack lower end is told" grep -q 'lower end is slack' "$scratch/err"
works "a rope in SI" beam "$scenes/hoist-rope.yaml" -q --basis 24 --json h.json
try "its speed is below that of its waves" near "$(key h.json v_crit)" 66.4 0.5
run beam "$scenes/hoist-rope.yaml" --basis 24 --set 'beam.inclination=30 degrees' --set 'beam.EI=2 kN.m^2'
try "inclined: what lies across is told" grep -q 'weight across the travel' "$scratch/out"
works "map" map "$scenes/d-figure-9.2.yaml" -q --x beam.mu=0.9:1.1 --y beam.v=0.5:4 --points 3x9 \
	--boundary edge.tsv --tsv map.tsv
try "its boundary passes through v_crit at mu 1" awk -F '\t' '!/^#/ && $1 == 1 { d = $2 - 2.38712;
	if (d < 0) d = -d; if (d < 5e-4) found = 1 } END { exit !found }' edge.tsv
try "growth is scaled, as the beam" grep -q "^beam.mu	beam.v	growth	" map.tsv
run map "$scenes/d-figure-9.2.yaml" --x beam.mu=0.9:1.1 --y beam.v=0.5:4 --quantity multiplier
try "a beam has no multipliers" test "$status" -eq 1
run map "$scenes/d-figure-9.2.yaml" --x beam.mu=0.9:1.1 --y Omega=0.5:4
try "nor a forcing" test "$status" -eq 1
works "plan" plan "$scenes/hoist-rope.yaml"
try "plan tells the conversion" grep -q 'theta = 2.08333' "$scratch/out"
done_testing

#!/bin/sh
# AUTO-07p runs the exported equations as they are and finds the events that are known of the models.
# One quick model always; all of them, at default settings, with HAWSER_LONG=1.
# SPDX-License-Identifier: GPL-3.0-or-later
here=$PWD
. "$(dirname "$0")/../checks/lib.sh"

export_auto=$here/tests/reference/rom-auto-export
OMP_NUM_THREADS=1
export OMP_NUM_THREADS

# run MODEL FROM TO [TOLERANCE NTST]: AUTO's table of special points in $scratch/points, "LP 1.2696...".
run() {
	model=$SRCDIR/tests/reference/$1.json
	name=$(echo "$1" | tr -c 'a-z0-9\n' _)
	shift
	try "$name: exported" "$export_auto" "$model" "$scratch/$name" "$@"
	try "$name: AUTO runs it" sh -c "cd '$scratch' && auto-07p $name.auto"
	[ -f "$scratch/b.$name" ] || echo '' >"$scratch/b.$name"
	# Columns of b.NAME: branch, point, type (5 fold, 6 branch point, 7 doubling, 8 torus), label,
	# Omega; header lines have branch 0.
	awk '$1 != 0 { t = $3 % 10; n = t == 5 ? "LP" : t == 6 ? "BP" : t == 7 ? "PD" : t == 8 ? "TR" : ""
		if (n != "") printf "%s %.9f\n", n, $5 }' "$scratch/b.$name" >"$scratch/points"
	awk '$1 != 0 { last = $5 } END { print last }' "$scratch/b.$name" >"$scratch/last"
}

# finds TYPE OMEGA TOLERANCE: relative, in Omega.
finds() {
	cp "$scratch/points" "$scratch/why"
	awk -v type="$1" -v want="$2" -v tolerance="$3" '
		$1 == type && ($2 - want)^2 <= (tolerance*want)^2 { found = 1 } END { exit !found }' \
		"$scratch/points"
	verdict $? "$name: $1 at $2 within $3"
}

# reaches OMEGA: the branch came to the end of the range.
reaches() {
	try "$name: reaches $1" awk -v end="$1" '{ past = $1 >= end } END { exit !past }' "$scratch/last"
}

if ! command -v auto-07p >/dev/null || ! command -v gfortran >/dev/null; then
	skip "auto-07p or gfortran is not installed"
	done_testing
	exit 0
fi

# The numbers are NLvib's examples and independent computations, to nine digits.
run duffing-nlvib-01 1.0 1.5 1e-8 30
finds LP 1.269601956 1e-6
finds LP 1.115700252 1e-6
reaches 1.5

if [ -n "${HAWSER_LONG:-}" ]; then
	run pair-2to1 0.55 1.3
	for omega in 0.957464503 1.037806516 1.078209077 0.608382792; do
		finds LP $omega 1e-6
	done
	finds TR 0.987743365 1e-6
	finds TR 1.009666609 1e-6
	finds BP 0.72351 1e-4
	reaches 1.3
	run springs-nlvib-06-f1e-3 1.05 1.2
	finds LP 1.127342667 1e-6
	finds LP 1.128546849 1e-6
	reaches 1.2
	run springs-nlvib-06-f3e-3 1.0 1.2
	finds LP 1.087926618 1e-6
	finds LP 1.122991807 1e-6
	finds PD 1.098891783 1e-6
	finds PD 1.094506527 1e-6
	reaches 1.2
	# u^5, u'^3, u^2 u' and a modulated u^3: the folds of hawser frf, by balance and by shooting
	run pair-quintic 0.8 1.6
	finds LP 1.368591832 1e-8
	finds LP 1.150078835 1e-8
	reaches 1.6
fi
done_testing

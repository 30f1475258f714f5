#!/bin/sh
# bench/defaults.sh HAWSER SCENE...: hawser frf with all defaults on each of these scenes, at most LIMIT (120) seconds of
# processor time each. A line a scene: its seconds, "limit" where it took them all, exit status, how the curve ended, and the
# first warning. Scenes that frf does not take are left out.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
hawser=$1
shift
limit=${LIMIT:-120}
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
export OPENBLAS_NUM_THREADS=1
for scene; do
	name=$(basename "$scene" .yaml)
	(
		ulimit -t "$limit"
		"$hawser" frf "$scene" -q >"$scratch/out" 2>"$scratch/err"
		echo $? >"$scratch/status"
		times >"$scratch/times"
	) 2>/dev/null
	status=$(cat "$scratch/status" 2>/dev/null || echo killed)
	[ "$status" != 1 ] || continue
	seconds=$(sed -n '2s/^\([0-9]*\)m\([0-9.]*\)s.*/\1 \2/p' "$scratch/times" | awk '{ printf "%.1f", 60*$1 + $2 }')
	[ "$status" -lt 128 ] || status="$status limit"
	printf '%-28s %6s s  status %s  %s  %s\n' "$name" "$seconds" "$status" \
		"$(sed -n 's/^# end: \([^-]*[a-z]\) - .*/\1/p' "$scratch/out" | head -1)" "$(head -1 "$scratch/err" | cut -c1-160)"
	rm -f "$scratch/status" "$scratch/times"
done

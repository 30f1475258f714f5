#!/bin/sh
# tests/cli/kinds-units.sh - each kind of scenes in each command that hawser check lists for it, with a key set, in SI and with
# --units: no column or comment stays in SI, JSON does. kinds.sh sets a key that is not there.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

units=kN,ft,Hz,lb
# What columns and comments must not end with; J and W: a length and a force are chosen.
cat >"$scratch/in-si.awk" <<'END'
BEGIN {
	column = "_((N|J|W|kg|rad_s)|([A-Za-z]*_)?m(_s[2-4]?)?|1_m|kg_m(_s|[23])?|Nms?|Ns(_m)?|Nm_per_m|Nm2|rad_s_m2)$"
	number = "[0-9][])]* (N|J|W|kg|m|rad/s|m/s|m/s\\^[2-4]|1/m|N/m|kg/m|kg/m/s|kg/m\\^[23]|N[. ]m|N[. ]m/s|N[. ]s|N[. ]m[. ]s|rad/s/m\\^2)([ ,;:).]|$)"
}
# a number of a mode is no frequency
/^#/ { if ($0 ~ number || $0 ~ /mode [0-9]+\.[0-9]+[,:;]/) { print; bad = 1 } next }
{ for (i = 1; i <= NF; i++) if ($i ~ column) { print $i; bad = 1 } exit }
END { exit bad }
END
no_si() {
	awk -F '\t' -f "$scratch/in-si.awk" us.tsv
}

# options KIND COMMAND: so that it is fast; "-": left out, as it
# - needs another file: damping, identify (units.sh has them), compare mms (its table has numbers without a unit alone), or has times for results: compare modes;
# - computes what frf does, for longer: folds, locus (a fold is to be found first), mms, orbit, hill, map, compare of models and motions, and all
#   but rom and nnm of the model of a ropeway (5 to 40 s), whose fields are those of a span's;
# - has the fields of another kind, for longer: irvine of a travelling cable, plan of one at rest;
# - does not take the scene of init as it is (frf of a travelling cable: no load; tow: no EA), or has no JSON (plan of a ropeway).
options() {
	case $2-$1 in
		damping-* | identify-* | compare_mms-* | compare_motion-* | compare_modes-* | folds-* | locus-* | mms-* | orbit-* | hill-* | map-* | compare-*) echo - ;;
		integrate-ropeway | frf-ropeway | irvine-travelling | plan-cable | frf-travelling | tow-tow | plan-ropeway | plan-beam) echo - ;;
		integrate-net) echo '--until 0.2 --every 0.1' ;;
		integrate-rod) echo '--until 0.02 --every 0.01 --no-error --set "rod.inertia=[8e-5,4e-5,4e-5]"' ;;
		integrate-*) echo '--Omega 0.9w1 --until 1T --every 0.5T -n 1' ;;
		frf-net) echo '--from 0.9w1 --to 0.91w1 -n 1 --max-points 2 --set "loads.J={force: [0, 0, 1], harmonic: {multiple: 1}}"' ;;
		frf-*) echo '--from 0.9w1 --to 0.91w1 -n 1 --max-points 2' ;;
		nnm-*) echo '-n 1 --max-points 3' ;;
		rom-*) echo '-n 1' ;;
		modes-*) echo '-n 2' ;;
		irvine-*) echo '-n 1 --points 2' ;;
		campbell-*) echo '-n 1 --points 2 --to 1' ;;
		plan-travelling) echo '--limit 0.01 --fidelities "raw 1"' ;;
		transient-ropeway) echo '--pass p1' ;;
		*) ;;
	esac
}
# tables KIND COMMAND: further tables, a line each.
tables() {
	case $2-$1 in
		statics-cable) printf '%s\n' --models --compatibility '--model fe' ;;
		statics-travelling) echo '--speeds --points 3' ;;
		statics-net) printf '%s\n' --profile '--equilibria 5 --set cables.left.elements=1 --set cables.right.elements=1' ;;
		statics-obstacles) echo --spans ;;
		statics-ropeway) printf '%s\n' --profile --spans --cases '--worst --phases 2' ;;
		modes-cable) printf '%s\n' '-n 2 --damped' '-n 1 --set cable.EI=20' ;;
		*) ;;
	esac
}
# key KIND: one of its keys and a value.
key() {
	case $1 in
		cable | travelling) echo g=9.8 ;;
		beam) echo beam.L=3.1 ;;
		net) echo cables.left.rho=3 ;;
		obstacles) echo cable.rho=3.9 ;;
		ropeway) echo ropeway.rope.rho=3.9 ;;
		rod) echo rod.rho=3 ;;
		tow) echo tow.speed=20 ;;
	esac
}

# in_units NAME COMMAND... : that command in SI and in units.
in_units() {
	name=$1
	shift
	rm -f si.json us.json us.tsv
	run "$@" --json si.json --reproducible -q
	run "$@" --units "$units" --json us.json --tsv us.tsv --reproducible -q
	try "$name" said 0 loud
	for file in si us; do # what it says of the columns of the table is in its units
		sed '/"columns": \[/,/^ *\]/d' $file.json >$file-numbers
	done
	try "  JSON in SI" cmp si-numbers us-numbers
	try "  neither columns nor comments" no_si
}

kinds=$("$HAWSER" init --help | sed -n '1s/^[^[]*\[\([a-z|]*\)\].*/\1/p' | tr '|' ' ')
kinds=${kinds%% stay*} # structures are of these kinds
for kind in $kinds; do
	"$HAWSER" init "$kind" >scene.yaml
	"$HAWSER" check scene.yaml 2>/dev/null | sed -n 's/^commands that take it: //p' | tr ' ' _ | sed 's/,_/\n/g' >takers
	try "$kind: commands" test -s takers
	set=$(key "$kind")
	while read -r command <&3; do
		words=$(echo "$command" | tr _ ' ')
		small=$(options "$kind" "$command")
		[ "$small" = - ] && continue
		eval "in_units \"$kind: $words\" $words scene.yaml $small --set $set"
		tables "$kind" "$command" >more
		while read -r option <&4; do
			eval "in_units \"$kind: $words $option\" $words scene.yaml $option --set $set"
		done 4<more
	done 3<takers
done
done_testing

#!/bin/sh
# Colour of messages and of hawser check: on terminals alone. SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

escape=$(printf '\033')
unset NO_COLOR CLICOLOR CLICOLOR_FORCE
export TERM=xterm
printf 'cable: {EA: 400 MN, rho: 6 kg/m}\nspan: {d: 250 m, hh: 10 m}\n' >bad.yaml

run check bad.yaml
try "no colour in a pipe" sh -c "! grep -q '$escape' '$scratch/err'"
try "the message" grep -q '^hawser: bad.yaml:2:.*hh' "$scratch/err"
export CLICOLOR_FORCE=1
run check bad.yaml
try "an error is red, its place bold" grep -q "^$escape\[1;31mhawser:$escape\[0m $escape\[1mbad.yaml:2:[0-9]*:$escape\[0m " \
	"$scratch/err"
run check "$chairlift"
try "what is good is green" grep -q "$escape\[32mwithout errors$escape\[0m" "$scratch/out"
run statics "$chairlift"
try "a table has no colour" sh -c "! grep -q '$escape' '$scratch/out'"
export NO_COLOR=1
run check bad.yaml
unset NO_COLOR CLICOLOR_FORCE
try "NO_COLOR is kept" sh -c "! grep -q '$escape' '$scratch/err'"
# a terminal needs /dev/pts
if script -qec true /dev/null </dev/null >/dev/null 2>&1; then
	script -qec "'$HAWSER' check bad.yaml" /dev/null </dev/null >terminal 2>&1
	try "colour on a terminal" grep -q "$escape\[1;31mhawser:" terminal
	TERM=dumb script -qec "'$HAWSER' check bad.yaml" /dev/null </dev/null >terminal 2>&1
	try "not on a dumb one" sh -c "grep -q hawser: terminal && ! grep -q '$escape' terminal"
	script -qec "'$HAWSER' frf '$chairlift' --from 0.98w1 --to 1.3w1 --step 0.05 -q" /dev/null </dev/null >terminal 2>&1
	try "peaks on a terminal, the highest first, in columns" awk '$1 == "probe" {at = index($0, "amplitude_m"); next}
		at && NF > 4 {if (substr($0, at - 1, 2) !~ /^ [0-9]/ || n++ && substr($0, at) + 0 > before) exit 1
		before = substr($0, at) + 0} END {exit !(n > 1 && n <= 10)}' terminal
	script -qec "'$HAWSER' statics '$chairlift'" /dev/null </dev/null >terminal 2>&1
	try "7 digits there" grep -q '^1\.252514   *1\.251094 ' terminal
	printf '%s\n' 'cable: {EA: 25 MN, rho: 1.6}' 'span: {d: 400 m, h: 0}' 'tension: {H: 28 kN, state: reference}' \
		'cases: [{name: Wärme, temperature: {change: 9 K}}]' 'temperature: {change: 0, expansion: 1.9e-5}' >cases.yaml
	script -qec "'$HAWSER' statics cases.yaml --cases -q" /dev/null </dev/null >terminal 2>&1
	try "columns beside names of other letters" awk '{sub("ä", "a")} $1 == "case" {at = index($0, "H_N")}
		$1 == "Warme" {found = substr($0, at - 1, 2) ~ /^ [0-9]/} END {exit !found}' terminal
	script -qec "'$HAWSER' statics '$chairlift' --tsv -" /dev/null </dev/null >terminal 2>&1
	try "17 with --tsv -" grep -q '^1\.25251444[0-9]*	1\.2510936[0-9]*	' terminal
else
	skip "terminals: the program script is missing, or there are none here"
fi
done_testing

#!/bin/sh
# What --help lists and what the manual page describes are the same options with the same arguments,
# in the same order; every default that --help states stands in the page.
# SPDX-License-Identifier: GPL-3.0-or-later
built=$PWD/man
. "$SRCDIR/tests/cli/lib.sh"
man=$scratch/man
mkdir "$man"
cp "$built"/*.1 "$man"

options_of_help() {
	sed -n '/^Options:/,/^More:/{ /^  \(-\|    --\)/{ s/^ *//; s/  .*//; p; }; }'
}

options_of_page() {
	awk -v want=".SH $1" '/^\.SH/ { on = ($0 == want) } on && after && /^\.B \\-/ { print } { after = /^\.TP/ }' |
		sed 's/^\.B //; s/\\f[A-Z]//g; s/\\-/-/g'
}

# init, check, schema and completion have no table, so that they have few options
least() {
	case $1 in init | check | schema | completion | merge) echo 1 ;; *) echo 7 ;; esac
}

commands >commands
while read -r command <&3; do
	page=$man/hawser-${command%% *}.1
	section=OPTIONS
	case $command in *' '*) section="OPTIONS OF $(echo "$command" | tr '[:lower:]' '[:upper:]')" ;; esac
	# shellcheck disable=SC2086 # words
	works "$command --help" $command --help
	options_of_help <"$scratch/out" >help
	options_of_page "$section" <"$page" >page
	try "$command: there are options" test "$(grep -c '' help)" -ge "$(least "$command")"
	try "$command: help and page list the same options" diff help page
	few=$(sed -n '/^Options:/,/^$/p' "$scratch/out" | grep -c '^  \(-\|    --\)')
	all=$(grep -c '' help)
	try "$command: of more than 20 options ten or so come first" test "$all" -le 20 -o "$few" -le 12
	# "(0.6w1)" at the end of a line of help
	plain=$(sed 's/\\-/-/g' "$page")
	sed -n 's/.*(\([^ ()]*\))$/\1/p' "$scratch/out" | while read -r default; do
		case $plain in *"($default)"*) ;; *) echo "($default) is not in the page" ;; esac
	done | nothing "$command: defaults agree"
	try "hawser(1) names hawser-${command%% *}(1)" \
		grep -q "hawser.*${command%% *} (1)" "$man/hawser.1"
done 3<commands

# the list of commands, with a line about each
works "hawser --help" --help
sed -n '/^Commands:/,/^Options:/{/^  /p;}' "$scratch/out" | sed 's/^  //; s/   */: /; s/$/./' >help
sed -n '/^\.SH COMMANDS/,/^\.SH OPTIONS/p' "$man/hawser.1" | sed -n '/^\.BR/{N;p;}' |
	sed 's/\\-/-/g' | sed '/^\.BR/{N;s/^\.BR "*//; s/"* "* - see.*\n/: /;}' >page
try "hawser(1) lists the commands as --help does" diff help page

for page in "$man"/*.1; do
	name=${page##*/}
	for section in NAME SYNOPSIS DESCRIPTION OPTIONS 'EXIT STATUS' EXAMPLES 'SEE ALSO'; do
		grep -q "^\.SH $section\$" "$page" || echo "$name: no $section"
	done
done | nothing "every page has its sections"
done_testing

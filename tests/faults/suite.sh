#!/bin/sh
# tests/faults/suite.sh - what run.sh has to know of the suite. In a build folder:
#   suite.sh list           lines of a set (quick, longer) and a case, with a tab between
#   suite.sh run CASE       run a case; it speaks TAP
#   suite.sh sources        the cases that read what faults change in the sources; every fault reaches them
#   suite.sh flags          the compiler's flags, with the warnings that are errors in .ci/run
# SRCDIR may name another tree than the build's, for what the cases read.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u

# value NAME: of a variable of the Makefile.
value() {
	printf 'include Makefile\n$(info $(%s))\nnothing:\n\t@:\n' "$1" | make -s --no-print-directory -f - nothing
}

# programs: lines of a case and the program that has it.
programs() {
	for program in $(value test_programs); do
		"./$program" list | sed "s|\$|	$program|"
	done
}

# scripts: lines of a case and the script.
scripts() {
	for script in $(value test_scripts); do
		case=${script#tests/}
		printf '%s\t%s\n' "${case%.sh}" "$script"
	done
}

# left_out CASE: of a build with sanitizers, .ci/run does not run it.
left_out() {
	[ -n "$sanitized" ] && grep -q "^$1\([ 	]\|\$\)" "$unsanitized"
}

case $1 in
list)
	SRCDIR=${SRCDIR-$(value srcdir)} # where programs with tables of cases read them
	export SRCDIR
	value TEST_ENVIRONMENT >suite-environment
	{ programs; scripts; } >suite-cases
	longer=$(value srcdir)/tests/longer.txt
	sanitized=$(value SANITIZE_FLAGS)
	unsanitized=$(value srcdir)/tests/unsanitized.txt
	while read -r case _; do
		if left_out "$case"; then
			continue
		elif grep -q "^$case\\([ 	]\\|\$\\)" "$longer"; then
			[ -n "$sanitized" ] || printf 'longer\t%s\n' "$case"
		else
			printf 'quick\t%s\n' "$case"
		fi
	done <suite-cases ;;
run)
	other=${SRCDIR-}
	# shellcheck disable=SC1091 # written above
	. ./suite-environment
	SRCDIR=${other:-$SRCDIR}
	MALLOC_PERTURB_=165 # as check-quick has it
	export MALLOC_PERTURB_
	file=$(awk -v name="$2" '$1 == name { print $2 }' suite-cases)
	case $file in
		*.sh) exec sh "$SRCDIR/$file" ;;
		*) exec "./$file" "$2" ;;
	esac ;;
sources)
	echo checks/messages ;;
flags)
	echo "$(value ANALYZER_FLAGS) $(value WARN_FLAGS) -Werror -O2" ;;
esac

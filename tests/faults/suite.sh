#!/bin/sh
# tests/faults/suite.sh - what run.sh has to know of the suite. In a build folder:
#   suite.sh list           lines of a set (quick, longer) and a case, with a tab between
#   suite.sh run CASE       run a case; it speaks TAP
#   suite.sh make CASE      make what the case needs
#   suite.sh sources        the cases that read what faults change in the sources; every fault reaches them
#   suite.sh flags          the compiler's flags, with the warnings that are errors in .ci/run
# SRCDIR may name another tree than the build's, for what the cases read.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u

# value NAME: of a variable of the Makefile.
value() {
	printf 'include Makefile\n$(info $(%s))\nnothing:\n\t@:\n' "$1" | make -s --no-print-directory -f - nothing
}

words() {
	value "$1" | tr -s ' ' '\n' | sed '/^$/d'
}

case $1 in
list)
	tests=$(words 'TESTS:$(EXEEXT)=')
	out=$(words 'filter $(SANITIZERS_OUT),$(TESTS:$(EXEEXT)=)')
	[ -n "$(value SANITIZE_FLAGS)" ] || out=
	longer=$(words LONGER)
	for case in $tests; do
		case "
$out
" in *"
$case
"*) continue ;; esac
		case "
$longer
" in *"
$case
"*) printf 'longer\t%s\n' "$case" ;; *) printf 'quick\t%s\n' "$case" ;; esac
	done
	value AM_TESTS_ENVIRONMENT >suite-environment ;;
run)
	other=${SRCDIR-}
	. ./suite-environment
	SRCDIR=${other:-$SRCDIR}
	case $2 in
		*.sh) exec sh "$SRCDIR/$2" ;;
		*) exec "./$2" ;;
	esac ;;
make)
	case $2 in *.sh) ;; *) make -s "$2" ;; esac ;;
sources)
	echo tests/checks/messages.sh ;;
flags)
	echo "$(value ANALYZER_FLAGS) $(value WARN_FLAGS) -Werror -O2" ;;
esac

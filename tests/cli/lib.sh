# tests/cli/lib.sh - running the program and looking at what it says, to be sourced. By hand, from the
# build folder: HAWSER=./hawser SRCDIR=.. ../tests/cli/usage.sh
# SPDX-License-Identifier: GPL-3.0-or-later
case $HAWSER in /*) ;; *) HAWSER=$PWD/$HAWSER ;; esac
# In the build folder hawser is a script of libtool's, which takes three times as long as the program behind it starts.
if [ "${HAWSER##*/}" = hawser ] && [ -x "${HAWSER%/*}/.libs/hawser" ]; then
	LD_LIBRARY_PATH=${HAWSER%/*}/.libs${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
	HAWSER=${HAWSER%/*}/.libs/hawser
	export LD_LIBRARY_PATH
fi
. "$SRCDIR/tests/checks/lib.sh"
top=$PWD
chairlift=$top/notebooks-data/scenes/b-table-4.2.yaml
duffing=$top/tests/reference/duffing-nlvib-01.json
# Relative names of files belong to the scratch folder; the source tree may be read-only.
mkdir "$scratch/work"
cd "$scratch/work" || exit 1

# The commands of run() are run by a program that is loaded once a script (tests/serve.c), where make check names it.
HAWSER_SERVER=${HAWSER_SERVER:-}
serving=$HAWSER_SERVER
if [ "$serving" ]; then
	mkfifo "$scratch/asks" "$scratch/answers"
	"$HAWSER_SERVER" serve <"$scratch/asks" >"$scratch/answers" &
	server=$!
	exec 8>"$scratch/asks" 9<"$scratch/answers"
fi
judge=
trap 'end_servers; rm -rf "$scratch"' EXIT
end_servers() {
	[ -z "$HAWSER_SERVER" ] || { printf '%s\0' -1 >&8; wait "$server"; }
	[ -z "$judge" ] || { printf '\n\n' >&6; wait "$judge"; }
}

# run ARGUMENTS: leaves $status, $scratch/out and $scratch/err; the input is $scratch/in, if any.
: >"$scratch/in"
run() {
	if [ "$serving" ]; then
		export -p >"$scratch/env"
		printf '%s\0' $# "$PWD" "$scratch" "$@" >&8
		read -r status <&9 || status="no answer"
		return
	fi
	"$HAWSER" "$@" <"$scratch/in" >"$scratch/out" 2>"$scratch/err"
	status=$?
}

# unserved: from here on each run starts the program, with what the shell has set (its umask).
unserved() {
	serving=
}

# commands: the names that hawser --help lists, one a line; some have two words.
commands() {
	"$HAWSER" --help | sed -n '/^Commands:/,/^Options:/s/^  \([a-z]* \{0,1\}[a-z]*\)  .*/\1/p' | sed 's/ *$//'
}

# said EXIT-STATUS [loud]: the last run ended so; if it failed, with nothing on standard output, else with nothing on standard error,
# unless it may be loud.
said() {
	[ "$status" -eq "$1" ] || { echo "exit status $status, not $1"; cat "$scratch/err"; return 1; }
	[ "$1" -eq 0 ] || [ ! -s "$scratch/out" ] || { echo "standard output is not empty"; return 1; }
	[ "$1" -ne 0 ] || [ ! -s "$scratch/err" ] || [ "${2-}" ] || { cat "$scratch/err"; return 1; }
}

exactly() {
	said "$1" && printf '%s\n' "$2" >"$scratch/want" && diff "$scratch/want" "$scratch/err"
}

like() {
	said "$1" loud || return 1
	grep -qE -- "$2" "$scratch/err" || { echo "no /$2/ in:"; cat "$scratch/err"; return 1; }
	{
		IFS= read -r first
		IFS= read -r second
		! IFS= read -r third || { echo "more than two lines"; return 1; }
	} <"$scratch/err"
	case $first in 'hawser: '*) ;; *) echo "no hawser: in front"; return 1 ;; esac
}

# called STATUS ARGUMENTS: leaves in $words the name of a check, without the folder of the sources.
called() {
	words="status $1: hawser"
	shift
	for word; do
		while :; do
			case $word in
				*"$top/"*) word=${word%%"$top/"*}${word#*"$top/"} ;;
				*) break ;;
			esac
		done
		words="$words $word"
	done
}

# refuses STATUS MESSAGE ARGUMENTS: exact standard error (without "hawser: "), empty standard output.
refuses() {
	want=$1
	message=$2
	shift 2
	run "$@"
	called "$want" "$@"
	try "$words" exactly "$want" "hawser: $message"
}

# refuses_like STATUS PATTERN ARGUMENTS: the same with an extended regular expression.
refuses_like() {
	want=$1
	message=$2
	shift 2
	run "$@"
	called "$want" "$@"
	try "$words" like "$want" "$message"
}

# denies TEXT STATUS PATTERN ARGUMENTS: ends with that status, and standard error has the basic regular expression.
denies() {
	text=$1 code=$2 saying=$3
	shift 3
	run "$@"
	try "$text" said "$code"
	try "  says so" grep -q -e "$saying" "$scratch/err"
}

# works TEXT ARGUMENTS
works() {
	text=$1
	shift
	run "$@"
	try "$text" said 0
}

# rough NAME ARGUMENTS: works, and says how far its model, or a boundary by it, may be off, that it
# has no modes there, or that a motion exceeds its range, but nothing else.
rough() {
	text=$1
	shift
	run "$@"
	try "$text" like 0 '^hawser: warning: .*((may be|are) off by .* (because of what the model leaves out|so far is the model of another size|of the width of their region)|the model knows no modes above|moves by up to .* right within)'
}

# flat NAME ARGUMENTS: works, and says that its map has nothing to show, but nothing else.
flat() {
	text=$1
	shift
	run "$@"
	try "$text" like 0 '^hawser: warning: (empty|constant): '
}

# The files here, which a failed run must not have added to.
holds() {
	ls -A >"$scratch/ls"
	printf '%s' "$1" | tr ' ' '\n' | sed '/^$/d' | diff - "$scratch/ls"
}

# python TEXT: passes when the program on standard input does; it may import json, csv, math, sys (-S: no
# packages of the site, whose search takes half of the start). A python started once forks for each.
python() {
	if command -v python3 >/dev/null; then
		cat >"$scratch/check.py"
		[ -n "$judge" ] || start_judge
		try "$1" judged
	else
		cat >/dev/null
		skip "$1: python3 is not installed"
	fi
}

start_judge() {
	mkfifo "$scratch/cases" "$scratch/verdicts" || exit 1
	python3 -S "$SRCDIR/tests/cli/serve.py" <"$scratch/cases" >"$scratch/verdicts" &
	judge=$!
	exec 6>"$scratch/cases" 7<"$scratch/verdicts"
}

judged() {
	printf '%s\n' "$PWD" "$scratch" >&6
	read -r answer <&7 && return "$answer"
}

# terminals: whether a pseudo-terminal can be opened, which needs Python and a mounted /dev/pts.
terminals() {
	python3 -S -c 'import pty; pty.openpty()' >/dev/null 2>&1
}
no_terminal="no pseudo-terminal can be opened (no python3, or /dev/pts is not mounted)"

# sketched: pictures are from here on what gnuplot is given, which has the same words and takes a tenth of the time.
# HAWSER_LONG=1 draws them; pictures.sh draws each kind always.
sketched() {
	[ -z "${HAWSER_LONG:-}" ] || return 0
	printf '#!/bin/sh\nexec cat\n' >"$scratch/gnuplot"
	chmod +x "$scratch/gnuplot"
	HAWSER_GNUPLOT=$scratch/gnuplot
	export HAWSER_GNUPLOT
}

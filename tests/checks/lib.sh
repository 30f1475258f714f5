# tests/checks/lib.sh - TAP for shell scripts, to be sourced. By hand, from the build folder:
#   SRCDIR=.. ../tests/checks/size.sh
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
: "${SRCDIR:?set it to the top of the source tree}"
LC_ALL=C
export LC_ALL
scratch=$(mktemp -d "${TMPDIR:-/tmp}/hawser-check.XXXXXX") || exit 1
trap 'rm -rf "$scratch"' EXIT
# The number of checks so far, in a file because the end of a pipe runs in a shell of its own. There are thousands of
# checks: what is done at each one is done by the shell itself, since starting a program takes some milliseconds.
echo 0 >"$scratch/count"
next() {
	read -r count <"$scratch/count"
	count=$((count + 1))
	echo $count >"$scratch/count"
}

# verdict STATUS TEXT: one line of TAP; the diagnostics stand in $scratch/why.
verdict() {
	next
	if [ "$1" -eq 0 ]; then
		echo "ok $count - $2"
	else
		echo "not ok $count - $2"
		[ ! -s "$scratch/why" ] || sed 's/^/# /' "$scratch/why"
	fi
	: >"$scratch/why"
}

# nothing TEXT: passes when standard input is empty; each line of it is a finding, "file:line: why".
nothing() {
	cat >"$scratch/why"
	[ ! -s "$scratch/why" ]
	verdict $? "$1"
}

# try TEXT COMMAND...: passes when the command does.
try() {
	text=$1
	shift
	"$@" >"$scratch/why" 2>&1
	verdict $? "$text"
}

skip() {
	next
	echo "ok $count # SKIP $1"
}

done_testing() {
	read -r count <"$scratch/count"
	echo "1..$count"
}

# Paths in findings are relative to the source tree.
cd "$SRCDIR" || exit 1

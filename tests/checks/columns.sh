#!/bin/sh
# Every column and every key of JSON that the tables of fields have (hawser help columns) is in the manual
# page of the command, and has a line that says what it is.
# SPDX-License-Identifier: GPL-3.0-or-later
BUILDDIR=${BUILDDIR-$PWD}
. "$(dirname "$0")/lib.sh"
if ! command -v python3 >/dev/null; then
	skip "python3 is not installed"
	done_testing
	exit
fi
# without libtool's script, which takes longer than the program
hawser=$BUILDDIR/hawser
if [ -x "$BUILDDIR/.libs/hawser" ]; then
	hawser=$BUILDDIR/.libs/hawser
	LD_LIBRARY_PATH=$BUILDDIR/.libs
	export LD_LIBRARY_PATH
fi
"$hawser" --help | sed -n '/^Commands:/,/^Options:/s/^  \([a-z]* \{0,1\}[a-z]*\)  .*/\1/p' | sed 's/ *$//' >"$scratch/commands"
mkdir "$scratch/lists"
while read -r command <&3; do
	# shellcheck disable=SC2086 # words
	"$hawser" help columns $command >"$scratch/lists/$command"
done 3<"$scratch/commands"
python3 -S tests/checks/columns.py "$BUILDDIR/man" "$scratch/lists"/* |
	nothing "the pages have all columns and keys"
grep -E '^ +[^ ]+ *$' "$scratch/lists"/* | nothing "each has a meaning"
done_testing

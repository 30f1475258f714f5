#!/bin/sh
# The table of messages in doc/robustness.md: each of its messages is in the sources, with the parts that
# vary left out, and each status has its rows; each message of the program has one. The list of all, doc/messages.md, is made
# by the build: it can be made, and each message keeps the rules.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"

# String literals of the sources, those that stand next to each other joined, % marks as the table has them.
find src -name '*.[ch]' -exec cat {} + | tr '\n\t' '  ' | sed 's/" *"//g; s/%%/%/g; s/\\"/"/g' >"$scratch/sources"
sed -n '/^## Messages/,$p' doc/robustness.md | sed -n 's/^| `\([^`]*\)` |.*/\1/p' >"$scratch/messages"

try "the table has messages" test "$(wc -l <"$scratch/messages")" -gt 60
sed 's/…/\n/g' "$scratch/messages" | sed 's/^ *//; s/ *$//' | awk '
	NR == FNR { sources = sources $0; next }
	length($0) >= 5 && !index(sources, $0) {
		print "doc/robustness.md: no message of the sources says \"" $0 "\"" }
' "$scratch/sources" - | nothing "each message of the table is one of the sources"
for status in $(sed -n 's/.*\[\(HAWSER_ERR_[A-Z_]*\)\] = .*/\1/p' src/core/status.c); do
	sed -n '/^## Messages/,$p' doc/robustness.md | grep -q "^### .*$status" ||
		echo "doc/robustness.md: no section for $status"
done | nothing "each status has its section"

if python3 -c '' 2>/dev/null; then
	python3 tests/checks/messages.py list >"$scratch/list"
	try "the list of all messages can be made" test "$(grep -c '^- ' "$scratch/list")" -gt 1000
	for status in $(sed -n 's/.*\[\(HAWSER_ERR_[A-Z_]*\)\] = .*/\1/p' src/core/status.c); do
		grep -q "^## $status\$" "$scratch/list" || echo "no messages of $status"
	done | nothing "it has messages of each status"
	python3 tests/checks/messages.py wrong | nothing "each message keeps the rules"
	python3 tests/checks/messages.py unexplained | nothing "each message of the program has a row"
else
	skip "python3 is not there: the list of all messages"
fi
done_testing

#!/bin/sh
# No file over 500 lines, no function over 90, lines of 100 columns (a tab is four; four more are
# let pass, for a last word), no trailing blanks, no notes to self; every source says what it is and
# under which licence.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"

sources=$(find src include tests bench examples -name '*.[ch]' | sort)

# shellcheck disable=SC2086 # a list of words, here and below
awk 'FNR == 501 { print FILENAME ":500: more than 500 lines: split it" }' $sources |
	nothing "no source file over 500 lines"

# A function's body starts with { in column 1 and ends with } there: that is the house style.
awk 'FNR == 1 { start = 0 }
	/^\{/ { start = FNR }
	/^\}/ { if (start && FNR - start + 1 > 90)
		print FILENAME ":" start ": function of " FNR - start + 1 " lines"; start = 0 }
' $sources | nothing "no function over 90 lines"

awk '{ line = $0; width = 0
	while (match(line, /\t/)) {
		width += RSTART - 1; width += 4 - width % 4; line = substr(line, RSTART + 1) }
	if (width + length(line) > 104) print FILENAME ":" FNR ": " width + length(line) " columns" }
' $sources | nothing "lines of 100 columns"

grep -nE '[ 	]+$' $sources /dev/null | sed 's/$/: trailing blank/' | nothing "no trailing blanks"
# Spaces may align a continued line; a statement of its own stands on tabs.
awk 'FNR == 1 { previous = ""; comment = 0 }
	/^ +[a-zA-Z}]/ && !comment && previous ~ /[;{}]$/ { print FILENAME ":" FNR ": indented by spaces" }
	{ if (/\/\*/) comment = 1; if (/\*\//) comment = 0; previous = $0 }
' $sources | nothing "indentation by tabs"
grep -nE '\b(TODO|FIXME|XXX)\b' $sources /dev/null | nothing "no notes to self"
awk 'FNR == 1 { if (file && !named) print file ":1: no SPDX line"; file = FILENAME; named = 0 }
	FNR <= 60 && /SPDX-License-Identifier: GPL-3.0-or-later/ { named = 1 }
	END { if (!named) print file ":1: no SPDX line" }' $sources | nothing "every source names its licence"
# In an archive of objects, libtool takes a name once.
for folder in src/*/; do
	find "$folder" -name '*.c' | sed 's|.*/||' | sort | uniq -d | sed "s|^|$folder: |"
done | nothing "the sources of a stage have different names"
# A comment on the line, or one above the group of constants without a blank line in it.
awk 'FNR == 1 { above = 0 }
	/^#define [A-Z_0-9]+ +[-(]?[0-9.]/ { if (!/\/\*/ && !above) print FILENAME ":" FNR ": " $0; next }
	{ above = /^( \*|\/\*).*\*\/[ \t]*$/ }' $(find src -name '*.[ch]' | sort) | nothing "every numeric constant has its reason"
# Several sources are compiled as one (src/batches.sh): a tag or an enumerator is one thing in all headers.
awk '/^enum( [a-z_0-9]+)? \{/ { inside = 1 }
	{ line = $0; gsub(/\/\*.*\*\//, "", line); sub(/\/\*.*/, "", line) }
	/^(struct|enum|union) [a-z_0-9]+ \{/ { see($1 " " $2) }
	inside { rest = line; sub(/^enum[^{]*\{/, "", rest)
		while (match(rest, /(^|,)[ \t]*HAWSER__[A-Z_0-9]+/)) {
			word = substr(rest, RSTART, RLENGTH); sub(/^[, \t]*/, "", word); see(word); rest = substr(rest, RSTART + RLENGTH) } }
	line ~ /\}/ { inside = 0 }
	function see(what) { if ((what in seen) && seen[what] != FILENAME) print FILENAME ":" FNR ": " what " is in " seen[what] " too"; seen[what] = FILENAME }
' $(find src include -name '*.h' | sort) | nothing "a tag or an enumerator has one header"
done_testing

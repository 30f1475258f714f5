# tests/faults/seed.awk - a source with faults, on standard output:
#   awk -v file=PATH -v only=NUMBER -f seed.awk faults.tsv SOURCE
# only=0: all faults of that file, each behind a switch (fault.c); otherwise that one alone, as a developer would have
# written it. The table marks the text that is replaced by {| and |}; the line of a fault must occur once in the file. The
# forms are: expression; statement; text, a string in a constant table, where no expression can stand: one there is refused.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = "\t"; bad = 0 }

function wrong(number, text) {
	printf "fault %s, %s: %s\n", number, file, text | "cat >&2"
	bad = 1
}

# The table: the faults of this file.
NR == FNR {
	if (FNR == 1 || $4 != file || (only != 0 && $1 != only))
		next
	n++
	number[n] = $1
	form[n] = $3
	begin = index($5, "{|")
	end = index($5, "|}")
	if (!begin || end < begin)
		wrong($1, "the original has no {| and |}")
	before[n] = substr($5, 1, begin - 1)
	original[n] = substr($5, begin + 2, end - begin - 2)
	whole[n] = before[n] original[n] substr($5, end + 2)
	replaced[n] = $6
	seen[n] = 0
	next
}

function switched(i) {
	if (only != 0)
		return replaced[i]
	if (form[i] == "expression")
		return "(hawser__fault(" number[i] ") ? (" replaced[i] ") : (" original[i] "))"
	if (form[i] == "statement")
		return "{ if (hawser__fault(" number[i] ")) { " replaced[i] " } else { " original[i] " } }"
	return "hawser__text_" number[i]
}

# A string that is replaced before main; its place counts as reached at once.
function text_of(i, name) {
	name = "hawser__text_" number[i]
	return "static char " name "[sizeof " original[i] " + sizeof " replaced[i] "] = " original[i] "; " \
		"static void __attribute__((constructor)) " name "_set(void) { " \
		"static const char with[] = " replaced[i] "; if (hawser__fault(" number[i] ")) " \
		"for (unsigned i = 0; i < sizeof with; i++) " name "[i] = with[i]; } "
}

/^\t*static const .*= \{$/ { table = 1 }
/};$/ { table = 0 }

{
	line = $0
	done = 0
	for (i = 1; i <= n; i++) {
		at = index($0, whole[i])
		if (!at)
			continue
		if (index(substr($0, at + 1), whole[i]))
			seen[i]++
		seen[i]++
		if (done++)
			wrong(number[i], "another fault is on its line")
		if (table && form[i] != "text")
			wrong(number[i], "no expression can stand in a constant table")
		if (form[i] == "statement" && original[i] !~ /[;}]$/)
			wrong(number[i], "that is no statement: " original[i])
		if (form[i] == "expression" && before[i] ~ /(\.|->)$/)
			wrong(number[i], "that is a member's name, not an expression: " original[i])
		at += length(before[i])
		line = substr($0, 1, at - 1) switched(i) substr($0, at + length(original[i]))
	}
	if (FNR == 1 && only == 0 && n) {
		printf "int hawser__fault(int number); "
		for (i = 1; i <= n; i++)
			if (form[i] == "text")
				printf "%s", text_of(i)
	}
	print line
}

END {
	for (i = 1; i <= n; i++)
		if (seen[i] != 1)
			wrong(number[i], "the original occurs " seen[i] " times: " whole[i])
	exit bad
}

# shapes.awk - see shapes.sh. Reads headers in the house style: one declaration a line or continued,
# struct fields indented, function declarations in column 1.
# SPDX-License-Identifier: GPL-3.0-or-later

# Is the name given a shape ("name [", "name[", "`name` are [3]", "*name") in this comment?
function shaped(comment, name,    word) {
	word = "(^|[^A-Za-z0-9_])"
	if (comment ~ word "\\*" name "([^A-Za-z0-9_]|$)")
		return 1
	return comment ~ word name "([^A-Za-z0-9_]|$)" && comment ~ /\[[^]]+\]/
}

# Every "double *name" and "int *name" of a declaration.
function pointers(text, names,    n) {
	n = 0
	while (match(text, /(double|int|long) \*+(const )?[a-z_A-Z0-9]+/)) {
		name = substr(text, RSTART, RLENGTH)
		sub(/.*[ *]/, "", name)
		names[++n] = name
		text = substr(text, RSTART + RLENGTH)
	}
	return n
}

function finish_function(    n, i, list) {
	parameters = declaration
	sub(/^[^(]*\(/, "", parameters)
	n = pointers(parameters, list)
	for (i = 1; i <= n; i++)
		if (!shaped(comment, list[i]) && !shaped(section, list[i]))
			print FILENAME ":" line ": no shape for parameter " list[i] " in the comment before"
	declaration = ""
}

FNR == 1 { comment = section = ""; declaration = ""; in_struct = 0; in_comment = 0 }

# Comments in column 1, kept until the next one: neighbours may share it. One that begins with
# "---" opens a section, and holds until the next such.
in_comment || /^\/\*/ {
	if (!in_comment)
		comment = ""
	comment = comment " " $0
	if (comment ~ /^ \/\* ---/)
		section = comment
	in_comment = $0 !~ /\*\//
	next
}

/^struct [a-z_]+ \{/ { in_struct = 1; next }
/^\}/ { in_struct = 0; next }
in_struct && /(^|[^a-z])(double|int|long) \*/ && !/\(\*/ {
	if ($0 !~ /\/\*.*\[[^]]+\]/)
		print FILENAME ":" FNR ": no shape for the field: " $0
}
in_struct { next }

declaration == "" && /^[a-z].*\(/ { line = FNR; declaration = $0 }
declaration != "" {
	if (FNR != line)
		declaration = declaration " " $0
	if ($0 ~ /;/)
		finish_function()
}

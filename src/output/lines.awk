# A text file as a constant of C, a string a line. Blank lines and the comments of report.js are left out.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { print "static const char *const " name "[] = {" }
/^[ \t]*$/ || /^[ \t]*\/\// { next }
{
	# "\\\\&" is a backslash and what matched in every awk; other numbers of backslashes are read differently.
	gsub(/[\\"]/, "\\\\&")
	gsub(/\t/, "\\t")
	print "\t\"" $0 "\\n\","
}
END { print "\t0\n};" }

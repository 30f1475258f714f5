# A text file as constants of C, a string a line. A line "!@ NAME", "%@ NAME" or "#@ NAME" begins the constant NAME; what stands
# before the first one is left out. With -v name=NAME all of the file is one constant, without blank lines and the comments of
# report.js.
# SPDX-License-Identifier: GPL-3.0-or-later
function begin(constant) {
	finish()
	print "static const char *const " constant "[] = {"
	open = 1
}
function finish() { if (open) print "\t0\n};"; open = 0 }
BEGIN { if (name) begin(name) }
FNR == 1 && !name { finish() }
/^[!%#]@ / { begin($2); next }
!open || (name && /^[ \t]*($|\/\/)/) { next }
{
	# "\\\\&" is a backslash and what matched in every awk; other numbers of backslashes are read differently.
	gsub(/[\\"]/, "\\\\&")
	gsub(/\t/, "\\t")
	print "\t\"" $0 "\\n\","
}
END { finish() }

# tests/faults/sums.awk faults.tsv found.tsv: a row a fault with what catches it, "-" where nothing of the step does, empty
# where the step was not tried; then, as comments, the sums.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN {
	FS = OFS = "\t"
	steps = split("warnings quick longer sanitizers", step, " ")
}
NR == FNR {
	if (FNR > 1) {
		fault[++n] = $1
		kind[n] = $2
		file[n] = $4
	}
	next
}
{ by[$1, $2] = $3 }
END {
	print "fault", "kind", "folder", "warnings", "quick", "longer", "sanitizers"
	for (i = 1; i <= n; i++) {
		split(file[i], part, "/")
		row = fault[i] OFS kind[i] OFS part[2]
		some = 0
		for (s = 1; s <= steps; s++) {
			what = by[fault[i], step[s]]
			row = row OFS what
			if (what != "" && what != "-") {
				caught[s]++
				if (!some++)
					first[s]++
			}
		}
		print row
		if (some)
			all++
		else
			none = none " " fault[i]
	}
	for (s = 1; s <= steps; s++)
		print "# " step[s] ": catches " caught[s] + 0 ", of these none of the steps before " first[s] + 0
	print "# caught: " all + 0 " of " n "; not caught:" (none ? none : " none")
}

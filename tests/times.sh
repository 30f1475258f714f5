#!/bin/sh
# tests/times.sh [COUNT]: the processor time of each test of the last make check, in seconds, the COUNT
# (30) longest first, and the sum of all. Run it in the build folder. Processor time includes what a
# test's child processes took, and hardly changes where other programs keep the processors busy.
# SPDX-License-Identifier: GPL-3.0-or-later
find tests -name '*.log' ! -name 'test-suite.log' | while read -r log; do
	awk -v test="${log%.log}" '
		function seconds(text, part) { split(text, part, /[ms]/); return 60*part[1] + part[2] }
		/^# processor time/ { getline; getline; print seconds($1) + seconds($2), test }' "$log"
done | sort -rn | awk -v most="${1-30}" '
	NR <= most { printf "%8.2f  %s\n", $1, $2 }
	{ sum += $1 }
	END { printf "%8.2f  all %d tests\n", sum, NR }'

#!/bin/sh
# The table of seeded faults (tests/faults) fits the sources: each text that is replaced occurs once in its file, and each
# folder has a fault.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"

table=tests/faults/faults.tsv
sed 1d "$table" | cut -f 4 | sort -u >"$scratch/files"
while read -r file; do
	${AWK-awk} -v file="$file" -v only=0 -f tests/faults/seed.awk "$table" "$file" 2>&1 >/dev/null
done <"$scratch/files" | nothing "each seeded fault fits the sources"
for folder in src/*/; do
	grep -q "^$folder" "$scratch/files" || echo "$folder: no seeded fault"
done | nothing "each folder has a seeded fault"
try "60 faults" test "$(sed 1d "$table" | grep -c .)" -ge 60
done_testing

#!/bin/sh
# tests/faults/seed.sh TABLE FROM TO: copy the tree FROM (files that git has) to the folder TO, with all faults of
# TABLE in it, each behind a switch: HAWSER_FAULT=17 in the environment makes number 17 active, without it there is
# none (fault.c). So one build serves all faults.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
table=$1 from=$2 to=$3
AWK=${AWK-awk}
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$to"
(cd "$from" && git ls-files -z | xargs -0 tar -cf - --) | (cd "$to" && tar -xf -)
cut -f 4 "$table" | sed 1d | sort -u | while read -r file; do
	$AWK -v file="$file" -v only=0 -f "$here/seed.awk" "$table" "$from/$file" >"$to/$file"
done
cp "$here/fault.c" "$to/src/core/fault.c"
sed 's|%D%/file\.c|& %D%/fault.c|' "$from/src/core/local.mk" >"$to/src/core/local.mk"
grep -q fault.c "$to/src/core/local.mk" || {
	echo "seed.sh: src/core/local.mk does not name file.c, beside which fault.c belongs" >&2
	exit 1
}

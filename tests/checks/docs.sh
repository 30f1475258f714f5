#!/bin/sh
# Files that the documents link to are there, and the versions they state agree.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"

for f in README.md HACKING.md doc/*.md; do
	[ -f "$f" ] || continue
	grep -noE '\]\([^)#]+' "$f" | while IFS= read -r hit; do
		target=${hit#*\](}
		case $target in *://*) continue ;; esac
		[ -e "$(dirname "$f")/$target" ] || echo "$f:${hit%%:*}: links to $target, which is not there"
	done
done | nothing "links between documents hold"

version=$(sed -n 's/^AC_INIT(\[hawser\], \[\([^]]*\)\].*/\1/p' configure.ac)
try "configure.ac states a version" test -n "$version"
try "NEWS begins with $version" grep -q "^hawser $version" NEWS
try "CITATION.cff has version $version" grep -q "^version: \"\{0,1\}$version\"\{0,1\}$" CITATION.cff
try "NEWS has an ABI paragraph for $version" awk -v v="$version" '
	/^hawser / { on = ($2 == v) } on && /^ABI/ { found = 1 } END { exit !found }' NEWS
done_testing

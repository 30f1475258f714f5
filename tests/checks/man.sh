#!/bin/sh
# Manual pages format without a warning, and every one is there for the program and the two files.
# SPDX-License-Identifier: GPL-3.0-or-later
here=$PWD
. "$(dirname "$0")/lib.sh"

pages=$(find "$here/man" man -maxdepth 1 -name '*.[1-9]' 2>/dev/null | sort)
try "there are manual pages" test -n "$pages"
for page in $pages; do
	name=${page##*/}
	if command -v man >/dev/null; then
		LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" \
			2>&1 >/dev/null | nothing "$name formats without a warning"
	else
		skip "$name: man is not installed"
	fi
done

# Of .BR and the like the words alternate in font and have no blank between them: a sentence cannot go on there.
for page in $pages; do
	grep -nE '^\.(BR|RB|IR|RI|BI|IB) .* [.,;] "?[A-Za-z]' "$page" | sed "s|^|${page##*/}:|"
done | nothing "no words run together"

# Each status that the program can end with; .SH EXIT STATUS of every command.
for page in $pages; do
	case $page in *.1) ;; *) continue ;; esac
	for status in 0 1 2 3 4 130; do
		sed -n '/^\.SH EXIT STATUS/,/^\.SH [^E]/p' "$page" | grep -q "^\.B $status\$" ||
			echo "${page##*/}: no exit status $status"
	done
done | nothing "exit statuses are complete"

# What a page, a header or a document refers to: hawser-frf(1), or ".BR hawser\-frf (1)" in a page.
for page in $pages; do
	sed 's/\\-/-/g; s/\\f[A-Z]//g' "$page" | grep -oE 'hawser-[a-z]+ ?\([1-9]\)' | sed "s|^|${page##*/} |"
done >"$scratch/references"
grep -oE 'hawser-[a-z]+\([1-9]\)' README.md NEWS HACKING.md include/hawser/*.h |
	tr ':' ' ' >>"$scratch/references"
while read -r from to; do
	target=$(echo "$to" | tr -d ' )' | tr '(' '.')
	echo "$pages" | grep -q "/$target\$" || echo "$from: refers to $to, which is not there"
done <"$scratch/references" | nothing "pages referred to are there"
done_testing

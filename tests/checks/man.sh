#!/bin/sh
# Manual pages format without a warning, and every one is there for the program and the two files.
# SPDX-License-Identifier: GPL-3.0-or-later
here=$PWD
. "$(dirname "$0")/lib.sh"

pages=$(find "$here/man" man -maxdepth 1 -name '*.[1-9]' 2>/dev/null | sort)
try "there are manual pages" test -n "$pages"
# What man runs, once for all pages: man itself takes longer than the formatting.
if command -v groff >/dev/null; then
	# shellcheck disable=SC2086 # a list of files
	LC_ALL=C.UTF-8 groff -t -K utf8 -man -rLL=80n -ww -z -Tutf8 $pages 2>&1 | nothing "pages format without a warning"
else
	skip "groff is not installed"
fi

# Of .BR and the like the words alternate in font and have no blank between them: a sentence cannot go on there.
# shellcheck disable=SC2086 # a list of files
grep -nE '^\.(BR|RB|IR|RI|BI|IB) .* [.,;] "?[A-Za-z]' $pages | nothing "no words run together"

# Each status that the program can end with; .SH EXIT STATUS of every command.
# shellcheck disable=SC2086 # a list of files
awk -v statuses='0 1 2 3 4 130' '
	FILENAME ~ /\.1$/ { page[FILENAME] }
	/^\.SH/ { inside = /^\.SH EXIT STATUS/ }
	inside && /^\.B [0-9]+$/ { has[FILENAME, $2] }
	END {
		n = split(statuses, status)
		for (file in page)
			for (i = 1; i <= n; i++)
				if (!((file, status[i]) in has)) print file ": no exit status " status[i]
	}' $pages | nothing "exit statuses are complete"

# What a page, a header or a document refers to: hawser-frf(1), or ".BR hawser\-frf (1)" in a page.
# shellcheck disable=SC2086 # a list of files
awk -v pages="$pages" '
	BEGIN {
		n = split(pages, path, /[ \n]+/)
		for (i = 1; i <= n; i++) { name = path[i]; sub(/.*\//, "", name); there[name] }
	}
	{
		gsub(/\\-/, "-")
		gsub(/\\f[A-Z]/, "")
		while (match($0, /hawser-[a-z]+ ?\([1-9]\)/)) {
			to = substr($0, RSTART, RLENGTH)
			$0 = substr($0, RSTART + RLENGTH)
			name = to
			gsub(/[ )]/, "", name)
			sub(/\(/, ".", name)
			if (!(name in there)) print FILENAME ": refers to " to ", which is not there"
		}
	}' $pages README.md NEWS HACKING.md src/README.md doc/*.md include/hawser/*.h | nothing "pages referred to are there"
done_testing

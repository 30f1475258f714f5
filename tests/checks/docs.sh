#!/bin/sh
# Files that the documents link to are there, and the versions they state agree.
# SPDX-License-Identifier: GPL-3.0-or-later
here=$PWD
. "$(dirname "$0")/lib.sh"

pages="README.md HACKING.md src/README.md tests/README.md bench/README.md packaging/README.md doc/*.md doc/site/README.md"
for f in $pages; do
	[ -f "$f" ] || continue
	grep -noE '\]\([^)#]+' "$f" | while IFS= read -r hit; do
		target=${hit#*\](}
		case $target in *://* | messages.md) continue ;; esac # the list of messages is made by the build
		[ -e "$(dirname "$f")/$target" ] || echo "$f:${hit%%:*}: links to $target, which is not there"
	done
done | nothing "links between documents hold"

# Sources that the documents name; names in capitals stand for others.
for f in $pages; do
	grep -noE '`(src|include|man|tests|bench|python|packaging)/[A-Za-z0-9_./-]+\.(c|h|mk|sh|py|awk|txt|table)`' "$f" | tr -d '`' |
		while IFS=: read -r line named; do
			case $named in *[A-Z][A-Z]*) continue ;; esac
			[ -e "$named" ] || echo "$f:$line: $named is not there"
		done
done | nothing "sources that documents name are there"

# "B Table 4.1" and "D 9.3.1" say what B and D are before they stand for the first time. In a manual page a line
# that begins with .B is in bold.
for f in $pages man/*.[15] "$here"/man/*.[15]; do
	[ -f "$f" ] || continue
	awk -v name="$f" '
		/Bertrand/ { known["B"] = 1 } /Dehadrai/ { known["D"] = 1 }
		/^\.B/ { next }
		{ line = " " $0 }
		match(line, /[^A-Za-z0-9.-][BD] (Tables? |Figures? |Appendix |\(?[0-9]+\.[0-9])/) {
			letter = substr(line, RSTART + 1, 1)
			if (!known[letter]++) printf "%s:%d: %s has not been explained\n", name, NR, letter
		}' "$f"
done | nothing "B and D are explained where they first stand"
# Pasted line by line, each section of doc/install.md leaves the shell in the folder where the next one expects it: every
# cd into a folder of the build has its cd .. . README.md is a door: it is short.
awk '/^    / { for (i = 1; i < NF; i++) if ($i == "cd") depth += $(i + 1) == ".." ? -1 : $(i + 1) == "build" }
	/^## / && depth != 0 { print "doc/install.md:" NR ": the commands above end " depth " folder(s) down"; depth = 0 }
' doc/install.md | nothing "doc/install.md goes back to the folder where it began"
try "README.md has at most 120 lines" test "$(wc -l <README.md)" -le 120
try "HACKING.md has at most two pages" test "$(wc -l <HACKING.md)" -le 130
try "hawser(1) and README.md name the glossary" grep -lq glossary.md README.md man/hawser.1.in

version=$(sed -n 's/^AC_INIT(\[hawser\], \[\([^]]*\)\].*/\1/p' configure.ac)
try "configure.ac states a version" test -n "$version"
try "NEWS begins with $version" grep -q "^hawser $version" NEWS
try "NEWS of $version has at most 60 lines" awk -v v="$version" '
	/^hawser / { on = ($2 == v) } on { n++ } END { exit n > 60 }' NEWS
try "CITATION.cff has version $version" grep -q "^version: \"\{0,1\}$version\"\{0,1\}$" CITATION.cff
try "NEWS has an ABI paragraph for $version" awk -v v="$version" '
	/^hawser / { on = ($2 == v) } on && /^ABI/ { found = 1 } END { exit !found }' NEWS
# What the analyzers' annotations are; `make check-analyzers` prints the same table with what is open.
SRCDIR=. sh tests/analyzers/run.sh counts | while IFS='|' read -r _ tool _ where; do
	grep -F "|$tool|" doc/robustness.md | grep -qF "|$where" || echo "doc/robustness.md: $tool has$where"
done | nothing "the document has as many annotations for the analyzers as the sources"
done_testing

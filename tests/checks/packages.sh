#!/bin/sh
# packages.txt is the one list: doc/install.md names the same packages, and configure's advice is on it.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"

group() {
	awk -v g="$1:" '$1 == g { for (i = 2; i <= NF; i++) print $i }' packages.txt | sort
}
# The apt-get install commands of doc/install.md, with their continued lines; options aside.
awk '/apt-get install/ { on = 1; sub(/.*apt-get install/, "") }
	on { more = sub(/\\$/, ""); for (i = 1; i <= NF; i++) if ($i !~ /^-/) print $i; on = more }
' doc/install.md | sort >"$scratch/page"
{ group build; group check; group optional; } | sort >"$scratch/list"

try "packages.txt has the groups" test -n "$(group build)" -a -n "$(group check)" -a -n "$(group optional)"
uniq -d "$scratch/list" | nothing "no package is listed twice"
comm -23 "$scratch/list" "$scratch/page" | sed 's/$/: not in doc/install.md/' |
	nothing "doc/install.md names every package"
comm -13 "$scratch/list" "$scratch/page" | sed 's/$/: not in packages.txt/' |
	nothing "doc/install.md names no other package"
for package in $(group analyzers) $(group site) $(group deb); do
	grep -qw -- "$package" doc/install.md || echo "$package: not in doc/install.md"
done | nothing "doc/install.md names what looks at the sources, and what makes the site and packages"
if [ -f configure.ac ]; then
	grep -o 'HAWSER_NEED(\[[^]]*\], \[[^]]*\]' configure.ac | sed 's/.*\[\(.*\)\]/\1/' | sort -u |
		comm -23 - "$scratch/list" | sed 's/$/: advised by configure, not in packages.txt/' |
		nothing "configure advises packages of the list"
fi
done_testing

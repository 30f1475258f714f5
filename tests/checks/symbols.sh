#!/bin/sh
# What the shared library exports is what the public headers declare: nothing less, nothing more; and each function is called
# by another stage, by the program, a test, or through the bindings.
# SPDX-License-Identifier: GPL-3.0-or-later
here=$PWD
. "$(dirname "$0")/lib.sh"

library=$here/.libs/libhawser.so
if [ ! -f "$library" ]; then
	skip "no shared library in this build"
	done_testing
	exit 0
fi
# A function compiled for several processors brings a ".resolver", which no C program can name.
${NM:-nm} -D --defined-only "$library" | awk '{ print $NF }' | grep -v '\.resolver$' | sort >"$scratch/exported"

# Functions declared: a hawser_ name straight before a parenthesis, in the preprocessed header.
echo '#include <hawser/hawser.h>' | ${CC:-cc} -std=c11 -Iinclude -E -P -x c - |
	tr '\n' ' ' | grep -oE '((enum|struct) )?\bhawser_[a-z0-9_]+ *\(' | grep -v '^[es]' |
	tr -d ' (' | sort -u >"$scratch/declared"

try "the headers declare functions ($(wc -l <"$scratch/declared"))" test -s "$scratch/declared"
grep -v '^hawser_[a-z]' "$scratch/exported" | nothing "only hawser_* symbols are exported"
comm -23 "$scratch/declared" "$scratch/exported" | sed 's/$/: declared, not exported/' |
	nothing "every public function is exported"
comm -13 "$scratch/declared" "$scratch/exported" | sed 's/$/: exported, not in a public header/' |
	nothing "every exported function is public"
# Objects of batches that are no longer made may lie about: they call what other objects call, or what is gone.
(cd "$here" && find src tests -name '*.o' -exec ${NM:-nm} -A {} +) 2>/dev/null | awk '
	$NF ~ /^hawser_[a-z]/ { split($1, path, "/"); stage = path[1] == "tests" ? "tests" : path[2]
		if ($(NF - 1) ~ /^[Ti]$/) own[$NF] = stage
		if ($(NF - 1) == "U") calls[$NF] = calls[$NF] " " stage }
	END { for (name in own) { n = split(calls[name], caller, " ")
		while (n > 0 && caller[n] == own[name]) n--
		if (n > 0) print name } }' | sort >"$scratch/called"
# settle.py calls all hawser_..._settle; names in quotes are called by name.
comm -23 "$scratch/exported" "$scratch/called" | grep -v '_settle$' | while read -r name; do
	grep -qrw "$name" tests/checks/bindings python examples || echo "$name: no other stage calls it, and no test"
done | nothing "every public function is called"
done_testing

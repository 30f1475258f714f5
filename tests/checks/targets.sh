#!/bin/sh
# No rule of ours waits for a target that starts a second make in the same folder, such as automake's all: with
# make -j that make and the first would write the same objects at the same time. all-am starts none. And make -n, which
# does start such makes, does no harm.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"

# second_make FILE...: "file:line: target waits for prerequisite", a line each.
second_make() {
	awk '
	function rule(text, colon, names, n, i) {
		colon = index(text, ":")
		target = substr(text, 1, colon - 1)
		if (target == ".PHONY") return
		n = split(substr(text, colon + 1), names, /[ \t]+/)
		for (i = 1; i <= n; i++) {
			if (names[i] == "") continue
			waits++
			where[waits] = FILENAME ":" FNR; who[waits] = target; on[waits] = names[i]
		}
	}
	{ line = more $0; more = "" }
	/\\$/ { more = substr(line, 1, length(line) - 1) " "; next }
	# a recipe that starts make, by itself or by a script
	line ~ /^\t/ { if (line ~ /\$\(MAKE\)/) starts[target] = 1; next }
	line ~ /^[^ #=:]+( [^ #=:]+)*:([^=]|$)/ { rule(line) }
	END {
		for (i = 1; i <= waits; i++)
			if (on[i] in starts || on[i] ~ /^(all|check|check-am|check-local|dist[a-z]*|(un)?install[a-z-]*)$/)
				print where[i] ": " who[i] " waits for " on[i] ", which starts a second make: wait for all-am"
	}' "$@"
}

makefiles=$(find . -name '*.mk' -not -path './build*/*' | sort)
second_make Makefile.am $makefiles | nothing "no rule waits for a target that starts a second make"

# The check itself: of these rules the second, the third and the fourth are wrong.
cat >"$scratch/wrong.mk" <<'END'
fine: all-am first.o
programs: all first.o
longer: first.o \
	check
twice: own-make
own-make: all-am
	cd elsewhere && $(MAKE)
variable := all
END
second_make "$scratch/wrong.mk" | sed 's/.*\.mk:\([0-9]*\): \([a-z]*\) .*for \([a-z-]*\),.*/\1 \2 \3/' >"$scratch/found"
printf '2 programs all\n4 longer check\n5 twice own-make\n' | diff - "$scratch/found" |
	nothing "such rules are found"

# make -n starts recipes that have $(MAKE): of check-kernels it removes no logs.
kernels=$PWD/tests/kernels/run.sh
mkdir "$scratch/kernels" && : >"$scratch/kernels/Zen.log"
(cd "$scratch" && MAKEFLAGS=kn KERNELS=Zen KERNEL_TESTS=unit/status KERNEL_FLAGS= sh "$kernels") >"$scratch/why" 2>&1
test -f "$scratch/kernels/Zen.log"
verdict $? "make -n check-kernels keeps the logs of the last run"
done_testing

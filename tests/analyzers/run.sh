#!/bin/sh
# tests/analyzers/run.sh - the sources through gcc -fanalyzer, clang-tidy and cppcheck; `make check-analyzers`
# calls it. It prints the table of doc/robustness.md: what is open, and how many findings are annotated.
# What a tool said is in analyzers/. A tool that is not installed is left out, which is said. The status
# is 0 where there is nothing new.
#
# What is found is mended, or annotated with why it is none: for gcc in tests/analyzers/gcc.txt, for
# the others in the line above, NOLINTNEXTLINE(check): why, or cppcheck-suppress check ; why.
# `run.sh counts` prints the annotations alone, which tests/checks/docs.sh compares with the document.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
: "${SRCDIR:?}"
LC_ALL=C
export LC_ALL
cd "$SRCDIR" || exit 1

annotated() {
	find src include -name '*.[ch]' -exec cat {} + | grep -c "$1"
}

# row TOOL OPEN: the annotations of a tool, and where they are.
row() {
	case $1 in
		gcc*) where="$(grep -vc '^#' tests/analyzers/gcc.txt), in \`tests/analyzers/gcc.txt\`" ;;
		clang*) where="$(annotated 'NOLINTNEXTLINE('), by \`NOLINTNEXTLINE\` in the line above" ;;
		*) where="$(annotated 'cppcheck-suppress'), by \`cppcheck-suppress\` in the line above" ;;
	esac
	echo "| $1 | $2 | $where |"
}
if [ "${1-}" = counts ]; then
	for tool in 'gcc -fanalyzer' clang-tidy cppcheck; do
		row "$tool" 0
	done
	exit
fi
: "${ANALYZER_FLAGS:?}"
cd - >/dev/null || exit 1
jobs=${ANALYZER_JOBS:-$(nproc 2>/dev/null || echo 1)}
gcc=${ANALYZER_GCC:-gcc}
mkdir -p analyzers && cd analyzers || exit 1
out=$PWD
cd "$SRCDIR" || exit 1
bad=0

# each LOG COMMAND...: the command on every source, several at a time, their words together in LOG.
each() {
	log=$1
	shift
	find src -name '*.c' | sort | xargs -P "$jobs" -I '{}' "$@" >"$log" 2>&1
}

# verdict TOOL FINDINGS: FINDINGS has one a line.
verdict() {
	found=$(wc -l <"$2")
	row "$1" "$found"
	[ "$found" -eq 0 ] && return
	bad=1
	head -n 20 "$2"
	echo "see $out"
}

# "file function warning" of each finding of gcc's.
gcc_findings() {
	awk '/: In function / { split($0, part, "\047"); name = part[2] }
		/warning:.*\[-Wanalyzer/ { split($0, part, ":"); sub(/.*\[-Wanalyzer-/, ""); sub(/\].*/, "")
			print part[1], name, $0 }' "$1" | sort -u
}

echo 'int main(void) { return 0; }' >"$out/try.c"
if $gcc -fanalyzer -c -o /dev/null "$out/try.c" 2>"$out/try.log" && [ ! -s "$out/try.log" ]; then
	# without optimisation, so that what it says is about the source
	each "$out/gcc.log" $gcc $ANALYZER_FLAGS -DHAWSER_ANALYSED -O0 -fanalyzer -fanalyzer-verbosity=1 \
		-c -o /dev/null '{}'
	gcc_findings "$out/gcc.log" >"$out/gcc.findings"
	sed '/^#/d; s/: .*//' tests/analyzers/gcc.txt | sort -u >"$out/gcc.known"
	comm -23 "$out/gcc.findings" "$out/gcc.known" >"$out/gcc.new"
	# the list is of Debian 12's gcc: others may find less
	case $($gcc -dumpversion) in
		12*) comm -13 "$out/gcc.findings" "$out/gcc.known" |
			sed 's/$/: not found any more: take it off the list/' >>"$out/gcc.new" ;;
	esac
	verdict "gcc -fanalyzer" "$out/gcc.new"
else
	echo "gcc -fanalyzer left out: $gcc has none (Debian: gcc)"
fi

if command -v clang-tidy >/dev/null; then
	# a process for each file: clang-tidy 14 loses track of va_start where it has several
	each "$out/clang-tidy.log" clang-tidy --quiet '{}' -- $ANALYZER_FLAGS
	grep -E '(error|warning): ' "$out/clang-tidy.log" | sed "s|^$PWD/||" | sort -u >"$out/clang-tidy.new"
	verdict clang-tidy "$out/clang-tidy.new"
else
	echo "clang-tidy left out: it is not installed (Debian: clang-tidy)"
fi

if command -v cppcheck >/dev/null; then
	# with -D it examines one configuration, that of config.h
	cppcheck -q -j "$jobs" --std=c11 --platform=unix64 --library=posix --inline-suppr \
		--enable=warning,performance,portability -DHAVE_CONFIG_H --include="${out%/*}/config.h" \
		-Iinclude -Isrc -I. src >"$out/cppcheck.log" 2>&1
	grep -E '^[^ ]*: (error|warning|style|performance|portability): ' "$out/cppcheck.log" \
		>"$out/cppcheck.new"
	verdict cppcheck "$out/cppcheck.new"
else
	echo "cppcheck left out: it is not installed (Debian: cppcheck)"
fi
exit $bad

#!/bin/sh
# tests/analyzers/run.sh - the sources through gcc -fanalyzer, clang-tidy and cppcheck; `make check-analyzers`
# calls it. One line a tool: what it found and how many findings are annotated. What it said is in
# analyzers/. A tool that is not installed is left out, which is said. The status is 0 where there is
# nothing new.
#
# What is found is mended, or annotated with why it is none: for gcc in tests/analyzers/gcc.txt, for
# the others in the line above, NOLINTNEXTLINE(check): why, or cppcheck-suppress check ; why.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
: "${SRCDIR:?}" "${ANALYZER_FLAGS:?}"
LC_ALL=C
export LC_ALL
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

# verdict TOOL FINDINGS ANNOTATED: FINDINGS has one a line.
verdict() {
	found=$(wc -l <"$2")
	echo "$1: $found findings, $3 annotated"
	[ "$found" -eq 0 ] && return
	bad=1
	head -n 20 "$2"
	echo "see $out"
}

annotated() {
	find src include -name '*.[ch]' -exec cat {} + | grep -c "$1"
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
	verdict "gcc -fanalyzer" "$out/gcc.new" "$(wc -l <"$out/gcc.known")"
else
	echo "gcc -fanalyzer left out: $gcc has none (Debian: gcc)"
fi

if command -v clang-tidy >/dev/null; then
	# a process for each file: clang-tidy 14 loses track of va_start where it has several
	each "$out/clang-tidy.log" clang-tidy --quiet '{}' -- $ANALYZER_FLAGS
	grep -E '(error|warning): ' "$out/clang-tidy.log" | sed "s|^$PWD/||" | sort -u >"$out/clang-tidy.new"
	verdict clang-tidy "$out/clang-tidy.new" "$(annotated 'NOLINTNEXTLINE(')"
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
	verdict cppcheck "$out/cppcheck.new" "$(annotated 'cppcheck-suppress')"
else
	echo "cppcheck left out: it is not installed (Debian: cppcheck)"
fi
exit $bad

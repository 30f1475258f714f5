#!/bin/sh
# tests/fuzz/run.sh - build the fuzz targets in sanitizers/ and run them in fuzzing/; `make fuzz` calls it. One line a
# target: inputs tried, edges covered, how it ended. The status is 0 where nothing was found, and
# where there is no libFuzzer, which is said.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
: "${SRCDIR:?}" "${FUZZ_TARGETS:?}"
clang=${FUZZ_CC:-clang}
mkdir -p fuzzing/findings || exit 1
echo 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { (void)d; (void)n; return 0; }' \
	>fuzzing/try.c
if ! $clang -fsanitize=fuzzer,address,undefined -o fuzzing/try fuzzing/try.c 2>/dev/null; then
	echo "fuzzing skipped: $clang has no libFuzzer (Debian: clang and libclang-rt-dev)"
	exit 0
fi
# The objects are those of make check-sanitizers.
${MAKE:-make} sanitizers/config.status >fuzzing/build.log 2>&1 &&
	${MAKE:-make} -C sanitizers $FUZZ_TARGETS >>fuzzing/build.log 2>&1 || { tail -n 20 fuzzing/build.log; exit 1; }

cd fuzzing || exit 1
export ASAN_OPTIONS=detect_leaks=1:quarantine_size_mb=16:allocator_may_return_null=1
export LSAN_OPTIONS=suppressions="$SRCDIR/tests/fuzz/leaks.supp":print_suppressions=0
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
# Addresses steer libFuzzer's choices: the same ones each time, where the system allows it.
fixed=
[ "$FUZZ_SEED" -eq 0 ] || ! setarch -R true 2>/dev/null || fixed='setarch -R'
# one TARGET: its inputs; the verdict in NAME.verdict, the status in NAME.ended.
one() {
	name=${1##*/fuzz-}
	found=corpus/$name
	if [ "$FUZZ_SEED" -ne 0 ]; then # what earlier runs found would change this one
		found=seeded/$name
		rm -rf "$found"
	fi
	mkdir -p "$found"
	$fixed "../sanitizers/$1" "$found" "$SRCDIR/tests/fuzz/corpus/$name" \
		-dict="$SRCDIR/tests/fuzz/corpus/$name.dict" -artifact_prefix="findings/$name-" \
		-max_total_time="$FUZZ_SECONDS" -runs="$FUZZ_RUNS" -seed="$FUZZ_SEED" \
		-timeout="$FUZZ_TIMEOUT" -rss_limit_mb=2048 -max_len=4096 -print_final_stats=1 >"$name.log" 2>&1
	status=$?
	runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$name.log")
	edges=$(sed -n 's/.* cov: \([0-9]*\).*/\1/p' "$name.log" | tail -n 1)
	{
		echo "fuzz-$name: ${runs:-no} inputs, ${edges:-no} edges, status $status"
		if [ "$status" -ne 0 ]; then
			grep -E 'ERROR|SUMMARY|broken promise|^message|runtime error' "$name.log" | head -n 5
			echo "see fuzzing/$name.log and fuzzing/findings/$name-*"
		fi
	} >"$name.verdict"
	echo "$status" >"$name.ended"
}

# FUZZ_JOBS targets at a time
at=0
rm -f ./*.verdict ./*.ended
for target in $FUZZ_TARGETS; do
	one "$target" &
	at=$((at + 1))
	[ $((at % ${FUZZ_JOBS:-1})) -ne 0 ] || wait
done
wait
bad=0
for target in $FUZZ_TARGETS; do
	name=${target##*/fuzz-}
	cat "$name.verdict" || bad=1
	[ "$(cat "$name.ended")" = 0 ] || bad=1
done
exit $bad

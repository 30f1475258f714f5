#!/bin/sh
# tests/kernels/run.sh: `make check-kernels`. Runs the tests that KERNEL_TESTS and KERNEL_FLAGS choose (tests/run) once under each of KERNELS: names of
# OpenBLAS's kernels, and "reference" for Debian's reference BLAS and LAPACK. A kernel runs only if the probe,
# a small program, ends well under it and tells its name; otherwise the line says why it is left out. Logs stay in
# kernels/; the exit status is 1 if a test failed or if nothing ran.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
# make -n runs this script too, since the line that starts it has $(MAKE). The first word of MAKEFLAGS is the letters of
# make's options, if any.
first=${MAKEFLAGS-}
case ${first%% *} in
	*[-=]*) ;;
	*n*)
		echo "check-kernels: would run under $KERNELS: $KERNEL_TESTS $KERNEL_FLAGS"
		exit 0 ;;
esac
probe=tests/kernels/probe
rm -rf kernels
mkdir kernels || exit 1
: >kernels/table
: >kernels/failures

# Where the probe's functions come from by default, and the name of the kernel that OpenBLAS takes by itself.
# shellcheck disable=SC2046 # words
set -- $(env -u OPENBLAS_CORETYPE $probe)
if [ $# -ne 4 ]; then
	echo "check-kernels: the probe failed"
	exit 1
fi
default=$1
blas=$2
echo "check-kernels: the BLAS here is $blas, its kernel by default $default"

# left_out NAME WHY
left_out() {
	printf '%-14s left out: %s\n' "$1" "$2"
	printf '%s\t-\t-\t-\t-\t%s\n' "$1" "left out: $2" >>kernels/table
}

# with NAME COMMAND...: run it with that BLAS.
with() {
	name=$1
	shift
	if [ "$name" = reference ]; then
		env LD_PRELOAD="$preload" "$@"
	else
		env OPENBLAS_CORETYPE="$name" "$@"
	fi
}

# usable NAME: whether programs get that BLAS; otherwise the reason is in $why.
usable() {
	if [ "$1" = reference ]; then
		folder=${blas%/*}
		preload=${KERNEL_REFERENCE:-$folder/blas/libblas.so.3:$folder/lapack/liblapack.so.3}
		why="no $preload (Debian packages libblas3 and liblapack3)"
		[ -f "${preload%:*}" ] && [ -f "${preload#*:}" ] || return 1
	elif [ "$default" = none ]; then
		why="that BLAS is not OpenBLAS, or is linked statically"
		return 1
	fi
	# shellcheck disable=SC2046 # words
	set -- "$1" $(with "$1" "$probe" 2>/dev/null)
	why="the processor cannot run it"
	[ $# -eq 5 ] || return 1
	if [ "$1" = reference ]; then
		why="the program still takes $3 and $5"
		[ "$3" = "${preload%:*}" ] && [ "$4" = "$3" ] && [ "$5" = "${preload#*:}" ]
	else
		why="this OpenBLAS has no such kernel and takes $2"
		[ "$2" = "$1" ]
	fi
}

# children_time: leaves the seconds of processor time of all children so far in $seconds. A subshell would report
# its own children.
children_time() {
	times >kernels/times
	seconds=$(awk 'function seconds(text, part) { split(text, part, /[ms]/); return 60*part[1] + part[2] }
		NR == 2 { print int(seconds($1) + seconds($2) + 0.5) }' kernels/times)
}

# The tests under one kernel. The preloaded libraries are for the tests alone, not for make.
run_tests() {
	children_time
	before=$seconds
	case $1 in
		reference) setting="LD_PRELOAD='$preload'; export LD_PRELOAD;" ;;
		*) setting="OPENBLAS_CORETYPE=$1; export OPENBLAS_CORETYPE;" ;;
	esac
	"$MAKE" --no-print-directory check-local TESTS="$KERNEL_TESTS" RUN_RESULTS="kernels/$1.tsv" KERNEL_SETTING="$setting" \
		RUN_FLAGS="$KERNEL_FLAGS -l kernels/$1" >"kernels/$1.out" 2>&1
	status=$?
	children_time
	spent=$((seconds - before))
	if [ ! -s "kernels/$1.tsv" ]; then
		result="FAILED: no test ran"
		set -- "$1" 0 1 0
	else
		# shellcheck disable=SC2046 # words
		set -- "$1" $(awk -F '\t' 'NR > 1 { p += $3; f += $4; s += $5 } END { print p + 0, f + 0, s + 0 }' "kernels/$1.tsv")
		result=passed
		[ "$status" -eq 0 ] && [ "$3" -eq 0 ] && [ "$2" -gt 0 ] || result=FAILED
	fi
	printf '%-14s %s: %s passed, %s failed, %s skipped, %s s of processor time\n' "$1" "$result" "$2" "$3" \
		"$4" "$spent"
	printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$1" "$2" "$3" "$4" "$spent" "$result" >>kernels/table
	sed -n "s|^FAIL: |under $1: |p" "kernels/$1.out" >>kernels/failures
}

for kernel in $KERNELS; do
	if usable "$kernel"; then
		run_tests "$kernel"
	else
		left_out "$kernel" "$why"
	fi
done

echo
awk -F '\t' 'BEGIN { printf "%-14s %7s %7s %7s %7s  %s\n", "kernel", "passed", "failed", "skipped", "s", "result" }
	{ printf "%-14s %7s %7s %7s %7s  %s\n", $1, $2, $3, $4, $5, $6 }' kernels/table
cat kernels/failures
if [ "$default" = none ] && ! grep -qw passed kernels/table; then
	echo "check-kernels: skipped, since this BLAS has no kernels to choose from"
	exit 0
fi
grep -q passed kernels/table && ! grep -q FAILED kernels/table

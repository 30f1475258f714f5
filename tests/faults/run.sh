#!/bin/sh
# tests/faults/run.sh SCRATCH [FAULT...]: which step of the checks catches each fault of faults.tsv; tests/README.md, "Seeded
# faults". In SCRATCH are then results.tsv, a row a fault, and sums.txt. What is there already is not made again, so that
# a run that was ended goes on.
#
# A fault is caught by a set of cases if one of those that reach it fails, or takes ten times as long, passes without the
# fault, and fails again with it. The rest of the set is then not run, nor the sets after it (ALL=1: all sets). The sanitizers are for
# what the others have not caught and for faults of memory.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
table=$here/faults.tsv
AWK=${AWK-awk}
OPENBLAS_NUM_THREADS=1
export AWK OPENBLAS_NUM_THREADS
unset HAWSER_FAULT HAWSER_FAULTS_REACHED SRCDIR MAKEFLAGS MAKELEVEL
mkdir -p "${1:?name a folder for the builds}" || exit 1
scratch=$(cd "$1" && pwd)
shift
faults=${*:-$(sed 1d "$table" | cut -f 1)}

die() {
	echo "faults: $*" >&2
	exit 1
}

# field NUMBER COLUMN: of the table.
field() {
	$AWK -F '\t' -v number="$1" -v column="$2" '$1 == number { print $column }' "$table"
}

# --- the trees and the builds ---

# build FOLDER ARGUMENTS OF CONFIGURE: the program and the tests, from the tree with faults.
build() {
	folder=$scratch/$1
	shift
	[ ! -f "$folder/complete" ] || return 0
	echo "faults: building in $folder"
	mkdir -p "$folder"
	(cd "$folder" && { [ -f config.status ] || ../seeded/configure -q "$@"; } &&
		make -j "${JOBS-2}" && make -j "${JOBS-2}" check-programs) >"$folder/build.log" 2>&1 ||
		die "the build failed, see $folder/build.log"
	touch "$folder/complete"
}

if [ ! -f "$scratch/seeded/configure" ]; then
	"$here/seed.sh" "$table" "$top" "$scratch/seeded" || die "the faults do not fit the sources"
	(cd "$scratch/seeded" && autoreconf -i) >"$scratch/autoreconf.log" 2>&1 || die "autoreconf failed"
fi
# What tests read of the tree, and the compilers: sources without switches, with one fault at most.
if [ ! -d "$scratch/plain" ]; then
	mkdir -p "$scratch/plain"
	(cd "$top" && git ls-files -z | xargs -0 tar -cf - --) | (cd "$scratch/plain" && tar -xf -)
fi

# plain FAULT: that fault alone stands in the sources; 0: none.
standing=
plain() {
	[ -z "$standing" ] || cp "$top/$standing" "$scratch/plain/$standing"
	standing=
	[ "$1" != 0 ] || return 0
	standing=$(field "$1" 4)
	$AWK -v file="$standing" -v only="$1" -f "$here/seed.awk" "$table" "$top/$standing" >"$scratch/plain/$standing"
}
trap 'plain 0' EXIT

# --- one case ---

seconds() {
	read -r up _ </proc/uptime
	echo "$up"
}

# passes CASE LIMIT: in the current build folder, with the environment's fault; no process takes more than so many seconds of
# processor time.
passes() {
	(
		ulimit -t "$2"
		SRCDIR=$scratch/plain exec timeout -k 5 900 sh "$here/suite.sh" run "$1"
	) >"$scratch/output" 2>&1 </dev/null &&
		grep -q '^1\.\.' "$scratch/output" && ! grep '^not ok' "$scratch/output" | grep -qv '# TODO'
}

# reach SET: run its cases without a fault; reach-SET.tsv: case, seconds, numbers of the faults that it reaches.
reach() {
	sh "$here/suite.sh" list | $AWK -F '\t' -v set="$1" '$1 == set { print $2 }' >"$scratch/cases-$1"
	touch "$scratch/reach-$1.tsv"
	while read -r case; do
		! cut -f 1 "$scratch/reach-$1.tsv" | grep -qx "$case" || continue
		: >"$scratch/reached"
		from=$(seconds)
		if HAWSER_FAULTS_REACHED=$scratch/reached passes "$case" 600; then
			took=$(echo "$from $(seconds)" | $AWK '{ print $2 - $1 }')
			numbers=$(sort -u "$scratch/reached" | $AWK '{ printf ",%d", $1 } END { print "," }')
			printf '%s\t%s\t%s\n' "$case" "$took" "$numbers" >>"$scratch/reach-$1.tsv"
		else
			echo "faults: $case fails without a fault and is left out" >&2
			cp "$scratch/output" "$scratch/fails-$(basename "$case").log"
			printf '%s\t%s\t%s\n' "$case" 0 fails >>"$scratch/reach-$1.tsv"
		fi
	done <"$scratch/cases-$1"
}

# cases FAULT SET: those that reach it, the shortest first, with their seconds.
cases() {
	$AWK -F '\t' -v fault=",$1," -v sources=" $(sh "$here/suite.sh" sources | tr '\n' ' ')" '
		$3 != "fails" && (index($3, fault) || index(sources, " " $1 " ")) { print $2 "\t" $1 }' \
		"$scratch/reach-$2.tsv" | sort -n
}

# caught FAULT SET: print the case of the set that catches it, or "-".
caught() {
	cases "$1" "$2" >"$scratch/list"
	while read -r took case; do
		! grep -qx "$case" "$scratch/unsure" || continue
		limit=$($AWK -v took="$took" 'BEGIN { print int(10*took) + 20 }')
		! HAWSER_FAULT=$1 passes "$case" "$limit" || continue
		cp "$scratch/output" "$scratch/caught-$1-$2.log"
		plain 0
		without=1
		passes "$case" "$limit" || without=0
		plain "$1"
		if [ $without = 1 ]; then
			HAWSER_FAULT=$1 passes "$case" "$limit" && continue
			echo "$case"
			return
		fi
		echo "faults: $case fails without a fault too and is left out" >&2
		echo "$case" >>"$scratch/unsure"
	done <"$scratch/list"
	echo -
}

# warned FAULT: what a compiler's warning, an error in .ci/run, says of it, or "-".
warned() {
	cd "$scratch/plain" || exit 1
	for compiler in gcc clang; do
		# shellcheck disable=SC2086 # a list of flags
		"$compiler" $flags -c -o /dev/null "$(field "$1" 4)" >"$scratch/output" 2>&1 && continue
		if grep -q 'Werror' "$scratch/output"; then
			sed -n "s/.*\[-Werror[=,]*\(-W[^]]*\|[^]]*\)\]$/$compiler \1/p" "$scratch/output" | head -n 1
		else
			echo "does not compile"
		fi
		return
	done
	echo -
}

# --- all faults ---

# record FAULT STEP WHAT
record() {
	printf '%s\t%s\t%s\n' "$1" "$2" "$3" >>"$scratch/found.tsv"
	echo "faults: $1 ($(field "$1" 2), $(field "$1" 4)), $2: $3"
}

# known FAULT STEP: that was tried.
known() {
	$AWK -F '\t' -v fault="$1" -v step="$2" '$1 == fault && $2 == step { n++ } END { exit !n }' "$scratch/found.tsv"
}

# found FAULT: some step has caught it.
found() {
	[ -z "${ALL-}" ] || return 1
	$AWK -F '\t' -v fault="$1" '$1 == fault && $3 != "-" { n++ } END { exit !n }' "$scratch/found.tsv"
}

of_memory() {
	case $(field "$1" 2) in leaked*|beyond*|uninitialised*) ;; *) false ;; esac
}

touch "$scratch/found.tsv" "$scratch/unsure"
build build --disable-static
cd "$scratch/build" || exit 1
flags=$(sh "$here/suite.sh" flags)
warnings() {
	for fault in $faults; do
		known "$fault" warnings && continue
		plain "$fault"
		record "$fault" warnings "$(warned "$fault")"
	done
}
for set in quick longer; do
	cd "$scratch/build" || exit 1
	plain 0
	reach "$set"
	for fault in $faults; do
		known "$fault" "$set" && continue
		[ "$set" = quick ] || ! found "$fault" || continue
		plain "$fault"
		record "$fault" "$set" "$(caught "$fault" "$set")"
	done
	warnings
done

# The sanitizers run the cases of .ci/run, whatever their set; what they reach is known from above.
build sanitizers --enable-sanitizers --disable-shared CC="${SANITIZERS_CC-clang}" CFLAGS='-O1 -g'
cd "$scratch/sanitizers" || exit 1
plain 0
sh "$here/suite.sh" list | cut -f 2 >"$scratch/cases-sanitizers"
cat "$scratch/reach-quick.tsv" "$scratch/reach-longer.tsv" | $AWK -F '\t' '
	NR == FNR { has[$1] = 1; next }
	has[$1]' "$scratch/cases-sanitizers" - >"$scratch/reach-sanitizers.tsv"
: >"$scratch/unsure"
for fault in $faults; do
	known "$fault" sanitizers && continue
	of_memory "$fault" || ! found "$fault" || continue
	plain "$fault"
	record "$fault" sanitizers "$(caught "$fault" sanitizers)"
done

$AWK -f "$here/sums.awk" "$table" "$scratch/found.tsv" >"$scratch/results.tsv"
cat "$scratch/results.tsv"

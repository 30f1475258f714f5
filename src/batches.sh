#!/bin/sh
# src/batches.sh BUILD-FOLDER: let make compile the sources of a folder in batches, several as one, which takes two thirds of the
# processor time: most of it goes to the headers, and each is read once a batch. It is for compiling everything once, as
# quickstart does; where one file was changed, its whole batch is compiled again, so that who edits does without.
#
# It writes BUILD-FOLDER/GNUmakefile, which make prefers to Makefile: lists of objects that stand for those of automake, and the
# files of the batches, which include the sources. Remove GNUmakefile to compile file by file again.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
build=$1
here=$(cd "$(dirname "$0")" && pwd)
top=$(dirname "$here")
awk=${AWK:-awk}
makefile=$build/GNUmakefile.tmp

# objects NAME: the objects of a variable of Makefile, a line each.
objects() {
	for object in $("$awk" -v name="$1" '
		$1 == name && $2 == "=" { on = 1; sub(/^[^=]*=/, "") }
		on { more = sub(/\\$/, ""); for (i = 1; i <= NF; i++) print $i; on = more }' "$build/Makefile"); do
		case $object in
			'$('am__objects*) variable=${object#??}; objects "${variable%?}" ;;
			*) echo "$object" ;;
		esac
	done
}

# batch VARIABLE SUFFIX SUFFIX FOLDER: the batches of a list of objects, whose names are those of their sources. The suffix is as
# in Makefile, then as it is.
batch() {
	list=
	rest=
	sources=$(objects "$1" | sed "s/\\.$2\$/.c/")
	for source in $sources; do
		[ -f "$top/$source" ] || rest="$rest ${source%.c}.$3"
	done
	sources=$(for source in $sources; do [ ! -f "$top/$source" ] || echo "$source"; done)
	# shellcheck disable=SC2086 # names
	(cd "$top" && "$awk" -f src/batches.awk $sources) >"$build/batches"
	number=1
	while grep "^$number " "$build/batches" | sed 's/^[0-9]* //' >"$build/batch.c" && [ -s "$build/batch.c" ]; do
		name=$4/batch-$number
		cmp -s "$build/batch.c" "$build/$name.c" || mv -f "$build/batch.c" "$build/$name.c"
		list="$list $name.$3"
		number=$((number + 1))
	done
	rm -f "$build/batch.c" "$build/batches"
	echo "override $1 :=$rest$list"
}

{
	echo "# written by src/batches.sh"
	# Of the core, programs link only the objects that they call.
	for stage in continuation scene statics modes beam water net ropeway rod tow rom response study output; do
		mkdir -p "$build/src/$stage/.deps"
		batch "am_src_${stage}_lib${stage}_la_OBJECTS" lo lo "src/$stage"
	done
	mkdir -p "$build/src/cli/.deps"
	batch am_src_cli_libcli_a_OBJECTS '$(OBJEXT)' o src/cli
	for stage in core continuation scene statics modes beam contact water net ropeway rod tow rom response study output; do
		mkdir -p "$build/tests/$stage-batches/.deps"
		batch "am_tests_${stage}_OBJECTS" '$(OBJEXT)' o "tests/$stage-batches"
	done
	echo "include Makefile"
	echo "batches := \$(patsubst %.c,%,\$(wildcard src/*/batch-*.c tests/*-batches/batch-*.c))"
	# Names of one file may be those of local variables in another. gcc can tell these from the others.
	echo "\$(batches:=.lo) \$(batches:=.o): private AM_CFLAGS += -Wno-shadow \$(if \$(findstring gcc,\$(CC)),-Wshadow=local)"
	# What reads scenes and arguments and writes text computes next to nothing, and tests spend 3 % of their time outside the
	# libraries: gcc needs two thirds of the time for -O1, with which it can't tell of each value that it is set.
	echo "\$(filter src/cli/% tests/%,\$(batches:=.o)) \$(filter src/scene/% src/output/%,\$(batches:=.lo)): \\
		private override CFLAGS := \$(subst -O2,-O1,\$(CFLAGS)) \
		\$(if \$(findstring gcc,\$(CC)),-Wno-maybe-uninitialized)"
	# With sanitizers clang takes a quarter of the time for -O0. They judge the sources, not the tests, which instrumented take ten
	# times as long to compile; and alignment where there are tables of offsets.
	echo "ifneq (,\$(strip \$(SANITIZE_FLAGS)))"
	echo "\$(filter src/cli/%,\$(batches:=.o)) \$(filter src/output/%,\$(batches:=.lo)): private override CFLAGS := \\
		\$(subst -O1,-O0,\$(CFLAGS)) -fsanitize=alignment"
	echo "\$(filter tests/%,\$(batches:=.o)): private override CFLAGS := \\
		\$(filter-out -fsanitize%,\$(CFLAGS)) -O0 -fno-sanitize=all"
	# Models have arrays for the most coordinates on the stack, up to 690 kB where functions are inlined. AddressSanitizer would mark
	# them at each call as out of their scope and as within it, which takes 80 % of the time of responses.
	echo "\$(filter src/rom/%,\$(batches:=.lo)): private override CFLAGS += -fno-sanitize-address-use-after-scope"
	echo "endif"
	echo "\$(filter src/output/%,\$(batches:=.lo)): \$(BUILT_SOURCES)"
	echo "-include \$(wildcard src/*/.deps/batch-*.P*o tests/*-batches/.deps/batch-*.Po)"
} >"$makefile"
mv -f "$makefile" "$build/GNUmakefile"

#!/bin/sh
# The library as others use it: installed into a scratch tree, found by pkg-config, linked shared and
# static by the programs in examples/, which then run.
# SPDX-License-Identifier: GPL-3.0-or-later
here=$PWD
. "$(dirname "$0")/lib.sh"
cc=${CC:-cc}
stage=$scratch/stage

# Silent and serial: the jobserver of the make above is not passed down.
try "make install into a scratch tree" \
	env MAKEFLAGS= MAKELEVEL= "${MAKE:-make}" -s -C "$here" install DESTDIR="$stage"
for f in "$stage$INCLUDEDIR/hawser/hawser.h" "$stage$LIBDIR/pkgconfig/hawser.pc" \
	"$stage$BINDIR/hawser"; do
	try "installed: ${f#"$stage"}" test -s "$f"
done

# The usual way to use a staged tree. Paths of other packages get the prefix too, where nothing is;
# the compiler's own search path finds those.
PKG_CONFIG_SYSROOT_DIR=$stage
PKG_CONFIG_PATH=$stage$LIBDIR/pkgconfig
PKG_CONFIG_ALLOW_SYSTEM_CFLAGS=1
PKG_CONFIG_ALLOW_SYSTEM_LIBS=1
export PKG_CONFIG_SYSROOT_DIR PKG_CONFIG_PATH PKG_CONFIG_ALLOW_SYSTEM_CFLAGS
export PKG_CONFIG_ALLOW_SYSTEM_LIBS
pc=${PKG_CONFIG:-pkg-config}
# compile NAME EXAMPLE PKG-CONFIG-OPTIONS: the command line of the example's own comment.
compile() {
	# shellcheck disable=SC2046,SC2086 # lists of flags
	$cc -std=c11 -Wall -Wextra -Werror "examples/$2.c" $($pc $3 --cflags --libs hawser) \
		-o "$scratch/$1"
}
run() {
	LD_LIBRARY_PATH=$stage$LIBDIR${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH} "$@"
}

version=$(run "$stage$BINDIR/hawser" --version 2>"$scratch/why" | sed -n '1s/.* //p')
try "pkg-config and hawser --version agree" test "$($pc --modversion hawser)" = "$version"

if ls "$stage$LIBDIR"/libhawser.so >/dev/null 2>&1; then
	try "examples/statics.c builds, shared" compile statics-shared statics ""
	try "and runs" run "$scratch/statics-shared"
	run "$scratch/statics-shared" >"$scratch/shared.out" 2>/dev/null
	try "and closes: the last point is end B, 250 m and 10 m away" \
		grep -q '^ *250\.0000 *10\.0000 ' "$scratch/shared.out"
	try "examples/frf.c builds, shared" compile frf-shared frf ""
	try "and runs" run "$scratch/frf-shared" notebooks-data/scenes/b-table-4.2.yaml 0.98 1.02
	rm -f "$stage$LIBDIR"/libhawser.so*
else
	skip "no shared library in this build"
fi
if [ -f "$stage$LIBDIR/libhawser.a" ]; then
	try "examples/statics.c builds, static" compile statics-static statics --static
	"$scratch/statics-static" >"$scratch/static.out" 2>"$scratch/why"
	verdict $? "and runs without the shared library"
	[ ! -f "$scratch/shared.out" ] ||
		try "with the same output" cmp "$scratch/shared.out" "$scratch/static.out"
else
	skip "no static library in this build"
fi

try "make uninstall" \
	env MAKEFLAGS= MAKELEVEL= "${MAKE:-make}" -s -C "$here" uninstall DESTDIR="$stage"
find "$stage" -type f ! -name 'libhawser.so*' | sed "s|^$stage||; s|\$|: left behind|" |
	nothing "make uninstall leaves nothing"
done_testing

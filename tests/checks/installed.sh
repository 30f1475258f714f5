#!/bin/sh
# The library as others use it: installed into a scratch tree, found by pkg-config, linked shared and
# static by the programs in examples/, which then run.
# SPDX-License-Identifier: GPL-3.0-or-later
here=$PWD
. "$(dirname "$0")/lib.sh"
cc=${CC:-cc}
stage=$scratch/stage

# An administrator's empty folder: it is not the install's to remove.
mkdir -p "$stage$LIBDIR"
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
find "$stage" -type f | sed "s|^$stage||; s|\$|: left behind|" |
	nothing "make uninstall leaves no file"
find "$stage" -type d -empty ! -path "$stage$LIBDIR" | sed "s|^$stage||; s|\$|: left behind|" |
	nothing "make uninstall leaves no empty folder that the install made"
try "and keeps one that was there" test -d "$stage$LIBDIR"

# What tells the loader: ldconfig writes a cache of our own, of a folder of our own, with or without a
# root's rights as far as loader.sh can see. known is the folder that the cache covers.
known=$scratch/known
mkdir "$known" "$scratch/bin" "$scratch/other"
cp "$here"/.libs/libhawser.so.?.?.? "$known" 2>/dev/null
echo "$known" >"$scratch/ld.conf"
printf '#!/bin/sh\nexec %s -f %s -C %s "$@"\n' "$(PATH=$PATH:/sbin:/usr/sbin command -v ldconfig)" \
	"$scratch/ld.conf" "$scratch/ld.cache" >"$scratch/bin/ldconfig"
printf '#!/bin/sh\necho "$USER_ID"\n' >"$scratch/bin/id"
chmod +x "$scratch/bin/ldconfig" "$scratch/bin/id"
# told DESTDIR USER-ID LIBDIR PROGRAM: what loader.sh prints
told() {
	rm -f "$scratch/ld.cache"
	DESTDIR=$1 USER_ID=$2 PATH=$scratch/bin:$PATH sh packaging/loader.sh "$3" "$4" 2>&1
}
cached() {
	"$scratch/bin/ldconfig" -p 2>/dev/null | grep -q "libhawser.*$known"
}
if [ "$(uname -s)" = Linux ] && ls "$known"/libhawser.so.* >/dev/null 2>&1; then
	told "" 0 "$known" true >"$scratch/why"
	cached && [ ! -s "$scratch/why" ]
	verdict $? "root's install to a folder of the loader's enters the library in its cache"
	told "$stage" 0 "$known" false >"$scratch/why"
	[ ! -e "$scratch/ld.cache" ] && [ ! -s "$scratch/why" ]
	verdict $? "a staged install leaves the cache alone"
	told "" 0 "$scratch/other" true >"$scratch/why"
	[ ! -e "$scratch/ld.cache" ] && [ ! -s "$scratch/why" ]
	verdict $? "so does an install elsewhere, whose program starts"
	told "" 1000 "$known" false >"$scratch/out"
	try "who may not run ldconfig is told to" grep -q 'run ldconfig as root' "$scratch/out"
	told "" 0 "$scratch/other" false >"$scratch/out"
	try "a folder that the loader doesn't know is named" \
		grep -q "LD_LIBRARY_PATH=$scratch/other" "$scratch/out"
else
	skip "no shared library, or no ldconfig of Linux"
fi
done_testing

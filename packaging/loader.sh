#!/bin/sh
# loader.sh - after an install or an uninstall: let the dynamic loader know what changed. From
# Makefile.am:
#
#   loader.sh LIBDIR [PROGRAM]
#
# The loader finds a library of /usr/local/lib in its cache only, and ldconfig alone writes that. With
# --prefix=$HOME/x libtool puts the folder into the program, and the cache is left alone. A staged
# install (DESTDIR) is no install on this machine: nothing is done, as packagers expect.
# PROGRAM is then started; where it can't, the reason and what to do are printed. The exit status is 0:
# the files are installed.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
libdir=$1 program=${2-}
PATH=$PATH:/usr/sbin:/sbin
unset LD_LIBRARY_PATH
[ -z "${DESTDIR-}" ] && [ "$(uname -s)" = Linux ] || exit 0

# Does the cache cover LIBDIR? ldconfig lists its folders as "/usr/local/lib: (from ...)".
covered() {
	ldconfig -v -N -X 2>/dev/null | sed -n 's|^\(/[^:]*\):.*|\1|p' | grep -qxF -- "$libdir"
}

if [ "$(id -u)" -eq 0 ] && covered; then
	ldconfig || echo "warning: ldconfig failed (exit status $?)" >&2
fi
[ -n "$program" ] || exit 0
why=$("$program" --version 2>&1 >/dev/null) && exit 0
echo "warning: $program is installed but does not start: $why" >&2
if covered; then
	echo "warning: run ldconfig as root" >&2
else
	echo "warning: add $libdir to a file in /etc/ld.so.conf.d and run ldconfig as root," \
		"or set LD_LIBRARY_PATH=$libdir" >&2
fi
exit 0

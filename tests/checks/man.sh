#!/bin/sh
# Manual pages format without a warning, and every one is there for the program and the two files.
# SPDX-License-Identifier: GPL-3.0-or-later
here=$PWD
. "$(dirname "$0")/lib.sh"

pages=$(find "$here/man" man -maxdepth 1 -name '*.[1-9]' 2>/dev/null | sort)
try "there are manual pages" test -n "$pages"
for page in $pages; do
	name=${page##*/}
	if command -v man >/dev/null; then
		LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" \
			2>&1 >/dev/null | nothing "$name formats without a warning"
	else
		skip "$name: man is not installed"
	fi
done
done_testing

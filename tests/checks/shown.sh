#!/bin/sh
# The commands that README.md, pages of doc and the manual pages show work, and print what is shown (shown.py says how).
# SPDX-License-Identifier: GPL-3.0-or-later
BUILDDIR=${BUILDDIR-$PWD} MANDIR=${MANDIR-$PWD/man}
export BUILDDIR MANDIR
. "$(dirname "$0")/lib.sh"
if ! command -v python3 >/dev/null; then
	skip "python3 is not installed"
	done_testing
	exit
fi
python3 tests/checks/shown.py

#!/bin/sh
# tests/timed.sh TEST [ARGUMENTS]: run a test, then write its processor time where its output goes.
# make check starts every test through it; tests/times.sh reads the logs.
# SPDX-License-Identifier: GPL-3.0-or-later
"$@"
status=$?
echo "# processor time (user system) of the wrapper, then of the test:"
times
exit $status

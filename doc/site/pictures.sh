#!/bin/sh
# The pictures of the documentation site: pictures.sh OUT. Runs the commands that its pages show, in order, one page a process;
# what they print is compared with what is shown, as in the tests. A page whose text and program have not changed is not run again.
#   SRCDIR  the source tree     HAWSER  the program (./hawser)
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
out=$1
HAWSER=${HAWSER:-$PWD/hawser}
export HAWSER
libs=$(dirname "$HAWSER")/.libs
mkdir -p "$out"
runs=
for page in index tutorial gallery; do
	log=$out/$page.log
	state=$(cat "$SRCDIR/doc/$page.md" "$SRCDIR"/notebooks-data/scenes/* "$SRCDIR/tests/checks/shown.py" "$HAWSER" "$libs/hawser" \
		"$libs/libhawser.so" 2>/dev/null | cksum)
	if [ -f "$out/$page.state" ] && [ "$(cat "$out/$page.state")" = "$state" ]; then
		continue
	fi
	rm -rf "$out/$page.md" "$out/$page.state"
	HAWSER_PICTURES=$out python3 "$SRCDIR/tests/checks/shown.py" "$SRCDIR/doc/$page.md" >"$log" 2>&1 &
	runs="$runs $page:$!"
	eval "state_$page=\$state"
done
failed=
for run in $runs; do
	page=${run%:*}
	if wait "${run#*:}" && ! grep -q '^not ok' "$out/$page.log"; then
		eval "printf '%s\n' \"\$state_$page\"" >"$out/$page.state"
	else
		grep -A 3 '^not ok' "$out/$page.log" >&2 || tail -n 5 "$out/$page.log" >&2
		failed="$failed doc/$page.md"
	fi
done
[ -z "$failed" ] || { echo "make site: commands failed:$failed" >&2; exit 1; }

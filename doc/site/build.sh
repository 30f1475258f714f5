#!/bin/sh
# The documentation site: build.sh OUT, in the build folder; make site runs it. The sources of the site and its pictures are kept in
# OUT-work. Warnings of Sphinx are errors. Nothing is fetched.
#   SRCDIR   the source tree     VERSION  hawser's     MANDIR  the manual pages     HAWSER  the program
#   PICTURES no: without those that commands draw, which takes a third of the time
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
out=$1
here=$SRCDIR/doc/site
# The packages are for the system's Python, which need not be the first one in PATH.
for python in ${PYTHON:-python3 /usr/bin/python3}; do
	missing=
	for package in sphinx myst_parser furo; do
		"$python" -c "import $package" 2>/dev/null || missing="$missing$package "
	done
	[ -n "$missing" ] || break
done
command -v mandoc >/dev/null || missing="${missing}mandoc "
if [ -n "$missing" ]; then
	echo "make site: not found: ${missing% }: install the packages that packages.txt lists for the site" >&2
	exit 77
fi
case $out in /*) ;; *) out=$PWD/$out ;; esac
work=$out-work
mkdir -p "$work"
if [ "${PICTURES:-yes}" != no ]; then
	sh "$here/pictures.sh" "$work/pictures"
	pictures=$work/pictures
fi
# what make makes too, where nothing else of the build is needed
mkdir -p "$work/made/doc"
"$python" "$SRCDIR/tests/checks/messages.py" list "$SRCDIR" >"$work/made/doc/messages.md"
export HAWSER_VERSION="$VERSION" HAWSER_SITE="$work/source" PYTHONDONTWRITEBYTECODE=1
"$python" "$here/assemble.py" --source "$SRCDIR" --made "$work/made" --man "${MANDIR:-man}" --out "$work/source" ${pictures:+--pictures "$pictures"}
rm -rf "$out"
"$python" -m sphinx -q -W --keep-going -j "${JOBS:-1}" -b html -c "$here" -d "$work/doctrees" "$work/source" "$out"
rm -rf "$out/.buildinfo" "$out/objects.inv"

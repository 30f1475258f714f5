#!/bin/sh
# The Python package, with pytest on the sources; HAWSER_LONG=1 also installs it into a folder and runs it from there.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

version=$(sed -n 's/^AC_INIT(\[hawser\], \[\([^]]*\)\].*/\1/p' "$top/configure.ac")
try "python/pyproject.toml has version $version" grep -q "^version = \"$version\"$" "$top/python/pyproject.toml"

with=
for candidate in python3 /usr/bin/python3; do
	"$candidate" -c 'import numpy, pytest' 2>/dev/null && with=$candidate && break
done
library=${HAWSER%/hawser}/libhawser.so
if [ -z "$with" ]; then
	skip "the package: python3-numpy or python3-pytest is not installed"
elif [ ! -f "$library" ]; then
	skip "the package: no shared library in this build"
else
	HAWSER_LIBRARY=$library PYTHONDONTWRITEBYTECODE=1 MPLCONFIGDIR=$scratch
	export HAWSER HAWSER_LIBRARY PYTHONDONTWRITEBYTECODE MPLCONFIGDIR
	"$with" -m pytest -q -p no:cacheprovider --tb=short --basetemp="$scratch/pytest" "$top/python/tests" \
		>"$scratch/why" 2>&1
	verdict $? "the tests in python/tests"
	if "$with" -c 'import mypy' 2>/dev/null && [ -n "${HAWSER_LONG:-}" ]; then
		(cd "$top/python" && "$with" -m mypy --cache-dir="$scratch/mypy") >"$scratch/why" 2>&1
		verdict $? "the annotations hold (mypy --strict)"
	fi
	if "$with" -c 'import setuptools, pip' 2>/dev/null && [ -n "${HAWSER_LONG:-}" ]; then
		mkdir "$scratch/tree" && cp -r "$top/python" "$top/include" "$scratch/tree"
		try "pip installs it" "$with" -m pip install -q --no-build-isolation --no-deps --no-warn-script-location \
			--target "$scratch/site" "$scratch/tree/python"
		PYTHONPATH=$scratch/site
		export PYTHONPATH
		try "  and it runs without the sources" "$with" -c 'import hawser, sys
assert hawser.__file__.startswith(sys.argv[1])
assert hawser.Statics(sys.argv[2]).T0 == 80000.0' "$scratch/site" "$top/notebooks-data/scenes/chairlift.yaml"
		unset PYTHONPATH
	fi
fi
done_testing

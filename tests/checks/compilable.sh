#!/bin/sh
# Each public header compiles alone as C11, and all together as C++, without a warning.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"

cxx=
for candidate in g++ clang++; do
	command -v $candidate >/dev/null && cxx=$candidate && break
done
for f in include/hawser/*.h; do
	name=hawser/${f##*/}
	echo "#include <$name>" | tee -a "$scratch/all.cc" >"$scratch/alone.c"
	try "$name is C11" ${CC:-cc} -std=c11 -pedantic-errors -Wall -Wextra -Werror -Iinclude \
		-fsyntax-only "$scratch/alone.c"
done
if [ -n "$cxx" ]; then
	try "all are C++" "$cxx" -std=c++11 -Wall -Wextra -Werror -Iinclude -fsyntax-only "$scratch/all.cc"
else
	skip "all are C++: no C++ compiler here"
fi
done_testing

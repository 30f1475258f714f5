#!/bin/sh
# The library from other languages: a C++ program and a Python program (ctypes) compute the same, move
# results and watch progress; hawser_sizeof knows every public structure, and comments the defaults of options.
# SPDX-License-Identifier: GPL-3.0-or-later
here=$PWD
. "$(dirname "$0")/lib.sh"

scene=notebooks-data/scenes/chairlift.yaml
cat >"$scratch/want" <<'END'
2 modes, 1.449219195 rad/s
3 modes, 1.449219195 rad/s
4 modes, 1.449219195 rad/s
response: 0 points, 0 events; 5 of N points, interrupted
sizes agree
first rows: g the distance of the ends catenary spectral spectral legendre gauss balance growth multiple-scales
END
# The number of points is not the subject.
agrees() {
	sed 's/; 5 of [0-9]* points/; 5 of N points/' "$1" | diff "$scratch/want" - >"$scratch/why"
	verdict $? "$2"
}

sed -n 's/^struct \(hawser_[a-z_0-9]*\) {.*/\1/p' include/hawser/*.h | sort >"$scratch/declared"
sed -n 's/^\tROW(\(hawser_[a-z_0-9]*\)).*/\1/p' src/study/sizes.c | sort >"$scratch/rows"
diff "$scratch/declared" "$scratch/rows" | sed -n 's/^</include\/hawser: not in src\/study\/sizes.c: /p
	s/^>/src\/study\/sizes.c: no public structure: /p' |
	nothing "hawser_sizeof knows the $(wc -l <"$scratch/declared") public structures"
grep -nE '^(const )?struct .*\(.*\*(count|n|rows)\)' include/hawser/*.h |
	nothing "tables of rows are read by index, NULL beyond the last"

if [ ! -f "$here/.libs/libhawser.so" ]; then
	skip "no shared library in this build"
	done_testing
	exit 0
fi
LD_LIBRARY_PATH=$here/.libs${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export LD_LIBRARY_PATH

cxx=
for candidate in g++ clang++; do
	command -v $candidate >/dev/null && cxx=$candidate && break
done
if [ -n "$cxx" ]; then
	try "a C++ program builds" "$cxx" -std=c++11 -Wall -Wextra -Werror -Iinclude \
		tests/checks/bindings/frf.cpp -o "$scratch/frf" -L"$here/.libs" -lhawser
	"$scratch/frf" $scene >"$scratch/cpp" 2>"$scratch/why"
	verdict $? "and runs"
	agrees "$scratch/cpp" "with the right numbers"
	"$scratch/frf" missing.yaml >/dev/null 2>"$scratch/error"
	try "a failure is an exception with the library's message" grep -q 'missing.yaml' "$scratch/error"
else
	skip "no C++ compiler here"
fi
if python3 -c 'import ctypes' 2>/dev/null; then
	python3 tests/checks/bindings/frf.py "$here/.libs/libhawser.so" $scene >"$scratch/python" \
		2>"$scratch/why"
	verdict $? "a Python program runs"
	agrees "$scratch/python" "with the right numbers"
	python3 tests/checks/bindings/settle.py "$here/.libs/libhawser.so" 2>&1 |
		nothing "defaults of options are those of their comments"
else
	skip "python3 with ctypes is not there"
fi
done_testing

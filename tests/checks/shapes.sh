#!/bin/sh
# Every pointer to numbers in a public header has its shape in a comment: a field on its own line
# ("[n][n] row-major", or with the fields declared together), a parameter in the comment before its
# function ("restoring [n]"), or it is said to be one value by naming it with its star ("*value").
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"

awk -f tests/checks/shapes.awk include/hawser/*.h | nothing "pointers to numbers have shapes"

# The check itself can fail: each of these lines but the last two breaks the rule once.
cat >"$scratch/bad.h" <<'END'
struct s {
	double *a;
	int *b; /* no shape here */
	double *c; /* [n] good */
};
/* Nothing of use. */
void f(double *x, const int *y);
/* x [n] and *y are fine here. */
void g(double *x, const double *y,
       double z);
END
findings=$(awk -f tests/checks/shapes.awk "$scratch/bad.h" | tee "$scratch/why" | wc -l)
try "and the check finds four planted slips" test "$findings" -eq 4
done_testing

/* contact/friction-corner.c - a node with several contacts.
 *
 * Of the impulses, that of the first contact is H_0 (s - sum of H_c^T r_c) with the force s on the
 * node, the others are unknowns beside du of the node. Where contacts that stick or are closed
 * determine the velocity more than once, their impulses are not unique: `weak`, a compliance that is
 * small and acts on the step alone, keeps them where they are, and does not change the solution.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "contact/friction.h"
#include "core/vec3.h"

enum { MOST = 3*HAWSER_CONTACTS_AT_NODE, WIDE = MOST + 4 };
/* Compliance over 1/rho: far above round-off, and small, as an error of the impulses shrinks by this
 * factor in each step. */
static const double weak = 1e-9;

/* Solve A x = right sides in place, rows A [n] of n + 4; 0 if it is singular. */
static int solve(double A[MOST][WIDE], int n)
{
	for (int j = 0; j < n; j++) {
		int pivot = j;

		for (int i = j + 1; i < n; i++)
			if (fabs(A[i][j]) > fabs(A[pivot][j]))
				pivot = i;
		if (A[pivot][j] == 0.0 || !isfinite(1.0/A[pivot][j]))
			return 0;
		for (int k = j; k < n + 4; k++) {
			double kept = A[pivot][k];

			A[pivot][k] = A[j][k];
			A[j][k] = kept;
		}
		for (int i = 0; i < n; i++) {
			double factor = i == j ? 0.0 : A[i][j]/A[j][j];

			if (factor != 0.0)
				for (int k = j; k < n + 4; k++)
					A[i][k] -= factor*A[j][k];
		}
	}
	for (int i = 0; i < n; i++)
		for (int k = n; k < n + 4; k++)
			A[i][k] /= A[i][i];
	return 1;
}

/* The three rows of the law of the index-th contact of a node; unknowns du and dr/scale. */
static void rows_of(double A[MOST][WIDE], const struct hawser_friction *of, int first, int index,
                    int n, double scale, const double S[3][4], const double U[3][4],
                    const struct hawser__touch_rows *law)
{
	for (int i = 0; i < 3; i++) {
		double *row = A[3*index + i];
		const double *a = law->CrH + 3*i;

		memset(row, 0, WIDE*sizeof *row);
		for (int j = 0; j < 3; j++)
			row[j] = law->CuH[3*i + j];
		row[n + 3] = -law->G[i];
		if (index) {
			for (int j = 0; j < 3; j++)
				row[3*index + j] = scale*(law->Cr[3*i + j] + (i == j ? weak : 0.0));
			continue;
		}
		for (int k = 0; k < 3; k++)
			for (int j = 0; j < 4; j++) {
				if (j < 3)
					row[j] += a[k]*S[k][j];
				row[n + j] += a[k]*U[k][j];
			}
		for (int d = of->touch[first].next, at = 3; d >= 0; d = of->touch[d].next, at += 3)
			for (int j = 0; j < 3; j++)
				for (int k = 0; k < 3; k++)
					row[at + j] -= scale*a[k]*of->touch[d].H[3*j + k];
	}
}

static void unpack(double to[3][4], const struct hawser__rows *rows)
{
	for (int k = 0; k < 4; k++) {
		to[0][k] = rows->x[k];
		to[1][k] = rows->y[k];
		to[2][k] = rows->z[k];
	}
}

int hawser__corner(struct hawser__rows *factor, struct hawser_friction *of, int first,
                   const struct hawser__rows *S, const struct hawser__rows *U,
                   const struct hawser__step_law *by)
{
	const double scale = of->touch[first].rho;
	double A[MOST][WIDE], left[3][4], right[3][4];
	int n = 0, index = 0;

	for (int c = first; c >= 0; c = of->touch[c].next)
		n += 3;
	unpack(left, S);
	unpack(right, U);
	for (int c = first; c >= 0; c = of->touch[c].next) {
		struct hawser__touch_rows law;

		hawser__touch_linearise(&law, &of->touch[c], by->sigma, hawser__step_from(by, of, c));
		rows_of(A, of, first, index++, n, scale, (const double (*)[4])left,
		        (const double (*)[4])right, &law);
	}
	if (!solve(A, n))
		return 0;
	factor->x = (hawser__vec){A[0][n], A[0][n + 1], A[0][n + 2], A[0][n + 3]};
	factor->y = (hawser__vec){A[1][n], A[1][n + 1], A[1][n + 2], A[1][n + 3]};
	factor->z = (hawser__vec){A[2][n], A[2][n + 1], A[2][n + 2], A[2][n + 3]};
	index = 1;
	for (int c = of->touch[first].next; c >= 0; c = of->touch[c].next, index++)
		for (int i = 0; i < 3; i++) {
			for (int j = 0; j < 3; j++)
				of->second[c].back[3*i + j] = scale*A[3*index + i][n + j];
			of->second[c].least[i] = scale*A[3*index + i][n + 3];
		}
	return 1;
}

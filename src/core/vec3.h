/* core/vec3.h - vectors and matrices in space. Matrices are [9], row by row.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_VEC3_H
#define HAWSER_CORE_VEC3_H

#include <float.h>
#include <math.h>

#include "core/hot.h"

/* fmax is a call of the C library, which loops feel. b where one is not a number. */
static inline double hawser__larger(double a, double b)
{
	return a > b ? a : b;
}

static inline double hawser__dot(const double a[3], const double b[3])
{
	return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

/* |a|; hypot where the square is not a normal number, as hypot takes ten times as long. */
static inline double hawser__norm(const double a[3])
{
	double square = hawser__dot(a, a);

	return square > DBL_MIN/DBL_EPSILON && square < DBL_MAX ? sqrt(square)
	                                                        : hypot(hypot(a[0], a[1]), a[2]);
}

/* c = a x b; c is neither a nor b. */
static inline void hawser__cross(double c[3], const double a[3], const double b[3])
{
	c[0] = a[1]*b[2] - a[2]*b[1];
	c[1] = a[2]*b[0] - a[0]*b[2];
	c[2] = a[0]*b[1] - a[1]*b[0];
}

/* The matrix A of A x = v x x. */
static inline void hawser__skew(double A[9], const double v[3])
{
	A[0] = A[4] = A[8] = 0.0;
	A[1] = -v[2];
	A[2] = v[1];
	A[3] = v[2];
	A[5] = -v[0];
	A[6] = -v[1];
	A[7] = v[0];
}

/* C = A B; C is neither. */
static inline void hawser__mul(double C[9], const double A[9], const double B[9])
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			C[3*i + j] = A[3*i]*B[j] + A[3*i + 1]*B[3 + j] + A[3*i + 2]*B[6 + j];
}

/* --- rows of a 3x3 block with a right side beside them: elimination along chains ---
 *
 * Rows of [block | right side] are registers of four numbers, and variables without index, so
 * that they stay in registers: to store single numbers and load them as one register stalls a
 * processor. */

struct hawser__rows {
	hawser__vec x, y, z;
};

/* The transposed cofactors c of the block, row by row; returns the determinant. */
HAWSER_PART double hawser__rows_adjugate(double c[9], const struct hawser__rows *m)
{
	const hawser__vec x = m->x, y = m->y, z = m->z;

	c[0] = y[1]*z[2] - y[2]*z[1];
	c[3] = y[2]*z[0] - y[0]*z[2];
	c[6] = y[0]*z[1] - y[1]*z[0];
	c[1] = x[2]*z[1] - x[1]*z[2];
	c[4] = x[0]*z[2] - x[2]*z[0];
	c[7] = x[1]*z[0] - x[0]*z[1];
	c[2] = x[1]*y[2] - x[2]*y[1];
	c[5] = x[2]*y[0] - x[0]*y[2];
	c[8] = x[0]*y[1] - x[1]*y[0];
	return x[0]*c[0] + x[1]*c[3] + x[2]*c[6];
}

/* The block's inverse, of the transposed cofactors and 1/determinant, times the rows of `off`. */
HAWSER_PART void hawser__rows_times(struct hawser__rows *product, const double c[9], double inverse,
                                    const struct hawser__rows *off)
{
	product->x = (c[0]*off->x + c[1]*off->y + c[2]*off->z)*inverse;
	product->y = (c[3]*off->x + c[4]*off->y + c[5]*off->z)*inverse;
	product->z = (c[6]*off->x + c[7]*off->y + c[8]*off->z)*inverse;
}

/* Of an eliminated place, whose rows are [next | y]: x = y - next*neighbour. */
HAWSER_PART void hawser__rows_back(double x[3], const struct hawser__rows *row,
                                   const double neighbour[3])
{
	const double a = neighbour[0], b = neighbour[1], c = neighbour[2];

	x[0] = row->x[3] - (row->x[0]*a + row->x[1]*b + row->x[2]*c);
	x[1] = row->y[3] - (row->y[0]*a + row->y[1]*b + row->y[2]*c);
	x[2] = row->z[3] - (row->z[0]*a + row->z[1]*b + row->z[2]*c);
}

/* --- three equations with a symmetric positive definite matrix --- */

/* x = A^-1 b by Cholesky. A squared pivot below `least` is replaced by it: 0, or the round-off of a
 * matrix that may be singular. */
static inline void hawser__solve3(double x[3], double A[3][3], const double b[3], double least)
{
	double L[3][3] = {{0.0}};

	for (int j = 0; j < 3; j++)
		for (int i = j; i < 3; i++) {
			double sum = A[i][j];

			for (int k = 0; k < j; k++)
				sum -= L[i][k]*L[j][k];
			L[i][j] = i == j ? sqrt(fmax(sum, least)) : sum/L[j][j];
		}
	for (int i = 0; i < 3; i++) {
		x[i] = b[i];
		for (int k = 0; k < i; k++)
			x[i] -= L[i][k]*x[k];
		x[i] /= L[i][i];
	}
	for (int i = 2; i >= 0; i--) {
		for (int k = i + 1; k < 3; k++)
			x[i] -= L[k][i]*x[k];
		x[i] /= L[i][i];
	}
}

#endif

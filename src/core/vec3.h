/* core/vec3.h - vectors and matrices in space. Matrices are [9], row by row.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_VEC3_H
#define HAWSER_CORE_VEC3_H

#include <float.h>
#include <math.h>

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

#endif

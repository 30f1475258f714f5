/* rod/so3.h - rotations in space: unit quaternions, exponential, logarithm, and their derivatives.
 *
 * A rotation R = exp(v) turns by |v| about v. Quaternions q = (w, x, y, z) are never replaced by -q, so
 * that the one between two nodes that move continuously tells angles above and below pi apart.
 *
 *   Jr(v)         exp(v + dv) = exp(v) exp(Jr(v) dv), the right Jacobian
 *   Ji(v)         its inverse: log(exp(v) exp(t)) = v + Ji(v) t + ..
 *   Jr(v)' , Ji(v)' are those of -v
 *
 * Matrices are [9], row by row. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_SO3_H
#define HAWSER_ROD_SO3_H

#include <math.h>

#include "core/vec3.h"

/* C = A' B; C is neither. */
static inline void hawser__mul_left(double C[9], const double A[9], const double B[9])
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			C[3*i + j] = A[i]*B[j] + A[3 + i]*B[3 + j] + A[6 + i]*B[6 + j];
}

/* C = A B'; C is neither. */
static inline void hawser__mul_right(double C[9], const double A[9], const double B[9])
{
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			C[3*i + j] = A[3*i]*B[3*j] + A[3*i + 1]*B[3*j + 1] + A[3*i + 2]*B[3*j + 2];
}

/* y = A x and y = A' x; y is not x. */
static inline void hawser__apply(double y[3], const double A[9], const double x[3])
{
	for (int i = 0; i < 3; i++)
		y[i] = A[3*i]*x[0] + A[3*i + 1]*x[1] + A[3*i + 2]*x[2];
}

static inline void hawser__apply_left(double y[3], const double A[9], const double x[3])
{
	for (int i = 0; i < 3; i++)
		y[i] = A[i]*x[0] + A[3 + i]*x[1] + A[6 + i]*x[2];
}

/* --- quaternions --- */

/* c is neither a nor b. */
static inline void hawser__quaternion_mul(double c[4], const double a[4], const double b[4])
{
	c[0] = a[0]*b[0] - a[1]*b[1] - a[2]*b[2] - a[3]*b[3];
	c[1] = a[0]*b[1] + a[1]*b[0] + a[2]*b[3] - a[3]*b[2];
	c[2] = a[0]*b[2] - a[1]*b[3] + a[2]*b[0] + a[3]*b[1];
	c[3] = a[0]*b[3] + a[1]*b[2] - a[2]*b[1] + a[3]*b[0];
}

/* conj(a) b, the rotation from a to b. */
static inline void hawser__quaternion_between(double c[4], const double a[4], const double b[4])
{
	const double back[4] = {a[0], -a[1], -a[2], -a[3]};

	hawser__quaternion_mul(c, back, b);
}

static inline void hawser__quaternion_matrix(double R[9], const double q[4])
{
	double w = q[0], x = q[1], y = q[2], z = q[3];

	R[0] = 1.0 - 2.0*(y*y + z*z);
	R[1] = 2.0*(x*y - w*z);
	R[2] = 2.0*(x*z + w*y);
	R[3] = 2.0*(x*y + w*z);
	R[4] = 1.0 - 2.0*(x*x + z*z);
	R[5] = 2.0*(y*z - w*x);
	R[6] = 2.0*(x*z - w*y);
	R[7] = 2.0*(y*z + w*x);
	R[8] = 1.0 - 2.0*(x*x + y*y);
}

/* --- so3.c --- */

void hawser__quaternion_exp(double q[4], const double v[3]);
/* v = log q, and the turn |v|, up to 2 pi: above pi where w < 0. */
double hawser__quaternion_log(double v[3], const double q[4]);
void hawser__quaternion_turn(double q[4], const double v[3]); /* q exp(v), of length 1 */
/* q of the rotation matrix R; w >= 0. */
void hawser__quaternion_of(double q[4], const double R[9]);

/* Of a vector v with |v| < 2 pi: functions of |v| in Jr and Ji, and their derivatives over |v|. */
struct hawser__so3 {
	double v[3];
	double a, b, c;    /* Jr = 1 - a v~ + b v~v~, Ji = 1 + v~/2 + c v~v~ */
	double da, db, dc; /* a'/|v| and so on */
};
void hawser__so3_at(struct hawser__so3 *at, const double v[3]);
/* The same in two parts: a, b and c, then the derivatives. */
void hawser__so3_values(struct hawser__so3 *at, const double v[3]);
void hawser__so3_derivatives(struct hawser__so3 *at);
void hawser__so3_jr(double J[9], const struct hawser__so3 *at);
void hawser__so3_ji(double J[9], const struct hawser__so3 *at);
/* Derivative with respect to v of Jr(v)' u, Ji(v)' u and Ji(v) u for a constant u. */
void hawser__so3_djr_left(double D[9], const struct hawser__so3 *at, const double u[3]);
void hawser__so3_dji_left(double D[9], const struct hawser__so3 *at, const double u[3]);
void hawser__so3_dji(double D[9], const struct hawser__so3 *at, const double u[3]);

#endif

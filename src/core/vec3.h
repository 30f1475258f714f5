/* core/vec3.h - vectors in space. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_VEC3_H
#define HAWSER_CORE_VEC3_H

#include <float.h>
#include <math.h>

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

#endif

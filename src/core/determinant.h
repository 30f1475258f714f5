/* core/determinant.h - the determinant of a matrix from its LU factors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_DETERMINANT_H
#define HAWSER_CORE_DETERMINANT_H

#include <math.h>
#include <stddef.h>

/* lu [count][count] and pivot [count] as LAPACK's dgetrf leaves them. Returns the logarithm of the size
 * of the determinant; *sign is 1 or -1. */
static inline double hawser__determinant(double *sign, const double *lu, const int *pivot, int count)
{
	double size = 0.0;

	*sign = 1.0;
	for (int i = 0; i < count; i++) {
		double entry = lu[(size_t)i*((size_t)count + 1)];

		size += log(fabs(entry));
		if ((entry < 0.0) != (pivot[i] != i + 1))
			*sign = -*sign;
	}
	return size;
}

#endif

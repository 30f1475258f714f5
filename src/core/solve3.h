/* core/solve3.h - three equations with a symmetric positive definite matrix.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_SOLVE3_H
#define HAWSER_CORE_SOLVE3_H

#include <math.h>

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

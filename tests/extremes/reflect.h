/* tests/extremes/reflect.h - a model with coupled coordinates whose solution is known, because it is an
 * uncoupled model in reflected coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_REFLECT_H
#define HAWSER_TESTS_REFLECT_H

/* matrix = H matrix H with H = 1 - 2 v v'/v'v, v = (1, 2, 1, 2, ...). */
static inline void reflect(double *matrix, int n)
{
	double v2 = 0.0;

	for (int j = 0; j < n; j++)
		v2 += (1 + j%2)*(1 + j%2);
	for (int side = 0; side < 2; side++)
		for (int j = 0; j < n; j++) {
			int from = side ? j : j*n, by = side ? n : 1;
			double sum = 0.0;

			for (int k = 0; k < n; k++)
				sum += (1 + k%2)*matrix[from + k*by];
			for (int k = 0; k < n; k++)
				matrix[from + k*by] -= 2.0*sum*(1 + k%2)/v2;
		}
}

#endif

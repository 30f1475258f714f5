/* modes/pairing.c - see pairing.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "modes/pairing.h"

enum hawser_status hawser__third_fill(double *third, int n,
                                      double (*by)(const void *of, int j, int k, int l),
                                      const void *of, const char *place, struct hawser_report *report)
{
	for (int j = 0; j < n; j++)
		for (int k = j; k < n; k++)
			for (int l = k; l < n; l++) {
				double value = by(of, j, k, l);

				if (!isfinite(value))
					return hawser__fail(report, HAWSER_ERR_NAN, place, "the tensor Q is %g for modes "
					                    "%d, %d, %d: their shapes are not finite", value, j + 1, k + 1,
					                    l + 1);
				third[(j*n + k)*n + l] = third[(j*n + l)*n + k] = value;
				third[(k*n + j)*n + l] = third[(k*n + l)*n + j] = value;
				third[(l*n + j)*n + k] = third[(l*n + k)*n + j] = value;
			}
	return HAWSER_OK;
}

double hawser__pairings(const double *pairing, int pairs, const int index[4])
{
	static const int way[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}};
	double sum = 0.0;

	for (int i = 0; i < 3; i++)
		sum += pairing[(size_t)hawser__pair(index[way[i][0]], index[way[i][1]])*(size_t)pairs +
		               (size_t)hawser__pair(index[way[i][2]], index[way[i][3]])];
	return sum;
}

/* response/torus/circle.c - see circle.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "response/torus/circle.h"
#include "response/floquet/monodromy.h"

struct hawser__circle hawser__circle_count(double *bound, const double *log_modulus,
                                           const double *argument, int m, double loss, double beside)
{
	struct hawser__circle circle = {0, 0, 0};

	for (int i = 0; i < m; i++) {
		double error = hawser__factors_error_of(i, log_modulus, argument, m, loss) + beside;

		if (log_modulus[i] > error) {
			circle.unstable++;
		} else if (log_modulus[i] >= -error) {
			circle.undecided++;
			circle.at_one += fabs(argument[i]) <= error;
		}
		if (bound)
			bound[i] = error;
	}
	return circle;
}

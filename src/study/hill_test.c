/* study/hill_test.c - test functions of stability boundaries (hill.c).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <complex.h>
#include <math.h>

#include "study/hill.h"

#define MOST_LOG 300.0    /* of a modulus: beyond that a multiplier stands for infinity */
#define UNDAMPED 1e-9     /* sum of the logarithms: the product of all multipliers is 1 */

static double complex multiplier(const struct hawser__hill *hill, int i)
{
	return cexp(fmin(hill->log_modulus[i], MOST_LOG) + I*hill->argument[i]);
}

static double shifted(const struct hawser__hill *hill, double by)
{
	double complex product = 1.0;

	for (int i = 0; i < hill->field->m; i++) {
		double complex mu = multiplier(hill, i);

		product *= (mu + by)/(1.0 + cabs(mu));
	}
	return creal(product);
}

static double pairs(const struct hawser__hill *hill)
{
	double complex product = 1.0;

	for (int i = 0; i < hill->field->m; i++)
		for (int j = i + 1; j < hill->field->m; j++) {
			double complex both = multiplier(hill, i)*multiplier(hill, j);

			product *= (both - 1.0)/(1.0 + cabs(both));
		}
	return creal(product);
}

/* rho = mu + 1/mu of the n pairs: each multiplier with the one nearest to its inverse. */
static int reduced(struct hawser__hill *hill, double complex *rho)
{
	int m = hill->field->m, n = 0;

	for (int i = 0; i < m; i++)
		hill->used[i] = 0;
	for (int i = 0; i < m; i++) {
		double complex inverse = 1.0/multiplier(hill, i);
		int best = -1;

		if (hill->used[i])
			continue;
		hill->used[i] = 1;
		for (int j = i + 1; j < m; j++)
			if (!hill->used[j] && (best < 0 || cabs(multiplier(hill, j) - inverse) <
			                                           cabs(multiplier(hill, best) - inverse)))
				best = j;
		if (best >= 0)
			hill->used[best] = 1;
		rho[n++] = multiplier(hill, i) + inverse;
	}
	return n;
}

static double discriminant(struct hawser__hill *hill)
{
	double complex *rho = (double complex *)hill->work, product = 1.0;
	int n = reduced(hill, rho);

	for (int i = 0; i < n; i++)
		for (int j = i + 1; j < n; j++) {
			double complex apart = (rho[i] - rho[j])/(1.0 + cabs(rho[i]) + cabs(rho[j]));

			product *= apart*apart;
		}
	return creal(product);
}

double hawser__hill_test(struct hawser__hill *hill, int kind)
{
	double sum = 0.0;

	if (kind != HAWSER_HILL_TORUS)
		return shifted(hill, kind == HAWSER_HILL_PLUS ? -1.0 : 1.0);
	for (int i = 0; i < hill->field->m; i++)
		sum += hill->log_modulus[i];
	return fabs(sum) < UNDAMPED ? discriminant(hill) : pairs(hill);
}

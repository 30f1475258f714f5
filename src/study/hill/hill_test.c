/* study/hill/hill_test.c - test functions of stability boundaries, from the multipliers mu_i of a
 * point:
 *
 *    plus   product of (mu_i - 1)
 *    minus  product of (mu_i + 1)
 *    torus  with damping: product over pairs of (mu_i mu_j - 1)
 *           without damping that is 0 everywhere: the discriminant of rho = mu + 1/mu, which changes
 *           sign as two pairs collide
 *
 * Each factor is divided by its natural size. Near a boundary, the products are as accurate as the
 * monodromy matrix, while the eigenvalues themselves lose half of their digits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>

#include "study/hill/hill.h"

#define MOST_LOG 300.0    /* largest logarithm of a modulus, near the range of double; a larger
                           * multiplier counts as infinite */
#define UNDAMPED 1e-9     /* largest sum of the logarithms without damping: the product of all
                           * multipliers is then 1 */
#define OFF_CIRCLE 1e-7   /* smallest logarithm of a modulus off the unit circle, without damping:
                           * above round-off */
#define ALONE 0.3         /* largest ratio of the two distances; chosen */
#define REAL 1e-3         /* largest sine of the argument of a multiplier that may be real; chosen */

static double complex multiplier(const struct hawser__hill_worker *worker, int i)
{
	return cexp(fmin(worker->log_modulus[i], MOST_LOG) + I*worker->argument[i]);
}

static double shifted(const struct hawser__hill_worker *worker, double by)
{
	double complex product = 1.0;

	for (int i = 0; i < worker->m; i++) {
		double complex mu = multiplier(worker, i);

		product *= (mu + by)/(1.0 + cabs(mu));
	}
	return creal(product);
}

static double pairs(const struct hawser__hill_worker *worker)
{
	double complex product = 1.0;

	for (int i = 0; i < worker->m; i++)
		for (int j = i + 1; j < worker->m; j++) {
			double complex both = multiplier(worker, i)*multiplier(worker, j);

			product *= (both - 1.0)/(1.0 + cabs(both));
		}
	return creal(product);
}

/* rho = mu + 1/mu of the n pairs: each multiplier is paired with the one nearest to its inverse. */
static int reduced(struct hawser__hill_worker *worker, double complex *rho)
{
	int m = worker->m, n = 0;

	for (int i = 0; i < m; i++)
		worker->used[i] = 0;
	for (int i = 0; i < m; i++) {
		double complex inverse = 1.0/multiplier(worker, i);
		int best = -1;

		if (worker->used[i])
			continue;
		worker->used[i] = 1;
		for (int j = i + 1; j < m; j++)
			if (!worker->used[j] && (best < 0 || cabs(multiplier(worker, j) - inverse) <
			                                             cabs(multiplier(worker, best) - inverse)))
				best = j;
		if (best >= 0)
			worker->used[best] = 1;
		rho[n++] = multiplier(worker, i) + inverse;
	}
	return n;
}

static double discriminant(struct hawser__hill_worker *worker)
{
	double complex *rho = (double complex *)worker->work, product = 1.0;
	int n = reduced(worker, rho);

	for (int i = 0; i < n; i++)
		for (int j = i + 1; j < n; j++) {
			double complex apart = (rho[i] - rho[j])/(1.0 + cabs(rho[i]) + cabs(rho[j]));

			product *= apart*apart;
		}
	return creal(product);
}

int hawser__hill_undamped(const struct hawser__hill_worker *worker)
{
	double sum = 0.0;

	for (int i = 0; i < worker->m; i++)
		sum += worker->log_modulus[i];
	return fabs(sum) < UNDAMPED;
}

double hawser__hill_test(struct hawser__hill_worker *worker, int kind)
{
	if (kind != HAWSER_HILL_TORUS)
		return shifted(worker, kind == HAWSER_HILL_PLUS ? -1.0 : 1.0);
	return hawser__hill_undamped(worker) ? discriminant(worker) : pairs(worker);
}

/* Distance from the unit circle above which a multiplier counts as outside. */
static double beyond(const struct hawser__hill_worker *worker)
{
	return hawser__hill_undamped(worker) ? OFF_CIRCLE : 0.0;
}

int hawser__hill_outside(const struct hawser__hill_worker *worker)
{
	double least = beyond(worker);
	int count = 0;

	for (int i = 0; i < worker->m; i++)
		count += worker->log_modulus[i] > least && fabs(sin(worker->argument[i])) > REAL;
	return count;
}

int hawser__hill_pair(const struct hawser__hill_worker *worker, double *argument)
{
	double best = INFINITY, least = hawser__hill_undamped(worker) ? OFF_CIRCLE : -INFINITY;

	for (int i = 0; i < worker->m; i++)
		if (worker->argument[i] > 0.0 && fabs(sin(worker->argument[i])) > REAL &&
		    worker->log_modulus[i] > least && fabs(worker->log_modulus[i]) < best) {
			best = fabs(worker->log_modulus[i]);
			*argument = worker->argument[i];
		}
	return isfinite(best);
}

int hawser__hill_alone(const struct hawser__hill_worker *worker)
{
	double least = INFINITY, gap = INFINITY, argument = 0.0;

	if (!hawser__hill_undamped(worker) || !hawser__hill_pair(worker, &argument))
		return 1;
	for (int i = 0; i < worker->m; i++) {
		double off = fabs(remainder(worker->argument[i] - argument, 2.0*M_PI));

		if (off > 0.0)
			gap = fmin(gap, off);
		else if (worker->log_modulus[i] > OFF_CIRCLE)
			least = fmin(least, worker->log_modulus[i]);
	}
	return least <= ALONE*gap;
}

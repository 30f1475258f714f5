/* study/identify/half_power_quotient.c - two modes from the squares of amplitudes, without a guess.
 *
 *    x        (omega^2 - zc)/h, with zc and h of the parabola's peak and half its width
 *    A        square of the amplitude relative to the largest: N(x)/D(x)
 *    N, D     n0 + n1 x + n2 x^2, and x^4 + d3 x^3 + d2 x^2 + d1 x + d0
 *
 * The sum of two modes, |g1/(w1^2 - z + 2 i xi1 w1 omega) + g2/(...)|^2, z = omega^2, is such a
 * quotient: each |w^2 - z + 2 i xi w omega|^2 is of second degree in z, and so is the numerator.
 * A D = N is linear in the seven coefficients, so that its least squares have one solution; a fit of
 * the amplitudes by the frequencies, ratios and parts has many local ones. Each row is divided by
 * 2 a D of the last solution, which makes it the difference of amplitudes (Sanathanan and Koerner
 * 1963). A root z of D has |z| = w^2 and the angle 2 asin(xi). The parts follow from A, which is
 * linear in g1^2, g1 g2 and g2^2.
 *
 * Noise disturbs D more than the modes: the result is where their fit begins (half_power_pair.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <math.h>
#include <string.h>

#include <lapacke.h>

#include "study/identify/half_power.h"

enum { DEGREE = 4, NUMERATOR = 3, MOST = HAWSER__HALF_MOST, ROUNDS = 6, SHAPES = HAWSER__HALF_SHAPES };

static double amplitude(const struct hawser__half_table *table, int i)
{
	return table->a[i]/table->a[table->best];
}

/* D at x. */
static double denominator(const double *d, double x)
{
	return d[0] + x*(d[1] + x*(d[2] + x*(d[3] + x)));
}

/* The coefficients: d [4], n [3]. */
static void coefficients(double p[MOST], const struct hawser__half_pair_of *pair, double zc, double h)
{
	const struct hawser__half_table *table = pair->table;

	/* at first twice the same mode */
	memcpy(p, (const double[MOST]){1.0, 0.0, 2.0, 0.0}, MOST*sizeof *p);
	for (int round = 0; round < ROUNDS; round++) {
		double R[MOST][MOST + 1] = {{0.0}};

		for (int i = pair->span.first; i <= pair->span.last; i++) {
			double x = (table->omega[i]*table->omega[i] - zc)/h, a = amplitude(table, i);
			double weight = 0.5/(a*fmax(fabs(denominator(p, x)), 1e-6)), row[MOST + 1], power = weight;

			for (int j = 0; j <= DEGREE; j++, power *= x) {
				row[j < DEGREE ? j : MOST] = (j < DEGREE ? 1.0 : -1.0)*a*a*power;
				if (j < NUMERATOR)
					row[DEGREE + j] = -power;
			}
			hawser__half_join(R, row, MOST);
		}
		hawser__half_solve(p, (const double (*)[MOST + 1])R, MOST);
	}
}

/* The two roots of D above the real axis. Returns 0 if there are not two. */
static int roots_above(double complex root[2], const double *d)
{
	double H[DEGREE*DEGREE] = {0.0}, re[DEGREE], im[DEGREE];
	int found = 0;

	for (int j = 0; j < DEGREE; j++) {
		if (!isfinite(d[j]))
			return 0;
		H[j*DEGREE] = -d[DEGREE - 1 - j]; /* the companion matrix, by columns */
		if (j + 1 < DEGREE)
			H[j*DEGREE + j + 1] = 1.0;
	}
	if (LAPACKE_dhseqr(LAPACK_COL_MAJOR, 'E', 'N', DEGREE, 1, DEGREE, H, DEGREE, re, im, NULL, 1))
		return 0;
	for (int j = 0; j < DEGREE; j++)
		if (im[j] > 0.0 && found < 2)
			root[found++] = re[j] + I*im[j];
	return found == 2;
}

/* g1 and g2, in q[3] and q[4], for the frequencies and ratios in q. */
static int parts(double *q, const struct hawser__half_pair_of *pair)
{
	double R[MOST][MOST + 1] = {{0.0}}, g[NUMERATOR];

	for (int i = pair->span.first; i <= pair->span.last; i++) {
		double complex by[SHAPES];
		double a = amplitude(pair->table, i), row[MOST + 1] = {0.0};

		hawser__half_pair_at(by, pair, q, pair->table->omega[i]);
		row[0] = 0.5*creal(by[3]*conj(by[3]))/a;
		row[1] = creal(by[3]*conj(by[4]))/a;
		row[2] = 0.5*creal(by[4]*conj(by[4]))/a;
		row[NUMERATOR] = 0.5*a;
		hawser__half_join(R, row, NUMERATOR);
	}
	hawser__half_solve(g, (const double (*)[MOST + 1])R, NUMERATOR);
	q[3] = sqrt(fmax(g[0], 0.0));
	q[4] = copysign(sqrt(fmax(g[2], 0.0)), g[1]);
	return isfinite(q[3]) && isfinite(q[4]);
}

int hawser__half_quotient(double q[SHAPES], const struct hawser__half_pair_of *pair)
{
	struct hawser__half_pair_of all = *pair;
	double zc = pair->wp*pair->wp, h = 2.0*pair->ratio*zc, p[MOST], w[2], xi[2];
	double complex root[2];

	if (pair->span.last - pair->span.first + 1 < MOST)
		return 0;
	coefficients(p, pair, zc, h);
	if (!roots_above(root, p))
		return 0;
	for (int k = 0; k < 2; k++) {
		double complex z = zc + h*root[k];

		w[k] = sqrt(cabs(z));
		xi[k] = sin(0.5*carg(z));
	}
	q[0] = (0.5*(w[0] + w[1])/pair->wp - 1.0)/pair->ratio;
	q[1] = 0.5*(w[1] - w[0])/pair->wp/pair->ratio;
	q[2] = 0.5*log(xi[0]*xi[1]) - log(pair->ratio);
	q[3] = q[4] = 1.0;
	q[SHAPES - 1] = 0.5*log(xi[1]/xi[0]);
	all.unknowns = SHAPES;
	return parts(q, &all);
}

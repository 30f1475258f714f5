/* tests/property/test-modes-chain.c - the frequencies of a chain of masses and springs: without
 * local frame and linearised strain, from the second derivative of the springs' energy about the
 * catenary in global axes. Second order in the spacing; Richardson extrapolation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <stdlib.h>

#include "tests/modes-span.h"
#include "tests/tap.h"

enum { KEPT = 8, FINEST = 240, LEVELS = 3 };

/* Static position of the point s: the elastic catenary's, scaled. */
static void position(double *x, const struct hawser_statics *st, double s)
{
	double u = st->eta + st->delta*s;

	x[0] = st->epsilon*s + (asinh(u) - asinh(st->eta))/st->delta;
	x[1] = st->epsilon*(st->eta*s + 0.5*st->delta*s*s) +
	       (hypot(1.0, u) - hypot(1.0, st->eta))/st->delta;
}

/* Second derivative of (|q| - h)^2/(2 epsilon h) by q, for a spring from p to q. */
static void spring(double H[3][3], const double *p, const double *q, double h, double epsilon)
{
	double d[3] = {q[0] - p[0], q[1] - p[1], 0.0}, length = hypot(d[0], d[1]);

	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++) {
			double tt = d[i]*d[j]/(length*length);

			H[i][j] = (tt + (1.0 - h/length)*((i == j) - tt))/(epsilon*h);
		}
}

/* Lowest frequencies of n springs of unstretched length l/n with equal masses between them. */
static int chain(double *omega, const struct hawser_statics *st, int n)
{
	int size = 3*(n - 1), failed;
	double h = st->l/n, *K = calloc((size_t)(size*size), sizeof *K);
	double *w = calloc((size_t)size, sizeof *w), none = 0.0;
	lapack_int found = 0, *support = calloc(2*(size_t)size, sizeof *support);

	if (!K || !w || !support)
		return -1;
	for (int e = 0; e < n; e++) {
		double p[2], q[2], H[3][3];

		position(p, st, e*h);
		position(q, st, (e + 1)*h);
		spring(H, p, q, h, st->epsilon);
		for (int a = e - 1; a <= e; a++)
			for (int b = e - 1; b <= e; b++)
				for (int i = 0; i < 9 && a >= 0 && b >= 0 && a < n - 1 && b < n - 1; i++)
					K[(3*a + i/3)*size + 3*b + i%3] += (a == b ? 1.0 : -1.0)*H[i/3][i%3]/h;
	}
	failed = LAPACKE_dsyevr(LAPACK_ROW_MAJOR, 'N', 'I', 'U', size, K, size, 0.0, 0.0, 1, KEPT,
	                        0.0, &found, w, &none, 1, support);
	for (int k = 0; k < KEPT; k++)
		omega[k] = sqrt(w[k]);
	free(K);
	free(w);
	free(support);
	return failed;
}

static void compare(double epsilon, double delta, double hs)
{
	struct hawser_statics st = scaled_span(epsilon, delta, hs);
	struct hawser_modes_options options = {.n = KEPT};
	struct hawser_modes m;
	double w[LEVELS][KEPT], worst = 0.0, low = 9.0, high = 0.0;

	printf("# epsilon %g, delta %g, hs %g\n", epsilon, delta, hs);
	for (int i = 0; i < LEVELS; i++)
		if (!ok(!chain(w[i], &st, FINEST >> (LEVELS - 1 - i)), "chain solved"))
			return;
	if (!ok(!hawser_modes_solve(&m, &st, &options, NULL), "modes solved"))
		return;
	for (int k = 0; k < KEPT; k++) {
		double fine = (4.0*w[2][k] - w[1][k])/3.0, coarse = (4.0*w[1][k] - w[0][k])/3.0;
		double order = log2(fabs(w[0][k] - m.mode[k].omega)/fabs(w[1][k] - m.mode[k].omega));

		worst = fmax(worst, fabs((16.0*fine - coarse)/15.0/m.mode[k].omega - 1.0));
		low = fmin(low, order);
		high = fmax(high, order);
	}
	ok(low > 1.9 && high < 2.1, "the chain comes nearer at order %.2f to %.2f", low, high);
	ok(worst < 1e-7, "and its extrapolation agrees to %.1e", worst);
	hawser_modes_clear(&m);
}

CASE(property_modes_chain)
{
	compare(0.0238, 0.4, 0.0);
	compare(0.01, 1.3, 0.7);
	compare(0.4, 0.2, -0.4);
	return done_testing();
}

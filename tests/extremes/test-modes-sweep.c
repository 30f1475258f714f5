/* Modes by each method, with every pair of parameters varied up to their limits.
 *
 * References: for `spectral`, shooting in extended precision, the number of modes by the index theorem,
 * and the orthogonality of the shapes; for the other methods, `spectral`. `analytic` states a bound on
 * the distance to the nearest in-plane frequency; `chain` and `fdm` state estimates.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define SHOOT_LONG_DOUBLE
#include <hawser/irvine.h>

#include "tests/extremes/sweep.h"
#include "tests/extremes/modes-count.h"
#include "tests/extremes/modes-quad.h"
#include "tests/modes-span.h"

#define COUNT(a) ((int)(sizeof(a)/sizeof(a)[0]))

static const double epsilons[] = {1e-14, 1e-11, 1e-8, 1e-6, 1e-4, 1e-2, 0.5};
static const double deltas[] = {1e-9, 1e-6, 1e-3, 0.03, 0.3, 1.0, 3.0, 10.0, 25.0, 50.0};
static const double slopes[] = {-50.0, -1.0, -1e-6, 0.0, 1e-12, 0.04, 0.3, 3.0, 20.0, 1e3, 1e6};
static const double counts[] = {1.0, 2.0, 7.0, 20.0, 60.0};
static const double bases[] = {0.0, 8.0, 12.0, 25.0, 60.0, 150.0};
static const double slants[] = {0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.1};
static const double asides[] = {-1e-6, -1e-12, -2e-16, 0.0, 2e-16, 1e-15, 1e-9, 1e-4};
static const double which[] = {0.0, 1.0, 2.0};
static const double points[] = {30.0, 100.0, 300.0, 1200.0};

static double worst_product; /* largest product of two shapes, over all spectral points */

static int steps_for(const struct hawser_statics *st, int n)
{
	double turn = asinh(st->eta + st->delta*st->l) - asinh(st->eta);

	return 12 + n + (int)(5.0*turn);
}

/* Integral of Phi_j.Phi_k over the grid. */
static double product(const struct hawser_modes *m, int j, int k)
{
	size_t size = 3*(size_t)m->grid.points;
	double sum = 0.0;

	for (size_t i = 0; i < size; i++)
		sum += m->grid.weight[i/3]*m->shape[(size_t)j*size + i]*m->shape[(size_t)k*size + i];
	return sum;
}

static void products(const struct hawser_modes *m)
{
	int last = m->n - 1, middle = m->n/2;
	double all[] = {product(m, 0, 0) - 1.0, product(m, last, last) - 1.0,
	                last > 0 ? product(m, 0, last) : 0.0,
	                last > middle ? product(m, middle, last) : 0.0,
	                middle > 0 ? product(m, middle - 1, middle) : 0.0};

	for (int i = 0; i < COUNT(all); i++)
		worst_product = isnan(all[i]) ? NAN : fmax(worst_product, fabs(all[i]));
}

/* 1: the modes of the result are the lowest ones; modes that coincide with the last are ignored. */
static int complete(const struct hawser_modes *m)
{
	const struct hawser_statics *st = &m->statics;
	double edge = m->mode[m->n - 1].omega*(1.0 - 1e-6 - 2.0*m->mode[m->n - 1].residual);
	int have[2] = {0}, steps = 4*steps_for(st, m->n), found;

	for (int k = 0; k < m->n; k++)
		have[m->mode[k].plane] += m->mode[k].omega < edge;
	for (int q = 0; q < 2; q++) {
		found = count_below(st, (enum hawser_plane)q, edge, steps);
		for (int more = 0; more < 2 && found != have[q]; more++)
			found = count_below(st, (enum hawser_plane)q, edge, steps *= 4);
		if (found != have[q]) {
			printf("# %d modes of plane %d found, there are %d\n", have[q], q, found);
			return 0;
		}
	}
	return 1;
}

/* x: epsilon, delta, slope, modes, basis. */
static void spectral(struct sweep_point *point, const double *x, void *turn)
{
	struct hawser_statics st = scaled_span(x[0], x[1], x[2]);
	struct hawser_modes_options options = {.n = (int)x[3], .basis = (int)x[4], .any_error = 1};
	struct hawser_modes m;
	int k = (++*(int *)turn*5) % options.n;

	point->skip = sweep_left_out(11, 1);
	if (point->skip)
		return;
	point->status = hawser_modes_solve(&m, &st, &options, &point->report);
	if (point->status)
		return;
	if (x[4] == 0.0)
		products(&m);
	for (int twice = 0; twice < 2; twice++, k = options.n - 1) {
		const struct hawser_mode *mode = m.mode + k;
		int steps = steps_for(&st, options.n);
		double error = count_error(&st, mode->plane, mode->omega, steps);

		if (!(error <= 0.5*mode->residual) && mode->residual < 1e-11)
			error = quad_frequency_error(&st, mode->plane, mode->omega, steps);
		sweep_keep(point, error, mode->residual);
	}
	for (k = 0; k < options.n && m.mode[k].residual < 1e-3;)
		k++;
	if (k == options.n && !complete(&m))
		sweep_keep(point, NAN, 0.0);
	hawser_modes_clear(&m);
}

/* A method on x[4] points (analytic: none) against the frequencies of `spectral`. */
static void other(struct sweep_point *point, const double *x, void *context)
{
	const char *method = context;
	int bound = method[0] == 'a', seen[2] = {0};
	struct hawser_statics st = scaled_span(x[0], x[1], x[2]);
	struct hawser_modes_options options = {.n = (int)x[3], .basis = bound ? 0 : (int)x[4],
	                                       .method = method, .any_error = 1};
	struct hawser_modes_options fine = {.n = options.n + 6};
	struct hawser_modes m, exact;

	point->bound = bound;
	point->skip = sweep_left_out(bound ? 5 : 7, 1);
	if (point->skip)
		return;
	point->status = hawser_modes_solve(&m, &st, &options, &point->report);
	if (point->status)
		return;
	if (hawser_modes_solve(&exact, &st, &fine, NULL)) {
		point->skip = 1;
		hawser_modes_clear(&m);
		return;
	}
	for (int k = 0; k < options.n; k++) {
		double error = 1e300;
		int number = ++seen[m.mode[k].plane], at = 0;

		for (int j = 0; j < fine.n; j++) {
			double e = fabs(m.mode[k].omega/exact.mode[j].omega - 1.0);

			if (exact.mode[j].plane != m.mode[k].plane)
				continue;
			if (bound ? e < error : ++at == number)
				error = e;
		}
		sweep_keep(point, fmin(error, 1.0), m.mode[k].residual + exact.mode[0].residual);
	}
	hawser_modes_clear(&m);
	hawser_modes_clear(&exact);
}

/* The tension of the i-th closest approach of two branches, as the tension of a span of this slope
 * decreases; 0: there is none. */
static double meeting(double slope, int i)
{
	const struct hawser_span span = {40e6, 6.0, 9.81, 100.0, slope*100.0};
	const struct hawser_irvine_options options = {.from = 200e3, .to = 8e3, .points = 15, .n = 16};
	static struct hawser_irvine_crossover known[8];
	static double last = -1.0;
	static int count;
	struct hawser_irvine irvine;

	if (slope != last) {
		count = 0;
		last = slope;
		if (hawser_irvine_trace(&irvine, &span, &options, NULL))
			return 0.0;
		count = irvine.crossovers < 8 ? irvine.crossovers : 8;
		memcpy(known, irvine.crossover, (size_t)count*sizeof *known);
		hawser_irvine_clear(&irvine);
	}
	return i < count ? known[i].H : 0.0;
}

/* x: slope, index of the closest approach, distance from it. Nearly coincident modes are right if the
 * index theorem counts the right number of modes below both ends of the stated error. */
static void crossing(struct sweep_point *point, const double *x, void *unused)
{
	struct hawser_span span = {40e6, 6.0, 9.81, 100.0, x[0]*100.0};
	struct hawser_modes_options options = {.n = 16};
	double H = meeting(x[0], (int)x[1])*(1.0 + x[2]);
	struct hawser_statics st;
	struct hawser_modes m;
	int place = 0;

	(void)unused;
	point->skip = H == 0.0 || sweep_left_out(5, 1);
	if (point->skip)
		return;
	point->status = hawser_statics_solve(&st, &span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT,
	                                     &point->report);
	if (!point->status)
		point->status = hawser_modes_solve(&m, &st, &options, &point->report);
	if (point->status)
		return;
	for (int k = 0; k < options.n; k++) {
		const struct hawser_mode *mode = m.mode + k, *next = mode + 1;
		int steps = 2*steps_for(&st, options.n), below, above, near = 0;

		if (mode->plane == HAWSER_OUT_OF_PLANE)
			continue;
		for (next = m.mode; next < m.mode + m.n; next++)
			near += next->plane == mode->plane && fabs(next->omega/mode->omega - 1.0) < 1e-3;
		place++;
		if (near < 2)
			continue;
		below = count_below(&st, mode->plane, mode->omega*(1.0 - mode->residual), steps);
		above = count_below(&st, mode->plane, mode->omega*(1.0 + mode->residual), steps);
		sweep_keep(point, below < place && above >= place ? 0.5*mode->residual : NAN, mode->residual);
	}
	point->skip = point->stated == 0.0;
	hawser_modes_clear(&m);
}

CASE(extremes_modes_sweep)
{
	char analytic[] = "analytic", fdm[] = "fdm", chain[] = "chain";
	struct sweep_axis axis[] = {{"epsilon", 1e-4, epsilons, COUNT(epsilons), 2},
	                            {"delta", 0.3, deltas, COUNT(deltas), 2},
	                            {"slope", 0.04, slopes, COUNT(slopes), 1},
	                            {"modes", 7.0, counts, COUNT(counts), 0},
	                            {"basis", 0.0, bases, COUNT(bases), 0}};
	const struct sweep_axis meetings[] = {{"slope", 0.0, slants, COUNT(slants), 2},
	                                      {"meeting", 0.0, which, COUNT(which), 0},
	                                      {"aside", 0.0, asides, COUNT(asides), 0}};
	int turn = 0;

	sweep_pairs("modes/spectral", axis, 5, spectral, &turn);
	ok(worst_product < 1e-8, "shapes are orthonormal, off by %.1e", worst_product);
	sweep_pairs("modes/meeting", meetings, 3, crossing, NULL);
	sweep_pairs("modes/analytic", axis, 4, other, analytic);
	axis[4] = (struct sweep_axis){"points", 300.0, points, COUNT(points), 0};
	sweep_pairs("modes/fdm", axis, 5, other, fdm);
	sweep_pairs("modes/chain", axis, 5, other, chain);
	sweep_again("fdm, modes in the plane missing", other, (double[]){1e-11, 0.3, 0.04, 20.0, 300.0},
	            fdm);
	sweep_again("spectral, too few elements", spectral, (double[]){1e-4, 50.0, 0.04, 7.0, 8.0}, &turn);
	return done_testing();
}

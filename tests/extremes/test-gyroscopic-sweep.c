/* Modes of travelling cables by each method, with every pair of parameters varied up to their limits.
 * The steady state is given as in a scene, at speeds up to 1e-9 below the limit speed.
 *
 * References: for `spectral`, shooting for a complex frequency in extended precision; for the other
 * methods, `spectral`. Their bound is on the distance to the nearest in-plane eigenvalue.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/extremes/sweep.h"
#include "tests/gyroscopic-shooting.h"

#define COUNT(a) ((int)(sizeof(a)/sizeof(a)[0]))

static const double paces[] = {0.0, 1e-8, 1e-3, 0.3, 0.9, 0.999, 1.0 - 1e-6, 1.0 - 1e-9};
static const double extensibility[] = {1e-14, 1e-11, 1e-8, 1e-6, 1e-4, 1e-2, 0.5};
static const double slopes[] = {-20.0, -1.0, -0.04, 0.0, 1e-12, 0.3, 3.0, 50.0};
static const double tensions[] = {0.8, 1.0, 3.0, 30.0, 1e3, 1e6, 1e9};
static const double counts[] = {1.0, 2.0, 7.0, 20.0, 60.0};

/* x: speed over the limit, w d/EA, slope, T0 over w d, modes. */
static enum hawser_status steady(struct hawser_statics *st, const double *x,
                                 struct hawser_report *report)
{
	struct hawser_span span = {INFINITY, 6.0, 9.81, 238.5, x[2]*238.5};
	double weight = span.rho*span.g*span.d, limit;
	struct hawser_motion motion = {.hold = HAWSER_HOLD_TENSION};
	enum hawser_status status;

	span.EA = weight/x[1];
	status = hawser_statics_limit(&limit, &span, HAWSER_GIVEN_T0, x[3]*weight, HAWSER_BRANCH_TAUT,
	                              HAWSER_HOLD_TENSION, report);
	motion.speed = x[0]*limit;
	return status ? status
	              : hawser_statics_travel(st, &span, HAWSER_GIVEN_T0, x[3]*weight,
	                                      HAWSER_BRANCH_TAUT, &motion, report);
}

static void spectral(struct sweep_point *point, const double *x, void *count)
{
	struct hawser_modes_options options = {.n = (int)x[4]};
	struct hawser_modes m;
	struct hawser_statics st;
	int k = (++*(int *)count*5) % options.n;

	point->skip = sweep_left_out(11, 1);
	if (point->skip)
		return;
	point->status = steady(&st, x, &point->report);
	if (!point->status)
		point->status = hawser_complex_modes_solve(&m, &st, &options, &point->report);
	if (point->status)
		return;
	for (int twice = 0; twice < 2; twice++, k = options.n - 1) {
		double range = asinh(st.eta + st.delta*st.l) - asinh(st.eta), unused;
		int steps = 30 + options.n*(2 + (int)fmin(st.motion.nu, 10.0)) + (int)(6.0*range);
		double complex exact = turn_frequency(&st, m.mode[k].plane, m.mode[k].omega, steps, &unused);

		sweep_keep(point, cabs(exact - m.mode[k].omega)/cabs(exact), m.mode[k].residual);
	}
	hawser_modes_clear(&m);
}

static void other(struct sweep_point *point, const double *x, void *method)
{
	struct hawser_modes_options options = {.n = (int)x[4], .method = method, .any_error = 1};
	struct hawser_modes_options fine = {.n = options.n + 6};
	struct hawser_modes m, exact;
	struct hawser_statics st;

	point->bound = 1;
	point->skip = ((const char *)method)[0] == 'f' ? sweep_left_out(13, 2) : sweep_left_out(5, 1);
	if (point->skip)
		return;
	point->status = steady(&st, x, &point->report);
	if (!point->status)
		point->status = hawser_complex_modes_solve(&m, &st, &options, &point->report);
	if (point->status)
		return;
	if (hawser_complex_modes_solve(&exact, &st, &fine, NULL)) {
		point->skip = 1;
		hawser_modes_clear(&m);
		return;
	}
	for (int k = 0; k < options.n; k++) {
		double error = INFINITY;

		for (int j = 0; j < fine.n; j++)
			if (exact.mode[j].plane == m.mode[k].plane)
				error = fmin(error, hypot(m.mode[k].omega - exact.mode[j].omega, m.mode[k].re)
				                    /exact.mode[j].omega);
		sweep_keep(point, fmin(error, 1.0), m.mode[k].residual + exact.mode[0].residual);
	}
	hawser_modes_clear(&m);
	hawser_modes_clear(&exact);
}

CASE(extremes_gyroscopic_sweep)
{
	char analytic[] = "analytic", source[] = "fdm-source";
	const struct sweep_axis axis[] = {
		{"pace", 0.3, paces, COUNT(paces), 1},
		{"extensibility", 1e-4, extensibility, COUNT(extensibility), 1},
		{"slope", 0.04, slopes, COUNT(slopes), 0},
		{"tension", 3.0, tensions, COUNT(tensions), 0},
		{"modes", 7.0, counts, COUNT(counts), 0},
	};
	int count = 0;

	sweep_pairs("gyroscopic/spectral", axis, 5, spectral, &count);
	sweep_pairs("gyroscopic/analytic", axis, 5, other, analytic);
	sweep_pairs("gyroscopic/fdm-source", axis, 5, other, source);
	sweep_again("fdm-source, modes in the plane missing", other,
	      (double[]){0.3, 1e-14, 0.04, 3.0, 20.0}, source);
	return done_testing();
}

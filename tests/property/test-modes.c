/* tests/property/test-modes.c - tests that every method of the table must pass: orthogonality,
 * Rayleigh quotients, equilibrium of the mode, mirror symmetry, convergence, and failures.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "tests/modes-span.h"
#include "tests/tap.h"

static const double spans[][3] = { /* epsilon, delta, hs */
	{2.385e-3, 0.147, 0.3}, {1e-6, 0.05, 0.0}, {1e-13, 0.7, -2.3}, {3e-9, 2.9, 0.4},
	{1e-11, 9.7, 0.0}, {1e-11, 20.0, 1.7}, {0.2, 0.3, 0.1},
};
enum { SPANS = sizeof spans/sizeof spans[0], MODES = 10 };

/* Integral of mode i times mode j: displacements (mass) or energy (stiffness). */
static double mass(const struct hawser_modes *m, int i, int j)
{
	double sum = 0.0;

	for (int p = 0; p < m->grid.points; p++)
		for (int c = 0; c < 3; c++)
			sum += m->grid.weight[p]*m->shape[(i*m->grid.points + p)*3 + c]*
			       m->shape[(j*m->grid.points + p)*3 + c];
	return sum;
}

static double stiffness(const struct hawser_modes *m, int i, int j)
{
	const struct hawser_statics *st = &m->statics;
	double sum = 0.0;

	for (int p = 0; p < m->grid.points; p++) {
		const double *x = m->slope + (i*m->grid.points + p)*3;
		const double *y = m->slope + (j*m->grid.points + p)*3;
		double T = hypot(1.0, st->eta + st->delta*m->grid.s[p]);

		sum += m->grid.weight[p]*(x[0]*y[0]/st->epsilon +
		                          T/(1.0 + st->epsilon*T)*(x[1]*y[1] + x[2]*y[2]));
	}
	return sum;
}

static void unit_norm(const struct hawser_modes *m)
{
	double worst = 0.0;

	for (int i = 0; i < m->n; i++)
		worst = fmax(worst, fabs(mass(m, i, i) - 1.0));
	ok(worst < 1e-13, "unit norm, to %.1e", worst);
}

static void orthogonality(const struct hawser_modes *m, double slack)
{
	double cross = 0.0, rayleigh = 0.0, energy = 0.0;

	for (int i = 0; i < m->n; i++)
		for (int j = 0; j <= i; j++) {
			double M = mass(m, i, j), K = stiffness(m, i, j);
			double scale = m->mode[i].omega*m->mode[j].omega;

			if (i == j) {
				rayleigh = fmax(rayleigh, fabs(K/scale - 1.0));
			} else {
				cross = fmax(cross, fabs(M));
				energy = fmax(energy, fabs(K)/scale);
			}
		}
	ok(cross < 1e-10 + slack, "orthogonal in the mass, to %.1e", cross);
	ok(energy < 1e-8 + slack, "orthogonal in the stiffness, to %.1e", energy);
	ok(rayleigh < 1e-10 + slack, "Rayleigh quotient is omega^2, to %.1e", rayleigh);
}

/* Force (tension increment along e, rotated static tension along n and z) in global axes, and
 * displacement. */
static void global(double *force, double *displacement, const struct hawser_modes *m, int k, double s)
{
	const struct hawser_statics *st = &m->statics;
	double u = st->eta + st->delta*s, T = hypot(1.0, u), c = 1.0/T, d = u/T, x[3], y[3];
	double turn = T/(1.0 + st->epsilon*T);

	hawser_modes_at(m, x, y, k, s);
	displacement[0] = c*x[0] - d*x[1];
	displacement[1] = d*x[0] + c*x[1];
	displacement[2] = x[2];
	force[0] = c*y[0]/st->epsilon - d*turn*y[1];
	force[1] = d*y[0]/st->epsilon + c*turn*y[1];
	force[2] = turn*y[2];
}

/* Step for differences: a small part of a wave and of the profile's scale T/delta, not too close to
 * the ends; 0 if there is no room. */
static double step_at(const struct hawser_statics *st, int k, double s)
{
	double h = 3e-3*fmin(st->l/(k + 4), hypot(1.0, st->eta + st->delta*s)/st->delta);

	return s > 2.0*h && s < st->l - 2.0*h ? h : 0.0;
}

/* Fourth-order central difference of values [4][3] at -2h, -h, h, 2h. */
static double difference(double value[][3], int c, double h)
{
	return (8.0*(value[2][c] - value[1][c]) - (value[3][c] - value[0][c]))/(12.0*h);
}

/* F' = -omega^2 X: the only check of a/epsilon, the dynamic tension, alone. Points are equidistant
 * in asinh(u), since the field is smooth there. */
static void equilibrium(const struct hawser_modes *m, double slack)
{
	const struct hawser_statics *st = &m->statics;
	double first = asinh(st->eta), last = asinh(st->eta + st->delta*st->l), worst = 0.0;

	for (int k = 0; k < m->n; k++)
		for (double z = 0.0437; z < 0.99; z += 0.0931) {
			double s = (sinh(first + (last - first)*z) - st->eta)/st->delta;
			double h = step_at(st, k, s), F[4][3], X[3], size = 0.0, miss = 0.0;
			double w2 = m->mode[k].omega*m->mode[k].omega;
			double kappa = st->delta/(1.0 + pow(st->eta + st->delta*s, 2.0));

			if (h == 0.0)
				continue;
			for (int i = 0; i < 4; i++)
				global(F[i], X, m, k, s + (i < 2 ? i - 2 : i - 1)*h);
			global((double[3]){0}, X, m, k, s);
			for (int c = 0; c < 3; c++) {
				size += fabs(F[0][c])*fmax(1.0/st->l, kappa) + w2*fabs(X[c]);
				miss += fabs(difference(F, c, h) + w2*X[c]);
			}
			worst = fmax(worst, miss/size);
		}
	ok(worst < 1e-7 + slack, "momentum: F' = -omega^2 X, to %.1e", worst);
}

/* a = P' - kappa Q, b = Q' + kappa P, c = B', at every third node. */
static void compatibility(const struct hawser_modes *m, double slack)
{
	const struct hawser_statics *st = &m->statics;
	double worst = 0.0;

	for (int k = 0; k < m->n; k++)
		for (int p = 1; p < m->grid.points - 1; p += 3) {
			double s = m->grid.s[p], u = st->eta + st->delta*s, h = step_at(st, k, s);
			double kappa = st->delta/(1.0 + u*u), near[4][3], x[3], y[3], size = 0.0;
			double miss = 0.0;

			if (h == 0.0)
				continue;
			for (int i = 0; i < 4; i++)
				hawser_modes_at(m, near[i], NULL, k, s + (i < 2 ? i - 2 : i - 1)*h);
			hawser_modes_at(m, x, y, k, s);
			miss += fabs(difference(near, 0, h) - kappa*x[1] - y[0]);
			miss += fabs(difference(near, 1, h) + kappa*x[0] - y[1]);
			miss += fabs(difference(near, 2, h) - y[2]);
			for (int c = 0; c < 3; c++)
				size += fabs(y[c]) + fabs(x[c])*fmax(1.0/st->l, kappa);
			worst = fmax(worst, miss/size);
		}
	ok(worst < 1e-7 + slack, "slopes are the local derivatives of shapes, to %.1e", worst);
}

static void ends(const struct hawser_modes *m, double slack)
{
	double worst = 0.0;

	for (int k = 0; k < m->n; k++)
		for (int end = 0; end < 2; end++) {
			double x[3];

			hawser_modes_at(m, x, NULL, k, end*m->statics.l);
			for (int c = 0; c < 3; c++)
				worst = fmax(worst, fabs(x[c])*sqrt(m->statics.l));
		}
	ok(worst < 1e-9 + slack, "shapes vanish at both ends, to %.1e", worst);
}

/* The reduced model integrates products of four slopes on the grid. Compare them with the product
 * of interpolated slopes by two-point Gauss on 400 and 800 cells per element, extrapolated. */
static double quartic_fine(const struct hawser_modes *m, int i, int j, int cells)
{
	double sum = 0.0;

	for (int e = 0; e < m->grid.elements; e++) {
		double a = m->grid.edge[e], h = (m->grid.edge[e + 1] - a)/cells;

		for (int c = 0; c < 2*cells; c++) {
			double s = a + h*(c/2 + 0.5 + (c%2 ? 0.5 : -0.5)/sqrt(3.0)), x[3], y[3], z[3];
			double T = hypot(1.0, m->statics.eta + m->statics.delta*s);

			hawser_modes_at(m, x, y, i, s);
			hawser_modes_at(m, x, z, j, s);
			sum += 0.5*h*T*pow((y[1] + y[2])*(z[1] + z[2]), 2.0);
		}
	}
	return sum;
}

static void quartic(const struct hawser_modes *m)
{
	double worst = 0.0;

	for (int i = 0; i < m->n; i += 3)
		for (int j = i; j < m->n; j += 3) {
			double sum = 0.0, fine = quartic_fine(m, i, j, 400);
			double finer = quartic_fine(m, i, j, 800);

			for (int p = 0; p < m->grid.points; p++) {
				const double *y = m->slope + (i*m->grid.points + p)*3;
				const double *z = m->slope + (j*m->grid.points + p)*3;
				double T = hypot(1.0, m->statics.eta + m->statics.delta*m->grid.s[p]);

				sum += m->grid.weight[p]*T*pow((y[1] + y[2])*(z[1] + z[2]), 2.0);
			}
			finer += (finer - fine)/15.0;
			worst = fmax(worst, fabs(sum/finer - 1.0));
		}
	ok(worst < 1e-12, "products of four slopes are integrated to %.1e", worst);
}

static void order_and_sign(const struct hawser_modes *m)
{
	int ascending = 1, positive = 1, named = 1;

	for (int k = 0; k < m->n; k++) {
		const struct hawser_mode *mode = m->mode + k;
		double peak = 0.0, now = 0.0;
		int f = mode->plane == HAWSER_OUT_OF_PLANE ? 2 : mode->axial_share > 0.5 ? 0 : 1;

		ascending &= k == 0 || mode->omega >= mode[-1].omega;
		named &= (mode->family == HAWSER_LONGITUDINAL) == (mode->axial_share > 0.5);
		for (int p = 0; p < m->grid.points; p++)
			peak = fmax(peak, fabs(m->shape[(k*m->grid.points + p)*3 + f]));
		for (int p = 0; p < m->grid.points && fabs(now) < 0.3*peak; p++)
			now = m->shape[(k*m->grid.points + p)*3 + f];
		positive &= now > 0.0;
	}
	ok(ascending, "frequencies ascend");
	ok(positive, "the dominant component starts positive from end A");
	ok(named, "family follows from the axial share of the kinetic energy");
}

/* A span and its mirror image have the same frequencies. */
static void mirror(const struct hawser_modes *m, const struct hawser_modes_options *options,
                   const double *p, double slack)
{
	struct hawser_statics st = scaled_span(p[0], p[1], -p[2]);
	struct hawser_modes image;
	double worst = 0.0;

	if (!ok(!hawser_modes_solve(&image, &st, options, NULL), "mirror image solved"))
		return;
	for (int k = 0; k < m->n; k++)
		worst = fmax(worst, fabs(image.mode[k].omega/m->mode[k].omega - 1.0));
	ok(worst < 1e-12 + slack, "its mirror image has the same frequencies, to %.1e", worst);
	hawser_modes_clear(&image);
}

/* Every frequency is within its stated error of an exact one of its plane: of the one with the same
 * number for methods that converge, of any for the closed forms, whose bound states no more. */
static void honest(const struct hawser_modes *m, int in_place)
{
	struct hawser_modes_options options = {.n = m->n + 10};
	struct hawser_modes exact;
	double least = HUGE_VAL;
	int next[2] = {0};

	if (!ok(!hawser_modes_solve(&exact, &m->statics, &options, NULL), "converged modes"))
		return;
	for (int k = 0; k < m->n; k++) {
		const struct hawser_mode *mode = m->mode + k;
		double error = HUGE_VAL;
		int count = 0;

		for (int j = 0; j < exact.n; j++) {
			if (exact.mode[j].plane != mode->plane)
				continue;
			if (!in_place || count++ == next[mode->plane])
				error = fmin(error, fabs(mode->omega/exact.mode[j].omega - 1.0));
		}
		next[mode->plane]++;
		least = fmin(least, (mode->residual + 1e-14)/error);
	}
	ok(least >= 1.0, "stated errors are %.2g times the true ones at least", least);
	hawser_modes_clear(&exact);
}

/* Properties of a converged result, up to its error. */
static void converged(const struct hawser_modes *m, double slack)
{
	ok(slack <= 1e-10, "estimated error %.1e meets the default tolerance", slack);
	orthogonality(m, slack);
	equilibrium(m, slack);
	quartic(m);
}

static void battery(const struct hawser_modes_method *method, const double *p)
{
	struct hawser_statics st = scaled_span(p[0], p[1], p[2]);
	struct hawser_modes_options options = {.n = MODES, .method = method->name, .any_error = 1};
	struct hawser_report report = {0};
	int spectral = method->tolerance <= 1e-9;
	static const char *told; /* the method that has said that it did not converge */
	enum hawser_status status;
	struct hawser_modes m;
	double slack = 0.0;

	printf("# %s: epsilon %g, delta %g, hs %g\n", method->name, p[0], p[1], p[2]);
	/* refining to the finest grid takes longest: once a method, or with HAWSER_LONG */
	if (!spectral && told == method->name && p[0] < 1e-8 && !getenv("HAWSER_LONG"))
		options.basis = 300;
	status = hawser_modes_solve(&m, &st, &options, &report);
	if (status == HAWSER_ERR_CONVERGENCE && !spectral) {
		told = method->name;
		ok(report.residual > method->tolerance && strlen(report.message) > 20 && !m.shape,
		   "not converged, and says so: %s", report.message);
		options.basis = 300;
		status = hawser_modes_solve(&m, &st, &options, &report);
	}
	if (!ok(!status, "solved %s", report.message))
		return;
	ok(m.n == MODES && m.method == method->name && m.basis > 0, "says what it is");
	for (int k = 0; k < m.n; k++)
		slack = fmax(slack, m.mode[k].residual);
	ok(options.basis > 0 || slack <= method->tolerance, "error %.1e, within its tolerance", slack);
	unit_norm(&m);
	if (spectral)
		converged(&m, slack);
	else
		honest(&m, isfinite(method->tolerance));
	if (isinf(method->tolerance) || slack < 1.0) {
		/* Closed forms have these properties whatever their error. The slopes of a chain are its
		 * strains, which differ from the derivatives of its shapes by the error of a shape, not by
		 * that of a frequency. */
		int own = strcmp(method->name, "chain") == 0;

		compatibility(&m, isinf(method->tolerance) ? 0.0 : own ? 100.0*slack : slack);
		ends(&m, isinf(method->tolerance) ? 0.0 : slack);
	}
	order_and_sign(&m);
	mirror(&m, &options, p, slack);
	hawser_modes_clear(&m);
}

static void refuse(const char *what, enum hawser_status want, const struct hawser_statics *st,
                   struct hawser_modes_options options)
{
	struct hawser_report report = {0};
	struct hawser_modes m;
	enum hawser_status got = hawser_modes_solve(&m, st, &options, &report);

	ok(got == want && report.status == want && strlen(report.message) > 20 && !m.shape,
	   "%s: %s, \"%s\"", what, hawser_status_name(got), report.message);
	hawser_modes_clear(&m);
}

static void refusals(const char *method)
{
	struct hawser_statics good = scaled_span(1e-4, 0.1, 0.2), st = good;
	struct hawser_modes_options o = {.n = 5, .method = method};

	o.n = 0;
	refuse("no modes", HAWSER_ERR_ARGUMENT, &good, o);
	o = (struct hawser_modes_options){.n = 61, .basis = 20, .method = method};
	refuse("more modes than the basis carries", HAWSER_ERR_ARGUMENT, &good, o);
	o = (struct hawser_modes_options){.n = 5, .basis = -1, .method = method};
	refuse("negative basis", HAWSER_ERR_ARGUMENT, &good, o);
	o = (struct hawser_modes_options){.n = 5, .basis = 1000000, .method = method};
	refuse("basis beyond reach", HAWSER_ERR_ARGUMENT, &good, o);
	o = (struct hawser_modes_options){.n = 5, .tolerance = NAN, .method = method};
	refuse("tolerance not a number", HAWSER_ERR_ARGUMENT, &good, o);
	o = (struct hawser_modes_options){.n = 5, .tolerance = 1e-17, .method = method};
	refuse("tolerance below round-off", HAWSER_ERR_CONVERGENCE, &good, o);
	o = (struct hawser_modes_options){.n = 100000, .method = method};
	refuse("very many modes", HAWSER_ERR_ARGUMENT, &good, o);
	o = (struct hawser_modes_options){.n = 5, .method = method};
	st.span.EA = HUGE_VAL;
	st.epsilon = 0.0;
	refuse("inextensible", HAWSER_ERR_NO_SOLUTION, &st, o);
	st = good;
	st.eta = NAN;
	refuse("statics not a number", HAWSER_ERR_NAN, &st, o);
	st = good;
	st.l = -1.0;
	refuse("negative length", HAWSER_ERR_ARGUMENT, &st, o);
	st = good;
	st.delta = HUGE_VAL;
	refuse("infinite weight", HAWSER_ERR_ARGUMENT, &st, o);
}

/* Exponential convergence of the spectral method: four more functions divide the error of ten
 * frequencies by at least 20, until round-off. */
static void spectral_convergence(void)
{
	struct hawser_statics st = scaled_span(1e-9, 0.8, 0.3);
	struct hawser_modes exact, m;
	struct hawser_modes_options options = {.n = MODES, .basis = 44};
	double before = 0.0;
	int steps = 0;

	if (!ok(!hawser_modes_solve(&exact, &st, &options, NULL), "44 functions"))
		return;
	for (options.basis = 8; options.basis <= 24; options.basis += 4) {
		double worst = 0.0;

		if (!ok(!hawser_modes_solve(&m, &st, &options, NULL), "%d functions", options.basis))
			break;
		for (int k = 0; k < MODES; k++)
			worst = fmax(worst, fabs(m.mode[k].omega/exact.mode[k].omega - 1.0));
		if (before > 1e-13) {
			ok(worst < before/20.0 || worst < 1e-14, "%d functions: error %.1e after %.1e",
			   options.basis, worst, before);
			steps++;
		}
		before = worst;
		hawser_modes_clear(&m);
	}
	ok(steps >= 2 && before < 1e-13, "round-off reached after %d steps", steps);
	hawser_modes_clear(&exact);
}

CASE(property_modes)
{
	const struct hawser_modes_method *row;
	struct hawser_statics st = scaled_span(1e-4, 0.1, 0.2);

	for (int i = 0; (row = hawser_modes_method(i)); i++) {
		ok(row->name && row->summary && row->source && row->solve,
		   "row %d is complete", i);
		for (int k = 0; k < SPANS; k++)
			battery(row, spans[k]);
		refusals(row->name);
	}
	refuse("unknown method", HAWSER_ERR_ARGUMENT, &st,
	       (struct hawser_modes_options){.n = 1, .method = "spectrel"});
	hawser_modes_clear(NULL);
	spectral_convergence();
	return done_testing();
}

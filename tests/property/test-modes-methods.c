/* tests/property/test-modes-methods.c - the stated properties of each method on the source's
 * example cables (B Table 4.1), level and at a slope of 1/3, over the tensions of the source's
 * figures.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/modes-scene.h"
#include "tests/modes-span.h"
#include "tests/tap.h"

enum { MODES = 10, CASES = 3, MOST_FUNCTIONS = 40 };
static const double slopes[2] = {0.0, 1.0/3.0};

static int solve(struct hawser_modes *m, const struct hawser_statics *st, const char *method, int n,
                 int basis)
{
	struct hawser_modes_options options = {.n = n, .basis = basis, .method = method};
	struct hawser_report report = {0};

	if (!hawser_modes_solve(m, st, &options, &report))
		return 1;
	ok(0, "%s", report.message);
	return 0;
}

/* The k-th mode (from 0) of a plane. */
static const struct hawser_mode *of_plane(const struct hawser_modes *m, enum hawser_plane plane,
                                          int k)
{
	for (int i = 0; i < m->n; i++)
		if (m->mode[i].plane == plane && k-- == 0)
			return m->mode + i;
	return NULL;
}

/* Largest relative difference between the modes of m and those of `right` with the same plane and
 * place. */
static double worst_error(const struct hawser_modes *m, const struct hawser_modes *right)
{
	int next[2] = {0};
	double worst = 0.0;

	for (int i = 0; i < m->n; i++) {
		enum hawser_plane plane = m->mode[i].plane;
		const struct hawser_mode *mode = of_plane(right, plane, next[plane]++);

		worst = fmax(worst, mode ? fabs(m->mode[i].omega/mode->omega - 1.0) : HUGE_VAL);
	}
	return worst;
}

/* lambda/pi from 0.1 to 10 for every case: H from EA downwards, in steps of 10 %. */
static void spectral_functions(void)
{
	for (int c = 1; c <= CASES; c++)
		for (int j = 0; j < 2; j++) {
			double worst = 0.0, at = 0.0, deepest = 0.0;
			struct hawser_statics st;
			int solved = 0;

			if (!ok(table_4_1(&st, c, slopes[j], 1.0), "case %d", c))
				continue;

			for (double ratio = 1.0; ratio > 1e-7; ratio *= 0.9) {
				struct hawser_modes m, right;
				double error, lambda;

				if (!tighten(&st, ratio))
					continue;
				lambda = st.irvine_source/M_PI;
				if (lambda < 0.1 || lambda > 10.0)
					continue;
				if (!solve(&right, &st, "spectral", MODES, 0))
					continue;
				if (solve(&m, &st, "spectral", MODES, MOST_FUNCTIONS)) {
					error = worst_error(&m, &right);
					solved++;
					deepest = fmax(deepest, st.delta);
					at = error > worst ? lambda : at;
					worst = fmax(worst, error);
					hawser_modes_clear(&m);
				}
				hawser_modes_clear(&right);
			}
			ok(solved > 25 && worst < 1e-9, "case %d, slope %.2f: %d functions give the first "
			   "%d frequencies of %d tensions to %.1e (lambda/pi %.2f; delta up to %.2f)", c,
			   slopes[j], MOST_FUNCTIONS, MODES, solved, worst, at, deepest);
		}
}

/* The taut span with the given lambda/pi (B 4.60); lambda decreases with H. */
static int at_lambda(struct hawser_statics *st, int c, double slope, double lambda)
{
	double low = 1e-7, high = 2.0;

	if (!table_4_1(st, c, slope, high))
		return 0;
	for (int i = 0; i < 60; i++) {
		double middle = sqrt(low*high);

		if (!tighten(st, middle))
			return 0;
		if (st->irvine_source > lambda*M_PI)
			low = middle;
		else
			high = middle;
	}
	return 1;
}

static const double lambdas[] = {0.3, 1.4, 2.385, 6.1};
enum { LAMBDAS = sizeof lambdas/sizeof lambdas[0] };

/* Two successive halvings of the interval divide the largest error by four each. */
static void second_order(const char *method, const struct hawser_statics *st, const char *where)
{
	struct hawser_modes right, m;
	double error[3], low = HUGE_VAL, high = 0.0;

	if (!solve(&right, st, "spectral", MODES + 10, 0))
		return;
	for (int i = 0; i < 3; i++) {
		error[i] = HUGE_VAL;
		if (solve(&m, st, method, MODES, (100 << i) - 1)) {
			error[i] = worst_error(&m, &right);
			hawser_modes_clear(&m);
		}
	}
	for (int i = 0; i < 2; i++) {
		low = fmin(low, log2(error[i]/error[i + 1]));
		high = fmax(high, log2(error[i]/error[i + 1]));
	}
	ok(low > 1.95 && high < 2.05, "%s, %s: order %.3f to %.3f, error %.1e with 399 points", method,
	   where, low, high, error[2]);
	hawser_modes_clear(&right);
}

/* An exact frequency of its plane lies within the stated error of each closed form. */
static void closed_forms(const struct hawser_statics *st, const char *where)
{
	struct hawser_modes right, m;
	double least = HUGE_VAL, worst = 0.0, stated = 0.0;

	if (!solve(&right, st, "spectral", 3*MODES, 0))
		return;
	if (solve(&m, st, "analytic", MODES, 0)) {
		for (int i = 0; i < m.n; i++) {
			double error = HUGE_VAL;
			const struct hawser_mode *mode;

			for (int k = 0; (mode = of_plane(&right, m.mode[i].plane, k)); k++)
				error = fmin(error, fabs(m.mode[i].omega/mode->omega - 1.0));
			least = fmin(least, (m.mode[i].residual + 1e-14)/error);
			worst = fmax(worst, error);
			stated = fmax(stated, m.mode[i].residual);
		}
		ok(least >= 1.0, "closed forms, %s: error up to %.1e, stated up to %.1e, each at "
		   "least %.2f times the true one", where, worst, stated, least);
		hawser_modes_clear(&m);
	}
	hawser_modes_clear(&right);
}

static void each_case(void)
{
	for (int c = 1; c <= CASES; c++)
		for (int j = 0; j < 2; j++)
			for (int i = 0; i < LAMBDAS; i++) {
				struct hawser_statics st;
				char where[80];

				snprintf(where, sizeof where, "case %d, slope %.2f, lambda %.2f pi", c,
				         slopes[j], lambdas[i]);
				if (!ok(at_lambda(&st, c, slopes[j], lambdas[i]), "%s", where))
					continue;
				second_order("fdm", &st, where);
				second_order("chain", &st, where);
				closed_forms(&st, where);
			}
}

/* First symmetric minus first antisymmetric in-plane frequency of a level span. */
static double ahead(const char *method, double lambda, double delta)
{
	struct hawser_statics st = scaled_span(delta*delta/(lambda*lambda), delta, 0.0);
	double omega[2] = {NAN, NAN};
	struct hawser_modes m;

	if (!solve(&m, &st, method, 6, 0))
		return NAN;
	for (int k = m.n - 1; k >= 0; k--)
		if (m.mode[k].plane == HAWSER_IN_PLANE && m.mode[k].symmetry != HAWSER_MIXED)
			omega[m.mode[k].symmetry == HAWSER_ANTISYMMETRIC] = m.mode[k].omega;
	hawser_modes_clear(&m);
	return omega[0] - omega[1];
}

/* The crossing is at lambda = 2 pi for delta -> 0, up to terms of order delta^2. */
static void crossover(const char *method)
{
	const double delta = 1e-3;
	double low = 1.9*M_PI, high = 2.1*M_PI;

	ok(ahead(method, low, delta) < 0.0 && ahead(method, high, delta) > 0.0,
	   "%s: the symmetric mode overtakes", method);
	for (int i = 0; i < 24; i++) {
		double middle = 0.5*(low + high);

		if (ahead(method, middle, delta) < 0.0)
			low = middle;
		else
			high = middle;
	}
	close_to(0.5*(low + high)/M_PI, 2.0, 1e-5, "crossover over pi");
}

/* With few points on a taut cable, finite differences increase the in-plane frequencies by several
 * percent, and the error estimates show this. Out-of-plane frequencies do not have this error and
 * are accurate. */
static void few_points(double epsilon, double delta, int points)
{
	struct hawser_statics st = scaled_span(epsilon, delta, 0.04);
	double worst = 0.0, most = 0.0, out = 0.0;
	struct hawser_modes right, m;

	if (!solve(&right, &st, "spectral", 30, 0))
		return;
	if (solve(&m, &st, "fdm", 5, points)) {
		int next[2] = {0};

		for (int i = 0; i < m.n; i++) {
			enum hawser_plane plane = m.mode[i].plane;
			const struct hawser_mode *mode = of_plane(&right, plane, next[plane]++);
			double ratio = m.mode[i].residual/fabs(m.mode[i].omega/mode->omega - 1.0);

			worst = fmax(worst, 1.0/ratio);
			most = fmax(most, ratio);
			out = plane == HAWSER_OUT_OF_PLANE ? fmax(out, m.mode[i].residual) : out;
		}
		ok(worst < 1.0 && most < 10.0 && out < 0.1, "%d points, epsilon %g, delta %g: stated between "
		   "%.1f and %.1f times the true error, out of the plane up to %.1e", points, epsilon, delta,
		   1.0/worst, most, out);
		hawser_modes_clear(&m);
	}
	hawser_modes_clear(&right);
}

CASE(property_modes_methods)
{
	few_points(2e-4, 0.184, 12);
	few_points(2e-4, 0.184, 20);
	few_points(1e-5, 0.184, 80);
	few_points(1e-4, 1.5, 160);
	few_points(1e-2, 5.0, 160);
	spectral_functions();
	each_case();
	crossover("spectral");
	crossover("analytic");
	return done_testing();
}

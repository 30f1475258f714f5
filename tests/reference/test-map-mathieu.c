/* Parametric resonance of one coordinate against Mathieu's equation:
 *
 *   u'' + 2 c u' + (1 + f cos Omega t) u = 0      a = 4/Omega^2, q = 2 f/Omega^2 with c = 0
 *
 * The boundaries of the tongue at Omega = 2/r are the characteristic values a_r(q) and b_r(q), which
 * GSL has (gsl_sf_mathieu_a, _b). With damping u = exp(-c t) w leaves a = 4 (1 - c^2)/Omega^2 for
 * w, which may grow as exp(c t): the boundary is where the largest multiplier of Mathieu's
 * equation is exp(2 pi c/Omega). That is found here by a Taylor series of order 30 a step, which
 * shares nothing with the method under test, and to second order by the known expansion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <gsl/gsl_sf_mathieu.h>

#include <hawser/hawser.h>

#include "tests/tap.h"

static double stiffness[1] = {1.0}, damping[1], excitation[1] = {1.0};
static struct hawser_harmonic harmonic = {.k = 1, .phase = HAWSER_COS, .K = excitation};
static const struct hawser_rom model = {.n = 1, .D = damping, .K = stiffness, .harmonics = 1,
	.harmonic = &harmonic, .length = 1.0, .time = 1.0, .force = 1.0};

static int trace(struct hawser_map *map, double from, double to, double most, int points)
{
	const struct hawser_map_source source = {.rom = &model, .key = {"Omega", "factor.load"},
		.quantity = "multiplier"};
	struct hawser_map_options options = {.coarse = 0};
	struct hawser_map_field field;
	struct hawser_report report = {.status = HAWSER_OK};
	enum hawser_status status = hawser_map_cable_open(&field, &source, &report);

	options.from[0] = from;
	options.to[0] = to;
	options.from[1] = 0.0;
	options.to[1] = most;
	options.points[0] = options.points[1] = points;
	options.tolerance = 1e-11;
	*map = (struct hawser_map){.nx = 0};
	if (!status)
		status = hawser_map_trace(map, &field, &options, &report);
	hawser_map_cable_close(&field);
	return ok(!status, "a map of %g to %g, damping %g: %d boundary points %s", from, to, damping[0],
	          map->boundaries, report.message);
}

/* Relative distance in a from the nearer boundary of tongue r. */
static double off_mathieu(const struct hawser_map_boundary *at, int r)
{
	double a = 4.0/(at->x*at->x), q = 2.0*at->y/(at->x*at->x);
	double one = gsl_sf_mathieu_a(r, q), two = gsl_sf_mathieu_b(r, q);

	return fmin(fabs(a - one), fabs(a - two))/a;
}

static void undamped(int r, double from, double to)
{
	struct hawser_map map;
	double worst = 0.0;
	int left = 0, right = 0;

	damping[0] = 0.0;
	if (trace(&map, from, to, 0.9, 41)) {
		for (int k = 0; k < map.boundaries; k++) {
			double a = 4.0/(map.boundary[k].x*map.boundary[k].x);
			double q = 0.5*map.boundary[k].y*a;

			worst = fmax(worst, off_mathieu(&map.boundary[k], r));
			if (2.0*a > gsl_sf_mathieu_a(r, q) + gsl_sf_mathieu_b(r, q))
				left++;
			else
				right++;
		}
		ok(map.boundaries >= 79 && left > 30 && right > 30,
		   "tongue %d: %d points on the left and %d on the right", r, left, right);
		ok(worst < 1e-8, "tongue %d: within %.1e of GSL's a_%d and b_%d", r, worst, r, r);
	}
	hawser_map_clear(&map);
}

/* --- damped --- */

/* The trace alone: sum of the diagonal of the monodromy matrix of w'' + (p + f cos Omega t) w = 0
 * by Taylor series. cos and sin of the phase have their own series. */
enum { ORDER = 30, STEPS = 64 };
static void taylor_step(double w[2], double p, double f, double omega, double t, double h)
{
	double u[ORDER + 2], c[ORDER], s[ORDER], x = 0.0, v = 0.0;

	u[0] = w[0];
	u[1] = w[1];
	c[0] = cos(omega*t);
	s[0] = sin(omega*t);
	for (int k = 0; k + 1 < ORDER; k++) {
		c[k + 1] = -omega*s[k]/(k + 1);
		s[k + 1] = omega*c[k]/(k + 1);
	}
	for (int k = 0; k < ORDER; k++) {
		double sum = p*u[k];

		for (int i = 0; i <= k; i++)
			sum += f*c[i]*u[k - i];
		u[k + 2] = -sum/((k + 1)*(k + 2));
	}
	for (int k = ORDER + 1; k >= 0; k--)
		x = x*h + u[k];
	for (int k = ORDER + 1; k >= 1; k--)
		v = v*h + k*u[k];
	w[0] = x;
	w[1] = v;
}

/* Positive inside the tongue of the damped equation: |trace| of w over 2 cosh(c T). */
static double inside(double omega, double f, double c)
{
	double period = 2.0*M_PI/omega, h = period/STEPS, sum = 0.0;

	for (int k = 0; k < 2; k++) {
		double w[2] = {k == 0, k == 1};

		for (int i = 0; i < STEPS; i++)
			taylor_step(w, 1.0 - c*c, f, omega, i*h, h);
		sum += w[k];
	}
	return fabs(sum) - 2.0*cosh(c*period);
}

static double bisect(double omega, double f, double c, double reach)
{
	double a = omega - reach, b = omega + reach, at_a = inside(a, f, c);

	if (at_a*inside(b, f, c) > 0.0)
		return NAN;
	for (int k = 0; k < 60; k++) {
		double middle = 0.5*(a + b), at_middle = inside(middle, f, c);

		if ((at_middle > 0.0) == (at_a > 0.0))
			a = middle;
		else
			b = middle;
	}
	return 0.5*(a + b);
}

static void damped(double c)
{
	struct hawser_map map;
	double worst = 0.0, expansion = 0.0, least = INFINITY;
	int compared = 0;

	damping[0] = 2.0*c;
	if (!trace(&map, 1.5, 2.6, 0.6, 41)) {
		hawser_map_clear(&map);
		return;
	}
	for (int k = 0; k < map.boundaries; k++) {
		const struct hawser_map_boundary *at = &map.boundary[k];
		double f = at->y, want;

		least = fmin(least, f);
		if (at->along != 0)
			continue;
		want = bisect(at->x, f, c, 1e-4);
		worst = fmax(worst, fabs(at->x - want)); /* NaN fails below */
		compared += isfinite(want);
		/* (Omega/2)^2 = 1 - 2 c^2 +- sqrt(f^2/4 - 4 c^2), Bolotin's first approximation, whose error
		 * is of the order of f^2 */
		if (f > 4.5*c)
			expansion = fmax(expansion, fabs(fabs(at->x*at->x/4.0 - 1.0 + 2.0*c*c) -
			                                 sqrt(0.25*f*f - 4.0*c*c))/(f*f));
	}
	/* a multiplier counts as unstable if its logarithm exceeds 1e-8: this displaces the boundary
	 * inwards */
	ok(compared > 40 && worst < 5e-8, "damping %g: %d points within %.1e of a Taylor series", c,
	   compared, worst);
	ok(expansion < 0.2, "damping %g: the first approximation is off by %.3f f^2", c, expansion);
	ok(least > 4.0*c*0.99 && least < 4.0*c*1.2, "damping %g: the tongue begins at %g, near 4 c", c,
	   least);
	hawser_map_clear(&map);
}

CASE(reference_map_mathieu)
{
	undamped(1, 1.2, 2.9);
	undamped(2, 0.85, 1.08);
	damped(0.01);
	damped(0.05);
	return done_testing();
}

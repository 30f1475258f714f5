/* Lyapunov exponents: of linear models their damping and eigenvalues; of a periodic motion the Floquet
 * exponents by a Runge-Kutta formula of this test; Ueda's chaotic oscillator against the published
 * value (Sprott, Chaos and Time-Series Analysis, 2003, table of driven systems: 0.1034); a free pair of
 * oscillators has a sum of 0; what is refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/lyapunov.h>

#include "tests/integrate-models.h"

static void linear(void)
{
	/* underdamped, then overdamped: -d/2 twice; -d/2 +- sqrt(d^2/4 - k) */
	const double damping[2] = {0.031, 2.6};

	for (int i = 0; i < 2; i++) {
		struct hawser_rom rom = model_oscillator(damping[i], 1.0, 0.0, 0.2);
		double rest[2] = {0.0, 0.0}, root = sqrt(fmax(0.25*damping[i]*damping[i] - 1.0, 0.0));
		struct hawser_lyapunov_options options = {.omega = 0.71, .initial = rest, .periods = 400};
		struct hawser_lyapunov found;

		ok(!hawser_lyapunov_find(&found, &rom, &options, NULL), "linear, damping %g", damping[i]);
		for (int k = 0; k < 2; k++) {
			double want = -0.5*damping[i] + (k ? -root : root), off = found.exponent[k] - want;

			ok(fabs(off) < 1e-9 && fabs(off) <= found.error[k] + 1e-14,
			   "%.15g against %.15g: off by %.1e, stated %.1e", found.exponent[k], want, off,
			   found.error[k]);
		}
		hawser_lyapunov_clear(&found);
		hawser_rom_clear(&rom);
	}
}

/* u'' + d u' + u + c u^3 = f cos(w t) and two disturbances: y = u, v, and these. */
static void slope(double out[6], const double y[6], double t, const double p[4])
{
	out[0] = y[1];
	out[1] = p[2]*cos(p[3]*t) - p[0]*y[1] - y[0] - p[1]*pow(y[0], 3);
	for (int i = 2; i < 6; i += 2) {
		out[i] = y[i + 1];
		out[i + 1] = -p[0]*y[i + 1] - (1.0 + 3.0*p[1]*y[0]*y[0])*y[i];
	}
}

static void step(double y[6], double t, double h, const double p[4])
{
	double k[4][6], z[6];

	slope(k[0], y, t, p);
	for (int s = 1; s < 4; s++) {
		double c = s == 3 ? h : 0.5*h;

		for (int i = 0; i < 6; i++)
			z[i] = y[i] + c*k[s - 1][i];
		slope(k[s], z, t + c, p);
	}
	for (int i = 0; i < 6; i++)
		y[i] += h/6.0*(k[0][i] + 2.0*k[1][i] + 2.0*k[2][i] + k[3][i]);
}

static void periodic(double d, double c, double f, double w)
{
	enum { STEPS = 1500 };
	struct hawser_rom rom = model_oscillator(d, 1.0, c, f);
	const double p[4] = {d, c, f, w};
	double y[6] = {0.0}, h = 2.0*M_PI/w/STEPS, trace, determinant, gap, want[2], start[2];
	struct hawser_lyapunov_options options = {.omega = w, .initial = start, .periods = 1000};
	struct hawser_lyapunov found;

	for (int k = 0; k < 300; k++) {
		y[2] = y[5] = 1.0;
		y[3] = y[4] = 0.0;
		start[0] = y[0];
		start[1] = y[1];
		for (int i = 0; i < STEPS; i++)
			step(y, i*h, h, p);
	}
	trace = y[2] + y[5];
	determinant = y[2]*y[5] - y[3]*y[4];
	gap = sqrt(fmax(0.25*trace*trace - determinant, 0.0));
	for (int k = 0; k < 2; k++)
		want[k] = w/(2.0*M_PI)*
		          (gap > 0.0 ? log(fabs(0.5*trace + (k ? -1.0 : 1.0)*copysign(gap, trace)))
		                     : 0.5*log(determinant));
	ok(!hawser_lyapunov_find(&found, &rom, &options, NULL), "periodic, Omega %g", w);
	for (int k = 0; k < 2; k++)
		ok(fabs(found.exponent[k] - want[k]) < 1e-7, "%.12g against Floquet's %.12g, stated %.1e",
		   found.exponent[k], want[k], found.error[k]);
	hawser_lyapunov_clear(&found);
	hawser_rom_clear(&rom);
}

static void ueda(void)
{
	struct hawser_rom rom = model_oscillator(0.05, 0.0, 1.0, 7.5);
	const double start[2] = {2.9974942784243939, -1.5124807139220722};
	struct hawser_lyapunov_options options = {.omega = 1.0, .initial = start, .periods = 4000,
	                                          .rtol = 1e-7};
	struct hawser_lyapunov found;

	ok(!hawser_lyapunov_find(&found, &rom, &options, NULL), "Ueda's oscillator");
	ok(fabs(found.exponent[0] - 0.1034) < 2.0*found.error[0] && found.error[0] < 0.02,
	   "%.5g +- %.1g against the published 0.1034", found.exponent[0], found.error[0]);
	ok(fabs(found.exponent[0] + found.exponent[1] + 0.05) < options.rtol, "sum: the damping, %.12g",
	   found.exponent[0] + found.exponent[1]);
	hawser_lyapunov_clear(&found);
	hawser_rom_clear(&rom);
}

static void free_pair(void)
{
	struct hawser_rom rom = model_pair();
	const double start[4] = {0.1, 0.05, 0.0, 0.02};
	struct hawser_lyapunov_options options = {.omega = 1.0, .initial = start, .periods = 1200};
	struct hawser_lyapunov found;
	double sum = 0.0;

	ok(!hawser_lyapunov_find(&found, &rom, &options, NULL), "a free pair");
	for (int i = 0; i < found.m; i++)
		sum += found.exponent[i];
	ok(fabs(sum) < 1e-10 && fabs(found.exponent[0]) < 1e-3 &&
	   fabs(found.exponent[0] + found.exponent[3]) < found.error[0] + found.error[3],
	   "%.2e %.2e %.2e %.2e: pairs of opposite sign, regular",
	   found.exponent[0], found.exponent[1], found.exponent[2], found.exponent[3]);
	hawser_lyapunov_clear(&found);
	hawser_rom_clear(&rom);
}

static void refused(void)
{
	struct hawser_rom rom = model_oscillator(0.05, 1.0, 0.1, 0.2);
	const double far[2] = {1e200, 0.0}, rest[2] = {0.0, 0.0};
	struct hawser_lyapunov_options good = {.omega = 1.0, .initial = rest, .periods = 100}, bad = good;
	struct hawser_lyapunov found;
	struct hawser_report report;

	bad.omega = -1.0;
	ok(hawser_lyapunov_find(&found, &rom, &bad, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	bad = good;
	bad.rtol = 2.0;
	ok(hawser_lyapunov_find(&found, &rom, &bad, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	bad = good;
	bad.periods = 99;
	ok(hawser_lyapunov_find(&found, &rom, &bad, &report) == HAWSER_ERR_ARGUMENT, "%s", report.message);
	bad = good;
	bad.rtol = 1e-300;
	ok(hawser_lyapunov_find(&found, &rom, &bad, &report) == HAWSER_ERR_CONVERGENCE, "%s",
	   report.message);
	hawser_lyapunov_clear(&found);
	bad = good;
	bad.initial = far;
	ok(hawser_lyapunov_find(&found, &rom, &bad, &report) == HAWSER_ERR_NAN, "%s", report.message);
	hawser_lyapunov_clear(&found);
	hawser_rom_clear(&rom);
}

CASE(property_lyapunov)
{
	linear();
	periodic(0.2, 0.4, 0.5, 1.1);
	periodic(0.1, 0.3, 0.4, 1.7);
	periodic(2.6, 0.3, 0.4, 1.7);
	ueda();
	free_pair();
	refused();
	return done_testing();
}

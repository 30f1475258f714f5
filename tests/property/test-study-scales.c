/* Multiple scales against the traced response: the error of the closed forms decreases with the
 * predicted order, for a cubic spring and for a mode whose nonlinearity is caused by another mode.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/study.h>

#include "study/accuracy/scales.h"
#include "tests/tap.h"

/* u'' + c u' + w^2 u + beta u^2 + gamma u^3 + 2 b u v = f cos, v'' + c v' + wv^2 v + b u^2 = 0, with
 * c, f and the amplitude of orders e^2, e^3 and e. */
static struct hawser_rom model(double e, double gamma, double beta, double b)
{
	struct hawser_rom rom = {.n = 2, .harmonics = 1};
	const double w = 1.3, wv = 3.7, c = 0.05, f = 0.12;
	int quads = 0;

	rom.K = calloc(4, sizeof(double));
	rom.D = calloc(4, sizeof(double));
	rom.Q = calloc(3, sizeof *rom.Q);
	rom.C = calloc(1, sizeof *rom.C);
	rom.harmonic = calloc(1, sizeof *rom.harmonic);
	rom.harmonic->f = calloc(2, sizeof(double));
	rom.K[0] = w*w;
	rom.K[3] = wv*wv;
	rom.D[0] = rom.D[3] = c*e*e;
	rom.Q[quads++] = (struct hawser_quad){0, 0, 0, beta};
	rom.Q[quads++] = (struct hawser_quad){0, 0, 1, 2.0*b};
	rom.Q[quads++] = (struct hawser_quad){1, 0, 0, b};
	rom.quads = quads;
	rom.C[0] = (struct hawser_cubic){0, 0, 0, 0, gamma};
	rom.cubics = 1;
	rom.harmonic->k = 1;
	rom.harmonic->f[0] = f*e*e*e;
	return rom;
}

/* Relative to the bend, which is of order e^2: the neglected terms in Omega are of order e^4. */
static double worst_fold(double e, double gamma, double beta, double b, double *bend)
{
	struct hawser_rom rom = model(e, gamma, beta, b);
	struct hawser__resonance resonance;
	struct hawser__scales scales;
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_report report = {.message = ""};
	struct hawser_frf frf = {.n = 0};
	double worst = 0.0;
	int found = 0;

	if (!ok(!hawser_rom_compile(&rom, &report), "the model %s", report.message))
		return NAN;
	resonance = hawser__resonance_of(&rom, 0);
	scales = hawser__scales_solve(&resonance);
	*bend = fabs(scales.peak_omega - resonance.omega);
	options.from = resonance.omega - 1.5**bend;
	options.to = resonance.omega + 1.5**bend;
	options.step_max = 0.02;
	if (ok(!hawser_frf_trace(&frf, &rom, &options, &report), "e = %g %s", e, report.message))
		for (int i = 0; i < frf.events; i++)
			for (int k = 0; k < scales.folds; k++) {
				double off = fabs(frf.event[i].omega - scales.fold_omega[k]);

				if (frf.event[i].kind != HAWSER_FOLD || off > 0.3**bend)
					continue;
				worst = fmax(worst, off);
				found++;
			}
	ok(scales.folds == 2 && found == 2, "two folds on either side (%d, %d)", scales.folds,
	   found);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	return worst;
}

static void check_order(const char *what, double gamma, double beta, double b)
{
	double bend[2], coarse = worst_fold(0.2, gamma, beta, b, &bend[0]);
	double fine = worst_fold(0.1, gamma, beta, b, &bend[1]);
	double order = log(coarse/fine)/log(2.0);

	printf("# %s: bend %.3e, %.3e; folds off by %.2e, %.2e\n", what, bend[0], bend[1], coarse,
	       fine);
	ok(order > 3.7 && order < 4.3, "%s: folds of order %.2f in the amplitude", what, order);
}

/* The closed forms satisfy the equation that defines them. */
static void check_closed(double cubic, double f)
{
	struct hawser__resonance resonance = {.omega = 2.385, .c = 0.031, .f = f, .cubic = cubic};
	struct hawser__scales scales = hawser__scales_solve(&resonance);
	double delta = 0.5*resonance.c, Gamma = 0.375*cubic/resonance.omega;
	double F = 0.5*f/resonance.omega;

	close_to(scales.peak, f/(resonance.c*resonance.omega), 1e-14, "peak");
	for (int i = 0; i < scales.folds; i++) {
		double a = scales.fold[i], sigma = scales.fold_omega[i] - resonance.omega;
		double x = sigma - Gamma*a*a;

		close_to(a*a*(delta*delta + x*x), F*F, 1e-12, "a fold is on the curve");
		/* d/da of the left side at fixed sigma; x has lost the digits of Gamma a^2 */
		ok(fabs(delta*delta + x*x - 2.0*Gamma*a*a*x) < 1e-12*(delta*delta + x*x) +
		   1e-14*pow(Gamma*a*a, 2), "where it turns");
	}
	ok(scales.folds == 0 || (scales.fold[0] > scales.fold[1] && scales.fold[0] <= scales.peak),
	   "the larger first: %g, %g, peak %g", scales.fold[0], scales.fold[1], scales.peak);
}

CASE(property_study_scales)
{
	/* 2 Gamma F^2/delta^3 = 16/(3 sqrt 3): slightly above there are folds, slightly below none */
	double delta = 0.0155, w = 2.385, Gamma = 0.375*0.9/w;
	double f = 2.0*w*sqrt(16.0/(3.0*sqrt(3.0))*pow(delta, 3)/(2.0*Gamma));
	struct hawser__resonance just = {.omega = w, .c = 2.0*delta, .cubic = 0.9};

	just.f = 0.999*f;
	ok(hawser__scales_solve(&just).folds == 0, "below the load at which folds begin");
	just.f = 1.001*f;
	ok(hawser__scales_solve(&just).folds == 2, "above it");
	check_closed(0.9, 0.1);
	check_closed(-0.9, 0.1);
	check_closed(0.9, 30.0);
	check_closed(0.0, 0.1);
	/* a condensed mode is the limit of a mode with dynamic response */
	close_to(hawser__returned(0.7, 1e4, 1.3), hawser__returned_static(0.7, 1e4), 1e-7,
	         "a stiff mode follows statically");
	check_order("cubic", 0.8, 0.0, 0.0);
	check_order("softening", -0.8, 0.0, 0.0);
	check_order("own quadratic", 0.0, 0.9, 0.0);
	check_order("another mode's answer", 0.0, 0.0, 1.6);
	check_order("all together", 1.5, 0.5, 1.1);
	return done_testing();
}

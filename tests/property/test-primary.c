/* Primary resonance in closed form, its backbone, and subharmonic resonance: the solutions satisfy
 * the equations and agree with orbits by shooting.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <hawser/backbone.h>
#include <hawser/primary.h>

#include "tests/tap.h"

static double damping[4], stiffness[4], load[2];
static struct hawser_harmonic harmonic;

/* n coordinates, D d on the diagonal, f cos on the first. */
static int make(struct hawser_rom *rom, int n, const double *k, double d, double f,
                struct hawser_quad *Q, int quads,
                struct hawser_cubic *C, int cubics)
{
	static struct hawser_quad quad[4];
	static struct hawser_cubic cubic[4];
	struct hawser_report report = {.message = ""};
	int good;

	memset(damping, 0, sizeof damping);
	memset(stiffness, 0, sizeof stiffness);
	for (int j = 0; j < n; j++) {
		damping[j*n + j] = d;
		stiffness[j*n + j] = k[j];
	}
	load[0] = f;
	load[1] = 0.0;
	harmonic = (struct hawser_harmonic){.k = 1, .phase = HAWSER_COS, .f = load};
	for (int i = 0; i < quads; i++)
		quad[i] = Q[i];
	for (int i = 0; i < cubics; i++)
		cubic[i] = C[i];
	*rom = (struct hawser_rom){.n = n, .D = damping, .K = stiffness, .quads = quads,
		.Q = quad, .cubics = cubics,
		.C = cubic, .harmonics = 1, .harmonic = &harmonic, .length = 1.0, .time = 1.0, .force =
		        1.0};
	good = !hawser_rom_compile(rom, &report);
	return ok(good, "a model of %d coordinates: %s", n, good ? "" : report.message);
}

/* Free the result of hawser_rom_compile; the other arrays belong to the test. */
static void unmake(struct hawser_rom *rom)
{
	struct hawser_rom kernel = {.kernel = rom->kernel};

	hawser_rom_clear(&kernel);
	rom->kernel = NULL;
}

/* Every point satisfies a^2 [delta^2 + (sigma - Gamma a^2)^2] = F^2; stability changes at the
 * folds; the mean and the second harmonic of u'' + u + q u^2 are -q a^2/2 and q a^2/6 (B 4.105,
 * with A = a/2). */
static void closed_form(double q, double gamma3)
{
	const double one = 1.0;
	struct hawser_quad Q[] = {{0, 0, 0, q}};
	struct hawser_cubic C[] = {{0, 0, 0, 0, gamma3}};
	struct hawser_rom rom;
	struct hawser_primary primary;
	struct hawser_primary_curve curve;
	struct hawser_report report = {.message = ""};
	double worst = 0.0, Gamma = 0.375*(gamma3 - 10.0/9.0*q*q), F = 0.5*0.1, least = INFINITY;
	int jumps = 0;

	if (!make(&rom, 1, &one, 0.05, 0.1, Q, 1, C, 1))
		return;
	if (ok(!hawser_primary_derive(&primary, &rom, 0, &report), "primary resonance")) {
		close_to(primary.gamma, Gamma, 1e-14, "backbone coefficient");
		close_to(primary.peak, F/0.025, 1e-14, "peak");
		ok(primary.folds == 2, "two folds");
		ok(!hawser_primary_trace(&curve, &primary, 0.5, 1.8, 300, &report), "its curve");
		for (int i = 0; i < curve.frf.points; i++) {
			double a = curve.amplitude[i], sigma = curve.frf.point[i].omega - 1.0;
			double x = sigma - Gamma*a*a;

			worst = fmax(worst, fabs(a*a*(0.025*0.025 + x*x)/(F*F) - 1.0));
			jumps += i > 0 && curve.frf.point[i].unstable != curve.frf.point[i - 1].unstable;
			least = fmin(least, fabs(curve.frf.point[i].omega - primary.fold_omega[1]));
		}
		ok(worst < 1e-12, "%d points obey the equation within %.1e", curve.frf.points, worst);
		ok(jumps == 2 && curve.frf.events == 2, "stability changes at %d places", jumps);
		ok(least < 1e-14, "a fold is one of the points");
		hawser_primary_curve_clear(&curve);
	}
	hawser_primary_clear(&primary);
	unmake(&rom);
}

/* With a probe that has the displacement of the coordinate: drift and second harmonic. */
static void parts(void)
{
	const double one = 1.0;
	struct hawser_quad Q[] = {{0, 0, 0, 0.3}};
	double s = 0.5, tangent[2] = {1.0, 0.0}, stretch = 1.0, shape[3] = {0.0, 1.0, 0.0}, slope[3] =
	        {0.0};
	char name[] = "mid", *names[] = {name};
	struct hawser_rom rom;
	struct hawser_primary primary = {.mode = 0};
	struct hawser_primary_curve curve = {.amplitude = NULL};
	struct hawser_report report = {.message = ""};
	double worst = 0.0;

	if (!make(&rom, 1, &one, 0.05, 0.02, Q, 1, NULL, 0))
		return;
	rom.shapes = (struct hawser_rom_shapes){.points = 1, .name = names, .s = &s, .tangent = tangent,
		.stretch = &stretch, .shape = shape, .slope = slope, .EA = 1.0};
	if (ok(!hawser_primary_derive(&primary, &rom, 0, &report) &&
	               !hawser_primary_trace(&curve, &primary, 0.8, 1.2, 50, &report), "a probe"))
		for (int i = 0; i < curve.frf.points; i++) {
			const double *y = curve.part + 9*i + 3;
			double a = curve.amplitude[i];

			worst = fmax(worst, fabs(y[0] + 0.15*a*a) + fabs(y[1] - a) + fabs(y[2] - 0.05*a*a));
		}
	ok(worst < 1e-14, "mean -q a^2/2, first a, second q a^2/6: within %.1e", worst);
	hawser_primary_curve_clear(&curve);
	hawser_primary_clear(&primary);
	unmake(&rom);
}

/* The distance of the parabola from the backbone is of fourth order in the amplitude: a series of
 * models. */
static void backbone(double q, double gamma3)
{
	const double k[] = {1.0, 6.3};
	struct hawser_quad Q[] = {{0, 0, 0, q}, {0, 0, 1, 2.0*q}, {1, 0, 0, q}};
	struct hawser_cubic C[] = {{0, 0, 0, 0, gamma3}};
	double gap[2] = {0.0}, gamma = 0.0;
	struct hawser_rom rom;
	struct hawser_report report = {.message = ""};

	if (!make(&rom, 2, k, 0.05, 0.02, Q, 3, C, 1))
		return;
	for (int i = 0; i < 2; i++) {
		struct hawser_backbone_options options = {.mode = 0};
		struct hawser_primary_curve curve;
		struct hawser_backbone run;
		double size = i ? 0.1 : 0.2;
		int last;

		options.size = size;
		options.lo = 0.5;
		options.hi = 1.5;
		options.tolerance = 1e-11;
		options.step_max = 0.01;
		if (!ok(!hawser_backbone_trace(&run, &rom, &options, &report) &&
		                !hawser_primary_backbone(&curve, &gamma, &rom, 0, size, 2, &report),
		                "backbones to %g",
		        size))
			break;
		last = run.points - 1;
		/* max |u| includes drift and second harmonic; the energy is a^2/2 + O(a^4) */
		gap[i] = fabs(run.point[last].omega - 1.0 - 2.0*gamma*run.point[last].energy);
		hawser_primary_curve_clear(&curve);
		hawser_backbone_clear(&run);
	}
	ok(log2(gap[0]/gap[1]) > 3.6, "parabola off by %.1e, order %.2f", gap[0], log2(gap[0]/gap[1]));
	unmake(&rom);
}

/* Equilibria of subharmonic resonance: a periodic state by shooting lies nearby, and the distance
 * decreases with the small parameter. b = 3: Duffing under a hard load; b = 2: with a quadratic
 * term. */
static double subharmonic(int b, double e)
{
	const double one = 1.0;
	struct hawser_quad Q[] = {{0, 0, 0, b == 2 ? 0.2*e : 0.0}};
	/* so that the amplitudes do not change */
	struct hawser_cubic C[] = {{0, 0, 0, 0, b == 2 ? 0.1*e : 0.1*e*e}};
	struct hawser_resonance resonance = {.count = 1, .mode = {0}, .order = {1}, .omega0 = 1.0};
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_modulation m = {.rom = NULL};
	struct hawser_rom rom;
	struct hawser_frf frf = {.n = 0};
	struct hawser_report report = {.message = ""};
	double x[2], omega, state[2], gap = NAN;
	/* detuning of the order of the terms: e (b = 2) or e^2 */
	double shift = b == 2 ? 0.1*e : 0.5*e*e;

	if (!make(&rom, 1, &one, b == 2 ? 0.02*e : 0.005*e*e, b == 2 ? 1.5 : 8.0, Q, b == 2, C, 1))
		return NAN;
	if (ok(!hawser_subharmonic_base(&rom, b, &report) && rom.harmonic->k == b,
	       "1/%d of the load's frequency", b) &&
	    ok(!hawser_modulation_derive(&m, &rom, &resonance, &report), "modulation") &&
	    ok(!hawser_subharmonic_start(&m, x, &omega, 1.0 + shift, 1.0 + 1.01*shift, &report),
	       "a motion at 1/%d: %s", b,
	       report.message)) {
		hawser_modulation_state(&m, state, x, omega);
		options.method = "shooting";
		options.from = omega;
		options.to = 1.1*omega;
		options.max_points = 1;
		options.samples = HAWSER_NONE;
		options.start = state;
		if (ok(!hawser_frf_trace(&frf, &rom, &options, &report), "shooting finds it again"))
			gap = hypot(frf.state[0] - state[0], frf.state[1] - state[1])/hypot(state[0], state[1]);
	}
	hawser_frf_clear(&frf);
	hawser_modulation_clear(&m);
	unmake(&rom);
	return gap;
}

static void refusals(void)
{
	const double k[] = {1.0, 4.0};
	struct hawser_cubic C[] = {{0, 0, 0, 0, 0.1}};
	struct hawser_rom rom;
	struct hawser_primary primary;
	struct hawser_primary_curve curve;
	struct hawser_report report = {.message = ""};
	double gamma;

	if (!make(&rom, 2, k, 0.05, 0.1, NULL, 0, C, 1))
		return;
	ok(hawser_primary_strongest(&rom) == 0, "the load drives the first");
	ok(hawser_primary_derive(&primary, &rom, 2, &report) == HAWSER_ERR_ARGUMENT, "mode 3 of 2: %s",
	   report.message);
	ok(hawser_primary_derive(&primary, &rom, 1, &report) == HAWSER_ERR_ARGUMENT, "no load: %s",
	   report.message);
	ok(hawser_primary_backbone(&curve, &gamma, &rom, 0, -1.0, 5, &report) == HAWSER_ERR_ARGUMENT,
	   "size: %s",
	   report.message);
	ok(hawser_subharmonic_base(&rom, 0, &report) == HAWSER_ERR_ARGUMENT, "base: %s",
	   report.message);
	damping[0] = 0.0;
	ok(hawser_primary_derive(&primary, &rom, 0, &report) == HAWSER_ERR_ARGUMENT, "no damping: %s",
	   report.message);
	hawser_primary_clear(NULL);
	hawser_primary_curve_clear(NULL);
	unmake(&rom);
}

CASE(property_primary)
{
	closed_form(0.0, 0.3);
	closed_form(0.5, 0.05);
	parts();
	backbone(0.0, 0.3);
	backbone(0.4, 0.1);
	for (int b = 2; b <= 3; b++) {
		double coarse = subharmonic(b, 0.2), fine = subharmonic(b, 0.1);

		ok(log2(coarse/fine) > 0.9 && fine < 0.02, "1/%d: state off by %.1e, order %.2f", b, fine,
		   log2(coarse/fine));
	}
	refusals();
	return done_testing();
}

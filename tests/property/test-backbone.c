/* Backbones: Duffing's equation against its elliptic integral, the energy, the invariants of a free
 * motion, ends and failures.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include <gsl/gsl_sf_ellint.h>

#include <hawser/backbone.h>

#include "tests/tap.h"

static int duffing(struct hawser_rom *rom, double cubic)
{
	struct hawser_report report;

	*rom = (struct hawser_rom){.n = 1, .cubics = 1, .length = 1.0, .time = 1.0, .force = 1.0};
	rom->D = calloc(1, sizeof(double));
	rom->K = calloc(1, sizeof(double));
	rom->C = calloc(1, sizeof *rom->C);
	if (!rom->D || !rom->K || !rom->C)
		return 1;
	rom->K[0] = 1.0;
	rom->D[0] = 0.03;
	rom->C[0].value = cubic;
	return hawser_rom_compile(rom, &report) != HAWSER_OK;
}

/* u'' + u + g u^3 = 0 from amplitude a: Omega = pi sqrt(1 + g a^2)/(2 K(k)), k^2 = g a^2/(2 (1 + g
 * a^2)). */
static double exact(double g, double a)
{
	const double pi = 3.14159265358979323846;
	double stiff = 1.0 + g*a*a;

	return pi*sqrt(stiff)/(2.0*gsl_sf_ellint_Kcomp(sqrt(0.5*g*a*a/stiff), GSL_PREC_DOUBLE));
}

static void against_closed_form(void)
{
	struct hawser_backbone_options options = {.mode = 0};
	struct hawser_backbone b;
	struct hawser_report report;
	struct hawser_rom rom;
	double worst = 0.0, energy = 0.0;

	if (!ok(!duffing(&rom, 0.1), "Duffing's equation"))
		return;
	options.size = 3.0;
	options.tolerance = 1e-11;
	if (ok(hawser_backbone_trace(&b, &rom, &options, &report) == HAWSER_OK &&
	               b.end == HAWSER_BACKBONE_SIZE, "up to amplitude 3"))
		for (int p = 0; p < b.points; p++) {
			double a = b.start[p];

			worst = fmax(worst, fabs(b.point[p].omega/exact(0.1, a) - 1.0));
			energy = fmax(energy, fabs(b.point[p].energy/(0.5*a*a + 0.025*a*a*a*a) - 1.0));
			energy = fmax(energy, b.point[p].energy_gap);
		}
	ok(worst < 1e-10, "Omega against the elliptic integral: %.1e", worst);
	ok(energy < 1e-10, "energy, at both ends of the half period: %.1e", energy);
	ok(b.point[b.points - 1].unstable == 0, "stable");
	hawser_backbone_clear(&b);
	hawser_rom_clear(&rom);
}

/* u1'' + u1 = 0 with u1 = cos t, and u2'' + (1 - h + 2 h u1^2) u2 = 0, which is
 * u2'' + (1 + h cos 2t) u2 = 0: by averaging u2 grows by pi h/2 in a period. */
static int coupled(struct hawser_rom *rom, double h)
{
	*rom = (struct hawser_rom){.n = 2, .cubics = 2, .length = 1.0, .time = 1.0, .force = 1.0};
	rom->D = calloc(4, sizeof(double));
	rom->K = calloc(4, sizeof(double));
	rom->C = calloc(2, sizeof *rom->C);
	if (!rom->D || !rom->K || !rom->C)
		return 1;
	rom->K[0] = 1.0;
	rom->K[3] = 1.0 - h;
	rom->C[0] = (struct hawser_cubic){0, 0, 1, 1, 2.0*h};
	rom->C[1] = (struct hawser_cubic){1, 0, 0, 1, 2.0*h};
	return hawser_rom_compile(rom, NULL) != HAWSER_OK;
}

/* Growth counts if it exceeds the error of the multipliers, which depends on the tolerance: two
 * multipliers are 1, and their error is the square root of that of the matrix. */
static void stability(double h, double tolerance, int unstable)
{
	struct hawser_backbone_options options = {.mode = 0};
	struct hawser_backbone b = {.n = 0};
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;
	int got = -1;

	options.size = 1.0;
	options.tolerance = tolerance;
	if (!coupled(&rom, h) && !hawser_backbone_trace(&b, &rom, &options, &report))
		got = b.point[b.points - 1].unstable;
	ok(got == unstable, "growth %.1e a period, tolerance %.0e: %d multipliers outside %s",
	   0.5*3.14159265358979323846*h, tolerance, got, report.message);
	hawser_backbone_clear(&b);
	hawser_rom_clear(&rom);
}

static void refusals(void)
{
	struct hawser_backbone_options options = {.mode = 0};
	struct hawser_backbone b;
	struct hawser_report report = {.message = ""};
	struct hawser_rom rom;

	if (!ok(!duffing(&rom, 0.1), "Duffing's equation"))
		return;
	ok(hawser_backbone_trace(&b, &rom, &options, &report) == HAWSER_ERR_ARGUMENT, "no size: %s",
	   report.message);
	hawser_backbone_clear(&b);
	options.size = 3.0;
	options.mode = 1;
	ok(hawser_backbone_trace(&b, &rom, &options, &report) == HAWSER_ERR_ARGUMENT,
	   "no such mode: %s",
	   report.message);
	hawser_backbone_clear(&b);
	options.mode = 0;
	options.max_points = 5;
	ok(hawser_backbone_trace(&b, &rom, &options, &report) == HAWSER_OK &&
	           b.end == HAWSER_BACKBONE_MAX_POINTS && b.points == 5, "five points");
	hawser_backbone_clear(&b);
	options.max_points = 2000;
	options.hi = 1.001;
	ok(hawser_backbone_trace(&b, &rom, &options, &report) == HAWSER_OK &&
	           b.end == HAWSER_BACKBONE_RANGE, "a range that ends before");
	hawser_backbone_clear(&b);
	hawser_backbone_clear(NULL);
	hawser_rom_clear(&rom);
}

CASE(property_backbone)
{
	against_closed_form();
	stability(1e-2, 1e-9, 1);
	stability(5e-6, 1e-12, 1);
	refusals();
	return done_testing();
}

/* The response to a strong load of what a model of a rope over sheaves does not keep: the motion of the
 * model under a slow wave of load against the exact statics of a rope with a mass at many points, and
 * the same without the terms in which that response is a field of the energy.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include <hawser/line_rom.h>

#include "tests/line-force.h"
#include "tests/tap.h"

enum { SPANS = 3, PHASES = 16, PARTS = 64, KEPT = 6 };
static const double spacing = 71.0, smeared = 8.0; /* m; kg/m of the rope's 18 in the masses */

static struct hawser_report report;

/* Equilibrium of the model at the phase tau. */
static int settle(double *u, const struct hawser_rom *rom, double tau)
{
	double R[KEPT], T[KEPT*KEPT], moved = INFINITY;
	int pivot[KEPT];

	for (int i = 0; i < 40 && moved > 1e-12; i++) {
		force_of(R, T, rom, u, tau);
		if (LAPACKE_dgesv(LAPACK_ROW_MAJOR, rom->n, 1, T, rom->n, pivot, R, 1))
			return 0;
		moved = 0.0;
		for (int j = 0; j < rom->n; j++) {
			u[j] -= R[j];
			moved = fmax(moved, fabs(R[j]));
		}
	}
	return moved <= 1e-12;
}

/* y at the middle of every span less that at rest, m, exactly: masses whose weights follow the wave. */
static int exactly(double y[SPANS], const struct hawser_line *line, const struct hawser_rom *rom,
                   double length0, double amplitude, double tau)
{
	struct hawser_line other = *line;
	struct hawser_line_mass mass[512];
	struct hawser_line_statics st;
	double each = spacing/PARTS;

	other.given = HAWSER_LINE_LENGTH0;
	other.value = length0;
	other.rho -= smeared;
	other.mass = mass;
	other.masses = 0;
	for (double S = 0.37*each; S < length0; S += each)
		mass[other.masses++] = (struct hawser_line_mass){.S = S,
			.mass = each*(smeared + amplitude/line->g*cos(2.0*M_PI*S/spacing - tau))};
	if (hawser_line_solve(&st, &other, &report))
		return ok(0, "statics: %s", report.message);
	for (int p = 0; p < SPANS; p++) {
		double xy[2];

		hawser_line_at(&st, xy, NULL, NULL, NULL, NULL, rom->shapes.s[p]*rom->length);
		y[p] = xy[1];
	}
	hawser_line_statics_clear(&st);
	return 1;
}

/* Largest difference of y over a period, relative to the largest y, of a model without fields (terms 0)
 * and with them. */
static int compare(double worst[2], const struct hawser_line *line,
                   const struct hawser_line_statics *st, int kept, double weight)
{
	const struct hawser_line_statics *lane[1] = {st};
	const struct hawser_line_rom_options o = {.load = HAWSER_LINE_LOAD_PASSING, .weight = {weight},
	                                          .spacing = spacing, .harmonics = 1, .modes.n = kept,
	                                          .condensed = 1};
	double rest[SPANS], u[2][KEPT] = {{0.0}}, most = 0.0;
	struct hawser_line_modes modes;
	struct hawser_rom_ends *ends;
	struct hawser_rom rom;
	int good, all;

	worst[0] = worst[1] = 0.0;
	if (!ok(!hawser_line_rom_build(&rom, &modes, lane, 1, &o, &report), "a model: %s", report.message))
		return 0;
	all = rom.harmonics;
	ends = rom.ends;
	good = all > 2 && ends && exactly(rest, line, &rom, st->length0, 0.0, 0.0);
	for (int i = 0; i < PHASES && good; i++) {
		const struct hawser_rom_moment moment = {.tau = 2.0*M_PI*i/PHASES, .omega = 1e-4};
		double y[SPANS], xyz[3];

		good = exactly(y, line, &rom, st->length0, 2.0*weight/spacing, moment.tau);
		for (int terms = 0; terms < 2; terms++) {
			rom.harmonics = terms ? all : 2;
			rom.ends = terms ? ends : NULL;
			good = good && settle(u[terms], &rom, moment.tau);
			for (int p = 0; p < SPANS; p++) {
				hawser_rom_displacement_at(&rom, xyz, p, u[terms], &moment);
				worst[terms] = fmax(worst[terms], fabs(xyz[1]*rom.length - y[p] + rest[p]));
				most = fmax(most, fabs(y[p] - rest[p]));
			}
		}
	}
	worst[0] /= most;
	worst[1] /= most;
	hawser_rom_clear(&rom);
	hawser_line_modes_clear(&modes);
	return good;
}

/* The difference of a model of second order falls with the square of the load, that without its fields
 * with the load. */
CASE(property_line_loaded)
{
	struct hawser_line_sheave sheave[2] = {{.centre = {80.0, 5.0}, .radius = 12.0, .side = 1},
	                                       {.centre = {190.0, 28.0}, .radius = 12.0, .side = 1}};
	struct hawser_line line = {.EA = 40e6, .rho = 18.0, .g = 9.81, .B = {300.0, 58.0},
	                           .given = HAWSER_LINE_T_A, .value = 84e3, .sheave = sheave, .sheaves = 2};
	struct hawser_line_statics st;
	double few[2], strong[2], half[2];
	int good;

	if (!ok(!hawser_line_solve(&st, &line, &report), "statics: %s", report.message))
		return done_testing();
	good = compare(few, &line, &st, 3, 2560.0) && compare(strong, &line, &st, KEPT, 2560.0) &&
	       compare(half, &line, &st, KEPT, 1280.0);
	ok(good && few[1] < 5e-3 && few[0] > 0.04,
	   "3 modes under weights of 2560 N: y to %.1e of the exact statics, without fields %.1e", few[1],
	   few[0]);
	ok(good && strong[1] < 0.15*strong[0], "%d modes: to %.1e, without fields %.1e", KEPT,
	   strong[1], strong[0]);
	ok(good && half[1] < 0.3*strong[1] && half[0] > 0.4*strong[0],
	   "half of these weights: to %.1e and %.1e", half[1], half[0]);
	hawser_line_statics_clear(&st);
	return done_testing();
}

/* The model of two lanes that a carriage and a bullwheel join: two lanes alike under the same load move
 * as one with half the carriage, by the whole force of the model at finite motions; and two lanes that
 * nothing joins, of different weights, have the modes, tensors and loads of each alone.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include <hawser/line_rom.h>

#include "tests/line-force.h"
#include "tests/tap.h"

enum { ONE = 4, TWO = 12 }; /* modes; most coordinates */

static struct hawser_report report;
static struct hawser_line_sheave sheave[2] = {{.centre = {80.0, 5.0}, .radius = 12.0, .side = 1},
                                              {.centre = {190.0, 28.0}, .radius = 12.0, .side = 1}};
static const struct hawser_line line = {.EA = 40e6, .rho = 4.0, .g = 25.0, .B = {300.0, 58.0},
                                        .given = HAWSER_LINE_T_A, .value = 84e3, .sheave = sheave,
                                        .sheaves = 2};

struct model {
	struct hawser_rom rom;
	struct hawser_line_modes modes;
};

static void clear(struct model *m)
{
	hawser_rom_clear(&m->rom);
	hawser_line_modes_clear(&m->modes);
}

static double omega(const struct model *m, int j)
{
	return m->modes.mode[j].omega/m->modes.time_unit;
}

/* kept[ONE]: the modes of two lanes that have the frequencies of one; 0: not all are there. */
static int matching(int *kept, const struct model *two, const struct model *one)
{
	int count = 0;

	for (int j = 0; j < two->modes.n && count < ONE; j++)
		if (fabs(omega(two, j)/omega(one, count) - 1.0) < 1e-9)
			kept[count++] = j;
	return count == ONE;
}

/* Forces of both at the same motion: those of two lanes are larger by sqrt(2), and so are the
 * coordinates. */
static double difference(const struct model *two, const struct model *one)
{
	double R[2][TWO], T[TWO*TWO], u[2][TWO] = {{0.0}}, worst = 0.0, most = 0.0;

	for (int i = 0; i < 8 && two->rom.n == one->rom.n && one->rom.n <= TWO; i++) {
		double tau = 0.7 + 0.9*i;

		for (int j = 0; j < ONE; j++) {
			int at = 3*(j*two->rom.shapes.points + 1); /* P, Q, B in the middle of the second span */
			double own = two->rom.shapes.shape[at + 1], other;

			other = one->rom.shapes.shape[3*(j*one->rom.shapes.points + 1) + 1];
			u[1][j] = 0.004*cos(1.0 + i + 2.0*j);
			u[0][j] = u[1][j]*sqrt(2.0)*(own*other < 0.0 ? -1.0 : 1.0);
		}
		force_of(R[0], T, &two->rom, u[0], tau);
		force_of(R[1], T, &one->rom, u[1], tau);
		for (int j = 0; j < ONE; j++) {
			double sign = u[0][j]*u[1][j] < 0.0 ? -sqrt(2.0) : sqrt(2.0);

			worst = fmax(worst, fabs(R[0][j] - sign*R[1][j]));
			most = fmax(most, fabs(R[0][j]));
		}
	}
	return most > 0.0 ? worst/most : INFINITY;
}

static void alike(struct hawser_line_rom_options o, const char *what)
{
	const struct hawser_line_freedom half = {.name = "carriage", .mass = 3e3, .end = {{{1.0}}}};
	const struct hawser_line_freedom both[2] = {
		{.name = "carriage", .mass = 6e3, .end = {{{1.0}}, {{1.0}}}},
		{.name = "bullwheel", .mass = 40.0, .end = {{{1.0, 0.2}}, {{-1.0, -0.2}}}}};
	struct hawser_line_statics st;
	const struct hawser_line_statics *lane[2] = {&st, &st};
	struct model one, two;
	int kept[ONE], good;

	if (!ok(!hawser_line_solve(&st, &line, &report), "statics: %s", report.message))
		return;
	o.modes.n = 2*ONE;
	o.modes.freedom = &half;
	o.modes.freedoms = 1;
	good = ok(!hawser_line_rom_build(&one.rom, &one.modes, lane, 1, &o, &report), "one lane, %s: %s",
	          what, report.message);
	o.kept = kept;
	o.count = 0;
	for (int j = 0; j < one.modes.n && o.count < ONE; j++)
		if (one.modes.mode[j].plane == HAWSER_IN_PLANE)
			kept[o.count++] = j;
	clear(&one);
	good = good && ok(o.count == ONE && !hawser_line_rom_build(&one.rom, &one.modes, lane, 1, &o,
	                  &report), "modes in the plane, %s: %s", what, report.message);
	for (int i = 1; i >= 0; i--) {
		o.weight[i] = o.weight[0];
		o.amplitude[i] = o.amplitude[0];
		o.running[i] = o.running[0];
	}
	o.kept = NULL;
	o.modes.n = 4*ONE;
	o.modes.freedom = both;
	o.modes.freedoms = 2;
	good = good && ok(!hawser_line_rom_build(&two.rom, &two.modes, lane, 2, &o, &report),
	                  "two lanes, %s: %s", what, report.message);
	if (good && ok(matching(kept, &two, &one), "two lanes, %s: frequencies of one", what)) {
		clear(&two);
		o.kept = kept;
		o.count = ONE;
		good = !hawser_line_rom_build(&two.rom, &two.modes, lane, 2, &o, &report);
		if (ok(good, "two lanes, %s: %s", what, report.message))
			ok(difference(&two, &one) < 1e-8, "two lanes alike, %s: forces of one to %.1e, with %d "
			   "second-order shapes", what, difference(&two, &one), one.rom.inertia.shapes);
	}
	clear(&two);
	clear(&one);
	hawser_line_statics_clear(&st);
}

/* Largest differences of f of the first waves, by the time that the weights are behind, and of Q and C
 * of the modes kept[ONE] of both lanes, which are those of lane 1 alone. */
static void compare(const struct model *both, const struct model *one, double behind)
{
	const struct hawser_rom *a = &both->rom, *b = &one->rom;
	double unit = pow(a->time/b->time, 2), f = 0.0, all = 0.0, Q = 0.0, C = 0.0;

	for (int h = 0; h < 6; h += 2)
		for (int j = 0; j < ONE; j++) {
			double phase = b->harmonic[h].k*behind, sine = b->harmonic[h + 1].f[j];
			double cosine = b->harmonic[h].f[j], own = hypot(cosine, sine)*unit;

			f = fmax(f, fabs(fabs(a->harmonic[h].f[j]) -
			                 fabs(cosine*cos(phase) - sine*sin(phase))*unit));
			f = fmax(f, fabs(fabs(a->harmonic[h + 1].f[j]) -
			                 fabs(cosine*sin(phase) + sine*cos(phase))*unit));
			all = fmax(all, own);
		}
	ok(f < 1e-9*all, "lanes apart: loads of each alone to %.1e", f/all);
	for (int i = 0; i < b->quads && a->quads == b->quads; i++)
		Q = fmax(Q, fabs(fabs(a->Q[i].value) - fabs(b->Q[i].value)*unit)/unit/fabs(b->Q[0].value));
	for (int i = 0; i < b->cubics && a->cubics == b->cubics; i++)
		C = fmax(C, fabs(fabs(a->C[i].value) - fabs(b->C[i].value)*unit)/unit/fabs(b->C[0].value));
	ok(a->quads == b->quads && Q < 1e-9 && a->cubics == b->cubics && C < 1e-8,
	   "lanes apart: Q and C of each alone to %.1e and %.1e", Q, C);
}

static void apart(void)
{
	struct hawser_line light = line;
	struct hawser_line_statics st[2];
	const struct hawser_line_statics *lane[2] = {&st[0], &st[1]}, *second[1] = {&st[1]};
	struct hawser_line_rom_options o = {.modes = {.n = ONE, .backward = {1}}, .condensed = 1,
		.load = HAWSER_LINE_LOAD_PASSING, .weight = {2400.0}, .spacing = 36.6};
	struct model one, both;
	int kept[ONE];

	light.g = 17.0;
	light.value = 70e3;
	if (!ok(!hawser_line_solve(&st[0], &line, &report) && !hawser_line_solve(&st[1], &light, &report),
	        "statics: %s", report.message))
		return;
	if (!ok(!hawser_line_rom_build(&one.rom, &one.modes, second, 1, &o, &report), "the second lane: %s",
	        report.message))
		return;
	o = (struct hawser_line_rom_options){.modes = {.n = 3*ONE, .backward = {0, 1}}, .condensed = 1,
		.load = HAWSER_LINE_LOAD_PASSING,
		.weight = {3900.0, 2400.0}, .first = {0.0, 11.0}, .spacing = o.spacing};
	if (ok(!hawser_line_rom_build(&both.rom, &both.modes, lane, 2, &o, &report) &&
	       matching(kept, &both, &one), "both lanes: %s", report.message)) {
		clear(&both);
		o.kept = kept;
		o.count = ONE;
		if (ok(!hawser_line_rom_build(&both.rom, &both.modes, lane, 2, &o, &report), "lane 2 of both: "
		       "%s", report.message))
			compare(&both, &one, 2.0*M_PI*11.0/o.spacing);
	}
	clear(&both);
	clear(&one);
	hawser_line_statics_clear(&st[0]);
	hawser_line_statics_clear(&st[1]);
}

CASE(property_line_lanes)
{
	alike((struct hawser_line_rom_options){.load = HAWSER_LINE_LOAD_PASSING, .weight = {3900.0},
	      .spacing = 36.6, .running = {14.0}, .ratio = 0.01}, "weights");
	alike((struct hawser_line_rom_options){.load = HAWSER_LINE_LOAD_DRIVE, .amplitude = {0.01},
	      .end = 1, .running = {14.0}, .speed = 4.0, .ratio = 0.01}, "drive");
	apart();
	return done_testing();
}

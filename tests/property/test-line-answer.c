/* What the modes that a model of a rope over sheaves does not keep do under its load: slow loads
 * against the exact statics of a rope whose end is moved, and of one on which weights stand at many
 * phases; fast ones against models that keep more modes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <complex.h>
#include <stdlib.h>

#include <hawser/line_rom.h>

#include "rom/condense/answer.h"
#include "tests/tap.h"

enum { SPANS = 3, PHASES = 256, WAVES = 3 };

/* A model of the line, or 0. */
static int build(struct hawser_rom *rom, struct hawser_line_modes *modes,
                 const struct hawser_line_statics *st, struct hawser_line_rom_options o, int n)
{
	const struct hawser_line_statics *lane[1] = {st};
	struct hawser_report report = {0};

	o.modes.n = n;
	return ok(!hawser_line_rom_build(rom, modes, lane, 1, &o, &report), "a model of %d modes: %s", n,
	          report.message);
}

/* Linear response at the phase tau: displacement along x and y of the middle of every span, m, and the
 * change of tension there, N. */
static void respond(double out[SPANS][3], const struct hawser_rom *rom, double omega, double tau)
{
	const struct hawser_rom_moment moment = {.tau = tau, .omega = omega};
	double u[HAWSER_LINE_ROM_MODES] = {0.0};

	for (int h = 0; h < rom->harmonics; h++) {
		const struct hawser_harmonic *one = &rom->harmonic[h];
		double W = one->k*omega;

		for (int j = 0; j < rom->n; j++)
			u[j] += creal(one->f[j]*cexp(I*one->k*tau)*(one->phase == HAWSER_SIN ? -I : 1.0)/
			              (rom->K[j*(rom->n + 1)] - W*W + I*W*rom->D[j*(rom->n + 1)]));
	}
	for (int p = 0; p < SPANS; p++) {
		double xyz[3];

		hawser_rom_displacement_at(rom, xyz, p, u, &moment);
		out[p][0] = xyz[0]*rom->length;
		out[p][1] = xyz[1]*rom->length;
		out[p][2] = hawser_rom_tension_at(rom, p, u, &moment);
	}
}

/* The same of the exact statics of a changed line, as they are. */
static int stand(double out[SPANS][3], const struct hawser_line *line, const struct hawser_rom *rom)
{
	struct hawser_line_statics st;
	struct hawser_report report = {0};

	if (hawser_line_solve(&st, line, &report))
		return ok(0, "statics: %s", report.message);
	for (int p = 0; p < SPANS; p++)
		hawser_line_at(&st, out[p], NULL, &out[p][2], NULL, NULL, rom->shapes.s[p]*rom->length);
	hawser_line_statics_clear(&st);
	return 1;
}

/* Largest difference relative to the largest value of the same kind (displacement, tension). */
static void compare(double worst[2], const double *own, const double *want, int count)
{
	double most[2] = {0.0};

	worst[0] = worst[1] = 0.0;
	for (int i = 0; i < count; i++) {
		most[i%3 == 2] = fmax(most[i%3 == 2], fabs(want[i]));
		worst[i%3 == 2] = fmax(worst[i%3 == 2], fabs(own[i] - want[i]));
	}
	worst[0] /= most[0];
	worst[1] /= most[1];
}

static void moved_end(const struct hawser_line *line, const struct hawser_line_statics *st)
{
	const double r = 1e-5;
	const struct hawser_line_rom_options o = {.load = HAWSER_LINE_LOAD_DRIVE, .end = 1,
	                                          .amplitude = {r}};
	double side[2][SPANS][3], own[SPANS][3], rest[SPANS][3], want[SPANS][3], worst[2];
	struct hawser_line_modes modes;
	struct hawser_rom rom;
	int good = 1;

	if (!build(&rom, &modes, st, o, 4))
		return;
	for (int i = 0; i < 2; i++) {
		struct hawser_line other = *line;

		other.given = HAWSER_LINE_LENGTH0;
		other.value = st->length0;
		other.B[0] += (i ? -r : r)*cos(st->angle_B);
		other.B[1] += (i ? -r : r)*sin(st->angle_B);
		good = good && stand(side[i], &other, &rom);
	}
	respond(own, &rom, 1e-4, 0.0);
	respond(rest, &rom, 1e-4, 0.5*M_PI);
	for (int i = 0; i < 3*SPANS; i++) {
		(&own[0][0])[i] -= (&rest[0][0])[i];
		(&want[0][0])[i] = 0.5*((&side[0][0][0])[i] - (&side[1][0][0])[i]);
	}
	compare(worst, &own[0][0], &want[0][0], 3*SPANS);
	ok(good && worst[0] < 1e-5, "an end that moves: displacements of the exact statics to %.1e",
	   worst[0]);
	ok(good && worst[1] < 1e-4, "  their tensions to %.1e", worst[1]);
	hawser_rom_clear(&rom);
	hawser_line_modes_clear(&modes);
}

/* Coefficients of the cosines and sines 1 to WAVES of a signal at PHASES phases. */
static void analyse(double *out, double (*signal)[SPANS][3])
{
	for (int i = 0; i < 3*SPANS; i++)
		for (int k = 0; k < WAVES; k++) {
			double c = 0.0, s = 0.0;

			for (int phase = 0; phase < PHASES; phase++) {
				double tau = 2.0*M_PI*phase/PHASES, value = (&signal[phase][0][0])[i];

				c += 2.0/PHASES*value*cos((k + 1)*tau);
				s += 2.0/PHASES*value*sin((k + 1)*tau);
			}
			out[(2*k*SPANS + i/3)*3 + i%3] = c;
			out[((2*k + 1)*SPANS + i/3)*3 + i%3] = s;
		}
}

/* Weights of 1 N, whose response is nearly linear. */
static void standing_weights(const struct hawser_line *line, const struct hawser_line_statics *st,
                             double spacing)
{
	static double own[PHASES][SPANS][3], want[PHASES][SPANS][3];
	const struct hawser_line_rom_options o = {.load = HAWSER_LINE_LOAD_PASSING, .weight = {1.0},
	                                          .spacing = spacing};
	double wave[2][2*WAVES*SPANS*3] = {{0.0}}, worst[2];
	struct hawser_line_mass mass[32];
	struct hawser_line other = *line;
	struct hawser_line_modes modes;
	struct hawser_rom rom;
	int good = 1;

	if (!build(&rom, &modes, st, o, 4))
		return;
	other.given = HAWSER_LINE_LENGTH0;
	other.value = st->length0;
	other.mass = mass;
	for (int i = 0; i < PHASES && good; i++) {
		other.masses = 0;
		for (double S = spacing*(i + 0.5)/PHASES; S < st->length0; S += spacing)
			mass[other.masses++] = (struct hawser_line_mass){.S = S, .mass = o.weight[0]/line->g};
		good = stand(want[i], &other, &rom);
		/* no weight stands on a break point: the phases are shifted by half a step */
		if (good)
			respond(own[i], &rom, 1e-4, 2.0*M_PI*(i + 0.5)/PHASES);
	}
	analyse(wave[0], own);
	analyse(wave[1], want);
	compare(worst, wave[0], wave[1], 2*WAVES*SPANS*3);
	ok(good && worst[0] < 1e-3, "weights at %g m: harmonics of displacements to %.1e of the exact "
	   "statics", spacing, worst[0]);
	/* tensions jump where a weight passes, so that 3/253 of the jump appears in the third harmonic */
	ok(good && worst[1] < 5e-3, "  of tensions to %.1e", worst[1]);
	hawser_rom_clear(&rom);
	hawser_line_modes_clear(&modes);
}

/* The answers at one frequency are those of the model, to round-off. */
static void frozen_answers(const struct hawser_rom *rom, double omega, const char *what)
{
	const double u[HAWSER_LINE_ROM_MODES] = {0.0};
	struct hawser__frozen frozen = {.room = 0};
	const struct hawser_rom *one = NULL;
	double worst = 0.0, most = 0.0;

	for (int pass = 0; pass < 2; pass++) /* the second one has the room of the first */
		one = hawser__rom_freeze(&frozen, rom, (1 + pass)*omega);
	for (int i = 0; one && i < 5*SPANS; i++) {
		const struct hawser_rom_moment moment = {.tau = 0.3 + 1.1*i, .omega = 2.0*omega};
		double a[5], b[5];

		hawser_rom_displacement_at(rom, a, i%SPANS, u, &moment);
		hawser_rom_displacement_at(one, b, i%SPANS, u, &moment);
		(void)hawser_rom_tensions_at(rom, &a[3], &a[4], u, &moment);
		(void)hawser_rom_tensions_at(one, &b[3], &b[4], u, &moment);
		for (int k = 0; k < 5; k++) {
			worst = fmax(worst, fabs(a[k] - b[k])/(k < 3 ? 1.0 : rom->force));
			most = fmax(most, k < 3 ? fabs(a[k]) : 0.0);
		}
	}
	ok(one && one != rom && worst < 1e-13 && most > 1e3*worst, "%s at one frequency: to %.1e of %.1e",
	   what, worst, most);
	hawser__rom_frozen_release(&frozen);
}

/* At frequencies up to far above the modes of the smaller model. */
static void more_modes(const struct hawser_line_statics *st, struct hawser_line_rom_options o,
                       const char *what)
{
	enum { SHARES = 4 };
	static const double share[SHARES] = {0.2, 0.9, 1.7, 2.6};
	double worst = 0.0, lowest;
	struct hawser_line_modes modes[2];
	struct hawser_rom rom[2];
	int good;

	if (!build(&rom[0], &modes[0], st, o, 3) || !build(&rom[1], &modes[1], st, o, 20))
		return;
	lowest = sqrt(rom[0].K[0]);
	good = rom[0].known.reach > 8.0*lowest && rom[0].known.modes > 10;
	for (int i = 0; i < SHARES; i++)
		for (int phase = 0; phase < 4; phase++) {
			double out[2][SPANS][3], off[2];

			for (int k = 0; k < 2; k++)
				respond(out[k], &rom[k], share[i]*lowest, 0.7 + 1.6*phase);
			compare(off, &out[0][0][0], &out[1][0][0], 3*SPANS);
			worst = fmax(worst, off[0]);
		}
	ok(good && worst < 1e-4, "%s: 3 modes and what follows are 20 modes to %.1e; known up to %.3g "
	   "times the lowest", what, worst, rom[0].known.reach/lowest);
	frozen_answers(&rom[0], 0.9*lowest, what);
	for (int k = 0; k < 2; k++) {
		hawser_rom_clear(&rom[k]);
		hawser_line_modes_clear(&modes[k]);
	}
}

CASE(property_line_answer)
{
	struct hawser_line_sheave sheave[2] = {{.centre = {80.0, 5.0}, .radius = 12.0, .side = 1},
	                                       {.centre = {190.0, 28.0}, .radius = 12.0, .side = 1}};
	struct hawser_line line = {.EA = 40e6, .rho = 10.0, .g = 9.81, .B = {300.0, 58.0},
	                           .given = HAWSER_LINE_T_A, .value = 84e3, .sheave = sheave, .sheaves = 2};
	struct hawser_line_statics st;
	struct hawser_report report = {0};

	if (!ok(!hawser_line_solve(&st, &line, &report), "statics: %s", report.message))
		return done_testing();
	moved_end(&line, &st);
	standing_weights(&line, &st, 36.6);
	standing_weights(&line, &st, 71.0);
	more_modes(&st, (struct hawser_line_rom_options){.load = HAWSER_LINE_LOAD_DRIVE, .end = 1,
	           .amplitude = {1e-5}}, "an end that moves");
	more_modes(&st, (struct hawser_line_rom_options){.load = HAWSER_LINE_LOAD_PASSING, .weight = {1.0},
	           .spacing = 36.6}, "weights that pass");
	hawser_line_statics_clear(&st);
	return done_testing();
}

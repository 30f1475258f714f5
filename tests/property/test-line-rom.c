/* Reduced models of a rope over sheaves: without sheaves against those of spans, which share no
 * code of the expansion; stiffness and forces by a moved end against statics and modes of the line
 * whose end is there; loads that pass against a sum over weights; energy; response against
 * integration.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>

#include <hawser/frf.h>
#include <hawser/integrate.h>
#include <hawser/line_rom.h>
#include <hawser/scene.h>

#include "tests/rom-entries.h"
#include "tests/tap.h"

/* --- one span --- */

static void one_span(double EA, double h, double T, const char *what)
{
	const struct hawser_line line = {.EA = EA, .rho = 6.0, .g = 9.81, .B = {250.0, h},
	                                 .given = HAWSER_LINE_T_A, .value = T};
	const struct hawser_span span = {.EA = EA, .rho = 6.0, .g = 9.81, .d = 250.0, .h = h};
	const struct hawser_line_rom_options o = {.modes = {.n = 6, .tolerance = 1e-10}};
	const struct hawser_modes_options choice = {.n = 6, .tolerance = 1e-11};
	struct hawser_scene scene = {.model = {.condense = HAWSER_CONDENSE_STATIC}};
	struct hawser_line_statics st;
	const struct hawser_line_statics *lane[1] = {&st};
	struct hawser_statics statics;
	struct hawser_line_modes line_modes;
	struct hawser_modes modes;
	struct hawser_rom own, reference;
	struct hawser_report report = {0};
	double worst[4] = {0.0}, most[4] = {1e-300, 1e-300, 1e-300, 1e-300};

	if (hawser_line_solve(&st, &line, &report) ||
	    hawser_line_rom_build(&own, &line_modes, lane, 1, &o, &report) ||
	    hawser_statics_solve(&statics, &span, HAWSER_GIVEN_T0, T, HAWSER_BRANCH_TAUT, &report) ||
	    hawser_modes_solve(&modes, &statics, &choice, &report) ||
	    hawser_rom_build(&reference, &modes, &scene, &report)) {
		ok(0, "%s: %s", what, report.message);
		return;
	}
	for (int i = 0; i < own.n*own.n; i++) {
		most[0] = fmax(most[0], fabs(reference.K[i]));
		worst[0] = fmax(worst[0], fabs(own.K[i] - reference.K[i]));
	}
	for (int j = 0; j < own.n; j++)
		for (int k = 0; k < own.n; k++)
			for (int l = k; l < own.n; l++) {
				double want = quad_of(&reference, j, k, l);

				most[1] = fmax(most[1], fabs(want));
				worst[1] = fmax(worst[1], fabs(quad_of(&own, j, k, l) - want));
			}
	for (int i = 0; i < own.cubics; i++) {
		const struct hawser_cubic *c = &own.C[i];
		double want = cubic_of(&reference, c->j, c->k, c->l, c->m);

		most[2] = fmax(most[2], fabs(want));
		worst[2] = fmax(worst[2], fabs(own.C[i].value - want));
	}
	for (int i = 0; i < 3*own.n*(own.n + 1)/2; i++) { /* mid-span: the only shape point here */
		double want = reference.shapes.second_shape[3*(i/3*reference.shapes.points + 1) + i%3];

		most[3] = fmax(most[3], fabs(want));
		worst[3] = fmax(worst[3], fabs(own.shapes.second_shape[i] - want));
	}
	ok(worst[0] <= 1e-10*most[0] && worst[1] <= 1e-8*most[1] && worst[2] <= 1e-8*most[2] &&
	   own.cubics > 20,
	   "%s: K to %.1e, Q to %.1e, C to %.1e of a span", what, worst[0]/most[0], worst[1]/most[1],
	   worst[2]/most[2]);
	ok(worst[3] <= 1e-7*most[3], "%s: what follows at mid-span to %.1e", what, worst[3]/most[3]);
	hawser_rom_clear(&own);
	hawser_rom_clear(&reference);
	hawser_modes_clear(&modes);
	hawser_line_modes_clear(&line_modes);
	hawser_line_statics_clear(&st);
}

/* --- an end that moves --- */

/* Frequencies squared (1/s^2) of the line whose end B is moved by r along the rope. */
static int moved(double omega2[], double reach[], const struct hawser_line *line,
                 const struct hawser_line_statics *at, const struct hawser_line_modes *base, int n,
                 double r)
{
	const struct hawser_line_modes_options o = {.n = n, .tolerance = 1e-11};
	struct hawser_line own = *line;
	struct hawser_line_statics st;
	const struct hawser_line_statics *lane[1] = {&st};
	struct hawser_line_modes modes;
	struct hawser_report report = {0};

	own.given = HAWSER_LINE_LENGTH0;
	own.value = at->length0;
	own.B[0] += r*cos(at->angle_B);
	own.B[1] += r*sin(at->angle_B);
	if (hawser_line_solve(&st, &own, &report) || hawser_line_modes_solve(&modes, lane, 1, &o, &report))
		return ok(0, "moved end: %s", report.message);
	for (int j = 0; j < n; j++) {
		double sum = 0.0;

		omega2[j] = pow(modes.mode[j].omega/modes.time_unit, 2.0);
		for (int p = 0; p < base->points; p++) { /* mass times displacement times shape */
			const double *u = base->shape + 3*(j*base->points + p);
			const struct hawser_line_modes_point *point = &base->point[p];
			double x[2], c = cos(point->angle), s = sin(point->angle);

			hawser_line_at(&st, x, NULL, NULL, NULL, NULL, point->S);
			sum += base->weight[p]*((x[0] - point->x[0])*(c*u[0] - s*u[1]) +
			                        (x[1] - point->x[1])*(s*u[0] + c*u[1]));
		}
		reach[j] = sum/base->length_unit;
	}
	hawser_line_modes_clear(&modes);
	hawser_line_statics_clear(&st);
	return 1;
}

static void moving_end(const struct hawser_line *line, const char *what)
{
	enum { N = 8 };
	const double amplitude = 0.01, r = 0.02;
	struct hawser_line_rom_options o = {.modes = {.n = N, .tolerance = 1e-10},
		.load = HAWSER_LINE_LOAD_DRIVE, .end = 1, .amplitude = {amplitude}, .condensed = 1};
	struct hawser_line_statics st;
	const struct hawser_line_statics *lane[1] = {&st};
	struct hawser_line_modes modes;
	struct hawser_rom rom;
	struct hawser_report report = {0};
	double up[2][N], down[2][N], far_up[2][N], far_down[2][N], worst[2] = {0.0}, most[2] = {0.0};

	if (hawser_line_solve(&st, line, &report) ||
	    hawser_line_rom_build(&rom, &modes, lane, 1, &o, &report)) {
		ok(0, "%s: %s", what, report.message);
		return;
	}
	if (!moved(up[0], up[1], line, &st, &modes, N, r) ||
	    !moved(down[0], down[1], line, &st, &modes, N, -r) ||
	    !moved(far_up[0], far_up[1], line, &st, &modes, N, 2*r) ||
	    !moved(far_down[0], far_down[1], line, &st, &modes, N, -2*r))
		return;
	for (int j = 0; j < N; j++) {
		double slope[2], own[2], unit = amplitude;

		for (int i = 0; i < 2; i++)
			slope[i] = (8.0*(up[i][j] - down[i][j]) - (far_up[i][j] - far_down[i][j]))/(12.0*r);
		own[0] = rom.harmonic[0].K[j*N + j];
		for (int s = 0; s < N; s++) {
			int k = j < s ? j : s, l = j < s ? s : j;

			own[0] += quad_of(&rom, j, k, l)*(j == s ? 2.0 : 1.0)*rom.harmonic[0].f[s]/rom.K[s*(N + 1)];
		}
		own[0] /= unit*rom.time*rom.time;
		own[1] = rom.harmonic[0].f[j]/rom.K[j*(N + 1)]/unit;
		printf("# %s %d %s: d(omega^2)/dr %.9g %.9g, reach %.9g %.9g\n", what, j + 1,
		       hawser_plane_name(modes.mode[j].plane), own[0], slope[0], own[1], slope[1]);
		for (int i = 0; i < 2; i++) {
			most[i] = fmax(most[i], fabs(slope[i]));
			worst[i] = fmax(worst[i], fabs(own[i] - slope[i]));
		}
	}
	ok(worst[0] <= 1e-6*most[0], "%s: change of frequencies by the end, exact modes, to %.1e", what,
	   worst[0]/most[0]);
	ok(worst[1] <= 1e-6*most[1], "%s: displacement by the end, exact statics, to %.1e", what,
	   worst[1]/most[1]);
	hawser_rom_clear(&rom);
	hawser_line_modes_clear(&modes);
	hawser_line_statics_clear(&st);
}

/* --- loads that pass, and motions --- */

/* Fourier coefficients of the force of weights that pass, from their sum at many phases. */
static void passing(const struct hawser_rom *rom, const struct hawser_line_modes *modes, double weight,
                    double spacing)
{
	enum { PHASES = 2048 };
	double worst = 0.0, most = 0.0, length = modes->lane[0]->length0;

	for (int j = 0; j < 4; j++) {
		double sum[6] = {0.0};

		for (int i = 0; i < PHASES; i++) {
			double force = 0.0, phase = 2.0*M_PI*i/PHASES;

			for (double S = spacing*i/PHASES; S < length; S += spacing) {
				double u[3], angle;

				hawser_line_modes_at(u, NULL, modes, j, 0, S/modes->length_unit);
				hawser_line_at(modes->lane[0], NULL, &angle, NULL, NULL, NULL, S);
				force -= weight/modes->force_unit*(u[0]*sin(angle) + u[1]*cos(angle));
			}
			for (int k = 0; k < 3; k++) {
				sum[2*k] += 2.0/PHASES*force*cos((k + 1)*phase);
				sum[2*k + 1] += 2.0/PHASES*force*sin((k + 1)*phase);
			}
		}
		for (int i = 0; i < 6; i++) {
			most = fmax(most, fabs(sum[i]));
			worst = fmax(worst, fabs(sum[i] - rom->harmonic[i].f[j]));
		}
	}
	ok(rom->harmonics >= 6 && most > 0.0 && worst <= 1e-6*most,
	   "weights that pass: harmonics of their sum to %.1e", worst/most);
}

static void conserves(const struct hawser_line_statics *const *lane)
{
	const struct hawser_line_rom_options model = {.modes = {.n = 6}};
	struct hawser_line_modes modes;
	struct hawser_rom rom;
	struct hawser_trajectory run;
	struct hawser_report report = {0};
	double initial[12] = {0.0}, worst = 0.0;
	const struct hawser_integrate_options o = {.omega = 1.0, .until = 40.0, .every = 1.0,
	                                           .initial = initial};

	for (int j = 0; j < 6; j++)
		initial[j] = 0.01/(1 + j);
	if (!ok(!hawser_line_rom_build(&rom, &modes, lane, 1, &model, &report) &&
	        !hawser_integrate(&run, &rom, &o, &report), "free motion: %s", report.message))
		return;
	for (int i = 0; i < run.rows; i++)
		worst = fmax(worst, fabs(run.energy[i]/run.energy[0] - 1.0));
	ok(hawser_rom_asymmetry(&rom) == 0.0 && worst <= 1e-8, "a potential; energy kept to %.1e", worst);
	hawser_trajectory_clear(&run);
	hawser_rom_clear(&rom);
	hawser_line_modes_clear(&modes);
}

/* The orbit of the response against an integration from rest. */
static void responds(const struct hawser_rom *rom, const char *what)
{
	struct hawser_frf_options f = {.samples = HAWSER_NONE};
	struct hawser_frf frf;
	struct hawser_trajectory run;
	struct hawser_report report = {0};
	double omega = 0.97*sqrt(rom->K[0]), worst = 0.0, most = 0.0, period = 2.0*M_PI/omega;
	const struct hawser_integrate_options o = {.omega = omega, .until = 80.0*period,
	                                           .every = 80.0*period};

	f.from = omega;
	f.to = 1.01*omega;
	if (!ok(!hawser_frf_trace(&frf, rom, &f, &report), "%s, response: %s", what, report.message))
		return;
	if (ok(!hawser_integrate(&run, rom, &o, &report), "%s, integration: %s", what, report.message))
		for (int i = 0; i < 2*rom->n; i++) {
			double own = run.state[2*rom->n*(run.rows - 1) + i];

			most = fmax(most, fabs(own));
			worst = fmax(worst, fabs(own - frf.state[i]));
		}
	ok(most > 1e-6 && worst <= 1e-6*most, "%s: response and settled motion (%.2e) to %.1e", what, most,
	   worst/most);
	hawser_frf_clear(&frf);
	hawser_trajectory_clear(&run);
}

static void motions(const struct hawser_line *line)
{
	struct hawser_line_rom_options o = {.modes = {.n = 6}, .ratio = 0.05,
		.load = HAWSER_LINE_LOAD_PASSING, .weight = {3000.0}, .spacing = 36.6};
	struct hawser_line_statics st;
	const struct hawser_line_statics *lane[1] = {&st};
	struct hawser_line_modes modes;
	struct hawser_rom rom;
	struct hawser_report report = {0};
	struct hawser_line_lift lift;

	if (!ok(!hawser_line_solve(&st, line, &report) &&
	        !hawser_line_rom_build(&rom, &modes, lane, 1, &o, &report), "model: %s", report.message))
		return;
	passing(&rom, &modes, 3000.0, 36.6);
	conserves(lane);
	responds(&rom, "passing");
	hawser_line_rom_lift(&lift, &modes, 0);
	printf("# mode 1 lifts off sheave %d at %g (%g m), force %g N\n", lift.sheave + 1, lift.amplitude,
	       lift.motion, lift.force);
	hawser_rom_clear(&rom);
	hawser_line_modes_clear(&modes);
	o.load = HAWSER_LINE_LOAD_DRIVE;
	o.amplitude[0] = 0.01;
	o.end = 1;
	if (ok(!hawser_line_rom_build(&rom, &modes, lane, 1, &o, &report), "model: %s", report.message))
		responds(&rom, "drive");
	hawser_rom_clear(&rom);
	hawser_line_modes_clear(&modes);
	hawser_line_statics_clear(&st);
}

/* --- lift-off --- */

/* At that amplitude the slopes beside the sheave have changed by its angle of contact. */
static void lifts(const struct hawser_line *line)
{
	struct hawser_line_rom_options o = {.modes = {.n = 1}};
	struct hawser_line_statics st;
	const struct hawser_line_statics *lane[1] = {&st};
	struct hawser_line_modes modes;
	struct hawser_rom rom;
	struct hawser_report report = {0};
	struct hawser_line_lift lift;
	double slope[2], u[3], v[3], turn, s0, s1;

	if (!ok(!hawser_line_solve(&st, line, &report) &&
	        !hawser_line_rom_build(&rom, &modes, lane, 1, &o, &report), "lift: %s", report.message))
		return;
	hawser_line_rom_lift(&lift, &modes, 0);
	s0 = st.piece[2*lift.sheave].S1/modes.length_unit;
	s1 = st.piece[2*lift.sheave + 2].S0/modes.length_unit;
	for (int i = 0; i < 2; i++) { /* change of slope of the free rope, a little beside the sheave */
		double h = 1e-6, s = i ? s1 + h : s0 - h;

		hawser_line_modes_at(u, v, &modes, 0, 0, s);
		slope[i] = v[1];
	}
	turn = fabs(slope[0] - slope[1])/(1.0 + st.contact[lift.sheave].T_in/line->EA)*lift.amplitude;
	ok(fabs(turn/st.contact[lift.sheave].wrap - 1.0) < 1e-4 && lift.motion > 0.0 &&
	   lift.force > 1000.0, "at %.3g m the angle of contact of sheave %d, %.4g, has changed by %.4g",
	   lift.motion, lift.sheave + 1, st.contact[lift.sheave].wrap, turn);
	hawser_rom_clear(&rom);
	hawser_line_modes_clear(&modes);
	hawser_line_statics_clear(&st);
}

/* --- refusals --- */

static void refused(const struct hawser_line *line, const struct hawser_line_rom_options *o,
                    enum hawser_status want, const char *word)
{
	struct hawser_line_statics st;
	const struct hawser_line_statics *lane[1] = {&st};
	struct hawser_line_modes modes;
	struct hawser_rom rom;
	struct hawser_report report = {0};
	enum hawser_status status = hawser_line_solve(&st, line, &report);

	if (!ok(!status, "statics: %s", report.message))
		return;
	status = hawser_line_rom_build(&rom, &modes, lane, 1, o, &report);
	ok(status == want && strstr(report.message, word), "%s: %s", hawser_status_name(status),
	   report.message);
	hawser_rom_clear(&rom);
	hawser_line_modes_clear(&modes);
	hawser_line_statics_clear(&st);
}

static void refusals(struct hawser_line line)
{
	struct hawser_line_rom_options o = {.modes = {.n = 41}};
	refused(&line, &o, HAWSER_ERR_ARGUMENT, "41 modes");
	o = (struct hawser_line_rom_options){.ratio = NAN};
	refused(&line, &o, HAWSER_ERR_ARGUMENT, "ratio");
	o = (struct hawser_line_rom_options){.load = HAWSER_LINE_LOAD_PASSING, .weight = {3000.0}};
	refused(&line, &o, HAWSER_ERR_ARGUMENT, "spacing");
	o = (struct hawser_line_rom_options){.load = HAWSER_LINE_LOAD_DRIVE, .amplitude = {INFINITY}};
	refused(&line, &o, HAWSER_ERR_ARGUMENT, "amplitude");
	o = (struct hawser_line_rom_options){.load = HAWSER_LINE_LOAD_DRIVE, .amplitude = {0.0, 1.0}};
	refused(&line, &o, HAWSER_ERR_ARGUMENT, "a lane that moves one");
	o = (struct hawser_line_rom_options){.modes = {.contact = HAWSER_LINE_ROLL}};
	refused(&line, &o, HAWSER_ERR_ARGUMENT, "roll");
	o = (struct hawser_line_rom_options){.held = 0};
	line.speed = 4.0;
	refused(&line, &o, HAWSER_ERR_ARGUMENT, "4 m/s");
}

CASE(property_line_rom)
{
	struct hawser_line_sheave sheave[2] = {{.centre = {80.0, 5.0}, .radius = 12.0, .side = 1},
	                                       {.centre = {190.0, 28.0}, .radius = 12.0, .side = 1}};
	struct hawser_line line = {.EA = 40e6, .rho = 10.0, .g = 9.81, .B = {300.0, 58.0},
	                           .given = HAWSER_LINE_T_A, .value = 84e3, .sheave = sheave, .sheaves = 2};

	one_span(4e8, 10.0, 8e4, "taut span");
	one_span(4e6, -60.0, 2e4, "deep span");
	/* a model of the span loses digits of C as EA/H grows, by the difference of terms of that size */
	one_span(4e12, 10.0, 8e4, "nearly inextensible span");
	moving_end(&line, "two towers");
	motions(&line);
	lifts(&line);
	refusals(line);
	return done_testing();
}

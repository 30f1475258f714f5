/* Modes of a rope over sheaves against those of single spans, published and independent numbers, and
 * closed forms.
 *
 * B: Bertrand, 2022. Its Table 3.6 cannot be reproduced, since it does not say where the sheave is; the
 * numbers of that geometry and of the small ropeway are of a prototype in another language, a mesh of
 * elements with contact at its nodes (doc/theory-ropeway-modes.md has what its mesh costs).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>

#include <hawser/gyroscopic.h>
#include <hawser/line_modes.h>

#include "tests/tap.h"

/* The modes of a line; 0 after a failure, which is reported. */
static int solved(struct hawser_line_modes *modes, struct hawser_line_statics *st,
                  const struct hawser_line *line, const struct hawser_line_modes_options *o,
                  const char *what)
{
	struct hawser_report report = {0};
	const struct hawser_line_statics *lane[1] = {st};
	enum hawser_status status = hawser_line_solve(st, line, &report);

	if (status)
		return ok(0, "%s: %s: %s", what, hawser_status_name(status), report.message);
	status = hawser_line_modes_solve(modes, lane, 1, o, &report);
	if (!status)
		return 1;
	hawser_line_statics_clear(st);
	return ok(0, "%s: %s: %s", what, hawser_status_name(status), report.message);
}

static void clear(struct hawser_line_modes *modes, struct hawser_line_statics *st)
{
	hawser_line_modes_clear(modes);
	hawser_line_statics_clear(st);
}

static double omega_of(const struct hawser_line_modes *modes, int k)
{
	return modes->mode[k].omega/modes->time_unit;
}

/* --- one span --- */

/* Without sheave, the modes of `hawser modes`. */
static void one_span(double EA, double d, double h, double T, const char *what)
{
	struct hawser_line line = {.EA = EA, .rho = 6.0, .g = 9.81, .B = {d, h}, .given = HAWSER_LINE_T_A,
	                           .value = T};
	const struct hawser_span span = {.EA = EA, .rho = 6.0, .g = 9.81, .d = d, .h = h};
	const struct hawser_line_modes_options o = {.n = 10, .tolerance = 1e-11};
	const struct hawser_modes_options choice = {.n = 10, .tolerance = 1e-11};
	struct hawser_line_statics st;
	struct hawser_statics statics;
	struct hawser_line_modes modes;
	struct hawser_modes reference;
	struct hawser_report report = {0};
	double worst = 0.0, stated = 0.0, shape = 0.0, slope = 0.0;

	if (!solved(&modes, &st, &line, &o, what))
		return;
	if (hawser_statics_solve(&statics, &span, HAWSER_GIVEN_T0, T, HAWSER_BRANCH_TAUT, &report) ||
	    hawser_modes_solve(&reference, &statics, &choice, &report)) {
		ok(0, "%s: %s", what, report.message);
		clear(&modes, &st);
		return;
	}
	for (int k = 0; k < 10; k++) {
		double off = modes.mode[k].omega/modes.time_unit*reference.time_unit/reference.mode[k].omega -
			1.0;

		worst = fmax(worst, fabs(off));
		stated = fmax(stated, modes.mode[k].residual);
		for (int i = 1; i < 20; i++) {
			double u[3], v[3], a[3], b[3];

			hawser_line_modes_at(u, a, &modes, k, 0, i*st.length0/modes.length_unit/20.0);
			hawser_modes_at(&reference, v, b, k, i*statics.l/20.0);
			for (int c = 0; c < 3; c++) {
				shape = fmax(shape, fabs(u[c] - v[c]));
				slope = fmax(slope, fabs(a[c] - b[c])/reference.mode[k].omega);
			}
		}
	}
	ok(worst <= 1e-10 && worst <= stated + 1e-12,
	   "%s: frequencies of hawser_modes to %.1e, estimated %.1e", what, worst, stated);
	ok(shape <= 1e-6 && slope <= 1e-6, "%s: shapes to %.1e, slopes to %.1e", what, shape, slope);
	hawser_modes_clear(&reference);
	clear(&modes, &st);
}

/* --- B Table 3.5's rope --- */

/* With stick, spans between the points of contact are single spans. */
static void stuck(const struct hawser_line *line)
{
	const struct hawser_line_modes_options o = {.n = 6, .contact = HAWSER_LINE_STICK,
	                                            .tolerance = 1e-11};
	const struct hawser_modes_options choice = {.n = 3, .tolerance = 1e-11};
	struct hawser_line_statics st;
	struct hawser_line_modes modes;
	double worst = 0.0;

	if (!solved(&modes, &st, line, &o, "stick"))
		return;
	for (int i = 0; i < 3; i += 2) {
		const struct hawser_line_piece *piece = &st.piece[i];
		const struct hawser_span span = {line->EA, line->rho, line->g, piece->x1[0] - piece->x0[0],
		                                 piece->x1[1] - piece->x0[1]};
		struct hawser_statics statics;
		struct hawser_modes reference;
		struct hawser_report report = {0};

		if (hawser_statics_solve(&statics, &span, HAWSER_GIVEN_LENGTH0, piece->S1 - piece->S0,
		                         HAWSER_BRANCH_TAUT, &report) ||
		    hawser_modes_solve(&reference, &statics, &choice, &report)) {
			ok(0, "%s", report.message);
			break;
		}
		for (int k = 0, j = 0; k < 6; k++) {
			if (modes.share[k*modes.spans + i/2] < 0.5 || j == 3)
				continue;
			worst = fmax(worst, fabs(omega_of(&modes, k)*reference.time_unit/reference.mode[j++].omega -
			                         1.0));
		}
		hawser_modes_clear(&reference);
	}
	ok(worst <= 1e-10, "stick: the modes of hawser_modes between the points of contact, to %.1e",
	   worst);
	clear(&modes, &st);
}

static void expect(const struct hawser_line *line, enum hawser_line_contact_kind contact,
                   const double *want, const char *plane, int n, double tolerance, const char *what)
{
	const struct hawser_line_modes_options o = {.n = n, .contact = contact};
	struct hawser_line_statics st;
	struct hawser_line_modes modes;
	char text[120];

	if (!solved(&modes, &st, line, &o, what))
		return;
	for (int k = 0; k < n; k++) {
		snprintf(text, sizeof text, "%s, %s, mode %d %s", what, hawser_line_contact_name(contact), k +
		         1,
		         hawser_plane_name(modes.mode[k].plane));
		close_to(omega_of(&modes, k), want[k], tolerance, text);
		ok((modes.mode[k].plane == HAWSER_OUT_OF_PLANE) == (plane[k] == 'z'), "%s: the plane", text);
	}
	clear(&modes, &st);
}

static void source_rope(void)
{
	static const double first[] = {1.49496, 1.52514, 1.52514, 3.03304};
	static const double second[] = {1.22338, 2.43481, 2.44519, 3.47141};
	static const double stick[] = {1.52514, 1.52514, 3.03304, 3.03304};
	struct hawser_line_sheave sheave = {.name = "s", .centre = {150.0, -8.0}, .radius = 10.0,
	                                    .side = 1};
	struct hawser_line line = {.EA = 1.5e9, .rho = 5.56, .g = 9.81, .B = {300.0, 0.0},
	                           .given = HAWSER_LINE_LENGTH0, .value = 301.0, .sheave = &sheave,
	                           .sheaves = 1};

	/* the mesh has nodes each 0.1 m: a span whose end is not at a node is up to 0.1 m of 150 m wrong */
	expect(&line, HAWSER_LINE_SLIP, first, "pzzp", 4, 2e-4, "B Table 3.5, centred");
	expect(&line, HAWSER_LINE_STICK, stick, "zzpp", 4, 2e-4, "B Table 3.5, centred");
	stuck(&line);
	sheave.centre[0] = 50.0;
	sheave.centre[1] = -5.0;
	expect(&line, HAWSER_LINE_SLIP, second, "zpzp", 4, 2e-4, "B Table 3.5, not centred");
}

/* --- ropeways --- */

static void carriers(struct hawser_line_mass *mass, int count, double phase)
{
	for (int i = 0; i < count; i++)
		mass[i] = (struct hawser_line_mass){.S = phase + 36.6*i, .mass = 400.0};
}

static void small_ropeway(void)
{
	static const double slip[] = {2.1127, 2.1299, 2.1307, 2.5235, 2.8393, 3.4201};
	static const double stick[] = {2.1299, 2.1307, 2.8393, 3.1099, 3.1804};
	static const double carriage[] = {1.3971, 2.1129, 2.6178};
	static const int planar[] = {0, 1, 4};
	const struct hawser_line_freedom freedom = {.name = "carriage", .mass = 20e3,
	                                            .end = {{{1.0, 0.0, 0.0}, {0.0}}}};
	struct hawser_line_modes_options o = {.n = 6, .printed = 1};
	struct hawser_line_sheave sheave[2] = {{.centre = {80.0, 5.0}, .radius = 12.0, .side = 1},
	                                       {.centre = {190.0, 28.0}, .radius = 12.0, .side = 1}};
	struct hawser_line_mass mass[9];
	struct hawser_line line = {.EA = 40e6, .rho = 4.0, .g = 9.81, .B = {300.0, 58.0},
	                           .given = HAWSER_LINE_T_A, .value = 84e3, .sheave = sheave, .sheaves = 2,
	                           .mass = mass, .masses = 9};
	struct hawser_line_statics st;
	struct hawser_line_modes modes;

	carriers(mass, 9, 18.3);
	expect(&line, HAWSER_LINE_SLIP, slip, "pzzpzp", 6, 3e-5, "small ropeway");
	expect(&line, HAWSER_LINE_STICK, stick, "zzzpp", 5, 3e-5, "small ropeway");
	if (solved(&modes, &st, &line, &o, "small ropeway as printed")) {
		close_to(omega_of(&modes, 0), 2.1159, 3e-5, "without the curvature term, mode 1");
		close_to(omega_of(&modes, 3), 2.5259, 3e-5, "without the curvature term, mode 4");
		clear(&modes, &st);
	}
	o = (struct hawser_line_modes_options){.n = 6, .freedom = &freedom, .freedoms = 1};
	if (solved(&modes, &st, &line, &o, "small ropeway with a carriage")) {
		for (int i = 0; i < 3; i++)
			close_to(omega_of(&modes, planar[i]), carriage[i], 1e-4,
			         "a carriage of 20 t, in the plane");
		ok(fabs(modes.freedom_at[0]) > 0.1*fabs(modes.freedom_at[1]), "the carriage moves in mode 1");
		clear(&modes, &st);
	}
}

/* --- belts: closed forms --- */

/* The statics of a weightless belt around two wheels, cut in the middle of its upper strand. */
static void belt_statics(struct hawser_line_statics *st, struct hawser_line_piece piece[5],
                         struct hawser_line_contact contact[2], struct hawser_line *line,
                         struct hawser_line_sheave sheave[2], double d, double R, double T)
{
	double g = 1.0 + T/line->EA, x[5][2] = {{0.5*d, R}, {d, R}, {d, -R}, {0.0, -R}, {0.0, R}}, S = 0.0;
	double length[5] = {0.5*d, M_PI*R, d, M_PI*R, 0.5*d};

	for (int i = 0; i < 2; i++)
		sheave[i] = (struct hawser_line_sheave){.centre = {i ? 0.0 : d, 0.0}, .radius = R, .side = 1};
	for (int i = 0; i < 5; i++) {
		piece[i] = (struct hawser_line_piece){.sheave = i%2 ? i/2 : -1, .mass = -1, .S0 = S,
			.S1 = S + length[i]/g, .x0 = {x[i][0], x[i][1]}, .x1 = {x[(i + 1)%5][0], x[(i + 1)%5][1]},
			.angle0 = -M_PI*(i/2), .angle1 = -M_PI*((i + 1)/2), .T0 = T, .T1 = T};
		S = piece[i].S1;
	}
	contact[0] = contact[1] = (struct hawser_line_contact){.touches = 1, .T_in = T, .T_out = T};
	line->A[0] = line->B[0] = x[0][0];
	line->A[1] = line->B[1] = x[0][1];
	line->sheave = sheave;
	line->sheaves = 2;
	*st = (struct hawser_line_statics){.line = line, .pieces = 5, .piece = piece, .contact = contact,
	                                   .T_A = T, .T_B = T, .angle_B = -2.0*M_PI, .length0 = S,
	                                   .length = S*g};
}

/* The belt of B Table 3.3: circulation has no stiffness. Without the curvature term it would have the
 * frequency sqrt(2 pi T/(R rho L)) if the belt were inextensible. */
static void belt(void)
{
	static const struct hawser_line_freedom cut[3] = {
		{.name = "x", .end = {{{1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}}},
		{.name = "y", .end = {{{0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}}}},
		{.name = "z", .end = {{{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}}}};
	const double d = 0.45, R = 0.05, T = 358.701;
	struct hawser_line line = {.EA = 30400.0, .rho = 0.096, .g = 0.0};
	struct hawser_line_modes_options o = {.n = 5, .freedom = cut, .freedoms = 3};
	struct hawser_line_sheave sheave[2];
	struct hawser_line_piece piece[5];
	struct hawser_line_contact contact[2];
	struct hawser_line_statics st;
	const struct hawser_line_statics *lane[1] = {&st};
	struct hawser_line_modes modes;
	struct hawser_report report = {0};
	double g = 1.0 + T/line.EA, c = sqrt(T/g/line.rho)*g, closed, last = 0.0;

	belt_statics(&st, piece, contact, &line, sheave, d, R, T);
	if (!ok(!hawser_line_modes_solve(&modes, lane, 1, &o, &report), "belt: %s", report.message))
		return;
	ok(modes.mode[0].omega == 0.0 && modes.mode[0].axial_share > 1.0 - 1e-12, "circulation has "
	   "frequency 0");
	for (int k = 1; k < 5; k++) /* strands of length d: transverse modes in both planes */
		close_to(omega_of(&modes, k), M_PI*c/d, 1e-12, "transverse mode of a strand");
	hawser_line_modes_clear(&modes);
	o.printed = 1;
	for (int i = 0; i < 3; i++) {
		line.EA = 30400.0*pow(100.0, i);
		belt_statics(&st, piece, contact, &line, sheave, d, R, T);
		if (!ok(!hawser_line_modes_solve(&modes, lane, 1, &o, &report), "belt: %s", report.message))
			return;
		closed = sqrt(2.0*M_PI*T/(R*line.rho*st.length0))/(1.0 + T/line.EA);
		for (int k = 0; k < modes.n; k++)
			if (modes.mode[k].axial_share > 0.9)
				last = omega_of(&modes, k);
		printf("# EA %g N: %.6g rad/s, inextensible %.6g\n", line.EA, last, closed);
		if (i == 0)
			close_to(last, 619.0, 1e-3, "without the curvature term: a false stiffness of circulation");
		hawser_line_modes_clear(&modes);
	}
	close_to(last, closed, 1e-5,
	         "without the curvature term: its closed form for an inextensible belt");
}

/* --- a rope that runs --- */

static int running(struct hawser_line_modes *modes, struct hawser_line_statics *st,
                   const struct hawser_line *line, const struct hawser_line_modes_options *o,
                   const char *what)
{
	struct hawser_report report = {0};
	const struct hawser_line_statics *lane[1] = {st};
	enum hawser_status status = hawser_line_solve(st, line, &report);

	if (status)
		return ok(0, "%s: %s: %s", what, hawser_status_name(status), report.message);
	status = hawser_line_modes_running(modes, lane, 1, o, &report);
	if (!status)
		return 1;
	hawser_line_statics_clear(st);
	return ok(0, "%s: %s: %s", what, hawser_status_name(status), report.message);
}

/* Without sheave, the complex modes of `hawser modes`. */
static void one_running_span(double speed)
{
	struct hawser_line line = {.EA = 4e8, .rho = 6.0, .g = 9.81, .B = {250.0, 10.0},
	                           .given = HAWSER_LINE_T_A, .value = 8e4, .speed = speed};
	const struct hawser_span span = {.EA = 4e8, .rho = 6.0, .g = 9.81, .d = 250.0, .h = 10.0};
	const struct hawser_motion motion = {.speed = speed, .hold = HAWSER_HOLD_TENSION};
	const struct hawser_line_modes_options o = {.n = 8};
	const struct hawser_modes_options choice = {.n = 8};
	struct hawser_line_statics st;
	struct hawser_line_modes modes;
	struct hawser_statics statics;
	struct hawser_modes reference;
	struct hawser_report report = {0};
	double worst = 0.0, other = 0.0;

	if (!running(&modes, &st, &line, &o, "running span"))
		return;
	if (hawser_statics_travel(&statics, &span, HAWSER_GIVEN_T0, 8e4, HAWSER_BRANCH_TAUT, &motion,
	                          &report) ||
	    hawser_complex_modes_solve(&reference, &statics, &choice, &report)) {
		ok(0, "running span: %s", report.message);
		clear(&modes, &st);
		return;
	}
	for (int k = 0; k < 8; k++) {
		worst = fmax(worst, fabs(omega_of(&modes, k)*reference.time_unit/reference.mode[k].omega -
		                         1.0));
		other = fmax(other, fabs(modes.mode[k].downstream - reference.mode[k].downstream) +
		                    fabs(modes.mode[k].condition - reference.mode[k].condition));
	}
	ok(worst <= 1e-10 && other <= 1e-6,
	   "%g m/s: frequencies of hawser_complex_modes to %.1e, shares and conditions to %.1e", speed,
	   worst,
	   other);
	hawser_modes_clear(&reference);
	clear(&modes, &st);
}

/* A weightless rope over a sheave: strings between fixed points across it, and one rod along it. */
static void running_string(void)
{
	struct hawser_line_sheave sheave = {.centre = {40.0, 8.0}, .radius = 2.0, .side = 1};
	struct hawser_line line = {.EA = 4e6, .rho = 4.0, .g = 0.0, .B = {100.0, 0.0},
	                           .given = HAWSER_LINE_T_A, .value = 5e4, .sheave = &sheave, .sheaves = 1,
	                           .speed = 60.0};
	const struct hawser_line_modes_options o = {.n = 30, .tolerance = 1e-10};
	struct hawser_line_statics st;
	struct hawser_line_modes modes;
	double rod2 = line.EA/line.rho, g = 1.0 + line.value/line.EA, string2 = line.value/line.rho/g;
	double v2 = line.speed*line.speed, worst[2] = {0.0}, last = 0.0;
	int strings = 0, rods = 0;

	if (!running(&modes, &st, &line, &o, "running string"))
		return;
	for (int k = 0; k < modes.n; k++) {
		double own = omega_of(&modes, k), length = st.length0, speed2 = rod2, number;
		int i = modes.share[k*modes.spans] > 0.5 ? 0 : 2;

		if (modes.mode[k].axial_share < 0.5) {
			length = st.piece[i].S1 - st.piece[i].S0;
			speed2 = string2;
		}
		number = own*length*sqrt(speed2)/(M_PI*(speed2 - v2));
		if (modes.mode[k].axial_share < 0.5)
			strings++;
		else
			rods++;
		worst[modes.mode[k].axial_share >= 0.5] =
			fmax(worst[modes.mode[k].axial_share >= 0.5], fabs(number/nearbyint(number) - 1.0));
		last = own;
	}
	ok(strings > 20 && rods > 0 && worst[0] <= 1e-10 && worst[1] <= 1e-10,
	   "running string up to %.4g rad/s: %d across to %.1e, %d along to %.1e", last, strings, worst[0],
	   rods,
	   worst[1]);
	clear(&modes, &st);
}

/* Two lanes that a carriage and its wheel join: running one way or the other is the same, and the
 * frequencies are even in the speed. */
static void running_loop(void)
{
	static const struct hawser_line_freedom joint[2] = {
		{.name = "carriage", .mass = 8e3, .end = {{{1.0, 0.0, 0.0}, {0.0}}, {{1.0, 0.0, 0.0}, {0.0}}}},
		{.name = "wheel", .mass = 30.0, .end = {{{1.0, 0.0, 0.0}, {0.0}}, {{-1.0, 0.0, 0.0}, {0.0}}}}};
	struct hawser_line_sheave sheave[2] = {{.centre = {80.0, 5.0}, .radius = 12.0, .side = 1},
	                                       {.centre = {190.0, 28.0}, .radius = 12.0, .side = 1}};
	struct hawser_line line = {.EA = 40e6, .rho = 4.0, .g = 9.81, .B = {300.0, 58.0},
	                           .given = HAWSER_LINE_T_A, .value = 84e3, .sheave = sheave, .sheaves = 2};
	struct hawser_line_modes_options o = {.n = 10, .freedom = joint, .freedoms = 2, .backward = {0, 1}};
	struct hawser_report report = {0};
	double omega[4][10];
	const double speed[4] = {0.0, 3.0, 6.0, 6.0};

	for (int i = 0; i < 4; i++) {
		struct hawser_line_statics st;
		const struct hawser_line_statics *lane[2] = {&st, &st};
		struct hawser_line_modes modes;

		line.speed = speed[i];
		o.backward[0] = i == 3;
		o.backward[1] = i != 3;
		if (!ok(!hawser_line_solve(&st, &line, &report) &&
		        !hawser_line_modes_running(&modes, lane, 2, &o, &report), "loop at %g m/s: %s",
		        speed[i],
		        report.message))
			return;
		for (int k = 0; k < 10; k++)
			omega[i][k] = omega_of(&modes, k);
		clear(&modes, &st);
	}
	for (int k = 0; k < 10; k++) {
		double slow = omega[1][k] - omega[0][k], fast = omega[2][k] - omega[0][k];

		if (k < 2) /* other modes are close to each other, so that higher powers matter */
			ok(fabs(fast/slow - 4.0) < 0.05, "loop, mode %d: %.6g rad/s, %.3e and %.3e at 3 and 6 m/s",
			   k + 1,
			   omega[0][k], slow, fast);
		close_to(omega[3][k], omega[2][k], 1e-11, "loop, running the other way");
	}
}

/* --- refusals --- */

static void refused(const struct hawser_line_statics *st, const struct hawser_line_modes_options *o,
                    enum hawser_status want, const char *word)
{
	const struct hawser_line_statics *lane[1] = {st};
	struct hawser_line_modes modes;
	struct hawser_report report = {0};
	enum hawser_status status = hawser_line_modes_solve(&modes, lane, 1, o, &report);

	ok(status == want && strstr(report.message, word), "%s: %s", hawser_status_name(status),
	   report.message);
	hawser_line_modes_clear(&modes);
}

static void refusals(void)
{
	struct hawser_line_sheave sheave = {.name = "s", .centre = {150.0, -8.0}, .radius = 10.0,
	                                    .side = 1};
	struct hawser_line line = {.EA = 1.5e9, .rho = 5.56, .g = 9.81, .B = {300.0, 0.0},
	                           .given = HAWSER_LINE_LENGTH0, .value = 301.0, .sheave = &sheave,
	                           .sheaves = 1};
	struct hawser_line_freedom freedom = {.name = "carriage", .mass = NAN,
	                                      .end = {{{1.0, 0.0, 0.0}, {0.0}}}};
	struct hawser_line_modes_options o = {.n = -1};
	struct hawser_line_statics st;
	struct hawser_report report = {0};

	if (!ok(!hawser_line_solve(&st, &line, &report), "statics"))
		return;
	refused(&st, &o, HAWSER_ERR_ARGUMENT, "modes asked");
	o = (struct hawser_line_modes_options){.n = 3, .tolerance = 2.0};
	refused(&st, &o, HAWSER_ERR_ARGUMENT, "tolerance");
	o = (struct hawser_line_modes_options){.n = 3, .freedom = &freedom, .freedoms = 1};
	refused(&st, &o, HAWSER_ERR_ARGUMENT, "carriage");
	freedom.mass = 1.0;
	freedom.end[0][0][2] = 1.0;
	refused(&st, &o, HAWSER_ERR_ARGUMENT, "both planes");
	o = (struct hawser_line_modes_options){.n = 3, .tolerance = 1e-17};
	refused(&st, &o, HAWSER_ERR_CONVERGENCE, "round-off");
	o = (struct hawser_line_modes_options){.n = 3, .contact = (enum hawser_line_contact_kind)7};
	refused(&st, &o, HAWSER_ERR_ARGUMENT, "contact");
	hawser_line_statics_clear(&st);
}

CASE(reference_line_modes)
{
	one_span(4e8, 250.0, 10.0, 8e4, "taut span");
	one_span(4e8, 250.0, -140.0, 4e4, "steep span");
	one_span(4e6, 100.0, 0.0, 1e6, "very elastic span");
	one_span(4e14, 250.0, 10.0, 8e4, "nearly inextensible span");
	one_span(4e8, 250.0, 10.0, 1.09e4, "slack span");
	source_rope();
	small_ropeway();
	belt();
	one_running_span(4.25);
	one_running_span(85.0);
	running_string();
	running_loop();
	refusals();
	return done_testing();
}

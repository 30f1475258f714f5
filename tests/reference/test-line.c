/* Statics of a rope over sheaves against published and independent numbers.
 *
 * B: Bertrand, 2022. Where B neglects the weight of the rope on a sheave, or where its
 * prototype did, the comparison says so.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>

#include <hawser/line.h>

#include "tests/tap.h"

static int solved(struct hawser_line_statics *st, const struct hawser_line *line, const char *what)
{
	struct hawser_report report = {0};
	enum hawser_status status = hawser_line_solve(st, line, &report);

	if (status)
		return ok(0, "%s: %s: %s", what, hawser_status_name(status), report.message);
	return ok(st->closure <= 1e-12*st->length && st->balance <= 1e-12*st->T_A*(1.0 + st->pieces),
	          "%s: closed to %.1e m, balanced to %.1e N", what, st->closure, st->balance);
}

/* |got - want| within half a unit of the last printed digit, and a little for the text's own
 * rounding. */
static void printed(double got, double want, double digit, const char *what)
{
	ok(fabs(got - want) <= 0.51*digit, "%s: %.7g, printed %.7g", what, got, want);
}

/* B Tables 6.3 and 6.4: joined catenaries, that is sheaves of radius 0. The load is spread: 25
 * kg/m. B says that the rope is inextensible there; the printed numbers are those of EA = 40
 * MN. */
static void bouquet_bare(void)
{
	static const double at[8][2] = {{40.0, 0.0}, {79.71, 16.86}, {146.56, 41.03}, {222.57, 67.96},
	                                {394.98, 126.17}, {479.37, 154.04}, {623.41, 195.99}, {694.13,
	                                                                                       212.67}};
	static const double T0[9] = {84.0, 84.0, 88.13, 94.04, 100.63, 114.87, 121.68, 131.94, 136.01};
	static const double L[9] = {14.97, 43.07, 71.02, 80.57, 182.7, 88.73, 150.04, 72.47, 14.95};
	static const double eta[9] = {-0.022, 0.358, 0.261, 0.247, 0.118, 0.234, 0.141, 0.168, -0.013};
	static const double R[10] = {1.84, -26.5, 16.68, 17.06, 30.5, 30.48, 30.98, 31.89, 41.45, 1.83};
	struct hawser_line_sheave sheave[8];
	struct hawser_line line = {.EA = 40e6, .rho = 25.0, .g = 9.81, .A = {25.0, 0.0}, .B = {709.13,
	                                                                                       212.67},
	                           .given = HAWSER_LINE_T_A, .value = 84e3, .sheave = sheave, .sheaves = 8};
	struct hawser_line_statics st;
	char what[64];

	memset(sheave, 0, sizeof sheave);
	for (int i = 0; i < 8; i++) {
		memcpy(sheave[i].centre, at[i], sizeof at[i]);
		sheave[i].side = i ? 1 : -1;
	}
	if (!solved(&st, &line, "B Tables 6.3, 6.4"))
		return;
	ok(st.pieces == 9, "nine spans");
	for (int i = 0; i < 9; i++) {
		snprintf(what, sizeof what, "B Table 6.3, span %d, T0 (kN)", i + 1);
		printed(st.piece[i].T0/1e3, T0[i], 0.01, what);
		snprintf(what, sizeof what, "B Table 6.3, span %d, L (m)", i + 1);
		printed(st.piece[i].S1 - st.piece[i].S0, L[i], i == 4 ? 0.1 : 0.01, what);
		snprintf(what, sizeof what, "B Table 6.3, span %d, eta", i + 1);
		printed(tan(st.piece[i].angle0), eta[i], 0.001, what);
	}
	printed(st.reaction_A[1]/1e3, R[0], 0.01, "B Table 6.4, lower station (kN)");
	printed(st.reaction_B[1]/1e3, R[9], 0.01, "B Table 6.4, upper station (kN)");
	for (int i = 0; i < 8; i++) {
		snprintf(what, sizeof what, "B Table 6.4, tower %d (kN)", i);
		printed(st.contact[i].force[1]/1e3, R[i + 1], i == 0 || i == 3 ? 0.1 : 0.01, what);
	}
	hawser_line_statics_clear(&st);
}

/* B Table 3.5. B's rope has no weight on the sheave, so that the printed 28 937 and 52 294 N
 * are met to 5e-5 only; the numbers of an independent prototype and of a mesh of 3000 elements
 * (28 935.56, 52 295.88, 52 126.33 N) are met to their digits. */
static void sheave_span(void)
{
	struct hawser_line_sheave sheave = {.centre = {150.0, -8.0}, .radius = 10.0, .side = 1};
	struct hawser_line line = {.EA = 1.5e9, .rho = 5.56, .g = 9.81, .B = {300.0, 0.0},
	                           .given = HAWSER_LINE_LENGTH0, .value = 301.0, .sheave = &sheave,
	                           .sheaves = 1};
	struct hawser_line_statics st;

	if (solved(&st, &line, "B Table 3.5, sheave in the middle")) {
		close_to(st.T_A*cos(st.angle_A), 28935.7, 2e-6, "H, own number");
		close_to(st.T_A*cos(st.angle_A), 28937.0, 6e-5, "H, printed");
		close_to(st.T_B, st.T_A, 1e-13, "symmetric");
		hawser_line_statics_clear(&st);
	}
	sheave.centre[0] = 50.0;
	sheave.centre[1] = -5.0;
	if (solved(&st, &line, "B Table 3.5, sheave at 50 m")) {
		close_to(st.T_A*cos(st.angle_A), 52295.98, 2e-7, "H on the left, own number");
		close_to(st.T_B*cos(st.angle_B), 52126.54, 2e-7, "H on the right, own number");
		close_to(st.T_A*cos(st.angle_A), 52294.0, 5e-5, "H, printed (no weight on the sheave)");
		hawser_line_statics_clear(&st);
	}
}

/* B Table 2.1: inextensible; own numbers. */
static void inextensible(void)
{
	static const struct { double L, yB, c[2], H1, H2, wrap; } row[3] = {
		{50.5, 0.0, {25.0, -3.0}, 2707.575, 2707.575, 0.477766},
		{50.5, 0.0, {37.5, -4.0}, 3831.428, 3940.200, 0.237402},
		{51.0, 8.0, {25.0, -1.0}, 4123.718, 4235.143, 0.164304},
	};
	struct hawser_line_statics st;

	for (int i = 0; i < 3; i++) {
		struct hawser_line_sheave sheave = {.centre = {row[i].c[0], row[i].c[1]}, .radius = 3.0,
		                                    .side = 1,
		                                    .friction = 0.1};
		struct hawser_line line = {.EA = INFINITY, .rho = 5.56, .g = 9.81, .B = {50.0, row[i].yB},
		                           .given = HAWSER_LINE_LENGTH0, .value = row[i].L, .sheave = &sheave,
		                           .sheaves = 1};

		if (!solved(&st, &line, "B Table 2.1"))
			continue;
		close_to(st.T_A*cos(st.angle_A), row[i].H1, 2e-7, "H on the left");
		close_to(st.T_B*cos(st.angle_B), row[i].H2, 2e-7, "H on the right");
		close_to(st.contact[0].wrap, row[i].wrap, 3e-6, "angle of contact");
		hawser_line_statics_clear(&st);
		line.sliding = HAWSER_LINE_TOWARD_B;
		if (solved(&st, &line, "B Table 2.1 with friction")) {
			if (i == 0)
				close_to(st.contact[0].T_out/st.contact[0].T_in, 1.052066, 5e-7, "line 1, T2/T1");
			hawser_line_statics_clear(&st);
		}
	}
}

/* Force on the rope but for the weight of rope and masses in contact: what a prototype without
 * these reported. */
static double pull(const struct hawser_line_contact *c, int component)
{
	double x = c->T_in*cos(c->angle_in) - c->T_out*cos(c->angle_out);
	double y = c->T_in*sin(c->angle_in) - c->T_out*sin(c->angle_out);

	return component == 1 ? y : hypot(x, y);
}

/* Carriers of 400 kg each 36.6 m. */
static void carriers(struct hawser_line_mass *mass, int count, double phase)
{
	for (int i = 0; i < count; i++)
		mass[i] = (struct hawser_line_mass){.S = phase + 36.6*i, .mass = 400.0};
}

/* The small ropeway with the friction of the prototype, whose normal force leaves out the weight of the
 * rope on the sheave: T_out = T_in e^(+-mu wrap) + w (y_out - y_in). The coefficient is adjusted until
 * this holds. */
static void lighter_friction(struct hawser_line *line, struct hawser_line_sheave *sheave, double mu,
                             double top)
{
	double way = line->sliding == HAWSER_LINE_TOWARD_B ? 1.0 : -1.0;
	struct hawser_line_statics st;

	for (int round = 0; round < 8; round++) {
		if (hawser_line_solve(&st, line, NULL)) {
			ok(0, "friction without the weight");
			return;
		}
		for (int k = 0; k < line->sheaves; k++) {
			const struct hawser_line_contact *c = &st.contact[k];
			double weight = line->rho*line->g*sheave[k].radius*(cos(c->angle_out) - cos(c->angle_in));

			sheave[k].friction += mu - way*log((c->T_out - weight)/c->T_in)/c->wrap;
		}
		if (round == 7)
			close_to(st.T_B, top, 6e-6, "T at the top, friction without the weight on the sheaves");
		hawser_line_statics_clear(&st);
	}
	sheave[0].friction = sheave[1].friction = mu;
}

/* A ropeway of two towers, against a prototype in another language (4 to 5 digits; no weight of
 * the rope on the sheaves). All phases: it could not solve 4 of 75. */
static void small_ropeway(void)
{
	struct hawser_line_sheave sheave[2] = {{.centre = {80.0, 5.0}, .radius = 12.0, .side = 1},
	                                       {.centre = {190.0, 28.0}, .radius = 12.0, .side = 1}};
	struct hawser_line_mass mass[9];
	struct hawser_line line = {.EA = 40e6, .rho = 4.0, .g = 9.81, .B = {300.0, 58.0},
	                           .given = HAWSER_LINE_T_A, .value = 84e3, .sheave = sheave, .sheaves = 2,
	                           .mass = mass};
	struct hawser_line_statics st;
	static const double range[2][2] = {{10510.0, 14316.0}, {16482.0, 20358.0}};
	double T[2] = {INFINITY, 0.0}, R[2][2] = {{INFINITY, 0.0}, {INFINITY, 0.0}}, worst = 0.0;
	int phases = 75, count = 0;

	if (solved(&st, &line, "small ropeway without carriers")) {
		close_to(st.length0, 305.01722, 2e-8, "unstretched length");
		close_to(st.T_B, 86271.11, 5e-7, "T at the top");
		close_to(pull(&st.contact[0], 0), 4207.14, 3e-5, "first tower");
		close_to(pull(&st.contact[1], 0), 8199.70, 3e-5, "second tower");
		hawser_line_statics_clear(&st);
	}
	line.masses = 9;
	carriers(mass, 9, 18.3);
	if (solved(&st, &line, "small ropeway with carriers")) {
		close_to(st.length0, 305.36187, 2e-8, "unstretched length");
		close_to(st.T_B, 91844.22, 1e-6, "T at the top");
		close_to(pull(&st.contact[0], 0), 14241.48, 3e-5, "first tower");
		close_to(pull(&st.contact[1], 0), 20280.73, 3e-5, "second tower");
		hawser_line_statics_clear(&st);
	}
	sheave[0].friction = sheave[1].friction = 0.03;
	for (int i = 0; i < 2; i++) {
		line.sliding = i ? HAWSER_LINE_TOWARD_A : HAWSER_LINE_TOWARD_B;
		if (!solved(&st, &line, "small ropeway with friction"))
			continue;
		close_to(st.T_B, i ? 90804.0 : 92885.0, 7e-5, "T at the top (the prototype's law has no "
		         "weight)");
		hawser_line_statics_clear(&st);
		lighter_friction(&line, sheave, 0.03, i ? 90804.0 : 92885.0);
	}
	line.sliding = HAWSER_LINE_NONE;
	for (int i = 0; i < phases; i++) {
		struct hawser_report report;

		carriers(mass, 9, 36.6*i/phases);
		if (hawser_line_solve(&st, &line, &report))
			continue;
		count++;
		T[0] = fmin(T[0], st.T_B);
		T[1] = fmax(T[1], st.T_B);
		for (int k = 0; k < 2; k++) {
			R[k][0] = fmin(R[k][0], pull(&st.contact[k], 0));
			R[k][1] = fmax(R[k][1], pull(&st.contact[k], 0));
		}
		worst = fmax(worst, fmax(st.closure/st.length, st.balance/st.T_A));
		hawser_line_statics_clear(&st);
	}
	ok(count == phases, "%d of %d phases", count, phases);
	ok(worst <= 1e-13, "closed and balanced to %.1e", worst);
	ok(T[0] < 91573.0 && T[0] > 91540.0 && T[1] > 93579.0 && T[1] < 93620.0,
	   "T at the top %.0f to %.0f N, without the four phases 91573 to 93579", T[0], T[1]);
	for (int k = 0; k < 2; k++)
		ok(R[k][0] < range[k][0]*1.0001 && R[k][0] > range[k][0]*0.997 &&
		    R[k][1] > range[k][1]*0.9999 &&
		   R[k][1] < range[k][1]*1.003, "tower %d %.0f to %.0f N, without the four phases %.0f to "
		   "%.0f", k + 1,
		   R[k][0], R[k][1], range[k][0], range[k][1]);
}

/* The line of B Table 6.2 with its towers as circles, carriers 20 m from the lower station. A
 * prototype gave T 115 790 N and the vertical forces below, but its rope went into the
 * compression battery p0: the first carrier hangs 0.25 m behind the point where the rope leaves
 * it, and the rope behind the carrier touches it again. */
static void bouquet(void)
{
	static const double at[8][2] = {{40.0, 0.0}, {79.71, 16.86}, {146.56, 41.03}, {222.57, 67.96},
	                                {394.98, 126.17}, {479.37, 154.04}, {623.41, 195.99}, {694.13,
	                                                                                       212.67}};
	static const double R[8] = {-33213.0, 15582.0, 10286.0, 18424.0, 18387.0, 19474.0, 20803.0,
	                            32182.0};
	struct hawser_line_sheave sheave[8];
	struct hawser_line_mass mass[22];
	struct hawser_line line = {.EA = 40e6, .rho = 4.0, .g = 9.81, .A = {25.0, 0.0}, .B = {709.13,
	                                                                                      212.67},
	                           .given = HAWSER_LINE_T_A, .value = 84e3, .sheave = sheave, .sheaves = 8,
	                           .mass = mass, .masses = 22};
	struct hawser_line_statics st;
	int arcs = 0;

	memset(sheave, 0, sizeof sheave);
	for (int i = 0; i < 8; i++) {
		sheave[i].side = i ? 1 : -1;
		sheave[i].radius = 12.0;
		sheave[i].centre[0] = at[i][0];
		sheave[i].centre[1] = at[i][1] - 12.0*sheave[i].side;
	}
	carriers(mass, 22, 20.0);
	if (!solved(&st, &line, "line of B Table 6.2"))
		return;
	for (int i = 0; i < st.pieces; i++)
		arcs += st.piece[i].sheave == 0;
	ok(arcs == 2 && st.carrier[0].state == 0, "the first carrier hangs between %d arcs of p0", arcs);
	close_to(st.T_B, 115790.0, 4e-4, "T at the top, against the prototype");
	close_to(pull(&st.contact[0], 1), R[0] - 3924.0, 6e-4, "p0 with the carrier, against the "
	         "prototype");
	for (int i = 1; i < 8; i++)
		close_to(pull(&st.contact[i], 1), R[i], 7e-4, "tower, against the prototype");
	hawser_line_statics_clear(&st);
}

CASE(reference_line)
{
	small_ropeway();
	bouquet();
	bouquet_bare();
	sheave_span();
	inextensible();
	return done_testing();
}

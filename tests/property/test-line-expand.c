/* The energy of a rope over sheaves to fourth order against statics, which share nothing with it:
 * the exact catenaries and arcs of hawser_line_solve under small further weights, whose points of
 * contact move.
 *
 * With the weights lambda P_i on the masses, the least potential energy E(lambda) has the
 * derivative Y = sum P_i y_i. The model has the linear response u to the weights, and E = E_0 +
 * ... - lambda^2 u K u/2 + lambda^3 V3(u) + lambda^4 V4(u).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "ropeway/expand/expand.h"
#include "tests/tap.h"

enum { MASSES = 40 };

struct weights {
	const struct hawser_line *line; /* with length0 */
	const double *P;                /* [masses] N */
};

/* Y at lambda. */
static double work_of(const struct weights *w, double lambda)
{
	struct hawser_line line = *w->line;
	struct hawser_line_mass mass[MASSES];
	struct hawser_line_statics st;
	struct hawser_report report = {0};
	double sum = 0.0;

	for (int i = 0; i < line.masses; i++) {
		mass[i] = w->line->mass[i];
		mass[i].mass += lambda*w->P[i]/line.g;
	}
	line.mass = mass;
	if (hawser_line_solve(&st, &line, &report)) {
		ok(0, "statics at %g: %s", lambda, report.message);
		return NAN;
	}
	for (int i = 0; i < line.masses; i++)
		sum += w->P[i]*st.carrier[i].x[1];
	hawser_line_statics_clear(&st);
	return sum;
}

/* coefficient[4] of Y by lambda^0 to lambda^3, from 6 differences with step h: errors of h^6. */
static void series(double coefficient[4], const struct weights *w, double h)
{
	double even[3], odd[3], middle = work_of(w, 0.0);

	for (int i = 0; i < 3; i++) {
		double s = h*(i + 1), up = work_of(w, s), down = work_of(w, -s);

		even[i] = (0.5*(up + down) - middle)/(s*s);
		odd[i] = 0.5*(up - down)/s;
	}
	coefficient[0] = middle;
	/* values of c0 + c2 s^2 + c4 s^4 at s = h, 2h, 3h */
	coefficient[1] = 1.5*odd[0] - 0.6*odd[1] + 0.1*odd[2];
	coefficient[2] = 1.5*even[0] - 0.6*even[1] + 0.1*even[2];
	coefficient[3] = (-13.0/24.0*odd[0] + 2.0/3.0*odd[1] - 0.125*odd[2])/(h*h);
}

/* The system in the plane with a mass on which a weight acts; of a rope that sticks each span is one
 * system. */
static int system_in_plane(const struct hawser__lmode *rope, const double *P)
{
	for (int i = 0; i < rope->systems; i++)
		for (int k = 0; rope->system[i].plane == HAWSER_IN_PLANE && k < rope->system[i].segments; k++) {
			int mass = rope->system[i].segment[k].piece->mass;

			if (mass >= 0 && P[mass] != 0.0)
				return i;
		}
	return -1;
}

static void load_nodes(double *load, const struct hawser__lmode *rope, int own, const double *P)
{
	const struct hawser__lmode_system *system = &rope->system[own];

	for (int i = 0; i < system->segments; i++) {
		const struct hawser__lmode_segment *s = &system->segment[i];
		const double *r = s->piece->reference;
		double angle = atan2(r[1], r[0]), P_i;
		struct hawser__lmode_joint joint;

		if (s->piece->mass < 0 || s->index == 0 || s->node[0] < 0)
			continue;
		P_i = P[s->piece->mass]/rope->force;
		joint = hawser__lmode_joint(rope, 0, s->index);
		if (joint.sheave >= 0) {
			load[system->node[s->node[0]].at] = -P_i*sin(joint.tangent[0]);
			continue;
		}
		load[system->node[s->node[0]].at] = -P_i*sin(angle);
		load[system->node[s->node[0]].at + 1] = -P_i*cos(angle);
	}
}

/* Second, third and fourth coefficients of E by the model; held: without motion of the points of
 * contact. */
static int model(double E[3], const struct hawser_line_statics *st, const double *P,
                 enum hawser_line_contact_kind contact, int held)
{
	struct hawser_line_modes_options o = {.n = 1, .tolerance = 1e-9, .contact = contact};
	const struct hawser_line_statics *lane[1] = {st};
	struct hawser__lmode rope = {.systems = 0};
	struct hawser__lexpand t = {.rope = NULL};
	struct hawser_report report = {0};
	enum hawser_status status = hawser__lmode_open(&rope, lane, 1, &o, 0.0, &report);
	const int index[4] = {0};
	double *x = NULL, *strain = NULL, *load = NULL, unit;
	int own = system_in_plane(&rope, P);

	for (int i = 0; i < rope.systems && !status; i++) {
		status = hawser__lmode_grids(&rope.system[i], &rope, 1.0, 4, &report);
		if (!status)
			status = hawser__lmode_factor(&rope.system[i], &report);
	}
	if (!status) {
		struct hawser__lexpand_shape shape = {.system = own};
		struct hawser__lmode_system *system = &rope.system[own];

		x = calloc((size_t)system->size, sizeof *x);
		strain = calloc((size_t)system->strains, sizeof *strain);
		load = calloc((size_t)system->size, sizeof *load);
		load_nodes(load, &rope, own, P);
		hawser__lmode_static(x, strain, system, load);
		shape.x = x;
		shape.strain = strain;
		unit = rope.force*rope.length;
		E[0] = -0.5*hawser__lmode_stiffness(x, strain, x, strain, system)*unit;
		status = hawser__lexpand_open(&t, &rope, &shape, 1, held, &report);
		if (!status) {
			E[1] = t.third[0]/6.0*unit;
			E[2] = hawser__lexpand_fourth(&t, index)/24.0*unit;
		}
		hawser__lexpand_clear(&t);
	}
	free(x);
	free(strain);
	free(load);
	hawser__lmode_clear(&rope);
	return ok(!status, "model: %s", report.message);
}

/* Weights on all masses but for those on circles: the work of those would not be linear. */
static void compare(struct hawser_line *line, double h, const char *what, double tolerance4)
{
	struct hawser_line_statics st;
	struct hawser_report report = {0};
	struct hawser_line fixed = *line;
	double Y[4], E[3], held[3], P[MASSES];
	const struct weights w = {&fixed, P};

	if (!ok(!hawser_line_solve(&st, line, &report), "%s: statics %s", what, report.message))
		return;
	for (int i = 0; i < line->masses; i++) {
		int on = st.carrier[i].state > 0;

		P[i] = on ? 0.0 : 100.0*sin(1.7*i + 0.4);
		if (on)
			printf("# mass %d is in state %d, carried %g N\n", i + 1, st.carrier[i].state,
			       st.carrier[i].carried);
	}
	fixed.given = HAWSER_LINE_LENGTH0;
	fixed.value = st.length0;
	series(Y, &w, h);
	if (model(E, &st, P, HAWSER_LINE_SLIP, 0) && model(held, &st, P, HAWSER_LINE_SLIP, 1)) {
		printf("# %s: second %.8g %.8g, third %.8g %.8g (held %.8g), fourth %.8g %.8g (held %.8g)\n",
		       what, 0.5*Y[1], E[0], Y[2]/3.0, E[1], held[1], Y[3]/4.0, E[2], held[2]);
		close_to(E[0], 0.5*Y[1], 1e-8, "second order");
		close_to(E[1], Y[2]/3.0, 1e-6, "third order");
		close_to(E[2], Y[3]/4.0, tolerance4, "fourth order");
	}
	hawser_line_statics_clear(&st);
}

/* --- a rope that sticks --- */

/* The free rope behind the only sheave, as a line of its own from the point at which it leaves it,
 * fixed there; under more weight it lies down on the circle. */
struct run {
	struct hawser_line line;
	struct hawser_line_mass mass[MASSES];
	struct hawser_line_sheave sheave;
};

/* P[..] of the masses on it are moved to the first ones. */
static void take_run(struct run *run, double *P, const struct hawser_line_statics *st)
{
	int i = st->pieces - 1;

	while (st->piece[i - 1].sheave < 0)
		i--;
	run->line = *st->line;
	run->line.mass = run->mass;
	run->line.masses = 0;
	run->line.sheave = &run->sheave;
	run->line.lift = 1;
	run->line.given = HAWSER_LINE_LENGTH0;
	run->line.value = 0.0;
	run->sheave = st->line->sheave[0];
	run->sheave.radius *= 1.0 - 1e-12; /* the end is on it, not inside */
	run->line.A[0] = st->piece[i].x0[0];
	run->line.A[1] = st->piece[i].x0[1];
	for (; i < st->pieces; i++) {
		if (st->piece[i].mass >= 0) {
			P[run->line.masses] = P[st->piece[i].mass];
			run->mass[run->line.masses] = st->line->mass[st->piece[i].mass];
			run->mass[run->line.masses++].S = run->line.value;
		}
		run->line.value += st->piece[i].S1 - st->piece[i].S0;
	}
}

/* As `series`, from lambda >= 0 alone: Newton's forward differences. */
static void series_forward(double c[4], const struct weights *w, double h)
{
	double d[6];

	for (int i = 0; i < 6; i++)
		d[i] = work_of(w, i*h);
	c[0] = d[0];
	for (int k = 1; k < 6; k++)
		for (int i = 5; i >= k; i--)
			d[i] -= d[i - 1];
	c[1] = (d[1] - d[2]/2.0 + d[3]/3.0 - d[4]/4.0 + d[5]/5.0)/h;
	c[2] = (d[2]/2.0 - d[3]/2.0 + 11.0/24.0*d[4] - 5.0/12.0*d[5])/(h*h);
	c[3] = (d[3]/6.0 - d[4]/4.0 + 7.0/24.0*d[5])/(h*h*h);
}

static void stuck(const struct hawser_line *of, double h)
{
	struct hawser_line one = *of, *line = &one;
	struct hawser_line_statics st;
	struct hawser_report report = {0};
	struct run run;
	double Y[4], E[3], held[3], P[MASSES] = {0.0}, own[MASSES];

	one.sheaves = 1;
	one.sheave = of->sheave + 1; /* behind it the rope rises: the end is left of its centre */
	if (!ok(!hawser_line_solve(&st, line, &report), "stick: statics %s", report.message))
		return;
	for (int i = 0; i < line->masses; i++)
		if (st.carrier[i].state == 0 && st.carrier[i].x[0] > 190.0)
			P[i] = 100.0 + 30.0*sin(1.7*i + 0.4);
	for (int i = 0; i < MASSES; i++)
		own[i] = P[i];
	take_run(&run, own, &st);
	series_forward(Y, &(struct weights){&run.line, own}, h);
	if (model(E, &st, P, HAWSER_LINE_STICK, 0) && model(held, &st, P, HAWSER_LINE_STICK, 1)) {
		printf("# stick: second %.8g %.8g, third %.8g %.8g (held %.8g), fourth %.8g %.8g\n", 0.5*Y[1],
		       E[0], Y[2]/3.0, E[1], held[1], Y[3]/4.0, E[2]);
		close_to(E[0], 0.5*Y[1], 1e-7, "second order, stick");
		close_to(E[1], Y[2]/3.0, 1e-5, "third order, stick");
		close_to(E[2], Y[3]/4.0, 1e-3, "fourth order, stick");
	}
	hawser_line_statics_clear(&st);
}

/* 1 if a mass is in the state with the masses at this phase. */
static int has_state(const struct hawser_line *line, struct hawser_line_mass *mass, double phase,
                     int state)
{
	struct hawser_line_statics st;
	struct hawser_report report = {0};
	int found = 0;

	for (int i = 0; i < line->masses; i++)
		mass[i].S = phase + 36.6*i;
	if (hawser_line_solve(&st, line, &report))
		return 0;
	for (int i = 0; i < line->masses; i++)
		found |= st.carrier[i].state == state;
	hawser_line_statics_clear(&st);
	return found;
}

/* Place the masses at the middle of the first phases at which one is in the state: small weights do not
 * change it there. 0: there are none. */
static int seek(const struct hawser_line *line, struct hawser_line_mass *mass, double from, int state)
{
	const double step = 0.02;
	int run = 0, k = 0;

	for (; k < 1000 && (run == 0 || has_state(line, mass, from + step*k, state)); k++)
		run += run > 0 || has_state(line, mass, from + step*k, state);
	if (!ok(run > 1 && k < 1000, "%d phases with a mass in state %d", run, state))
		return 0;
	return has_state(line, mass, from + step*(k - 0.5*run), state);
}

CASE(property_line_expand)
{
	struct hawser_line_sheave sheave[3] = {{.centre = {80.0, 5.0}, .radius = 12.0, .side = 1},
	                                       {.centre = {190.0, 28.0}, .radius = 12.0, .side = 1}};
	struct hawser_line_mass mass[MASSES];
	struct hawser_line line = {.EA = 40e6, .rho = 4.0, .g = 9.81, .B = {300.0, 58.0},
	                           .given = HAWSER_LINE_T_A, .value = 84e3, .sheave = sheave, .sheaves = 2,
	                           .mass = mass, .masses = 8};

	for (int i = 0; i < 8; i++)
		mass[i] = (struct hawser_line_mass){.S = 18.3 + 36.6*i, .mass = 400.0};
	compare(&line, 2.0, "two towers", 2e-5);
	stuck(&line, 1.0);
	sheave[0].radius = sheave[1].radius = 40.0;
	sheave[0].centre[1] -= 28.0;
	sheave[1].centre[1] -= 28.0;
	/* of the fourth order the weight over the length by which the point of contact moves is left
	 * out */
	compare(&line, 2.0, "large radius", 1e-3);
	sheave[0].radius = sheave[1].radius = 12.0;
	sheave[0].centre[1] += 28.0;
	sheave[1].centre[1] += 28.0;
	for (int state = 1; state <= 3; state++)
		if (seek(&line, mass, 3.0, state))
			compare(&line, 2.0, state == 1 ? "a mass at the first point of contact"
			        : state == 2 ? "a mass on a tower" : "a mass at the last point of contact", 2e-5);
	/* the lowest part of the line of B Table 6.2: a carrier hangs between two arcs of the first
	 * sheave */
	sheave[0] = (struct hawser_line_sheave){.centre = {40.0, 12.0}, .radius = 12.0, .side = -1};
	sheave[1] = (struct hawser_line_sheave){.centre = {79.71, 4.86}, .radius = 12.0, .side = 1};
	line.A[0] = 25.0;
	line.B[0] = 146.56;
	line.B[1] = 41.03;
	for (int i = 0; i < 4; i++)
		mass[i] = (struct hawser_line_mass){.S = 20.0 + 36.6*i, .mass = 400.0};
	line.masses = 3;
	compare(&line, 2.0, "a carrier under a compression battery", 2e-2);
	line.rho = 0.04;
	compare(&line, 2.0, "the same of a light rope", 2e-5);
	return done_testing();
}

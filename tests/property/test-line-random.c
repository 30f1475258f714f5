/* Statics of random lines: whatever is returned is an equilibrium (balance, no pull by a sheave,
 * no rope inside a sheave, and the differential equations integrated step by step from A to B), a
 * refusal states the least tension, and other ways to ask have an answer too. The tension at B may
 * belong to several equilibria: with another tension other masses hang in other spans.
 *
 * HAWSER_LONG: 10 000 lines instead of 60.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "config.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/line-random.h"
#include "tests/tap.h"

static double size_of(const struct hawser_line *line)
{
	return fabs(line->B[0]) + fabs(line->B[1]);
}

/* What is wrong with an equilibrium; NULL: nothing. */
static const char *wrong(const struct hawser_line_statics *st)
{
	const struct hawser_line *line = st->line;
	double size = size_of(line), T = fmax(st->T_A, st->T_B), S = 0.0;

	for (int i = 0; i < st->pieces; i++)
		T = fmax(T, fmax(st->piece[i].T0, st->piece[i].T1));
	if (!(st->closure <= 1e-12*size))
		return "it does not close";
	if (!(st->balance <= 1e-11*T))
		return "its forces do not balance";
	for (int i = 0; i < line->masses; i++)
		if (st->carrier[i].present && st->carrier[i].carried < -1e-10*T)
			return "a sheave pulls a mass";
	for (int k = 0; k < line->sheaves; k++) {
		const struct hawser_line_contact *c = &st->contact[k];

		if (c->touches && (c->wrap < 0.0 || c->pressure_min < -1e-10*T))
			return "a sheave pulls the rope";
		if (!c->touches && c->clearance < -1e-9*size)
			return "the rope is in a sheave without contact";
		if (c->touches && !(c->T_out >= c->T_out_min*(1.0 - 1e-9) &&
		                    c->T_out <= c->T_out_max*(1.0 + 1e-9)))
			return "the tension is beyond friction";
	}
	for (int i = 0; i < st->pieces; i++) {
		const struct hawser_line_piece *piece = &st->piece[i];

		if (piece->S0 != S || !(piece->S1 > piece->S0))
			return "its pieces do not follow each other";
		S = piece->S1;
	}
	return S == st->length0 || fabs(S - st->length0) <= 1e-14*S ? NULL : "its pieces are not the rope";
}

/* The deepest place of the rope in a sheave, m. */
static double inside(const struct hawser_line_statics *st, int places)
{
	const struct hawser_line *line = st->line;
	double worst = 0.0;

	for (int i = 0; i < st->pieces; i++)
		for (int j = 0; j < places; j++) {
			const struct hawser_line_piece *piece = &st->piece[i];
			double x[2];

			hawser_line_at(st, x, NULL, NULL, NULL, NULL,
			               piece->S0 + (piece->S1 - piece->S0)*j/places);
			for (int k = 0; k < line->sheaves; k++) {
				const struct hawser_line_sheave *s = &line->sheave[k];

				worst = fmax(worst, s->radius - hypot(x[0] - s->centre[0], x[1] - s->centre[1]));
				if (fabs(x[0] - s->centre[0]) < 0.1*s->radius && s->side*(x[1] - s->centre[1]) < 0.0)
					return INFINITY; /* on the wrong side */
			}
		}
	return worst;
}

/* State of the step-by-step integration: x, y, and the vector P = (T - rho v^2 |x'|) e. */
struct state {
	double x[2], P[2];
};

static double tension(const struct hawser_line *line, const double P[2])
{
	double thrust = line->rho*line->speed*line->speed;

	return (hypot(P[0], P[1]) + thrust)/(1.0 - thrust/line->EA);
}

/* Derivatives by S: of the free rope, or of rope on a sheave, which presses it by its curvature. */
static struct state slope_of(const struct hawser_line *line, const struct state *s, int sheave)
{
	double P = hypot(s->P[0], s->P[1]), g = 1.0 + tension(line, s->P)/line->EA, N, m;
	double t[2] = {s->P[0]/P, s->P[1]/P}, w = line->rho*line->g, side;
	struct state d = {{g*t[0], g*t[1]}, {0.0, w}};

	if (sheave < 0)
		return d;
	side = line->sheave[sheave].side;
	m = line->sliding == HAWSER_LINE_NONE ? 0.0 : line->sliding == HAWSER_LINE_TOWARD_B
	    ? line->sheave[sheave].friction : -line->sheave[sheave].friction;
	N = P*g/line->sheave[sheave].radius + side*w*t[0];
	d.P[0] -= N*(-side*t[1] - m*t[0]);
	d.P[1] -= N*(side*t[0] - m*t[1]);
	return d;
}

static void add(struct state *s, const struct state *d, double h)
{
	for (int k = 0; k < 2; k++) {
		s->x[k] += h*d->x[k];
		s->P[k] += h*d->P[k];
	}
}

/* Runge and Kutta's method of order 4. */
static void integrate(struct state *s, const struct hawser_line *line, int sheave, double length,
                      int steps)
{
	double h = length/steps;

	for (int i = 0; i < steps; i++) {
		struct state k1 = slope_of(line, s, sheave), k2, k3, k4, at = *s;

		add(&at, &k1, h/2.0);
		k2 = slope_of(line, &at, sheave);
		at = *s;
		add(&at, &k2, h/2.0);
		k3 = slope_of(line, &at, sheave);
		at = *s;
		add(&at, &k3, h);
		k4 = slope_of(line, &at, sheave);
		add(s, &k1, h/6.0);
		add(s, &k2, h/3.0);
		add(s, &k3, h/3.0);
		add(s, &k4, h/6.0);
	}
}

/* Weight of a mass, and the force of the sheave at it. */
static void kink(struct state *s, const struct hawser_line_statics *st, int mass)
{
	const struct hawser_line *line = st->line;
	const struct hawser_line_carrier *c = &st->carrier[mass];
	double N = c->carried, n[2], m;

	s->P[1] += line->mass[mass].mass*line->g;
	if (c->sheave < 0 || N == 0.0)
		return;
	for (int k = 0; k < 2; k++)
		n[k] = (c->x[k] - line->sheave[c->sheave].centre[k])/line->sheave[c->sheave].radius;
	m = line->sliding == HAWSER_LINE_NONE ? 0.0 : line->sliding == HAWSER_LINE_TOWARD_B
	    ? line->sheave[c->sheave].friction : -line->sheave[c->sheave].friction;
	s->P[0] -= N*(n[0] - m*n[1]);
	s->P[1] -= N*(n[1] + m*n[0]);
}

/* How far the integration from A, through the places at which contacts and masses begin and end,
 * is from B and from the tension there, over size and tension. Lines with points as sheaves are
 * left out. */
static double integrated(const struct hawser_line_statics *st, int steps)
{
	const struct hawser_line *line = st->line;
	double thrust = line->rho*line->speed*line->speed, P = st->T_A*(1.0 - thrust/line->EA) - thrust;
	struct state s = {{line->A[0], line->A[1]}, {P*cos(st->angle_A), P*sin(st->angle_A)}};

	for (int i = 0; i < st->pieces; i++) {
		if (st->piece[i].mass >= 0)
			kink(&s, st, st->piece[i].mass);
		integrate(&s, line, st->piece[i].sheave, st->piece[i].S1 - st->piece[i].S0, steps);
	}
	return fmax(hypot(s.x[0] - line->B[0], s.x[1] - line->B[1])/size_of(line),
	            fabs(tension(line, s.P)/st->T_B - 1.0));
}

static int has_points(const struct hawser_line *line)
{
	return line->sheaves && line->sheave[0].radius == 0.0;
}

/* Largest difference of two solutions of the same line, over the tension. */
static double apart(const struct hawser_line_statics *a, const struct hawser_line_statics *b)
{
	double worst = fmax(fabs(a->T_A - b->T_A), fabs(a->T_B - b->T_B))/a->T_A;

	for (int k = 0; k < a->line->sheaves; k++)
		for (int i = 0; i < 2; i++)
			worst = fmax(worst, fabs(a->contact[k].force[i] - b->contact[k].force[i])/a->T_A);
	return worst;
}

/* The same line from its other end. */
static void mirror(struct line_random *to, const struct line_random *from,
                   const struct hawser_line_statics *st)
{
	int n = from->line.sheaves, count = 0;

	*to = *from;
	to->line.sheave = to->sheave;
	to->line.mass = to->mass;
	to->line.A[0] = -from->line.B[0];
	to->line.A[1] = from->line.B[1];
	to->line.B[0] = -from->line.A[0];
	to->line.B[1] = from->line.A[1];
	for (int k = 0; k < n; k++) {
		to->sheave[k] = from->sheave[n - 1 - k];
		to->sheave[k].centre[0] *= -1.0;
	}
	for (int i = from->line.masses - 1; i >= 0; i--)
		if (from->mass[i].S < st->length0) {
			to->mass[count] = from->mass[i];
			to->mass[count++].S = st->length0 - from->mass[i].S;
		}
	to->line.masses = count;
	to->line.sliding = from->line.sliding == HAWSER_LINE_NONE ? HAWSER_LINE_NONE
	                   : from->line.sliding == HAWSER_LINE_TOWARD_A ? HAWSER_LINE_TOWARD_B
	                   : HAWSER_LINE_TOWARD_A;
	to->line.given = HAWSER_LINE_T_A;
	to->line.value = st->T_B;
}

struct tally {
	int solved, refused, failed, lifted, wrong, other, others;
	double deepest, integrated, end, mirrored, pressed, length;
};

/* The line that is given by another quantity of its solution. */
static void other_givens(struct tally *tally, const struct line_random *r,
                         const struct hawser_line_statics *st)
{
	struct hawser_report report;
	struct hawser_line_statics other;
	struct line_random back;
	struct hawser_line line = r->line;

	mirror(&back, r, st);
	if (!hawser_line_solve(&other, &back.line, &report)) {
		tally->mirrored = fmax(tally->mirrored, fabs(other.T_B/st->T_A - 1.0));
		hawser_line_statics_clear(&other);
	} else {
		tally->other++;
	}
	line.given = HAWSER_LINE_T_B;
	line.value = st->T_B;
	if (!hawser_line_solve(&other, &line, &report)) {
		tally->wrong += wrong(&other) != NULL;
		tally->others += apart(st, &other) > 1e-7;
		tally->end = fmax(tally->end, fabs(other.T_B/st->T_B - 1.0));
		hawser_line_statics_clear(&other);
	} else {
		tally->other++;
	}
	line.given = HAWSER_LINE_LENGTH0;
	line.value = st->length0;
	while (line.masses && line.mass[line.masses - 1].S > line.value)
		line.masses--;
	if (!hawser_line_solve(&other, &line, &report)) {
		tally->wrong += wrong(&other) != NULL;
		tally->length = fmax(tally->length, fabs(other.length0/st->length0 - 1.0));
		hawser_line_statics_clear(&other);
	} else {
		tally->other++;
	}
}

/* The same line with the sheaves that the rope presses, and no others. */
static void only_pressed(struct tally *tally, const struct line_random *r,
                         const struct hawser_line_statics *st)
{
	struct hawser_line_statics other;
	struct line_random fewer = *r;
	struct hawser_report report;
	int count = 0;

	for (int k = 0; k < r->line.sheaves; k++)
		if (st->contact[k].touches)
			fewer.sheave[count++] = r->sheave[k];
	if (count < r->line.sheaves) {
		struct hawser_line line = r->line;

		line.lift = 0;
		if (hawser_line_solve(&other, &line, &report) != HAWSER_ERR_NO_SOLUTION ||
		    !strstr(report.message, "lifts off"))
			tally->other++;
	}
	fewer.line.sheave = fewer.sheave;
	fewer.line.mass = fewer.mass;
	fewer.line.sheaves = count;
	fewer.line.lift = 0;
	if (hawser_line_solve(&other, &fewer.line, &report)) {
		tally->other++;
		return;
	}
	tally->pressed = fmax(tally->pressed, fabs(other.T_B/st->T_B - 1.0));
	hawser_line_statics_clear(&other);
}

/* A tension that is too low: the least one that the report states is right to 1e-6. */
static int least_is_right(struct line_random *r, const char *message)
{
	const char *at = strstr(message, "at least ");
	struct hawser_report report;
	struct hawser_line_statics st;
	double least = at ? strtod(at + 9, NULL) : 0.0;

	if (!(least > r->line.value*(1.0 - 1e-9)))
		return 0;
	r->line.value = least*(1.0 + 1e-6);
	if (hawser_line_solve(&st, &r->line, &report) || wrong(&st))
		return 0;
	hawser_line_statics_clear(&st);
	r->line.value = least*(1.0 - 1e-6);
	if (hawser_line_solve(&st, &r->line, &report))
		return 1;
	hawser_line_statics_clear(&st);
	return 0;
}

static void one(struct tally *tally, int number)
{
	struct line_random r;
	struct hawser_line_statics st;
	struct hawser_report report;
	enum hawser_status status;
	const char *what;

	line_random(&r, number);
	status = hawser_line_solve(&st, &r.line, &report);
	if (status == HAWSER_ERR_NO_SOLUTION && strstr(report.message, "too low")) {
		tally->refused++;
		if (number%5 == 0 && !least_is_right(&r, report.message)) {
			printf("# line %d: %s\n", number, report.message);
			tally->wrong++;
		}
		return;
	}
	if (status) {
		printf("# line %d: %s\n", number, report.message);
		tally->failed++;
		return;
	}
	tally->solved++;
	what = wrong(&st);
	if (what) {
		printf("# line %d: %s\n", number, what);
		tally->wrong++;
	}
	for (int k = 0; k < r.line.sheaves; k++)
		if (!st.contact[k].touches) {
			tally->lifted++;
			break;
		}
	tally->deepest = fmax(tally->deepest, inside(&st, 8)/size_of(&r.line));
	if (!has_points(&r.line)) {
		double miss = integrated(&st, 60);

		if (miss > 1e-6)
			miss = integrated(&st, 2000);
		tally->integrated = fmax(tally->integrated, miss);
	}
	if (number%3 == 0)
		only_pressed(tally, &r, &st);
	if (number%5 == 0)
		other_givens(tally, &r, &st);
	hawser_line_statics_clear(&st);
}

int main(int argc, char **argv)
{
	struct tally tally = {0};
	int count = getenv("HAWSER_LONG") ? 10000 : 60, first = argc > 1 ? atoi(argv[1]) : 0;

	if (argc > 2)
		count = first + atoi(argv[2]);
	for (int number = first; number < count; number++)
		one(&tally, number);
	ok(tally.failed == 0, "%d lines solved (%d with sheaves without contact), %d with too low a "
	   "tension, %d failed", tally.solved, tally.lifted, tally.refused, tally.failed);
	ok(tally.wrong == 0, "%d that are no equilibria", tally.wrong);
	ok(tally.deepest <= 1e-11, "rope in sheaves: %.1e of the line's size at most", tally.deepest);
	ok(tally.integrated <= 1e-7, "integration step by step: %.1e", tally.integrated);
	ok(tally.other == 0, "%d failures of other ways to ask", tally.other);
	ok(tally.pressed <= 1e-11, "without the sheaves that are not pressed: %.1e", tally.pressed);
	ok(tally.end <= 1e-9, "given the tension at B: %.1e (%d have another equilibrium with it)",
	   tally.end, tally.others);
	ok(tally.length <= 1e-9, "given the length: %.1e", tally.length);
	ok(tally.mirrored <= 1e-9, "from the other end: %.1e", tally.mirrored);
	return done_testing();
}

/* The continuation loop on plane curves F(x, y) = 0 of known shape. Each is followed in both
 * directions with the settings of every kind of curve; it must stay on the curve, pass its folds,
 * reach its end, and have its length. Failures, interruptions and refinements are provoked.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "continuation/curve.h"
#include "continuation/metric.h"
#include "tests/tap.h"

#define TOLERANCE 1e-12

/* F and its gradient. */
typedef double curve_function(double gradient[2], const double u[2]);

struct plane_curve {
	const char *name;
	curve_function *F;
	void (*at)(double u[2], double s); /* points of the curve, s from 0 to 1; closed if both ends
	                                    * are equal */
	int folds; /* number of points at which x turns back */
};

struct owner {
	const struct plane_curve *is;
	double u[2], t[2], next[2], turn[2], start[2], target[2];
	double longest, worst, arc;
	int points, folds, limit;
	int stop_after;  /* steps; 0: never */
	int fail_below;  /* the corrector fails beyond x = 0.5 until the discretisation is refined */
	int refined, no_finer;
};

static double circle(double g[2], const double u[2])
{
	g[0] = 2.0*u[0];
	g[1] = 2.0*u[1];
	return u[0]*u[0] + u[1]*u[1] - 1.0;
}

/* Two folds, as in a response with a jump. */
static double cubic(double g[2], const double u[2])
{
	g[0] = 1.0;
	g[1] = -3.0*u[1]*u[1] + 1.0;
	return u[0] - u[1]*u[1]*u[1] + u[1];
}

static double line(double g[2], const double u[2])
{
	g[0] = 1.0;
	g[1] = -1.0;
	return u[0] - u[1];
}

/* A bend of radius 1e-3, between two straight parts. */
static double bend(double g[2], const double u[2])
{
	double e = 1e-3, r = sqrt(u[0]*u[0] + e*e);

	g[0] = -u[0]/r;
	g[1] = 1.0;
	return u[1] - r;
}

static void on_circle(double u[2], double s)
{
	double angle = 1.0 + 2.0*M_PI*(s == 1.0 ? 0.0 : s);

	u[0] = cos(angle);
	u[1] = sin(angle);
}

static void on_cubic(double u[2], double s)
{
	u[1] = 3.0*s - 1.5;
	u[0] = u[1]*u[1]*u[1] - u[1];
}

static void on_line(double u[2], double s)
{
	u[0] = u[1] = 3.0*s - 1.0;
}

static void on_bend(double u[2], double s)
{
	u[0] = 2.0*s - 1.0;
	u[1] = sqrt(u[0]*u[0] + 1e-6);
}

static const double unit[2] = {1.0, 1.0};
static const struct hawser__metric plane = {2, unit};

static enum hawser_status prepare(void *context, int *ended)
{
	struct owner *owner = context;

	*ended = owner->points >= owner->limit;
	return HAWSER_OK;
}

static int interrupted(void *context, int tries)
{
	const struct owner *owner = context;

	return tries == 0 && owner->stop_after > 0 && owner->points >= owner->stop_after;
}

static int predict(void *context, double ds)
{
	struct owner *owner = context;

	for (int k = 0; k < 2; k++)
		owner->next[k] = owner->u[k] + ds*owner->t[k];
	return 0;
}

/* Newton's method in the line normal to row; returns 1 if it fails. */
static int newton(curve_function *F, double u[2], const double row[2],
                  struct hawser__correction *correction)
{
	double before = 0.0;

	*correction = (struct hawser__correction){0};
	for (int i = 1; i <= 8; i++) {
		double g[2], f = F(g, u), det = g[0]*row[1] - g[1]*row[0], length;

		u[0] -= f*row[1]/det;
		u[1] += f*row[0]/det;
		length = fabs(f/det);
		correction->iterations = i;
		correction->residual = fabs(F(g, u));
		if (i == 1)
			correction->first = length;
		if (i == 2)
			correction->contraction = length/before;
		if (!isfinite(length) || (before > 0.0 && length > 0.5*before && length > TOLERANCE))
			return 1;
		if (correction->residual <= TOLERANCE)
			return 0;
		before = length;
	}
	return 1;
}

static enum hawser_status correct(void *context, double ds, struct hawser__correction *correction,
                                  int *failed)
{
	struct owner *owner = context;

	(void)ds;
	*failed = newton(owner->is->F, owner->next, owner->t, correction) ||
	          (owner->fail_below && !owner->refined && owner->next[0] > 0.5);
	return HAWSER_OK;
}

static enum hawser_status refine(void *context, double ds, double *factor)
{
	struct owner *owner = context;

	*factor = 0.0;
	if (!owner->fail_below || owner->no_finer || owner->refined || ds > 1e-4)
		return HAWSER_OK;
	owner->refined = 1;
	*factor = 100.0;
	return HAWSER_OK;
}

static void tangent(const struct plane_curve *is, double t[2], const double u[2], const double side[2])
{
	double g[2], length, sense;

	is->F(g, u);
	length = hypot(g[0], g[1]);
	sense = -g[1]*side[0] + g[0]*side[1] < 0.0 ? -1.0 : 1.0;
	t[0] = -sense*g[1]/length;
	t[1] = sense*g[0]/length;
}

static enum hawser_status finish(void *context, double ds, double *angle)
{
	struct owner *owner = context;

	(void)ds;
	tangent(owner->is, owner->turn, owner->next, owner->t);
	*angle = hawser__metric_angle(&plane, owner->t, owner->turn);
	return HAWSER_OK;
}

static enum hawser_status judge(void *context, double ds, double angle, enum hawser__verdict *verdict)
{
	(void)context;
	(void)ds;
	*verdict = angle > 0.4 ? HAWSER__SHORTEN : HAWSER__KEEP;
	return HAWSER_OK;
}

static double longest(void *context)
{
	return ((const struct owner *)context)->longest;
}

static enum hawser_status arrive(void *context, enum hawser__arrival *arrival, double taken, double *ds)
{
	struct owner *owner = context;
	const struct hawser__node a = {owner->u, owner->t}, b = {owner->next, owner->turn};
	double g[2], share, y[2], d[2];
	int there = owner->points > 3 &&
	            hawser__curve_passes(&share, owner->target, &a, &b, taken, 0.02, y, d, &plane);

	(void)ds;
	if (there) {
		memcpy(owner->next, owner->target, sizeof owner->next);
		tangent(owner->is, owner->turn, owner->next, owner->t);
	}
	owner->arc += hawser__arc_between(&plane, &a, &b);
	owner->worst = fmax(owner->worst, fabs(owner->is->F(g, owner->next)));
	owner->folds += owner->t[0]*owner->turn[0] < 0.0;
	owner->points++;
	memcpy(owner->u, owner->next, sizeof owner->u);
	memcpy(owner->t, owner->turn, sizeof owner->t);
	*arrival = there ? HAWSER__AT_END : HAWSER__GO_ON;
	return HAWSER_OK;
}

static const struct hawser__curve_ops ops = {
	.prepare = prepare, .interrupted = interrupted, .predict = predict, .correct = correct,
	.refine = refine, .finish = finish, .judge = judge, .longest = longest, .arrive = arrive
};

static struct owner begin(const struct plane_curve *is, int back, double step)
{
	struct owner owner = {.is = is, .points = 1, .limit = 20000, .longest = step};
	double ahead[2], side[2];

	is->at(owner.u, back ? 1.0 : 0.0);
	is->at(owner.target, back ? 0.0 : 1.0);
	is->at(ahead, back ? 1.0 - 1e-6 : 1e-6);
	for (int k = 0; k < 2; k++)
		side[k] = ahead[k] - owner.u[k];
	tangent(is, owner.t, owner.u, side);
	return owner;
}

static enum hawser__outcome follow(struct owner *owner, const struct hawser__step_settings *settings)
{
	struct hawser__curve curve = {.ops = &ops, .settings = settings, .owner = owner, .ds = 1e-3};
	enum hawser__outcome outcome;

	ok(hawser__curve_follow(&curve, &outcome) == HAWSER_OK, "%s is followed", owner->is->name);
	return outcome;
}

static const struct plane_curve battery[] = {
	{"circle", circle, on_circle, 2}, {"cubic", cubic, on_cubic, 2}, {"line", line, on_line, 0},
	{"bend", bend, on_bend, 0}
};

/* By chords. */
static double length_of(const struct plane_curve *is)
{
	enum { CHORDS = 200000 };
	double a[2], b[2], sum = 0.0;

	is->at(a, 0.0);
	for (int i = 1; i <= CHORDS; i++) {
		is->at(b, (double)i/CHORDS);
		sum += hypot(b[0] - a[0], b[1] - a[1]);
		memcpy(a, b, sizeof a);
	}
	return sum;
}

static void check_battery(void)
{
	static const struct hawser__step_settings *const settings[] = {
		&hawser__frf_steps, &hawser__folds_steps, &hawser__backbone_steps, &hawser__boundary_steps,
		&hawser__torus_steps
	};

	for (size_t c = 0; c < sizeof battery/sizeof *battery; c++)
		for (size_t k = 0; k < sizeof settings/sizeof *settings; k++)
			for (int back = 0; back < 2; back++) {
				struct owner owner = begin(&battery[c], back, 0.1);
				enum hawser__outcome outcome = follow(&owner, settings[k]);

				ok(outcome == HAWSER__ENDED && owner.points < owner.limit,
				   "%s, settings %zu, %s: to its end, %d points", battery[c].name, k,
				   back ? "back" : "on", owner.points);
				ok(owner.worst <= 1e-10, "on the curve to %.1e", owner.worst);
				ok(owner.folds == battery[c].folds, "%d folds", owner.folds);
				close_to(owner.arc, length_of(&battery[c]), 2e-3, "length");
			}
}

/* The sum of the steps approaches the arclength as the longest step decreases: its error is of
 * fourth order. */
static void check_arcs(void)
{
	double error[2];

	for (int i = 0; i < 2; i++) {
		struct owner owner = begin(&battery[0], 0, i ? 0.05 : 0.1);

		follow(&owner, &hawser__frf_steps);
		error[i] = fabs(owner.arc - 2.0*M_PI);
	}
	ok(error[1] < error[0]/12.0 && error[1] > 0.0, "arc of the circle: %.1e, then %.1e", error[0],
	   error[1]);
}

static void check_ends(void)
{
	struct owner owner = begin(&battery[1], 0, 0.1);

	owner.stop_after = 7;
	ok(follow(&owner, &hawser__frf_steps) == HAWSER__INTERRUPTED && owner.points == 7,
	   "interrupted after 7 points (%d)", owner.points);
	owner = begin(&battery[1], 0, 0.1);
	owner.limit = 11;
	ok(follow(&owner, &hawser__frf_steps) == HAWSER__ENDED && owner.points == 11,
	   "11 points and no more (%d)", owner.points);
	owner = begin(&battery[2], 0, 0.1);
	owner.fail_below = 1;
	ok(follow(&owner, &hawser__frf_steps) == HAWSER__ENDED && owner.refined,
	   "a finer discretisation gets over a failure");
	owner = begin(&battery[2], 0, 0.1);
	owner.fail_below = owner.no_finer = 1;
	ok(follow(&owner, &hawser__frf_steps) == HAWSER__LOST && owner.u[0] <= 0.5 && owner.u[0] > 0.49,
	   "lost where the corrector fails, at %.3f", owner.u[0]);
}

/* A point of a curve lies in one of two steps that follow each other, wherever it is, whatever the
 * curve turns in a step; a point beside them in none. On a circle. */
static void check_passage(void)
{
	static const double turn[] = {0.05, 0.4, 0.7};
	int lost = 0, false_ones = 0;
	double off = 0.0;

	for (int k = 0; k < 3; k++)
		for (int i = -40; i <= 240; i++) {
			double at = 0.01*i, angle = turn[k]*at, goal[2] = {cos(angle), sin(angle)};
			double arc[3] = {0.0, turn[k], 2.0*turn[k]}, y[3][2], t[3][2], share, here[2], d[2];
			int found = 0;

			for (int e = 0; e < 3; e++) {
				y[e][0] = t[e][1] = cos(arc[e]);
				y[e][1] = sin(arc[e]);
				t[e][0] = -y[e][1];
			}
			for (int e = 0; e < 2; e++) {
				const struct hawser__node a = {y[e], t[e]}, b = {y[e + 1], t[e + 1]};

				if (hawser__curve_passes(&share, goal, &a, &b, turn[k], 0.02, here, d, &plane)) {
					found = 1;
					off = fmax(off, fabs(e + share - at));
				}
			}
			lost += i >= 0 && i <= 200 && !found;
			false_ones += (i < 0 || i > 200) && found;
		}
	ok(lost == 0 && false_ones == 0 && off < 0.01,
	   "points on steps are found: %d of them not, %d beside them, places to %.1e", lost, false_ones,
	   off);
}

/* The tangent at a point of a circle from 1 to 3 unequal arcs before it, with tangents of any length:
 * the error falls with the square of the arcs from one, and from more with their fourth power, as the
 * error of arclengths by chords does. */
static void check_slope(void)
{
	for (int nodes = 1; nodes <= 3; nodes++) {
		double error[2];

		for (int half = 0; half < 2; half++) {
			double y[4][2], t[4][2], slope[2], h = half ? 0.1 : 0.2;
			struct hawser__node node[3];

			for (int e = 0; e <= nodes; e++) {
				double angle = h*(e + 0.2385*e*e);

				y[e][0] = cos(angle);
				y[e][1] = sin(angle);
				t[e][0] = -(1.0 + e)*y[e][1];
				t[e][1] = (1.0 + e)*y[e][0];
				if (e < nodes)
					node[e] = (struct hawser__node){y[e], t[e]};
			}
			hawser__curve_slope(slope, y[nodes], node, nodes,
			                    h*(1.0 + 0.2385*(2*nodes - 1)), &plane);
			error[half] = hypot(slope[0] - t[nodes][0]/(1.0 + nodes),
			                    slope[1] - t[nodes][1]/(1.0 + nodes));
		}
		ok(error[0] < 0.05 && error[1] < 1.25*error[0]/(nodes == 1 ? 4.0 : 16.0),
		   "tangent from %d nodes: %.1e, then %.1e", nodes, error[0], error[1]);
	}
}

CASE(unit_continuation)
{
	check_battery();
	check_arcs();
	check_ends();
	check_passage();
	check_slope();
	return done_testing();
}

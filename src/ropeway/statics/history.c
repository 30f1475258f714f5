/* ropeway/statics/history.c - friction that follows from the order in which a rope is paid in and out.
 *
 *   m_k   friction that acts on circle k, from -mu_k to mu_k; > 0: the tension grows toward B
 *   M_k   m, unstretched rope between circle k and the end at which none is paid in or out
 *   p_k   m, rope that has passed circle k toward B in a step: the change of M_k, with its sign
 *
 * The path begins with the state without tangential forces. In each step of it Coulomb's law
 * holds at each circle:
 *
 *   p_k = 0 and |m_k| <= mu_k (stick),  p_k > 0 and m_k = mu_k,  or  p_k < 0 and m_k = -mu_k (slip).
 *
 * More friction m_k leaves less rope on the side of B, so that p_k falls with m_k, and p_k = 0 is
 * found by secant steps, or is bracketed. Circles act on each other through the rope between them: they
 * are taken in turn until all laws hold (Gauss-Seidel; the change at one circle reaches the next one
 * weakened).
 * Between two stops of the path STEPS steps find out where a circle begins to slip and stops again.
 *
 * M_k is that at a fixed point of the circle, where the rope was in the middle of its contact when it
 * first touched: rope that is laid on or taken off on a side does not slip. The rope in contact has
 * the tension that m_k gives it everywhere, as if it slipped to it; the error of the length is below
 * mu*wrap*T/EA of the arc's length.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "continuation/false_position.h"
#include "core/report.h"
#include "ropeway/statics/line.h"

/* Steps between two stops; rounds over all circles, the first with secant steps: ten are usual;
 * tries to bracket p_k = 0: eight are usual. */
enum { STEPS = 20, ROUNDS = 400, SECANTS = 100, TRIES = 60 };
#define STEEP 1e-9 /* of the friction: a change of it that shows the slope */
#define STILL 1e-11 /* of the rope's length: passed rope that is none, some 100 times round-off */

struct walk {
	const struct hawser_obstacles *scene;
	struct hawser_line line;
	struct hawser_line_statics st; /* of the last solution */
	double *middle;                /* [sheaves] rad, slope angle at the fixed point; NAN: not touched */
	double *kept;                  /* [sheaves] M_k of the last step, m */
	double *slope;                 /* [sheaves] m, change of p_k with m_k; 0: not known */
};

static enum hawser_status solve(struct walk *of, struct hawser_report *report)
{
	static const char *const key[] = {"T0", "T1", "length0"};
	struct hawser_report inner = {0};
	enum hawser_status status;

	hawser_line_statics_clear(&of->st);
	status = hawser_line_solve(&of->st, &of->line, &inner);
	return status ? hawser__fail(report, status, "statics", "contact.path, at tension.%s = %.9g %s: "
	                             "%.440s", key[of->line.given], of->line.value,
	                             of->line.given == HAWSER_LINE_LENGTH0 ? "m" : "N", inner.message)
	              : HAWSER_OK;
}

/* M_k at the slope angle `middle` of the circle. */
static double rope_behind(const struct walk *of, int k, double middle)
{
	const struct hawser_line_statics *st = &of->st;
	const struct hawser_line_contact *c = &st->contact[k];
	const struct hawser_line_sheave *sheave = &st->line->sheave[k];
	double from, to, stretch = 1.0 + 0.5*(c->T_in + c->T_out)/st->line->EA, S;

	hawser__line_touch(&from, &to, st, k);
	S = 0.5*(from + to) +
		sheave->side*(0.5*(c->angle_in + c->angle_out) - middle)*sheave->radius/stretch;
	return of->scene->winch ? S : st->length0 - S;
}

/* p_k in the state that was solved last. */
static double passed(const struct walk *of, int k)
{
	double change;

	if (!of->st.contact[k].touches || isnan(of->middle[k]))
		return 0.0;
	change = rope_behind(of, k, of->middle[k]) - of->kept[k];
	return of->scene->winch ? -change : change;
}

/* Whether the law holds at circle k in the state that was solved last. */
static int holds(const struct walk *of, int k, double still)
{
	const struct hawser_line_sheave *sheave = &of->line.sheave[k];
	double p = passed(of, k);

	return fabs(p) <= still || (p > 0.0 ? sheave->grip >= sheave->friction
	                                    : sheave->grip <= -sheave->friction);
}

/* Find m_k for which the law holds, the other circles left as they are. */
static enum hawser_status bracket(struct walk *of, int k, double still, struct hawser_report *report)
{
	struct hawser_line_sheave *sheave = &of->line.sheave[k];
	double a = sheave->grip, fa = passed(of, k), b = fa > 0.0 ? sheave->friction : -sheave->friction;
	double fb;
	struct hawser__bracketed in;
	enum hawser_status status;

	sheave->grip = b;
	status = solve(of, report);
	fb = status ? 0.0 : passed(of, k);
	if (!status && a != b)
		of->slope[k] = (fb - fa)/(b - a);
	if (status || (fa > 0.0) == (fb > 0.0) || fabs(fb) <= still)
		return status;
	in = a < b ? (struct hawser__bracketed){a, b, fa, fb, 0}
	           : (struct hawser__bracketed){b, a, fb, fa, 0};
	for (int i = 0; i < TRIES && !status; i++) {
		double f;

		sheave->grip = hawser__false_position(&in, i);
		status = solve(of, report);
		f = status ? 0.0 : passed(of, k);
		if (fabs(f) <= 0.1*still)
			break;
		hawser__false_position_take(&in, sheave->grip, f);
	}
	return status;
}

/* One secant step of m_k toward its law; the slope is that of earlier steps. */
static enum hawser_status improve(struct walk *of, int k, struct hawser_report *report)
{
	struct hawser_line_sheave *sheave = &of->line.sheave[k];
	double m = sheave->grip, f = passed(of, k), slope;
	enum hawser_status status;

	sheave->grip = fmax(fmin(m - f/of->slope[k], sheave->friction), -sheave->friction);
	status = solve(of, report);
	slope = status ? NAN : (passed(of, k) - f)/(sheave->grip - m);
	if (slope < 0.0 && fabs(sheave->grip - m) > STEEP*sheave->friction)
		of->slope[k] = slope;
	return status;
}

static enum hawser_status step(struct walk *of, struct hawser_report *report)
{
	int sheaves = of->line.sheaves, worst = 0;
	enum hawser_status status = solve(of, report);

	for (int round = 0; round < ROUNDS && !status; round++) {
		double still = STILL*of->st.length0;
		int wrong = 0;

		for (int k = 0; k < sheaves && !status; k++)
			if (!holds(of, k, still)) {
				wrong = 1;
				worst = k;
				status = of->slope[k] < 0.0 && round < SECANTS ? improve(of, k, report)
				                                               : bracket(of, k, still, report);
			}
		if (!wrong)
			return HAWSER_OK;
	}
	return status ? status
		: hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "statics", ROUNDS, passed(of, worst),
		                  "contact.path: at %.9g the friction at %s was not found: %.3g m of rope too "
		                  "much pass it", of->line.value, of->line.sheave[worst].name,
		                  passed(of, worst));
}

/* Keep the state as point `i` of the path, and begin the next step from it. */
static void keep(struct walk *of, struct hawser_obstacles_path *path, int i)
{
	int sheaves = of->line.sheaves;

	path->value[i] = of->line.value;
	path->T[2*i] = of->st.T_A;
	path->T[2*i + 1] = of->st.T_B;
	for (int k = 0; k < sheaves; k++) {
		const struct hawser_line_contact *c = &of->st.contact[k];

		double p = passed(of, k);
		int stuck = c->touches && !isnan(of->middle[k]) && fabs(p) <= STILL*of->st.length0;

		path->slid[i*sheaves + k] = (i ? path->slid[(i - 1)*sheaves + k] : 0.0) + (stuck ? 0.0 : p);
		if (!c->touches) {
			of->middle[k] = NAN;
			of->line.sheave[k].grip = 0.0;
		} else if (isnan(of->middle[k])) {
			of->middle[k] = 0.5*(c->angle_in + c->angle_out);
		}
		path->grip[i*sheaves + k] = of->line.sheave[k].grip;
		if (c->touches && !stuck) /* what sticks does not drift */
			of->kept[k] = rope_behind(of, k, of->middle[k]);
	}
}

static enum hawser_status allot(struct walk *of, struct hawser_obstacles_statics *st, size_t points,
                                struct hawser_report *report)
{
	size_t sheaves = (size_t)of->line.sheaves;
	struct hawser_obstacles_path *path = &st->path;

	of->middle = calloc(sheaves + 1, sizeof *of->middle);
	of->kept = calloc(sheaves + 1, sizeof *of->kept);
	of->slope = calloc(sheaves + 1, sizeof *of->slope);
	st->held = calloc(sheaves + 1, sizeof *st->held);
	path->value = calloc(points, sizeof *path->value);
	path->T = calloc(2*points, sizeof *path->T);
	path->grip = calloc(points*sheaves + 1, sizeof *path->grip);
	path->slid = calloc(points*sheaves + 1, sizeof *path->slid);
	return of->middle && of->kept && of->slope && st->held && path->value && path->T && path->grip &&
		path->slid ? HAWSER_OK : hawser__no_memory(report, "statics");
}

enum hawser_status hawser__obstacles_history(struct hawser_obstacles_statics *st,
                                             const struct hawser_obstacles *scene,
                                             struct hawser_report *report)
{
	struct walk of = {.scene = scene, .line = scene->line};
	int points = scene->stops*STEPS + 1;
	double last = scene->line.value;
	enum hawser_status status = allot(&of, st, (size_t)points, report);

	if (!status) {
		memcpy(st->held, scene->line.sheave, (size_t)scene->line.sheaves*sizeof *st->held);
		of.line.sheave = st->held;
		for (int k = 0; k < scene->line.sheaves; k++)
			of.middle[k] = NAN;
	}
	for (int i = 0; i < points && !status; i++) {
		double from = scene->path[i ? (i - 1)/STEPS : 0];
		double to = (i + STEPS - 1)/STEPS < scene->stops ? scene->path[(i + STEPS - 1)/STEPS] : last;
		double part = i ? ((i - 1) % STEPS + 1.0)/STEPS : 0.0;

		of.line.value = part == 1.0 ? to : from + part*(to - from);
		status = i ? step(&of, report) : solve(&of, report);
		if (!status)
			keep(&of, &st->path, i);
		st->path.points += !status;
	}
	hawser_line_statics_clear(&of.st);
	free(of.middle);
	free(of.kept);
	free(of.slope);
	st->line[0] = of.line;
	return status;
}

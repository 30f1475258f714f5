/* study/map/ridge_find.c - resonances between two points (ridge.h): where two multipliers have the same
 * argument.
 *
 *    theta     argument of a multiplier
 *    u         place between the points in the period: proportional to 1/Omega, in which theta of a
 *              constant frequency is linear; without a change of Omega, to t
 *    v         d theta/du at a point, from one near it
 *    D         difference of two arguments, over u
 *
 * By the frequencies at rest w the places are those at which w_j +- w_k is a multiple of Omega. Strong
 * excitation displaces the frequencies by more than their distances, so that no multiplier can be
 * given to a mode. A multiplier of the one point is therefore continued to the one of the other whose
 * argument and rate agree best with its own, by the cubic through both; where D of two of them is a
 * multiple of 2 pi they meet. The resonance is named by the frequencies at rest that are the least
 * displaced.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/grow.h"
#include "core/report.h"
#include "study/map/ridge.h"

#define ALIKE 0.01     /* distance of two places that are one, relative to the points'; chosen */
#define LIKE 0.1       /* the same of arguments; chosen */
#define HALF 0.05      /* of two conjugate meetings one is searched: that with an argument in the upper
                        * half, widened by this */
#define CERTAIN 0.5    /* largest distance in rad of two that are taken for one course; chosen */
enum { PIECES = 8 };   /* of a cubic; chosen */

/* A multiplier from the one point to the other: cubic over u from 0 to 1. */
struct course {
	double theta, change, v[2];
	double part;
};

struct meeting {
	struct hawser__combination of;
	double t, slope, angle;
};

struct finding {
	const struct hawser__ridge_edge *edge;
	const double *end[2];
	struct course *course; /* [2n] */
	double *rate[2];       /* [2n] v at both ends */
	double *cost;          /* [2n][2n] */
	int *to;               /* [2n] multiplier of the other point */
	struct meeting *met;
	size_t count;
};

static double wrapped(double angle)
{
	return remainder(angle, 2.0*M_PI);
}

static double argument(const double *exponents, int n, int c)
{
	return exponents[1 + 4*n + c];
}

static double part(const double *exponents, int n, int c)
{
	return exponents[1 + n + c/2];
}

/* u of the place t. */
static double period_place(const struct finding *of, double t)
{
	double a = of->end[0][0], b = of->end[1][0], here = a + t*(b - a);

	return a == b ? t : (1.0/here - 1.0/a)/(1.0/b - 1.0/a);
}

static double place_of(const struct finding *of, double u)
{
	double a = of->end[0][0], b = of->end[1][0];

	return a == b ? u : (1.0/(1.0/a + u*(1.0/b - 1.0/a)) - a)/(b - a);
}

/* --- courses --- */

/* One multiplier of the one list for each of the other, the cheapest pairs first; costs may be
 * infinite. */
static void match(int *to, double *cost, int m)
{
	for (int c = 0; c < m; c++)
		to[c] = -1;
	for (int round = 0; round < m; round++) {
		int best = -1;

		for (int e = 0; e < m*m; e++)
			if (cost[e] < (best < 0 ? INFINITY : cost[best]))
				best = e;
		if (best < 0)
			return;
		to[best/m] = best%m;
		for (int c = 0; c < m; c++)
			cost[best/m*m + c] = cost[c*m + best%m] = INFINITY;
	}
}

/* The rates at an end. */
static void rates(struct finding *of, int end)
{
	const double *e = of->end[end], *f = of->edge->near[end];
	double step = period_place(of, end + of->edge->step[end]) - end;
	int n = of->edge->n, m = 2*n;

	for (int a = 0; a < m; a++)
		for (int b = 0; b < m; b++)
			of->cost[a*m + b] = part(e, n, a) != part(f, n, b) ? INFINITY
			                    : fabs(wrapped(argument(f, n, b) - argument(e, n, a)));
	match(of->to, of->cost, m);
	for (int c = 0; c < m; c++)
		of->rate[end][c] = of->to[c] < 0 ? NAN
			: wrapped(argument(f, n, of->to[c]) - argument(e, n, c))/step;
}

/* Arguments and rates agree at the middle. */
static void courses(struct finding *of)
{
	const double *e = of->end[0], *f = of->end[1];
	int n = of->edge->n, m = 2*n;

	for (int a = 0; a < m; a++)
		for (int b = 0; b < m; b++) {
			double v = of->rate[0][a], w = of->rate[1][b];
			double off = wrapped(argument(f, n, b) - argument(e, n, a) - 0.5*(v + w));
			double cost = fabs(off) + 0.25*fabs(v - w);

			of->cost[a*m + b] = part(e, n, a) == part(f, n, b) && cost < CERTAIN ? cost : INFINITY;
		}
	match(of->to, of->cost, m);
	for (int c = 0; c < m; c++) {
		struct course *course = &of->course[c];
		double half;

		*course = (struct course){.part = NAN};
		if (of->to[c] < 0)
			continue;
		half = 0.5*(of->rate[0][c] + of->rate[1][of->to[c]]);
		course->theta = argument(e, n, c);
		course->change = half + wrapped(argument(f, n, of->to[c]) - course->theta - half);
		course->v[0] = of->rate[0][c];
		course->v[1] = of->rate[1][of->to[c]];
		course->part = part(e, n, c);
	}
}

static double at(const struct course *course, double u)
{
	double w = 1.0 - u;

	return course->theta + course->change*u*u*(3.0 - 2.0*u) +
	       u*w*(w*course->v[0] - u*course->v[1]);
}

/* --- meetings --- */

/* The frequencies at rest whose resonance is displaced the least: their displacements in rad are
 * those of the angle at which the multipliers meet, or of its conjugate. */
static void name(struct hawser__combination *to, const struct finding *of, double component, double t,
                 double angle)
{
	const double *a = of->end[0], *b = of->end[1], *member = a + 1 + of->edge->n;
	int n = of->edge->n;
	double omega = a[0] + t*(b[0] - a[0]), turn = 2.0*M_PI/omega, least = INFINITY;

	for (int e = 0; e < 4*n*n; e++) {
		int j = e/4%n, k = e/4/n, sign = e & 1 ? 1 : -1, order;
		double phi = e & 2 ? angle : -angle, off[2];
		double w = a[1 + j] + t*(b[1 + j] - a[1 + j]), v = a[1 + k] + t*(b[1 + k] - a[1 + k]);

		if (member[j] != component || member[k] != component ||
		    (sign > 0 ? j > k : j == k || w < v))
			continue;
		off[0] = wrapped(phi - w*turn);
		off[1] = wrapped(phi + sign*v*turn);
		order = (int)round((w + sign*v)/omega + (off[0] - off[1])/(2.0*M_PI));
		if (order < 1 || !(fabs(off[0]) + fabs(off[1]) < least))
			continue;
		least = fabs(off[0]) + fabs(off[1]);
		*to = (struct hawser__combination){.j = j, .k = k, .sign = sign, .m = order, .angle = angle};
	}
}

static enum hawser_status add(struct finding *of, const struct meeting *item,
                              struct hawser_report *report)
{
	if (hawser__more(&of->met, (long)of->count, sizeof *of->met))
		return hawser__no_memory(report, "hill");
	of->met[of->count++] = *item;
	return HAWSER_OK;
}

/* A course is met by another at u, D having the slope `rate` there. */
static enum hawser_status meet(struct finding *of, const struct course *a, double u, double rate,
                               struct hawser_report *report)
{
	const double step = 1e-3;
	double t = place_of(of, u);
	double du = (period_place(of, t + step) - period_place(of, t - step))/(2.0*step);
	double omega = of->end[0][0] + t*(of->end[1][0] - of->end[0][0]);
	double angle = wrapped(at(a, u)), change = of->end[1][0] - of->end[0][0];
	struct meeting item = {.of = {.m = 0}, .t = t, .slope = rate*du*omega/(2.0*M_PI), .angle = angle};

	if ((angle < -HALF && angle > HALF - M_PI) ||
	    (change != 0.0 && fabs(item.slope) > (HAWSER__RIDGE_HIGHEST + 0.5)*fabs(change)))
		return HAWSER_OK;
	name(&item.of, of, a->part, t, angle);
	item.of.turn[0] = du*(at(a, u + step) - at(a, u - step))/(2.0*step);
	item.of.turn[1] = item.of.turn[0] - rate*du;
	return item.of.m > 0 ? add(of, &item, report) : HAWSER_OK;
}

/* D is taken as linear over each piece. */
static enum hawser_status meetings(struct finding *of, const struct course *a, const struct course *b,
                                   struct hawser_report *report)
{
	const double turn = 2.0*M_PI;
	enum hawser_status status = HAWSER_OK;

	for (int k = 0; k < PIECES && !status; k++) {
		double u = (double)k/PIECES, v = (k + 1.0)/PIECES;
		double from = at(a, u) - at(b, u), to = at(a, v) - at(b, v);

		for (double l = ceil(fmin(from, to)/turn); l*turn < fmax(from, to) && !status; l++)
			status = meet(of, a, u + (v - u)*(l*turn - from)/(to - from),
			              (to - from)*PIECES, report);
	}
	return status;
}

static enum hawser_status by_courses(struct finding *of, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;
	int m = 2*of->edge->n;

	rates(of, 0);
	rates(of, 1);
	courses(of);
	for (int a = 0; a < m; a++)
		for (int b = a + 1; b < m && !status; b++)
			if (of->course[a].part == of->course[b].part)
				status = meetings(of, &of->course[a], &of->course[b], report);
	return status;
}

/* --- by the frequencies at rest --- */

/* Whether it is one of the first `count`. */
static int known(const struct finding *of, size_t count, const struct meeting *item)
{
	for (size_t c = 0; c < count; c++) {
		const struct meeting *other = &of->met[c];

		if (other->of.j == item->of.j && other->of.k == item->of.k &&
		    other->of.sign == item->of.sign && other->of.m == item->of.m &&
		    fabs(other->t - item->t) < ALIKE &&
		    fmin(fabs(wrapped(other->angle - item->angle)),
		         fabs(wrapped(other->angle + item->angle))) < LIKE)
			return 1;
	}
	return 0;
}

static enum hawser_status at_rest(struct finding *of, const struct hawser__combination *pair,
                                  size_t courses, int *above, struct hawser_report *report)
{
	const double *a = of->end[0], *b = of->end[1];
	double sum[2] = {a[1 + pair->j] + pair->sign*a[1 + pair->k],
	                 b[1 + pair->j] + pair->sign*b[1 + pair->k]};
	double low = fmin(fabs(sum[0])/a[0], fabs(sum[1])/b[0]);
	double high = fmax(fabs(sum[0])/a[0], fabs(sum[1])/b[0]);
	enum hawser_status status = HAWSER_OK;

	if (!(sum[0]*sum[1] > 0.0))
		return HAWSER_OK;
	for (int m = (int)fmax(ceil(low), 1.0); m <= floor(high) && !status; m++) {
		double r[2] = {fabs(sum[0]) - m*a[0], fabs(sum[1]) - m*b[0]};
		struct meeting item = {.of = *pair, .slope = r[1] - r[0]};

		*above |= m > HAWSER__RIDGE_HIGHEST;
		if (m > HAWSER__RIDGE_HIGHEST)
			break;
		if (r[0] == r[1])
			continue;
		item.t = r[0]/(r[0] - r[1]);
		item.of.m = m;
		if (sum[0] < 0.0) {
			item.of.j = pair->k;
			item.of.k = pair->j;
		}
		item.angle = 2.0*M_PI*(a[1 + item.of.j] + item.t*(b[1 + item.of.j] - a[1 + item.of.j]))/
		             (a[0] + item.t*(b[0] - a[0]));
		if (!known(of, courses, &item))
			status = add(of, &item, report);
	}
	return status;
}

static enum hawser_status find(struct finding *of, int *above, struct hawser_report *report)
{
	const double *member[2] = {of->end[0] + 1 + of->edge->n, of->end[1] + 1 + of->edge->n};
	int n = of->edge->n;
	enum hawser_status status = HAWSER_OK;
	size_t courses;

	if (of->edge->near[0] && of->edge->near[1])
		status = by_courses(of, report);
	courses = of->count;
	for (int j = 0; j < n; j++)
		for (int k = j; k < n; k++) {
			if (member[0][j] != member[0][k] && member[1][j] != member[1][k])
				continue;
			for (int sign = 1; sign >= (j == k ? 1 : -1) && !status; sign -= 2)
				status = at_rest(of, &(struct hawser__combination){.j = j, .k = k, .sign = sign},
				                 courses, above, report);
		}
	return status;
}

enum hawser_status hawser__ridge_find(const struct hawser__ridge_edge *edge, int *above,
                                      const struct hawser__ridge_taker *taker,
                                      struct hawser_report *report)
{
	size_t m = 2*(size_t)edge->n;
	struct finding of = {.edge = edge, .end = {edge->end[0], edge->end[1]}};
	enum hawser_status status = HAWSER_OK;

	of.cost = malloc((m*m + 2*m)*sizeof *of.cost);
	of.course = malloc(m*sizeof *of.course);
	of.to = malloc(m*sizeof *of.to);
	if (of.cost && of.course && of.to) {
		of.rate[0] = of.cost + m*m;
		of.rate[1] = of.rate[0] + m;
		status = find(&of, above, report);
	} else {
		status = hawser__no_memory(report, "hill");
	}
	for (size_t c = 0; c < of.count && !status; c++)
		status = taker->found(taker->context, &of.met[c].of, of.met[c].t, of.met[c].slope, report);
	free(of.cost);
	free(of.course);
	free(of.to);
	free(of.met);
	return status;
}

struct hawser__combination hawser__combination_on(const struct hawser__combination *of, double length)
{
	struct hawser__combination own = *of;

	own.turn[0] /= length;
	own.turn[1] /= length;
	return own;
}

/* study/hill/hill_ridges.c - boundaries of tongues that no sample of a search line shows.
 *
 * At each sum and difference of two frequencies at rest that is a multiple of Omega on the line, the
 * least stable point is searched (ridge.h). If it is unstable, its tongue has a boundary on each
 * side, near the places at which the parabola of the search has no growth.
 *
 *    s       position on the line, 0 to 1
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "core/share.h"
#include "response/floquet/linear_margin.h"
#include "study/hill/hill.h"
#include "study/map/ridge.h"

#define OUTSIDE 1.3   /* first place outside the tongue, in half-widths; chosen */
#define LEAST 1e-13   /* smallest half-width, relative to the line: round-off */
#define REACH 1.0     /* distance from its resonance at rest at which a tongue is looked for, in
                       * intervals; chosen */
#define CLEAR 0.3     /* decay at the least stable point, relative to the mean one, with which a
                       * tongue is clearly closed; chosen */
#define ROUGH 1e-3    /* the same relative to Omega: above the error of rough multipliers */
#define NODE_NEAR 0.015625 /* second point at a node, by which multipliers have rates, in intervals;
                            * chosen */
enum { EVERY = 8, TRIES = 4 };

struct walk {
	struct hawser__hill *hill;
	const struct hawser__hill_line *line;
	int nodes, n;
	double *exponents; /* [nodes + 1][2][HAWSER__EXPONENTS(n)] of the node and of a point near it */
	double *own;       /* [HAWSER__EXPONENTS(n)] */
	double *place;     /* [nodes + 1][2] s of both */
	int *unstable;     /* [nodes + 1] */
	int at;            /* the interval from this node */
};

static void place(double at[2], const struct hawser__hill_line *line, double s)
{
	at[0] = line->from[0] + s*line->along[0];
	at[1] = line->from[1] + s*line->along[1];
}

static double node_at(const struct walk *walk, long i)
{
	int samples = walk->line->samples;

	return (double)(i*EVERY < samples ? i*EVERY : samples)/samples;
}

/* From a node to the point near it. */
static double near(const struct walk *walk, long i)
{
	return i < walk->nodes ? NODE_NEAR*(node_at(walk, i + 1) - node_at(walk, i))
	                       : NODE_NEAR*(node_at(walk, i - 1) - node_at(walk, i));
}

static void node(void *context, long i, int number)
{
	const struct walk *walk = context;
	double at[2];

	for (int k = 0; k < 2; k++) {
		place(at, walk->line, walk->place[2*i + k]);
		hawser__hill_exponents(walk->hill, &walk->hill->worker[number], &walk->unstable[i],
		                       walk->exponents + (2*i + k)*HAWSER__EXPONENTS(walk->n), at, 1);
	}
}

/* The boundary on each side of the tongue, whose least stable point is s. */
static void both_sides(const struct walk *walk, const struct hawser__ridge *ridge, double s)
{
	const double lambda[2] = {ridge->growth/walk->own[0], fabs(ridge->angle)/(2.0*M_PI)};
	int kind = lambda[1] == 0.0 ? HAWSER_HILL_PLUS : lambda[1] == 0.5 ? HAWSER_HILL_MINUS
	                                                                 : HAWSER_HILL_TORUS;
	double half = fmax(hawser__ridge_half(ridge) + fabs(s - ridge->centre), LEAST);

	for (int side = -1; side <= 1; side += 2)
		for (int i = 0; i < TRIES; i++) {
			double out = fmin(fmax(s + side*half*OUTSIDE*(1 << i), 0.0), 1.0);

			if (hawser__hill_side(walk->hill, kind, ridge->of.j, lambda, walk->line, s, out))
				break;
		}
}

/* Search the least stable point of a resonance: *s becomes that of the unstable ones, with its growth
 * and angle, or -1. */
static enum hawser__ridge_state descend(struct hawser__ridge *ridge, double *s, struct walk *walk,
                                        int rough)
{
	struct hawser__hill *hill = walk->hill;
	enum hawser__ridge_state state = HAWSER__RIDGE_GOES_ON;
	double growth = 0.0, angle = 0.0, at[2];
	int unstable;

	*s = -1.0;
	while (state == HAWSER__RIDGE_GOES_ON) {
		double here = ridge->at;

		place(at, walk->line, here);
		if (hawser__hill_exponents(hill, hill->worker, &unstable, walk->own, at, rough)) {
			hill->status = hill->worker->status;
			*hill->report = hill->worker->report;
			return HAWSER__RIDGE_LOST;
		}
		state = hawser__ridge_take(ridge, walk->own, walk->n);
		if (unstable > 0 && ridge->growth > growth) {
			*s = here;
			growth = ridge->growth;
			angle = ridge->angle;
		}
	}
	ridge->growth = growth;
	ridge->angle = angle;
	return state;
}

/* With damping rough multipliers suffice where the least stable point is clearly stable. */
static int clearly_closed(const struct hawser__ridge *ridge, enum hawser__ridge_state state,
                          double omega)
{
	double least = ridge->mean + 0.5*sqrt(fmax(ridge->top, 0.0));

	return state == HAWSER__RIDGE_CLOSED && least < CLEAR*ridge->mean && least < -ROUGH*omega;
}

static enum hawser_status look(void *context, const struct hawser__combination *of, double t,
                               double slope, struct hawser_report *report)
{
	struct walk *walk = context;
	struct hawser__hill *hill = walk->hill;
	double from = node_at(walk, walk->at), length = node_at(walk, walk->at + 1) - from;
	const struct hawser__ridge begin = {.of = hawser__combination_on(of, length),
		.slope = slope/length,
		.low = fmax(0.0, from - REACH*length), .high = fmin(1.0, from + (1.0 + REACH)*length),
		.at = from + t*length};
	struct hawser__ridge ridge = begin;
	enum hawser__ridge_state state;
	double s, at[2];

	(void)report;
	state = descend(&ridge, &s, walk, 1);
	if (hill->status || (s < 0.0 && clearly_closed(&ridge, state, walk->own[0])))
		return hill->status;
	ridge = begin;
	state = descend(&ridge, &s, walk, 0);
	place(at, walk->line, s < 0.0 ? ridge.place[0] : s);
	hawser__hill_to_caller(at, hill, at);
	if (!hill->status && (s >= 0.0 || state == HAWSER__RIDGE_UNRESOLVED))
		hill->status = hawser__ridge_note(&hill->tongues, of, s >= 0.0, at, hill->report);
	if (s >= 0.0 && !hill->status)
		both_sides(walk, &ridge, s);
	return hill->status;
}

static void all_intervals(struct walk *walk)
{
	struct hawser__hill *hill = walk->hill;
	const struct hawser__ridge_taker taker = {look, walk};
	size_t size = HAWSER__EXPONENTS((size_t)walk->n);

	for (int i = 0; i <= walk->nodes; i++)
		for (int k = 0; k < 2; k++)
			walk->place[2*i + k] = node_at(walk, i) + k*near(walk, i);
	if ((hill->status = hawser__hill_prepare(hill, walk->line, walk->place, 2*(walk->nodes + 1))))
		return;
	hawser__share((long)walk->nodes + 1, hill->threads, node, walk);
	for (int t = 0; t < hill->threads && !hill->status; t++)
		if ((hill->status = hill->worker[t].status))
			*hill->report = hill->worker[t].report;
	for (walk->at = 0; walk->at < walk->nodes && !hill->status && !hill->chart->interrupted;
	     walk->at++) {
		const double *a = walk->exponents + 2*walk->at*size, *b = a + 2*size;
		double length = node_at(walk, walk->at + 1) - node_at(walk, walk->at);
		const struct hawser__ridge_edge edge = {{a, b},
			{a[size] > 0.0 ? a + size : NULL, b[size] > 0.0 ? b + size : NULL},
			{near(walk, walk->at)/length, near(walk, walk->at + 1)/length}, walk->n};

		if (!(a[0] > 0.0 && b[0] > 0.0)) /* no response there */
			continue;
		hill->status = hawser__ridge_find(&edge, &hill->tongues.above, &taker, hill->report);
	}
}

void hawser__hill_ridges(struct hawser__hill *hill, const struct hawser__hill_line *line)
{
	struct walk walk = {.hill = hill, .line = line, .n = hill->field->m/2,
		.nodes = (line->samples + EVERY - 1)/EVERY};
	size_t size = HAWSER__EXPONENTS((size_t)walk.n);

	if (!hill->worker->linear || hill->status)
		return;
	walk.exponents = calloc((2*(size_t)walk.nodes + 3)*size + 2*((size_t)walk.nodes + 1),
	                        sizeof(double));
	walk.unstable = calloc((size_t)walk.nodes + 1, sizeof *walk.unstable);
	if (walk.exponents && walk.unstable) {
		walk.own = walk.exponents + 2*((size_t)walk.nodes + 1)*size;
		walk.place = walk.own + size;
		all_intervals(&walk);
	} else {
		hill->status = hawser__no_memory(hill->report, "hill");
	}
	free(walk.exponents);
	free(walk.unstable);
}

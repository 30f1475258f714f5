/* ropeway/modes/track_match.c - which mode of the next value continues a branch.
 *
 *   m_ij    squared correlation of mode i at one value with mode j at the next
 *   to[i]   the mode that continues mode i: pairs are taken by descending m_ij
 *
 * Where two branches change their order, their modes either belong to spans that do not interact
 * (another plane, another lane between fixed ends, a rope that sticks), and they cross; or they are
 * coupled. The square of the gap of two coupled frequencies is a parabola about the place at which they
 * are closest (eigenvalues of a Hermitian 2 x 2 matrix), so that this place is found by parabolas
 * within a bracket. If the gap there is above `CROSSES`, the branches veer: they keep their order and
 * exchange their shapes, however short the step in which they do.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/grow.h"
#include "core/report.h"
#include "ropeway/modes/track.h"

#define SURE 0.5     /* least m_ij without a shorter step: no other mode can have as much */
#define KNOWN 0.1    /* least m_ij of a branch that goes on at all: an eighth of all modes by chance */
#define CROSSES 1e-6 /* largest relative gap of a crossing */
#define ROUND_OFF 1e-11 /* a relative gap that is none: the frequencies have some 1e-13 */
#define BESIDE 1e-3  /* of the bracket: a place that is tried beside its lowest point */
#define NARROW 1e-5  /* of the step: a bracket that is narrow enough, the gap is even in the distance */
enum { TRIES = 24 }; /* places that are tried: eight are usual */

enum hawser_status hawser__track_crossover(struct hawser__track *t,
                                           const struct hawser_ropeway_track_crossover *at,
                                           struct hawser_report *report)
{
	if (hawser__more(&t->crossover, t->crossovers, sizeof *t->crossover))
		return hawser__no_memory(report, "track");
	t->crossover[t->crossovers++] = *at;
	return HAWSER_OK;
}

/* to [a->n], or -1; returns 0 without memory. */
static int pair_up(int *to, double *best, const struct hawser__track_sample *a,
                   const struct hawser__track_sample *b)
{
	size_t cells = (size_t)a->n*(size_t)b->n;
	double *m = malloc((cells + 1)*sizeof *m);

	if (!m)
		return 0;
	for (int i = 0; i < a->n; i++) {
		to[i] = -1;
		best[i] = 0.0;
		for (int j = 0; j < b->n; j++)
			m[i*b->n + j] = hawser__track_alike(a, i, b, j);
	}
	for (;;) {
		int i, j, most = -1;

		for (int k = 0; k < (int)cells; k++)
			if (m[k] > KNOWN && (most < 0 || m[k] > m[most]))
				most = k;
		if (most < 0)
			break;
		i = most/b->n;
		j = most % b->n;
		to[i] = j;
		best[i] = m[most];
		for (int k = 0; k < b->n; k++)
			m[i*b->n + k] = 0.0;
		for (int k = 0; k < a->n; k++)
			m[k*b->n + j] = 0.0;
	}
	free(m);
	return 1;
}

int hawser__track_place(const struct hawser__track_sample *a, int k)
{
	int place = 0;

	for (int i = 0; i < k; i++)
		place += a->plane[i] == a->plane[k];
	return place;
}

/* The mode at a place; -1: there is none. */
static int mode_at(const struct hawser__track_sample *a, enum hawser_plane plane, int place)
{
	for (int i = 0; i < a->n; i++)
		if (a->plane[i] == plane && place-- == 0)
			return i;
	return -1;
}

/* Gap of the modes at a place and the next one; *omega: their mean. NAN: unknown. */
static double gap_of(double *omega, const struct hawser__track_sample *a, enum hawser_plane plane,
                     int place)
{
	int i = mode_at(a, plane, place), j = mode_at(a, plane, place + 1);

	if (i < 0 || j < 0)
		return NAN;
	*omega = 0.5*(a->omega[i] + a->omega[j]);
	return (a->omega[j] - a->omega[i]) / *omega;
}

/* A search for the least gap: x[0], x[1], x[2] in order, and the squares of the gaps there. */
struct bracket {
	double x[3], y[3];
};

/* The next place to try: the vertex of the parabola, or a little beside the middle point if it is
 * there; as long as the middle point is not the lowest, half way from it to the lower end. */
static double propose(const struct bracket *in)
{
	const double *x = in->x, *y = in->y;
	double d1 = (y[1] - y[0])/(x[1] - x[0]), d2 = (y[2] - y[1])/(x[2] - x[1]), at;

	if (y[0] <= y[1] || y[2] <= y[1])
		return y[0] <= y[2] ? 0.5*(x[0] + x[1]) : 0.5*(x[1] + x[2]);
	at = 0.5*(x[0] + x[1] - d1*(x[2] - x[0])/(d2 - d1));
	if (fabs(at - x[1]) < BESIDE*fabs(x[2] - x[0]))
		at = x[1] + BESIDE*(fabs(x[2] - x[1]) > fabs(x[1] - x[0]) ? x[2] - x[1] : x[0] - x[1]);
	return at;
}

static void take(struct bracket *in, double x, double y)
{
	double *X = in->x, *Y = in->y;
	int beyond = (x - X[1])*(X[2] - X[1]) > 0.0; /* between the middle point and the last one */
	int lower = y < Y[1] || (Y[0] <= Y[1] && !beyond) || (Y[2] <= Y[1] && beyond);
	int end = lower ? (beyond ? 0 : 2) : beyond ? 2 : 0; /* which is left out */

	if (lower) {
		X[end] = X[1];
		Y[end] = Y[1];
		X[1] = x;
		Y[1] = y;
	} else {
		X[end] = x;
		Y[end] = y;
	}
}

enum hawser_status hawser__track_closest(struct hawser_ropeway_track_crossover *at,
                                         struct hawser__track *t, const struct hawser__track_sample *a,
                                         const struct hawser__track_sample *b, enum hawser_plane plane,
                                         int place, struct hawser_report *report)
{
	double omega = 0.0, wide = fabs(b->at.value - a->at.value);
	double next = 0.5*(a->at.value + b->at.value);
	struct bracket in = {{a->at.value, next, b->at.value},
	                     {pow(gap_of(&omega, a, plane, place), 2.0), HUGE_VAL,
	                      pow(gap_of(&omega, b, plane, place), 2.0)}};

	*at = (struct hawser_ropeway_track_crossover){.gap = HUGE_VAL, .below = -1, .above = -1};
	for (int i = 0; i < TRIES && fabs(in.x[2] - in.x[0]) > NARROW*wide; i++) {
		struct hawser__track_sample here;
		double gap;
		enum hawser_status status = hawser__track_sample(&here, t, next, report);

		if (status)
			return status;
		gap = gap_of(&omega, &here, plane, place);
		hawser__track_sample_clear(&here);
		if (gap < at->gap) {
			at->gap = gap;
			at->value = next;
			at->omega = omega;
		}
		if (i == 0)
			in.y[1] = gap*gap;
		else
			take(&in, next, gap*gap);
		if (gap < ROUND_OFF)
			break;
		next = propose(&in);
	}
	at->veers = at->gap > CROSSES;
	return HAWSER_OK;
}

/* 1 if the modes i and j, which change their order, are not next to each other on both sides, so that
 * a third one is involved. */
static int involved(const struct hawser__track_sample *a, const struct hawser__track_sample *b,
                    const int *to, int i, int j)
{
	return hawser__track_place(a, j) - hawser__track_place(a, i) != 1 ||
	       hawser__track_place(b, to[i]) - hawser__track_place(b, to[j]) != 1;
}

/* Decide on two modes that change their order: i below j at a. */
static enum hawser_status decide(struct hawser__track *t, int *to, int i, int j,
                                 const struct hawser__track_sample *a,
                                 const struct hawser__track_sample *b, struct hawser_report *report)
{
	struct hawser_ropeway_track_crossover at = {.below = a->branch[i], .above = a->branch[j]};
	int coupled = hawser__track_coupled(a, i, j) || hawser__track_coupled(b, to[i], to[j]);
	enum hawser_status status = HAWSER_OK;

	if (coupled || !involved(a, b, to, i, j)) {
		status = hawser__track_closest(&at, t, a, b, a->plane[i], hawser__track_place(a, i), report);
		at.below = a->branch[i];
		at.above = a->branch[j];
		at.veers &= coupled;
		at.gap = coupled ? at.gap : 0.0;
	} else { /* where straight lines meet */
		double before = a->omega[j] - a->omega[i], after = b->omega[to[i]] - b->omega[to[j]];
		double part = before + after > 0.0 ? before/(before + after) : 0.5;

		at.value = a->at.value + part*(b->at.value - a->at.value);
		at.omega = a->omega[i] + part*(b->omega[to[i]] - a->omega[i]);
	}
	if (!status && at.veers) {
		int own = to[i];

		to[i] = to[j];
		to[j] = own;
	}
	return status ? status : hawser__track_crossover(t, &at, report);
}

enum hawser_status hawser__track_match(int *split, struct hawser__track *t,
                                       const struct hawser__track_sample *a,
                                       struct hawser__track_sample *b, int last,
                                       struct hawser_report *report)
{
	int *to = calloc((size_t)a->n, sizeof *to);
	double *best = calloc((size_t)a->n, sizeof *best);
	enum hawser_status status = to && best && pair_up(to, best, a, b)
		? HAWSER_OK : hawser__no_memory(report, "track");

	*split = 0;
	for (int i = 0; i < a->n && !status && !last; i++) {
		*split |= a->branch[i] >= 0 && best[i] < SURE;
		for (int j = i + 1; j < a->n; j++)
			*split |= to[i] >= 0 && to[j] >= 0 && to[i] > to[j] && a->plane[i] == a->plane[j] &&
			          (a->branch[i] >= 0 || a->branch[j] >= 0) && involved(a, b, to, i, j) &&
			          (hawser__track_coupled(a, i, j) || hawser__track_coupled(b, to[i], to[j]));
	}
	/* Where the rope leaves an obstacle all frequencies jump: that is no crossover. */
	for (int i = 0; i < a->n && !status && !*split && a->at.touched == b->at.touched; i++)
		for (int j = i + 1; j < a->n && !status; j++)
			if (to[i] >= 0 && to[j] >= 0 && to[i] > to[j] && a->plane[i] == a->plane[j] &&
			    (a->branch[i] >= 0 || a->branch[j] >= 0))
				status = decide(t, to, i, j, a, b, report);
	for (int i = 0; i < a->n && !status && !*split; i++) {
		if (a->branch[i] < 0)
			continue;
		b->at.unsure |= best[i] < SURE;
		t->least = fmin(t->least, best[i]);
		if (to[i] >= 0)
			b->branch[to[i]] = a->branch[i];
	}
	free(to);
	free(best);
	return status;
}

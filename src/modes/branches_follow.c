/* modes/branches_follow.c - from station to station: which branch is which, with steps as small as that
 * needs (doc/theory-irvine.md).
 *
 *   m_ij     squared correlation of place i at one stop with place j at the next; places are by
 *            frequency, in the plane
 *   block    the fewest neighbouring places whose shapes go over into each other: in each row and
 *            column of it the m_ij sum to `correlation` at least
 *
 * A block of one is a shape that stayed. In a block of two the shapes have turned within their
 * plane, by an angle whose squared sine is m_12: past one half, the two were closest in this step,
 * and meet.c finds where, and whether they crossed. Anything else halves the step. So the order of
 * places changes at located crossings only, and a veering, however narrow, does not swap branches.
 * Out of the plane frequencies are eigenvalues of a Sturm-Liouville problem, hence simple: their
 * branches never meet.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "modes/branches.h"

/* No stop has more places than modes are asked for: branches_stop.c refuses more. */
enum { NUDGES = 3, PLACES_MOST = HAWSER__ASK_MOST + 24 };
/* Where two frequencies coincide the shapes are any mixture: step aside by this part of the step. */
static const double nudge = 1e-5;
enum verdict { FINE, SPLIT, WIDEN };

enum hawser_status hawser__branches_insert(struct hawser__branches *all, int place,
                                           struct hawser__stop *stop,
                                           struct hawser_report *report)
{
	if (all->stops == all->stop_capacity) {
		int capacity = 2*all->stop_capacity + 64;
		struct hawser__stop *grown = realloc(all->stop, (size_t)capacity*sizeof *grown);

		if (!grown) {
			hawser__stop_clear(stop);
			return hawser__no_memory(report, all->course->where);
		}
		all->stop = grown;
		all->stop_capacity = capacity;
	}
	memmove(all->stop + place + 1, all->stop + place,
	        (size_t)(all->stops - place)*sizeof *all->stop);
	all->stop[place] = *stop;
	all->stops++;
	*stop = (struct hawser__stop){0};
	return HAWSER_OK;
}

/* Highest place of a branch that is followed. */
static int top(const struct hawser__branches *all)
{
	int place = all->at_capacity - 1;

	while (place > 0 && all->at[place] >= all->in)
		place--;
	return place;
}

static int contains(const struct hawser__branches *all, int first, int end)
{
	for (int k = first; k < end; k++)
		if (all->at[k] < all->in)
			return 1;
	return 0;
}

/* Do the places first..end-1 go over into each other? */
static int closed(const double *m, int stride, int first, int end, double least)
{
	for (int i = first; i < end; i++) {
		double row = 0.0, column = 0.0;

		for (int j = first; j < end; j++) {
			/* m is full: correlations() fills it */
			/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign) */
			row += m[i*stride + j];
			column += m[j*stride + i];
		}
		if (row < least || column < least)
			return 0;
	}
	return 1;
}

/* pair[*pairs]: lower places of the pairs that exchange their shapes; [count] has room. */
static enum verdict judge(int *pair, int *pairs, struct hawser__branches *all, const double *m,
                          int count)
{
	double least = all->options.correlation, kept = 1.0;
	int highest = top(all), first, end;

	*pairs = 0;
	for (first = 0; first <= highest; first = end) {
		for (end = first + 1; end < count; end++)
			if (closed(m, count, first, end, least))
				break;
		if (!closed(m, count, first, end, least))
			return end - first > 4 ? SPLIT : WIDEN;
		if (!contains(all, first, end))
			continue;
		if (end - first > 2)
			return SPLIT;
		if (end - first == 1)
			/* NOLINTNEXTLINE(clang-analyzer-core.CallAndMessage): the same */
			kept = fmin(kept, m[first*count + first]);
		else if (m[first*count + first + 1] + m[(first + 1)*count + first] > 1.0)
			pair[(*pairs)++] = first;
	}
	all->least_correlation = fmin(all->least_correlation, kept);
	return FINE;
}

/* Modes at x with a place in the sweep; where two branches coincide, a little beside it. */
static enum hawser_status make_stop(struct hawser__stop *stop, struct hawser__branches *all,
                                    double x, double step, struct hawser_report *report)
{
	for (int tries = 0;; tries++) {
		enum hawser_status status = hawser__stop_solve(stop, all, x + tries*nudge*step, 1,
		                                               report);
		int k = 0, highest = top(all);

		if (status)
			return status;
		stop->moved = tries*nudge*step;
		while (k <= highest && k + 1 < stop->in &&
		       hawser__stop_gap(stop, k) > all->options.crossing)
			k++;
		if (k > highest || k + 1 >= stop->in || tries == NUDGES)
			return HAWSER_OK;
		hawser__stop_clear(stop);
	}
}

/* More places for the last stop and for `next`, which are left as they were where that fails. */
static enum hawser_status widen(struct hawser__branches *all, struct hawser__stop *next,
                                struct hawser_report *report)
{
	struct hawser__stop *both[] = {all->stop + all->stops - 1, next};
	int most = both[0]->in > next->in ? both[0]->in : next->in;

	all->need = (all->need > most ? all->need : most) + 1;
	for (int i = 0; i < 2; i++) {
		struct hawser__stop wider;
		enum hawser_status status = hawser__stop_solve(&wider, all, both[i]->x, 1, report);

		if (status)
			return status;
		wider.moved = both[i]->moved;
		wider.inserted = both[i]->inserted;
		hawser__stop_clear(both[i]);
		*both[i] = wider;
	}
	return HAWSER_OK;
}

static void swap_places(struct hawser__branches *all, int k)
{
	int other = all->at[k];

	all->at[k] = all->at[k + 1];
	all->at[k + 1] = other;
	if (top(all) + 3 > all->need)
		all->need = top(all) + 3;
}

/* Squared correlations of the last stop with `next`, count x count, into *m (grown as needed). */
static enum hawser_status correlate(double **m, int *count, const struct hawser__branches *all,
                                    const struct hawser__stop *next, struct hawser_report *report)
{
	const struct hawser__stop *last = all->stop + all->stops - 1;
	double *grown;

	*count = last->in < next->in ? last->in : next->in;
	grown = realloc(*m, (size_t)*count*(size_t)*count*sizeof *grown);
	if (!grown)
		return hawser__no_memory(report, all->course->where);
	*m = grown;
	for (int i = 0; i < *count; i++)
		for (int j = 0; j < *count; j++)
			grown[i**count + j] = hawser__stop_correlation(last, i, next, j, all);
	return HAWSER_OK;
}

/* Verdict on the step from the last stop to `next`; pairs into pair[PLACES_MOST]. */
static enum hawser_status verdict_on(enum verdict *verdict, int *pair, int *pairs,
                                     struct hawser__branches *all, const struct hawser__stop *next,
                                     struct hawser_report *report)
{
	double *m = NULL;
	int count;
	enum hawser_status status = correlate(&m, &count, all, next, report);

	if (!status)
		*verdict = top(all) + 1 < count ? judge(pair, pairs, all, m, count) : WIDEN;
	free(m);
	return status;
}

static enum hawser_status exchange(struct hawser__branches *all, const int *pair, int pairs,
                                   const struct hawser__stop *next, struct hawser_report *report)
{
	for (int i = 0; i < pairs; i++) {
		int known = all->meetings;
		enum hawser_status status = hawser__branches_meet(all, pair[i],
		                                                  all->stop + all->stops - 1, next,
		                                                  report);

		if (status)
			return status;
		if (all->meetings > known && all->meeting[known].kind == HAWSER_CROSSING)
			swap_places(all, pair[i]);
	}
	return HAWSER_OK;
}

static enum hawser_status lost(const struct hawser__branches *all, const struct hawser__stop *stop,
                               struct hawser_report *report)
{
	double least = all->options.least_step;
	char here[HAWSER__HERE];

	all->course->say(here, sizeof here, &stop->statics);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, all->course->where, 0, least,
	                       "at %s three or more branches in the plane change their shapes "
	                       "within a step of %g and cannot be told apart: a small change "
	                       "of the span separates them, or begin and end the range elsewhere",
	                       here, least);
}

/* Half of the way from the last stop to `next`. */
static enum hawser_status split(struct hawser__branches *all, struct hawser__stop *next,
                                struct hawser_report *report);

/* From the last stop to `next`, which is taken over, halving as needed. */
static enum hawser_status reach(struct hawser__branches *all, struct hawser__stop *next,
                                struct hawser_report *report)
{
	int pair[PLACES_MOST], pairs;
	enum verdict verdict = WIDEN;
	enum hawser_status status;

	while ((status = verdict_on(&verdict, pair, &pairs, all, next, report)) == HAWSER_OK &&
	       verdict != FINE) {
		double step = next->x - all->stop[all->stops - 1].x;
		int least = fabs(step) < all->options.least_step;

		if (verdict == SPLIT && least && all->course->marks) {
			next->unsure = 1;
			pairs = 0;
			break;
		}
		status = verdict == WIDEN ? widen(all, next, report)
		         : least ? lost(all, next, report) : split(all, next, report);
		if (status)
			break;
	}
	if (!status)
		status = exchange(all, pair, pairs, next, report);
	if (!status)
		return hawser__branches_insert(all, all->stops, next, report);
	hawser__stop_clear(next);
	return status;
}

static enum hawser_status split(struct hawser__branches *all, struct hawser__stop *next,
                                struct hawser_report *report)
{
	double last = all->stop[all->stops - 1].x, step = next->x - last;
	struct hawser__stop middle;
	enum hawser_status status = make_stop(&middle, all, last + 0.5*step, step, report);

	if (status)
		return status;
	middle.inserted = 1;
	return reach(all, &middle, report);
}

/* How many of the n lowest modes each plane has at the start. */
static enum hawser_status begin(struct hawser__branches *all, double x, double step,
                                struct hawser_report *report)
{
	struct hawser__stop stop;
	enum hawser_status status;

	all->ask = all->options.n;
	status = hawser__stop_solve(&stop, all, x, 0, report);
	if (status)
		return status;
	all->in = stop.in;
	all->out = stop.out;
	hawser__stop_clear(&stop);
	all->need = all->in + 2;
	all->ask += 4;
	all->at_capacity = PLACES_MOST;
	all->at = malloc(PLACES_MOST*sizeof *all->at);
	if (!all->at)
		return hawser__no_memory(report, all->course->where);
	for (int k = 0; k < PLACES_MOST; k++)
		all->at[k] = k;
	status = make_stop(&stop, all, x, step, report);
	return status ? status : hawser__branches_insert(all, 0, &stop, report);
}

enum hawser_status hawser__branches_follow(struct hawser__branches *all, const double *x,
                                           int points, struct hawser_report *report)
{
	enum hawser_status status = begin(all, x[0], x[1] - x[0], report);

	for (int i = 1; i < points && !status; i++) {
		struct hawser__stop next;

		status = make_stop(&next, all, x[i], x[i] - x[i - 1], report);
		if (!status)
			status = reach(all, &next, report);
	}
	return status;
}

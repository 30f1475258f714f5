/* modes/sweep/branches_follow.c - follow branches from sample to sample, with step control
 * (doc/theory-irvine.md).
 *
 *   place    index of an in-plane mode in ascending order of frequency
 *   m_ij     squared correlation of the mode at place i of one sample with that at place j
 *            of the next one
 *   block    a smallest set of neighbouring places whose shapes span nearly the same space at both
 *            samples: the m_ij of each of its rows and columns sum to at least `correlation`
 *
 * In a block of one, the shape has not changed. In a block of two, the two shapes have rotated
 * within the plane that they span, by an angle whose squared sine is m_12. If m_12 exceeds one
 * half, the two frequencies were closest within this step; branches_crossover.c locates that point
 * and decides whether they crossed. Any other block halves the step. The order of the branches
 * therefore changes only at located crossings, and a veering never swaps branches, however narrow
 * it is. The out-of-plane frequencies are eigenvalues of a Sturm-Liouville problem, hence simple:
 * their branches never cross.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "modes/sweep/branches.h"

/* A sample has at most HAWSER__ASK_MOST modes and the few that hawser__branches_enough may add. */
enum { NUDGES = 3, PLACES_MOST = HAWSER__ASK_MOST + 24 };
/* If two frequencies of a sample coincide, their shapes are undetermined, and the abscissa is moved
 * by this fraction of the step: large against round-off, small against any step of interest. */
static const double nudge = 1e-5;
enum verdict { FINE, SPLIT, WIDEN };

enum hawser_status hawser__branches_insert(struct hawser__branches *all, int place,
                                           struct hawser__sample *sample,
                                           struct hawser_report *report)
{
	if (hawser__more(&all->sample, all->samples, sizeof *all->sample)) {
		hawser__sample_clear(sample);
		return hawser__no_memory(report, all->sweep->where);
	}
	memmove(all->sample + place + 1, all->sample + place,
	        (size_t)(all->samples - place)*sizeof *all->sample);
	all->sample[place] = *sample;
	all->samples++;
	*sample = (struct hawser__sample){0};
	return HAWSER_OK;
}

/* Highest place of a requested branch. */
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

/* Are the places first..end-1 a block, with `least` as the least sum of a row or column? */
static int closed(const double *m, int stride, int first, int end, double least)
{
	for (int i = first; i < end; i++) {
		double row = 0.0, column = 0.0;

		for (int j = first; j < end; j++) {
			/* correlate() has filled m */
			/* NOLINTNEXTLINE(clang-analyzer-core.uninitialized.Assign) */
			row += m[i*stride + j];
			column += m[j*stride + i];
		}
		if (row < least || column < least)
			return 0;
	}
	return 1;
}

/* Judge a step by its correlations m[count][count]. pair[*pairs], with room for count: lower places
 * of the pairs that exchange their shapes. */
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

/* Sample at x, or slightly beside x if two frequencies coincide at x. */
static enum hawser_status make_sample(struct hawser__sample *sample, struct hawser__branches *all,
                                    double x, double step, struct hawser_report *report)
{
	for (int tries = 0;; tries++) {
		enum hawser_status status = hawser__sample_solve(sample, all, x + tries*nudge*step, 1,
		                                               report);
		int k = 0, highest = top(all);

		if (status)
			return status;
		sample->moved = tries*nudge*step;
		while (k <= highest && k + 1 < sample->in &&
		       hawser__sample_gap(sample, k) > all->options.crossing)
			k++;
		if (k > highest || k + 1 >= sample->in || tries == NUDGES)
			return HAWSER_OK;
		hawser__sample_clear(sample);
	}
}

/* Recompute the last sample and `next` with one more mode. On failure they are unchanged. */
static enum hawser_status widen(struct hawser__branches *all, struct hawser__sample *next,
                                struct hawser_report *report)
{
	struct hawser__sample *both[] = {all->sample + all->samples - 1, next};
	int most = both[0]->in > next->in ? both[0]->in : next->in;

	all->need = (all->need > most ? all->need : most) + 1;
	for (int i = 0; i < 2; i++) {
		struct hawser__sample wider;
		enum hawser_status status = hawser__sample_solve(&wider, all, both[i]->x, 1, report);

		if (status)
			return status;
		wider.moved = both[i]->moved;
		wider.inserted = both[i]->inserted;
		hawser__sample_clear(both[i]);
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

/* Squared correlations of the last sample with `next`: (*m)[*count][*count], reallocated. */
static enum hawser_status correlate(double **m, int *count, const struct hawser__branches *all,
                                    const struct hawser__sample *next, struct hawser_report *report)
{
	const struct hawser__sample *last = all->sample + all->samples - 1;
	double *grown;

	*count = last->in < next->in ? last->in : next->in;
	grown = realloc(*m, (size_t)*count*(size_t)*count*sizeof *grown);
	if (!grown)
		return hawser__no_memory(report, all->sweep->where);
	*m = grown;
	for (int i = 0; i < *count; i++)
		for (int j = 0; j < *count; j++)
			grown[i**count + j] = hawser__sample_correlation(last, i, next, j, all);
	return HAWSER_OK;
}

/* Judge the step from the last sample to `next`; pair[PLACES_MOST] as for judge(). */
static enum hawser_status verdict_on(enum verdict *verdict, int *pair, int *pairs,
                                     struct hawser__branches *all, const struct hawser__sample *next,
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
                                   const struct hawser__sample *next, struct hawser_report *report)
{
	for (int i = 0; i < pairs; i++) {
		int known = all->crossovers;
		enum hawser_status status = hawser__branches_locate(all, pair[i],
		                                                  all->sample + all->samples - 1, next,
		                                                  report);

		if (status)
			return status;
		if (all->crossovers > known && all->crossover[known].kind == HAWSER_CROSSING)
			swap_places(all, pair[i]);
	}
	return HAWSER_OK;
}

static enum hawser_status lost(const struct hawser__branches *all, const struct hawser__sample *sample,
                               struct hawser_report *report)
{
	double least = all->options.least_step;
	char here[HAWSER__HERE];

	all->sweep->describe(here, sizeof here, &sample->statics);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, all->sweep->where, 0, least,
	                       "at %s three or more branches in the plane change their shapes "
	                       "within a step of %g and cannot be distinguished: a small change "
	                       "of the span separates them, or begin and end the range elsewhere",
	                       here, least);
}

/* Insert a sample halfway between the last sample and `next`. */
static enum hawser_status split(struct hawser__branches *all, struct hawser__sample *next,
                                struct hawser_report *report);

/* Step from the last sample to `next`, halving the step as needed. Takes ownership of `next`. */
static enum hawser_status reach(struct hawser__branches *all, struct hawser__sample *next,
                                struct hawser_report *report)
{
	int pair[PLACES_MOST], pairs;
	enum verdict verdict = WIDEN;
	enum hawser_status status;

	while ((status = verdict_on(&verdict, pair, &pairs, all, next, report)) == HAWSER_OK &&
	       verdict != FINE) {
		double step = next->x - all->sample[all->samples - 1].x;
		int least = fabs(step) < all->options.least_step;

		if (verdict == SPLIT && least && all->sweep->marks) {
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
		return hawser__branches_insert(all, all->samples, next, report);
	hawser__sample_clear(next);
	return status;
}

static enum hawser_status split(struct hawser__branches *all, struct hawser__sample *next,
                                struct hawser_report *report)
{
	double last = all->sample[all->samples - 1].x, step = next->x - last;
	struct hawser__sample middle;
	enum hawser_status status = make_sample(&middle, all, last + 0.5*step, step, report);

	if (status)
		return status;
	middle.inserted = 1;
	return reach(all, &middle, report);
}

/* First sample, and the number of branches in each plane: those of the n lowest modes there. */
static enum hawser_status begin(struct hawser__branches *all, double x, double step,
                                struct hawser_report *report)
{
	struct hawser__sample sample;
	enum hawser_status status;

	all->ask = all->options.n;
	status = hawser__sample_solve(&sample, all, x, 0, report);
	if (status)
		return status;
	all->in = sample.in;
	all->out = sample.out;
	hawser__sample_clear(&sample);
	all->need = all->in + 2;
	all->ask += 4;
	all->at_capacity = PLACES_MOST;
	all->at = malloc(PLACES_MOST*sizeof *all->at);
	if (!all->at)
		return hawser__no_memory(report, all->sweep->where);
	for (int k = 0; k < PLACES_MOST; k++)
		all->at[k] = k;
	status = make_sample(&sample, all, x, step, report);
	return status ? status : hawser__branches_insert(all, 0, &sample, report);
}

void hawser__branches_tell(struct hawser__branches *all, double fraction)
{
	struct hawser_progress_state state;

	if (!all->progress || !hawser__is_watched(all->progress))
		return;
	state = hawser__progress_state(all->sweep->where, "solutions", all->solves,
	                               all->done.began);
	state.fraction = fraction;
	hawser__span_foretell(&all->done, &state);
	(void)hawser__told_to_stop(all->progress, &state);
}

enum hawser_status hawser__branches_follow(struct hawser__branches *all, const double *x,
                                           int points, struct hawser_report *report)
{
	enum hawser_status status = begin(all, x[0], x[1] - x[0], report);

	for (int i = 1; i < points && !status; i++) {
		struct hawser__sample next;

		status = make_sample(&next, all, x[i], x[i] - x[i - 1], report);
		if (!status)
			status = reach(all, &next, report);
		/* the bases grow with the speed: time with its cube, measured on the travelling cables of B */
		hawser__branches_tell(all, pow((i + 1.0)/points, 3.0));
	}
	return status;
}

/* response/branch/cover.c - see hawser/cover.h.
 *
 * A branch is continuous, so it covers every Omega between the least and the greatest of its points.
 * What no branch covers is a list of gaps. The widest gap is taken first: a branch is begun in its
 * middle and followed in both directions, no further than the gap. Where no orbit is found there, the
 * gap is halved; a part below a sixteenth of the range is given up, and stated.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/cover.h>

#include "core/grow.h"
#include "core/progress.h"
#include "core/report.h"
#include "response/branch/trace.h"

#define MOST_STARTS 8 /* in gaps; a start may take as long as a branch */
static const double narrow = 0.002;      /* of the range: a gap that is not looked into */
static const double indivisible = 0.0625; /* of the range: a gap that is not halved */

struct gaps {
	double (*at)[2]; /* [count], ascending; those of width 0 are gone */
	char *given_up;
	int count;
};

static int insert(struct gaps *gaps, int place, double from, double to, int given_up)
{
	if (hawser__more(&gaps->at, gaps->count, sizeof *gaps->at) ||
	    hawser__more(&gaps->given_up, gaps->count, 1))
		return 1;
	memmove(gaps->at + place + 1, gaps->at + place, (size_t)(gaps->count - place)*sizeof *gaps->at);
	memmove(gaps->given_up + place + 1, gaps->given_up + place, (size_t)(gaps->count - place));
	gaps->at[place][0] = from;
	gaps->at[place][1] = to;
	gaps->given_up[place] = (char)given_up;
	gaps->count++;
	return 0;
}

/* Take what the branch covers out of the gaps. 1: no memory. */
static int cut(struct gaps *gaps, const struct hawser_frf *frf)
{
	double least = INFINITY, most = -INFINITY;

	for (int i = 0; i < frf->points && frf->points > 1; i++) {
		least = fmin(least, frf->point[i].omega);
		most = fmax(most, frf->point[i].omega);
	}
	for (int g = 0; g < gaps->count; g++) {
		double *at = gaps->at[g], end = at[1];

		if (most <= at[0] || least >= at[1])
			continue;
		at[1] = fmax(at[0], fmin(at[1], least));
		if (most < end && insert(gaps, g + 1, most, end, gaps->given_up[g]))
			return 1;
		g += most < end;
	}
	return 0;
}

/* No time left is told: most of the time is taken by searches for further branches that find none, and
 * the part of the range that is covered says nothing of them. */
static int watch_gaps(void *data, const struct hawser_progress_state *state)
{
	struct hawser_progress_state told = *state;

	told.fraction = NAN;
	told.left = INFINITY; /* nor does that of the curve before hold */
	return hawser__told_to_stop(data, &told);
}

/* The widest gap that may be looked into, or -1. */
static int widest(const struct gaps *gaps, double range)
{
	int best = -1;
	double width = narrow*range;

	for (int g = 0; g < gaps->count; g++)
		if (!gaps->given_up[g] && gaps->at[g][1] - gaps->at[g][0] > width) {
			width = gaps->at[g][1] - gaps->at[g][0];
			best = g;
		}
	return best;
}

/* A further branch, of which orbits may be known; *frf is it, and stays valid until the next call. It
 * is dropped where it has no two points, and *frf is NULL then, as where no work is left for it. */
static enum hawser_status add(struct hawser_cover *cover, struct hawser_frf **frf,
                              const struct hawser_rom *rom, const struct hawser_frf_options *options,
                              const struct hawser__orbits *known, struct hawser_report *report)
{
	const struct hawser__trace_watch watch = {.known = known, .direct = 1}; /* many starts */
	struct hawser_report local = {.status = HAWSER_OK};
	struct hawser_frf_options left = *options;
	enum hawser_status status;

	*frf = NULL;
	if (options->most_work > 0.0) {
		left.most_work = options->most_work - cover->work;
		cover->costly = left.most_work <= 0.0;
	}
	if (cover->costly)
		return HAWSER_OK;
	if (hawser__more(&cover->branch, cover->branches, sizeof *cover->branch))
		return hawser__no_memory(report, "frf");
	status = hawser__frf_trace(&cover->branch[cover->branches], rom, &left, &watch, &local);
	cover->work += hawser_orbit_work(&cover->branch[cover->branches].cost, rom);
	cover->costly = cover->branch[cover->branches].end == HAWSER_END_WORK;
	if (status && status != HAWSER_ERR_CONVERGENCE) {
		hawser_frf_clear(&cover->branch[cover->branches]);
		if (report)
			*report = local;
		return status;
	}
	if (cover->branch[cover->branches].points < 2) {
		hawser_frf_clear(&cover->branch[cover->branches]);
		return HAWSER_OK;
	}
	*frf = &cover->branch[cover->branches++];
	(*frf)->branch = 1 + cover->branches;
	return HAWSER_OK;
}

/* From the middle of a gap to each of its ends: to the second one from the orbit with which the
 * curve to the first one began. *found: 0 where no orbit was found there. */
static enum hawser_status both_ways(struct hawser_cover *cover, int *found, struct gaps *gaps, int g,
                                    const struct hawser_rom *rom,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report)
{
	struct hawser_frf_options part = *options;
	double from = gaps->at[g][0], to = gaps->at[g][1];

	*found = 0;
	part.begin = 0.5*(from + to);
	for (int way = 0; way < 2; way++) {
		struct hawser_frf *frf;
		enum hawser_status status;

		part.from = way ? options->from : options->to;
		part.to = way ? options->to : options->from;
		status = add(cover, &frf, rom, &part, NULL, report);
		if (!status && !frf && part.start) {
			part.start = NULL;
			status = add(cover, &frf, rom, &part, NULL, report);
		}
		if (status || !frf)
			return status;
		*found = 1;
		part.start = frf->state;
		if (cut(gaps, frf))
			return hawser__no_memory(report, "frf");
		if (frf->end == HAWSER_END_INTERRUPTED || frf->end == HAWSER_END_CLOSED || cover->costly)
			return HAWSER_OK;
	}
	return HAWSER_OK;
}

static int ended(const struct hawser_cover *cover)
{
	return cover->costly || (cover->branches > 0 &&
	                         cover->branch[cover->branches - 1].end == HAWSER_END_INTERRUPTED);
}

static enum hawser_status fill_gaps(struct hawser_cover *cover, struct gaps *gaps, double range,
                                    const struct hawser_rom *rom,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report)
{
	for (int i = 0, g; i < MOST_STARTS && (g = widest(gaps, range)) >= 0; i++) {
		double from = gaps->at[g][0], to = gaps->at[g][1], middle = 0.5*(from + to);
		enum hawser_status status;
		int found;

		if ((status = both_ways(cover, &found, gaps, g, rom, options, report)) || ended(cover))
			return status;
		if (found)
			continue;
		if (!(to - from > indivisible*range)) {
			gaps->given_up[g] = 1;
			continue;
		}
		gaps->at[g][1] = middle;
		if (insert(gaps, g + 1, middle, to, 0))
			return hawser__no_memory(report, "frf");
	}
	return HAWSER_OK;
}

/* The gaps that are left, neighbours joined. 1: no memory. */
static int list_gaps(struct hawser_cover *cover, const struct gaps *gaps, double range)
{
	cover->gap = malloc(2*((size_t)gaps->count + 1)*sizeof *cover->gap);
	if (!cover->gap)
		return 1;
	for (int g = 0; g < gaps->count; g++) {
		const double *at = gaps->at[g];

		if (!(at[1] - at[0] > narrow*range))
			continue;
		if (cover->gaps > 0 && cover->gap[2*cover->gaps - 1] == at[0]) {
			cover->gap[2*cover->gaps - 1] = at[1];
			continue;
		}
		cover->gap[2*cover->gaps] = at[0];
		cover->gap[2*cover->gaps + 1] = at[1];
		cover->gaps++;
	}
	return 0;
}

int hawser_cover_needed(const struct hawser_frf *first, const struct hawser_frf_options *options)
{
	return first->points > 0 && !options->start &&
	       (options->begin == 0.0 || options->begin == options->from) &&
	       (first->end == HAWSER_END_RETURNED || first->end == HAWSER_END_SLACK ||
	        first->end == HAWSER_END_AT_REST || first->end == HAWSER_END_CLOSED ||
	        first->end == HAWSER_END_UNSTABLE || first->end == HAWSER_END_LOST);
}

enum hawser_status hawser_cover_trace(struct hawser_cover *cover, const struct hawser_frf *first,
                                      const struct hawser_rom *rom,
                                      const struct hawser_frf_options *options,
                                      struct hawser_report *report)
{
	double lo = fmin(options->from, options->to), hi = fmax(options->from, options->to);
	struct hawser_frf_options back = *options;
	struct gaps gaps = {.at = NULL};
	struct hawser_progress progress = options->progress;
	struct hawser_frf *frf;
	enum hawser_status status = HAWSER_OK;

	*cover = (struct hawser_cover){.branches = 0};
	if (!hawser_cover_needed(first, options))
		return HAWSER_OK;
	back.from = options->to;
	back.to = options->from;
	back.begin = 0.0;
	back.direction = 0;
	if (hawser__is_watched(&options->progress))
		back.progress = (struct hawser_progress){watch_gaps, &progress};
	if (insert(&gaps, 0, lo, hi, 0) || cut(&gaps, first))
		status = hawser__no_memory(report, "frf");
	if (!status)
		status = add(cover, &frf, rom, &back, first->back, report);
	if (!status && frf && cut(&gaps, frf))
		status = hawser__no_memory(report, "frf");
	if (!status && !ended(cover))
		status = fill_gaps(cover, &gaps, hi - lo, rom, &back, report);
	if (!status && list_gaps(cover, &gaps, hi - lo))
		status = hawser__no_memory(report, "frf");
	free(gaps.at);
	free(gaps.given_up);
	if (status)
		hawser_cover_clear(cover);
	return status;
}

void hawser_cover_clear(struct hawser_cover *cover)
{
	for (int i = 0; i < cover->branches; i++)
		hawser_frf_clear(&cover->branch[i]);
	free(cover->branch);
	free(cover->gap);
	memset(cover, 0, sizeof *cover);
}

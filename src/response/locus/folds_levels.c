/* response/locus/folds_levels.c - the least load with a fold: responses at falling loads.
 *
 * A response shows the folds at one load. At each load it is traced from both ends of the range: if
 * a branch leaves the range at its upper end, its fold is outside, and the branch from the other
 * end has the second fold of the pair. Fold curves connect these folds with other loads. A fold
 * curve may, however, lie within the range at low loads only, so that the nominal response has none
 * of its folds. Therefore responses are traced at falling loads as well, from the largest one on, where
 * a branch that is detached at the nominal load may have joined the main one, and the curves through
 * their folds are followed. They are traced in a window wider than the range, but for those at the
 * largest load where folds are known already. One of these loads is just below the least load on all
 * curves, which verifies it. The search ends at a response that is nearly linear and has no fold.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "response/locus/folds_search.h"

#define BELOW 0.97 /* first load examined below the least known load, relative to it; chosen */
/* For the time left alone, as of shipped scenes; measured: */
#define FIRST_TIME 0.7 /* of the responses at the first load, over that of those at the nominal load */
#define LESS 0.8       /* mean time of those that follow over the last one */
#define AFTER 0.4      /* the search ends at this load, relative to the least one with folds */
#define ASIDE 1e-8 /* error to which the folds of these responses are located: they are corrected as
                    * folds; chosen */
#define RATIO 0.6  /* ratio of successive loads; chosen */

/* The least load at which a fold has been found. */
static double least(const struct hawser_folds *folds)
{
	double load = INFINITY;

	for (int c = 0; c < folds->curves; c++)
		load = fmin(load, folds->curve[c].least_load);
	for (int i = 0; i < folds->lost; i++)
		load = fmin(load, folds->lost_at[i].load);
	return load;
}

/* Trace a response, forward or in reverse, with the curves through its folds. (Without multipliers,
 * whose number tells that a step has jumped to another branch, it would take two thirds of the time and
 * lose curves: 2 of 7 of b-table-4.5.) *same: 1: it begins on the orbit on which `other` ended, and is
 * not traced. *failed: 1: it could not be traced to its end. */
static enum hawser_status respond(struct hawser__fold_search *search, struct hawser_frf *frf,
                                  const struct hawser__load *load, int reverse, int wide,
                                  const struct hawser_frf *other, int *same, int *failed)
{
	struct hawser__fold_watch watch = {.options = search->options,
		.stage = reverse ? "response in reverse" : "response", .other = other};
	struct hawser_frf_options choice = hawser__fold_response(search, &watch);
	struct hawser_report local = {.status = HAWSER_OK};
	struct hawser_rom rom = load->rom;
	int up = choice.to > choice.from;
	double middle = 0.5*(search->part[0] + search->part[1]);
	enum hawser_status status;

	hawser__span_stage(&search->walk.span, reverse ? middle : search->part[0],
	                   reverse ? search->part[1] : middle);

	if (wide) {
		choice.from = up ? search->walk.window_lo : search->walk.window_hi;
		choice.to = up ? search->walk.window_hi : search->walk.window_lo;
	}
	if (reverse) {
		double keep = choice.from;

		choice.from = choice.to;
		choice.to = keep;
	}
	choice.samples = HAWSER_NONE;
	search->for_folds = load->factor != 1.0;
	if (search->for_folds) {
		choice.most_unstable = search->options->most_unstable;
		choice.event_tolerance = ASIDE;
		memset(&rom.shapes, 0, sizeof rom.shapes);
		memset(&rom.line, 0, sizeof rom.line);
	}
	status = hawser__fold_trace(search, frf, &rom, &choice, &local);
	search->for_folds = 0;
	if (status == HAWSER_ERR_MEMORY) {
		if (search->report)
			*search->report = local;
		return status;
	}
	*same = watch.same;
	search->cut += !status && frf->end == HAWSER_END_UNSTABLE;
	*failed = status || hawser__fold_limited(frf);
	search->folds->interrupted |= !watch.same && frf->end == HAWSER_END_INTERRUPTED;
	if (load->factor < 1.0 && load->factor >= least(search->folds))
		return HAWSER_OK; /* a fold at a lower load is known: this failure has no effect */
	if (!wide && !status)
		hawser__fold_note_cut(search, frf, load->factor);
	if (!wide && status)
		hawser__fold_note(search, "the response at load factor %.6g could not be traced to its "
		                  "end (%.150s)", load->factor, local.message);
	return HAWSER_OK;
}

enum hawser_status hawser__fold_note_level(struct hawser__fold_search *search, double load, int wide,
                                           int found)
{
	struct hawser_folds *folds = search->folds;

	if (hawser__more(&folds->level, folds->levels, sizeof *folds->level))
		return hawser__no_memory(search->report, "folds");
	folds->level[folds->levels++] = (struct hawser_folds_level){.load = load, .folds = found,
		.from = wide ? search->walk.window_lo : search->walk.omega_lo,
		.to = wide ? search->walk.window_hi : search->walk.omega_hi};
	return HAWSER_OK;
}

enum hawser_status hawser__fold_reverse(struct hawser__fold_search *search,
                                        const struct hawser_frf *first,
                                        const struct hawser__load *load, int wide,
                                        struct hawser__fold_level *level)
{
	struct hawser_frf frf = {0};
	int failed = 0, same = 0;
	enum hawser_status status = respond(search, &frf, load, 1, wide,
	                                    first->end == HAWSER_END_RANGE ? first : NULL, &same,
	                                    &failed);

	level->failed |= failed;
	level->linear &= same;
	if (!status && !same && !search->folds->interrupted) {
		level->folds += hawser__fold_count(&frf);
		status = hawser__fold_curves(search, &frf, load->factor);
		if (!status && !wide && load->factor == 1.0 && !search->options->skip_isolas &&
		    frf.points > 1 && !failed)
			return hawser__fold_keep(search, &frf);
	}
	hawser_frf_clear(&frf);
	return status;
}

/* Responses at this load from both ends of the range or of the window. */
static enum hawser_status both(struct hawser__fold_search *search, const struct hawser__load *load,
                               int wide, struct hawser__fold_level *level)
{
	struct hawser_frf frf = {0};
	int same;
	enum hawser_status status = respond(search, &frf, load, 0, wide, NULL, &same, &level->failed);

	level->linear = !status && !level->failed && hawser__fold_linear(search, load, &frf);
	level->folds = hawser__fold_count(&frf);
	if (!status && !search->folds->interrupted)
		status = hawser__fold_curves(search, &frf, load->factor);
	if (hawser__fold_ended(search)) {
		level->failed = 1;
		level->linear = 0;
	} else if (!status) {
		status = hawser__fold_reverse(search, &frf, load, wide, level);
	}
	if (!status && !level->failed)
		status = hawser__fold_note_level(search, load->factor, wide, level->folds);
	hawser_frf_clear(&frf);
	return status;
}

/* Trace the curves through the folds at this load, within the range or, if `wide`, within its window.
 * If a response cannot be traced in the window, it is traced within the range. */
static enum hawser_status search_load(struct hawser__fold_search *search, double factor, int wide,
                                      struct hawser__fold_level *level)
{
	struct hawser__load load = {0};
	enum hawser_status status = hawser__load_open(&load, search->rom, search->report);

	*level = (struct hawser__fold_level){0};
	if (!status) {
		hawser__load_set(&load, factor);
		status = both(search, &load, wide, level);
		/* a trace that fails outside the range may succeed within it */
		if (!status && wide && level->failed && !hawser__fold_ended(search)) {
			*level = (struct hawser__fold_level){0};
			status = both(search, &load, 0, level);
		}
	}
	hawser__load_clear(&load);
	return status;
}

/* The load after `at`: just below the least load with a known fold, if there is one. */
static double next_load(double at, double known)
{
	if (at > known)
		return fmax(RATIO*at, BELOW*known);
	return isfinite(known) && at > BELOW*known ? BELOW*at : RATIO*at;
}

/* Foretell the responses at this load, which take `each` s, and what follows. Returns the time so
 * far, s. */
static double foretell(struct hawser__fold_search *search, double load, double each)
{
	double last = fmax(search->options->load_from, AFTER*fmin(least(search->folds), load));
	double rest = LESS*each*ceil(fmax(log(last/load)/log(RATIO), 0.0));
	double done = hawser__wall_seconds() - search->walk.span.began;

	hawser__fold_ahead(search, each, rest + hawser__fold_detached(search, done + each + rest));
	return done;
}

/* The loads that were not searched for the work that they take. */
static void note_rest(struct hawser__fold_search *search)
{
	const struct hawser_folds *folds = search->folds;
	double load = INFINITY;

	for (int i = 0; i < folds->levels; i++)
		load = fmin(load, folds->level[i].load);
	if (folds->levels > 0)
		hawser__fold_note(search, "load factors below %.6g were not searched, as the work came to its "
		                  "limit", load);
	else
		hawser__fold_note(search, "no load was searched from both ends of the range, as the work came "
		                  "to its limit");
}

enum hawser_status hawser__fold_levels(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;
	double floor = search->options->load_from, load = search->options->load_to;
	double each = FIRST_TIME*(hawser__wall_seconds() - search->walk.span.began);
	int done = load <= floor, cut = 0, none = !isfinite(least(folds)), first = load > 1.0 || none;

	while (!done && !hawser__fold_ended(search)) {
		struct hawser__fold_level level;
		enum hawser_status status;
		double before;

		if (!first)
			load = fmax(next_load(load, least(folds)), floor);
		before = foretell(search, load, each);
		status = search_load(search, load, none || !first, &level);
		each = hawser__wall_seconds() - search->walk.span.began - before;
		first = 0;
		if (status)
			return status;
		/* loads above the least known one need no search */
		cut = load < least(folds) && (cut || level.failed);
		folds->nearly_linear = level.linear && load < least(folds);
		done = folds->nearly_linear || load <= floor;
	}
	folds->searched = done && !cut && !folds->interrupted;
	if (!folds->searched && search->walk.costly)
		note_rest(search);
	if (search->cut > 0)
		hawser__fold_note(search, "%d responses at other loads ended where more than %d multipliers "
		                  "are unstable, and folds beyond are found only where a curve leads there "
		                  "(--unstable)", search->cut, search->options->most_unstable);
	return HAWSER_OK;
}

/* The kind of the point at which a curve has its least load. */
static enum hawser_folds_least_kind kind_of(const struct hawser__fold_search *search,
                                            const struct hawser_folds_curve *curve)
{
	const struct hawser_folds *folds = search->folds;

	if (curve->least_event >= 0)
		switch (folds->event[curve->least_event].kind) {
		case HAWSER_FOLDS_CUSP: return HAWSER_FOLDS_LEAST_CUSP;
		case HAWSER_FOLDS_ISOLA: return HAWSER_FOLDS_LEAST_ISOLA;
		case HAWSER_FOLDS_BIFURCATION: return HAWSER_FOLDS_LEAST_BIFURCATION;
		default: break;
		}
	if (curve->least_load == search->options->load_from)
		return HAWSER_FOLDS_LEAST_LOAD;
	if (curve->least_omega == search->walk.omega_lo || curve->least_omega == search->walk.omega_hi)
		return HAWSER_FOLDS_LEAST_OMEGA;
	return HAWSER_FOLDS_LEAST_BOUND;
}

void hawser__fold_least(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;

	folds->least_load = INFINITY;
	for (int c = 0; c < folds->curves; c++)
		if (folds->curve[c].least_load < folds->least_load) {
			folds->least_load = folds->curve[c].least_load;
			folds->least_omega = folds->curve[c].least_omega;
			folds->least_kind = kind_of(search, &folds->curve[c]);
		}
	for (int i = 0; i < folds->lost; i++)
		if (folds->lost_at[i].load < folds->least_load) {
			folds->least_load = folds->lost_at[i].load;
			folds->least_omega = folds->lost_at[i].omega;
			folds->least_kind = HAWSER_FOLDS_LEAST_BOUND;
		}
	if (folds->least_kind != HAWSER_FOLDS_LEAST_LOAD && !folds->searched)
		folds->least_kind = HAWSER_FOLDS_LEAST_BOUND;
}

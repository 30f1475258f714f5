/* response/locus/folds.c - fold curves: from the folds of responses to curves through all of them.
 *
 * The responses at the nominal load are searched for folds, from both ends of the range. Then follow
 * responses at falling loads (folds_levels.c). A fold on a known curve starts no new one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/progress.h"
#include "core/report.h"
#include "core/settle.h"
#include "response/time/flow.h"
#include "response/locus/folds_search.h"
#include "rom/terms/drag.h"
#include "rom/terms/terms.h"
#include "rom/file/entries.h"

#define SAME_ORBIT 1e-5 /* relative distance below which two orbits are the same; chosen, above the
                         * errors of located folds */
#define NOMINAL 0.15 /* part of a search that is done after the responses at the nominal load, with
                      * their curves, as of shipped scenes (1 to 6 s); measured */
#define SAME_LOAD 1e-9 /* relative difference of their loads, likewise */

void hawser_folds_settle(struct hawser_folds_options *options)
{
	hawser__settle(&options->load_from, 0.01);
	hawser__settle(&options->load_to, 2.0);
	hawser__settle(&options->tolerance, 1e-9);
	hawser__settle(&options->event_tolerance, 1e-10);
	hawser__settle(&options->step_max, 0.02);
	hawser__settle_count(&options->max_points, 5000);
	hawser__settle_count(&options->starts, 96);
	if (!options->method)
		options->method = "balance";
}

static enum hawser_status check(const struct hawser_rom *rom,
                                const struct hawser_folds_options *options,
                                struct hawser_report *report)
{
	if (rom->drag)
		return hawser__drag_refuse(rom, "a search for folds", report);
	if (hawser__rom_more(rom))
		return hawser__more_refuse(rom, "a search for folds", report);
	if (rom->periods > 1)
		return hawser__periods_refuse(rom, "a search for folds", report);
	if (!(options->from > 0.0) || !(options->to > 0.0) || options->from == options->to ||
	    !isfinite(options->from) || !isfinite(options->to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "folds",
		                    "frequency range from %.9g%s to %.9g%s: both ends must be "
		                    "positive, finite and different",
		                    HAWSER_SHOWN(rom, options->from), HAWSER_SHOWN(rom, options->to));
	if (!(options->load_from > 0.0) || !(options->load_from < 1.0) ||
	    !(options->load_to >= 1.0) || !isfinite(options->load_to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "folds",
		                    "load factors from %.9g to %.9g: the first must be between 0 and "
		                    "1, the second 1 or more (1 is the model's own load)",
		                    options->load_from, options->load_to);
	if (!(options->tolerance >= 1e-13 && options->tolerance <= 1e-4))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "folds",
		                    "tolerance %g: must be between 1e-13 and 1e-4",
		                    options->tolerance);
	if (options->max_points < 2 || !(options->step_max > 0.0) ||
	    !(options->event_tolerance > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "folds",
		                    "max points %d (2 or more), largest step %g and event tolerance %g "
		                    "(positive): one is out of range", options->max_points,
		                    options->step_max, options->event_tolerance);
	return HAWSER_OK;
}

void hawser__fold_ahead(struct hawser__fold_search *search, double stage, double after)
{
	hawser__span_ahead(&search->walk.span, stage, after);
	search->part[0] = search->walk.span.from;
	search->part[1] = search->walk.span.to;
}

int hawser__fold_told_to_stop(struct hawser__fold_search *search, const char *stage, const char *unit,
                              long done)
{
	struct hawser__span *span = &search->walk.span;
	struct hawser_progress_state state;

	if (!hawser__is_watched(&search->options->progress))
		return 0;
	state = hawser__progress_state(stage, unit, done, span->began);
	hawser__span_foretell(span, &state);
	search->folds->interrupted |= hawser__told_to_stop(&search->options->progress, &state);
	return search->folds->interrupted;
}

int hawser__fold_watch(void *data, const struct hawser_progress_state *state)
{
	struct hawser__fold_watch *watch = data;
	struct hawser_progress_state told = *state;
	const struct hawser_frf *frf = state->frf, *other = watch->other;
	size_t m = 2*(size_t)frf->n;

	if (other && other->points > 0 && frf->points == 1)
		watch->same = hawser__same_state(other->state + m*(size_t)(other->points - 1), frf->state,
		                                 (int)m, SAME_ORBIT);
	if (watch->same)
		return 1;
	told.stage = watch->stage;
	hawser__span_foretell(watch->span, &told);
	told.load = 1.0;
	return hawser__told_to_stop(&watch->options->progress, &told);
}

struct hawser_frf_options hawser__fold_response(struct hawser__fold_search *search,
                                                struct hawser__fold_watch *watch)
{
	struct hawser_frf_options choice = {.method = search->options->method};

	choice.from = search->options->from;
	choice.to = search->options->to;
	choice.tolerance = search->options->tolerance;
	choice.max_points = search->options->max_points;
	watch->span = &search->walk.span;
	choice.progress = (struct hawser_progress){hawser__fold_watch, watch};
	return choice;
}

/* Whether the start of the curve lies on a known curve. */
static int known(struct hawser__fold_search *search)
{
	const struct hawser__orbit *orbit = hawser__fold_orbit(&search->fold);
	const double *z = search->walk.start.z;

	orbit->ops->state(orbit, search->walk.state, z);
	return hawser__known_fold(&search->known, z[search->fold.size - 2], z[search->fold.size - 1],
	                          search->walk.state);
}

/* The least load of a list within the range of Omega. */
static double least_of(const struct hawser__fold_list *list, const double *range)
{
	double load = INFINITY;

	for (int p = 0; p < list->points; p++)
		if (list->point[p].omega >= range[0] && list->point[p].omega <= range[1])
			load = fmin(load, list->point[p].load);
	return load;
}

/* Whether the list ended before its curve did. */
static int unfinished(const struct hawser__fold_list *list)
{
	return list->end == HAWSER_FOLDS_MAX_POINTS || list->end == HAWSER_FOLDS_FAILED ||
	       list->end == HAWSER_FOLDS_WORK;
}

/* Add the curve to the result. A known curve is left out, unless it reaches lower loads or an
 * unfinished curve exists that it may continue. */
static enum hawser_status take(struct hawser__fold_search *search,
                               const struct hawser__fold_list *back,
                               const struct hawser__fold_list *on)
{
	const double range[] = {search->walk.omega_lo, search->walk.omega_hi};
	struct hawser_folds *folds = search->folds;
	double least = INFINITY;
	enum hawser_status status;

	for (int c = 0; c < folds->curves; c++)
		least = fmin(least, folds->curve[c].least_load);
	if (!search->unfinished &&
	    (hawser__known_curve(&search->known, on, range) ||
	     hawser__known_curve(&search->known, back, range)) &&
	    fmin(least_of(on, range), least_of(back, range)) >= least*(1.0 - SAME_LOAD))
		return HAWSER_OK;
	search->unfinished |= unfinished(on) || unfinished(back);
	if ((status = hawser__known_add(&search->known, back, range, search->report)) ||
	    (status = hawser__known_add(&search->known, on, range, search->report)))
		return status;
	return hawser__list_join(folds, back, on, range, search->report);
}

/* Half a curve. It ends if no available discretisation is accurate enough. */
static enum hawser_status follow(struct hawser__fold_search *search, struct hawser__fold_list *list,
                                 int direction)
{
	struct hawser__fold_walk *walk = &search->walk;
	struct hawser_report local = {.status = HAWSER_OK};
	enum hawser_status status;

	walk->report = &local;
	status = hawser__walk_follow(walk, list, direction);
	walk->report = search->report;
	if (status == HAWSER_ERR_CONVERGENCE) {
		list->end = HAWSER_FOLDS_FAILED;
		snprintf(list->message, sizeof list->message, "%.220s", local.message);
		return HAWSER_OK;
	}
	if (status && search->report)
		*search->report = local;
	return status;
}

enum hawser_status hawser__fold_new(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;
	struct hawser__fold_walk *walk = &search->walk;
	struct hawser__fold_list back = {.n = folds->n, .probes = folds->probes}, on = back;
	int size = search->fold.size;
	enum hawser_status status = HAWSER_OK;

	if (known(search))
		return HAWSER_OK;
	if (walk->start.z[size - 1] == 1.0) {
		struct hawser_folds_event event = {.kind = HAWSER_FOLDS_NOMINAL,
			.omega = walk->start.z[size - 2], .load = 1.0};

		status = hawser__list_event(&on, walk, &event, walk->start.z);
	}
	if (!status)
		status = follow(search, &on, 1);
	if (!status && on.end != HAWSER_FOLDS_CLOSED && on.end != HAWSER_FOLDS_INTERRUPTED)
		status = follow(search, &back, -1);
	if (!status)
		status = take(search, &back, &on);
	folds->interrupted |= walk->stopped;
	hawser__list_clear(&back);
	hawser__list_clear(&on);
	return status;
}

enum hawser_status hawser__fold_lost(struct hawser__fold_search *search, double omega, double load)
{
	struct hawser_folds *folds = search->folds;

	if (hawser__more(&folds->lost_at, folds->lost, sizeof *folds->lost_at))
		return hawser__no_memory(search->report, "folds");
	folds->lost_at[folds->lost++] = (struct hawser_folds_lost){omega, load};
	return HAWSER_OK;
}

enum hawser_status hawser__fold_curves(struct hawser__fold_search *search,
                                       const struct hawser_frf *frf, double load)
{
	enum hawser_status status = HAWSER_OK;

	for (int e = 0; !status && e < frf->events && !search->folds->interrupted; e++) {
		int failed;

		if (frf->event[e].kind != HAWSER_FOLD ||
		    hawser__known_passage(&search->known, frf->event[e].omega, load))
			continue;
		search->walk.stage = "fold curve";
		status = hawser__fold_seed(search, frf, &frf->event[e], load, &failed);
		if (status == HAWSER_ERR_CONVERGENCE) {
			status = HAWSER_OK;
			failed = 1;
		}
		if (status)
			break;
		if (failed && (frf->event[e].omega < search->walk.omega_lo ||
		               frf->event[e].omega > search->walk.omega_hi))
			continue; /* not asked for */
		if (failed)
			status = hawser__fold_lost(search, frf->event[e].omega, load);
		else if (!known(search))
			status = hawser__fold_images(search);
	}
	return status;
}

int hawser__fold_count(const struct hawser_frf *frf)
{
	int folds = 0;

	for (int e = 0; e < frf->events; e++)
		folds += frf->event[e].kind == HAWSER_FOLD;
	return folds;
}

void hawser__fold_note(struct hawser__fold_search *search, const char *format, ...)
{
	struct hawser_folds *folds = search->folds;
	static const char between[] = "; ", more[] = "; and further gaps";
	size_t length = strlen(folds->note), room = sizeof folds->note - sizeof more + 1 - length;
	char text[sizeof folds->note];
	va_list arguments;

	if (length && strcmp(folds->note + length - strlen(more), more) == 0)
		return;
	va_start(arguments, format);
	vsnprintf(text, sizeof text, format, arguments);
	va_end(arguments);
	snprintf(folds->note + length, sizeof folds->note - length, "%s%s", length ? between : "",
	         strlen(text) + strlen(between) < room ? text : more + strlen(between));
}

void hawser__fold_note_cut(struct hawser__fold_search *search, const struct hawser_frf *frf,
                           double load)
{
	if (hawser__fold_limited(frf))
		hawser__fold_note(search, "the response at load factor %.6g ended at Omega %.6g%s, after %d "
		                  "points: folds beyond may be missing (--max-points)", load,
		                  HAWSER_SHOWN(search->rom, frf->point[frf->points - 1].omega), frf->points);
}

/* The response at the nominal load, which is part of the result, and the one traced in reverse. */
static enum hawser_status nominal_load(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;
	struct hawser__fold_watch watch = {.options = search->options, .stage = "response"};
	struct hawser_frf_options choice = hawser__fold_response(search, &watch);
	struct hawser__load load = {0};
	struct hawser__fold_level level = {0};
	enum hawser_status status = hawser__fold_trace(search, &folds->response, search->rom, &choice,
	                                               search->report);

	if (status)
		return status;
	folds->interrupted = folds->response.end == HAWSER_END_INTERRUPTED;
	hawser__fold_note_cut(search, &folds->response, 1.0);
	level.failed = hawser__fold_limited(&folds->response);
	level.folds = hawser__fold_count(&folds->response);
	status = hawser__fold_curves(search, &folds->response, 1.0);
	if (status || hawser__fold_ended(search))
		return status;
	if (!(status = hawser__load_open(&load, search->rom, search->report)) &&
	    !(status = hawser__fold_reverse(search, &folds->response, &load, 0, &level)) && !level.failed)
		status = hawser__fold_note_level(search, 1.0, 0, level.folds);
	hawser__load_clear(&load);
	return status;
}

/* The response at the nominal load through a motion that was given, to both sides. */
static enum hawser_status given_response(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;
	const struct hawser_frf_options *first = search->options->first;
	struct hawser__fold_watch watch = {.options = search->options, .stage = "response"};
	struct hawser_frf_options choice = hawser__fold_response(search, &watch);
	struct hawser_frf *frf = &folds->response, back = {0};
	enum hawser_status status;

	choice.start = first->start;
	choice.along = first->along;
	choice.begin = first->begin;
	status = hawser__fold_trace(search, frf, search->rom, &choice, search->report);
	if (status)
		return status;
	folds->interrupted = frf->end == HAWSER_END_INTERRUPTED;
	hawser__fold_note_cut(search, frf, 1.0);
	if (!folds->interrupted)
		status = hawser__fold_curves(search, frf, 1.0);
	if (status || frf->points < 2 || frf->end == HAWSER_END_CLOSED || hawser__fold_ended(search))
		return status;
	choice.start = frf->state;
	choice.along = NULL;
	choice.begin = frf->point[0].omega;
	choice.direction = frf->point[1].omega > frf->point[0].omega ? -1 : 1;
	status = hawser__fold_trace(search, &back, search->rom, &choice, search->report);
	folds->interrupted = back.end == HAWSER_END_INTERRUPTED;
	if (!status)
		hawser__fold_note_cut(search, &back, 1.0);
	if (!status && !folds->interrupted)
		status = hawser__fold_curves(search, &back, 1.0);
	hawser_frf_clear(&back);
	return status;
}

/* Nothing but a limit explains why there is no result. */
static enum hawser_status costly(const struct hawser__fold_search *search, const char *what)
{
	return hawser__fail(search->report, HAWSER_ERR_CONVERGENCE, "folds",
	                    "%s in the part of the search that was done: fewer modes (-n) or a narrower "
	                    "range take less work, --max-points N goes on", what);
}

/* The note that explains why nothing was found. */
static enum hawser_status none(const struct hawser__fold_search *search)
{
	const struct hawser_folds *folds = search->folds;
	const struct hawser_folds_options *options = search->options;
	int searched = options->first ? !folds->note[0] && !folds->costly
	               : folds->searched && !hawser__fold_limited(&folds->response);

	if (folds->lost == 0 && !searched && folds->costly)
		return costly(search, "no fold was found");
	if (folds->lost == 0 && options->first && searched)
		return hawser__fail(search->report, HAWSER_ERR_NO_SOLUTION, "folds",
		                    "the response through that motion has no fold between Omega %.9g%s and "
		                    "%.9g%s at the model's own load: without --from-label other responses and "
		                    "loads are searched", HAWSER_SHOWN(search->rom, options->from),
		                    HAWSER_SHOWN(search->rom, options->to));
	if (folds->lost == 0 && !searched)
		return hawser__fail(search->report, HAWSER_ERR_CONVERGENCE, "folds",
		                    "no fold was found, but %s: raise --max-points, change --tolerance "
		                    "or narrow the range",
		                    folds->note);
	if (folds->lost == 0)
		return hawser__fail(search->report, HAWSER_ERR_NO_SOLUTION, "folds",
		                    "the response has no fold between Omega %.9g%s and %.9g%s: nothing "
		                    "jumps there at load factors from %.6g to %.6g, by responses at %d "
		                    "of them from both ends of the range%s; raise --load-to%s%s",
		                    HAWSER_SHOWN(search->rom, options->from),
		                    HAWSER_SHOWN(search->rom, options->to),
		                    options->load_from, options->load_to, folds->levels,
		                    folds->nearly_linear ? " down to a nearly linear one" : "",
		                    folds->note[0] ? "; " : "", folds->note);
	return hawser__fail(search->report, HAWSER_ERR_CONVERGENCE, "folds",
	                    "none of %d folds of the response could be converged as a fold: "
	                    "loosen --tolerance", folds->lost);
}

/* Responses at all loads, and detached ones. */
static enum hawser_status search_responses(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;
	enum hawser_status status = nominal_load(search);

	if (!status && !folds->interrupted)
		status = hawser__fold_levels(search);
	if (!status && !search->options->skip_isolas && !folds->interrupted)
		status = hawser__fold_isolas(search);
	if (!status && !search->options->skip_isolas && !hawser__fold_ended(search))
		status = hawser__fold_starts(search);
	return status;
}

static enum hawser_status search_curves(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;
	enum hawser_status status;

	search->part[1] = search->options->first ? 1.0 : NOMINAL;
	hawser__span_stage(&search->walk.span, 0.0, search->part[1]);
	status = search->options->first ? given_response(search) : search_responses(search);
	folds->costly = search->walk.costly;
	if (status || folds->interrupted)
		return status;
	if (folds->curves == 0)
		return none(search);
	if (folds->points == 0 && folds->costly)
		return costly(search, "no curve got beyond the fold it began at");
	if (folds->points == 0)
		return hawser__fail(search->report, HAWSER_ERR_CONVERGENCE, "folds",
		                    "no curve got beyond the fold it began at: %s", folds->curve[0].message);
	return HAWSER_OK;
}

enum hawser_status hawser_folds_trace(struct hawser_folds *folds, const struct hawser_rom *rom,
                                      const struct hawser_folds_options *options,
                                      struct hawser_report *report)
{
	struct hawser_folds_options settled = *options;
	struct hawser__fold_search search = {.folds = folds, .rom = rom, .options = &settled,
		.unasked = options->starts == 0, .report = report};
	enum hawser_status status;

	*folds = (struct hawser_folds){.n = rom->n, .probes = rom->shapes.points};
	hawser_folds_settle(&settled);
	options = &settled;
	if ((status = check(rom, options, report)) ||
	    (status = hawser__numbers_check(rom, HAWSER_ERR_NAN, report)))
		return status;
	search.known.m = 2*rom->n;
	search.beside = calloc(2*(size_t)rom->n, sizeof(double));
	if (!search.beside)
		return hawser__no_memory(report, "folds");
	if (!(status = hawser__fold_decay(&search)) &&
	    !(status = hawser__fold_open(&search.fold, rom, report)) &&
	    !(status = hawser__walk_open(&search.walk, &search.fold, options, report))) {
		search.seeds.size = search.passages.size = search.fold.size - 1;
		search.walk.passages = &search.passages;
		search.walk.window_lo = search.window[0];
		search.walk.window_hi = search.window[1];
		if (!(status = search_curves(&search)))
			hawser__fold_least(&search);
	}
	folds->solves = search.fold.solves;
	free(search.beside);
	free(search.decay);
	hawser__known_clear(&search.known);
	hawser__store_clear(&search.seeds);
	hawser__store_clear(&search.passages);
	hawser__walk_clear(&search.walk);
	hawser__fold_close(&search.fold);
	return status;
}

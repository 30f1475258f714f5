/* response/folds.c - fold curves: from the folds of responses to curves through all of them.
 *
 * Responses at two loads are searched for folds: the nominal one, and the largest, where what is
 * detached at the nominal load may have joined the main curve. A fold that lies on a curve already
 * known begins no other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/flow.h"
#include "response/folds_search.h"
#include "rom/entries.h"

#define SAME_OMEGA 1e-6 /* relative: two folds at one load are the same */
#define SAME_FREQUENCY 1e-7 /* between what shooting has located and harmonic balance */
#define SAME_STATE 1e-3

struct hawser_folds_options hawser_folds_defaults(void)
{
	return (struct hawser_folds_options){.load_from = 0.01, .load_to = 2.0, .tolerance = 1e-9,
		.event_tolerance = 1e-10, .max_points = 5000, .step_max = 0.02, .isolas = 1,
		.method = "balance"};
}

static enum hawser_status check(const struct hawser_rom *rom,
                                const struct hawser_folds_options *options,
                                struct hawser_report *report)
{
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

int hawser__fold_watch(void *context, const struct hawser_frf *frf)
{
	const struct hawser__fold_watch *watch = context;
	const struct hawser_folds_options *options = watch->options;
	double omega = frf->points ? frf->point[frf->points - 1].omega : 0.0;

	return options->progress &&
	       options->progress(options->progress_context, watch->stage, frf->points, omega, 1.0);
}

struct hawser_frf_options hawser__fold_response(const struct hawser__fold_search *search,
                                                struct hawser__fold_watch *watch)
{
	struct hawser_frf_options choice = hawser_frf_defaults();

	choice.method = search->options->method;
	choice.from = search->options->from;
	choice.to = search->options->to;
	choice.tolerance = search->options->tolerance;
	choice.max_points = search->options->max_points;
	choice.progress = hawser__fold_watch;
	choice.progress_context = watch;
	return choice;
}

static int same_state(const double *a, const double *b, int m)
{
	double gap = 0.0, sum = 0.0;

	for (int i = 0; i < m; i++) {
		gap += (a[i] - b[i])*(a[i] - b[i]);
		sum += a[i]*a[i] + b[i]*b[i];
	}
	return gap <= SAME_STATE*SAME_STATE*sum;
}

static int same(double omega, double load, const double *state, double other_omega,
                double other_load, const double *other_state, int m)
{
	return fabs(omega - other_omega) <= SAME_OMEGA*omega &&
	       fabs(load - other_load) <= SAME_OMEGA*load && same_state(state, other_state, m);
}

/* Whether a curve that is known passes this frequency at this load: in a passage of the nominal load,
 * or at an end. A mirror image of that motion, if it is one, draws the same curve. */
static int passed(const struct hawser_folds *folds, double omega, double load)
{
	for (int e = 0; e < folds->events; e++)
		if (folds->event[e].load == load &&
		    fabs(folds->event[e].omega - omega) <= SAME_FREQUENCY*omega)
			return 1;
	for (int c = 0; c < folds->curves; c++)
		for (int k = 0; k < 2 && folds->curve[c].points > 0; k++) {
			const struct hawser_folds_curve *curve = &folds->curve[c];
			int p = curve->first + (k ? curve->points - 1 : 0);

			if (folds->point[p].load == load &&
			    fabs(folds->point[p].omega - omega) <= SAME_FREQUENCY*omega)
				return 1;
		}
	return 0;
}

/* Whether the walk's start lies on a curve that is known, to the last digits. */
static int known(struct hawser__fold_search *search)
{
	const struct hawser_folds *folds = search->folds;
	const struct hawser__orbit *orbit = hawser__fold_orbit(&search->fold);
	const double *z = search->walk.start.z;
	double *state = search->walk.state, omega = z[search->fold.size - 2];
	double load = z[search->fold.size - 1];
	size_t m = 2*(size_t)folds->n;

	orbit->ops->state(orbit, state, z);
	for (int e = 0; e < folds->events; e++)
		if (same(omega, load, state, folds->event[e].omega, folds->event[e].load,
		         folds->event_state + (size_t)e*m, (int)m))
			return 1;
	for (int c = 0; c < folds->curves; c++) {
		int first = folds->curve[c].first, last = first + folds->curve[c].points - 1;

		for (int p = first; p <= last; p += last > first ? last - first : 1)
			if (same(omega, load, state, folds->point[p].omega, folds->point[p].load,
			         folds->state + (size_t)p*m, (int)m))
				return 1;
	}
	return 0;
}

/* The curve through the walk's start. */
static enum hawser_status trace_curve(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;
	struct hawser__fold_walk *walk = &search->walk;
	struct hawser__fold_list back = {.n = folds->n, .probes = folds->probes}, on = back;
	int size = search->fold.size;
	enum hawser_status status = HAWSER_OK;

	if (walk->start.z[size - 1] == 1.0) {
		struct hawser_folds_event event = {.kind = HAWSER_FOLDS_NOMINAL,
			.omega = walk->start.z[size - 2], .load = 1.0};

		status = hawser__list_event(&on, walk, &event, walk->start.z);
	}
	if (!status)
		status = hawser__walk_follow(walk, &on, 1);
	if (!status && on.end != HAWSER_FOLDS_CLOSED && on.end != HAWSER_FOLDS_INTERRUPTED)
		status = hawser__walk_follow(walk, &back, -1);
	if (!status)
		status = hawser__list_join(folds, &back, &on, search->report);
	folds->interrupted |= walk->stopped;
	hawser__list_clear(&back);
	hawser__list_clear(&on);
	return status;
}

enum hawser_status hawser__fold_lost(struct hawser__fold_search *search, double omega, double load)
{
	struct hawser_folds *folds = search->folds;
	struct hawser_folds_lost *larger = realloc(folds->lost_at,
	                                           ((size_t)folds->lost + 1)*sizeof *larger);

	if (!larger)
		return hawser__no_memory(search->report, "folds");
	folds->lost_at = larger;
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
		    passed(search->folds, frf->event[e].omega, load))
			continue;
		search->walk.stage = "fold curve";
		status = hawser__fold_seed(search, frf, &frf->event[e], load, &failed);
		if (status == HAWSER_ERR_CONVERGENCE) {
			status = HAWSER_OK;
			failed = 1;
		}
		if (status)
			break;
		if (failed)
			status = hawser__fold_lost(search, frf->event[e].omega, load);
		else if (!known(search))
			status = trace_curve(search);
	}
	return status;
}

static int count_folds(const struct hawser_frf *frf)
{
	int folds = 0;

	for (int e = 0; e < frf->events; e++)
		folds += frf->event[e].kind == HAWSER_FOLD;
	return folds;
}

/* What a limit has cut may have folds beyond. */
static void note_cut(struct hawser__fold_search *search, const struct hawser_frf *frf, double load)
{
	struct hawser_folds *folds = search->folds;
	size_t length = strlen(folds->note);

	if (frf->end == HAWSER_END_MAX_POINTS)
		snprintf(folds->note + length, sizeof folds->note - length,
		         "%sthe response at load factor %.6g ended at Omega %.6g%s, after %d points: "
		         "folds beyond may be missing (--max-points)", length ? "; " : "", load,
		         HAWSER_SHOWN(search->rom, frf->point[frf->points - 1].omega), frf->points);
}

/* The response at load_to: its failure is told, and what it found before is used. */
static enum hawser_status largest_load(struct hawser__fold_search *search, int *found)
{
	const struct hawser_folds_options *options = search->options;
	struct hawser__fold_watch watch = {options, "response at the largest load"};
	struct hawser_frf_options choice = hawser__fold_response(search, &watch);
	struct hawser_report local = {.status = HAWSER_OK};
	struct hawser__load load = {0};
	struct hawser_frf frf = {0};
	enum hawser_status status = hawser__load_open(&load, search->rom, search->report);

	if (!status) {
		hawser__load_set(&load, options->load_to);
		choice.samples = 0;
		status = hawser__fold_trace(search, &frf, &load.rom, &choice, &local);
		if (status && status != HAWSER_ERR_MEMORY) {
			size_t length = strlen(search->folds->note);

			snprintf(search->folds->note + length, sizeof search->folds->note - length,
			         "%sthe response at load factor %.6g could not be traced to its end "
			         "(%.150s)", length ? "; " : "", options->load_to, local.message);
			status = HAWSER_OK;
		} else if (status && search->report) {
			*search->report = local;
		}
	}
	search->folds->interrupted |= !status && frf.end == HAWSER_END_INTERRUPTED;
	*found = count_folds(&frf);
	note_cut(search, &frf, options->load_to);
	if (!status)
		status = hawser__fold_curves(search, &frf, options->load_to);
	hawser_frf_clear(&frf);
	hawser__load_clear(&load);
	return status;
}

static enum hawser_status search_curves(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;
	struct hawser__fold_watch watch = {search->options, "response"};
	struct hawser_frf_options choice = hawser__fold_response(search, &watch);
	int found = 0;
	enum hawser_status status = hawser__fold_trace(search, &folds->response, search->rom, &choice,
	                                               search->report);

	if (status)
		return status;
	folds->interrupted = folds->response.end == HAWSER_END_INTERRUPTED;
	note_cut(search, &folds->response, 1.0);
	status = hawser__fold_curves(search, &folds->response, 1.0);
	if (!status && !folds->interrupted && search->options->load_to > 1.0)
		status = largest_load(search, &found);
	if (status || folds->interrupted)
		return status;
	if (folds->curves == 0 && folds->lost == 0 &&
	    folds->response.end == HAWSER_END_MAX_POINTS)
		return hawser__fail(search->report, HAWSER_ERR_CONVERGENCE, "folds",
		                    "no fold was found, but %s: raise it, or narrow the range",
		                    folds->note);
	if (folds->curves == 0 && folds->lost == 0)
		return hawser__fail(search->report, HAWSER_ERR_NO_SOLUTION, "folds",
		                    "the response has no fold between Omega %.9g%s and %.9g%s, at loads "
		                    "of 1 and %.6g times the given one: nothing jumps there; raise "
		                    "--load-to%s%s", HAWSER_SHOWN(search->rom, search->options->from),
		                    HAWSER_SHOWN(search->rom, search->options->to),
		                    search->options->load_to, folds->note[0] ? "; " : "", folds->note);
	if (folds->curves == 0)
		return hawser__fail(search->report, HAWSER_ERR_CONVERGENCE, "folds",
		                    "none of %d folds of the response could be converged as a fold: "
		                    "loosen --tolerance", folds->lost);
	if (folds->points == 0)
		return hawser__fail(search->report, HAWSER_ERR_CONVERGENCE, "folds",
		                    "no curve got beyond the fold it began at: %s", folds->curve[0].message);
	return HAWSER_OK;
}

enum hawser_status hawser_folds_trace(struct hawser_folds *folds, const struct hawser_rom *rom,
                                      const struct hawser_folds_options *options,
                                      struct hawser_report *report)
{
	struct hawser__fold_search search = {.folds = folds, .rom = rom, .options = options,
		.report = report};
	enum hawser_status status;

	*folds = (struct hawser_folds){.n = rom->n, .probes = rom->shapes.points};
	if ((status = check(rom, options, report)) ||
	    (status = hawser__numbers_check(rom, HAWSER_ERR_NAN, report)))
		return status;
	search.beside = calloc(2*(size_t)rom->n, sizeof(double));
	if (!search.beside)
		return hawser__no_memory(report, "folds");
	if (!(status = hawser__fold_open(&search.fold, rom, report)) &&
	    !(status = hawser__walk_open(&search.walk, &search.fold, options, report))) {
		search.seeds.size = search.passages.size = search.fold.size - 1;
		search.walk.passages = &search.passages;
		if (!(status = search_curves(&search)) && options->isolas && !folds->interrupted)
			status = hawser__fold_isolas(&search);
	}
	folds->solves = search.fold.solves;
	free(search.beside);
	hawser__store_clear(&search.seeds);
	hawser__store_clear(&search.passages);
	hawser__walk_clear(&search.walk);
	hawser__fold_close(&search.fold);
	return status;
}

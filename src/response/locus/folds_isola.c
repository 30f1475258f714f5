/* response/locus/folds_isola.c - response curves that are detached from the main one.
 *
 * A fold curve crosses the nominal load once for every fold of the nominal response. A crossing
 * that is a fold neither of the main response nor of a traced detached curve belongs to a new
 * detached curve. The trace of that curve starts at its fold: the orbit is moved along the null
 * vector v by a small part of its size,
 *
 *      y = y_fold + e v,    Omega = Omega_fold - e^2 f_xx / (2 f_Omega)
 *
 * and corrected normal to v, since at the fold Omega does not determine the orbit, and near it the
 * problem is ill-conditioned. The continuation then follows the whole curve.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "response/locus/folds_search.h"

/* For the time left alone, as of shipped scenes; measured: */
#define ISOLAS 0.15 /* time of the detached curves over that before, */
#define STARTS 0.3  /* and of those from pseudo-random motions */
#define SAME_FOLD 1e-6 /* relative difference of Omega below which two folds are the same; chosen */

static int has_fold(const struct hawser_frf *frf, double omega)
{
	for (int e = 0; e < frf->events; e++)
		if (frf->event[e].kind == HAWSER_FOLD &&
		    fabs(frf->event[e].omega - omega) <= SAME_FOLD*omega)
			return 1;
	return 0;
}

static int visited(const struct hawser_folds *folds, double omega)
{
	int found = has_fold(&folds->response, omega);

	for (int i = 0; i < folds->isolas; i++)
		found |= has_fold(&folds->isola[i], omega);
	return found;
}

/* walk->start = the fold at exactly the nominal load, with its null vectors. */
static enum hawser_status at_fold(struct hawser__fold_search *search, double omega, int *failed)
{
	const double *y = hawser__store_find(&search->passages, omega);
	struct hawser__fold *fold = &search->fold;
	const struct hawser__balance *balance = &fold->balance;
	double residual, *v = search->walk.lo.t;
	enum hawser_status status = HAWSER_OK;

	*failed = 1;
	if (y)
		status = hawser__walk_begin_orbit(&search->walk, y, 1.0, failed);
	if (status || *failed)
		return status;
	/* with the fold's own borders, v has length 1 */
	status = hawser__fold_evaluate(fold, &residual, search->walk.start.z, search->report);
	memset(v, 0, (size_t)fold->size*sizeof *v);
	for (int i = 0; i < balance->unknowns; i++)
		v[balance->slot[i]] = balance->col_scale[i]*
		                      fold->x[3*((size_t)balance->unknowns + 1) + (size_t)i];
	search->bend = fold->second/fold->F_omega*balance->base.W;
	return status;
}

/* State [2n] and *omega of the response beside the fold, at the relative distance e along the null
 * vector v = walk.lo.t. Returns 1 if there is no such orbit. */
static int beside(struct hawser__fold_search *search, double e, double *omega)
{
	struct hawser__orbit *orbit = hawser__fold_orbit(&search->fold);
	struct hawser__correction correction;
	double *z = search->walk.scratch.z, *v = search->walk.lo.t;
	int size = search->fold.size;

	for (int i = 0; i < size; i++)
		z[i] = search->walk.start.z[i] + e*v[i];
	z[size - 2] -= 0.5*e*e*search->bend;
	if (hawser__orbit_correct(orbit, z, &correction, v, search->options->tolerance))
		return 1;
	*omega = z[size - 2];
	orbit->ops->state(orbit, search->beside, z);
	return 0;
}

/* Trace a curve from a state beside the fold. *found: 1: the curve has that fold. */
static enum hawser_status trace_from(struct hawser__fold_search *search, struct hawser_frf *frf,
                                     const struct hawser_frf_options *choice, double fold_omega,
                                     int *found)
{
	struct hawser_report local;
	enum hawser_status status = hawser__fold_trace(search, frf, search->rom, choice,
	                                               &local);

	*found = frf->end == HAWSER_END_INTERRUPTED || has_fold(frf, fold_omega);
	if (!*found || status == HAWSER_ERR_MEMORY)
		hawser_frf_clear(frf);
	if (status == HAWSER_ERR_MEMORY && search->report)
		*search->report = local;
	return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
}


enum hawser_status hawser__fold_keep(struct hawser__fold_search *search, struct hawser_frf *frf)
{
	struct hawser_folds *folds = search->folds;
	struct hawser_frf kept = *frf;

	if (hawser__more(&folds->isola, folds->isolas, sizeof *folds->isola)) {
		hawser_frf_clear(frf);
		return hawser__no_memory(search->report, "folds");
	}
	folds->isola[folds->isolas++] = *frf;
	folds->interrupted |= kept.end == HAWSER_END_INTERRUPTED;
	return folds->interrupted ? HAWSER_OK : hawser__fold_curves(search, &kept, 1.0);
}

/* The curve through the fold at the start. An open curve is followed in both directions. */
static enum hawser_status trace(struct hawser__fold_search *search, double fold_omega, int *found)
{
	/* the last distances are for a curve near its isola centre */
	static const double part[] = {0.3, -0.3, 0.1, -0.1, 0.03, -0.03, 0.01, -0.01, 3e-3, -3e-3, 1e-3,
		-1e-3, 3e-4, 1e-4};
	struct hawser__fold_watch watch = {.options = search->options, .stage = "detached curve"};
	struct hawser_frf_options choice = hawser__fold_response(search, &watch);
	struct hawser_frf frf = {0};
	enum hawser_status status = HAWSER_OK;
	double *start = search->beside;
	int open;

	*found = 0;
	for (size_t k = 0; !status && !*found && k < sizeof part/sizeof *part; k++) {
		if (beside(search, part[k], &choice.begin) ||
		    !(choice.begin > fmin(choice.from, choice.to) &&
		      choice.begin < fmax(choice.from, choice.to)))
			continue;
		choice.start = start;
		/* towards the fold, since in the other direction the curve may leave the range at once */
		choice.direction = choice.begin < fold_omega ? 1 : -1;
		status = trace_from(search, &frf, &choice, fold_omega, found);
	}
	if (status || !*found)
		return status;
	open = frf.end == HAWSER_END_RANGE || frf.end == HAWSER_END_RETURNED;
	if ((status = hawser__fold_keep(search, &frf)) || !open || hawser__fold_ended(search))
		return status;
	choice.direction = -choice.direction;
	frf = (struct hawser_frf){0};
	status = hawser__fold_trace(search, &frf, search->rom, &choice, NULL);
	if (status != HAWSER_ERR_MEMORY && frf.points > 0)
		return hawser__fold_keep(search, &frf);
	hawser_frf_clear(&frf);
	return status == HAWSER_ERR_MEMORY ? hawser__no_memory(search->report, "folds") : HAWSER_OK;
}

double hawser__fold_detached(const struct hawser__fold_search *search, double before)
{
	const struct hawser_folds_options *options = search->options;

	return options->skip_isolas ? 0.0 : before*(ISOLAS + (options->starts > 0 ? STARTS : 0.0));
}

enum hawser_status hawser__fold_isolas(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;
	double done = hawser__wall_seconds() - search->walk.span.began;

	hawser__fold_ahead(search, ISOLAS*done, hawser__fold_detached(search, done) - ISOLAS*done);
	if (hawser__fold_told_to_stop(search, "detached curves", "known", folds->isolas))
		return HAWSER_OK;
	/* the list of events grows in this loop */
	for (int e = 0; e < folds->events; e++) {
		double omega = folds->event[e].omega;
		int failed, found = 0;
		enum hawser_status status;

		if (folds->event[e].kind != HAWSER_FOLDS_NOMINAL || visited(folds, omega))
			continue;
		if (hawser__fold_ended(search))
			break;
		status = at_fold(search, omega, &failed);
		if (!status && !failed)
			status = trace(search, omega, &found);
		if (status && status != HAWSER_ERR_CONVERGENCE)
			return status;
		if (!found && (status = hawser__fold_lost(search, omega, 1.0)))
			return status;
	}
	return HAWSER_OK;
}

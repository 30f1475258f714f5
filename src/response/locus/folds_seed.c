/* response/locus/folds_seed.c - folds of a response, as starting points of fold curves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "core/report.h"
#include "response/locus/folds_search.h"
#include "response/branch/trace.h"

/* Most work of a response once the search has none left, s: it ends after its first orbit. */
static const double least_work = 1e-9;

/* The equations of a fold have the unknowns of harmonic balance. */
static void keep_fold(void *context, const struct hawser_frf_event *event,
                      const struct hawser__orbit *orbit, const double *y)
{
	struct hawser__fold_search *search = context;

	if (event->kind == HAWSER_FOLD && orbit->ops == search->fold.balance.base.ops &&
	    orbit->size == search->seeds.size)
		hawser__store_add(&search->seeds, y);
}

enum hawser_status hawser__fold_trace(struct hawser__fold_search *search, struct hawser_frf *frf,
                                      const struct hawser_rom *rom,
                                      const struct hawser_frf_options *choice,
                                      struct hawser_report *report)
{
	const struct hawser__trace_watch watch = {.event = keep_fold, .context = search,
		.for_folds = search->for_folds};
	struct hawser_frf_options limited = *choice;
	enum hawser_status status;

	hawser__store_clear(&search->seeds);
	if (search->options->most_work > 0.0)
		limited.most_work = fmax(hawser__walk_left(&search->walk), least_work);
	status = hawser__frf_trace(frf, rom, &limited, &watch, report);
	search->walk.work += hawser_orbit_work(&frf->cost, rom);
	search->walk.costly |= frf->end == HAWSER_END_WORK;
	return search->seeds.failed ? hawser__no_memory(report, "folds") : status;
}

/* Whether the start is the required fold: Newton's method may have converged to another one. */
static int is_fold(const struct hawser__fold_search *search, double omega)
{
	return fabs(search->walk.start.z[search->fold.size - 2] - omega) <= 1e-5*omega;
}

/* Start from the orbit at the fold if harmonic balance found it; otherwise from the points on both
 * sides. */
enum hawser_status hawser__fold_seed(struct hawser__fold_search *search,
                                     const struct hawser_frf *frf,
                                     const struct hawser_frf_event *event, double load,
                                     int *failed)
{
	const double *y = hawser__store_find(&search->seeds, event->omega);
	int p = event->after, m = 2*frf->n;
	enum hawser_status status = HAWSER_OK;

	*failed = 1;
	if (y) {
		status = hawser__walk_begin_orbit(&search->walk, y, load, failed);
		*failed |= !is_fold(search, event->omega);
	}
	for (int k = 0; !status && *failed && k < 2 && p + k < frf->points; k++) {
		status = hawser__walk_begin(&search->walk, frf->state + (size_t)(p + k)*(size_t)m,
		                            frf->point[p + k].omega, load, failed);
		*failed |= !is_fold(search, event->omega);
	}
	if (status || !*failed || p + 1 >= frf->points)
		return status;
	status = hawser__walk_begin_between(&search->walk, frf->state + (size_t)p*(size_t)m,
	                                    frf->point[p].omega,
	                                    frf->state + (size_t)(p + 1)*(size_t)m,
	                                    frf->point[p + 1].omega, load, failed);
	*failed |= !is_fold(search, event->omega);
	return status;
}

/* response/folds_levels.c - the least load at which the response has a fold: responses at falling loads.
 *
 * A response shows the folds of one load. At each load it is traced from both ends of the range, since
 * a branch that leaves the range above has its fold beyond, and the branch from the other end has the
 * other fold of the pair. Fold curves lead from there to other loads. But a curve may lie within the
 * range at low loads only, and none of its folds be met at the nominal load. So responses follow at
 * falling loads, in a window somewhat wider than the range, and the curves of their folds; one of the
 * loads is a little below the least one on all curves, which is checked so. The search ends with a
 * response that is nearly linear and has no fold.
 *
 *   l_k   logarithms of the moduli of the multipliers of an orbit, in falling order
 *   L_k   those of the linear model, 2 pi Re(lambda_k)/Omega, in falling order
 *
 * At a fold some l_k is 0. A response is called nearly linear where |l_k - L_k| <= |L_k|/2 at every
 * point of it: each multiplier has gone less than half of the way. The difference is proportional to
 * the load or to its square at small loads, so that it is smaller still at smaller ones.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/flow.h"
#include "response/folds_search.h"
#include "rom/entries.h"

#define MARGIN 0.1 /* of the window beside the range, relative */
#define NEAR 0.3   /* of a natural frequency to the range, relative */
#define BELOW 0.97 /* of the least load found: the first one that is checked */
#define RATIO 0.6  /* of successive loads */
#define NEARLY_LINEAR 0.5
#define FASTEST 30.0 /* |L_k| beyond which a multiplier, below 1e-13, is round-off */

static int falling(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x < y) - (x > y);
}

/* The window about the range: a margin on both sides, or up to a margin beyond the natural frequency
 * next to the range, if that is near: its resonance may bend into the range. */
static void set_window(struct hawser__fold_search *search, const double *natural, int count)
{
	double lo = fmin(search->options->from, search->options->to);
	double hi = fmax(search->options->from, search->options->to), below = lo, above = hi;

	for (int k = 0; k < count; k++) {
		if (natural[k] < lo && natural[k] > lo*(1.0 - NEAR) && (below == lo || natural[k] > below))
			below = natural[k];
		if (natural[k] > hi && natural[k] < hi*(1.0 + NEAR) && (above == hi || natural[k] < above))
			above = natural[k];
	}
	search->window[0] = below*(1.0 - MARGIN);
	search->window[1] = above*(1.0 + MARGIN);
}

enum hawser_status hawser__fold_decay(struct hawser__fold_search *search)
{
	const struct hawser_rom *rom = search->rom;
	int n = rom->n, m = 2*n;
	double *A = calloc((size_t)m*(size_t)m, sizeof *A), *imaginary = malloc((size_t)m*sizeof *A);
	enum hawser_status status = HAWSER_OK;
	lapack_int info;

	search->decay = malloc(2*(size_t)m*sizeof *search->decay);
	if (!A || !imaginary || !search->decay) {
		status = hawser__no_memory(search->report, "folds");
		goto done;
	}
	for (int j = 0; j < n; j++) {
		A[(size_t)j*(size_t)m + (size_t)(n + j)] = 1.0;
		for (int k = 0; k < n; k++) {
			A[(size_t)(n + j)*(size_t)m + (size_t)k] = -rom->K[j*n + k];
			A[(size_t)(n + j)*(size_t)m + (size_t)(n + k)] = -rom->D[j*n + k];
		}
	}
	info = LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', m, A, m, search->decay, imaginary, NULL, m,
	                     NULL, m);
	if (hawser__lapack_starved(info))
		status = hawser__no_memory(search->report, "folds");
	for (int k = 0; info && k < m; k++)
		search->decay[k] = 0.0; /* then no response is nearly linear, and all loads are looked at */
	set_window(search, imaginary, info ? 0 : m);
	qsort(search->decay, (size_t)m, sizeof(double), falling);
done:
	free(A);
	free(imaginary);
	return status;
}

/* Whether every point of the response is nearly linear. */
static int nearly_linear(const struct hawser__fold_search *search, const struct hawser_frf *frf)
{
	int m = 2*frf->n;
	double *l = search->decay + m;

	for (int p = 0; p < frf->points; p++) {
		double period = 2.0*M_PI/frf->point[p].omega;

		for (int k = 0; k < m; k++)
			l[k] = frf->multiplier[2*((size_t)p*(size_t)m + (size_t)k)];
		qsort(l, (size_t)m, sizeof *l, falling);
		for (int k = 0; k < m; k++) {
			double L = search->decay[k]*period;

			if (fabs(L) <= FASTEST && !(fabs(l[k] - L) <= NEARLY_LINEAR*fabs(L)))
				return 0;
		}
	}
	return frf->end == HAWSER_END_RANGE;
}

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

/* A response, forward or in reverse, with its folds. One that begins on the orbit on which `other`
 * ended is not traced: *same. *failed where it could not be traced to its end. */
static enum hawser_status respond(struct hawser__fold_search *search, struct hawser_frf *frf,
                                  const struct hawser__load *load, int reverse, int wide,
                                  const struct hawser_frf *other, int *same, int *failed)
{
	struct hawser__fold_watch watch = {.options = search->options,
		.stage = reverse ? "response in reverse" : "response", .other = other};
	struct hawser_frf_options choice = hawser__fold_response(search, &watch);
	struct hawser_report local = {.status = HAWSER_OK};
	int up = choice.to > choice.from;
	enum hawser_status status;

	if (wide) {
		choice.from = up ? search->walk.window_lo : search->walk.window_hi;
		choice.to = up ? search->walk.window_hi : search->walk.window_lo;
	}
	if (reverse) {
		double keep = choice.from;

		choice.from = choice.to;
		choice.to = keep;
	}
	choice.samples = 0;
	status = hawser__fold_trace(search, frf, &load->rom, &choice, &local);
	if (status == HAWSER_ERR_MEMORY) {
		if (search->report)
			*search->report = local;
		return status;
	}
	*same = watch.same;
	*failed = status || frf->end == HAWSER_END_MAX_POINTS;
	search->folds->interrupted |= !status && !watch.same && frf->end == HAWSER_END_INTERRUPTED;
	if (load->factor < 1.0 && load->factor >= least(search->folds))
		return HAWSER_OK; /* there is a fold at a lower load: this one does not matter */
	if (!wide && *failed && !status)
		hawser__fold_note(search, HAWSER__FOLDS_CUT, load->factor,
		                  HAWSER_SHOWN(search->rom, frf->point[frf->points - 1].omega),
		                  frf->points);
	if (!wide && status)
		hawser__fold_note(search, "the response at load factor %.6g could not be traced to its "
		                  "end (%.150s)", load->factor, local.message);
	return HAWSER_OK;
}

enum hawser_status hawser__fold_note_level(struct hawser__fold_search *search, double load, int wide,
                                           int found)
{
	struct hawser_folds *folds = search->folds;
	struct hawser_folds_level *larger = realloc(folds->level,
	                                            ((size_t)folds->levels + 1)*sizeof *larger);

	if (!larger)
		return hawser__no_memory(search->report, "folds");
	folds->level = larger;
	larger[folds->levels++] = (struct hawser_folds_level){.load = load, .folds = found,
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
		if (!status && !wide && load->factor == 1.0 && search->options->isolas && frf.points > 1 &&
		    !failed)
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

	level->linear = !status && !level->failed && nearly_linear(search, &frf);
	level->folds = hawser__fold_count(&frf);
	if (!status && !search->folds->interrupted)
		status = hawser__fold_curves(search, &frf, load->factor);
	if (!status && !search->folds->interrupted)
		status = hawser__fold_reverse(search, &frf, load, wide, level);
	if (!status && !level->failed)
		status = hawser__fold_note_level(search, load->factor, wide, level->folds);
	hawser_frf_clear(&frf);
	return status;
}

enum hawser_status hawser__fold_level(struct hawser__fold_search *search, double factor, int wide,
                                      struct hawser__fold_level *level)
{
	struct hawser__load load = {0};
	enum hawser_status status = hawser__load_open(&load, search->rom, search->report);

	*level = (struct hawser__fold_level){0};
	if (!status) {
		hawser__load_set(&load, factor);
		status = both(search, &load, wide, level);
		/* what fails beyond the range's ends may do within them */
		if (!status && wide && level->failed && !search->folds->interrupted) {
			*level = (struct hawser__fold_level){0};
			status = both(search, &load, 0, level);
		}
	}
	hawser__load_clear(&load);
	return status;
}

/* The load after `at`: below the least one with a fold that is known, if any, and no lower at first. */
static double next_load(double at, double known)
{
	if (at > known)
		return fmax(RATIO*at, BELOW*known);
	return isfinite(known) && at > BELOW*known ? BELOW*at : RATIO*at;
}

enum hawser_status hawser__fold_levels(struct hawser__fold_search *search)
{
	struct hawser_folds *folds = search->folds;
	double floor = search->options->load_from, load = search->options->load_to;
	int done = load <= floor, cut = 0, first = 1;

	while (!done && !folds->interrupted) {
		struct hawser__fold_level level;
		enum hawser_status status;

		/* where nothing is known, the largest load itself in the window */
		if (!first || isfinite(least(folds)))
			load = fmax(next_load(load, least(folds)), floor);
		first = 0;
		status = hawser__fold_level(search, load, 1, &level);
		if (status)
			return status;
		/* above the least load that is known nothing matters to it */
		cut = load < least(folds) && (cut || level.failed);
		folds->nearly_linear = level.linear && load < least(folds);
		done = folds->nearly_linear || load <= floor;
	}
	folds->searched = !cut && !folds->interrupted;
	return HAWSER_OK;
}

/* What the least load of a curve is. */
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

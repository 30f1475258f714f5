/* response/locus/folds_known.c - which folds lie on curves that have been traced.
 *
 * Every point of every curve is stored, also those outside the range: Omega, load, and the state at the
 * start of a period. A fold found at another load is known if it lies between two successive points of
 * a stored curve. A curve is known if it shares a special point, a crossing of the range's end, or an
 * end at a bound of the load with a stored one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "response/locus/folds_search.h"

#define SAME_OMEGA 1e-6 /* relative: folds at one load that are nearer than this are the same;
                         * chosen */
#define SAME_FREQUENCY 1e-7 /* relative difference of a fold located by shooting and by harmonic
                             * balance; chosen from their tolerances */
#define SAME_STATE 1e-3 /* relative difference of their orbits; chosen */
#define BESIDE 0.1 /* distance from a chord in lengths of the chord: successive tangents differ by
                    * at most 0.5 rad */

/* FIRST: the first point of a curve, without a preceding chord. MARK: an exact point, stored
 * outside the order of the curve. */
enum { POINT = 0, FIRST, MARK };

static enum hawser_status add(struct hawser__fold_known *known, int kind, double omega, double load,
                              const double *state, struct hawser_report *report)
{
	size_t m = (size_t)known->m;

	if (hawser__more(&known->place, known->count, sizeof *known->place) ||
	    hawser__more(&known->state, known->count, m*sizeof *known->state))
		return hawser__no_memory(report, "folds");
	memcpy(known->state + (size_t)known->count*m, state, m*sizeof *state);
	known->place[known->count++] = (struct hawser__fold_place){omega, load, kind};
	return HAWSER_OK;
}

void hawser__known_clear(struct hawser__fold_known *known)
{
	free(known->place);
	free(known->state);
}

int hawser__same_state(const double *a, const double *b, int m, double tolerance)
{
	double gap = 0.0, sum = 0.0;

	for (int i = 0; i < m; i++) {
		gap += (a[i] - b[i])*(a[i] - b[i]);
		sum += a[i]*a[i] + b[i]*b[i];
	}
	return gap <= tolerance*tolerance*sum;
}

int hawser__known_passage(const struct hawser__fold_known *known, double omega, double load)
{
	for (int i = 0; i < known->count; i++)
		if (known->place[i].kind == MARK && known->place[i].load == load &&
		    fabs(known->place[i].omega - omega) <= SAME_FREQUENCY*omega)
			return 1;
	return 0;
}

/* Whether the fold is a mark. */
static int marked(const struct hawser__fold_known *known, double omega, double load,
                  const double *state)
{
	for (int i = 0; i < known->count; i++) {
		const struct hawser__fold_place *place = &known->place[i];

		if (place->kind == MARK && fabs(omega - place->omega) <= SAME_OMEGA*omega &&
		    fabs(load - place->load) <= SAME_OMEGA*load &&
		    hawser__same_state(state, known->state + (size_t)i*(size_t)known->m, known->m,
		                       SAME_STATE))
			return 1;
	}
	return 0;
}

/* Whether the fold lies between points i - 1 and i of a curve. */
static int between(const struct hawser__fold_known *known, int i, double omega, double load,
                   const double *state)
{
	const struct hawser__fold_place *a = &known->place[i - 1], *b = &known->place[i];
	const double *xb = known->state + (size_t)i*(size_t)known->m, *xa = xb - known->m;
	double s, gap = 0.0, chord = 0.0, sum = 0.0;

	if (b->kind != POINT || a->kind == MARK || a->load == b->load ||
	    (a->load - load)*(b->load - load) > 0.0)
		return 0;
	s = (load - a->load)/(b->load - a->load);
	if (fabs(a->omega + s*(b->omega - a->omega) - omega) >
	    BESIDE*fabs(b->omega - a->omega) + SAME_OMEGA*omega)
		return 0;
	for (int j = 0; j < known->m; j++) {
		double d = xb[j] - xa[j];

		gap += pow(xa[j] + s*d - state[j], 2);
		chord += d*d;
		sum += state[j]*state[j];
	}
	return sqrt(gap) <= BESIDE*sqrt(chord) + SAME_STATE*sqrt(sum);
}

int hawser__known_fold(const struct hawser__fold_known *known, double omega, double load,
                       const double *state)
{
	for (int i = 1; i < known->count; i++)
		if (between(known, i, omega, load, state))
			return 1;
	return marked(known, omega, load, state);
}

/* The state of point p of a list. */
static const double *list_state(const struct hawser__fold_list *list, int p)
{
	return list->row + (size_t)p*(size_t)hawser__fold_width(list) + list->n +
	       3*(size_t)list->probes;
}

/* Whether point p of a list is exact: its start, a crossing of an end of the range, or its end. */
static int exact(const struct hawser__fold_list *list, int p, const double *range)
{
	return p == 0 || list->point[p].omega == range[0] || list->point[p].omega == range[1] ||
	       (p == list->points - 1 && list->end == HAWSER_FOLDS_LOAD);
}

int hawser__known_curve(const struct hawser__fold_known *known,
                        const struct hawser__fold_list *list, const double *range)
{
	for (int e = 0; e < list->events; e++)
		if (marked(known, list->event[e].omega, list->event[e].load,
		           list->event_state + (size_t)e*(size_t)known->m))
			return 1;
	for (int p = 0; p < list->points; p++)
		if (exact(list, p, range) &&
		    marked(known, list->point[p].omega, list->point[p].load, list_state(list, p)))
			return 1;
	return 0;
}

enum hawser_status hawser__known_add(struct hawser__fold_known *known,
                                     const struct hawser__fold_list *list, const double *range,
                                     struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int p = 0; !status && p < list->points; p++)
		status = add(known, p > 0 ? POINT : FIRST, list->point[p].omega, list->point[p].load,
		             list_state(list, p), report);
	for (int p = 0; !status && p < list->points; p++)
		if (exact(list, p, range))
			status = add(known, MARK, list->point[p].omega, list->point[p].load,
			             list_state(list, p), report);
	for (int e = 0; !status && e < list->events; e++)
		status = add(known, MARK, list->event[e].omega, list->event[e].load,
		             list->event_state + (size_t)e*(size_t)known->m, report);
	return status;
}

/* response/locus/folds_events.c - special points of a fold curve, located between two stations.
 *
 * After a reduction by Lyapunov and Schmidt to f(x, Omega, load) = 0 the fold is f = f_x = 0, with
 *
 *   f_xx = w^T F_yy v v    f_Omega = w^T F_Omega    f_load = w^T F_load
 *
 * Along the curve f_Omega dOmega + f_load dload = 0 and f_xx dx + f_xOmega dOmega + f_xload dload = 0.
 *
 *   cusp                f_xx = 0: Omega and load stand still together, the orbit alone moves
 *   stationary load     f_Omega = 0: f = f_x = f_Omega = 0. Then f is, to second order in (x,
 *                       Omega), a quadratic form with determinant -f_xx f_load load'', where load''
 *                       is the load's second derivative by Omega along the curve: where it is
 *                       definite a closed curve shrinks to a point, where it is indefinite two
 *                       curves cross (Golubitsky and Schaeffer, Singularities and Groups in
 *                       Bifurcation Theory I, 1985, chapter IV: isola centre and simple bifurcation;
 *                       hysteresis for the cusp)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "continuation/false_position.h"
#include "response/time/flow.h"
#include "response/locus/folds_walk.h"

#define MOST_ITERATIONS 40 /* iterations of false position with halvings: 1e-12 of the step in the
                            * worst case */
#define WORST_RESIDUAL 1e-4 /* largest test function at its zero, relative to its size at the ends:
                             * a larger one is a discontinuity; chosen */

/* Whether test k changes sign between a and b. */
static int changes(const struct hawser__fold_station *a, const struct hawser__fold_station *b,
                   int k)
{
	return (a->test[k] < 0.0) != (b->test[k] < 0.0);
}

/* scratch = the point of the curve at fraction s from lo to hi, with its own test functions. */
static enum hawser_status place(struct hawser__fold_walk *walk, double s, int *failed)
{
	struct hawser__fold_station *at = &walk->scratch;
	const struct hawser__node lo = hawser__fold_node(&walk->lo), hi = hawser__fold_node(&walk->hi);
	const struct hawser__metric metric = hawser__fold_metric(walk->fold);
	double residual;
	enum hawser_status status;

	hawser__curve_between(at->z, walk->plane, &lo, &hi, s, &metric);
	hawser__walk_orient(walk, &walk->lo);
	status = hawser__walk_correct(walk, at, walk->plane, failed);
	if (status || *failed || (status = hawser__fold_evaluate(walk->fold, &residual, at->z,
	                                                         walk->report)))
		return status;
	if ((*failed = !isfinite(residual)))
		return HAWSER_OK;
	hawser__walk_finish(walk, at, walk->plane);
	at->arc = walk->lo.arc + s*(walk->hi.arc - walk->lo.arc);
	return HAWSER_OK;
}

/* Find the zero of test k between lo and hi, in scratch. The curve itself is evaluated at every
 * trial. */
static enum hawser_status locate(struct hawser__fold_walk *walk, int k, double *residual,
                                 int *failed)
{
	struct hawser__fold_station *lo = &walk->lo, *hi = &walk->hi;
	struct hawser__bracketed in = {lo->arc, hi->arc, lo->test[k], hi->test[k], 0};
	double goal = walk->options->event_tolerance, first = fmax(fabs(in.fa), fabs(in.fb));

	for (int i = 0; i < MOST_ITERATIONS; i++) {
		double arc = hawser__false_position(&in, i);
		enum hawser_status status = place(walk, (arc - lo->arc)/(hi->arc - lo->arc), failed);

		if (status || *failed)
			return status;
		*residual = fabs(walk->scratch.test[k])/first;
		if (*residual <= goal || hi->arc - lo->arc <= goal) {
			*failed = *residual > WORST_RESIDUAL; /* the test function is discontinuous and has no
			                                       * zero */
			return HAWSER_OK;
		}
		hawser__false_position_take(&in, arc, walk->scratch.test[k]);
		hawser__station_copy(changes(lo, &walk->scratch, k) ? hi : lo, &walk->scratch,
		                     walk->fold->size);
	}
	*failed = 1;
	return HAWSER_OK;
}

/* 1 if the load has a minimum at the event, -1 for a maximum, 0 if the signs at the ends do not
 * tell. */
static int extremum(const struct hawser__fold_walk *walk, double load)
{
	int at = walk->fold->size - 1;
	double a = walk->here.z[at] - load, b = walk->next.z[at] - load;

	return a > 0.0 && b > 0.0 ? 1 : a < 0.0 && b < 0.0 ? -1 : 0;
}

static enum hawser_status record(struct hawser__fold_walk *walk,
                                 const struct hawser__fold_station *at,
                                 enum hawser_folds_kind kind, double residual)
{
	int size = walk->fold->size;
	struct hawser_folds_event event = {.kind = kind, .omega = at->z[size - 2],
		.load = at->z[size - 1], .arc = at->arc, .residual = residual,
		.after = walk->list->points - 2};

	if (kind != HAWSER_FOLDS_NOMINAL)
		event.minimum = extremum(walk, event.load);
	if (kind == HAWSER_FOLDS_ISOLA) /* the form is definite if this is negative */
		if (walk->fold->second*walk->fold->F_load*event.minimum > 0.0)
			event.kind = HAWSER_FOLDS_BIFURCATION;
	return hawser__list_event(walk->list, walk, &event, at->z);
}

/* Report an event that was detected but not located. */
static void miss(struct hawser__fold_walk *walk, enum hawser_folds_kind kind)
{
	const struct hawser__fold_station *here = &walk->here;
	int size = walk->fold->size;

	snprintf(walk->list->message, sizeof walk->list->message,
	         "a special point (%s) beyond Omega %.9g%s, load factor %.9g, was not located",
	         hawser_folds_kind_name(kind),
	         HAWSER_SHOWN(walk->fold->load.full, here->z[size - 2]), here->z[size - 1]);
}

/* Locate the crossings of the nominal load between a and b. */
static enum hawser_status passage(struct hawser__fold_walk *walk,
                                  const struct hawser__fold_station *a,
                                  const struct hawser__fold_station *b, int *missed)
{
	const struct hawser__node from = hawser__fold_node(a), to = hawser__fold_node(b);
	const struct hawser__metric metric = hawser__fold_metric(walk->fold);
	int size = walk->fold->size, failed;
	double share;
	enum hawser_status status;

	if (!((a->z[size - 1] - 1.0)*(b->z[size - 1] - 1.0) < 0.0))
		return HAWSER_OK;
	share = hawser__curve_meets(walk->scratch.z, walk->plane, &from, &to, size - 1, 1.0, &metric);
	memset(walk->plane, 0, (size_t)size*sizeof(double));
	walk->plane[size - 1] = 1.0;
	hawser__walk_orient(walk, a);
	status = hawser__walk_correct(walk, &walk->scratch, walk->plane, &failed);
	if (!status && failed) {
		*missed = 1;
		miss(walk, HAWSER_FOLDS_NOMINAL);
	}
	if (status || failed)
		return status;
	walk->scratch.z[size - 1] = 1.0;
	walk->scratch.arc = a->arc + share*(b->arc - a->arc);
	return record(walk, &walk->scratch, HAWSER_FOLDS_NOMINAL, 0.0);
}

/* Whether a place of a step lies within the range of Omega, of which its ends are outside or at a
 * bound: the curve turns there. */
static int dips(const struct hawser__fold_walk *walk, const struct hawser__fold_station *place)
{
	const struct hawser__fold_station *at[] = {place, &walk->here, &walk->next};
	int inside[3];

	for (int i = 0; i < 3; i++) {
		double omega = at[i]->z[walk->fold->size - 2];

		inside[i] = omega > walk->omega_lo && omega < walk->omega_hi;
	}
	return inside[0] && !inside[1] && !inside[2];
}

enum hawser_status hawser__fold_events(struct hawser__fold_walk *walk, int *missed, int *cut)
{
	static const enum hawser_folds_kind kind[] = {HAWSER_FOLDS_CUSP, HAWSER_FOLDS_ISOLA};
	struct hawser__fold_station *here = &walk->here, *next = &walk->next;
	struct hawser__fold_list *list = walk->list;
	int size = walk->fold->size, first = list->events, turned = 0;
	enum hawser_status status;

	*missed = *cut = 0;
	for (int k = 0; k < HAWSER_FOLD_TESTS; k++) {
		double residual;
		int failed;

		if (!changes(here, next, k))
			continue;
		hawser__station_copy(&walk->lo, here, size);
		hawser__station_copy(&walk->hi, next, size);
		if ((status = locate(walk, k, &residual, &failed)))
			return status;
		if (failed) {
			*missed = 1;
			miss(walk, kind[k]);
			continue;
		}
		if (dips(walk, &walk->scratch)) {
			hawser__fold_swap(&walk->scratch, next);
			*cut = 1;
			return HAWSER_OK;
		}
		if ((status = record(walk, &walk->scratch, kind[k], residual)))
			return status;
		turned = 1;
	}
	if (!turned) {
		status = passage(walk, here, next, missed);
	} else {
		/* the load may cross its nominal value on both sides of its extreme */
		hawser__station_copy(&walk->lo, &walk->scratch, size);
		hawser__station_copy(&walk->hi, &walk->scratch, size);
		status = passage(walk, here, &walk->lo, missed);
		if (!status)
			status = passage(walk, &walk->hi, next, missed);
	}
	for (int i = first; i < list->events; i++)
		for (int j = i; j > first && list->event[j].arc < list->event[j - 1].arc; j--)
			hawser__list_swap(list, j, j - 1);
	return status;
}

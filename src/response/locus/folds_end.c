/* response/locus/folds_end.c - the end of a fold curve: at a bound of the load, outside the frequency
 * range, or at its start.
 *
 * Only folds within the range of Omega are part of the result. A curve that leaves the range may,
 * however, return at a lower load: it passes a cusp outside and returns as the other fold of the
 * pair. A curve is therefore followed everywhere within a window about the range (folds_levels.c).
 * Outside the window it is followed only as long as its load does not exceed the load at which it
 * left the window, since only then can it return at a lower load.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "response/locus/folds_walk.h"

#define FEWEST_CLOSED 10 /* least number of points of a closed curve; chosen */
#define CLOSE 0.02 /* largest distance, in steps, at which a closed curve passes its start; chosen */
/* A curve ends where Omega is outside the range by this factor: its folds there would belong to a
 * resonance that is bent to four times its natural frequency. */
#define FARTHEST 4.0

/* Move next to the point at which the curve reaches the bound of an unknown. */
static enum hawser_status cut(struct hawser__fold_walk *walk, int place, double bound, int *failed)
{
	const struct hawser__node here = hawser__fold_node(&walk->here);
	const struct hawser__node next = hawser__fold_node(&walk->next);
	const struct hawser__metric metric = hawser__fold_metric(walk->fold);
	int size = walk->fold->size;
	double share = hawser__curve_meets(walk->scratch.z, walk->direction, &here, &next, place, bound,
	                                   &metric);
	enum hawser_status status;

	memset(walk->plane, 0, (size_t)size*sizeof(double));
	walk->plane[place] = 1.0;
	hawser__walk_orient(walk, &walk->here);
	status = hawser__walk_correct(walk, &walk->scratch, walk->plane, failed);
	if (status || *failed)
		return status;
	hawser__walk_finish(walk, &walk->scratch, walk->here.t);
	walk->scratch.arc = walk->here.arc + share*(walk->next.arc - walk->here.arc);
	walk->scratch.z[place] = bound;
	hawser__fold_swap(&walk->scratch, &walk->next);
	return HAWSER_OK;
}

/* Whether the curve crosses this Omega between here and next. A point at this Omega is no crossing. */
static int crosses(const struct hawser__fold_walk *walk, double bound)
{
	int place = walk->fold->size - 2;

	return (walk->here.z[place] - bound)*(walk->next.z[place] - bound) < 0.0;
}

/* Whether next lies outside the part of the plane in which curves are followed. */
static int gone(struct hawser__fold_walk *walk)
{
	int size = walk->fold->size;
	double omega = walk->next.z[size - 2], load = walk->next.z[size - 1];

	if (omega >= walk->window_lo && omega <= walk->window_hi) {
		walk->ceiling = INFINITY;
		return 0;
	}
	if (!isfinite(walk->ceiling))
		walk->ceiling = walk->here.z[size - 1];
	return load > walk->ceiling || omega < walk->omega_lo/FARTHEST ||
	       omega > walk->omega_hi*FARTHEST;
}

/* Whether the curve passes its start between here and next. */
static int closed(struct hawser__fold_walk *walk, double *share)
{
	const struct hawser__node here = hawser__fold_node(&walk->here);
	const struct hawser__node next = hawser__fold_node(&walk->next);
	const struct hawser__metric metric = hawser__fold_metric(walk->fold);

	return walk->list->points >= FEWEST_CLOSED &&
	       hawser__curve_passes(share, walk->start.z, &here, &next, walk->next.arc - walk->here.arc,
	                            CLOSE, walk->scratch.z, walk->plane, &metric);
}

/* next = the start, at the fraction `share` of the step. */
static enum hawser_status close_curve(struct hawser__fold_walk *walk, double share, int *failed)
{
	double arc = walk->next.arc;
	enum hawser_status status;

	hawser__station_copy(&walk->next, &walk->start, walk->fold->size);
	walk->next.arc = walk->here.arc + share*(arc - walk->here.arc);
	hawser__walk_orient(walk, &walk->here);
	status = hawser__walk_correct(walk, &walk->next, walk->here.t, failed);
	if (!status && !*failed)
		hawser__walk_finish(walk, &walk->next, walk->here.t);
	return status;
}

enum hawser_status hawser__walk_end(struct hawser__fold_walk *walk, int *ended, int *failed)
{
	const struct hawser_folds_options *options = walk->options;
	const double range[] = {walk->omega_lo, walk->omega_hi};
	int size = walk->fold->size;
	double load, share;
	enum hawser_status status;

	*failed = 0;
	*ended = closed(walk, &share);
	if (*ended) {
		walk->list->end = HAWSER_FOLDS_CLOSED;
		return close_curve(walk, share, failed);
	}
	for (int k = 0; k < 2; k++)
		if (crosses(walk, range[k]) &&
		    ((status = cut(walk, size - 2, range[k], failed)) || *failed))
			return status;
	load = walk->next.z[size - 1];
	if (load >= options->load_to || load <= options->load_from) {
		*ended = 1;
		walk->list->end = HAWSER_FOLDS_LOAD;
		return cut(walk, size - 1, load >= options->load_to ? options->load_to
		                                                    : options->load_from, failed);
	}
	*ended = gone(walk);
	if (*ended)
		walk->list->end = HAWSER_FOLDS_OMEGA;
	return HAWSER_OK;
}

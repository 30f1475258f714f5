/* response/locus/folds_list.c - the points and events of a curve, and their transfer to the result.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/names.h"
#include "core/report.h"
#include "response/locus/folds_walk.h"

#define ROUNDING 1e-12 /* relative difference of the loads of two corrections of one fold; chosen */

enum hawser_status hawser__list_point(struct hawser__fold_list *list,
                                      struct hawser__fold_walk *walk,
                                      const struct hawser__fold_station *station)
{
	const struct hawser__orbit *orbit = &walk->fold->balance.base;
	size_t width = (size_t)hawser__fold_width(list);
	int size = walk->fold->size;
	double *row;

	if (hawser__more(&list->point, list->points, sizeof *list->point) ||
	    hawser__more(&list->row, list->points, width*sizeof *list->row))
		return hawser__no_memory(walk->report, "folds");
	row = list->row + (size_t)list->points*width;
	if (hawser__amplitude_find(walk->amplitude, row, row + list->n, orbit->samples, orbit->rows,
	                           station->z[size - 2]))
		return hawser__no_memory(walk->report, "folds");
	orbit->ops->state(orbit, row + list->n + 3*(size_t)list->probes, station->z);
	list->point[list->points++] = (struct hawser_folds_point){
		.omega = station->z[size - 2],
		.load = station->z[size - 1],
		.arc = station->arc,
		.residual = station->correction.residual,
		.mesh = station->mesh,
		.iterations = station->correction.iterations,
		.harmonics = walk->fold->balance.order,
	};
	return HAWSER_OK;
}

enum hawser_status hawser__list_event(struct hawser__fold_list *list,
                                      struct hawser__fold_walk *walk,
                                      const struct hawser_folds_event *event, const double *z)
{
	const struct hawser__orbit *orbit = &walk->fold->balance.base;
	size_t m = 2*(size_t)list->n;

	if (hawser__more(&list->event, list->events, sizeof *list->event) ||
	    hawser__more(&list->event_state, list->events, m*sizeof *list->event_state))
		return hawser__no_memory(walk->report, "folds");
	orbit->ops->state(orbit, list->event_state + (size_t)list->events*m, z);
	list->event[list->events++] = *event;
	if (event->kind == HAWSER_FOLDS_NOMINAL)
		hawser__store_add(walk->passages, z);
	if (walk->passages->failed)
		return hawser__no_memory(walk->report, "folds");
	return HAWSER_OK;
}

void hawser__list_swap(struct hawser__fold_list *list, int a, int b)
{
	struct hawser_folds_event keep = list->event[a];
	size_t m = 2*(size_t)list->n;
	double *x = list->event_state + (size_t)a*m, *y = list->event_state + (size_t)b*m;

	list->event[a] = list->event[b];
	list->event[b] = keep;
	for (size_t i = 0; i < m; i++) {
		double value = x[i];

		x[i] = y[i];
		y[i] = value;
	}
}

void hawser__list_clear(struct hawser__fold_list *list)
{
	free(list->point);
	free(list->row);
	free(list->event);
	free(list->event_state);
}

static void put_point(struct hawser_folds *folds, const struct hawser__fold_list *list, int i,
                      double sign)
{
	size_t n = (size_t)folds->n, probes = 3*(size_t)folds->probes, p = (size_t)folds->points++;
	const double *row = list->row + (size_t)i*(size_t)hawser__fold_width(list);

	folds->point[p] = list->point[i];
	folds->point[p].arc *= sign;
	memcpy(folds->coordinate + p*n, row, n*sizeof *row);
	memcpy(folds->probe + p*probes, row + n, probes*sizeof *row);
	memcpy(folds->state + p*2*n, row + n + probes, 2*n*sizeof *row);
}

/* `after` is already the place among all points. */
static void put_event(struct hawser_folds *folds, const struct hawser__fold_list *list, int i,
                      double sign, int after)
{
	size_t m = 2*(size_t)folds->n, e = (size_t)folds->events++;

	folds->event[e] = list->event[i];
	folds->event[e].arc *= sign;
	folds->event[e].after = after;
	memcpy(folds->event_state + e*m, list->event_state + (size_t)i*m, m*sizeof(double));
}

/* The least load of the curve: if the load has a minimum there, that of an event, even where a step
 * ends at it. */
static void find_least(const struct hawser_folds *folds, struct hawser_folds_curve *curve)
{
	curve->least_load = INFINITY;
	curve->least_event = -1;
	for (int i = curve->first; i < curve->first + curve->points; i++)
		if (folds->point[i].load < curve->least_load) {
			curve->least_load = folds->point[i].load;
			curve->least_omega = folds->point[i].omega;
		}
	for (int e = curve->first_event; e < curve->first_event + curve->events; e++)
		if (folds->event[e].load <= curve->least_load*(1.0 + ROUNDING)) {
			curve->least_load = folds->event[e].load;
			curve->least_omega = folds->event[e].omega;
			curve->least_event = e;
		}
}

/* The two halves of a curve as one sequence: the points of `back` in reverse order without its
 * first one, then those of `on`. */
static const struct hawser_folds_point *at(const struct hawser__fold_list *back,
                                           const struct hawser__fold_list *on, int base, int i)
{
	return i < base ? &back->point[base - i] : &on->point[i - base];
}

static int within(double omega, const double *range)
{
	return omega >= range[0] && omega <= range[1];
}

/* Append an event after point `after` of the sequence, of which first to last is a part; `end` is 1
 * if the sequence ends with it. */
static int part_of(const struct hawser_folds_event *event, int after, int first, int last, int end,
                   const double *range)
{
	return after >= first && after < last + end && within(event->omega, range);
}

/* Points first to last of the sequence as a curve of the result. */
static void put_part(struct hawser_folds *folds, const struct hawser__fold_list *back,
                     const struct hawser__fold_list *on, int first, int last, const double *range)
{
	struct hawser_folds_curve *curve = &folds->curve[folds->curves++];
	int base = back->points > 0 ? back->points - 1 : 0, total = base + on->points;
	int shift = folds->points - first;

	*curve = (struct hawser_folds_curve){.first = folds->points, .first_event = folds->events};
	curve->end[0] = first > 0 ? HAWSER_FOLDS_OMEGA : base > 0 ? back->end : on->end;
	curve->end[1] = last < total - 1 ? HAWSER_FOLDS_OMEGA : on->end;
	for (int i = first; i <= last; i++)
		if (i < base)
			put_point(folds, back, base - i, -1.0);
		else
			put_point(folds, on, i - base, 1.0);
	for (int e = back->events - 1; e >= 0; e--) {
		int after = base - 1 - back->event[e].after;

		if (part_of(&back->event[e], after, first, last, 0, range))
			put_event(folds, back, e, -1.0, shift + after);
	}
	for (int e = 0; e < on->events; e++) {
		int after = base + on->event[e].after;

		if (part_of(&on->event[e], after, first, last, last == total - 1, range))
			put_event(folds, on, e, 1.0, shift + after);
	}
	curve->points = folds->points - curve->first;
	curve->events = folds->events - curve->first_event;
	memcpy(curve->message, on->message[0] ? on->message : back->message,
	       sizeof curve->message);
	find_least(folds, curve);
}

enum hawser_status hawser__list_join(struct hawser_folds *folds,
                                     const struct hawser__fold_list *back,
                                     const struct hawser__fold_list *on, const double *range,
                                     struct hawser_report *report)
{
	size_t n = (size_t)folds->n, probes = 3*(size_t)folds->probes;
	size_t points = (size_t)folds->points + (size_t)back->points + (size_t)on->points;
	size_t events = (size_t)folds->events + (size_t)back->events + (size_t)on->events;
	int base = back->points > 0 ? back->points - 1 : 0, total = base + on->points, last;

	/* there are at most as many parts as points */
	if (hawser__resize(&folds->point, points, sizeof *folds->point) ||
	    hawser__resize(&folds->coordinate, points*n, sizeof(double)) ||
	    hawser__resize(&folds->probe, points*probes, sizeof(double)) ||
	    hawser__resize(&folds->state, points*2*n, sizeof(double)) ||
	    hawser__resize(&folds->event, events, sizeof *folds->event) ||
	    hawser__resize(&folds->event_state, events*2*n, sizeof(double)) ||
	    hawser__resize(&folds->curve, (size_t)folds->curves + (size_t)total, sizeof *folds->curve))
		return hawser__no_memory(report, "folds");
	for (int first = 0; first < total; first = last + 1) {
		last = first;
		if (!within(at(back, on, base, first)->omega, range))
			continue;
		while (last + 1 < total && within(at(back, on, base, last + 1)->omega, range))
			last++;
		if (last > first || total == 1) /* otherwise the curve only touches the range */
			put_part(folds, back, on, first, last, range);
	}
	return HAWSER_OK;
}

HAWSER__NAMES(hawser_folds_least_name, enum hawser_folds_least_kind, "cusp", "isola-centre",
	"simple-bifurcation", "end of the frequency range", "end of the load range", "bound")
/* crossings of the nominal load, cusps and the like */
HAWSER__NAMES(hawser_folds_kind_name, enum hawser_folds_kind, "nominal", "cusp", "isola-centre",
	"simple-bifurcation")
HAWSER__NAMES(hawser_folds_end_name, enum hawser_folds_end, "end of the frequency range",
	"end of the load range", "curve closed", "max-points", "interrupted", "failed", "most work")

void hawser_folds_clear(struct hawser_folds *folds)
{
	if (!folds)
		return;
	free(folds->point);
	free(folds->coordinate);
	free(folds->probe);
	free(folds->state);
	free(folds->curve);
	free(folds->event);
	free(folds->event_state);
	hawser_frf_clear(&folds->response);
	for (int i = 0; i < folds->isolas; i++)
		hawser_frf_clear(&folds->isola[i]);
	free(folds->isola);
	free(folds->lost_at);
	free(folds->level);
	memset(folds, 0, sizeof *folds);
}

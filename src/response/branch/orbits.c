/* response/branch/orbits.c - the orbits of a curve, kept, and a trace that passes them again.
 *
 * A curve may be traced twice: first for its shape, then for its multipliers and events
 * (study/accuracy/draft.c). Its orbits are then known: the second trace begins with the first of them,
 * steps end at them where their lengths allow it, and they need one Jacobian each, for their tangents.
 * Between them the orbits are found as those of any other curve. Where the second trace ends before the
 * curve does, one from the curve's other end passes them backwards (cover.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "response/branch/trace.h"
#include "response/orbit/balance.h"
#include "rom/terms/terms.h"

#define LONGER 1.5 /* longest step to a known orbit, over the one that is expected to be good; chosen */
#define SKIPS_FROM 24 /* coordinates: with fewer, multipliers take less than the orbits about peaks that
                       * are then traced again. With 18, 30 and 36: 1.7 -> 2.1, 5.8 -> 5.7, 6.1 -> 5.5 s
                       * (footbridge in a short and the whole range, conductor) */
#define BEHIND 0.1 /* part of that step below which an orbit ahead is not worth one; chosen */

size_t hawser__series_length(const struct hawser__series *series, int n)
{
	return (2*(size_t)series->order + 1)*(size_t)n + 1;
}

static void clear(struct hawser__orbits *orbits)
{
	for (int i = 0; i < orbits->count; i++)
		free(orbits->item[i].y);
	orbits->count = 0;
}

void hawser__orbits_clear(struct hawser__orbits *orbits)
{
	clear(orbits);
	free(orbits->item);
	*orbits = (struct hawser__orbits){.n = 0};
}

void hawser__orbits_free(struct hawser__orbits *orbits)
{
	if (orbits)
		hawser__orbits_clear(orbits);
	free(orbits);
}

static double omega_of(const struct hawser__orbits *orbits, int i)
{
	return orbits->item[i].y[hawser__series_length(&orbits->item[i], orbits->n) - 1];
}

struct hawser__orbits *hawser__orbits_back(struct hawser__orbits *orbits, double from)
{
	struct hawser__orbits *back = malloc(sizeof *back);
	int last = 0;

	if (!back || orbits->count == 0) {
		free(back);
		return NULL;
	}
	while (last + 1 < orbits->count &&
	       (omega_of(orbits, last) < from) == (omega_of(orbits, 0) < from))
		last++;
	for (int i = last + 1; i < orbits->count; i++)
		free(orbits->item[i].y);
	orbits->count = last + 1;
	for (int i = 0; 2*i < last; i++) {
		struct hawser__series keep = orbits->item[i];

		orbits->item[i] = orbits->item[last - i];
		orbits->item[last - i] = keep;
	}
	for (int i = 0; i <= last; i++) {
		size_t length = hawser__series_length(&orbits->item[i], orbits->n);

		cblas_dscal((int)length, -1.0, orbits->item[i].y + length, 1);
	}
	*back = *orbits;
	*orbits = (struct hawser__orbits){.n = 0};
	return back;
}

/* --- to keep them --- */

static int order_of(const struct hawser__station *station, int n, int size)
{
	int at = size - 2;

	while (at >= n && station->y[at] == 0.0 && station->t[at] == 0.0)
		at--;
	return (at/n + 1)/2;
}

static enum hawser_status keep(struct hawser__orbits *orbits, const struct hawser__trace *trace,
                               const struct hawser__station *station)
{
	int n = trace->orbit->n, size = trace->orbit->size;
	struct hawser__series *series;
	size_t length;

	if (hawser__more(&orbits->item, orbits->count, sizeof *orbits->item))
		return hawser__no_memory(trace->report, "frf");
	series = &orbits->item[orbits->count];
	*series = (struct hawser__series){.arc = station->arc, .order = order_of(station, n, size)};
	length = hawser__series_length(series, n);
	if (!(series->y = malloc(2*length*sizeof(double))))
		return hawser__no_memory(trace->report, "frf");
	orbits->n = n;
	orbits->count++;
	memcpy(series->y, station->y, length*sizeof(double));
	memcpy(series->y + length, station->t, length*sizeof(double));
	series->y[length - 1] = station->y[size - 1];
	series->y[2*length - 1] = station->t[size - 1];
	return HAWSER_OK;
}

static int is_series(const struct hawser__trace *trace)
{
	return strcmp(trace->frf->method, hawser__balance_method.about.name) == 0 &&
	       hawser__rom_periods(trace->rom) == 1;
}

static enum hawser_status step(void *context, struct hawser__trace *trace)
{
	struct hawser__orbits *orbits = context;
	enum hawser_status status = HAWSER_OK;

	if (!is_series(trace))
		return HAWSER_OK;
	if (trace->frf->points == 2) { /* also of a trace that begins again */
		clear(orbits);
		status = keep(orbits, trace, &trace->here);
	}
	return status ? status : keep(orbits, trace, &trace->next);
}

static void back(void *context)
{
	struct hawser__orbits *orbits = context;

	if (orbits->count > 0)
		free(orbits->item[--orbits->count].y);
}

struct hawser__trace_watch hawser__orbits_watch(struct hawser__orbits *orbits)
{
	return (struct hawser__trace_watch){.context = orbits, .step = step, .back = back};
}

/* --- and to pass them again --- */

/* y and, unless it is NULL, t [size] of a known orbit. */
static void unpack(double *y, double *t, const struct hawser__series *series,
                   const struct hawser__orbit *orbit)
{
	size_t length = hawser__series_length(series, orbit->n), rest = (size_t)orbit->size - length;
	double *out[2] = {y, t};

	for (int k = 0; k < 2 && out[k]; k++) {
		const double *from = series->y + (size_t)k*length;

		memcpy(out[k], from, (length - 1)*sizeof *from);
		memset(out[k] + length - 1, 0, rest*sizeof *from);
		out[k][orbit->size - 1] = from[length - 1];
	}
}

static const struct hawser__orbits *known_to(const struct hawser__trace *trace)
{
	const struct hawser__orbits *known = trace->watch ? trace->watch->known : NULL;

	return known && known->count > 1 && known->n == trace->orbit->n && is_series(trace) ? known : NULL;
}

const struct hawser__step_settings *hawser__known_settings(const struct hawser_rom *rom,
                                                           const struct hawser__trace_watch *watch)
{
	if (!hawser__is_large(rom) && !(watch && watch->for_folds))
		return &hawser__frf_steps;
	return rom->exact && watch && watch->known && watch->known->count > 0 && rom->n >= SKIPS_FROM
	       ? &hawser__known_steps : &hawser__exact_steps;
}

enum hawser_status hawser__known_first(struct hawser__trace *trace, int *found)
{
	const struct hawser__orbits *known = known_to(trace);
	struct hawser__orbit *orbit = trace->orbit;

	*found = known && omega_of(known, 0) == trace->options.begin &&
	         hawser__series_length(&known->item[0], known->n) <= (size_t)orbit->size;
	if (!*found)
		return HAWSER_OK;
	unpack(trace->here.y, NULL, &known->item[0], orbit);
	trace->here.y[orbit->size - 1] = trace->options.begin;
	orbit->ops->metric(orbit, trace->here.y);
	return hawser__balance_hold((struct hawser__balance *)orbit, trace->here.y, trace->report);
}

/* The arclength from `here` to a known orbit, which is in the scratch station then; 0: it is behind, or
 * the curve turns by more than the goal on the way. */
static double way_to(struct hawser__trace *trace, const struct hawser__series *series)
{
	const struct hawser__metric metric = hawser__orbit_metric(trace->orbit);
	struct hawser__station *at = &trace->scratch;
	const struct hawser__node here = hawser__station_node(&trace->here);
	const struct hawser__node there = hawser__station_node(at);
	double along = 0.0;

	unpack(at->y, at->t, series, trace->orbit);
	for (int i = 0; i < metric.size; i++)
		along += metric.weight[i]*trace->here.t[i]*(at->y[i] - trace->here.y[i]);
	return along > 0.0 ? hawser__arc_between(&metric, &here, &there) : 0.0;
}

void hawser__known_aim(struct hawser__trace *trace)
{
	const struct hawser__orbits *known = known_to(trace);
	const struct hawser__metric metric = hawser__orbit_metric(trace->orbit);
	double ds = trace->curve.ds, aim = 0.0;
	int i = trace->passed;

	trace->aim = 0.0;
	for (; known && i < known->count; i++) {
		double way = hawser__series_length(&known->item[i], known->n) <= (size_t)metric.size
		             ? way_to(trace, &known->item[i]) : INFINITY;

		if (aim == 0.0 && way < BEHIND*ds) {
			trace->passed = i + 1;
			continue;
		}
		if (way > (aim == 0.0 ? LONGER : 1.0)*ds ||
		    (aim > 0.0 && hawser__metric_angle(&metric, trace->here.t, trace->scratch.t) >
		                  trace->curve.settings->goal_angle))
			break;
		trace->aimed = i;
		aim = way;
	}
	if (aim > 0.0)
		trace->curve.ds = trace->aim = aim;
}

int hawser__known_ahead(struct hawser__trace *trace, double ds)
{
	trace->orbit->known = trace->aim > 0.0 && ds == trace->aim;
	if (!trace->orbit->known)
		return 0;
	unpack(trace->next.y, trace->side, &known_to(trace)->item[trace->aimed], trace->orbit);
	return !hawser__balance_hold((struct hawser__balance *)trace->orbit, trace->next.y, NULL);
}

const double *hawser__known_side(const struct hawser__trace *trace, double ds)
{
	return ds == trace->aim ? trace->side : trace->here.t;
}

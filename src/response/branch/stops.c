/* response/branch/stops.c - see stops.h.
 *
 * Between its events a step of the curve is monotone in the parameter, so that each part passes a value
 * at most once. The orbit is corrected at this value from the cubic between the stations. Next to a
 * fold the derivative at a constant parameter is nearly singular and the correction may go to the other
 * side of the fold; the tangent tells. There the place on the arc is found by false position, whose
 * corrections are normal to the curve.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "continuation/false_position.h"
#include "core/grow.h"
#include "core/report.h"
#include "response/branch/stops.h"

enum { HALVINGS = 50, TRIES = 60 };
#define SAME 1e-11 /* relative difference of a parameter from a value that counts as none: a
                    * hundredth of the relative tolerance of orbits; chosen */

/* A part of a step without events: fractions of the step, parameters at its ends. */
struct part {
	double from, to, low, high; /* low at `from`, high at `to` */
	int unstable;
};

static double parameter_at(struct hawser__trace *trace, double s)
{
	struct hawser__station *scratch = &trace->scratch;

	hawser__station_between(scratch->y, trace->direction, &trace->here, &trace->next, s, trace->orbit);
	return scratch->y[trace->orbit->size - 1];
}

/* Where the cubic has the parameter `at`; the station's y is that point, `direction` its direction. */
static double meet(struct hawser__trace *trace, const struct part *part, double at)
{
	double lo = part->from, hi = part->to, way = part->high < part->low ? -1.0 : 1.0;

	for (int i = 0; i < HALVINGS; i++) {
		double s = 0.5*(lo + hi);

		if ((parameter_at(trace, s) - at)*way < 0.0)
			lo = s;
		else
			hi = s;
	}
	parameter_at(trace, lo);
	return lo;
}

/* Correct the scratch station at the parameter `at`. *found: 0 where the result isn't on this part. */
static enum hawser_status at_once(struct hawser__trace *trace, int *found, const struct part *part,
                                  double at)
{
	struct hawser__station *scratch = &trace->scratch;
	struct hawser__orbit *orbit = trace->orbit;
	double way = part->high < part->low ? -1.0 : 1.0, *side = trace->side;
	int last = orbit->size - 1, failed;
	enum hawser_status status;

	meet(trace, part, at);
	memcpy(side, trace->direction, (size_t)orbit->size*sizeof(double));
	scratch->y[last] = at;
	memset(trace->direction, 0, (size_t)orbit->size*sizeof(double));
	trace->direction[last] = orbit->W;
	status = hawser__trace_correct(trace, scratch, trace->direction, &failed);
	*found = !status && !failed;
	if (!*found)
		return status;
	hawser__station_turn(scratch, orbit, side, NULL);
	*found = scratch->t[last]*way > 0.0;
	return HAWSER_OK;
}

/* The same by false position on the arc. */
static int along_arc(struct hawser__trace *trace, const struct part *part, double at)
{
	struct hawser__station *scratch = &trace->scratch;
	struct hawser__orbit *orbit = trace->orbit;
	struct hawser__bracketed in = {part->from, part->to, part->low - at, part->high - at, 0};
	double tolerance = SAME*hawser__orbit_extent(orbit, trace->here.y);

	if (in.fa*in.fb > 0.0)
		return 0;
	for (int i = 0; i < TRIES; i++) {
		double s = hawser__false_position(&in, i), f;

		if (hawser__station_inside(scratch, orbit, &trace->here, &trace->next, s,
		                           trace->options.tolerance))
			return 0;
		f = scratch->y[orbit->size - 1] - at;
		if (fabs(f) <= tolerance || in.b - in.a < 1e-14)
			return 1;
		hawser__false_position_take(&in, s, f);
	}
	return 0;
}

/* The scratch station, whose orbit was corrected last, becomes a stop. */
static enum hawser_status keep(struct hawser__stops *stops, struct hawser__trace *trace, int place,
                               int unstable)
{
	const struct hawser__orbit *orbit = trace->orbit;
	const struct hawser_frf *frf = trace->frf;
	const double *y = trace->scratch.y;
	double omega = hawser__orbit_omega(orbit, y), extreme[2] = {NAN, NAN}, *state, peak = 0.0;
	double length = orbit->rom->length/frf->length, time = orbit->rom->time/frf->time;
	const double *of = frf->probes > 0 ? stops->spare + frf->n : stops->spare;
	int count = frf->probes > 0 ? 3*frf->probes : frf->n;

	stops->m = orbit->m;
	if (hawser__more(&stops->stop, stops->stops, sizeof *stops->stop) ||
	    hawser__more(&stops->state, stops->stops, (size_t)stops->m*sizeof *stops->state))
		return hawser__no_memory(trace->report, "frf");
	hawser__amplitude_take(trace->amplitude, orbit->rom);
	if (hawser__amplitude_find(trace->amplitude, stops->spare, stops->spare + frf->n, orbit->samples,
	                           orbit->rows, omega) ||
	    (frf->tension && hawser__amplitude_tension(trace->amplitude, extreme, orbit->samples,
	                                               orbit->rows, omega) > 0))
		return hawser__no_memory(trace->report, "frf");
	for (int i = 0; i < count; i++)
		peak = fmax(peak, of[i]);
	state = stops->state + (size_t)stops->stops*(size_t)stops->m;
	orbit->ops->state(orbit, state, y);
	for (int i = 0; i < stops->m; i++)
		state[i] *= i < frf->n ? length : length/time;
	stops->stop[stops->stops++] = (struct hawser__stop){place, unstable, peak*length, extreme[0]};
	return HAWSER_OK;
}

static enum hawser_status pass(struct hawser__stops *stops, struct hawser__trace *trace,
                               const struct part *part)
{
	double low = fmin(part->low, part->high), high = fmax(part->low, part->high);
	double slack = SAME*fmax(fabs(low), fabs(high));
	int up = part->high > part->low;
	enum hawser_status status = HAWSER_OK;

	for (int i = 0; i < stops->count && !status; i++) {
		int place = up ? i : stops->count - 1 - i, found;
		double at = stops->at[place];

		if (at < low - slack || at > high + slack)
			continue;
		if ((status = at_once(trace, &found, part, at)))
			return status;
		if (found || along_arc(trace, part, at))
			status = keep(stops, trace, place, part->unstable);
		else if (at > low + slack && at < high - slack)
			stops->missed++;
	}
	return status;
}

enum hawser_status hawser__stops_step(void *context, struct hawser__trace *trace)
{
	struct hawser__stops *stops = context;
	const struct hawser__account *account = &trace->account;
	double length = trace->next.arc - trace->here.arc;
	int last = trace->orbit->size - 1;
	struct part part = {0.0, 1.0, trace->here.y[last], trace->next.y[last],
	                    trace->here.circle.unstable};
	enum hawser_status status = HAWSER_OK;

	if (trace->frf->points == 2) {
		stops->stops = stops->missed = 0;
		if (!stops->spare)
			stops->spare = malloc(((size_t)trace->frf->n + 3*(size_t)trace->frf->probes)*
			                      sizeof(double));
		if (!stops->spare)
			return hawser__no_memory(trace->report, "frf");
	}
	stops->last[0] = stops->stops;
	stops->last[1] = stops->missed;
	for (int i = 0; i < account->events && !status; i++) {
		const struct hawser_frf_event *event = &account->event[i];

		part.to = (event->arc - trace->here.arc)/length;
		part.high = event->parameter;
		if (part.to > part.from && part.to < 1.0) {
			status = pass(stops, trace, &part);
			part.from = part.to;
			part.low = part.high;
		}
		part.unstable = event->unstable[1];
	}
	part.to = 1.0;
	part.high = trace->next.y[last];
	if (!status && account->events > 0)
		part.unstable = trace->next.circle.unstable;
	return status ? status : pass(stops, trace, &part);
}

void hawser__stops_back(void *context)
{
	struct hawser__stops *stops = context;

	stops->stops = stops->last[0];
	stops->missed = stops->last[1];
}

void hawser__stops_clear(struct hawser__stops *stops)
{
	free(stops->stop);
	free(stops->state);
	free(stops->spare);
	*stops = (struct hawser__stops){.at = NULL};
}

/* response/branch/record.c - see record.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/names.h"
#include "core/report.h"
#include "response/branch/record.h"
#include "response/branch/trace.h"
#include "response/cycle/cycle.h"

#define ONE_ARC 0.05 /* largest arclength between a fold and a branch point that are one; chosen */
#define ERRORS 5.0   /* and of their parameters, in errors; chosen */

static enum hawser_status grow(struct hawser_frf *frf, int own, struct hawser_report *report)
{
	const size_t rows = frf->capacity ? 2*(size_t)frf->capacity : 256, n = (size_t)frf->n;
	const size_t each = sizeof(double);

	if (hawser__resize(&frf->point, rows, sizeof *frf->point) ||
	    hawser__resize(&frf->coordinate, rows*n, each) ||
	    hawser__resize(&frf->probe, rows*3*(size_t)frf->probes, each) ||
	    ((!frf->capacity || frf->tension) && hawser__resize(&frf->tension, 2*rows, each)) ||
	    (own && (hawser__resize(&frf->swing, rows*n, each) ||
	             hawser__resize(&frf->trivial, rows, each))) ||
	    hawser__resize(&frf->multiplier, rows*4*n, each) ||
	    hawser__resize(&frf->state, rows*2*n, each))
		return hawser__no_memory(report, "frf");
	frf->capacity = (int)rows;
	return HAWSER_OK;
}

/* Returns 1 when out of memory. */
static int find_tension(struct hawser_frf *frf, struct hawser__amplitude *amplitude,
                        const struct hawser__orbit *orbit, double omega)
{
	int failed = hawser__amplitude_tension(amplitude, frf->tension + (size_t)frf->points*2,
	                                       orbit->samples, orbit->rows, omega);

	if (failed < 0) {
		free(frf->tension);
		frf->tension = NULL;
	}
	return failed > 0;
}

/* A state of a model, in the units of frf. */
static void convert(double *state, const struct hawser_frf *frf, const struct hawser_rom *rom)
{
	double length = rom->length/frf->length, time = rom->time/frf->time;

	for (int i = 0; i < 2*frf->n; i++)
		state[i] *= i < frf->n ? length : length/time;
}

enum hawser_status hawser__record_point(struct hawser_frf *frf, struct hawser__amplitude *amplitude,
                                        const struct hawser__station *station,
                                        const struct hawser__orbit *orbit,
                                        struct hawser_report *report)
{
	enum hawser_status status;
	int p = frf->points, m = orbit->m;
	double *multiplier, omega = hawser__orbit_omega(orbit, station->y);
	double length = orbit->rom->length/frf->length, contact;
	int sheave;

	if (p == frf->capacity && (status = grow(frf, orbit->own != HAWSER__FORCED, report)))
		return status;
	hawser__amplitude_take(amplitude, orbit->rom);
	if (hawser__amplitude_find(amplitude, frf->coordinate + (size_t)p*frf->n,
	                           frf->probe + (size_t)p*3*frf->probes, orbit->samples,
	                           orbit->rows, omega) ||
	    hawser__amplitude_contact(amplitude, &contact, &sheave, orbit->samples, orbit->rows) ||
	    (frf->tension && find_tension(frf, amplitude, orbit, omega)) ||
	    (frf->swing && hawser__amplitude_swing(amplitude, frf->swing + (size_t)p*frf->n, orbit->samples,
	                                           orbit->rows)))
		return hawser__no_memory(report, "frf");
	frf->point[p] = (struct hawser_frf_point){
		.omega = orbit->own == HAWSER__CYCLES ? omega/orbit->rom->time*frf->time
		         : orbit->family ? orbit->family->omega*frf->time : omega,
		.parameter = station->y[orbit->size - 1],
		.arc = station->arc,
		.unstable = station->circle.unstable,
		.undecided = station->circle.undecided,
		.direction = station->t[orbit->size - 1] < 0.0 ? -1 : 1,
		.residual = station->correction.residual,
		.mesh = station->mesh,
		.error = station->error,
		.liouville = station->liouville,
		.iterations = station->correction.iterations,
		.steps = orbit->resolution,
		.contact = contact,
		.sheave = sheave,
	};
	multiplier = frf->multiplier + (size_t)p*2*m;
	for (int i = 0; i < m; i++) {
		multiplier[2*i] = station->log_modulus[i];
		multiplier[2*i + 1] = station->argument[i];
		if (i >= m - orbit->idle)
			multiplier[2*i] = NAN;
		else if (orbit->own == HAWSER__RESTS)
			hawser__equilibrium_value(&multiplier[2*i], &multiplier[2*i + 1], orbit,
			                          station->log_modulus[i], station->argument[i]);
	}
	orbit->ops->state(orbit, frf->state + (size_t)p*m, station->y);
	convert(frf->state + (size_t)p*m, frf, orbit->rom);
	for (int j = 0; j < frf->n; j++)
		frf->coordinate[(size_t)p*frf->n + j] *= length;
	for (int j = 0; frf->swing && j < frf->n; j++)
		frf->swing[(size_t)p*frf->n + j] *= length;
	if (frf->trivial)
		frf->trivial[p] = station->trivial;
	for (int j = 0; j < 3*frf->probes; j++)
		frf->probe[(size_t)p*3*frf->probes + j] *= length;
	frf->points++;
	frf->cost = orbit->cost;
	return HAWSER_OK;
}

/* Whether these are at one place. On a pitchfork's own branch Omega turns where that branch crosses the
 * other: a fold and a branch point in one. Beside it the tests are round-off, which may change more: a
 * branch point where nothing turns belongs to it. */
static int are_one(const struct hawser_frf_event *a, const struct hawser_frf_event *b)
{
	int fold = a->kind == HAWSER_FOLD || b->kind == HAWSER_FOLD;
	int point = a->kind == HAWSER_BRANCH_POINT || b->kind == HAWSER_BRANCH_POINT;
	int same = a->kind == HAWSER_BRANCH_POINT && b->kind == HAWSER_BRANCH_POINT;

	return ((fold && point) || same) && a->located && b->located && fabs(a->arc - b->arc) <= ONE_ARC &&
	       fabs(a->parameter - b->parameter) <= ERRORS*(a->error + b->error)*fabs(a->parameter);
}

enum hawser_status hawser__record_event(struct hawser_frf *frf,
                                        const struct hawser_frf_event *event, const double *state,
                                        const struct hawser_rom *rom, struct hawser_report *report)
{
	double *row;

	if (frf->events > 0 && are_one(&frf->event[frf->events - 1], event)) {
		const struct hawser_frf_event *last = &frf->event[frf->events - 1];
		int twice = last->kind == event->kind;

		if (event->kind == HAWSER_FOLD || (twice && last->turns))
			return HAWSER_OK;
		frf->events--;
		if (twice && !event->turns)
			return HAWSER_OK;
	}
	if (frf->events == frf->event_capacity) {
		size_t capacity = frf->event_capacity ? 2*(size_t)frf->event_capacity : 32;

		if (hawser__resize(&frf->event, capacity, sizeof *frf->event) ||
		    hawser__resize(&frf->event_state, capacity*2*(size_t)frf->n, sizeof(double)))
			return hawser__no_memory(report, "frf");
		frf->event_capacity = (int)capacity;
	}
	frf->event[frf->events] = *event;
	row = frf->event_state + 2*(size_t)frf->n*(size_t)frf->events++;
	for (int i = 0; i < 2*frf->n; i++)
		row[i] = state ? state[i] : NAN;
	convert(row, frf, rom);
	return HAWSER_OK;
}

/* Index of the last point before the event. */
static int point_before(const struct hawser_frf *frf, const struct hawser_frf_event *event)
{
	int p = event->after;

	while (p > 0 && frf->point[p].arc > event->arc)
		p--;
	while (p + 1 < frf->points && frf->point[p + 1].arc < event->arc)
		p++;
	return p;
}

static void swap_events(struct hawser_frf *frf, int a, int b)
{
	struct hawser_frf_event event = frf->event[a];
	double *x = frf->event_state + 2*(size_t)frf->n*(size_t)a;
	double *y = frf->event_state + 2*(size_t)frf->n*(size_t)b;

	frf->event[a] = frf->event[b];
	frf->event[b] = event;
	for (int i = 0; i < 2*frf->n; i++) {
		double value = x[i];

		x[i] = y[i];
		y[i] = value;
	}
}

void hawser__record_order(struct hawser_frf *frf)
{
	int kept = 0;

	for (int e = 0; e < frf->events; e++) {
		struct hawser_frf_event *event = &frf->event[e];
		int last = frf->points - 1, ends = event->after == last;

		event->after = point_before(frf, event);
		if (!ends && event->after == last && event->arc > frf->point[last].arc)
			continue; /* the curve ended before it got there */
		swap_events(frf, kept, e);
		for (int i = kept++; i > 0 && frf->event[i].arc < frf->event[i - 1].arc; i--)
			swap_events(frf, i, i - 1);
	}
	frf->events = kept;
}

void hawser__frf_in_loads(struct hawser_frf *frf, int periods, int family)
{
	double parameter = family ? 1.0 : periods;

	for (int p = 0; p < frf->points; p++) {
		frf->point[p].omega *= periods;
		frf->point[p].parameter *= parameter;
	}
	for (int e = 0; e < frf->events; e++) {
		frf->event[e].omega *= periods;
		frf->event[e].parameter *= parameter;
		frf->event[e].bracket[0] *= parameter;
		frf->event[e].bracket[1] *= parameter;
	}
	frf->period = periods;
}

void hawser_frf_clear(struct hawser_frf *frf)
{
	if (!frf)
		return;
	free(frf->point);
	free(frf->coordinate);
	free(frf->probe);
	free(frf->tension);
	free(frf->multiplier);
	free(frf->swing);
	free(frf->trivial);
	free(frf->state);
	free(frf->event);
	free(frf->event_state);
	hawser__orbits_free(frf->back);
	memset(frf, 0, sizeof *frf);
}

HAWSER__NAMES(hawser_event_name, enum hawser_event_kind, "fold", "period-doubling", "torus",
	"branch-point", "unexplained", "slack", "resonance", "hopf")

HAWSER__NAMES(hawser_frf_end_name, enum hawser_frf_end, "end of the range", "returned",
	"curve closed", "max-points", "interrupted", "failed", "at rest", "slack", "unstable",
	"lost", "meets a branch", "most work", "hopf", "homoclinic")

int hawser_frf_label(struct hawser_frf *frf, int first, int every)
{
	every = every == 0 ? 10 : every;
	for (int p = 0, e = 0; p < frf->points; p++) {
		frf->point[p].label = every > 0 && (p % every == 0 || p == frf->points - 1)
		                      ? first++ : 0;
		for (; e < frf->events && frf->event[e].after <= p; e++)
			frf->event[e].label = first++;
	}
	return first;
}

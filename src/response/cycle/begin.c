/* response/cycle/begin.c - what equilibria and limit cycles have beside the continuation of orbits:
 * how they begin, Hopf points, and where cycles end.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/branch/trace.h"
#include "response/cycle/cycle.h"
#include "response/cycle/hopf.h"
#include "rom/terms/drag.h"

#define SMALL 0.02   /* of the largest size: a cycle that is smaller may be near a Hopf point; chosen */
#define AGREES 0.1   /* largest distance of that point from where the square of the size becomes 0,
                      * relative to the length of the extrapolation, */
#define NEAREST 1e-7 /* and relative to the parameter; chosen */
#define TOGETHER 1e-5 /* of Hopf points from each other, and from where the count shows them; chosen */
/* A cycle that is slower than this part of the first one nears a homoclinic orbit where a change of
 * its period is worth less than this change of the parameter, both relative; chosen. */
#define SLOW 0.6
#define STANDS 1e-5
enum { STILL = 3 }; /* points; chosen */
#define FIRST_REFINEMENTS 4 /* of the mesh at the first cycle; chosen */

/* --- the methods --- */

/* Of the motion from the state `start`. */
static enum hawser_status settle(struct hawser__trace *trace, struct hawser_report *report)
{
	struct hawser_frf_options *options = &trace->options;
	size_t m = 2*(size_t)trace->rom->n;
	double *x = hawser__hold(&trace->hold, m, sizeof *x);
	const struct hawser_rom *rom;
	enum hawser_status status = x ? options->family->model(options->family->context, &rom,
	                                                       options->begin, report)
	                              : hawser__no_memory(report, "frf");

	if (status)
		return status;
	memcpy(x, options->start, m*sizeof *x);
	options->start = x;
	return hawser__cycle_settle(x, &options->omega, rom, report);
}

enum { MANY = 200 }; /* terms; those of a wind on 6 modes are more; chosen */

/* Balance of large models, or where it is asked for: where modes are quick against the range, or there
 * are many terms or the exact force of a wind, with which shooting takes twice as long. Equations of
 * first order are stiff by their relaxation alone, and only shooting has a row for rotations of the
 * model. */
static enum hawser_status cycle_method(const struct hawser__orbit_method **method,
                                       const struct hawser_rom *rom,
                                       const struct hawser_frf_options *options,
                                       struct hawser_report *report)
{
	int asked = options->method && strcmp(options->method, "balance") == 0, turns = 0;
	int suits = !options->method && !rom->first && !rom->plug &&
	            (!rom->drag || hawser__drag_smooth(rom->drag)) &&
	            (rom->terms > MANY || rom->drag || hawser__balance_method.suits(rom, options));
	double *turn = malloc((size_t)rom->n*(size_t)rom->n*sizeof *turn);
	enum hawser_status status = turn ? HAWSER_OK : hawser__no_memory(report, "frf");

	if (!status && (asked || suits))
		status = hawser__cycle_turn(turn, &turns, rom, report);
	if (!status && turns && asked)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                      "limit cycles of a model that may be rotated are followed by shooting: "
		                      "leave out --method");
	*method = (asked || suits) && !turns ? &hawser__balance_method : &hawser__shooting_method;
	free(turn);
	return status;
}

enum hawser_status hawser__own_open(struct hawser__trace *trace, struct hawser_report *report)
{
	struct hawser_frf_options options;
	const struct hawser__orbit_method *method;
	struct hawser__orbit *inner;
	enum hawser_status status = HAWSER_OK;

	if (trace->options.omega < 0.0)
		status = settle(trace, report);
	if (status)
		return status;
	options = trace->options;
	if (!(options.omega > 0.0)) {
		status = hawser__equilibrium_open(&trace->orbit, trace->rom, report);
		trace->frf->method = "equilibria";
	} else {
		options.from = options.to = options.begin = options.omega;
		status = cycle_method(&method, trace->rom, &options, report);
		if (!status)
			status = method->open(&inner, trace->rom, &options, report);
		if (!status)
			status = hawser__cycle_open(&trace->orbit, inner, report);
		if (!status)
			trace->frf->method = method->about.name;
	}
	if (status)
		return status;
	trace->orbit->family = options.family;
	trace->orbit->floor = trace->hi - trace->lo;
	return HAWSER_OK;
}

/* --- how they begin --- */

enum hawser_status hawser__own_equilibrium(struct hawser__trace *trace, double *u)
{
	const struct hawser_rom_family *family = trace->options.family;
	const struct hawser_rom *rom;
	enum hawser_status status = family->model(family->context, &rom, trace->options.begin,
	                                          trace->report);

	if (!status && trace->options.start)
		memcpy(u, trace->options.start, (size_t)rom->n*sizeof *u);
	return status ? status : hawser__equilibrium_find(u, rom, !trace->options.start, trace->report);
}

/* y: a wave about an equilibrium; base: without the wave. */
static void set_wave(double *y, double *base, struct hawser__trace *trace)
{
	const struct hawser_frf_options *options = &trace->options;
	struct hawser__orbit *orbit = trace->orbit;
	int n = orbit->n;
	double *wave = trace->mark_y;

	memset(y, 0, (size_t)orbit->size*sizeof *y);
	memset(wave, 0, 2*(size_t)n*sizeof *wave);
	memcpy(wave, options->start, (size_t)n*sizeof *wave);
	orbit->ops->add_wave(orbit, y, wave, 0, options->omega);
	memcpy(base, y, (size_t)orbit->size*sizeof *y);
	memcpy(wave, options->along, (size_t)n*sizeof *wave);
	memcpy(wave + n, options->turn, (size_t)n*sizeof *wave);
	orbit->ops->add_wave(orbit, y, wave, 1, options->omega);
}

/* The prediction of the first cycle, and the direction in which it is away from an equilibrium or
 * from another cycle. */
static enum hawser_status aim_cycle(struct hawser__trace *trace)
{
	const struct hawser_frf_options *options = &trace->options;
	struct hawser__orbit *orbit = trace->orbit;
	int size = orbit->size;
	double *y = trace->here.y, *base = trace->next.y, *x = trace->mark_y, length;
	enum hawser_status status = HAWSER_OK;

	if (options->turn) {
		set_wave(y, base, trace);
	} else {
		for (int i = 0; i < orbit->m; i++)
			x[i] = options->start[i] + options->along[i];
		status = orbit->ops->from_state(orbit, base, options->start, options->omega, trace->report);
		if (!status)
			status = orbit->ops->from_state(orbit, y, x, options->omega, trace->report);
	}
	y[size - 2] = base[size - 2] = options->omega;
	y[size - 1] = base[size - 1] = options->begin;
	orbit->ops->metric(orbit, y);
	for (int i = 0; i < size; i++)
		trace->direction[i] = y[i] - base[i];
	length = sqrt(hawser__orbit_dot(orbit, trace->direction, trace->direction));
	cblas_dscal(size, 1.0/length, trace->direction, 1);
	return status;
}

/* From a state of a cycle at the parameter `begin`. */
static enum hawser_status from_state(struct hawser__trace *trace)
{
	struct hawser__orbit *orbit = trace->orbit;
	int last = orbit->size - 1;
	enum hawser_status status;

	trace->here.y[last - 1] = trace->options.omega;
	trace->here.y[last] = trace->options.begin;
	if (hawser__orbit_place(orbit, trace->options.begin))
		return HAWSER_ERR_CONVERGENCE;
	status = orbit->ops->from_state(orbit, trace->here.y, trace->options.start, trace->options.omega,
	                                trace->report);
	if (!status) {
		orbit->ops->metric(orbit, trace->here.y);
		hawser__cycle_loose(orbit);
	}
	return status;
}

enum hawser_status hawser__own_cycle(struct hawser__trace *trace, double side)
{
	struct hawser__orbit *orbit = trace->orbit;
	const struct hawser_frf_options *options = &trace->options;
	int failed = 1;
	enum hawser_status status = HAWSER_OK;

	for (int refined = 0; failed && !status && refined <= FIRST_REFINEMENTS; refined++) {
		if (refined > 0)
			status = orbit->ops->enrich(orbit, 1, trace->report);
		if (!status && options->along) {
			if (!hawser__orbit_place(orbit, options->begin) && !(status = aim_cycle(trace)))
				status = hawser__trace_correct(trace, &trace->here, trace->direction, &failed);
			if (!status && !failed)
				status = hawser__station_finish(&trace->here, orbit, trace->direction, trace->report);
		} else if (!status) {
			status = from_state(trace);
			if (!status)
				status = hawser__trace_settle(trace, &trace->here, side, NULL, &failed);
		}
	}
	if (!status && failed)
		status = hawser__fail_at(trace->report, HAWSER_ERR_CONVERGENCE, "frf",
		                         trace->here.correction.iterations, trace->here.correction.residual,
		                         "no limit cycle was found at %s near the given one",
		                         hawser__orbit_where(orbit, options->begin).text);
	return status;
}

/* --- Hopf points --- */

/* In the units of the result. */
static void convert(struct hawser_hopf *hopf, const struct hawser__trace *trace)
{
	double time = trace->orbit->rom->time/trace->frf->time;
	double length = trace->orbit->rom->length/trace->frf->length;

	hopf->omega /= time;
	hopf->growth /= time;
	hopf->swing *= length*length;
}

static double extent_at(const struct hawser__trace *trace, double p)
{
	return fmax(fabs(p), trace->orbit->floor);
}

/* The event becomes the Hopf point of the pair near i guess (0: that nearest to the axis). */
static enum hawser_status take_hopf(struct hawser__trace *trace, struct hawser_frf_event *event,
                                    const double *state, double guess)
{
	double *wave = malloc((size_t)trace->orbit->m*sizeof *wave), rate;
	enum hawser_status status = wave ? HAWSER_OK : hawser__no_memory(trace->report, "frf");

	if (!status)
		status = hawser__hopf(&event->hopf, &rate, wave, trace->options.family, state,
		                      event->parameter, guess, extent_at(trace, event->parameter),
		                      trace->report);
	free(wave);
	if (status)
		return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
	convert(&event->hopf, trace);
	event->kind = HAWSER_HOPF;
	event->omega = event->hopf.omega;
	return HAWSER_OK;
}

/* The Hopf points at the equilibrium x [m], *p near the event: as many as the count of unstable
 * eigenvalues says, which are those nearest to the axis. *found: 0: they are not all on it. */
static enum hawser_status record_together(int *found, struct hawser__trace *trace,
                                          const struct hawser_frf_event *event, double *x, double p)
{
	struct hawser__orbit *orbit = trace->orbit;
	int pairs = abs(event->unstable[1] - event->unstable[0])/2, m = orbit->m;
	double growth, turn, before = 0.0, *y = trace->scratch.y;
	enum hawser_status status;

	memcpy(y, x, (size_t)orbit->n*sizeof *y);
	y[orbit->n] = p;
	(void)orbit->ops->defects(orbit, y, 1);
	if ((status = orbit->ops->multipliers(orbit, trace->report)))
		return status;
	*found = 0;
	for (int i = 0; i < m; i++)
		*found += fabs(orbit->log_modulus[i]) < TOGETHER && orbit->argument[i] > 0.0;
	if (!(*found = *found == pairs && pairs > 1))
		return HAWSER_OK;
	for (int i = 0; i < m && !status; i++) {
		struct hawser_frf_event one = *event;

		if (!(fabs(orbit->log_modulus[i]) < TOGETHER && orbit->argument[i] > 0.0))
			continue;
		hawser__equilibrium_value(&growth, &turn, orbit, orbit->log_modulus[i], orbit->argument[i]);
		one.parameter = p;
		one.error = fmin(event->error, TOGETHER*TOGETHER);
		one.residual = fabs(orbit->log_modulus[i]);
		one.suspected = 0;
		one.located = 1;
		one.after = trace->frf->points - 2;
		one.hopf.turning = fabs(turn - before) <= TOGETHER*turn;
		before = turn;
		status = take_hopf(trace, &one, x, turn);
		if (!status)
			status = hawser__record_event(trace->frf, &one, x, orbit->rom, trace->report);
	}
	return status;
}

/* Several pairs may cross the axis together: the count changes by more than the tests can tell. */
static enum hawser_status cross_together(int *found, struct hawser__trace *trace,
                                         const struct hawser_frf_event *event)
{
	int m = trace->orbit->m;
	double *x = calloc(2*(size_t)m, sizeof *x), p = event->parameter, extent = extent_at(trace, p);
	struct hawser_hopf hopf = {.turning = 0};
	enum hawser_status status = x ? HAWSER_OK : hawser__no_memory(trace->report, "frf");

	if (!status) {
		memcpy(x, trace->here.y, (size_t)trace->orbit->n*sizeof *x);
		status = hawser__hopf_near(&hopf, x + m, x, &p, trace->options.family, 0.0, extent, NULL);
	}
	if (!status && fabs(p - event->parameter) <= TOGETHER*extent)
		status = record_together(found, trace, event, x, p);
	free(x);
	return status == HAWSER_ERR_CONVERGENCE ? HAWSER_OK : status;
}

enum hawser_status hawser__trace_hopf(struct hawser__trace *trace, struct hawser_frf_event *event,
                                      const double *state, int *together)
{
	int more = event->kind == HAWSER_UNEXPLAINED ||
	           (event->kind == HAWSER_TORUS && event->suspected);
	enum hawser_status status = HAWSER_OK;

	*together = 0;
	if (more)
		status = cross_together(together, trace, event);
	if (!status && !*together && event->kind == HAWSER_TORUS)
		status = take_hopf(trace, event, state, 0.0);
	return status;
}

/* --- where cycles end --- */

/* The Hopf point to which the cycles at `here` shrink, if there is one where the square of their
 * size becomes 0 by its last two values. */
static enum hawser_status shrinks_to(int *found, struct hawser_frf_event *event, double *state,
                                     struct hawser__trace *trace)
{
	const struct hawser__shrinking *s = &trace->shrinking;
	struct hawser__orbit *orbit = trace->orbit;
	int n = orbit->n, last = orbit->size - 1;
	double now = s->size[1]*s->size[1], before = s->size[0]*s->size[0];
	double length = (s->omega[1] - s->omega[0])*now/(before - now), p = s->omega[1] + length, at = p;
	double extent = extent_at(trace, p), *wave = state + 2*n;
	enum hawser_status status;

	memset(state, 0, 2*(size_t)n*sizeof *state);
	for (int i = 0; i < orbit->rows; i++)
		cblas_daxpy(n, 1.0/orbit->rows, orbit->samples + (size_t)i*n, 1, state, 1);
	status = hawser__hopf_near(&event->hopf, wave, state, &at, trace->options.family,
	                           trace->here.y[last - 1], extent, NULL);
	if (status == HAWSER_ERR_MEMORY)
		return status;
	*found = !status && fabs(at - p) <= AGREES*fabs(length) + NEAREST*extent;
	convert(&event->hopf, trace);
	event->omega = event->hopf.omega;
	event->parameter = at;
	event->kind = HAWSER_HOPF;
	event->located = 1;
	event->error = NEAREST*NEAREST;
	event->bracket[0] = event->bracket[1] = at;
	event->arc = trace->here.arc;
	event->after = trace->frf->points - 1;
	event->unstable[0] = event->unstable[1] = trace->here.circle.unstable;
	return HAWSER_OK;
}

/* Whether the period grows, for the last points, while the parameter stands still. */
static int slows_down(struct hawser__trace *trace)
{
	const struct hawser__orbit *orbit = trace->orbit;
	const struct hawser_frf *frf = trace->frf;
	int last = orbit->size - 1;
	const double *y = trace->here.y, *t = trace->here.t;
	double worth = fabs(t[last]*y[last - 1])/(fabs(t[last - 1])*extent_at(trace, y[last]));
	int slow = y[last - 1] < SLOW*frf->point[0].omega*orbit->rom->time/frf->time && worth < STANDS;

	trace->slow = slow ? trace->slow + 1 : 0;
	return trace->slow > STILL;
}

enum hawser_status hawser__own_ends(struct hawser__trace *trace, int *ended)
{
	struct hawser__shrinking *s = &trace->shrinking;
	struct hawser__orbit *orbit = trace->orbit;
	struct hawser_frf *frf = trace->frf;
	int last = orbit->size - 1;
	struct hawser_frf_event event = {.kind = HAWSER_HOPF};
	double *state;
	enum hawser_status status;

	*ended = 0;
	if (orbit->own != HAWSER__CYCLES)
		return HAWSER_OK;
	if (slows_down(trace)) {
		*ended = 1;
		frf->end = HAWSER_END_HOMOCLINIC;
		return HAWSER_OK;
	}
	s->size[0] = s->size[1];
	s->omega[0] = s->omega[1];
	s->size[1] = orbit->X;
	s->omega[1] = trace->here.y[last];
	s->largest = fmax(s->largest, orbit->X);
	if (s->known++ == 0 || !(s->size[1] < s->size[0] && s->size[1] < SMALL*s->largest))
		return HAWSER_OK;
	state = malloc(4*(size_t)orbit->n*sizeof *state);
	if (!state)
		return hawser__no_memory(trace->report, "frf");
	status = shrinks_to(ended, &event, state, trace);
	if (!status && *ended) {
		frf->end = HAWSER_END_HOPF;
		status = hawser__record_event(frf, &event, state, orbit->rom, trace->report);
	}
	free(state);
	return status;
}

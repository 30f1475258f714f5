/* study/basin/map_basin.c - the field of basins: at which response a motion ends; see hawser/basin.h.
 *
 * Responses are found first, by curves over the frequency and from a coarse grid of states, in one
 * thread and in one order, so that every point of the map refers to the same list.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/grow.h"
#include "core/report.h"
#include "study/basin/basin.h"
#include "study/map/map_cable.h"
#include "study/map/map_rows.h"

#define RETURNED 1e-3 /* relative distance from the state some periods before from which the response is
                       * sought; chosen */
#define DECAYS 60.0   /* a motion may take as many periods as reduce the slowest distance by exp(-60);
                       * chosen: from the largest to the smallest neighbourhood that is used it is 14 */
enum { GRID = 9, FIRST_PERIODS = 400, LEAST_PERIODS = 200, MOST_PERIODS = 20000, BETWEEN_TRIES = 20 };

/* --- motions --- */

struct motion {
	double x[2*HAWSER_ROM_MAX];
	double past[HAWSER__MOST_PERIODS_OF_ONE][2*HAWSER_ROM_MAX];
};

/* Whether the motion, in the neighbourhood of the response, still decays. */
static int confirmed(const struct hawser__attractor *attractor, struct hawser__orbiter *orbiter,
                     double *x, double form)
{
	double later;

	for (int k = 0; k < attractor->about.period*attractor->turns; k++)
		if (hawser__orbiter_map(orbiter, x) != HAWSER__MOVES)
			return 0;
	return hawser__attractor_has(attractor, x, orbiter->m, &later) >= 0 &&
	       later <= 0.5*(1.0 + attractor->q)*form + 1e-12;
}

/* The number of the response at which x ends, from 1; 0: at none within the periods; -1: it escapes.
 * *fate: _UNRESOLVED where it could not be integrated. */
static int ends_at(const struct hawser__basins *basins, enum hawser__fate *fate,
                   struct hawser__orbiter *orbiter, double *x)
{
	double form;

	orbiter->steps = 16;
	for (int period = 0; period < basins->periods; period++) {
		for (int a = 0; a < basins->count; a++)
			if (hawser__attractor_has(&basins->attractor[a], x, orbiter->m, &form) >= 0 &&
			    confirmed(&basins->attractor[a], orbiter, x, form))
				return a + 1;
		*fate = hawser__orbiter_map(orbiter, x);
		if (*fate != HAWSER__MOVES)
			return *fate == HAWSER__ESCAPED ? -1 : 0;
	}
	return 0;
}

/* --- responses --- */

static int known(const struct hawser__basins *basins, const struct hawser__attractor *attractor)
{
	double form;

	for (int a = 0; a < basins->count; a++)
		if (hawser__attractor_has(&basins->attractor[a], attractor->state, 2*basins->rom->n,
		                          &form) >= 0)
			return 1;
	return 0;
}

static enum hawser_status try_state(struct hawser__basins *basins, struct hawser__orbiter *orbiter,
                                    const double *x, int period, int followed,
                                    struct hawser_report *report)
{
	struct hawser__attractor attractor;
	int found;
	enum hawser_status status = hawser__attractor_find(&attractor, &found, orbiter, x, period, report);

	attractor.about.followed = followed;
	if (status || !found || known(basins, &attractor)) {
		hawser__attractor_clear(&attractor);
		return status;
	}
	if (hawser__more(&basins->attractor, basins->count, sizeof *basins->attractor)) {
		hawser__attractor_clear(&attractor);
		return hawser__no_memory(report, "map");
	}
	basins->attractor[basins->count++] = attractor;
	return HAWSER_OK;
}

/* Those of curves over the frequency. */
static enum hawser_status follow(struct hawser__basins *basins, struct hawser__orbiter *orbiter,
                                 struct hawser_report *report)
{
	struct hawser__map_row row;
	size_t m = 2*(size_t)basins->rom->n;
	enum hawser_status status = hawser__map_row_at(&row, basins->rom, basins->source->omega, NULL,
	                                               report);

	for (int i = 0; i < row.kept && !status; i++)
		status = try_state(basins, orbiter, row.state + (size_t)i*m, 1, 1, report);
	hawser__map_row_clear(&row);
	return status;
}

/* A motion that no known response takes: where it returns to a state before, look for a response. */
static enum hawser_status pursue(struct hawser__basins *basins, struct hawser__orbiter *orbiter,
                                 struct motion *motion, struct hawser_report *report)
{
	enum { ALL = HAWSER__MOST_PERIODS_OF_ONE };
	int m = orbiter->m, rest = 0, count = basins->count;
	enum hawser_status status = HAWSER_OK;

	orbiter->steps = 16;
	for (int period = 0; period < FIRST_PERIODS && !status && basins->count == count; period++) {
		double form, size = hawser__orbiter_size(orbiter, motion->x);

		for (int a = 0; a < basins->count; a++)
			if (hawser__attractor_has(&basins->attractor[a], motion->x, m, &form) >= 0)
				return HAWSER_OK;
		for (int k = 1; k <= ALL && k <= period && rest <= 0; k++) {
			const double *before = motion->past[(period - k)%ALL];
			double z[2*HAWSER_ROM_MAX];

			for (int i = 0; i < m; i++)
				z[i] = motion->x[i] - before[i];
			if (!(hawser__orbiter_size(orbiter, z) <= RETURNED*size))
				continue;
			rest = BETWEEN_TRIES;
			status = try_state(basins, orbiter, motion->x, k, 0, report);
		}
		rest--;
		memcpy(motion->past[period%ALL], motion->x, (size_t)m*sizeof *motion->x);
		if (hawser__orbiter_map(orbiter, motion->x) != HAWSER__MOVES)
			break;
	}
	return status;
}

static void place(const struct hawser__basins *basins, double *x, double first, double second)
{
	memset(x, 0, 2*(size_t)basins->rom->n*sizeof *x);
	x[basins->component[0]] = first*basins->scaled[0];
	x[basins->component[1]] = second*basins->scaled[1];
}

static enum hawser_status look(struct hawser__basins *basins, struct hawser__orbiter *orbiter,
                               struct hawser_report *report)
{
	const struct hawser_map_source *source = basins->source;
	struct motion *motion = malloc(sizeof *motion);
	enum hawser_status status = motion ? HAWSER_OK : hawser__no_memory(report, "map");

	for (int p = 0; p < GRID*GRID && !status; p++) {
		double s = (p%GRID + 0.5)/GRID, t = (p/GRID + 0.5)/GRID;

		place(basins, motion->x, source->from[0] + s*(source->to[0] - source->from[0]),
		      source->from[1] + t*(source->to[1] - source->from[1]));
		status = pursue(basins, orbiter, motion, report);
	}
	free(motion);
	return status;
}

static int by_amplitude(const void *a, const void *b)
{
	const struct hawser__attractor *one = a, *two = b;
	double first = one->about.amplitude, second = two->about.amplitude;

	/* symmetric ones have the same amplitude but for errors */
	if (fabs(first - second) > 1e-7*(first + second))
		return first < second ? -1 : 1;
	return one->state[0] < two->state[0] ? -1 : one->state[0] > two->state[0];
}

static enum hawser_status find_all(struct hawser__basins *basins, struct hawser_report *report)
{
	struct hawser__orbiter orbiter;
	double slowest = 0.0, periods;
	enum hawser_status status = hawser__orbiter_open(&orbiter, basins->rom, basins->omega, report);

	orbiter.size = basins->size;
	if (!status)
		status = follow(basins, &orbiter, report);
	if (!status)
		status = look(basins, &orbiter, report);
	hawser__orbiter_close(&orbiter);
	if (status)
		return status;
	if (basins->count == 0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "map",
		                    "basin: no stable periodic response was found, from curves over the "
		                    "frequency or from states of the map: there is nothing to end at");
	qsort(basins->attractor, (size_t)basins->count, sizeof *basins->attractor, by_amplitude);
	for (int a = 0; a < basins->count; a++) {
		double rate = log(basins->attractor[a].about.multiplier)/basins->attractor[a].about.period;

		slowest = a ? fmax(slowest, rate) : rate;
	}
	periods = DECAYS/-slowest;
	basins->periods = periods < LEAST_PERIODS ? LEAST_PERIODS
	                  : periods > MOST_PERIODS ? MOST_PERIODS : (int)periods;
	return HAWSER_OK;
}

/* --- the field --- */

struct worker {
	const struct hawser__basins *basins;
	struct hawser__orbiter orbiter;
};

static enum hawser_status open_worker(void **to, void *context, struct hawser_report *report)
{
	struct hawser__basins *basins = context;
	struct worker *worker = calloc(1, sizeof *worker);
	enum hawser_status status;

	*to = worker;
	if (!worker)
		return hawser__no_memory(report, "map");
	worker->basins = basins;
	status = hawser__orbiter_open(&worker->orbiter, basins->rom, basins->omega, report);
	worker->orbiter.size = basins->size;
	return status;
}

static void close_worker(void *context)
{
	struct worker *worker = context;

	if (worker)
		hawser__orbiter_close(&worker->orbiter);
	free(worker);
}

static enum hawser_status point(void *context, struct hawser_map_sample *sample, double *marks,
                                double x, double y, struct hawser_report *report)
{
	struct worker *worker = context;
	enum hawser__fate fate = HAWSER__MOVES;
	double state[2*HAWSER_ROM_MAX];

	(void)marks;
	place(worker->basins, state, x, y);
	*sample = (struct hawser_map_sample){.code = HAWSER_MAP_OK};
	sample->number = ends_at(worker->basins, &fate, &worker->orbiter, state);
	sample->value = sample->number;
	if (fate != HAWSER__UNRESOLVED)
		return HAWSER_OK;
	sample->code = HAWSER_MAP_NOT_CONVERGED;
	(void)hawser__fail(report, HAWSER_OK, "map", "a period of the motion needs more steps than the "
	                   "integration may take");
	return HAWSER_OK;
}

/* "u1" is component 0, "v1" component n. */
static enum hawser_status read_key(struct hawser__basins *basins, int k, struct hawser_report *report)
{
	const char *key = basins->source->key[k];
	const struct hawser_rom *rom = basins->rom;
	char *end = NULL;
	long j = (*key == 'u' || *key == 'v') && isdigit((unsigned char)key[1])
	         ? strtol(key + 1, &end, 10) : 0;

	if (j > 1 && rom->n == 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "%.60s: the axes of basins are components of the initial state: u1 "
		                    "(displacement) and v1 (velocity)", key);
	if (j < 1 || j > rom->n || *end)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "%.60s: the axes of basins are components of the initial state: u1 to "
		                    "u%d (displacements) and v1 to v%d (velocities)", key, rom->n, rom->n);
	basins->component[k] = (int)j - 1 + (*key == 'v' ? rom->n : 0);
	basins->scaled[k] = rom->scaled ? (*key == 'v' ? rom->time : 1.0)/rom->length : 1.0;
	return HAWSER_OK;
}

static enum hawser_status open_model(struct hawser__basins *basins, struct hawser_report *report)
{
	const struct hawser_map_source *source = basins->source;
	double omega = 0.0;
	int steady;
	enum hawser_status status;

	if (!(source->omega > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "the quantity basin needs a forcing frequency: give Omega");
	basins->model_source = (struct hawser_map_source){.scene = source->scene, .rom = source->rom,
		.file = source->file, .key = {"Omega", "factor.load"}, .quantity = "amplitude"};
	status = hawser_map_cable_open(&basins->inner, &basins->model_source, report);
	if (!status)
		status = basins->inner.open(&basins->inner_worker, basins->inner.context, report);
	if (!status)
		status = hawser__map_worker_model(basins->inner_worker, &basins->rom, &omega, &steady,
		                                  source->omega, 1.0, report);
	if (!status && basins->rom->n > HAWSER_ROM_MAX)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                      "basin: the model has %d coordinates, and this quantity takes at most %d",
		                      basins->rom->n, HAWSER_ROM_MAX);
	basins->omega = status ? 0.0 : omega*basins->rom->time;
	return status;
}

static enum hawser_status describe(struct hawser__basins *basins, struct hawser_report *report)
{
	const struct hawser_map_source *source = basins->source;
	size_t size = strlen(basins->inner.identity) + 200;

	basins->identity = malloc(size);
	if (!basins->identity)
		return hawser__no_memory(report, "map");
	snprintf(basins->identity, size, "basins over %.20s from %a to %a, %.20s from %a to %a at %a\n%s",
	         source->key[0], source->from[0], source->to[0], source->key[1], source->from[1],
	         source->to[1], source->omega, basins->inner.identity);
	return HAWSER_OK;
}

enum hawser_status hawser_map_basin_open(struct hawser_map_field *field,
                                         const struct hawser_map_source *source,
                                         struct hawser_report *report)
{
	struct hawser__basins *basins = calloc(1, sizeof *basins);
	enum hawser_status status;

	*field = (struct hawser_map_field){.name = "basin", .context = basins};
	if (!basins)
		return hawser__no_memory(report, "map");
	basins->source = source;
	status = open_model(basins, report);
	for (int k = 0; k < 2 && !status; k++)
		status = read_key(basins, k, report);
	if (!status && basins->component[0] == basins->component[1])
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "map", "both axes are %s: give --y "
		                      "another key", source->key[0]);
	if (!status) {
		double x = fmax(fabs(source->from[0]), fabs(source->to[0]))*basins->scaled[0];
		double y = fmax(fabs(source->from[1]), fabs(source->to[1]))*basins->scaled[1];

		basins->size = hypot(x/(basins->component[0] < basins->rom->n ? 1.0 : basins->omega),
		                     y/(basins->component[1] < basins->rom->n ? 1.0 : basins->omega));
		status = describe(basins, report);
	}
	if (!status)
		status = find_all(basins, report);
	if (status) {
		hawser_map_basin_close(field);
		return status;
	}
	field->identity = basins->identity;
	field->threshold = NAN;
	field->open = open_worker;
	field->close = close_worker;
	field->point = point;
	return HAWSER_OK;
}

void hawser_map_basin_close(struct hawser_map_field *field)
{
	struct hawser__basins *basins = field ? field->context : NULL;

	if (!basins)
		return;
	for (int a = 0; a < basins->count; a++)
		hawser__attractor_clear(&basins->attractor[a]);
	free(basins->attractor);
	if (basins->inner_worker)
		basins->inner.close(basins->inner_worker);
	hawser_map_cable_close(&basins->inner);
	free(basins->identity);
	free(basins);
	*field = (struct hawser_map_field){.name = NULL};
}

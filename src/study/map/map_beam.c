/* study/map/map_beam.c - the field of a travelling beam over two numeric keys of its scene: the largest
 * growth of its lowest modes, or the number of growing modes.
 *
 * The integrals of the discretisation depend on the end conditions only, and each worker computes
 * them once.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/beam.h>
#include <hawser/map.h>

#include "core/report.h"

enum { FUNCTIONS = 24, MODES = 6 };
/* Real parts below this, relative to the modulus, are round-off; those of an undamped beam are
 * exactly 0. */
static const double rounding = 1e-10;
static const double error = 1e-12; /* relative error of larger real parts; chosen with a margin to
                                    * round-off */

struct beam_map {
	struct hawser_map_source source;
	int modes, functions, counts; /* counts: 1: the value of the map is the number of growing modes */
	char *identity;
};

struct worker {
	const struct beam_map *map;
	struct hawser_beam_integrals integrals;
	struct hawser_beam_eigenvalue *value; /* [modes] */
};

static void close_worker(void *context)
{
	struct worker *worker = context;

	if (!worker)
		return;
	hawser_beam_integrals_clear(&worker->integrals);
	free(worker->value);
	free(worker);
}

static enum hawser_status open_worker(void **to, void *context, struct hawser_report *report)
{
	const struct beam_map *map = context;
	struct worker *worker = calloc(1, sizeof *worker);
	enum hawser_beam_ends ends = (enum hawser_beam_ends)map->source.scene->beam.ends;

	*to = worker;
	if (!worker)
		return hawser__no_memory(report, "map");
	worker->map = map;
	worker->value = malloc((size_t)map->modes*sizeof *worker->value);
	if (!worker->value)
		return hawser__no_memory(report, "map");
	return hawser_beam_method(0)->fill(&worker->integrals, ends, map->functions, report);
}

static enum hawser_status measure(struct worker *worker, struct hawser_map_sample *sample,
                                  double margin[2], const struct hawser_beam *beam,
                                  struct hawser_report *report)
{
	int found;
	enum hawser_status status = hawser_beam_eigenvalues(worker->value, NULL, &found,
	                                                    &worker->integrals, beam,
	                                                    worker->map->modes, report);

	sample->value = -HUGE_VAL;
	for (int i = 0; !status && i < found; i++) {
		double re = worker->value[i].re, modulus = hypot(re, worker->value[i].im);

		if (re > rounding*modulus)
			margin[0] = fmin(margin[0], re - error*modulus);
		else
			margin[1] = fmax(margin[1], re + error*modulus);
		re = fabs(re) <= rounding*modulus ? 0.0 : re;
		sample->number += re > 0.0;
		sample->value = fmax(sample->value, re);
	}
	if (beam->time > 0.0)
		sample->value /= beam->time;
	if (worker->map->counts)
		sample->value = sample->number;
	return status;
}

static enum hawser_status point(void *context, struct hawser_map_sample *sample, double *marks,
                                double x, double y, struct hawser_report *report)
{
	struct worker *worker = context;
	const struct hawser_map_source *source = &worker->map->source;
	struct hawser_scene scene = *source->scene; /* its `name` is shared with the source */
	struct hawser_beam beam;
	double margin[2] = {HUGE_VAL, -HUGE_VAL};
	enum hawser_status status = hawser_scene_set(&scene, source->key[0], x, report);

	*sample = (struct hawser_map_sample){0.0, 0, HAWSER_MAP_OK};
	if (!status)
		status = hawser_scene_set(&scene, source->key[1], y, report);
	if (!status)
		status = hawser_beam_scene(&beam, &scene, report);
	if (!status)
		status = measure(worker, sample, margin, &beam, report);
	if (marks)
		memcpy(marks, margin, sizeof margin);
	if (!status || status == HAWSER_ERR_MEMORY)
		return status;
	*sample = (struct hawser_map_sample){0.0, 0,
		status == HAWSER_ERR_NO_SOLUTION ? HAWSER_MAP_NO_STATE
		: status == HAWSER_ERR_CONVERGENCE ? HAWSER_MAP_NOT_CONVERGED : HAWSER_MAP_REFUSED};
	return HAWSER_OK;
}

static enum hawser_status check(const struct hawser_map_source *source, struct hawser_report *report)
{
	double unused;

	if (strcmp(source->quantity, "growth") != 0 && strcmp(source->quantity, "unstable") != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "%.40s is no quantity of a beam: write growth or unstable",
		                    source->quantity);
	if (strcmp(source->key[0], source->key[1]) == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map", "both axes are %s: give --y another "
		                    "key", source->key[0]);
	for (int k = 0; k < 2; k++) {
		if (strncmp(source->key[k], "beam.", 5) != 0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
			                    "%.60s: the axes of a beam's map are numbers of its section, "
			                    "such as beam.v", source->key[k]);
		if (hawser_scene_get(source->scene, &unused, source->key[k], report))
			return HAWSER_ERR_ARGUMENT;
	}
	return HAWSER_OK;
}

static enum hawser_status describe(struct beam_map *map, struct hawser_report *report)
{
	const struct hawser_map_source *source = &map->source;
	enum hawser_status status;
	size_t size = 0;
	FILE *stream = open_memstream(&map->identity, &size);

	if (!stream)
		return hawser__no_memory(report, "map");
	fprintf(stream, "hawser %s, %s of a beam over %s and %s, %d modes, %d functions\n",
	        hawser_version(), source->quantity, source->key[0], source->key[1], map->modes,
	        map->functions);
	status = hawser_scene_write(source->scene, stream, report);
	if ((fclose(stream) != 0 || !map->identity) && !status)
		status = hawser__no_memory(report, "map");
	return status;
}

enum hawser_status hawser_map_beam_open(struct hawser_map_field *field,
                                        const struct hawser_map_source *source, int modes,
                                        int functions, struct hawser_report *report)
{
	struct beam_map *map;
	enum hawser_status status = check(source, report);

	*field = (struct hawser_map_field){.name = source->quantity};
	if (status)
		return status;
	map = calloc(1, sizeof *map);
	if (!map)
		return hawser__no_memory(report, "map");
	map->source = *source;
	map->modes = modes > 0 ? modes : MODES;
	map->functions = functions > 0 ? functions : FUNCTIONS;
	map->counts = strcmp(source->quantity, "unstable") == 0;
	field->context = map;
	status = describe(map, report);
	if (status) {
		hawser_map_beam_close(field);
		return status;
	}
	field->identity = map->identity;
	field->open = open_worker;
	field->close = close_worker;
	field->point = point;
	field->marks = 2;
	field->margins = 1;
	return HAWSER_OK;
}

void hawser_map_beam_close(struct hawser_map_field *field)
{
	struct beam_map *map = field ? field->context : NULL;

	if (!map)
		return;
	free(map->identity);
	free(map);
	*field = (struct hawser_map_field){.name = NULL};
}

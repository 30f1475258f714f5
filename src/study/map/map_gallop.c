/* study/map/map_gallop.c - the field of a scene in a wind over two of its keys: the speed from which
 * on a mode grows (modes/complex/damped_trace.c), all modes together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/map.h>

#include "core/report.h"
#include "modes/complex/damped.h"

enum { SPEEDS = 7, FEW = 4 }; /* modes where the scene does not say how many */
#define LEAST 1e-3 /* speeds are sought from this multiple of the scene's */
#define REACH 2.0  /* to this one */
#define TOLERANCE 1e-6 /* of the modes: far below the width of a map's brackets, 4e-3; chosen */

struct gallop_map {
	struct hawser_map_source source;
	int modes;
	char *identity;
};

/* The lowest speed at which a mode begins to grow; INFINITY: there is none up to *top. */
static enum hawser_status critical_speed(double *speed, double *top, const struct hawser_scene *scene,
                                         int modes, struct hawser_report *report)
{
	double value[SPEEDS];
	const struct hawser_damped_sweep_options options = {.key = "wind.speed", .value = value,
		.points = SPEEDS, .modes = {.n = modes, .tolerance = TOLERANCE}};

	for (int i = 0; i < SPEEDS; i++)
		value[i] = (LEAST + (REACH - LEAST)*i/(SPEEDS - 1))*scene->wind.speed;
	*top = value[SPEEDS - 1];
	return hawser__damped_onset(speed, scene, &options, report);
}

static enum hawser_status gallop_point(void *context, struct hawser_map_sample *sample, double *marks,
                                       double x, double y, struct hawser_report *report)
{
	const struct gallop_map *map = context;
	struct hawser_scene scene = *map->source.scene; /* its `name` is shared with the source */
	double speed, top;
	enum hawser_status status = hawser_scene_set(&scene, map->source.key[0], x, report);

	*sample = (struct hawser_map_sample){0.0, 0, HAWSER_MAP_OK};
	if (!status)
		status = hawser_scene_set(&scene, map->source.key[1], y, report);
	if (!status)
		status = critical_speed(&speed, &top, &scene, map->modes, report);
	if (status == HAWSER_ERR_MEMORY)
		return status;
	if (status) {
		sample->code = status == HAWSER_ERR_NO_SOLUTION ? HAWSER_MAP_NO_STATE
		               : status == HAWSER_ERR_CONVERGENCE ? HAWSER_MAP_NOT_CONVERGED
		                                                  : HAWSER_MAP_REFUSED;
	} else if (isinf(speed)) {
		sample->code = HAWSER_MAP_NO_STATE;
		(void)hawser__fail(report, HAWSER_OK, "map", "no mode begins to grow up to %.4g m/s, %g times "
		                   "wind.speed", top, REACH);
	} else {
		sample->value = speed;
		sample->number = speed < scene.wind.speed;
	}
	if (marks) { /* the wind is faster than the critical speed by so much */
		double faster = scene.wind.speed - speed;

		marks[0] = sample->number ? faster : HUGE_VAL;
		marks[1] = sample->number ? -HUGE_VAL : faster;
	}
	return HAWSER_OK;
}

static enum hawser_status open_gallop(void **worker, void *context, struct hawser_report *report)
{
	(void)report;
	*worker = context;
	return HAWSER_OK;
}

static void close_gallop(void *worker)
{
	(void)worker;
}

static enum hawser_status check_gallop(const struct hawser_map_source *source,
                                       struct hawser_report *report)
{
	double unused;

	if (!source->scene || !source->scene->wind.present)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "the quantity critical-speed is that of a span in a wind: give a scene "
		                    "with the section wind");
	if (strcmp(source->key[0], source->key[1]) == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map", "both axes are %s: give --y another "
		                    "key", source->key[0]);
	for (int k = 0; k < 2; k++) {
		if (strcmp(source->key[k], "wind.speed") == 0)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
			                    "wind.speed is what the quantity critical-speed is: choose another "
			                    "axis, or the quantity growth");
		if (hawser_scene_get(source->scene, &unused, source->key[k], report))
			return HAWSER_ERR_ARGUMENT;
	}
	return HAWSER_OK;
}

enum hawser_status hawser_map_gallop_open(struct hawser_map_field *field,
                                          const struct hawser_map_source *source,
                                          struct hawser_report *report)
{
	enum hawser_status status = check_gallop(source, report);
	struct gallop_map *map = status ? NULL : calloc(1, sizeof *map);
	size_t size = 0;
	FILE *stream;

	*field = (struct hawser_map_field){.name = source->quantity};
	if (status)
		return status;
	if (!map)
		return hawser__no_memory(report, "map");
	map->source = *source;
	map->modes = source->scene->model.modes > 0 ? source->scene->model.modes : FEW;
	*field = (struct hawser_map_field){.name = source->quantity, .context = map,
		.threshold = source->scene->wind.speed, .marks = 2, .margins = 1, .open = open_gallop,
		.close = close_gallop, .point = gallop_point};
	stream = open_memstream(&map->identity, &size);
	if (stream) {
		fprintf(stream, "hawser %s, %s over %s and %s, %d modes\n", hawser_version(), source->quantity,
		        source->key[0], source->key[1], map->modes);
		status = hawser_scene_write(source->scene, stream, report);
	}
	if (!stream || fclose(stream) != 0 || !map->identity)
		status = hawser__no_memory(report, "map");
	field->identity = map->identity;
	if (status)
		hawser_map_gallop_close(field);
	return status;
}

void hawser_map_gallop_close(struct hawser_map_field *field)
{
	struct gallop_map *map = field ? field->context : NULL;

	if (!map)
		return;
	free(map->identity);
	free(map);
	*field = (struct hawser_map_field){.name = NULL};
}

/* cli/model/judged_plane.c - planes of parameters of travelling cables: the model, and the error of the
 * boundaries.
 *
 * The coordinates are the span of complex modes (hawser_complex_modes_span), whose frequencies it has
 * exactly. Regions of instability lie where two of them add up to a multiple of Omega, for the most to
 * Omega; the second harmonic of the fluctuation drives the response at twice that. So modes up to a
 * little more than twice the largest Omega are taken, at the corner of the plane that has the most.
 * For the span of the first table in doc/theory-hill.md, 8 complex modes give edges to 2e-4 of the
 * width, with 16 coordinates; 24 coordinates of a full-order model and 60 modes at rest are no better.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/gyroscopic.h>

#include "cli/model/judged.h"
#include "core/report.h"

static const double beyond = 2.05; /* times the largest Omega: complex modes up to there; chosen */
enum { LEAST = 4, MOST = 14, MORE = 4 }; /* complex modes; and those of a better model more */
enum { LINES = 3 };

static int is_factor(const char *key)
{
	return strcmp(key, "Omega") == 0 || strncmp(key, "factor.", 7) == 0;
}

/* The axis along which boundaries are compared: Omega if it is one. */
static int along(const struct hawser_map_source *source)
{
	return strcmp(source->key[1], "Omega") == 0;
}

static double top(const struct hawser_map_source *source)
{
	for (int k = 0; k < 2; k++)
		if (strcmp(source->key[k], "Omega") == 0)
			return fmax(source->from[k], source->to[k]);
	return source->omega;
}

/* Complex modes at one corner of the plane; 0: it has no such modes. */
static int waves_at(const struct hawser_map_source *source, int corner)
{
	const struct hawser_modes_options options = {.n = MOST};
	struct hawser_scene scene = *source->scene;
	struct hawser_modes modes = {.n = 0};
	struct hawser_statics statics = {.H = 0.0};
	enum hawser_status status = HAWSER_OK;
	int count = 0;

	for (int k = 0; k < 2 && !status; k++)
		if (!is_factor(source->key[k]))
			status = hawser_scene_set(&scene, source->key[k],
			                          corner >> k & 1 ? source->to[k] : source->from[k], NULL);
	if (!status)
		status = hawser_statics_scene(&statics, &scene, NULL);
	if (status || statics.space || statics.attachments > 0 || statics.bending.EI > 0.0 ||
	    statics.elastic || statics.motion.nu == 0.0)
		return 0;
	status = hawser_complex_modes_solve(&modes, &statics, &options, NULL);
	while (!status && count < modes.n &&
	       modes.mode[count].omega <= beyond*top(source)*modes.time_unit)
		count++;
	hawser_modes_clear(&modes);
	return status ? 0 : count > LEAST ? count : LEAST;
}

static int waves_of(const struct hawser_map_source *source)
{
	int most = 0;

	for (int corner = 0; corner < 4; corner++) {
		int count = waves_at(source, corner);

		most = count > most ? count : most;
	}
	return most;
}

static int travels(const struct hawser_map_source *source)
{
	const struct hawser_scene *scene = source->scene;

	return scene && !scene->beam.form && scene->travel.present && top(source) > 0.0 &&
	       scene->model.modes != HAWSER_MODES_AUTO &&
	       (scene->travel.speed != 0.0 || strcmp(source->key[0], "travel.speed") == 0 ||
	        strcmp(source->key[1], "travel.speed") == 0);
}

/* The error of the scene's model at its natural frequencies. */
static enum hawser_status measure(struct cli_judged *judged, const struct hawser_map_source *source,
                                  struct hawser_report *report)
{
	struct cli_model own = {.has_scene = 1, .scene = *source->scene};
	struct hawser_modes modes = {.n = 0};
	struct hawser_modes_options options = cli_modes_options(&own.scene);
	struct hawser_statics statics;
	enum hawser_status status = hawser_statics_scene(&statics, &own.scene, NULL);

	if (!status && own.scene.model.energy == HAWSER_ENERGY_EXACT)
		status = hawser_rom_build_full(&own.rom, &statics, &own.scene, own.scene.model.basis, NULL);
	else if (!status && !(status = hawser_modes_solve(&modes, &statics, &options, NULL)))
		status = hawser_rom_build_linear(&own.rom, &modes, &own.scene, NULL);
	hawser_modes_clear(&modes);
	if (status) /* the points of the plane tell of it */
		return HAWSER_OK;
	status = cli_judged_choose(judged, &own, 0, top(source), report);
	judged->coordinates = own.rom.n;
	hawser_rom_clear(&own.rom);
	return status;
}

enum hawser_status cli_judged_plane(struct cli_judged *judged, struct hawser_map_source *source,
                                    const struct cli_model *model, int free,
                                    struct hawser_report *report)
{
	*judged = (struct cli_judged){.stated = 0};
	if (!model->has_scene || model->made || !travels(source))
		return HAWSER_OK;
	if (free)
		judged->waves = source->waves = waves_of(source);
	judged->coordinates = 2*judged->waves;
	return judged->waves > 0 ? HAWSER_OK : measure(judged, source, report);
}

/* --- boundaries --- */

/* A crossing of a line along the axis. */
struct crossing {
	double other, at;
};

static int by_place(const void *a, const void *b)
{
	const struct crossing *x = a, *y = b;

	return x->other != y->other ? (x->other > y->other) - (x->other < y->other)
	                            : (x->at > y->at) - (x->at < y->at);
}

/* Lines from crossings [count] in the order of by_place: LINES of them, evenly among those that have
 * two crossings or more; at [count] for their numbers. */
static int lines_of(struct hawser_map_line line[LINES], double *at, const struct crossing *crossing,
                    int count)
{
	int groups = 0, lines = 0, seen = 0;

	for (int pass = 0; pass < 2; pass++)
		for (int i = 0, n; i < count; i += n) {
			for (n = 1; i + n < count && crossing[i + n].other == crossing[i].other; n++)
				;
			for (int k = i; k < i + n; k++)
				at[k] = crossing[k].at;
			if (n < 2)
				continue;
			if (pass == 0)
				groups++;
			else if (lines < LINES && seen++ == (2*lines + 1)*groups/(2*LINES))
				line[lines++] = (struct hawser_map_line){crossing[i].other, n, at + i};
		}
	return lines;
}

static enum hawser_status compare(struct cli_judged *judged, const struct hawser_map_source *source,
                                  struct crossing *crossing, int count, struct hawser_report *report)
{
	struct hawser_scene scene = *source->scene;
	struct hawser_map_source better = *source;
	struct hawser_map_line line[LINES];
	double *at = malloc(((size_t)count + 1)*sizeof *at);
	enum hawser_status status = at ? HAWSER_OK : hawser__no_memory(report, "map");

	scene.model.energy = HAWSER_ENERGY_QUARTIC;
	scene.model.condense = HAWSER_CONDENSE_STATIC;
	better.scene = &scene;
	better.waves = judged->waves > 0 ? judged->waves + MORE : waves_of(source);
	if (!status && better.waves > 0 && count > 0) {
		qsort(crossing, (size_t)count, sizeof *crossing, by_place);
		status = hawser_map_shift(&judged->edges, source, &better, along(source), line,
		                          lines_of(line, at, crossing, count), report);
	}
	judged->unit = strcmp(source->key[along(source)], "Omega") == 0 ? "rad/s" : "";
	free(at);
	return status;
}

enum hawser_status cli_judged_map(struct cli_judged *judged, const struct hawser_map_source *source,
                                  const struct hawser_map *map, struct hawser_report *report)
{
	int k = judged->coordinates > 0 ? along(source) : 0, count = 0;
	struct crossing *crossing;
	enum hawser_status status;

	if (judged->coordinates == 0 || map->interrupted)
		return HAWSER_OK;
	crossing = malloc(((size_t)map->boundaries + 1)*sizeof *crossing);
	if (!crossing)
		return hawser__no_memory(report, "map");
	for (int b = 0; b < map->boundaries; b++) {
		const struct hawser_map_boundary *at = &map->boundary[b];

		if (at->along == k && at->number[0] != at->number[1] && at->code[0] == HAWSER_MAP_OK &&
		    at->code[1] == HAWSER_MAP_OK)
			crossing[count++] = (struct crossing){k ? at->x : at->y, k ? at->y : at->x};
	}
	status = compare(judged, source, crossing, count, report);
	free(crossing);
	return status;
}

/* Where a boundary crosses the line other = at. */
static int cross(struct crossing *to, const struct hawser_hill_boundary *boundary, int k, double at)
{
	int count = 0;

	for (int i = 0; i + 1 < boundary->points; i++) {
		const double *p = boundary->at + 2*i, *q = p + 2;
		double a = p[1 - k] - at, b = q[1 - k] - at;

		if ((a < 0.0) != (b < 0.0)) {
			if (to)
				to[count] = (struct crossing){at, p[k] + (q[k] - p[k])*a/(a - b)};
			count++;
		}
	}
	return count;
}

enum hawser_status cli_judged_chart(struct cli_judged *judged, const struct hawser_map_source *source,
                                    const struct hawser_hill_chart *chart,
                                    struct hawser_report *report)
{
	int k, count = 0;
	struct crossing *crossing = NULL;
	enum hawser_status status;

	if (judged->coordinates == 0 || chart->interrupted)
		return HAWSER_OK;
	k = along(source);
	for (int pass = 0; pass < 2; pass++) {
		count = 0;
		for (int i = 0; i < LINES; i++)
			for (int b = 0; b < chart->boundaries; b++) {
				double part = (i + 0.87)/LINES;

				count += cross(crossing ? crossing + count : NULL, &chart->boundary[b], k,
				               source->from[1 - k] + part*(source->to[1 - k] - source->from[1 - k]));
			}
		if (pass == 0 && !(crossing = malloc(((size_t)count + 1)*sizeof *crossing)))
			return hawser__no_memory(report, "hill");
	}
	status = compare(judged, source, crossing, count, report);
	free(crossing);
	return status;
}

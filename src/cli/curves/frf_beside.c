/* cli/curves/frf_beside.c - a second response in the picture of a frequency response, read from its
 * JSON result.
 *
 * The stable and the unstable parts become one overlay each, with NAN where the other one is. A part
 * contains the neighbouring points of the other part, so that no gap remains between the two.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/curves/frf_beside.h"
#include "cli/model/state.h"
#include "core/report.h"

/* "raw 5 modes" of "out/raw-5-modes.json". */
static void name_it(char *label, size_t size, const char *path)
{
	const char *name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path, *end = strrchr(name, '.');
	size_t length = end && end > name ? (size_t)(end - name) : strlen(name), k;

	for (k = 0; k < length && k + 1 < size; k++)
		label[k] = isalnum((unsigned char)name[k]) ? name[k] : ' ';
	label[k] = '\0';
	if (strcmp(path, "-") == 0)
		snprintf(label, size, "other response");
}

enum hawser_status cli_beside_open(struct cli_beside *beside, const char *path,
                                   const struct cli_model *model, struct hawser_report *report)
{
	enum hawser_status status = cli_state_root(&beside->root, path, report);
	const char *command;

	if (status)
		return status;
	name_it(beside->label, sizeof beside->label, path);
	command = json_string_value(json_object_get(beside->root, "command"));
	if (!command || strcmp(command, "frf") != 0 ||
	    json_array_size(json_object_get(beside->root, "points")) == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--beside %s: that is no result of hawser frf with points, as --json "
		                    "writes it", path);
	if (json_is_false(json_object_get(beside->root, "si")) != !model->rom.scaled)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "frf",
		                    "--beside %s: that response %s units, and this model %s: give one of the "
		                    "same kind", path, model->rom.scaled ? "has no" : "has",
		                    model->rom.scaled ? "has them" : "has none");
	return HAWSER_OK;
}

/* --- its points --- */

/* The points of branch k, from 0; NULL beyond the last. */
static json_t *branch(const struct cli_beside *beside, size_t k)
{
	return json_object_get(k == 0 ? beside->root
	                       : json_array_get(json_object_get(beside->root, "branches"), k - 1),
	                       "points");
}

static size_t count(const struct cli_beside *beside)
{
	size_t points = 0;

	for (size_t k = 0; branch(beside, k); k++)
		points += json_array_size(branch(beside, k)) + 1;
	return points;
}

static double number(const json_t *value)
{
	return json_is_number(value) ? json_number_value(value) : NAN;
}

/* The amplitudes of a point, in the order of the present model. Returns how many it has. */
static int take(double *probe, double *coordinate, const json_t *point,
                const struct cli_frf_result *result)
{
	const struct hawser_rom *rom = &result->model->rom;
	double length = cli_per_length(result->model);
	int known = 0;

	for (int p = 0; p < result->frf->probes; p++)
		for (int c = 0; c < 3; c++) {
			char key[64];

			snprintf(key, sizeof key, "%c_%s", "xyz"[c], rom->shapes.name[p]);
			probe[3*p + c] = number(json_object_get(json_object_get(point, "amplitude"), key))/length;
			known += isfinite(probe[3*p + c]) != 0;
		}
	for (int j = 0; j < result->frf->n; j++) {
		coordinate[j] = number(json_array_get(json_object_get(point, "coordinates"),
		                                      (size_t)j))/length;
		known += result->frf->probes == 0 && isfinite(coordinate[j]);
	}
	return known;
}

static void erase(double *row, int width)
{
	for (int k = 0; k < width; k++)
		row[k] = NAN;
}

/* Remove point i from the part where neither it nor a neighbour is. stable [points]; -1 between
 * branches. */
static void divide(struct cli_beside *beside, const int *stable, const struct cli_frf_result *result)
{
	int width = 3*result->frf->probes, n = result->frf->n;

	for (int i = 0; i < beside->points; i++)
		for (int part = 0; part < 2; part++) {
			int own = part == 0;

			if (stable[i] == own || (i > 0 && stable[i - 1] == own))
				continue;
			erase(beside->probe[part] + (size_t)i*(size_t)width, width);
			erase(beside->coordinate[part] + (size_t)i*(size_t)n, n);
		}
}

static int read_points(struct cli_beside *beside, int *stable, const struct cli_frf_result *result)
{
	int width = 3*result->frf->probes, n = result->frf->n, known = 0, i = 0;
	size_t wide = (size_t)width*sizeof(double), all = (size_t)n*sizeof(double);

	for (size_t k = 0; branch(beside, k); k++) {
		for (size_t m = 0; m <= json_array_size(branch(beside, k)); m++, i++) {
			const json_t *point = json_array_get(branch(beside, k), m);
			double *probe = beside->probe[0] + (size_t)i*(size_t)width;
			double *coordinate = beside->coordinate[0] + (size_t)i*(size_t)n;

			/* beyond the last point there is none, and everything is NAN */
			beside->omega[i] = number(json_object_get(point, "Omega"))/cli_per_omega(result->model);
			stable[i] = point ? json_is_true(json_object_get(point, "stable")) : -1;
			known += take(probe, coordinate, point, result);
			memcpy(beside->probe[1] + (size_t)i*(size_t)width, probe, wide);
			memcpy(beside->coordinate[1] + (size_t)i*(size_t)n, coordinate, all);
		}
	}
	return known;
}

enum hawser_status cli_beside_overlays(struct cli_overlay *overlay, int *overlays,
                                       struct cli_beside *beside,
                                       const struct cli_frf_result *result,
                                       struct hawser_report *report)
{
	size_t points = count(beside);
	int *stable = malloc((points + 1)*sizeof *stable), room = stable != NULL, known;

	*overlays = 0;
	beside->points = (int)points;
	beside->omega = malloc((points + 1)*sizeof *beside->omega);
	for (int part = 0; part < 2; part++) {
		beside->probe[part] = malloc((points*3*(size_t)result->frf->probes + 1)*sizeof(double));
		beside->coordinate[part] = malloc((points*(size_t)result->frf->n + 1)*sizeof(double));
		room = room && beside->probe[part] && beside->coordinate[part];
	}
	if (!room || !beside->omega) {
		free(stable);
		return hawser__no_memory(report, "frf");
	}
	known = read_points(beside, stable, result);
	divide(beside, stable, result);
	free(stable);
	if (known == 0) {
		cli_warn("--beside: that response has no displacement of a point that this model has, so the "
		         "picture does not show it");
		return HAWSER_OK;
	}
	for (int part = 0; part < 2; part++)
		overlay[part] = (struct cli_overlay){part ? "" : beside->label, beside->points, beside->omega,
		                                     beside->probe[part], beside->coordinate[part], part + 1};
	*overlays = 2;
	return HAWSER_OK;
}

void cli_beside_clear(struct cli_beside *beside)
{
	json_decref(beside->root);
	free(beside->omega);
	for (int part = 0; part < 2; part++) {
		free(beside->probe[part]);
		free(beside->coordinate[part]);
	}
	*beside = (struct cli_beside){.root = NULL};
}

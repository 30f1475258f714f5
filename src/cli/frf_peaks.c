/* cli/frf_peaks.c - the peaks of a frequency response: finding them, and telling them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/cli.h"
#include "core/report.h"

enum { name_size = 80 };

static int tells_tension(const struct hawser_landmark *peak)
{
	return peak->kind == HAWSER_LANDMARK_TENSION || peak->kind == HAWSER_LANDMARK_LEAST_TENSION;
}

/* "z", "T_max", "u_3" */
static void component(char *text, size_t size, const struct hawser_landmark *peak)
{
	if (tells_tension(peak))
		snprintf(text, size, "%s",
		         peak->kind == HAWSER_LANDMARK_TENSION ? "T_max" : "T_min");
	else if (peak->probe < 0)
		snprintf(text, size, "u_%d", peak->axis + 1);
	else
		snprintf(text, size, "%c", "xyz"[peak->axis]);
}

/* In SI where the model has units. */
static double size_of(const struct cli_frf_result *result, const struct hawser_landmark *peak)
{
	if (peak->kind == HAWSER_LANDMARK_TENSION)
		return peak->rest + peak->size;
	if (peak->kind == HAWSER_LANDMARK_LEAST_TENSION)
		return peak->rest - peak->size;
	return peak->size*cli_per_length(result->model);
}

static const char *unit_of(const struct cli_frf_result *result, const struct hawser_landmark *peak)
{
	return tells_tension(peak) ? " N" : result->model->rom.scaled ? " m" : "";
}

void cli_frf_peak_comments(struct hawser__table *table, const struct cli_frf_result *result)
{
	for (int k = 0; k < result->peaks; k++) {
		const struct hawser_landmark *peak = &result->peak[k];
		char name[name_size];

		component(name, sizeof name, peak);
		hawser__table_comment(table, "peak: %s%s%s = %.9g%s at Omega = %.12g%s%s (relative errors "
		                      "%.1e, %.1e)", name, peak->probe < 0 ? "" : "_",
		                      peak->probe < 0 ? "" : result->model->rom.shapes.name[peak->probe],
		                      size_of(result, peak), unit_of(result, peak),
		                      peak->omega*cli_per_omega(result->model),
		                      result->model->rom.scaled ? " rad/s" : "",
		                      peak->stable ? "" : ", unstable", peak->size_error,
		                      peak->omega_error);
	}
}

void cli_frf_peaks_json(struct hawser__json *json, const struct cli_frf_result *result)
{
	json_t *list = hawser__json_array(json, json->root, "peaks"), *row;

	for (int k = 0; k < result->peaks; k++) {
		const struct hawser_landmark *peak = &result->peak[k];
		char name[name_size];

		row = hawser__json_object(json, list, NULL);
		component(name, sizeof name, peak);
		if (peak->probe < 0)
			hawser__json_null(json, row, "probe");
		else
			hawser__json_text(json, row, "probe", result->model->rom.shapes.name[peak->probe]);
		hawser__json_text(json, row, "component", name);
		hawser__json_number(json, row, "Omega", peak->omega*cli_per_omega(result->model));
		hawser__json_number(json, row, "size", size_of(result, peak));
		hawser__json_number(json, row, "Omega_error", peak->omega_error);
		hawser__json_number(json, row, "size_error", peak->size_error);
		if (tells_tension(peak))
			hawser__json_number(json, row, "at_rest", peak->rest);
		hawser__json_flag(json, row, "stable", peak->stable);
		hawser__json_number(json, row, "arc", peak->arc);
	}
}

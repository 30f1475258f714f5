/* study/map/map_row_model.c - the model of a row of a map of responses, and its family where the
 * parameter that is followed is not Omega. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/scene_family.h>

#include "core/report.h"
#include "study/map/map_cable.h"
#include "study/map/map_rows.h"

int hawser__map_row_along(const void *context)
{
	const struct hawser__map_cable *cable = context;
	const enum hawser__reach *reach = cable->reach;

	for (int k = 0; k < 2; k++)
		if (reach[k] == HAWSER__REACH_OMEGA)
			return k;
	for (int k = 0; k < 2; k++)
		if (reach[k] == HAWSER__REACH_LOAD)
			return k;
	return strncmp(cable->source.key[0], "model.", 6) == 0;
}

/* The frequency of a row over something else. */
static double frequency_of(const struct hawser__map_cable *cable, const struct hawser__map_row *row,
                           int along)
{
	return cable->reach[1 - along] == HAWSER__REACH_OMEGA ? row->fixed : cable->source.omega;
}

/* Over a key of the scene. A second family keeps the first model, which a trace refers to. */
static enum hawser_status over_key(const struct hawser__map_cable *cable, struct hawser__map_row *row,
                                   const double at[2], int along, struct hawser_report *report)
{
	const char *key = cable->source.key[along];
	double from = fmin(row->at[0], row->at[row->count - 1]);
	double to = fmax(row->at[0], row->at[row->count - 1]), omega = frequency_of(cable, row, along);
	struct hawser_rom_family family = {.context = NULL}, keeper = {.context = NULL};
	const struct hawser_rom *rom;
	struct hawser_scene scene;
	enum hawser_status status = hawser__map_cable_axes(&scene, cable, at, HAWSER__REACH_RATES, report);

	if (!status)
		status = hawser_scene_family_open(&family, &scene, key, from, to, from, omega, report);
	if (status)
		return status;
	status = hawser_scene_family_open(&keeper, &scene, key, from, to, from, omega, report);
	if (!status && !(status = keeper.model(keeper.context, &rom, from, report)))
		status = hawser__map_row_follow(row, rom, &family, omega, 0, report);
	if (keeper.context)
		hawser_scene_family_close(&keeper);
	hawser_scene_family_close(&family);
	return status;
}

/* Over a parameter of a file, with the other one at its value. */
static enum hawser_status over_parameter(const struct hawser__map_cable *cable,
                                         struct hawser__map_row *row, const double at[2], int along,
                                         struct hawser_report *report)
{
	struct hawser_rom_family family = {.context = NULL};
	struct hawser_parameter parameter[HAWSER_PARAMETERS];
	struct hawser_rom_source file;
	struct hawser_rom rom = {.n = 0};
	double omega = frequency_of(cable, row, along);
	const char *name = cable->source.key[along];
	enum hawser_status status;

	hawser__map_cable_file(&file, parameter, cable, at);
	status = hawser_rom_source_model(&rom, &file, report);
	if (!status)
		status = hawser_parameter_open(&family, &file, name, omega, report);
	if (!status) {
		status = hawser__map_row_follow(row, &rom, &family, omega, 0, report);
		hawser_parameter_close(&family);
	}
	hawser_rom_clear(&rom);
	return status;
}

static enum hawser_status trace_row(void *worker, const struct hawser__map_cable *cable,
                                    struct hawser__map_row *row, int *steady,
                                    struct hawser_report *report)
{
	int along = hawser__map_row_along(cable) != row->across;
	enum hawser__reach reach = cable->reach[along];
	struct hawser_rom_family family = {.context = NULL};
	const struct hawser_rom *rom;
	double at[2], omega, last = fmax(row->at[0], row->at[row->count - 1]);
	enum hawser_status status;

	at[1 - along] = row->fixed;
	at[along] = reach == HAWSER__REACH_LOAD ? 1.0 : reach == HAWSER__REACH_OMEGA && !(last > 0.0)
	                                                        ? 1.0 : last;
	*steady = 0;
	if (reach != HAWSER__REACH_OMEGA && reach != HAWSER__REACH_LOAD) {
		*steady = reach != HAWSER__REACH_PARAMETER;
		return *steady ? over_key(cable, row, at, along, report)
		               : over_parameter(cable, row, at, along, report);
	}
	status = hawser__map_worker_model(worker, &rom, &omega, steady, at[0], at[1], report);
	*steady = status != HAWSER_OK && *steady;
	if (!status && reach == HAWSER__REACH_OMEGA)
		return hawser__map_row_follow(row, rom, NULL, last, 1, report);
	if (!status)
		status = hawser_factor_open(&family, rom, HAWSER_FACTOR_LOAD, omega, report);
	if (status)
		return status;
	status = hawser__map_row_follow(row, rom, &family, omega, 1, report);
	hawser_factor_close(&family);
	return status;
}

enum hawser_status hawser__map_worker_row(void *worker, struct hawser__map_row *row,
                                          struct hawser_report *report)
{
	struct hawser_map_sample sample = {.value = 0.0};
	struct hawser_report local = {.status = HAWSER_OK};
	enum hawser_status status;
	int steady;

	row->answer = calloc((size_t)row->count, sizeof *row->answer);
	if (!row->answer)
		return hawser__no_memory(report, "map");
	status = trace_row(worker, hawser__map_worker_cable(worker), row, &steady, &local);
	if (status && hawser__map_own_failure(&sample, status, steady)) {
		hawser__map_row_fill(row, 0, row->count, sample.code, local.message);
		status = HAWSER_OK;
	}
	if (status && report)
		*report = local;
	row->ready = !status && !row->interrupted;
	return status;
}

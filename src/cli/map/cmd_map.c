/* cli/map/cmd_map.c - hawser map: a quantity over two parameters, and where stability changes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/axis.h"
#include "cli/model/exact.h"
#include "cli/frame/hdf5.h"
#include "cli/model/judged.h"
#include "cli/model/label.h"
#include "cli/map/map_part.h"
#include "cli/frame/part.h"
#include "cli/frame/progress.h"
#include "cli/frame/view.h"
#include "cli/map/tongues.h"
#include "core/report.h"

/* Of critical-speed, of which a point takes some 10 ms, and twice as much where nothing grows: */
enum { GALLOP_POINTS = 17 };  /* along an axis */
#define GALLOP_TOLERANCE 4e-3 /* width of brackets: a sixteenth of a cell; chosen */

struct settings {
	struct cli_common common;
	const char *x, *y, *points, *quantity, *omega, *checkpoint, *boundary, *part, *hdf5, *label;
	double jump, tolerance;
	int n, depth, coarse, threads, full, partial, stable, rest;
};
static const struct cli_option options[] = {
	{"x", 0, "KEY=FROM:TO", "horizontal axis: a key of the scene, or Omega", CLI_TEXT(x)},
	{"y", 0, "KEY=FROM:TO", "vertical axis", CLI_TEXT(y)},
	{"quantity", 0, "NAME",
	 "growth, multiplier, unstable, amplitude, basin or critical-speed (by the axes)",
	 CLI_TEXT(quantity)},
	{"points", 0, "NXxNY", "resolution (200x200; critical-speed: 17x17)", CLI_TEXT(points)},
	{"modes", 'n', "N", "number of modes (the scene's model.modes)", CLI_INTEGER(n)},
	CLI_LIBRARY_OPTION,
	{"Omega", 0, "FREQUENCY", "frequency of the forcing, if it is no axis", CLI_TEXT(omega)},
	CLI_HEADING("What is mapped"),
	{"rest", 0, "", "stability of rest, whatever moves the model", CLI_FLAG(rest)},
	{"from-label", 0, "FILE#LABEL", "amplitude: with the motions that are connected to this label of a "
	 "JSON result of frf", CLI_TEXT(label)},
	{"stable", 0, "", "amplitude: min, max and branches of stable responses only", CLI_FLAG(stable)},
	CLI_HEADING("Resolution"),
	{"depth", 0, "N", "resolution of 2^N cells along each axis, instead of --points",
	 CLI_INTEGER(depth), .most = 14, .excludes = "points"},
	{"coarse", 0, "N", "size of the first cells, in smallest cells; 1: every point (8)",
	 CLI_INTEGER(coarse)},
	{"jump", 0, "NUMBER", "split cells in which the value varies by this part (0.05)",
	 CLI_POSITIVE(jump)},
	{"tolerance", 0, "NUMBER", "width of boundary brackets, as a part of the range (1e-4)",
	 CLI_POSITIVE(tolerance)},
	CLI_HEADING("Running"),
	{"threads", 0, "N", "number of threads (all processors)", CLI_INTEGER(threads)},
	{"checkpoint", 0, "FILE", "save points to this file, and continue from those in it",
	 CLI_TEXT(checkpoint)},
	{"part", 0, "K/N", "compute part K of N into the checkpoint; hawser merge joins them",
	 CLI_TEXT(part)},
	{"partial", 0, "", "leave points empty that cannot be computed, and warn", CLI_FLAG(partial)},
	CLI_HEADING("Files"),
	{"boundary", 0, "FILE", "write the points of the boundaries as a table", CLI_TEXT(boundary)},
	{"hdf5", 0, "FILE", "write points and boundaries as HDF5, for millions of rows", CLI_TEXT(hdf5)},
	{"full", 0, "", "write interpolated points to the table too", CLI_FLAG(full)},
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Computes a quantity over two parameters. Cells are split where stability changes, down to the",
	"resolution, and the boundary is then bracketed on their edges.",
	"KEY: a numeric key of the scene (man hawser-scene), a parameter of the model's file, Omega,",
	"factor.load (of all excitation) or factor.damping. FROM and TO: in SI, or with a unit, or 0.6w1.",
	"With a forcing frequency stability is that of the periodic response, or of rest where nothing",
	"moves the model, or with --rest.",
	NULL,
};

/* --- what the user wrote --- */

static enum hawser_status read_points(int points[2], const struct settings *settings,
                                      struct hawser_report *report)
{
	char *end;
	long along[2];

	if (settings->depth > 0)
		points[0] = points[1] = (1 << settings->depth) + 1;
	if (!settings->points)
		return HAWSER_OK;
	along[0] = strtol(settings->points, &end, 10);
	along[1] = *end == 'x' ? strtol(end + 1, &end, 10) : 0;
	for (int k = 0; k < 2; k++)
		points[k] = along[k] < 0 ? -1 : along[k] > INT_MAX ? INT_MAX : (int)along[k];
	if (*end || points[0] == 0 || points[1] == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "--points %s: write two whole numbers such as 200x100",
		                    settings->points);
	return HAWSER_OK;
}

static int is_of(const char *axis, const char *begin)
{
	return axis && strncmp(axis, begin, strlen(begin)) == 0;
}

/* Without --quantity: multipliers of motions at a frequency, growth of others. */
static const char *quantity_by_axes(const struct settings *settings)
{
	int at_frequency = settings->omega || is_of(settings->x, "Omega=") || is_of(settings->y, "Omega=");
	int beam = is_of(settings->x, "beam.") || is_of(settings->y, "beam.");

	return at_frequency && !beam ? "multiplier" : "growth";
}

static enum hawser_status read_quantity(struct cli_map_result *result, const char *name,
                                        struct hawser_report *report)
{
	const char *words[8];
	int count = 0, k;
	enum hawser_status status;

	for (; hawser_map_quantity(count); count++)
		words[count] = hawser_map_quantity(count)->name;
	status = cli_choose(&k, "map", "quantity", name, words, count, report);
	result->quantity = hawser_map_quantity(status ? 0 : k);
	return status;
}

static void read_numbers(struct hawser_map_options *to, const struct settings *settings)
{
	if (settings->coarse > 0)
		to->coarse = settings->coarse;
	if (settings->jump > 0.0)
		to->jump = settings->jump;
	if (settings->tolerance > 0.0)
		to->tolerance = settings->tolerance;
	if (strcmp(settings->quantity, "critical-speed") == 0) {
		for (int k = 0; k < 2; k++)
			to->points[k] = to->points[k] ? to->points[k] : GALLOP_POINTS;
		to->tolerance = to->tolerance > 0.0 ? to->tolerance : GALLOP_TOLERANCE;
	}
	hawser_map_settle(to);
	/* brackets that are narrower than cells would cost as much again as the points of a basin's map */
	if (strcmp(settings->quantity, "basin") == 0 && !(settings->tolerance > 0.0))
		to->tolerance = fmin(0.5, 1.0/(fmin(to->points[0], to->points[1]) - 1.0));
	to->threads = settings->threads;
	to->strict = !settings->partial;
	to->only_stable = settings->stable;
	to->checkpoint = settings->checkpoint;
}

/* --- work --- */

static void append(struct hawser_report *report, const char *text)
{
	size_t used = strlen(report->message);

	snprintf(report->message + used, sizeof report->message - used, "%s", text);
}

/* Points that --partial has left empty. */
static void warn_uncomputed(const struct hawser_map *map)
{
	char text[CLI_WARNING_SIZE];
	int count = 0;

	for (int k = 0; k < HAWSER_MAP_CODES; k++)
		count += hawser_map_uncomputed((enum hawser_map_code)k) ? map->count[k] : 0;
	if (map->incomplete > 0) {
		snprintf(text, sizeof text, "in %d rows responses may be missing, since a curve could not be "
		         "followed to its end; the first: %.300s", map->incomplete, map->broken);
		cli_caution("responses may be missing", text);
	}
	if (count == 0)
		return;
	snprintf(text, sizeof text, "%d of %ld points could not be computed and are empty; the comments of "
	         "the table say why", count, map->visited);
	cli_warn(text);
}

static enum hawser_status trace(struct hawser_map *map, struct cli_map_result *result,
                                const struct cli_model *model, const struct settings *settings,
                                const struct hawser_map_start *start, struct hawser_report *report)
{
	struct hawser_map_source source = {
		.scene = model->has_scene ? &model->scene : NULL,
		.rom = model->has_scene ? NULL : &model->rom,
		.file = model->has_scene ? NULL : &model->source, .key = {result->key[0], result->key[1]},
		.from = {result->options.from[0], result->options.from[1]},
		.to = {result->options.to[0], result->options.to[1]}, .omega = result->omega,
		.quantity = result->quantity->name, .rest = settings->rest,
		.start = start, .orbit = 1e-2*settings->tolerance};
	struct cli_watch watch = {.progress = {.quiet = result->common->quiet}};
	struct hawser_map_options choice = result->options;
	struct hawser_map_field field;
	int beam = model->has_scene && model->scene.beam.form;
	int basin = strcmp(result->quantity->name, "basin") == 0;
	int gallop = strcmp(result->quantity->name, "critical-speed") == 0;
	enum hawser_status status = HAWSER_OK;

	if (!result->quantity->nonlinear && !gallop)
		status = cli_judged_plane(&result->judged, &source, model, cli_judged_free(model, settings->n),
		                          report);
	if (!status)
		status = basin ? hawser_map_basin_open(&field, &source, report)
		         : gallop ? hawser_map_gallop_open(&field, &source, report)
		         : beam ? hawser_map_beam_open(&field, &source, settings->n, 0, report)
		                : hawser_map_cable_open(&field, &source, report);

	choice.progress = (struct hawser_progress){cli_watch, &watch};
	choice.strict = choice.strict && !gallop; /* modes may be out of reach far off the scene */
	if (status)
		return status;
	result->along = field.along;
	result->responds = field.responds;
	status = hawser_map_trace(map, &field, &choice, report);
	cli_progress_end(&watch.progress);
	if (status == HAWSER_ERR_CONVERGENCE && choice.strict)
		append(report, "; --partial leaves such points empty, and a smaller range may have none");
	if (!status && map->point && choice.parts == 0)
		status = cli_judged_map(&result->judged, &source, map, report);
	if (!status && basin && map->point)
		status = hawser_basins_count(&result->basins, &field, map, report);
	basin ? hawser_map_basin_close(&field)
	      : gallop ? hawser_map_gallop_close(&field)
	      : beam ? hawser_map_beam_close(&field) : hawser_map_cable_close(&field);
	return status;
}

static enum hawser_status write_result(const struct cli_map_result *result,
                                       const struct settings *settings,
                                       struct hawser_report *report)
{
	struct hawser__table lines = {0};
	enum hawser_status status = HAWSER_OK;

	if (settings->boundary || settings->hdf5)
		cli_map_boundary(&lines, result);
	if (settings->boundary)
		status = hawser__table_write(&lines, settings->boundary, report);
	if (!status && settings->hdf5)
		status = cli_map_hdf5(settings->hdf5, result, &lines, report);
	hawser__table_clear(&lines);
	return status ? status : cli_show(result->common, &cli_map_showing, result, report);
}

/* Rows are followed as they are, without cells. */
static enum hawser_status check_rows(const struct settings *settings, struct hawser_report *report)
{
	const char *option = settings->coarse > 0 ? "coarse" : settings->jump > 0.0 ? "jump"
	                     : settings->tolerance > 0.0 ? "tolerance" : NULL;

	return !option ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
	                      "--%s: a map of amplitudes has no cells that are split: it follows curves "
	                      "along one axis, for each of the --points of the other", option);
}

static int is_worker(const struct hawser__ranks *ranks)
{
	return ranks && ranks->rank > 0;
}

static enum hawser_status check(struct cli_map_result *result, struct settings *settings,
                                struct hawser__ranks *ranks, struct hawser_report *report)
{
	const struct cli_output more[] = {{"checkpoint", settings->checkpoint},
	                                  {"boundary", settings->boundary},
	                                  {"hdf5", settings->hdf5}};
	enum hawser_status status;

	if (!settings->quantity)
		settings->quantity = quantity_by_axes(settings);
	status = read_quantity(result, settings->quantity, report);

	if (!status && strcmp(result->quantity->name, "amplitude") == 0)
		status = check_rows(settings, report);
	else if (!status && settings->stable)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                      "--stable: only the responses of the quantity amplitude are stable or "
		                      "not: the number of instabilities is a column of every map");
	if (!status && settings->label && strcmp(result->quantity->name, "amplitude") != 0)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                      "--from-label is for the quantity amplitude: the quantity %s is of one "
		                      "response", result->quantity->name);
	if (!status && settings->rest && result->quantity->nonlinear)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                      "--rest is for growth, multiplier and unstable: the quantity %s is of "
		                      "responses", result->quantity->name);
	if (!status)
		status = read_points(result->options.points, settings, report);
	read_numbers(&result->options, settings);
	settings->common.delivered = settings->hdf5 != NULL;
	if (!status)
		status = cli_part_read(&result->options.part, &result->options.parts, settings->part, "map",
		                       result->options.checkpoint, &settings->common,
		                       settings->boundary ? "boundary" : settings->hdf5 ? "hdf5" : NULL,
		                       report);
	if (!status)
		status = cli_map_ranks(&result->options, &settings->common, ranks, report);
	if (status || is_worker(ranks))
		return status;
	status = cli_outputs_check_with(&settings->common, more, 3, report);
	if (!status)
		status = cli_hdf5_check(settings->hdf5, report);
	return status ? status : hawser__file_check(settings->boundary, report);
}

static void take_axis(struct cli_map_result *result, int k, const struct cli_map_axis *axis)
{
	result->key[k] = axis->key;
	result->unit[k] = axis->unit;
	result->options.from[k] = axis->backwards ? axis->to : axis->from;
	result->options.to[k] = axis->backwards ? axis->from : axis->to;
}

/* A map of amplitudes may take the exact energy; of the stability of responses the error is stated. */
static enum hawser_status judge_model(const struct cli_map_result *result,
                                      struct cli_model *model, int n, struct hawser_report *report)
{
	const struct hawser_map_options *map = &result->options;
	const char *name = result->quantity->name;
	int k = strcmp(result->key[1], "Omega") == 0, whole = strcmp(name, "amplitude") == 0;
	const struct cli_plane plane = {
		{result->key[0], result->key[1]}, {map->from[0], map->from[1]},
		{map->to[0], map->to[1]}, result->omega,
		!whole ? 0 : map->points[k || strcmp(result->key[0], "Omega") == 0 ? 1 - k : 1]};

	if (!whole && strcmp(name, "multiplier") != 0 && strcmp(name, "unstable") != 0)
		return HAWSER_OK;
	return cli_exact_plane(&plane, model, n, result->common, report);
}

/* The motion at --from-label; label->state is its own. */
static enum hawser_status open_label(struct cli_label *label, struct hawser_map_start *start,
                                     struct cli_map_result *result, const struct settings *settings,
                                     struct hawser_report *report)
{
	const char *over = strcmp(result->key[0], "Omega") == 0 ? result->key[1] : result->key[0];
	const struct hawser_map_options *map = &result->options;
	struct cli_model model = {0};
	int k = 0;
	enum hawser_status status = cli_model_load(&model, &settings->common, settings->n, report);

	if (!status)
		status = cli_label_exact(&model, settings->label, report);
	if (!status)
		status = cli_label_open(label, "from-label", settings->label, over, &model,
		                        &settings->common, report);
	for (; k < 2 && !status; k++) {
		start->at[k] = cli_label_at(label, result->key[k], &model);
		if (!(start->at[k] >= fmin(map->from[k], map->to[k]) &&
		      start->at[k] <= fmax(map->from[k], map->to[k])))
			status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
			                      "--from-label %s: that motion is at %s = %.9g, which is not in the "
			                      "range: give a range that has it", settings->label, result->key[k],
			                      start->at[k]);
	}
	if (!status && label->period > 1)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                      "--from-label %s: that motion has %d periods of the load, and those of a "
		                      "map have one: hawser frf --over and hawser locus follow it",
		                      settings->label, label->period);
	if (!status && !(result->omega > 0.0))
		result->omega = strcmp(over, result->key[0]) == 0 ? cli_label_at(label, "Omega", &model) : 0.0;
	start->coordinates = model.rom.n;
	start->state = label->state;
	cli_model_clear(&model);
	return status;
}

static enum hawser_status make(struct settings *settings, struct hawser__ranks *ranks,
                               struct hawser_report *report)
{
	struct cli_model model = {0};
	struct hawser_map map = {0};
	struct cli_map_result result = {.common = &settings->common, .model = &model, .map = &map,
	                                .full = settings->full};
	struct cli_map_axis axis[2] = {{.copy = NULL}};
	struct cli_label label = {.state = NULL};
	struct hawser_map_start start;
	enum hawser_status status = check(&result, settings, ranks, report);

	if (!status)
		status = cli_model_or_scene(&model, &settings->common, settings->n, report);
	for (int k = 0; k < 2 && !status; k++) {
		status = cli_map_axis(&axis[k], k ? "y" : "x", k ? settings->y : settings->x, &model, report);
		take_axis(&result, k, &axis[k]);
	}
	if (!status && settings->omega)
		status = cli_map_frequency(&result.omega, settings->omega, "Omega", &model, report);
	if (!status && settings->label)
		status = open_label(&label, &start, &result, settings, report);
	if (!status && !settings->rest)
		status = judge_model(&result, &model, settings->n, report);
	if (!status && model.has_scene && model.scene.travel.braking > 0.0)
		cli_warn("travel.braking is left out: the map is of travel.speed, the speed before");
	if (!status)
		status = trace(&map, &result, &model, settings, label.state ? &start : NULL, report);
	if (!status && result.options.parts > 0)
		cli_map_part_done(&result.options, &map, settings->common.quiet || is_worker(ranks));
	else if (!status && !is_worker(ranks))
		cli_map_judge(&result);
	if (!status && !is_worker(ranks)) {
		if (*result.flat)
			cli_caution(result.flat[0] == 'e' ? "empty" : "constant", result.flat);
		cli_exact_range_warn(&model);
		warn_uncomputed(&map);
		cli_judged_warn(&result.judged);
		cli_tongues_warn(&map.narrow);
	}
	if (!status && result.options.parts == 0 && !is_worker(ranks))
		status = write_result(&result, settings, report);
	hawser_map_clear(&map);
	hawser_basins_clear(&result.basins);
	cli_label_clear(&label);
	cli_model_clear(&model);
	free(axis[0].copy);
	free(axis[1].copy);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	struct settings *settings = context;
	struct hawser__ranks *ranks;
	enum hawser_status status = cli_ranks_open(&ranks, "map", report);

	if (!status)
		status = make(settings, ranks, report);
	if (status) {
		cli_ranks_fail(ranks, status, report);
		cli_map_lost(report, ranks, settings->checkpoint);
	}
	if (is_worker(ranks))
		status = HAWSER_OK; /* rank 0 tells of it; mpirun ends all as soon as one fails */
	cli_ranks_close(ranks, NULL);
	return status;
}

const struct cli_command cli_map = {
	"map", "SCENE|MODEL", "Stability and amplitude over two parameters", notes, options, NULL,
	sizeof(struct settings), 1, run, cli_map_listing,
	.takes = CLI_MODELS | CLI_BEAM,
};

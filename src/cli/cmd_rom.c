/* cli/cmd_rom.c - hawser rom: the reduced-order model of a scene, as a file and for AUTO-07p.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>
#include <string.h>

#include "cli/view.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *export[2]; /* format, stem */
	const char *from, *to;
	double tolerance;
	int n, intervals, points;
};
static const struct settings defaults = {
	.from = "0.6w1", .to = "3.3w1",
};

static const struct cli_option options[] = {
	{"modes", 'n', "N", "number of modes kept (the scene's model.modes)", CLI_INTEGER(n)},
	{"export", 0, "FORMAT STEM", "write equations for another program; FORMAT: auto",
	 CLI_TWO(export)},
	{"from", 0, "FREQUENCY", "start of the range of the export, and of modes: auto (0.6w1)",
	 CLI_TEXT(from)},
	{"to", 0, "FREQUENCY", "end of that range (3.3w1)", CLI_TEXT(to)},
	{"tolerance", 0, "NUMBER", "EPSL and EPSU of the export, tolerances (1e-9)",
	 CLI_POSITIVE(tolerance)},
	{"intervals", 0, "N", "NTST of the export, number of mesh intervals (80)", CLI_COUNT(intervals)},
	{"max-points", 0, "N", "NMX of the export, most points (20000)", CLI_COUNT(points)},
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"--json writes the reduced-model file, which frf and integrate take in place of a scene.",
	"FREQUENCY: a number (rad/s), \"0.3 Hz\", or a multiple such as 0.6w1.",
	"With model.modes: auto the modes kept are chosen for forcing from --from to --to.",
	NULL,
};

static void entry(struct hawser__table *table, const char *tensor, const int *index, int indices,
                  double value)
{
	int i;

	hawser__table_word(table, tensor);
	for (i = 0; i < 4; i++)
		if (i < indices)
			hawser__table_number(table, index[i]);
		else
			hawser__table_word(table, "");
	hawser__table_number(table, value);
}

static void matrix(struct hawser__table *table, const char *tensor, const double *a, int n)
{
	int j, k;

	for (j = 0; a && j < n; j++)
		for (k = 0; k < n; k++)
			if (a[j*n + k] != 0.0)
				entry(table, tensor, (int[]){j, k}, 2, a[j*n + k]);
}

static void tensors(struct hawser__table *table, const struct hawser_rom *rom)
{
	int i, j;

	matrix(table, "K", rom->K, rom->n);
	matrix(table, "D", rom->D, rom->n);
	for (i = 0; i < rom->quads; i++)
		entry(table, "Q", (int[]){rom->Q[i].j, rom->Q[i].k, rom->Q[i].l}, 3, rom->Q[i].value);
	for (i = 0; i < rom->cubics; i++)
		entry(table, "C", (int[]){rom->C[i].j, rom->C[i].k, rom->C[i].l, rom->C[i].m}, 4,
		      rom->C[i].value);
	for (i = 0; i < rom->harmonics; i++)
		for (j = 0; rom->harmonic[i].f && j < rom->n; j++)
			if (rom->harmonic[i].f[j] != 0.0)
				entry(table, "f", (int[]){j}, 1, rom->harmonic[i].f[j]);
}

static void fill_table(struct hawser__table *table, const struct settings *settings,
                       const struct cli_model *model)
{
	static const char *const column[] = {"tensor", "j", "k", "l", "m", "value"};
	const struct hawser_rom *rom = &model->rom;
	int i;

	cli_echo_table(table, &settings->common, "rom", model->has_scene ? &model->scene : NULL,
	               rom->exact ? "exact strain energy on all functions of the basis: full order"
	                          : "energy expanded to fourth order, projected on the modes");
	cli_choice_comments(table, model);
	if (rom->exact)
		hawser__table_comment(table, "%d coordinates, %d harmonics; scaled; the restoring force "
		                             "is no polynomial, K is its linear part; model.modes "
		                             "and model.condense do not apply", rom->n,
		                      rom->harmonics);
	else
		hawser__table_comment(table, "%d coordinates, %d quadratic and %d cubic entries, "
		                             "%d harmonics; scaled", rom->n, rom->quads, rom->cubics,
		                      rom->harmonics);
	if (rom->scaled)
		hawser__table_comment(table, "units: length %.12g m, time %.12g s, force %.12g N",
		                      rom->length, rom->time, rom->force);
	if (!rom->exact)
		hawser__table_comment(table, "asymmetry of the derivatives of the energy: %.2e (relative)",
		                      hawser_rom_asymmetry(rom));
	for (i = 0; i < 6; i++)
		hawser__table_column(table, "%s", column[i]);
	tensors(table, rom);
}

/* The files of the export, which hawser_rom_export_auto names so, are outputs like others. */
static enum hawser_status check_export(const struct settings *settings,
                                       struct hawser_report *report)
{
	const char *stem = settings->export[1], *slash = strrchr(stem, '/');
	int folder = slash ? (int)(slash + 1 - stem) : 0;
	size_t size = strlen(stem) + sizeof ".auto";
	char *equations = malloc(size), *constants = malloc(size), *script = malloc(size);
	const struct cli_output more[] = {{"export", equations}, {"export", constants},
	                                  {"export", script}};
	enum hawser_status status;

	if (equations && constants && script) {
		snprintf(equations, size, "%s.f90", stem);
		snprintf(constants, size, "%.*sc.%s", folder, stem, stem + folder);
		snprintf(script, size, "%s.auto", stem);
		status = cli_outputs_check_with(&settings->common, more, 3, report);
	} else {
		status = hawser__no_memory(report, "rom");
	}
	free(equations);
	free(constants);
	free(script);
	return status;
}

static enum hawser_status check(const struct settings *settings, struct hawser_report *report)
{
	if (settings->export[0] && strcmp(settings->export[0], "auto") != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "--export %s: the formats are auto", settings->export[0]);
	if (settings->common.plot)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "rom has no picture; hawser modes --plot draws the shapes");
	return settings->export[0] ? check_export(settings, report)
	                           : cli_outputs_check(&settings->common, report);
}

/* Modes that are to be chosen, for the range of the export. */
static enum hawser_status choose(struct cli_model *model, const struct settings *settings,
                                 struct hawser_report *report)
{
	double from, to;
	enum hawser_status status = cli_frequency(&from, settings->from, "from", model, report);

	if (!status)
		status = cli_frequency(&to, settings->to, "to", model, report);
	return status ? status : cli_choice_build(model, from, to, report);
}

static enum hawser_status export(const struct settings *settings, const struct cli_model *model,
                                 struct hawser_report *report)
{
	struct hawser_auto_options choice = {.ntst = 0};
	enum hawser_status status = cli_frequency(&choice.from, settings->from, "from", model, report);

	if (!status)
		status = cli_frequency(&choice.to, settings->to, "to", model, report);
	if (status)
		return status;
	if (settings->tolerance > 0.0)
		choice.tolerance = settings->tolerance;
	if (settings->intervals > 0)
		choice.ntst = settings->intervals;
	if (settings->points > 0)
		choice.nmx = settings->points;
	status = hawser_rom_export_auto(&model->rom, settings->export[1], &choice, report);
	if (!status)
		cli_written(settings->export[1]);
	return status;
}

/* The reduced-model file, with what every result has besides. */
static enum hawser_status save(const struct settings *settings, const struct cli_model *model,
                               struct hawser_report *report)
{
	struct hawser__view view = cli_view(model, 0);
	struct hawser__json json;
	char *text;
	json_t *parts;
	enum hawser_status status = hawser_rom_text(&model->rom, &text, report);

	if (status)
		return status;
	cli_echo_json(&json, &settings->common, "rom", model->has_scene ? &model->scene : NULL);
	parts = json_loads(text, 0, NULL);
	if (!parts || json_object_update(json.root, parts))
		status = hawser__no_memory(report, "rom");
	json_decref(parts);
	free(text);
	hawser__fields_json(&json, json.root, cli_choice_field, model, &view);
	cli_stats_json(&json, &settings->common);
	if (!status)
		status = hawser__json_write(&json, settings->common.json, report);
	if (!status)
		cli_written(settings->common.json);
	hawser__json_clear(&json);
	return status;
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_common plain = settings->common;
	struct hawser__table table = {0};
	struct cli_model model = {0};
	enum hawser_status status = check(settings, report);

	if (!status)
		status = cli_model_load(&model, &settings->common, settings->n, report);
	if (!status && model.automatic)
		status = choose(&model, settings, report);
	if (status)
		goto done;
	fill_table(&table, settings, &model);
	status = hawser__table_check(&table, report);
	if (!status && settings->export[0])
		status = export(settings, &model, report);
	if (!status && plain.json)
		status = save(settings, &model, report);
	if (status || (plain.json && strcmp(plain.json, "-") == 0))
		goto done;
	if (!plain.tsv && (plain.json || settings->export[0])) {
		if (!plain.quiet)
			hawser__table_print_comments(&table, stdout);
		goto done;
	}
	plain.json = NULL;
	status = cli_deliver(&plain, &table, NULL, NULL, report);
done:
	hawser__table_clear(&table);
	cli_model_clear(&model);
	return status;
}

const struct cli_command cli_rom = {
	"rom", "SCENE|MODEL", "Reduced-order model: a file, or equations for AUTO-07p", notes, options,
	&defaults, sizeof(struct settings), 1, run, NULL,
};

/* cli/model/cmd_rom.c - hawser rom: the reduced-order model of a scene, as a file and for AUTO-07p.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/curves/frf_over.h"
#include "cli/frame/view.h"
#include "cli/model/made.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *export[2]; /* format, stem */
	const char *from, *to, *over;
	double tolerance;
	int n, intervals, points;
};
static const struct cli_option options[] = {
	{"modes", 'n', "N", "number of modes kept (the scene's model.modes)", CLI_INTEGER(n)},
	CLI_HEADING("Export"),
	{"export", 0, "FORMAT STEM", "write equations; FORMAT: auto, coco, matcont, bifurcationkit",
	 CLI_TWO(export)},
	{"from", 0, "FREQUENCY", "start of the range of the export, and of modes: auto (0.6w1)",
	 CLI_TEXT(from)},
	{"to", 0, "FREQUENCY", "end of that range (3.3w1)", CLI_TEXT(to)},
	{"over", 0, "KEY=FROM:TO", "equilibria and limit cycles over a parameter, to auto",
	 CLI_TEXT(over), .needs = "export", .excludes = "from, to"},
	{"tolerance", 0, "NUMBER", "EPSL and EPSU of the export, tolerances (1e-9)",
	 CLI_POSITIVE(tolerance)},
	{"intervals", 0, "N", "NTST of the export, number of mesh intervals (80)", CLI_COUNT(intervals)},
	{"max-points", 0, "N", "NMX of the export, most points (20000)", CLI_COUNT(points)},
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"--json writes the reduced-model file, which frf and integrate take in place of a scene.",
	"FREQUENCY: a number (rad/s), \"0.3 Hz\", or a multiple such as 0.6w1.",
	"Of a ropeway the model is that of one lane.",
	"With model.modes: auto the modes kept are chosen for forcing from --from to --to.",
	NULL,
};

struct result {
	const struct cli_common *common;
	const struct cli_model *model;
};

/* --- the table: nonzero entries of the tensors --- */

struct entry {
	const char *tensor;
	int j, k, l, m; /* HAWSER__NO_INTEGER: the tensor has fewer indices */
	double value;
};
#define OF(member) HAWSER__AT(struct entry, member)
static const struct hawser__field entry_field[] = {
	{NULL, "tensor", "K, D, Q, C, or f for the load", OF(tensor)},
	{NULL, "j", "equation, from 0", OF(j)},
	{NULL, "k", "index of the first coordinate, from 0; empty if there is none, as the following",
	 OF(k)},
	{NULL, "l", "index of the second", OF(l)},
	{NULL, "m", "index of the third", OF(m)},
	{NULL, "value", "coefficient of the monomial in equation j, scaled", OF(value)},
	HAWSER__END,
};
#undef OF

static size_t entries(const void *parent)
{
	const struct hawser_rom *rom = &((const struct result *)parent)->model->rom;
	size_t n = (size_t)rom->n;

	return 2*n*n + (size_t)rom->quads + (size_t)rom->cubics + (size_t)rom->harmonics*n;
}

/* The entry with that number among all of K, D, Q, C and f. */
static struct entry entry_at(const struct hawser_rom *rom, size_t i)
{
	enum { NONE = HAWSER__NO_INTEGER };
	size_t n = (size_t)rom->n, quads = (size_t)rom->quads, cubics = (size_t)rom->cubics;

	if (i < 2*n*n) {
		int first = i < n*n, j = (int)(i/n % n), k = (int)(i % n);
		const double *a = first ? rom->K : rom->D;

		return (struct entry){first ? "K" : "D", j, k, NONE, NONE, a ? a[i % (n*n)] : 0.0};
	}
	i -= 2*n*n;
	if (i < quads)
		return (struct entry){"Q", rom->Q[i].j, rom->Q[i].k, rom->Q[i].l, NONE, rom->Q[i].value};
	i -= quads;
	if (i < cubics)
		return (struct entry){"C", rom->C[i].j, rom->C[i].k, rom->C[i].l, rom->C[i].m,
		                      rom->C[i].value};
	i -= cubics;
	return (struct entry){"f", (int)(i % n), NONE, NONE, NONE,
	                      rom->harmonic[i/n].f ? rom->harmonic[i/n].f[i % n] : 0.0};
}

/* Zeros of the matrices and of the load are omitted; Q and C are stored without zeros. */
static const void *entry_row(void *to, const void *parent, size_t i)
{
	struct entry *entry = to;

	*entry = entry_at(&((const struct result *)parent)->model->rom, i);
	return entry->value != 0.0 || strchr("QC", *entry->tensor) ? to : NULL;
}
static const struct hawser__list entry_list = {
	.field = entry_field, .size = HAWSER__MADE_SIZE(struct entry), .count = entries,
	.row = entry_row};

const struct cli_listing cli_rom_listing[] = {
	{"Columns of the table:", entry_field, 0},
	{"Keys of JSON besides those of hawser-rom(5):", cli_choice_field, 1},
	{NULL, NULL, 0},
};

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return cli_model_head(result->common, "rom", result->model->rom.exact
	                      ? "exact strain energy on all functions of the basis: full order"
	                      : "energy expanded to fourth order, projected on the modes",
	                      result->model, 0);
}

/* Up to where the static law of a coordinate holds. */
static void range_comment(struct hawser__table *table, const struct hawser_rom *rom, int j)
{
	static const char *const beyond[] = {
		[HAWSER_RANGE_FORCE] = "beyond, its force, inertia or damping is off by more",
		[HAWSER_RANGE_AT_LEAST] = "not sought further",
		[HAWSER_RANGE_SLACK] = "the cable is slack beyond"};
	const struct hawser_rom_range *range = &rom->range[j];

	if (range->end != HAWSER_RANGE_UNKNOWN)
		hawser__table_comment(table, "range of u_%d (%s): %.3g m within %.0f %%; %s", j + 1,
		                      rom->label ? rom->label[j] : "mode", range->amplitude,
		                      100.0*HAWSER_LAW_LIMIT, beyond[range->end]);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_model *model = ((const struct result *)of)->model;
	const struct hawser_rom *rom = &model->rom;
	char forces[240];

	cli_choice_comments(table, model);
	for (int j = 0; rom->range && j < rom->n; j++)
		range_comment(table, rom, j);
	if (rom->exact)
		hawser__table_comment(table, "%d coordinates, %d harmonics; scaled; the restoring force "
		                             "is no polynomial, K is its linear part; model.modes "
		                             "and model.condense do not apply", rom->n,
		                      rom->harmonics);
	else
		hawser__table_comment(table, "%d coordinates, %d quadratic and %d cubic entries, "
		                             "%d harmonics; scaled", rom->n, rom->quads, rom->cubics,
		                      rom->harmonics);
	if (rom->terms > 0)
		hawser__table_comment(table, "%d terms besides, products of coordinates and velocities, which "
		                      "only the file has (--json)", rom->terms);
	hawser_rom_forces_text(rom, forces, sizeof forces);
	if (*forces)
		hawser__table_comment(table, "forces are evaluated %s", forces);
	if (rom->scaled)
		hawser__table_comment(table, "units: length %.12g m, time %.12g s, force %.12g N",
		                      rom->length, rom->time, rom->force);
	if (!rom->exact && rom->kernel)
		hawser__table_comment(table, "asymmetry of the derivatives of the energy: %.2e (relative)",
		                      hawser_rom_asymmetry(rom));
}

static int write_model(FILE *stream, const void *rom)
{
	return hawser_rom_write_members(rom, stream, NULL) != HAWSER_OK;
}

/* The reduced-model file, with the members common to all results. */
static void fill_json(struct hawser__json *json, const void *of)
{
	const struct result *result = of;
	struct cli_head shown = head(of);

	cli_echo_json(json, shown.common, shown.command, shown.scene);
	if (!json->status)
		json->status = hawser_rom_write_members(&result->model->rom, NULL, &json->report);
	if (json->status)
		return;
	hawser__json_members(json, write_model, &result->model->rom);
	hawser__fields_json(json, json->root, cli_choice_field, result->model, &shown.view);
	cli_stats_json(json, shown.common);
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .rows = &entry_list, .json = fill_json};

/* --- options --- */

/* Index of the format of --export; -1 if there is none of this name. */
static int format_of(const struct settings *settings)
{
	for (int k = 0; hawser_export_format(k); k++)
		if (strcmp(hawser_export_format(k)->name, settings->export[0]) == 0)
			return k;
	return -1;
}

/* Check the files that hawser_rom_export_auto writes like other outputs. */
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
	int k = format_of(settings);

	if (equations && constants && script && k > 0) {
		snprintf(equations, size, "%s%s", stem, hawser_export_format(k)->suffix);
		status = cli_outputs_check_with(&settings->common, more, 1, report);
	} else if (equations && constants && script) {
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
	if (settings->export[0] && format_of(settings) < 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "--export %s: the formats are auto, coco, matcont and bifurcationkit",
		                    settings->export[0]);
	/* NOLINTNEXTLINE(clang-analyzer-core.NonNullParamChecker): --over needs --export */
	if (settings->over && strcmp(settings->export[0], "auto") != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "--over goes with --export auto: the other formats have no equations over "
		                    "a parameter");
	if (settings->common.plot)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "rom has no picture; hawser modes --plot draws the shapes");
	return settings->export[0] ? check_export(settings, report)
	                           : cli_outputs_check(&settings->common, report);
}

/* With modes: auto the modes are chosen for the range of the export. */
static enum hawser_status choose(struct cli_model *model, const struct settings *settings,
                                 struct hawser_report *report)
{
	double from, to;
	enum hawser_status status = cli_range(&from, &to, settings->from, settings->to, "rom", model,
	                                      report);

	return status ? status : cli_choice_build(model, from, to, report);
}

/* Over the parameter, or over the frequency. */
static enum hawser_status export_auto(struct hawser_auto_options *choice,
                                      const struct settings *settings, struct cli_model *model,
                                      struct hawser_report *report)
{
	struct cli_over over = {.at = NAN};
	enum hawser_status status;

	if (!settings->over) {
		status = cli_range(&choice->from, &choice->to, settings->from, settings->to, "rom", model,
		                   report);
		return status ? status : hawser_rom_export_auto(&model->rom, settings->export[1], choice,
		                                                report);
	}
	status = cli_over_open(&over, settings->over, NULL, model, report);
	choice->from = over.from;
	choice->to = over.to;
	if (!status)
		status = hawser_family_export_auto(&over.family, over.axis.key, over.from, NULL,
		                                   settings->export[1], choice, report);
	cli_over_clear(&over);
	return status;
}

static enum hawser_status export(const struct settings *settings, struct cli_model *model,
                                 struct hawser_report *report)
{
	struct hawser_auto_options choice = {.ntst = 0};
	enum hawser_status status;

	if (format_of(settings) > 0) {
		status = hawser_rom_export(&model->rom, settings->export[0], settings->export[1], report);
		if (!status)
			cli_written(settings->export[1]);
		return status;
	}
	if (settings->tolerance > 0.0)
		choice.tolerance = settings->tolerance;
	if (settings->intervals > 0)
		choice.ntst = settings->intervals;
	if (settings->points > 0)
		choice.nmx = settings->points;
	status = export_auto(&choice, settings, model, report);
	if (!status)
		cli_written(settings->export[1]);
	return status;
}

/* The ranges of a model of a scene. */
static enum hawser_status judge(struct cli_model *model, struct hawser_report *report)
{
	struct hawser_rom *rom = &model->rom;

	if (!model->has_scene || rom->exact || rom->n - rom->inertia.shapes > CLI_JUDGED)
		return HAWSER_OK;
	return hawser_law_range(rom, &model->statics, NULL, report);
}

/* The forces of a model of many modes of which only the file is wanted are not needed: without a table
 * or comments, which tell the asymmetry, and without an export, which contains a computed orbit. */
static enum hawser_status load(struct cli_model *model, const struct settings *settings,
                               struct hawser_report *report)
{
	const struct cli_common *common = &settings->common;

	return common->json && common->quiet && !common->tsv && !settings->export[0]
	       ? cli_model_entries(model, common, settings->n, report)
	       : cli_over_load(model, common, settings->n, settings->over, report);
}

static enum hawser_status run(void *context, struct hawser_report *report)
{
	struct settings *settings = context;
	struct cli_model model = {0};
	const struct result result = {&settings->common, &model};
	enum hawser_status status = check(settings, report);

	if (!status)
		status = load(&model, settings, report);
	if (!status && model.automatic)
		status = choose(&model, settings, report);
	if (!status)
		status = judge(&model, report);
	if (!status && settings->export[0])
		status = export(settings, &model, report);
	settings->common.delivered = settings->export[0] != NULL;
	if (!status && model.has_scene && model.rom.drag)
		cli_warn(model.scene.wind.present
		         ? "the force of the wind is no part of these entries with wind.form: exact: hawser "
		           "integrate and hawser frf compute it from the scene"
		         : "damping.drag is no part of these entries: hawser integrate and hawser frf compute "
		           "its force from the scene");
	if (!status && settings->common.json && model.rom.plug) /* refused before anything is said */
		status = hawser_rom_write_members(&model.rom, NULL, report);
	if (!status && model.made && model.rom.plug)
		cli_warn("the force of the water is no part of these entries, but for its damping and loads at "
		         "rest: hawser frf and hawser integrate -n compute it from the scene");
	if (!status)
		cli_made_warn(&model);
	if (!status)
		status = cli_show(&settings->common, &showing, &result, report);
	cli_model_clear(&model);
	return status;
}

const struct cli_command cli_rom = {
	"rom", "SCENE|MODEL", "Reduced-order model: a file, or equations for other programs", notes,
	options,
	NULL, sizeof(struct settings), 1, run, cli_rom_listing,
	.takes = CLI_MODELS,
};

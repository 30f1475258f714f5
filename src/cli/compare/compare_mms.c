/* cli/compare/compare_mms.c - hawser compare mms: the approximation by multiple scales against the
 * response of the model, at decreasing load and damping.
 *
 *   e        1, 1/2, 1/4 ...: the scale of a level. With one resonant mode (or 1:1, 1:3) damping is
 *            scaled by e^2 and load by e^3, so that the amplitude is proportional to e and all terms
 *            of the approximation keep their ratios. With a mode at twice the frequency: e and e^2
 *
 * The terms that multiple scales neglect are of a higher order in e. The distances of folds and
 * peaks between the two curves show this order.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/backbone/mms_result.h"
#include "cli/frame/progress.h"
#include "cli/frame/view.h"
#include "core/report.h"

enum { LEVELS = 10 };

struct settings {
	struct cli_common common;
	const char *from, *to, *resonant;
	double tolerance, step;
	int n, mode, levels;
};
static const struct settings defaults = {.step = 0.001, .levels = 4, .tolerance = 1e-11};

static const struct cli_option options[] = {
	{"mode", 0, "J", "resonant mode (the one that the load drives the most)", CLI_INTEGER(mode)},
	CLI_TEXT_OPTION(resonant, "LIST", "several resonant modes, as mode:order: 1:1,4:2"),
	CLI_RANGE_OPTIONS("one end of the range at full load", "the other end"),
	CLI_MODES_OPTION,
	{"levels", 0, "N", "number of load levels, full load included (4)", CLI_COUNT(levels),
	 .most = LEVELS},
	CLI_TOLERANCE_OPTION("tolerance of both curves, relative to the orbit (1e-11)"),
	{"step", 0, "NUMBER", "longest step, as a part of the range (0.001)", CLI_POSITIVE(step)},
	CLI_LANE_LOAD_OPTION,
	CLI_LANE_OPTIONS,
	CLI_NO_OPTION,
};

static const char *const notes[] = {
	"Follows the model's response and that of multiple scales (one mode: in closed form) at falling",
	"load and damping, and tabulates the distances of folds and peak, with the slope of their fall.",
	NULL,
};

struct level {
	double e;
	struct cli_mms_marks scales, model;
};

struct result {
	const struct cli_common *common;
	struct cli_model *model;
	struct hawser_resonance resonance;
	int mode, powers[2]; /* powers of e by which damping and load are scaled */
	double from, to;     /* scaled, at full load */
	int levels;
	struct level level[LEVELS];
	struct hawser_frf frf;          /* full load: response of the model */
	struct hawser_frf scales;       /* full load: multiple scales */
};

/* --- both curves at a level --- */

static void scale_model(struct hawser_rom *rom, double damping, double load)
{
	for (int e = 0; e < rom->n*rom->n; e++)
		rom->D[e] *= damping;
	for (int i = 0; i < rom->harmonics; i++) {
		struct hawser_harmonic *harmonic = &rom->harmonic[i];

		for (int j = 0; harmonic->f && j < rom->n; j++)
			harmonic->f[j] *= load;
		for (int e = 0; harmonic->K && e < rom->n*rom->n; e++)
			harmonic->K[e] *= load;
		for (int e = 0; harmonic->D && e < rom->n*rom->n; e++)
			harmonic->D[e] *= load;
		for (int e = 0; harmonic->answer && e < 2*4*rom->shapes.points; e++)
			harmonic->answer[e] *= load;
		for (int e = 0; harmonic->answer_line && e < 2*rom->line.points; e++)
			harmonic->answer_line[e] *= load;
	}
}

static enum hawser_status trace(struct hawser_frf *frf, const struct result *result,
                                const char *method,
                                const struct settings *settings, double narrow,
                                struct hawser_report *report)
{
	struct hawser_frf_options choice = {.method = NULL};
	double centre = result->resonance.omega0;

	choice.from = centre + (result->from - centre)*narrow;
	choice.to = centre + (result->to - centre)*narrow;
	choice.method = method;
	choice.resonance = &result->resonance;
	choice.tolerance = settings->tolerance;
	choice.event_tolerance = 1e-13;
	choice.step_max = settings->step;
	choice.samples = HAWSER_NONE;
	choice.progress.function = cli_watch_silently;
	return hawser_frf_trace(frf, &result->model->rom, &choice, report);
}

/* One mode: the closed form. Its curve is sampled closely, to locate the peak of the displacement. */
static enum hawser_status closed_form(struct hawser_frf *frf, struct cli_mms_marks *marks,
                                      const struct result *result, double narrow,
                                      struct hawser_report *report)
{
	struct hawser_primary primary = {0};
	struct hawser_primary_curve curve = {.amplitude = NULL};
	double centre = result->resonance.omega0;
	enum hawser_status status = hawser_primary_derive(&primary, &result->model->rom, result->mode,
	                                                  report);

	if (!status)
		status = hawser_primary_trace(&curve, &primary, centre + (result->from - centre)*narrow,
		                              centre + (result->to - centre)*narrow, 1001, report);
	if (!status) {
		cli_mms_marks(marks, &curve.frf, result->mode);
		for (int k = 0; k < primary.folds && k < marks->folds; k++)
			marks->omega[k] = primary.fold_omega[k];
		*frf = curve.frf;
		curve.frf = (struct hawser_frf){.n = 0};
	}
	hawser_primary_curve_clear(&curve);
	hawser_primary_clear(&primary);
	return status;
}

static enum hawser_status one_level(struct result *result, int k, const struct settings *settings,
                                    struct hawser_report *report)
{
	struct level *level = &result->level[k];
	double e = ldexp(1.0, -k), narrow = pow(e, result->powers[0]);
	struct hawser_frf frf = {0}, scales = {0};
	enum hawser_status status;

	level->e = e;
	status = trace(&frf, result, NULL, settings, narrow, report);
	if (!status)
		cli_mms_marks(&level->model, &frf, result->mode);
	if (!status && settings->resonant) {
		status = trace(&scales, result, "multiple-scales", settings, narrow, report);
		if (!status)
			cli_mms_marks(&level->scales, &scales, result->mode);
	} else if (!status) {
		status = closed_form(&scales, &level->scales, result, narrow, report);
	}
	if (!status && k == 0) {
		result->frf = frf;
		result->scales = scales;
		return status;
	}
	hawser_frf_clear(&frf);
	hawser_frf_clear(&scales);
	return status;
}

/* --- results --- */

/* Distance between the two curves of a fold or of the peak (fold -1) at a level; NAN if one of them
 * does not have it. */
static double gap(const struct result *result, int k, int fold)
{
	const struct level *level = &result->level[k];

	if (k < 0)
		return NAN;
	if (fold < 0)
		return fabs(level->scales.peak_omega - level->model.peak_omega);
	if (level->scales.folds <= fold || level->model.folds <= fold)
		return NAN;
	return fabs(level->scales.omega[fold] - level->model.omega[fold]);
}

static double size_gap(const struct result *result, int k, int fold)
{
	const struct level *level = &result->level[k];

	/* near a fold the amplitude changes fast, so that only the frequencies are compared */
	return isnan(gap(result, k, fold)) || fold >= 0 ?
	        NAN : level->scales.peak/level->model.peak - 1.0;
}

static double slope(double before, double now)
{
	return log2(fabs(before)/fabs(now));
}

static int most_folds(const struct result *result)
{
	int most = 0;

	for (int k = 0; k < result->levels; k++)
		most = most > result->level[k].scales.folds ? most : result->level[k].scales.folds;
	return most;
}

/* A fold or the peak at a level; NAN: not present. */
struct mark {
	double e, omega_mms, omega_model, distance, slope, a_mms, a_model, a_error, a_slope;
	const char *mark;
};
#define OF(member) HAWSER__AT(struct mark, member)
#define MAYBE(member) OF(member), .flags = HAWSER__NULL | HAWSER__INFINITE | HAWSER__BARE
static const struct hawser__field mark_field[] = {
	{"e", "e", "by which load and damping are scaled", OF(e)},
	{"mark", "mark", "peak or fold", OF(mark)},
	{"Omega_mms", "Omega_mms", "frequency by multiple scales",
	 MAYBE(omega_mms), .unit = HAWSER__RAD_S},
	{"Omega_model", "Omega_model", "frequency of the model",
	 MAYBE(omega_model), .unit = HAWSER__RAD_S},
	{NULL, "Omega_distance", "distance of the two frequencies",
	 MAYBE(distance), .unit = HAWSER__RAD_S},
	{"slope", "slope", "order in e to which the distance falls", MAYBE(slope)},
	{"a_mms", "a_mms", "amplitude by multiple scales", MAYBE(a_mms), .unit = HAWSER__M},
	{"a_model", "a_model", "amplitude of the model", MAYBE(a_model), .unit = HAWSER__M},
	{NULL, "a_error", "of the peak, relative", MAYBE(a_error)},
	{"a_slope", "a_slope", "order in e to which this falls", MAYBE(a_slope)},
	HAWSER__END,
};
#undef MAYBE
#undef OF

static struct mark mark_of(const struct result *result, int k, int fold)
{
	const struct cli_mms_marks *mms = &result->level[k].scales, *model = &result->level[k].model;
	double e = result->level[k].e;

	if (fold < 0)
		return (struct mark){
			.e = e, .mark = "peak", .omega_mms = mms->peak_omega, .omega_model = model->peak_omega,
			.a_mms = mms->peak, .a_model = model->peak};
	return (struct mark){
		.e = e, .mark = "fold", .omega_mms = fold < mms->folds ? mms->omega[fold] : NAN,
		.omega_model = fold < model->folds ? model->omega[fold] : NAN,
		.a_mms = fold < mms->folds ? mms->a[fold] : NAN,
		.a_model = fold < model->folds ? model->a[fold] : NAN};
}

/* All folds and the peak, in the order of the table: by fold (-1: the peak), then by level. */
HAWSER__OF(marks, size_t, struct result, (size_t)((most_folds(of) + 1)*of->levels))

static const void *mark_row(void *to, const void *parent, size_t index)
{
	const struct result *result = parent;
	int fold = (int)index/result->levels - 1, k = (int)index % result->levels;
	struct mark *row = to;

	*row = mark_of(result, k, fold);
	row->distance = gap(result, k, fold);
	row->slope = k ? slope(gap(result, k - 1, fold), gap(result, k, fold)) : NAN;
	row->a_error = size_gap(result, k, fold);
	row->a_slope = k ? slope(size_gap(result, k - 1, fold), size_gap(result, k, fold)) : NAN;
	return row;
}

/* The folds and peaks that both curves have. */
static const void *common_row(void *row, const void *parent, size_t index)
{
	mark_row(row, parent, index);
	return isnan(((const struct mark *)row)->distance) ? NULL : row;
}
static const struct hawser__list
	mark_list = {.field = mark_field, .size = HAWSER__MADE_SIZE(struct mark), .count = marks,
	.row = mark_row},
	common_list = {.field = mark_field, .size = HAWSER__MADE_SIZE(struct mark), .count = marks,
	               .row = common_row};

static const struct hawser__field result_field[] = {
	{"mode", NULL, "the resonant mode, from 1", HAWSER__AT(struct result, mode),
	 .flags = HAWSER__FROM_1},
	{"damping_power", NULL, "of e, by which damping is scaled",
	 HAWSER__AT(struct result, powers[0])},
	{"load_power", NULL, "of e, by which load is scaled", HAWSER__AT(struct result, powers[1])},
	{"marks", NULL, "that both curves have", HAWSER__OBJECTS_OF(common_list)},
	HAWSER__END,
};

const struct cli_listing cli_compare_mms_listing[] = {
	{"Columns of the table:", mark_field, 0},
	{"Keys of JSON:", result_field, 1},
	{NULL, NULL, 0},
};

/* "2.17e-01, 2.46e-02, 1.99e-03", by level; `-` if one of the curves does not have the fold or
 * peak. */
static void list(char *text, size_t size, const struct result *result, int fold, double unit,
                 double (*of)(const struct result *result, int k, int fold))
{
	size_t used = 0;

	*text = '\0';
	for (int k = 0; k < result->levels && used < size; k++) {
		double number = unit*of(result, k, fold);
		const char *comma = k > 0 ? ", " : "";

		used += (size_t)(isfinite(number) ? snprintf(text + used, size - used, "%s%.2e", comma,
		                                             fabs(number))
		                                  : snprintf(text + used, size - used, "%s-", comma));
	}
}

/* A summary of the errors; it is printed alone if the table is written to a file. */
static void errors(struct hawser__table *table, const struct result *result)
{
	char text[16*LEVELS], name[24] = "peak";

	list(text, sizeof text, result, -1, 1.0, size_gap);
	hawser__table_comment(table, "relative error of a at the peak, from level to level: %s", text);
	for (int fold = -1; fold < most_folds(result); fold++) {
		if (fold >= 0)
			snprintf(name, sizeof name, "fold %d", fold + 1);
		list(text, sizeof text, result, fold, cli_per_omega(result->model), gap);
		hawser__table_comment(table, "distance of Omega, %s: %s", name, text);
	}
}

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return cli_model_head(result->common, "compare mms",
	                      "multiple scales against continuation of the same model",
	                      result->model, 0);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;

	hawser__table_comment(table, "damping times e^%d, load times e^%d; a is the largest |u_%d|",
	                      result->powers[0], result->powers[1], result->mode + 1);
	if (result->model->rom.scaled)
		hawser__table_comment(table, "Omega in %s, a in %s", hawser__shown_unit("rad/s").name,
		                      hawser__shown_unit("m").name);
	errors(table, result);
}

static enum hawser_status draw(const char *path, const void *context, struct hawser_report *report)
{
	const struct result *result = context;
	double *omega = malloc(((size_t)result->scales.points + 1)*sizeof *omega);
	struct cli_overlay overlay = {"multiple scales", result->scales.points, omega,
	                              result->scales.probe,
	                              result->scales.coordinate, 0};
	const struct cli_frf_result drawn = {.common = result->common, .model = result->model,
		.frf = &result->frf, .overlay = &overlay, .overlays = 1, .from = result->from,
		.to = result->to, .scale = "linear"};
	enum hawser_status status;

	if (!omega)
		return hawser__no_memory(report, "compare mms");
	for (int i = 0; i < result->scales.points; i++)
		omega[i] = result->scales.point[i].omega;
	status = cli_frf_draw(path, &drawn, report);
	free(omega);
	return status;
}

/* --- what was asked for --- */

static enum hawser_status choose(struct result *result, const struct settings *settings,
                                 struct hawser_report *report)
{
	const struct hawser_rom *rom = &result->model->rom;
	struct hawser_primary primary = {0};
	struct cli_mms_range range = {.half = 0.1};
	int base;
	enum hawser_status status = HAWSER_OK;

	if (settings->resonant) {
		status = cli_mms_read(&result->resonance, &base, settings->resonant, rom, report);
		if (!status && base > 1)
			status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare mms",
			                      "--resonant %s: motions of several periods of the load are not "
			                      "compared: write whole orders", settings->resonant);
		for (int r = status ? 0 : result->resonance.count - 1; r >= 0; r--)
			if (result->resonance.order[r] == 1)
				result->mode = result->resonance.mode[r];
		range.half *= result->resonance.omega0;
	} else {
		status = cli_mms_mode(&result->mode, settings->mode, rom, report);
		if (!status)
			status = hawser_primary_derive(&primary, rom, result->mode, report);
		result->mode = primary.mode;
		result->resonance = (struct hawser_resonance){.count = 1, .mode = {primary.mode}, .order =
		                                              {1},
		                                              .omega0 = primary.omega};
		range.half = 2.0*fabs(primary.peak_omega - primary.omega) + 15.0*primary.damping;
	}
	hawser_primary_clear(&primary);
	result->powers[0] = 2;
	result->powers[1] = 3;
	for (int r = 0; r < result->resonance.count; r++)
		if (result->resonance.order[r] == 2) {
			result->powers[0] = 1;
			result->powers[1] = 2;
		}
	range.centre = result->resonance.omega0;
	range.from = settings->from;
	range.to = settings->to;
	return status ? status : cli_mms_range(&result->from, &result->to, &range, result->model,
	                                       report);
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .rows = &mark_list, .fields = result_field, .draw = draw};

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	struct cli_model model = {0};
	struct result *result = calloc(1, sizeof *result);
	enum hawser_status status = result ? cli_outputs_check(&settings->common, report)
	                                   : hawser__no_memory(report, "compare mms");

	if (!status)
		status = cli_model_load(&model, &settings->common, settings->n, report);
	if (!status && model.automatic)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "compare mms",
		                      "model.modes: auto chooses by the load, which changes here: give a "
		                      "number of modes (--modes)");
	if (status)
		goto done;
	result->common = &settings->common;
	result->model = &model;
	status = choose(result, settings, report);
	for (int k = 0; k < settings->levels && !status && !cli_interrupted(); k++) {
		const double e = 0.5;

		if (k > 0)
			scale_model(&model.rom, pow(e, result->powers[0]), pow(e, result->powers[1]));
		cli_progress_note(settings->common.quiet, "load and damping, level %d of %d", k + 1,
		                  settings->levels);
		status = one_level(result, k, settings, report);
		result->levels += !status;
	}
	if (!status && result->levels > 0)
		status = cli_show(&settings->common, &showing, result, report);
	hawser_frf_clear(&result->frf);
	hawser_frf_clear(&result->scales);
done:
	cli_model_clear(&model);
	free(result);
	return status;
}

const struct cli_command cli_compare_mms = {
	"compare mms", "SCENE|MODEL", "Multiple scales against the model's response, at falling load",
	        notes,
	options, &defaults, sizeof(struct settings), 1, run, cli_compare_mms_listing,
	.takes = CLI_FORCED | CLI_MODELS,
};

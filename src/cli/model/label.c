/* cli/model/label.c - see label.h.
 *
 * A label is of one model. A result over Omega has the model of the scene; one over a key has another
 * at each point, which is the scene's where the scene has that value of the key. The first orbit of the
 * new curve must be that of the label again: this also refuses a model with other modes or signs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/model/label.h"
#include "cli/model/state.h"
#include "cli/frame/view.h"
#include "core/report.h"

#define SAME 1e-9  /* relative, of values of a key and of Omega */
#define OFF 0.01   /* largest distance of the first orbit from that of the label, relative; chosen */
#define ASIDE 1e-5 /* distance of the first orbit from a fold, relative; chosen */

void cli_label_all(struct cli_frf_result *result)
{
	int every = result->label_every > 0 ? result->label_every : HAWSER_NONE;
	int next = hawser_frf_label((void *)result->frf, 1, every);

	for (int k = 0; k < result->others; k++)
		next = hawser_frf_label((void *)result->other[k].frf, next, every);
}

int cli_label_plain(const struct hawser_frf *frf, const struct cli_model *model)
{
	return frf->period <= 1 || frf->period == model->rom.periods;
}

int cli_label_split(char *path, size_t size, const char *text)
{
	const char *mark = strrchr(text, '#');
	char *end;
	long number = mark ? strtol(mark + 1, &end, 10) : 0;

	if (!mark || mark == text || *end || end == mark + 1 || number < 1 || number > 1000000000)
		return 0;
	snprintf(path, size, "%.*s", (int)(mark - text), text);
	return (int)number;
}

/* --- find it --- */

/* Of a result or one of its branches: the point or event with this label, or NULL. */
static json_t *find_in(const json_t *branch, int label, int *most)
{
	static const char *const list[] = {"points", "events"};
	json_t *found = NULL, *row;
	size_t i;

	for (int k = 0; k < 2; k++)
		json_array_foreach(json_object_get(branch, list[k]), i, row) {
			json_int_t its = json_integer_value(json_object_get(row, "label"));

			if (its > *most)
				*most = (int)its;
			if (its == label)
				found = row;
		}
	return found;
}

/* *branch: that of the label. */
static json_t *find(const json_t *root, const json_t **branch, int label, int *most)
{
	json_t *found = find_in(root, label, most), *other, *one, *points;
	size_t i;

	*branch = root;
	if (label == CLI_LABEL_LAST) {
		points = json_object_get(root, "points");
		return json_array_get(points, json_array_size(points) - 1);
	}
	json_array_foreach(json_object_get(root, "branches"), i, other) {
		one = find_in(other, label, most);
		if (one) {
			found = one;
			*branch = other;
		}
	}
	return found;
}

static double number(const json_t *object, const char *key)
{
	const json_t *value = json_object_get(object, key);

	return json_is_number(value) ? json_number_value(value) : NAN;
}

static void text_of(char *to, size_t size, const json_t *object, const char *key)
{
	const char *text = json_string_value(json_object_get(object, key));

	snprintf(to, size, "%s", text ? text : "");
}

static enum hawser_status read_label(struct cli_label *label, const json_t *root, const char *option,
                                     const char *text, const struct cli_model *model,
                                     struct hawser_report *report)
{
	const json_t *over = json_object_get(root, "over"), *branch, *row, *tension;
	int most = 0, n = model->rom.n;

	row = find(root, &branch, label->number, &most);
	if (!row && (most == 0 || label->number == CLI_LABEL_LAST))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
		                    "--%s %s: that is no result of hawser frf with labels, as --json writes it",
		                    option, text);
	if (!row)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
		                    "--%s %s: that result has the labels 1 to %d", option, text, most);
	text_of(label->kind, sizeof label->kind, row, "kind");
	text_of(label->over, sizeof label->over, over, "key");
	if (!json_object_get(row, "state"))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
		                    "--%s %s: this %s has no motion: take a label beside it", option, text,
		                    *label->kind ? label->kind : "point");
	if (!cli_state_take(label->state, json_object_get(row, "state"), model))
		return cli_state_refuse(report, text, n, "its state is not one of this model");
	label->omega = number(row, "Omega")/cli_per_omega(model);
	label->parameter = number(row, "parameter");
	label->anchor = number(over, "from");
	tension = json_object_get(row, "tension");
	label->least = strcmp(label->kind, "slack") == 0 ? 0.0 : number(tension, "min");
	label->period = json_is_integer(json_object_get(branch, "period"))
	                ? (int)json_integer_value(json_object_get(branch, "period")) : 1;
	if (!(label->omega > 0.0 || (label->omega == 0.0 && hawser_rom_autonomous(&model->rom))) ||
	    label->period < 1 || (*label->over && !isfinite(label->parameter)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
		                    "--%s %s: that result is damaged: this label has no frequency, period or "
		                    "parameter", option, text);
	return HAWSER_OK;
}

/* --- the same model? --- */

/* The present value of a key of --over; NAN: not known. */
static double present(const char *key, const struct cli_model *model)
{
	double value = NAN;

	if (!cli_over_needs_scene(key))
		return 1.0;
	for (int i = 0; i < model->source.parameters; i++)
		if (strcmp(model->source.parameter[i].name, key) == 0)
			return model->source.parameter[i].value;
	if (!model->has_scene || hawser_scene_get(&model->scene, &value, key, NULL))
		return NAN;
	return value;
}

double cli_label_at(const struct cli_label *label, const char *key, const struct cli_model *model)
{
	return strcmp(key, "Omega") == 0 ? label->omega*cli_per_omega(model)
	       : strcmp(key, label->over) == 0 ? label->parameter : present(key, model);
}

static int same(double a, double b)
{
	return fabs(a - b) <= SAME*fmax(fabs(a), fabs(b));
}

/* The first parameter of a model file or library that has another value in the result; NULL: none.
 * `but` and `or` (or NULL) are followed and not compared. */
static const char *other_parameter(const json_t *root, const struct hawser_rom_source *source,
                                   const char *but, const char *or)
{
	const json_t *object = json_object_get(root, "parameters");

	for (int i = 0; i < source->parameters; i++) {
		const struct hawser_parameter *one = &source->parameter[i];
		double then = number(object, one->name);

		if ((but && strcmp(but, one->name) == 0) || (or && strcmp(or, one->name) == 0))
			continue;
		if (!isnan(then) && !same(then, one->value))
			return one->name;
	}
	return NULL;
}

static enum hawser_status check(const struct cli_label *label, const json_t *root, const char *option,
                                const char *text, const char *over, const struct cli_model *model,
                                const struct cli_common *common, struct hawser_report *report)
{
	struct hawser__view view = cli_view(model, ~0u);
	struct cli_model then = *model;
	enum hawser_status status = HAWSER_OK;
	const char *found, *but = *label->over ? label->over : over, *other;
	char name[128];

	other = other_parameter(root, &model->source, over, label->over);
	if (*label->over && !(over && strcmp(over, label->over) == 0)) {
		if (!same(present(label->over, model), label->parameter))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
			                    "--%s %s: that is a motion at %s = %.17g: %s%s", option, text,
			                    label->over, label->parameter, cli_over_needs_scene(label->over)
			                    ? "add --set with this value, or follow it with --over "
			                    : "follow it with --over ", label->over);
	}
	then.natural = malloc(((size_t)model->naturals + 1)*sizeof *then.natural);
	if (!then.natural)
		return hawser__no_memory(report, "label");
	memcpy(then.natural, model->natural, (size_t)model->naturals*sizeof *then.natural);
	hawser__fields_read(&then, cli_naturals_field, root, &view);
	found = cli_last_difference(name, sizeof name, root,
	                            but && cli_over_needs_scene(but) ? but : NULL, model, &then, common,
	                            &status);
	free(then.natural);
	if (status)
		return hawser__no_memory(report, "label");
	found = found ? found : other;
	return !found ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
	                      "--%s %s: that is a result of another %s, with another value of %s", option,
	                      text, model->has_scene ? "scene" : "model", found);
}

/* A curve that can be continued: over the same key, and not complete. */
static enum hawser_status check_last(struct cli_label *label, const json_t *root, const char *text,
                                     const char *over, struct hawser_report *report)
{
	static const enum hawser_frf_end cut[] = {HAWSER_END_MAX_POINTS, HAWSER_END_INTERRUPTED,
		HAWSER_END_FAILED, HAWSER_END_WORK, HAWSER_END_LOST, HAWSER_END_UNSTABLE};
	char end[64];
	int goes_on = 0;

	text_of(end, sizeof end, root, "end");
	label->direction = number(root, "direction") < 0.0 ? -1 : 1;
	for (size_t i = 0; i < sizeof cut/sizeof *cut; i++)
		goes_on |= strcmp(end, hawser_frf_end_name(cut[i])) == 0;
	if (!over || strcmp(over, label->over) != 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
		                    "--continue %s: that curve is over %s: continue it over the same key", text,
		                    *label->over ? label->over : "Omega");
	return goes_on ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
	                      "--continue %s: that curve is complete (%s): begin another one", text, end);
}

enum hawser_status cli_label_open(struct cli_label *label, const char *option, const char *text,
                                  const char *over, const struct cli_model *model,
                                  const struct cli_common *common, struct hawser_report *report)
{
	char path[4096];
	json_t *root = NULL;
	enum hawser_status status;

	*label = (struct cli_label){.number = cli_label_split(path, sizeof path, text),
		.option = option};
	if (strcmp(option, "continue") == 0) {
		snprintf(path, sizeof path, "%s", text);
		label->number = CLI_LABEL_LAST;
	}
	if (label->number == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
		                    "--%s %s: write FILE#LABEL, with a label of that result", option, text);
	if (model->automatic)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
		                    "--%s %s: a state has as many coordinates as the model, and "
		                    "model.modes: auto makes several; give a number of modes", option, text);
	status = cli_state_root(&root, path, report);
	label->state = calloc(2*(size_t)model->rom.n, sizeof *label->state);
	if (!status && !label->state)
		status = hawser__no_memory(report, "label");
	if (!status)
		status = read_label(label, root, option, text, model, report);
	if (!status && label->number == CLI_LABEL_LAST)
		status = check_last(label, root, text, over, report);
	if (!status)
		status = check(label, root, option, text, over, model, common, report);
	json_decref(root);
	return status;
}

enum hawser_status cli_label_scene(char *scene, size_t size, int *modes, json_t **result,
                                   const char *text, struct hawser_report *report)
{
	char path[4096];
	int number = cli_label_split(path, sizeof path, text);
	const json_t *of, *count;
	json_t *root = NULL;
	FILE *file;
	enum hawser_status status = cli_state_root(&root, path, report);

	if (status)
		return status;
	of = json_object_get(root, "scene");
	text_of(scene, size, of, json_object_get(of, "name") ? "name" : "model_file");
	count = json_object_get(json_object_get(of, "model"), "modes");
	*modes = json_is_integer(count) ? (int)json_integer_value(count) : 0;
	*result = root;
	file = *scene ? fopen(scene, "r") : NULL;
	if (file)
		fclose(file);
	return file ? HAWSER_OK
	            : hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
	                           "%s names %s%s: write SCENE --from-label %s#%d, with the scene or "
	                           "model file of that result", path,
	                           *scene ? "a scene or model that is not found here, " : "no scene",
	                           scene, path, number);
}

int cli_label_value(char *set, size_t size, const json_t *result, const char *text)
{
	char path[4096], key[96];
	const json_t *branch, *row;
	int most = 0;

	row = find(result, &branch, cli_label_split(path, sizeof path, text), &most);
	text_of(key, sizeof key, json_object_get(result, "over"), "key");
	if (!row || !*key || !cli_over_needs_scene(key) || !isfinite(number(row, "parameter")))
		return 0;
	snprintf(set, size, "%s=%.17g", key, number(row, "parameter"));
	return 1;
}

void cli_label_clear(struct cli_label *label)
{
	free(label->state);
	label->state = NULL;
}

/* --- begin there --- */

static enum hawser_status refuse(const struct cli_label *label, const char *text, const char *why,
                                 struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "label", "--%s %s: %s", label->option, text, why);
}

enum hawser_status cli_label_begin(struct hawser_frf_options *choice, double *along,
                                   const struct cli_label *label, const struct cli_over *over,
                                   const struct cli_model *model, const char *text,
                                   struct hawser_report *report)
{
	int fold = strcmp(label->kind, "fold") == 0, up = choice->to > choice->from;
	int own = over && hawser_rom_autonomous(&model->rom);

	if (strcmp(label->kind, "branch-point") == 0)
		return refuse(label, text, "at a branch point two curves cross: take a label beside it, or "
		              "follow both with --branches", report);
	if (choice->end_at_slack && label->least <= 0.0)
		return refuse(label, text, "there the cable is slack: take a label before, or --slack follow",
		              report);
	if (over && fold)
		return refuse(label, text, "at a fold the motion can't be followed in another parameter: take "
		              "a label beside it", report);
	choice->start = label->state;
	choice->direction = label->direction;
	if (own && strcmp(label->kind, "hopf") != 0) /* there it is the equilibrium */
		choice->omega = label->omega;
	choice->begin = !over ? label->omega : strcmp(over->axis.key, label->over) == 0 ? label->parameter
	                : present(over->axis.key, model);
	if (!(choice->begin >= fmin(choice->from, choice->to) &&
	      choice->begin <= fmax(choice->from, choice->to)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
		                    "--%s %s: that motion is at %s = %.9g, which is not in the range: give a "
		                    "range that has it", label->option, text, over ? over->axis.key : "Omega",
		                    choice->begin*(over ? 1.0 : cli_per_omega(model)));
	if (own && choice->begin == 0.0) /* which would be the end of the range */
		choice->begin = DBL_MIN;
	for (int i = 0; fold && i < 2*model->rom.n; i++)
		along[i] = (up ? ASIDE : -ASIDE)*label->state[i];
	choice->along = fold ? along : NULL;
	return HAWSER_OK;
}

enum hawser_status cli_label_kept(const struct cli_label *label, const struct hawser_frf *frf,
                                  const char *text, struct hawser_report *report)
{
	double off = 0.0, size = 0.0;

	if (frf->points < 1 || strcmp(frf->method, "multiple-scales") == 0)
		return HAWSER_OK;
	for (int i = 0; i < 2*frf->n; i++) {
		double weight = i < frf->n || label->omega == 0.0 ? 1.0 : 1.0/label->omega;

		off += pow(weight*(frf->state[i] - label->state[i]), 2.0);
		size += pow(weight*label->state[i], 2.0);
	}
	if (sqrt(off) <= OFF*sqrt(size))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "label",
	                    "--%s %s: this model has no such motion; the nearest is off by %.2g of its "
	                    "size: its modes may have another order or sign", label->option, text,
	                    sqrt(off)/fmax(sqrt(size), 1e-300));
}

/* Functions a component of the full-order model of a JSON result; 0: none, or no such file. */
static int functions_of(const char *path)
{
	json_t *root = NULL;
	const json_t *keys, *energy;
	int functions = 0;

	if (cli_state_root(&root, path, NULL))
		return 0;
	keys = json_object_get(json_object_get(root, "scene"), "model");
	energy = json_object_get(keys, "energy");
	if (json_is_string(energy) && strcmp(json_string_value(energy), "exact") == 0)
		functions = (int)json_integer_value(json_object_get(keys, "basis"));
	json_decref(root);
	return functions;
}

enum hawser_status cli_label_exact(struct cli_model *model, const char *text,
                                   struct hawser_report *report)
{
	char path[4096];
	int functions;

	if (!text || strcmp(text, "-") == 0 || !model->has_scene || model->automatic ||
	    model->scene.model.energy != HAWSER_ENERGY_AUTO)
		return HAWSER_OK;
	if (!cli_label_split(path, sizeof path, text))
		snprintf(path, sizeof path, "%s", text);
	functions = functions_of(path);
	if (functions <= 0)
		return HAWSER_OK;
	model->scene.model.energy = HAWSER_ENERGY_EXACT;
	model->scene.model.basis = functions;
	hawser_rom_clear(&model->rom);
	return hawser_rom_build_full(&model->rom, &model->statics, &model->scene, functions, report);
}

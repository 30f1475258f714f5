/* cli/model/last.c - read the end of a result to continue it, and check that it is of the same model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion/integrate_result.h"
#include "cli/model/state.h"
#include "core/report.h"

/* Read the last point of a response and the last row of a run, by the fields with which they were
 * written. `then` is the model, with room for the values in the result. */
static void read_response(struct cli_last *last, struct cli_model *then, const json_t *root)
{
	struct hawser__view view = cli_view(then, ~0u);
	struct hawser_frf_point point = {.omega = NAN};
	struct hawser_frf frf = {.point = &point, .state = last->state};
	struct cli_frf_result past = {.model = then, .frf = &frf};

	hawser__fields_read(&past, cli_frf_showing.fields, root, &view);
	last->omega = point.omega;
	last->direction = past.direction;
	last->end = frf.end;
}

static void read_run(struct cli_last *last, struct cli_model *then, const json_t *root)
{
	struct hawser__view view = cli_view(then, ~0u);
	struct cli_integrate_result past = {
		.model = then, .omega = NAN, .run = {.time = &last->t, .state = last->state}};

	last->t = NAN;
	view.context = &past;
	hawser__fields_read(&past, cli_integrate_showing.fields, root, &view);
	last->omega = past.omega;
	last->swept = past.forcing.omega_to > 0.0;
}

/* --- the same model? --- */

/* The name of the first member that differs, such as "load.extent", or NULL. The name of a scene, which
 * is its path, is not compared, and neither is the member `but` (or NULL). */
static const char *difference(char *name, size_t size, json_t *a, json_t *b, const char *but)
{
	char inner[64] = "";
	size_t length;
	const char *key;
	json_t *value;

	json_object_foreach(a, key, value) {
		json_t *other = json_object_get(b, key);

		length = strlen(key);
		if (strcmp(key, "name") == 0 || json_equal(value, other) || (but && strcmp(key, but) == 0))
			continue;
		if (json_is_object(value) && json_is_object(other)) {
			const char *part = but && strncmp(but, key, length) == 0 && but[length] == '.'
			                   ? but + length + 1 : NULL;

			*inner = '\0';
			if (!difference(inner, sizeof inner, value, other, part) &&
			    !difference(inner, sizeof inner, other, value, part))
				continue;
		}
		snprintf(name, size, "%s%s%s", key, *inner ? "." : "", inner);
		return name;
	}
	return NULL;
}

/* Results of model files have no keys to compare, but results of frf have the natural frequencies. */
static int frequencies_differ(const struct cli_model *model, const struct cli_model *then)
{
	for (int i = 0; i < model->naturals; i++)
		if (!(fabs(model->natural[i] - then->natural[i]) <= 1e-9*fabs(model->natural[i])))
			return 1;
	return 0;
}

const char *cli_last_difference(char *name, size_t size, const json_t *root, const char *but,
                                const struct cli_model *model, const struct cli_model *then,
                                const struct cli_common *common, enum hawser_status *status)
{
	json_t *before = json_object_get(root, "scene"), *now;
	const char *found = NULL;
	struct hawser__json echo;

	cli_echo_json(&echo, common, "", model->has_scene ? &model->scene : NULL);
	*status = echo.status;
	now = json_object_get(echo.root, "scene");
	if (!*status && model->has_scene && json_object_get(before, "span")) {
		found = difference(name, size, now, before, but);
		if (!found)
			found = difference(name, size, before, now, but);
	}
	if (!*status && !found && !but && frequencies_differ(model, then))
		found = "natural frequencies";
	hawser__json_clear(&echo);
	return found;
}

static enum hawser_status check(const json_t *root, const char *path, const char *command,
                                const struct cli_model *model, const struct cli_model *then,
                                const struct cli_common *common, struct hawser_report *report)
{
	enum hawser_status status;
	char name[128];
	const char *found = cli_last_difference(name, sizeof name, root, NULL, model, then,
	                                        common, &status);

	if (status)
		return hawser__no_memory(report, "continue");
	if (!found)
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "continue",
	                    "--continue %s: that is a result of another %s, with another value of %s; --%s "
	                    "begins anew from its last state", path,
	                    model->has_scene ? "scene" : "model", found,
	                    strcmp(command, "frf") == 0 ? "start" : "initial");
}

/* --- */

static enum hawser_status read_result(struct cli_last *last, struct cli_model *then,
                                      const json_t *root, const char *path, const char *command,
                                      struct hawser_report *report)
{
	const char *name = json_string_value(json_object_get(root, "command"));
	int ours = name && strcmp(name, command) == 0;

	last->omega = NAN;
	if (ours && strcmp(command, "frf") == 0)
		read_response(last, then, root);
	else if (ours)
		read_run(last, then, root);
	if (!isfinite(last->omega) || !isfinite(last->t))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "continue",
		                    "--continue %s: that is no result of hawser %s with a state to go on "
		                    "from, as --json writes it", path, command);
	for (int i = 0; i < 2*then->rom.n; i++)
		if (!isfinite(last->state[i]))
			return cli_state_refuse(report, path, then->rom.n,
			                        "its last state is not one of this model");
	return HAWSER_OK;
}

enum hawser_status cli_last_open(struct cli_last *last, const char *path, const char *command,
                                 const struct cli_model *model, const struct cli_common *common,
                                 struct hawser_report *report)
{
	size_t numbers = 2*(size_t)model->rom.n, naturals = (size_t)model->naturals;
	struct cli_model then = *model;
	json_t *root = NULL;
	enum hawser_status status = cli_state_root(&root, path, report);

	*last = (struct cli_last){.state = malloc((numbers + naturals)*sizeof *last->state)};
	if (!status && !last->state)
		status = hawser__no_memory(report, "continue");
	if (!status) {
		for (size_t i = 0; i < numbers; i++)
			last->state[i] = NAN;
		/* if the result has no natural frequencies, the present ones are compared */
		then.natural = last->state + numbers;
		memcpy(then.natural, model->natural, naturals*sizeof *then.natural);
		status = read_result(last, &then, root, path, command, report);
	}
	if (!status)
		status = check(root, path, command, model, &then, common, report);
	json_decref(root);
	if (status)
		cli_last_clear(last);
	return status;
}

void cli_last_clear(struct cli_last *last)
{
	free(last->state);
	last->state = NULL;
}

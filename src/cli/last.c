/* cli/last.c - where a result ended, to go on from there, and whether it is one of this very model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/cli.h"
#include "cli/state.h"
#include "core/report.h"

/* 0 where `root` is no result of `command`. */
static int find_last(struct cli_last *last, const json_t *root, const char *command)
{
	const char *name = json_string_value(json_object_get(root, "command"));
	const char *end = json_string_value(json_object_get(root, "end"));
	const json_t *points = json_object_get(root, "points"), *times = json_object_get(root, "times");
	const json_t *point = json_array_get(points, json_array_size(points) - 1);
	const json_t *time = json_array_get(times, json_array_size(times) - 1);

	if (!name || strcmp(name, command) != 0 || !end || !(point || time))
		return 0;
	snprintf(last->end, sizeof last->end, "%s", end);
	last->omega = json_number_value(json_object_get(point ? point : root, "Omega"));
	last->direction = (int)json_integer_value(json_object_get(root, "direction"));
	last->t = json_number_value(time);
	return isfinite(last->omega) && isfinite(last->t);
}

/* --- the same model? --- */

/* Like json_equal, but the name of the first member that differs, or NULL; "load.extent". Only the
 * name of a scene, which is its path, may differ. */
static const char *difference(char *name, size_t size, json_t *a, json_t *b)
{
	char inner[64] = "";
	const char *key;
	json_t *value;

	json_object_foreach(a, key, value) {
		json_t *other = json_object_get(b, key);

		if (strcmp(key, "name") == 0 || json_equal(value, other))
			continue;
		if (json_is_object(value) && json_is_object(other) &&
		    !difference(inner, sizeof inner, value, other))
			difference(inner, sizeof inner, other, value);
		snprintf(name, size, "%s%s%s", key, *inner ? "." : "", inner);
		return name;
	}
	return NULL;
}

/* Models out of files have no keys to compare, but a result of frf knows their frequencies. */
static int frequencies_differ(const json_t *list, const struct cli_model *model)
{
	if (json_array_size(list) != (size_t)model->naturals)
		return list != NULL;
	for (int i = 0; i < model->naturals; i++) {
		double mine = model->natural[i]*cli_per_omega(model);
		double then = json_number_value(json_array_get(list, (size_t)i));

		if (fabs(mine - then) > 1e-9*fmax(fabs(mine), fabs(then)))
			return 1;
	}
	return 0;
}

/* What differs between the scene of the result and the one of now, or NULL. */
static const char *compare(char *name, size_t size, const json_t *root,
                           const struct cli_model *model, const struct cli_common *common,
                           enum hawser_status *status)
{
	json_t *then = json_object_get(root, "scene"), *now;
	const char *found = NULL;
	struct hawser__json echo;

	cli_echo_json(&echo, common, "", model->has_scene ? &model->scene : NULL);
	*status = echo.status;
	now = json_object_get(echo.root, "scene");
	if (!*status && model->has_scene && json_object_get(then, "span")) {
		found = difference(name, size, now, then);
		if (!found)
			found = difference(name, size, then, now);
	}
	if (!*status && !found && frequencies_differ(json_object_get(root, "natural_frequencies"), model))
		found = "natural frequencies";
	hawser__json_clear(&echo);
	return found;
}

static enum hawser_status check(const json_t *root, const char *path, const char *command,
                                const struct cli_model *model, const struct cli_common *common,
                                struct hawser_report *report)
{
	enum hawser_status status;
	char name[128];
	const char *found = compare(name, sizeof name, root, model, common, &status);

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

enum hawser_status cli_last_open(struct cli_last *last, const char *path, const char *command,
                                 const struct cli_model *model, const struct cli_common *common,
                                 struct hawser_report *report)
{
	json_t *root = NULL;
	enum hawser_status status = cli_state_root(&root, path, report);

	*last = (struct cli_last){.state = NULL};
	if (!status && !(last->state = calloc(2*(size_t)model->rom.n, sizeof *last->state)))
		status = hawser__no_memory(report, "continue");
	if (!status && !find_last(last, root, command))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "continue",
		                      "--continue %s: that is no result of hawser %s with a state to go on "
		                      "from, as --json writes it", path, command);
	if (!status)
		status = cli_state_of(last->state, root, path, model, report);
	if (!status)
		status = check(root, path, command, model, common, report);
	json_decref(root);
	last->omega /= cli_per_omega(model);
	last->t *= cli_per_omega(model);
	if (status)
		cli_last_clear(last);
	return status;
}

void cli_last_clear(struct cli_last *last)
{
	free(last->state);
	last->state = NULL;
}

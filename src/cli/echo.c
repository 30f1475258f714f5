/* cli/echo.c - what every result begins with: version, command, and the scene it belongs to, key by
 * key from the scene's own table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "cli/cli.h"

void cli_echo_table(struct hawser__table *table, const struct cli_common *common,
                    const char *command, const struct hawser_scene *scene, const char *method)
{
	int i;

	hawser__table_comment(table, "hawser %s %s", hawser_version(), command);
	hawser__table_comment(table, "%s: %s", scene ? "scene" : "model",
	                      scene && scene->name ? scene->name : common->input);
	for (i = 0; i < common->sets; i++)
		hawser__table_comment(table, "set: %s", common->set[i]);
	hawser__table_comment(table, "method: %s", method);
	if (scene)
		hawser__table_comment(table, "g = %.10g m/s^2", scene->g);
}

static const char *given_name(enum hawser_given given)
{
	static const char *const name[] = {"", "H", "T0", "T1", "length0", "sag"};

	return name[given];
}

/* Keys that hold no single number. */
static void other_value(struct hawser__json *json, json_t *section, const char *name,
                        const struct hawser_scene *scene, const char *path)
{
	if (strcmp(path, "tension.branch") == 0)
		hawser__json_text(json, section, name,
		                  scene->tension.branch == HAWSER_BRANCH_SLACK ? "slack" : "taut");
	else if (strcmp(path, "load.frame") == 0)
		hawser__json_text(json, section, name,
		                  scene->load.frame == HAWSER_FRAME_GLOBAL ? "global" : "local");
	else if (strcmp(path, "load.per_length") == 0)
		hawser__json_numbers(json, section, name, scene->load.per_length, 3, 1.0);
	else if (strcmp(path, "load.extent") == 0)
		hawser__json_numbers(json, section, name, scene->load.extent, 2, 1.0);
}

static int is_used(const struct hawser_scene *scene, const char *path)
{
	if (strncmp(path, "tension.", 8) == 0 && strcmp(path, "tension.branch") != 0)
		return strcmp(path + 8, given_name(scene->tension.given)) == 0;
	if (strcmp(path, "tension.branch") == 0)
		return scene->tension.given == HAWSER_GIVEN_T0 || scene->tension.given == HAWSER_GIVEN_T1;
	return strncmp(path, "load.", 5) != 0 || scene->load.present;
}

/* The object that "damping.rayleigh" names, made where it is missing; *name is what is left. */
static json_t *walk(struct hawser__json *json, json_t *echo, const char **name, const char *path)
{
	const char *dot;
	json_t *inner;
	char part[64];

	for (; (dot = strchr(path, '.')) != NULL; path = dot + 1, echo = inner) {
		snprintf(part, sizeof part, "%.*s", (int)(dot - path), path);
		inner = json_object_get(echo, part);
		if (!inner)
			inner = hawser__json_object(json, echo, part);
	}
	*name = path;
	return echo;
}

static void echo_key(struct hawser__json *json, json_t *echo, const struct hawser_scene *scene,
                     const struct hawser_scene_key *key)
{
	int scalar, single = strcmp(key->type, "number") == 0 || strcmp(key->type, "integer") == 0;
	json_t *section;
	const char *name;
	double value;

	if (!is_used(scene, key->path))
		return;
	scalar = single && hawser_scene_get(scene, &value, key->path, NULL) == HAWSER_OK;
	if (single && !scalar)
		return;
	section = walk(json, echo, &name, key->path);
	if (!scalar)
		other_value(json, section, name, scene, key->path);
	else if (isinf(value))
		hawser__json_text(json, section, name, ".inf");
	else if (strcmp(key->type, "integer") == 0)
		hawser__json_integer(json, section, name, (long)value);
	else
		hawser__json_number(json, section, name, value);
}

void cli_echo_json(struct hawser__json *json, const struct cli_common *common,
                   const char *command, const struct hawser_scene *scene)
{
	const struct hawser_scene_key *key;
	size_t count, i;
	json_t *echo;

	hawser__json_begin(json);
	hawser__json_text(json, json->root, "command", command);
	hawser__json_text(json, json->root, "version", hawser_version());
	echo = hawser__json_object(json, json->root, "scene");
	hawser__json_text(json, echo, scene ? "name" : "model_file",
	                  scene && scene->name ? scene->name : common->input);
	if (!scene)
		return;
	key = hawser_scene_keys(&count);
	for (i = 0; i < count && !json->status; i++)
		echo_key(json, echo, scene, &key[i]);
}

json_t *cli_stats_json(struct hawser__json *json, const struct cli_common *common)
{
	json_t *stats = hawser__json_object(json, json->root, "stats");

	hawser__json_number(json, stats, "wall_time_secs", cli_seconds() - common->started);
	return stats;
}

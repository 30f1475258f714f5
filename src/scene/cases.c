/* scene/cases.c - the list of load cases: each has a name, and the static load and the change of
 * temperature that take the place of those of the scene.
 *
 * An item is read into an empty scene, by the same code as load.static and temperature of a scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "scene/tree.h"

static enum hawser_status name_of(struct hawser__reader *reader, struct hawser_case *to, int number,
                                  const struct hawser__tree *tree)
{
	const char *text = tree->text;

	if (!text || !*text || strlen(text) >= sizeof to->name || strpbrk(text, "\"\\\t#{}[],:"))
		return hawser__reader_fail(reader, &tree->at, "cases[%d].name must be a word or a few, of at "
		                           "most %d characters, without quotes, tabs and \\ # { } [ ] , :",
		                           number, HAWSER_NAME_SIZE - 1);
	memcpy(to->name, text, strlen(text) + 1);
	return HAWSER_OK;
}

static int is_below(const char *path, const char *section)
{
	size_t length = strlen(section);

	return !strncmp(path, section, length) && (!path[length] || path[length] == '.');
}

/* A key of a case, whose own scene the reader has. Paths are those of overrides. */
static enum hawser_status key_of(struct hawser__reader *reader, struct hawser_case *to, int number,
                                 const char *path, const struct hawser__tree *tree)
{
	char shown[HAWSER__SHOWN];

	if (!strcmp(path, "name"))
		return name_of(reader, to, number, tree);
	if (!strcmp(path, "load") || !strcmp(path, "temperature") ||
	    (!tree->name && (is_below(path, "load") || is_below(path, "temperature"))))
		return hawser__parse_value(reader, path, tree);
	return hawser__reader_fail(reader, &tree->at, "cases[%d] takes name, load and temperature, not %s",
	                           number, hawser__shown(shown, path));
}

/* Keep what the scene of an item has. */
static enum hawser_status keep(struct hawser__reader *reader, struct hawser_case *to, int number,
                               const struct hawser__mark *place)
{
	const struct hawser_scene *scene = reader->scene;

	if (!*to->name)
		return hawser__reader_fail(reader, place, "cases[%d] has no name: give it one, such as "
		                           "name: ice", number);
	for (int i = 0; hawser_scene_key(i); i++)
		if (scene->written[i] && hawser__child_of(hawser_scene_key(i)->path, "load"))
			return hawser__reader_fail(reader, &reader->key[i], "cases[%d] (%s): a case has a static "
			                           "load only, load: {static: {...}}; the varying one is that "
			                           "of the scene", number, to->name);
	to->loaded = reader->section[hawser__section_find("load.static")].pass != 0;
	memcpy(to->per_length, scene->static_load.per_length, sizeof to->per_length);
	to->mass = scene->static_load.mass;
	to->heated = reader->section[hawser__section_find("temperature")].pass != 0;
	if (to->heated && !hawser_scene_written(scene, "temperature.change"))
		return hawser__reader_fail(reader, place, "cases[%d] (%s): temperature.change is missing: "
		                           "give a number in K", number, to->name);
	to->change = scene->temperature.change;
	to->expansion = hawser_scene_written(scene, "temperature.expansion")
	                ? scene->temperature.expansion : NAN;
	return HAWSER_OK;
}

/* Read all keys of a case or, with a path, that one, into a scene of its own. */
static enum hawser_status read_case(struct hawser__reader *reader, int number, const char *path,
                                    const struct hawser__tree *tree)
{
	struct hawser_scene *scene = reader->scene, *one = calloc(1, sizeof *one);
	struct hawser__reader inner = *reader;
	struct hawser_case *to = &scene->load_case[number];
	enum hawser_status status = HAWSER_OK;

	if (!one)
		return hawser__no_memory(reader->report, "scene");
	inner.scene = one;
	memset(inner.key, 0, sizeof inner.key);
	memset(inner.section, 0, sizeof inner.section);
	if (path) {
		hawser_scene_case(one, scene, number);
		memset(one->written, 0, sizeof one->written);
		one->written[hawser__key_find("temperature.change")] = (unsigned char)to->heated;
		one->written[hawser__key_find("temperature.expansion")] =
			(unsigned char)(to->heated && !isnan(to->expansion));
		inner.section[hawser__section_find("load.static")].pass =
			to->loaded || is_below(path, "load.static");
		inner.section[hawser__section_find("temperature")].pass =
			to->heated || is_below(path, "temperature");
		status = key_of(&inner, to, number, path, tree);
	}
	for (const struct hawser__tree *child = tree->child; !path && child && !status; child = child->next)
		status = key_of(&inner, to, number, child->name, child);
	if (status == HAWSER_OK)
		status = keep(&inner, to, number, &reader->list[HAWSER__CASES]);
	reader->units = inner.units;
	free(one);
	return status;
}

enum hawser_status hawser__case_read(struct hawser__reader *reader, int number,
                                     const struct hawser__tree *tree)
{
	return read_case(reader, number, NULL, tree);
}

enum hawser_status hawser__case_set(struct hawser__reader *reader, int number, const char *path,
                                    const struct hawser__tree *tree)
{
	return read_case(reader, number, path, tree);
}

enum hawser_status hawser__cases_check(struct hawser__reader *reader)
{
	struct hawser_scene *scene = reader->scene;

	for (int i = 0; i < scene->cases; i++) {
		struct hawser_case *c = &scene->load_case[i];

		if (!c->heated || !isnan(c->expansion))
			continue;
		if (!scene->temperature.present)
			return hawser__reader_fail(reader, &reader->list[HAWSER__CASES], "cases[%d] (%s) has no "
			                           "temperature.expansion, and neither has the scene: give it "
			                           "in 1/K in one of them", i, c->name);
		c->expansion = scene->temperature.expansion;
	}
	return HAWSER_OK;
}

void hawser_scene_case(struct hawser_scene *to, const struct hawser_scene *scene, int index)
{
	const struct hawser_case *c = &scene->load_case[index];

	*to = *scene;
	to->static_load.present = c->loaded;
	memcpy(to->static_load.per_length, c->per_length, sizeof c->per_length);
	to->static_load.mass = c->mass;
	to->temperature.present = c->heated;
	to->temperature.change = c->heated ? c->change : 0.0;
	to->temperature.expansion = c->heated ? c->expansion : 0.0;
}

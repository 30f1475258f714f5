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
#include "scene/reader.h"

/* The text of a case's name, which follows its key. */
static enum hawser_status name_of(struct hawser__reader *reader, struct hawser_case *to, int number,
                                  const struct hawser__mark *place)
{
	char text[HAWSER__TEXT_ROOM] = "";
	yaml_event_t event;
	enum hawser_status status = hawser__event_next(reader, &event);

	if (status != HAWSER_OK)
		return status;
	if (event.type == YAML_SCALAR_EVENT)
		status = hawser__event_text(reader, text, &event, "this name");
	yaml_event_delete(&event);
	if (status != HAWSER_OK)
		return status;
	if (!*text || strlen(text) >= sizeof to->name || strpbrk(text, "\"\\\t#{}[],:"))
		return hawser__reader_fail(reader, place, "cases[%d].name must be a word or a few, of at "
		                           "most %d characters, without quotes, tabs and \\ # { } [ ] , :",
		                           number, HAWSER_NAME_SIZE - 1);
	memcpy(to->name, text, strlen(text) + 1);
	return HAWSER_OK;
}

/* One "key: value" of a case; *end is 1 at the end. */
static enum hawser_status pair(struct hawser__reader *reader, int *end, struct hawser_case *to,
                               int number)
{
	char key[HAWSER__TEXT_ROOM] = "", shown[HAWSER__SHOWN];
	struct hawser__mark place;
	yaml_event_t event;
	enum hawser_status status = hawser__event_next(reader, &event);

	if (status != HAWSER_OK)
		return status;
	place = hawser__event_place(reader, &event);
	*end = event.type == YAML_MAPPING_END_EVENT;
	if (event.type == YAML_SCALAR_EVENT)
		status = hawser__event_text(reader, key, &event, "this key");
	yaml_event_delete(&event);
	if (*end || status != HAWSER_OK)
		return status;
	if (!strcmp(key, "name"))
		return *to->name ? hawser__reader_fail(reader, &place, "cases[%d] has two names: keep one",
		                                       number)
		                 : name_of(reader, to, number, &place);
	if (!strcmp(key, "load") || !strcmp(key, "temperature"))
		return hawser__parse_value(reader, key, &place);
	return hawser__reader_fail(reader, &place, "cases[%d] takes name, load and temperature, not %s",
	                           number, hawser__shown(shown, key));
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

enum hawser_status hawser__case_read(struct hawser__reader *reader, int number)
{
	struct hawser_scene *scene = reader->scene, *one = calloc(1, sizeof *one);
	struct hawser__reader inner = *reader;
	struct hawser_case *to = &scene->load_case[number];
	enum hawser_status status = HAWSER_OK;
	int end = 0;

	if (!one)
		return hawser__no_memory(reader->report, "scene");
	inner.scene = one;
	memset(inner.key, 0, sizeof inner.key);
	memset(inner.section, 0, sizeof inner.section);
	while (status == HAWSER_OK && !end)
		status = pair(&inner, &end, to, number);
	if (status == HAWSER_OK)
		status = keep(&inner, to, number, &reader->list[HAWSER__CASES]);
	reader->units = inner.units;
	free(one);
	return status;
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

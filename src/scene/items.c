/* scene/items.c - the list of attachments: its items have the keys "attach.NAME" of the table, and
 * are read, checked and named one by one.
 *
 * Each item is a pass of its own (reader.h), with a negative number, so that a key may occur once in
 * each item.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/reader.h"

static const char list[] = "attach";

/* Read the value of `path` in attachment `item` or, if it is NULL, all keys of the attachment. */
static enum hawser_status within(struct hawser__reader *reader, int item, const char *path,
                                 const struct hawser__place *place)
{
	int pass = reader->pass;
	enum hawser_status status;

	reader->item = item;
	reader->pass = -(++reader->items);
	status = path ? hawser__parse_value(reader, path, place) : hawser__parse_mapping(reader, list);
	reader->pass = pass;
	reader->item = 0;
	return status;
}

/* Read the item that begins with `event`. */
static enum hawser_status item(struct hawser__reader *reader, const yaml_event_t *event)
{
	struct hawser__place place = hawser__event_place(reader, event);
	int at = hawser__key_find("attach.at"), number = reader->scene->attachments;
	enum hawser_status status;

	if (event->type != YAML_MAPPING_START_EVENT)
		return hawser__reader_fail(reader, &place, "attach[%d] must be a mapping, such as "
		                           "{at: 40 %%, mass: 20 kg}", number);
	if (number == HAWSER_ATTACH_MAX)
		return hawser__reader_fail(reader, &place, "attach has more than %d items: give fewer",
		                           HAWSER_ATTACH_MAX);
	reader->scene->attach[number] = (struct hawser_attachment){.absorber_direction = {0.0, 1.0, 0.0}};
	reader->key[at] = (struct hawser__place){0};
	status = within(reader, number, NULL, NULL);
	if (status != HAWSER_OK)
		return status;
	reader->scene->attachments++;
	if (reader->key[at].pass == 0)
		return hawser__reader_fail(reader, &place, "attach[%d] has no position: give at, such as "
		                           "at: 40 %% or at: 12 m", number);
	return HAWSER_OK;
}

enum hawser_status hawser__list_read(struct hawser__reader *reader,
                                     enum hawser_status (*read)(struct hawser__reader *,
                                                                const yaml_event_t *))
{
	enum hawser_status status = HAWSER_OK;

	for (int end = 0; !end && status == HAWSER_OK;) {
		yaml_event_t event;

		status = hawser__event_next(reader, &event);
		if (status != HAWSER_OK)
			break;
		end = event.type == YAML_SEQUENCE_END_EVENT;
		if (!end)
			status = read(reader, &event);
		yaml_event_delete(&event);
	}
	return status;
}

enum hawser_status hawser__items_read(struct hawser__reader *reader,
                                      const struct hawser__place *place)
{
	struct hawser__place here;
	yaml_event_t event;
	enum hawser_status status;

	if (reader->attach.pass == reader->pass)
		return hawser__reader_fail(reader, place, "duplicate key attach: keep one list");
	reader->attach = *place;
	status = hawser__event_next(reader, &event);
	if (status != HAWSER_OK)
		return status;
	here = hawser__event_place(reader, &event);
	reader->scene->attachments = 0;
	if (event.type == YAML_SEQUENCE_START_EVENT)
		status = hawser__list_read(reader, item);
	else
		status = hawser__reader_fail(reader, &here, "attach must be a list of mappings, such as "
		                             "[{at: 40 %%, mass: 20 kg}]");
	yaml_event_delete(&event);
	return status;
}

int hawser__item_key(int *number, const struct hawser_scene *scene, const char *path)
{
	const char *name = path + sizeof list, *dot = strchr(name, '.');
	size_t length = dot ? (size_t)(dot - name) : 0;
	char key[2*HAWSER_NAME_SIZE];

	*number = -1;
	if (!length)
		return -1;
	if (isdigit((unsigned char)*name)) {
		char *end;
		long value = strtol(name, &end, 10);

		if (end == dot && value < scene->attachments)
			*number = (int)value;
	}
	for (int i = 0; i < scene->attachments && *number < 0; i++)
		if (strlen(scene->attach[i].name) == length &&
		    strncmp(scene->attach[i].name, name, length) == 0)
			*number = i;
	snprintf(key, sizeof key, "%s.%s", list, dot + 1);
	return strchr(dot + 1, '.') ? -1 : hawser__key_find(key);
}

enum hawser_status hawser__items_set(struct hawser__reader *reader, const char *path,
                                     const struct hawser__place *place)
{
	int number, key = hawser__item_key(&number, reader->scene, path);
	char shown[HAWSER__SHOWN];

	if (key < 0)
		return hawser__reader_fail(reader, place, "unknown key %s: write attach.NUMBER.KEY, from 0, "
		                           "or attach.NAME.KEY, with at, mass, spring, damper, absorber_... "
		                           "or name",
		                           hawser__shown(shown, path));
	if (number < 0)
		return hawser__reader_fail(reader, place, "%s: the scene has %d attachment%s, and none has "
		                           "this number or name", hawser__shown(shown, path),
		                           reader->scene->attachments,
		                           reader->scene->attachments == 1 ? "" : "s");
	return within(reader, number, hawser_scene_key(key)->path, place);
}

/* 1 if an attachment has no effect. */
static int idle(const struct hawser_attachment *a)
{
	double sum = a->mass + a->absorber_mass;

	for (int c = 0; c < 3; c++)
		sum += a->spring[c] + a->damper[c];
	return sum == 0.0;
}

enum hawser_status hawser__items_check(struct hawser__reader *reader)
{
	const struct hawser_scene *scene = reader->scene;
	const struct hawser_attachment *a = scene->attach;

	if (!scene->attachments)
		return HAWSER_OK;
	if (scene->beam.form)
		return hawser__reader_fail(reader, &reader->attach, "attach contradicts beam: a scene is of "
		                           "a cable or of a beam, remove one of them");
	if (scene->travel.present)
		return hawser__reader_fail(reader, &reader->attach, "attach contradicts travel: attachments "
		                           "are at rest, and the cable would move past them; remove one of "
		                           "them");
	for (int i = 0; i < scene->attachments; i++) {
		if ((a[i].absorber_mass > 0.0) != (a[i].absorber_stiffness > 0.0) ||
		    (a[i].absorber_damping > 0.0 && !(a[i].absorber_mass > 0.0)))
			return hawser__reader_fail(reader, &reader->attach, "attach[%d] has an incomplete "
			                           "absorber: give both absorber_mass and absorber_stiffness, "
			                           "or none", i);
		if (idle(&a[i]))
			return hawser__reader_fail(reader, &reader->attach, "attach[%d] has no effect: give it a "
			                           "mass, a spring, a damper or an absorber", i);
		for (int j = 0; j < i; j++)
			if (*a[i].name && !strcmp(a[i].name, a[j].name))
				return hawser__reader_fail(reader, &reader->attach, "attach[%d] and attach[%d] "
				                           "have the same name %s: give different ones, or "
				                           "none", j, i, a[i].name);
			else if (a[i].by_length == a[j].by_length && a[i].at == a[j].at)
				return hawser__reader_fail(reader, &reader->attach, "attach[%d] and attach[%d] "
				                           "are at the same point: make one of them", j, i);
	}
	return HAWSER_OK;
}

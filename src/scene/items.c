/* scene/items.c - the lists of a scene: their items have keys "attach.KEY" of the table, and are read,
 * checked and named one by one.
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

#include "core/append.h"
#include "scene/reader.h"
#include "scene/tree_keys.h"

/* Read the value of `path` in an item of a list or, if it is NULL, all keys of the item. */
static enum hawser_status within(struct hawser__reader *reader, const struct hawser__items *list,
                                 int item, const char *path, const struct hawser__tree *tree)
{
	int pass = reader->pass;
	enum hawser_status status;

	reader->item = item;
	reader->pass = -(++reader->items);
	status = path ? hawser__parse_value(reader, path, tree)
	              : hawser__parse_mapping(reader, list->name, tree);
	reader->pass = pass;
	reader->item = 0;
	return status;
}

static enum hawser_status item(struct hawser__reader *reader, const struct hawser__items *list,
                               const struct hawser__tree *tree)
{
	const struct hawser__mark place = tree->value;
	int *count = hawser__list_count(list, reader->scene), number = *count;
	int needed = list->required ? hawser__key_find(list->required) : -1;
	char *fresh = (char *)reader->scene + list->first + (size_t)number*list->size;
	enum hawser_status status;

	if (tree->kind != HAWSER__MAPPING)
		return hawser__reader_fail(reader, &place, "%s[%d] must be a mapping, such as %s",
		                           list->name, number, list->example);
	if (number == list->most)
		return hawser__reader_fail(reader, &place, "%s has more than %d items: give fewer",
		                           list->name, list->most);
	memset(fresh, 0, list->size);
	if (list->fresh)
		memcpy(fresh, list->fresh, list->size);
	if (needed >= 0)
		reader->key[needed] = (struct hawser__mark){0};
	status = list->read ? list->read(reader, number, tree)
	                    : within(reader, list, number, NULL, tree);
	if (status != HAWSER_OK)
		return status;
	++*count;
	if (needed >= 0 && reader->key[needed].pass == 0)
		return hawser__reader_fail(reader, &place, "%s[%d] %s", list->name, number, list->missing);
	return HAWSER_OK;
}

enum hawser_status hawser__items_read(struct hawser__reader *reader, int index,
                                      const struct hawser__tree *tree)
{
	const struct hawser__items *list = hawser__list_row(index);
	enum hawser_status status = HAWSER_OK;

	reader->list[index] = tree->at;
	*hawser__list_count(list, reader->scene) = 0;
	if (tree->kind != HAWSER__SEQUENCE)
		return hawser__reader_fail(reader, &tree->value, "%s must be a list of mappings, such as [%s]",
		                           list->name, list->example);
	for (const struct hawser__tree *child = tree->child; child && !status; child = child->next)
		status = item(reader, list, child);
	return status;
}

int hawser__item_key(int *number, const struct hawser_scene *scene, const char *path)
{
	const struct hawser__items *list = hawser__list_row(hawser__list_find(path));
	const char *name = path + strcspn(path, "."), *dot;
	size_t length;
	int count = list ? *hawser__list_count(list, scene) : 0;
	char key[2*HAWSER_NAME_SIZE];

	*number = -1;
	name += *name == '.';
	length = strcspn(name, ".");
	dot = name + length;
	if (!length || !list)
		return -1;
	if (isdigit((unsigned char)*name)) {
		char *end;
		long value = strtol(name, &end, 10);

		if (end == dot && value < count)
			*number = (int)value;
	}
	for (int i = 0; i < count && *number < 0; i++) {
		const char *own = hawser__item_name(list, scene, i);

		if (strlen(own) == length && strncmp(own, name, length) == 0)
			*number = i;
	}
	if (!*dot || !list->keys)
		return -1;
	snprintf(key, sizeof key, "%s.%s", list->name, dot + 1);
	return strchr(dot + 1, '.') ? -1 : hawser__key_find(key);
}

enum hawser_status hawser__items_set(struct hawser__reader *reader, int index, const char *path,
                                     const struct hawser__tree *tree)
{
	const struct hawser__mark *place = &tree->at;
	const struct hawser__items *list = hawser__list_row(index);
	int number, key = hawser__item_key(&number, reader->scene, path);
	int count = *hawser__list_count(list, reader->scene);
	const char *rest = strchr(strchr(path, '.') + 1, '.');
	char shown[HAWSER__SHOWN], best[HAWSER__TEXT_ROOM], keys[HAWSER__TREE_LIST_SIZE] = "";

	for (int i = 0; hawser_scene_key(i) && key < 0; i++)
		if (hawser__list_of(i) == list)
			hawser__append(keys, sizeof keys, ", ", "%s", hawser__leaf(hawser_scene_key(i)->path));
	if (list->set && number >= 0 && rest)
		return list->set(reader, number, rest + 1, tree);
	if (!list->keys)
		return hawser__reader_fail(reader, place, "%s: give the whole list, %s=[%s]", path, list->name,
		                           list->example);
	hawser__tree_nearest(best, hawser__leaf(path), keys);
	if (key < 0)
		return hawser__reader_fail(reader, place, "unknown key %s: %s%s%swrite %s.NUMBER.KEY, from 0, "
		                           "or %s.NAME.KEY, with %s", hawser__shown(shown, path),
		                           *best ? "did you mean " : "", best, *best ? "? " : "", list->name,
		                           list->name, list->keys);
	if (number < 0)
		return hawser__reader_fail(reader, place, "%s: the scene has %d %s%s, and none has "
		                           "this number or name", hawser__shown(shown, path), count,
		                           list->one, count == 1 ? "" : "s");
	return within(reader, list, number, hawser_scene_key(key)->path, tree);
}

/* Rules of every list. */
static enum hawser_status common(struct hawser__reader *reader, int index)
{
	const struct hawser__items *list = hawser__list_row(index);
	const struct hawser__mark *here = &reader->list[index];

	if (reader->scene->beam.form)
		return hawser__reader_fail(reader, here, "%s contradicts beam: a scene is of a cable or of a "
		                           "beam, remove one of them", list->name);
	for (int i = 0; i < *hawser__list_count(list, reader->scene); i++)
		for (int j = 0; j < i; j++) {
			const char *name = hawser__item_name(list, reader->scene, i);

			if (*name && !strcmp(name, hawser__item_name(list, reader->scene, j)))
				return hawser__reader_fail(reader, here, "%s[%d] and %s[%d] have the same "
				                           "name %s: give different ones%s", list->name, j,
				                           list->name, i, name, list->keys ? ", or none" : "");
		}
	return HAWSER_OK;
}

enum hawser_status hawser__items_check(struct hawser__reader *reader)
{
	const struct hawser__items *list;
	enum hawser_status status = HAWSER_OK;

	for (int l = 0; !status && (list = hawser__list_row(l)); l++) {
		if (!*hawser__list_count(list, reader->scene))
			continue;
		status = common(reader, l);
		if (!status)
			status = list->check(reader);
	}
	return status;
}

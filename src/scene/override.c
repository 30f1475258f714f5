/* scene/override.c - overrides of spans that are no plain values: what is taken out ("attach.0="), and
 * one element of a list. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdio.h>
#include <string.h>

#include "scene/tree.h"

static void forget_item(struct hawser__reader *reader, const struct hawser__items *list, int number)
{
	int *count = hawser__list_count(list, reader->scene);
	char *at = (char *)reader->scene + list->first + (size_t)number*list->size;

	--*count;
	memmove(at, at + list->size, (size_t)(*count - number)*list->size);
}

/* A key of an item gets its default again. */
static void forget_of_item(struct hawser__reader *reader, const struct hawser__items *list, int number,
                           int index)
{
	const struct hawser__row *row = &hawser__rows()[index];
	size_t offset = row->offset - list->first, size = hawser__parse_size(row);
	char *at = (char *)hawser__field(reader->scene, index, number);

	if (row->type == HAWSER__NAME)
		*at = '\0';
	else if (list->fresh)
		memcpy(at, (const char *)list->fresh + offset, size);
	else
		memset(at, 0, size);
}

enum hawser_status hawser__parse_take_out(struct hawser__reader *reader, const char *path,
                                          const struct hawser__mark *place)
{
	const struct hawser__items *list = hawser__list_row(hawser__list_find(path));
	size_t sections, length = strlen(path);
	const struct hawser__section *section = hawser__sections(&sections);
	int item, key = list ? hawser__item_key(&item, reader->scene, path) : hawser__key_find(path);

	if (list && !strchr(path, '.')) {
		*hawser__list_count(list, reader->scene) = 0;
		reader->list[hawser__list_find(path)] = (struct hawser__mark){0};
		return HAWSER_OK;
	}
	if (list && key >= 0 && item >= 0 && list->required &&
	    !strcmp(hawser_scene_key(key)->path, list->required))
		return hawser__reader_fail(reader, place, "%s: each %s needs it", path, list->one);
	if (list && item >= 0 && key >= 0)
		forget_of_item(reader, list, item, key);
	else if (list && item >= 0)
		forget_item(reader, list, item);
	else if (list || (key < 0 && hawser__section_find(path) < 0))
		return list ? hawser__items_set(reader, hawser__list_find(path), path,
		                                &(struct hawser__tree){.at = *place})
		            : hawser__parse_unknown(reader, place, path);
	for (size_t s = 0; s < sections && !list; s++)
		if (!strncmp(section[s].path, path, length) && strchr(".", section[s].path[length]))
			reader->section[s] = (struct hawser__mark){0};
	for (int i = 0; hawser_scene_key(i) && !list; i++) {
		const struct hawser__row *row = &hawser__rows()[i];
		const char *own = hawser_scene_key(i)->path;

		if (strncmp(own, path, length) != 0 || !strchr(".", own[length]) || !reader->key[i].pass)
			continue;
		if (row->group && hawser__chosen(reader->scene, row->group) == row->member)
			hawser__choose(reader->scene, row->group, 0);
		hawser__parse_forget(reader, i);
	}
	return HAWSER_OK;
}

int hawser__parse_element(char *text, size_t size, const struct hawser_scene *scene, const char *path,
                          int element, const char *value)
{
	int item = 0, count;
	int key = hawser__list_find(path) >= 0 ? hawser__item_key(&item, scene, path)
	                                       : hawser__key_find(path);
	size_t used = 0;

	if (key < 0 || item < 0 || (!hawser__list_of(key) && !scene->written[key]))
		return 0;
	count = hawser__count(scene, key);
	for (int k = 0; k < count && used < size; k++)
		used += k == element ? (size_t)snprintf(text + used, size - used, "%s%s", k ? ", " : "[", value)
		                     : (size_t)snprintf(text + used, size - used, "%s%.17g", k ? ", " : "[",
		                                        hawser__stored(scene, key, k, item));
	if (used < size)
		snprintf(text + used, size - used, "]");
	return element < count && used + 1 < size;
}

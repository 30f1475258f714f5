/* scene/scene.c - open a scene, and access its values by key.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "scene/keys.h"

/* `status`: whether the document could be read. */
static enum hawser_status once(struct hawser_scene *scene, enum hawser_status status,
                               struct hawser_document *from, const char *const *set, size_t nset,
                               struct hawser_report *report)
{
	memset(scene, 0, sizeof *scene);
	if (!status)
		status = hawser_scene_of(scene, from, set, nset, report);
	hawser_document_clear(from);
	return status;
}

enum hawser_status hawser_scene_read(struct hawser_scene *scene, FILE *stream, const char *name,
                                     const char *const *set, size_t nset,
                                     struct hawser_report *report)
{
	struct hawser_document from;

	return once(scene, hawser_document_read(&from, stream, name, report), &from, set, nset, report);
}

enum hawser_status hawser_scene_open(struct hawser_scene *scene, const char *path,
                                     const char *const *set, size_t nset,
                                     struct hawser_report *report)
{
	struct hawser_document from;

	return once(scene, hawser_document_open(&from, path, report), &from, set, nset, report);
}

/* Split "load.extent[1]" into the index of its key and the element 1; without an element it is -1.
 * *item is the number of the item of a list, -1 if it does not exist; 0 for other keys. */
static int locate(const struct hawser_scene *scene, const char *path, int *element, int *item)
{
	char name[HAWSER__TEXT_ROOM];
	int index;

	*element = -1;
	*item = 0;
	if (strlen(path) >= sizeof name)
		return -1;
	strcpy(name, path);
	if (!hawser__path_plain(name))
		return -1;
	index = hawser__item_key(item, scene, name);
	if (index >= 0)
		return index;
	*element = hawser__path_element(name);
	return *element < 0 ? -1 : hawser__item_key(item, scene, name);
}

static enum hawser_status absent(const char *path, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "scene",
	                    "this scene does not give %.60s: add it to the scene, or with --set", path);
}

static enum hawser_status no_key(const char *path, struct hawser_report *report)
{
	char of[HAWSER__TEXT_ROOM], keys[HAWSER__TREE_LIST_SIZE], hint[HAWSER__TEXT_ROOM];
	char own[HAWSER__TEXT_ROOM];
	int nested = strchr(path, '.') != NULL, inner;

	snprintf(of, sizeof of, "span%s%.200s", nested ? "." : "", nested ? path : "");
	if (nested)
		*strrchr(of, '.') = '\0';
	hawser__tree_key_list(keys, sizeof keys, of);
	hawser__tree_suggest(hint, hawser__leaf(path), of, keys);
	snprintf(own, sizeof own, "did you mean %.200s? ", hawser__leaf(path));
	if (strcmp(hint, own) == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hawser_scene_get",
		                    "%.60s is a section or a list: name a number in it, as tension.T0 or "
		                    "load.per_length[2]", path);
	inner = nested && *keys;
	if (!inner)
		hawser__tree_key_list(keys, sizeof keys, "span");
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hawser_scene_get",
	                    "there is no key %.60s: %s%s takes %s", path, hint, inner ? of + 5 : "a scene",
	                    keys);
}

enum hawser_status hawser_scene_get(const struct hawser_scene *scene, double *value,
                                    const char *path, struct hawser_report *report)
{
	int element, item, index = locate(scene, path, &element, &item);
	int count;

	if (index < 0)
		return no_key(path, report);
	if (hawser__is_word(scene, index) || hawser__row(index)->type == HAWSER__TREE_TEXT)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hawser_scene_get",
		                    "%s is a word, not a number", path);
	count = hawser__count(scene, index);
	if (count > 1 && element < 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hawser_scene_get",
		                    "%s has %d values: give one of them, %s[0] to %s[%d]", path, count, path,
		                    path, count - 1);
	if (count ? element < 0 || element >= count : element >= 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hawser_scene_get",
		                    "%s: %s has %d value%s, counted from 0", path,
		                    hawser_scene_key(index)->path, count ? count : 1,
		                    count ? "s" : "");
	if (hawser__list_of(index) ? item < 0 : !hawser__applies(scene, index))
		return absent(path, report);
	*value = hawser__stored(scene, index, element, item);
	return HAWSER_OK;
}

const char *hawser__key_unit(const struct hawser_scene *scene, const char *path, char unit[static 32])
{
	int element, item, index = locate(scene, path, &element, &item);
	const char *of = index < 0 ? "1" : hawser_scene_key(index)->unit;

	snprintf(unit, 32, " %s", of);
	return strcmp(of, "1") == 0 || !*of ? "" : unit;
}

static enum hawser_status out_of_range(const char *path, double value, int index,
                                       struct hawser_report *report)
{
	const struct hawser_scene_key *key = hawser_scene_key(index);
	int pure = !strcmp(key->unit, "1");

	return hawser__fail(report, HAWSER_ERR_SCENE, "scene",
	                    "%s = %.9g%s%s is out of range: it must be %s%s", path, value,
	                    pure ? "" : " ", pure ? "" : key->unit,
	                    hawser__row(index)->type == HAWSER__TREE_INTEGER ? "a whole number, " : "",
	                    key->range);
}

enum hawser_status hawser_scene_set(struct hawser_scene *scene, const char *path, double value,
                                    struct hawser_report *report)
{
	double before, pair[2];
	enum hawser_status status = hawser_scene_get(scene, &before, path, report);
	int element, item, index = locate(scene, path, &element, &item), whole;
	const struct hawser__tree_key *row;
	char *at;

	if (status)
		return status;
	row = hawser__row(index);
	at = hawser__field(scene, index, item);
	memcpy(&whole, at + (row->type == HAWSER__TREE_POSITION ? sizeof(double) : 0), sizeof whole);
	if (!hawser__tree_in_range(row->range, value) ||
	    (row->type == HAWSER__TREE_POSITION && !hawser__tree_between(row->range, value, whole)) ||
	    (row->type == HAWSER__TREE_INTEGER &&
	     (value != nearbyint(value) || value < row->least || value > row->most)))
		return out_of_range(path, value, index, report);
	memcpy(pair, at, row->range == HAWSER__TREE_INCREASING ? sizeof pair : 0);
	if (row->range == HAWSER__TREE_INCREASING) {
		pair[element] = value;
		if (!(pair[0] < pair[1]))
			return out_of_range(path, value, index, report);
	}
	if (row->type == HAWSER__TREE_INTEGER) {
		whole = (int)value;
		memcpy(at, &whole, sizeof whole);
	} else {
		memcpy(at + (element > 0 ? (size_t)element : 0)*sizeof value, &value, sizeof value);
	}
	/* a negative index was refused above */
	/* NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult) */
	scene->written[index] = 1;
	return HAWSER_OK;
}

enum hawser_status hawser_scene_word(const struct hawser_scene *scene, char *word,
                                     const char *path, struct hawser_report *report)
{
	int index = hawser__key_find(path), choice;

	if (index < 0 || !hawser__is_word(scene, index))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "hawser_scene_word",
		                    "%.60s is not a key whose value is a word", path);
	if (!hawser__applies(scene, index))
		return absent(path, report);
	memcpy(&choice, (const char *)scene + hawser__row(index)->at, sizeof choice);
	hawser__word(word, HAWSER_WORD_SIZE, hawser_scene_key(index)->words, choice);
	return HAWSER_OK;
}

int hawser_scene_written(const struct hawser_scene *scene, const char *path)
{
	int index = hawser__key_find(path);

	return index >= 0 && scene->written[index];
}

void hawser_scene_clear(struct hawser_scene *scene)
{
	if (!scene)
		return;
	free(scene->name);
	memset(scene, 0, sizeof *scene);
}

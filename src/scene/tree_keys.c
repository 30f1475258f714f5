/* scene/tree_keys.c - the tables of keys of all kinds; which keys a mapping may have.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdio.h>
#include <string.h>

#include "core/append.h"
#include "core/spelling.h"
#include "scene/tree_keys.h"

#define TABLE(name, NAME) &hawser__tree_of_##name,
static const struct hawser__tree_table *const tables[] = {HAWSER_SCENE_KINDS(TABLE) TABLE(mesh, )};
enum { TABLES = sizeof tables/sizeof *tables };

const struct hawser__tree_table *hawser__tree_kind(enum hawser_kind kind)
{
	return kind > HAWSER_KIND_SPAN && kind < HAWSER_KIND_MODEL ? tables[kind - 1] : NULL;
}

const struct hawser__tree_table *hawser__tree_table(const char *of)
{
	size_t length = strcspn(of, ".");

	for (int i = 0; i < TABLES; i++)
		if (!strncmp(tables[i]->kind, of, length) && !tables[i]->kind[length])
			return tables[i];
	return NULL;
}

const struct hawser__tree_key *hawser__tree_row(int index)
{
	int i = 0;

	while (i < TABLES && index >= tables[i]->rows)
		index -= tables[i++]->rows;
	return i < TABLES && index >= 0 ? &tables[i]->row[index] : NULL;
}

const char *hawser__tree_key_of(const char *path, const char *of)
{
	size_t length = strlen(of);

	if (strncmp(path, of, length) != 0 || path[length] != '.' || strpbrk(path + length + 1, ".["))
		return NULL;
	return path + length + 1;
}

void hawser__tree_key_list(char *text, size_t size, const char *of)
{
	const struct hawser__tree_table *table = hawser__tree_table(of);
	const char *before = "", *key;

	*text = '\0';
	for (int i = 0; table && i < table->rows; i++) {
		const struct hawser__tree_key *row = &table->row[i];

		key = hawser__tree_key_of(row->path, of);
		/* another form of the same value */
		if (!key || row->need == HAWSER__TREE_MESH || !strcmp(row->path, before))
			continue;
		before = row->path;
		hawser__append(text, size, ", ", "%s", key);
	}
}

void hawser__tree_nearest(char best[HAWSER__TEXT_ROOM], const char *name, const char *keys)
{
	int least = hawser__edit_limit(strlen(name)) + 1;

	*best = '\0';
	while (*keys) {
		size_t length = strcspn(keys, ",");
		char key[HAWSER__TEXT_ROOM];
		int distance;

		snprintf(key, sizeof key, "%.*s", (int)length, keys);
		distance = hawser__edit_distance(name, key);
		if (distance < least) {
			least = distance;
			snprintf(best, HAWSER__TEXT_ROOM, "%s", key);
		}
		keys += length;
		keys += strspn(keys, ", ");
	}
}

static int among(const char *name, const char *keys)
{
	size_t own = strlen(name);

	while (*keys) {
		size_t length = strcspn(keys, ",");

		if (length == own && !strncmp(name, keys, own))
			return 1;
		keys += length;
		keys += strspn(keys, ", ");
	}
	return 0;
}

enum hawser_status hawser__tree_keys(struct hawser__reader *reader, const struct hawser__tree *tree,
                                     const char *what, const char *of)
{
	char shown[HAWSER__SHOWN], best[HAWSER__TEXT_ROOM], keys[HAWSER__TREE_LIST_SIZE];

	if (strchr(of, ',')) /* a list */
		snprintf(keys, sizeof keys, "%s", of);
	else
		hawser__tree_key_list(keys, sizeof keys, of);
	if (tree->kind != HAWSER__MAPPING)
		return hawser__reader_fail(reader, &tree->at, "%s must be a mapping with the keys %s", what,
		                           keys);
	for (const struct hawser__tree *child = tree->child; child; child = child->next) {
		if (among(child->name, keys))
			continue;
		hawser__tree_nearest(best, child->name, keys);
		return hawser__reader_fail(reader, &child->at, "unknown key %s: %s%s%s%s takes %s",
		                           hawser__shown(shown, child->name), *best ? "did you mean " : "",
		                           best, *best ? "? " : "", what, keys);
	}
	return HAWSER_OK;
}

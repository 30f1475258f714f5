/* scene/tree_keys.c - the tables of keys of all kinds; which keys a mapping may have.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include <hawser/document.h>

#include "core/append.h"
#include "core/spelling.h"
#include "scene/tree_keys.h"

#define TABLE(name, NAME) &hawser__tree_of_##name,
static const struct hawser__tree_table *const tables[] = {TABLE(span, ) HAWSER_SCENE_KINDS(TABLE)
                                                          TABLE(mesh, )};
enum { TABLES = sizeof tables/sizeof *tables };

const struct hawser__tree_table *hawser__tree_kind(enum hawser_kind kind)
{
	return kind >= HAWSER_KIND_SPAN && kind < HAWSER_KIND_MODEL ? tables[kind] : NULL;
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

const struct hawser__tree_key *hawser__tree_next(const struct hawser__tree_key *row, const char *path)
{
	const struct hawser__tree_table *table = hawser__tree_table(path);

	for (row = row ? row + 1 : table->row; row < table->row + table->rows; row++)
		if (!strcmp(row->path, path))
			return row;
	return NULL;
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
	const char *key;

	*text = '\0';
	for (int i = 0; table && i < table->rows; i++) {
		const struct hawser__tree_key *row = &table->row[i];

		key = hawser__tree_key_of(row->path, of);
		if (!key || row->need == HAWSER__TREE_MESH || hawser__tree_next(NULL, row->path) != row)
			continue;
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

/* The mapping of a path, "cable" of "span.cable.EA", into section [size]. */
static const char *section_of(char *section, size_t size, const char *path)
{
	const char *begin = path + strcspn(path, ".") + 1, *end = strrchr(path, '.');

	snprintf(section, size, "%.*s", end > begin ? (int)(end - begin) : 0, begin);
	return section;
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

/* Other names that keys are known by. */
static const struct {
	const char *name, *key;
} synonym[] = {
	{"mass", "rho"}, {"stiffness", "EA"}, {"length", "d"}, {"span", "d"}, {"rise", "h"},
	{"height", "h"}, {"pretension", "H"}, {"velocity", "speed"}, {"zeta", "ratio"}, {"xi", "ratio"},
	{"E", "EA"}, {"weight", "rho"}, {"L", "d"}, {"l", "d"}, {"T", "T0"}, {"force", "T0"},
	{"logdec", "ratio"}, {"decrement", "ratio"}, {"gravity", "g"}, {"v", "speed"},
	{"mass", "attach"}, {"damper", "attach"}, {"E", "EI"}, {"weight", "counterweight"}, {"len", "d"},
	{"len", "length"},
};

/* One of the keys by another name of it, or NULL. */
static const char *by_another_name(const char *name, const char *keys)
{
	for (size_t i = 0; i < sizeof synonym/sizeof *synonym; i++)
		if (strcmp(name, synonym[i].name) == 0 && among(synonym[i].key, keys))
			return synonym[i].key;
	return NULL;
}

/* Of a key at the top of scenes of another kind. */
static void of_another_kind(char hint[HAWSER__TEXT_ROOM], const char *name, const char *of)
{
#define WORD(word, WORD) #word,
	static const char *const kind[] = {"span", HAWSER_SCENE_KINDS(WORD)};
#undef WORD
	char keys[HAWSER__TREE_LIST_SIZE];

	for (size_t i = 0; i < sizeof kind/sizeof *kind && !strchr(of, '.') && !*hint; i++) {
		hawser__tree_key_list(keys, sizeof keys, kind[i]);
		if (strcmp(kind[i], of) != 0 && among(name, keys))
			snprintf(hint, HAWSER__TEXT_ROOM, "scenes of the kind %s have it; ", kind[i]);
	}
}

enum { ELSEWHERE = 4 }; /* edit distance to keys of other sections: two letters */

const char *hawser__tree_suggest(char hint[HAWSER__TEXT_ROOM], const char *name, const char *of,
                                 const char *keys)
{
	const struct hawser__tree_table *table = hawser__tree_table(of);
	const struct hawser__tree_key *near = NULL;
	const char *leaf = strrchr(name, '.') ? strrchr(name, '.') + 1 : name;
	int limit = hawser__edit_limit(strlen(leaf)), least = 2*(limit < ELSEWHERE ? limit : ELSEWHERE) + 2;
	char best[HAWSER__TEXT_ROOM], section[HAWSER__TEXT_ROOM];

	*hint = '\0';
	if (isdigit((unsigned char)*name))
		return strcpy(hint, "is it a decimal comma? A number has a decimal point; ");
	if (strchr(name, ':'))
		return strcpy(hint, "write a blank behind the colon; ");
	hawser__tree_nearest(best, name, leaf == name ? keys : "");
	if (by_another_name(name, keys))
		snprintf(best, sizeof best, "%s", by_another_name(name, keys));
	if (*best)
		snprintf(hint, HAWSER__TEXT_ROOM, "did you mean %.200s? ", best);
	for (int i = 0; !*best && table && i < table->rows; i++) {
		const struct hawser__tree_key *row = &table->row[i];
		const char *own = strrchr(row->path, '.') + 1;
		int cost = 2*hawser__edit_distance(leaf, own) + (strncmp(row->path, of, strlen(of)) != 0);

		if (cost >= least || strpbrk(own, "[*") || row->need == HAWSER__TREE_MESH ||
		    (cost > 1 && !leaf[1])) /* one letter is near every other */
			continue;
		least = cost;
		near = row;
	}
	if (!*best && !near)
		of_another_kind(hint, name, of);
	if (near)
		snprintf(hint, HAWSER__TEXT_ROOM, "did you mean %.60s %s%.60s? ", strrchr(near->path, '.') + 1,
		         *section_of(section, sizeof section, near->path) ? "under " : "at the top level",
		         section);
	return hint;
}

enum hawser_status hawser__tree_keys(struct hawser__reader *reader, const struct hawser__tree *tree,
                                     const char *what, const char *of)
{
	char path[2*HAWSER__TEXT_ROOM], shown[HAWSER__SHOWN], hint[HAWSER__TEXT_ROOM];
	char keys[HAWSER__TREE_LIST_SIZE];

	if (strchr(of, ',')) /* a list */
		snprintf(keys, sizeof keys, "%s", of);
	else
		hawser__tree_key_list(keys, sizeof keys, of);
	if (tree->kind != HAWSER__MAPPING)
		return hawser__reader_fail(reader, &tree->value, "%s must be a mapping with the keys %s", what,
		                           keys);
	for (const struct hawser__tree *child = tree->child; child; child = child->next) {
		if (among(child->name, keys))
			continue;
		snprintf(path, sizeof path, "%s%s%s", strcmp(what, "the scene") ? what : "",
		         strcmp(what, "the scene") ? "." : "", *child->name ? child->name : "\"\"");
		return hawser__reader_fail(reader, &child->at, "unknown key %s: %s%s takes %s",
		                           hawser__shown(shown, path),
		                           hawser__tree_suggest(hint, child->name, of, keys), what, keys);
	}
	return HAWSER_OK;
}

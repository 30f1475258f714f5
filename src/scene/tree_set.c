/* scene/tree_set.c - overrides of a tree: "cables.c1.EA=100 MN" puts a value in the place of another
 * one, "cables.c1.elements=" removes what is there.
 *
 * The table of keys says which mappings may be added on the way, and which keys exclude each other:
 * an override takes their place.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/report.h"
#include "scene/tree_keys.h"

/* Item of a list by its number or its `name`, entry of a mapping by its name. */
static struct hawser__tree *step_into(const struct hawser__tree *tree, const char *name,
                                      const struct hawser__tree_words *words)
{
	int number = 0;

	if (tree->kind != HAWSER__SEQUENCE)
		return hawser__tree_find(tree, name);
	for (struct hawser__tree *child = tree->child; child; child = child->next, number++) {
		const struct hawser__tree *called = hawser__tree_find(child, "name");
		char own[16];

		snprintf(own, sizeof own, "%c%d", words->item, number);
		if (!strcmp(own + 1, name) || !strcmp(called && called->text ? called->text : own, name))
			return child;
	}
	return NULL;
}

static const struct hawser__tree_key *row_of(const char *path)
{
	return hawser__tree_table(path) ? hawser__tree_next(NULL, path) : NULL;
}

/* Add to the path of a tree in the table what the part `name` of an override is there. */
static void descend(char path[HAWSER__TEXT_ROOM], const struct hawser__tree *tree, const char *name)
{
	size_t used = strlen(path), left = HAWSER__TEXT_ROOM - used;

	if (tree->kind == HAWSER__SEQUENCE) {
		snprintf(path + used, left, "[]");
		return;
	}
	snprintf(path + used, left, ".*");
	if (!row_of(path))
		snprintf(path + used, left, ".%.*s", (int)(left > 2 ? left - 2 : 0), name);
}

/* Is a value of this path a mapping, or may it be one? */
static int may_be_mapping(const char *path)
{
	const struct hawser__tree_key *row = row_of(path);

	while (row && row->type != HAWSER__TREE_MAPPING)
		row = hawser__tree_next(row, path);
	return row != NULL;
}

/* The default of a list of numbers, such as "[0, 0, 0]", at the place `name`, of which an override
 * sets one; NULL: there is none. */
static struct hawser__tree *add_default(struct hawser__tree *tree, const char *name,
                                        const struct hawser__tree_key *row)
{
	struct hawser__tree *fresh = NULL;
	double unused[4];

	if (!row || !row->count || !row->given || !hawser__tree_default(unused, row->count, row->given))
		return NULL;
	if (!hawser__tree_parse(&fresh, row->given, strlen(row->given)) || !(fresh->name = strdup(name))) {
		hawser__tree_clear(fresh);
		return NULL;
	}
	hawser__tree_append(tree, fresh);
	return fresh;
}

static struct hawser__tree *add(struct hawser__tree *tree, const char *name,
                                const struct hawser__mark *at)
{
	struct hawser__tree *fresh = calloc(1, sizeof *fresh);

	if (fresh && !(fresh->name = strdup(name))) {
		free(fresh);
		fresh = NULL;
	}
	if (!fresh)
		return NULL;
	fresh->kind = HAWSER__MAPPING;
	fresh->at = *at;
	hawser__tree_append(tree, fresh);
	return fresh;
}

static void take_out(struct hawser__tree *tree, struct hawser__tree *child)
{
	struct hawser__tree *before = NULL;

	for (struct hawser__tree *one = tree->child; one != child; one = one->next)
		before = one;
	if (before)
		before->next = child->next;
	else
		tree->child = child->next;
	if (tree->last == child)
		tree->last = before;
	tree->children--;
	child->next = NULL;
	hawser__tree_clear(child);
}

/* Take out the keys of a mapping that exclude the one of this row (NULL: there is none). */
static void displace(struct hawser__tree *tree, const struct hawser__tree_key *row)
{
	size_t length = row ? (size_t)(strrchr(row->path, '.') - row->path) : 0;

	if (!row || (row->need != HAWSER__TREE_ONE_OF && row->need != HAWSER__TREE_AT_MOST_ONE))
		return;
	for (struct hawser__tree *one = tree->child, *after; one; one = after) {
		char path[HAWSER__TEXT_ROOM];
		const struct hawser__tree_key *other;

		after = one->next;
		snprintf(path, sizeof path, "%.*s.%.100s", (int)length, row->path, one->name);
		other = row_of(path);
		if (other && other->need == row->need && other->pick == row->pick &&
		    strcmp(path, row->path) != 0)
			take_out(tree, one);
	}
}

static enum hawser_status unknown(struct hawser__reader *reader, const struct hawser__mark *at,
                                  const struct hawser__tree *tree, const char *name, const char *path,
                                  const struct hawser__tree_words *words)
{
	char keys[HAWSER__TREE_LIST_SIZE] = "", hint[HAWSER__TEXT_ROOM], shown[HAWSER__SHOWN];

	if (tree->kind == HAWSER__MAPPING)
		hawser__tree_key_list(keys, sizeof keys, path);
	for (const struct hawser__tree *one = tree->child; one; one = one->next) {
		const struct hawser__tree *called = hawser__tree_find(one, "name");
		const char *own = called ? called->text : one->name;

		if (own)
			hawser__append(keys, sizeof keys, ", ", "%s", own);
	}
	if (tree->kind == HAWSER__SEQUENCE)
		return hawser__reader_fail(reader, at, "%s has %d item%s, numbered from 0, and none has the "
		                           "number or name %s%s%s", strchr(path, '.') + 1, tree->children,
		                           tree->children == 1 ? "" : "s", hawser__shown(shown, name),
		                           *keys ? ": its names are " : "", keys);
	return hawser__reader_fail(reader, at, "the scene has no place %s here: %swrite names and "
	                           "numbers joined by dots, such as %s",
	                           *name ? hawser__shown(shown, name) : "\"\"",
	                           hawser__tree_suggest(hint, name, path, keys), words->set);
}

/* Put the tree `fresh`, which is used up, in the place of `name` in a tree. NULL: take out what is
 * there. */
static enum hawser_status put(struct hawser__tree *tree, struct hawser__reader *reader,
                              struct hawser__tree *fresh, const char *name,
                              const struct hawser__tree_key *row,
                              const struct hawser__tree_words *words)
{
	struct hawser__tree *old = step_into(tree, name, words);

	if (!fresh) {
		if (old)
			take_out(tree, old);
		return HAWSER_OK;
	}
	if (!old)
		old = add(tree, name, &fresh->at);
	if (!old) {
		hawser__tree_clear(fresh);
		return hawser__no_memory(reader->report, "scene");
	}
	displace(tree, row);
	hawser__tree_clear(old->child);
	free(old->text);
	old->kind = fresh->kind;
	old->text = fresh->text;
	old->child = fresh->child;
	old->last = fresh->last;
	old->children = fresh->children;
	old->at = old->value = fresh->at;
	free(fresh);
	return HAWSER_OK;
}

/* Follow a path, whose dots are overwritten. */
static enum hawser_status walk(struct hawser__tree *root, struct hawser__reader *reader,
                               struct hawser__tree *fresh, char *name,
                               const struct hawser__tree_words *words)
{
	const struct hawser__mark here = {.pass = reader->pass, .set = reader->set, .line = 1};
	struct hawser__tree *tree = root;
	char path[HAWSER__TEXT_ROOM], below[HAWSER__TEXT_ROOM];

	snprintf(path, sizeof path, "%s", words->table);
	for (char *dot; tree; name = dot + 1) {
		struct hawser__tree *next;

		dot = strchr(name, '.');
		if (dot)
			*dot = '\0';
		next = step_into(tree, name, words);
		snprintf(below, sizeof below, "%s", path);
		descend(below, tree, name);
		if (!next && (tree->kind != HAWSER__MAPPING || !*name || (!row_of(below) && (dot || !fresh)))) {
			hawser__tree_clear(fresh);
			return unknown(reader, &here, tree, name, path, words);
		}
		memcpy(path, below, sizeof path);
		if (!dot)
			return put(tree, reader, fresh, name, row_of(path), words);
		if (!next && !fresh)
			return HAWSER_OK;
		if (fresh)
			displace(tree, row_of(path));
		tree = next ? next : may_be_mapping(path) ? add(tree, name, &here)
		       : add_default(tree, name, row_of(path));
	}
	hawser__tree_clear(fresh);
	return hawser__reader_fail(reader, &here, "%s is no mapping: give its whole value", path);
}

enum hawser_status hawser__tree_set(struct hawser__tree *root, struct hawser__reader *reader,
                                    const char *set, const struct hawser__tree_words *words)
{
	const char *equals = strchr(set, '=');
	struct hawser__tree *fresh = NULL;
	char path[HAWSER__TEXT_ROOM];
	size_t length;
	enum hawser_status status = HAWSER_OK;

	reader->set = set;
	reader->pass++;
	set += strspn(set, " ");
	length = equals && equals > set ? (size_t)(equals - set) : 0;
	while (length && set[length - 1] == ' ')
		length--;
	if (!equals || length >= sizeof path)
		return hawser__reader_fail(reader, &(struct hawser__mark){.set = reader->set},
		                           "write KEY=VALUE, such as %s", words->set);
	memcpy(path, set, length);
	path[length] = '\0';
	if (!hawser__path_plain(path))
		return hawser__reader_fail(reader, &(struct hawser__mark){.set = reader->set},
		                           "a bracket of the key is open or empty: write names and "
		                           "numbers joined by dots, such as %s", words->set);
	if (equals[1 + strspn(equals + 1, " ")])
		status = hawser__tree_document(&fresh, reader, equals + 1, strlen(equals + 1));
	if (!status && !fresh && equals[1 + strspn(equals + 1, " ")])
		status = hawser__reader_fail(reader, &(struct hawser__mark){.set = reader->set},
		                             "%s has no value: write %s=VALUE", path, path);
	if (status) {
		hawser__tree_clear(fresh);
		return status;
	}
	if (fresh)
		fresh->at.set = reader->set;
	return walk(root, reader, fresh, path, words);
}

/* scene/parse.c - parser for documents and mappings, driven by the table of keys. It descends only
 * where the table has a key, so that the depth is bounded by the table and the cost by the length
 * of the text. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdio.h>
#include <string.h>

#include "core/report.h"
#include "scene/reader.h"
#include "scene/suggest.h"
#include "scene/tree.h"

static const char *path_of(int index)
{
	return hawser_scene_key(index)->path;
}

size_t hawser__parse_size(const struct hawser__row *row)
{
	int count = hawser__type_count(row->type);

	if (row->type == HAWSER__WORD || row->type == HAWSER__INTEGER)
		return sizeof(int);
	if (row->type == HAWSER__SERIES)
		return HAWSER_RATIOS*sizeof(double) + sizeof(int);
	return (size_t)(count ? count : 1)*sizeof(double);
}

void hawser__parse_forget(struct hawser__reader *reader, int index)
{
	const struct hawser__row *row = &hawser__rows()[index];

	memset((char *)reader->scene + row->offset, 0, hawser__parse_size(row)); /* never of an item */
	reader->key[index] = (struct hawser__mark){0};
	reader->scene->written[index] = 0;
}

/* An override of one member of a group removes the others. tension.branch applies to T0 and T1 only
 * and is removed with them. */
static void displace(struct hawser__reader *reader, enum hawser__group group, int member)
{
	int branch = hawser__key_find("tension.branch");

	for (int i = 0; hawser_scene_key(i); i++)
		if (hawser__rows()[i].group == group && hawser__rows()[i].member != member)
			hawser__parse_forget(reader, i);
	if (group == HAWSER__TENSION && member != HAWSER_GIVEN_T0 && member != HAWSER_GIVEN_T1 &&
	    reader->key[branch].pass < reader->pass)
		hawser__parse_forget(reader, branch);
}

/* The key of this group that was already given in this pass, or -1. */
static int rival(const struct hawser__reader *reader, enum hawser__group group, int member)
{
	for (int i = 0; hawser_scene_key(i); i++)
		if (hawser__rows()[i].group == group && hawser__rows()[i].member != member &&
		    reader->key[i].pass == reader->pass)
			return i;
	return -1;
}

/* Record that a key is given; fail if it contradicts another key. */
static enum hawser_status claim(struct hawser__reader *reader, int index,
                                const struct hawser__mark *place)
{
	const struct hawser__row *row = &hawser__rows()[index];
	struct hawser__mark *mine = &reader->key[index];
	int other = row->group ? rival(reader, row->group, row->member) : -1;
	char where[48];

	if (other >= 0)
		return hawser__reader_fail(reader, place, "%s contradicts %s %s: give %s",
		                           path_of(index), path_of(other),
		                           hawser__mark_text(where, sizeof where, &reader->key[other]),
		                           hawser__choice(row->group)->rule);
	if (row->group) {
		displace(reader, row->group, row->member);
		hawser__choose(reader->scene, row->group, row->member);
	}
	*mine = *place;
	mine->pass = reader->pass;
	reader->scene->written[index] = 1;
	return HAWSER_OK;
}

enum hawser_status hawser__parse_unknown(struct hawser__reader *reader,
                                         const struct hawser__mark *place, const char *path)
{
	struct hawser__kind_sign sign;
	size_t length = strcspn(path, ".");
	char hint[256], shown[HAWSER__SHOWN];

	for (int i = 0; hawser__kind_sign(&sign, i); i++)
		if (!strncmp(path, sign.key, length) && !sign.key[length])
			return hawser__reader_fail(reader, place, "%s is a key of another kind of scenes (%s), and "
			                           "this one is read as a span: see hawser-scene(5)", sign.key,
			                           hawser_kind_name(!strcmp(sign.key, "kind") ? reader->kind
			                                            : sign.kind));
	hawser__suggest(hint, sizeof hint, path);
	return hawser__reader_fail(reader, place, "unknown key %s: %s",
	                           *path ? hawser__shown(shown, path) : "\"\"", hint);
}

enum hawser_status hawser__parse_value(struct hawser__reader *reader, const char *path,
                                       const struct hawser__tree *tree)
{
	int key = hawser__key_find(path), section = hawser__section_find(path);
	int list = hawser__list_find(path);
	char hint[256];
	enum hawser_status status;

	if (list >= 0 && !strchr(path, '.'))
		return hawser__items_read(reader, list, tree);
	if (!strcmp(path, "kind") && reader->pass == 1 && tree->text && !strcmp(tree->text, "span"))
		return HAWSER_OK; /* spans need not say so */
	if (key < 0 && section < 0)
		return hawser__parse_unknown(reader, &tree->at, path);
	if (key >= 0) {
		status = claim(reader, key, &tree->at);
		return status ? status : hawser__value_read(reader, tree, key);
	}
	reader->section[section] = tree->at;
	if (tree->kind == HAWSER__MAPPING)
		return hawser__parse_mapping(reader, path, tree);
	hawser__list(hint, sizeof hint, path);
	return hawser__reader_fail(reader, &tree->value, "%s is %s, but must be a mapping: %s", path,
	                           tree->kind == HAWSER__SEQUENCE ? "a list" : "a single value", hint);
}

/* Fail for a name with a dot, which must not be looked up in the table. */
static enum hawser_status dotted(struct hawser__reader *reader,
                                 const struct hawser__mark *place, const char *path)
{
	if (hawser__key_find(path) < 0)
		return hawser__parse_unknown(reader, place, path);
	return hawser__reader_fail(reader, place, "unknown key %s: in a file write %s under %.*s",
	                           path, hawser__leaf(path), (int)hawser__parent_length(path),
	                           path);
}

enum hawser_status hawser__parse_mapping(struct hawser__reader *reader, const char *section,
                                         const struct hawser__tree *tree)
{
	enum hawser_status status = HAWSER_OK;
	char path[2*HAWSER__TEXT_ROOM];

	for (const struct hawser__tree *child = tree->child; child && !status; child = child->next) {
		snprintf(path, sizeof path, "%s%s%s", section, *section ? "." : "", child->name);
		status = strchr(child->name, '.') ? dotted(reader, &child->at, path)
		                                  : hawser__parse_value(reader, path, child);
	}
	return status;
}

/* The top level of the document: a mapping. An empty document is nothing, or one empty scalar. */
static enum hawser_status top(struct hawser__reader *reader, const struct hawser__tree *tree)
{
	reader->root = tree ? tree->value : (struct hawser__mark){.pass = 1};
	if (!tree || (tree->kind == HAWSER__SCALAR && !*tree->text))
		return hawser__reader_fail(reader, &reader->root, "the scene is empty: it needs at least "
		                           "cable, span and tension (see hawser-scene(5))");
	if (tree->kind != HAWSER__MAPPING)
		return hawser__reader_fail(reader, &reader->root,
		                           "a scene is a mapping of keys to values, such as "
		                           "\"cable: {EA: 400 MN, rho: 6 kg/m}\"");
	return hawser__parse_mapping(reader, "", tree);
}

enum hawser_status hawser__parse_file(struct hawser__reader *reader,
                                      const struct hawser_document *from)
{
	struct hawser__tree *own = NULL;
	enum hawser_status status = HAWSER_OK;

	reader->set = NULL;
	reader->pass = 1;
	if (!from->tree) /* it tells why there is none */
		status = hawser__tree_document(&own, reader, from->text, from->length);
	if (!status)
		status = top(reader, own ? own : from->tree);
	hawser__tree_clear(own);
	return status;
}

/* Read the text after "path=" as the value of path. An empty text takes out what is there. */
static enum hawser_status assign(struct hawser__reader *reader, char *path, const char *text)
{
	const struct hawser__mark place = {.pass = reader->pass, .set = reader->set, .line = 1};
	char parent[HAWSER__TEXT_ROOM], whole[2*HAWSER__TEXT_ROOM];
	struct hawser__tree *tree = NULL;
	int list, item, element;
	enum hawser_status status;

	snprintf(parent, sizeof parent, "%s", path);
	element = hawser__path_element(parent);
	if (text[strspn(text, " ")] && element >= 0 &&
	    hawser__parse_element(whole, sizeof whole, reader->scene, parent, element, text)) {
		path = parent;
		text = whole;
	}
	list = hawser__list_find(path);
	item = list >= 0 && strchr(path, '.');
	if (!text[strspn(text, " ")])
		return hawser__parse_take_out(reader, path, &place);
	if (hawser__key_find(path) < 0 && hawser__section_find(path) < 0 && list < 0)
		return hawser__parse_unknown(reader, &place, path);
	status = hawser__tree_document(&tree, reader, text, strlen(text));
	if (!status && !tree)
		status = hawser__reader_fail(reader, &place, "%s has no value: write %s=VALUE", path, path);
	if (!status) {
		tree->at = place;
		status = item ? hawser__items_set(reader, list, path, tree)
		              : hawser__parse_value(reader, path, tree);
	}
	hawser__tree_clear(tree);
	return status;
}

enum hawser_status hawser__parse_override(struct hawser__reader *reader, const char *set)
{
	const char *equals = strchr(set, '=');
	const char *first = set + strspn(set, " ");
	size_t length;
	char path[HAWSER__TEXT_ROOM];
	struct hawser__mark place;

	reader->set = set;
	reader->pass++;
	place = (struct hawser__mark){.pass = reader->pass, .set = set, .line = 1};
	if (!equals)
		return hawser__reader_fail(reader, &place,
		                           "write KEY=VALUE, such as cable.EA=400 MN");
	length = first < equals ? (size_t)(equals - first) : 0;
	while (length && first[length - 1] == ' ')
		length--;
	if (length >= sizeof path)
		return hawser__reader_fail(reader, &place, "no key is that long: write KEY=VALUE");
	memcpy(path, first, length);
	path[length] = '\0';
	if (!hawser__path_plain(path))
		return hawser__reader_fail(reader, &place, "a bracket of the key is open or empty: write names "
		                           "and numbers joined by dots, such as attach.0.mass=25 kg");
	return assign(reader, path, equals + 1);
}

enum hawser_status hawser__parse_defaults(struct hawser__reader *reader)
{
	const struct hawser_scene_key *key;
	unsigned char written[HAWSER_SCENE_KEYS];
	char path[HAWSER__TEXT_ROOM];
	enum hawser_status status = HAWSER_OK;

	memcpy(written, reader->scene->written, sizeof written);
	for (int i = 0; status == HAWSER_OK && (key = hawser_scene_key(i)); i++) {
		if (!key->fallback || hawser__list_of(i) || written[i])
			continue;
		reader->set = key->fallback;
		reader->pass++;
		snprintf(path, sizeof path, "%s", key->path);
		status = assign(reader, path, key->fallback);
	}
	memcpy(reader->scene->written, written, sizeof written);
	return status;
}

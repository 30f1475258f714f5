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

/* The place of the earlier of two keys, for a message about the later one. */
static const char *earlier(char *text, size_t size, const struct hawser__mark *first)
{
	if (first->set)
		snprintf(text, size, "in the same override");
	else
		snprintf(text, size, "in line %zu", first->line);
	return text;
}

static enum hawser_status twice(struct hawser__reader *reader, const struct hawser__mark *place,
                                const struct hawser__mark *first, const char *path)
{
	char where[48];

	return hawser__reader_fail(reader, place, "duplicate key %s, already given %s: keep one",
	                           path, earlier(where, sizeof where, first));
}

/* Record that a key is given; fail if it is a duplicate or contradicts another key. */
static enum hawser_status claim(struct hawser__reader *reader, int index,
                                const struct hawser__mark *place)
{
	const struct hawser__row *row = &hawser__rows()[index];
	struct hawser__mark *mine = &reader->key[index];
	int other = row->group ? rival(reader, row->group, row->member) : -1;
	char where[48];

	if (mine->pass == reader->pass)
		return twice(reader, place, mine, path_of(index));
	if (other >= 0)
		return hawser__reader_fail(reader, place, "%s contradicts %s %s: give %s",
		                           path_of(index), path_of(other),
		                           earlier(where, sizeof where, &reader->key[other]),
		                           hawser__choice(row->group)->rule);
	if (row->group) {
		displace(reader, row->group, row->member);
		hawser__choose(reader->scene, row->group, row->member);
	}
	*mine = *place;
	reader->scene->written[index] = 1;
	return HAWSER_OK;
}

static enum hawser_status claim_section(struct hawser__reader *reader, int index,
                                        const struct hawser__mark *place)
{
	struct hawser__mark *mine = &reader->section[index];
	size_t count;

	if (mine->pass == reader->pass)
		return twice(reader, place, mine, hawser__sections(&count)[index].path);
	*mine = *place;
	return HAWSER_OK;
}

enum hawser_status hawser__parse_unknown(struct hawser__reader *reader,
                                         const struct hawser__mark *place, const char *path)
{
	const struct hawser__kind_sign *sign;
	size_t length = strcspn(path, ".");
	char hint[256], shown[HAWSER__SHOWN];

	for (int i = 0; (sign = hawser__kind_sign(i)); i++)
		if (!strncmp(path, sign->key, length) && !sign->key[length])
			return hawser__reader_fail(reader, place, "%s is a key of another kind of scenes (%s), and "
			                           "this one is read as a span: see hawser-scene(5)", sign->key,
			                           hawser_kind_name(!strcmp(sign->key, "kind") ? reader->kind
			                                            : sign->kind));
	hawser__suggest(hint, sizeof hint, path);
	return hawser__reader_fail(reader, place, "unknown key %s: %s",
	                           *path ? hawser__shown(shown, path) : "\"\"", hint);
}

/* The kind of scene: this reader is for spans, which need not say so. */
static enum hawser_status kind(struct hawser__reader *reader, const struct hawser__mark *place)
{
	yaml_event_t event;
	enum hawser_status status = hawser__event_next(reader, &event);

	if (status != HAWSER_OK)
		return status;
	if (event.type != YAML_SCALAR_EVENT || strcmp((const char *)event.data.scalar.value, "span"))
		status = hawser__parse_unknown(reader, place, "kind");
	yaml_event_delete(&event);
	return status;
}

/* Read the value of `path`, whose name is at `place`: the value of a key or the mapping of a
 * section. */
enum hawser_status hawser__parse_value(struct hawser__reader *reader, const char *path,
                                       const struct hawser__mark *place)
{
	int key = hawser__key_find(path), section = hawser__section_find(path);
	int list = hawser__list_find(path);
	yaml_event_t event;
	enum hawser_status status;

	if (list >= 0 && !strchr(path, '.'))
		return hawser__items_read(reader, list, place);
	if (!strcmp(path, "kind") && reader->pass == 1)
		return kind(reader, place);
	if (key < 0 && section < 0)
		return hawser__parse_unknown(reader, place, path);
	status = key >= 0 ? claim(reader, key, place) : claim_section(reader, section, place);
	if (status != HAWSER_OK)
		return status;
	status = hawser__event_next(reader, &event);
	if (status != HAWSER_OK)
		return status;
	if (key >= 0) {
		status = hawser__value_read(reader, &event, key);
	} else if (event.type == YAML_MAPPING_START_EVENT) {
		status = hawser__parse_mapping(reader, path);
	} else {
		char hint[256];
		struct hawser__mark here = hawser__event_place(reader, &event);

		hawser__list(hint, sizeof hint, path);
		status = hawser__reader_fail(reader, &here,
		                             "%s is %s, but must be a mapping: %s", path,
		                             event.type == YAML_SEQUENCE_START_EVENT
		                                     ? "a list" : "a single value", hint);
	}
	yaml_event_delete(&event);
	return status;
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

/* Read one "key: value" of a section; *end is 1 at the end of the mapping. */
static enum hawser_status pair(struct hawser__reader *reader, int *end, const char *section)
{
	char name[HAWSER__TEXT_ROOM], path[2*HAWSER__TEXT_ROOM];
	struct hawser__mark place;
	yaml_event_t event;
	enum hawser_status status = hawser__event_next(reader, &event);

	if (status != HAWSER_OK)
		return status;
	place = hawser__event_place(reader, &event);
	*end = event.type == YAML_MAPPING_END_EVENT;
	if (!*end && event.type != YAML_SCALAR_EVENT)
		status = hawser__reader_fail(reader, &place, "a key must be a word, not a %s",
		                             event.type == YAML_SEQUENCE_START_EVENT ? "list"
		                                                                     : "mapping");
	else if (!*end)
		status = hawser__event_text(reader, name, &event, "this key");
	yaml_event_delete(&event);
	if (*end || status != HAWSER_OK)
		return status;
	snprintf(path, sizeof path, "%s%s%s", section, *section ? "." : "", name);
	return strchr(name, '.') ? dotted(reader, &place, path) : hawser__parse_value(reader, path, &place);
}

enum hawser_status hawser__parse_mapping(struct hawser__reader *reader, const char *section)
{
	enum hawser_status status = HAWSER_OK;
	int end = 0;

	while (status == HAWSER_OK && !end)
		status = pair(reader, &end, section);
	return status;
}

/* Skip the next event, which must be of this type; *here is its place. */
static enum hawser_status step(struct hawser__reader *reader, int *found, yaml_event_type_t type,
                               struct hawser__mark *here)
{
	yaml_event_t event;
	enum hawser_status status = hawser__event_next(reader, &event);

	if (status != HAWSER_OK)
		return status;
	*found = event.type == type;
	*here = hawser__event_place(reader, &event);
	yaml_event_delete(&event);
	return HAWSER_OK;
}

static enum hawser_status empty(struct hawser__reader *reader, const struct hawser__mark *place)
{
	return hawser__reader_fail(reader, place, "the scene is empty: it needs at least cable, "
	                                          "span and tension (see hawser-scene(5))");
}

/* Read the top level of the document: a mapping. An empty document is one empty scalar. */
static enum hawser_status top(struct hawser__reader *reader)
{
	yaml_event_t event;
	enum hawser_status status = hawser__event_next(reader, &event);

	if (status != HAWSER_OK)
		return status;
	reader->root = hawser__event_place(reader, &event);
	if (event.type == YAML_MAPPING_START_EVENT)
		status = hawser__parse_mapping(reader, "");
	else if (event.type == YAML_SCALAR_EVENT && event.data.scalar.length == 0)
		status = empty(reader, &reader->root);
	else
		status = hawser__reader_fail(reader, &reader->root,
		                             "a scene is a mapping of keys to values, such as "
		                             "\"cable: {EA: 400 MN, rho: 6 kg/m}\"");
	yaml_event_delete(&event);
	return status;
}

/* Read the end of the document and of the stream. */
static enum hawser_status finish(struct hawser__reader *reader)
{
	struct hawser__mark here;
	int found;
	enum hawser_status status = step(reader, &found, YAML_DOCUMENT_END_EVENT, &here);

	if (status == HAWSER_OK)
		status = step(reader, &found, YAML_STREAM_END_EVENT, &here);
	if (status != HAWSER_OK || found)
		return status;
	return hawser__reader_fail(reader, &here, "a second document begins here: a scene is one "
	                                          "document, so remove what follows");
}

/* Read up to the first event of the document; *any is 0 if the text has no document. */
static enum hawser_status start(struct hawser__reader *reader, int *any, yaml_parser_t *yaml,
                                const char *text, size_t length)
{
	struct hawser__mark here;
	enum hawser_status status;

	if (!yaml_parser_initialize(yaml))
		return hawser__no_memory(reader->report, "scene");
	reader->yaml = yaml;
	yaml_parser_set_input_string(yaml, (const unsigned char *)text, length);
	status = step(reader, any, YAML_STREAM_START_EVENT, &here);
	if (status == HAWSER_OK)
		status = step(reader, any, YAML_DOCUMENT_START_EVENT, &here);
	return status;
}

enum hawser_status hawser__parse_file(struct hawser__reader *reader, const char *text,
                                      size_t length)
{
	yaml_parser_t yaml;
	int any = 0;
	enum hawser_status status;

	memset(&yaml, 0, sizeof yaml);
	reader->set = NULL;
	reader->pass = 1;
	status = start(reader, &any, &yaml, text, length);
	if (status == HAWSER_OK && !any)
		status = empty(reader, &(struct hawser__mark){.pass = 1});
	if (status == HAWSER_OK)
		status = top(reader);
	if (status == HAWSER_OK)
		status = finish(reader);
	yaml_parser_delete(&yaml);
	return status;
}

/* Read the text after "path=" as the value of path. An empty text takes out what is there. */
static enum hawser_status assign(struct hawser__reader *reader, char *path, const char *text)
{
	const struct hawser__mark place = {.pass = reader->pass, .set = reader->set, .line = 1};
	yaml_parser_t yaml;
	char parent[HAWSER__TEXT_ROOM], whole[2*HAWSER__TEXT_ROOM];
	int any = 0, list, item, element;
	enum hawser_status status;

	snprintf(parent, sizeof parent, "%s", path);
	element = hawser__path_element(parent);
	if (text[strspn(text, " ")] && element >= 0 &&
	    hawser__parse_element(whole, sizeof whole, reader->scene, parent, element, text)) {
		path = parent;
		text = whole;
	}
	list = hawser__list_find(path);
	item = list >= 0 && hawser__list_row(list)->keys && strchr(path, '.');
	if (!text[strspn(text, " ")])
		return hawser__parse_take_out(reader, path, &place);
	if (list >= 0 && !item && strchr(path, '.'))
		return hawser__reader_fail(reader, &place, "%s: give the whole list, %s=[%s]", path,
		                           hawser__list_row(list)->name, hawser__list_row(list)->example);
	if (hawser__key_find(path) < 0 && hawser__section_find(path) < 0 && list < 0)
		return hawser__parse_unknown(reader, &place, path);
	memset(&yaml, 0, sizeof yaml);
	status = start(reader, &any, &yaml, text, strlen(text));
	if (status == HAWSER_OK && !any)
		status = hawser__reader_fail(reader, &place, "%s has no value: write %s=VALUE", path, path);
	if (status == HAWSER_OK)
		status = item ? hawser__items_set(reader, list, path, &place)
		              : hawser__parse_value(reader, path, &place);
	if (status == HAWSER_OK)
		status = finish(reader);
	yaml_parser_delete(&yaml);
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

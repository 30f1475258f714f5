/* scene/tree.c - see scene/tree.h. The depth is bounded, the events are those of scene/events.c (no
 * anchors, aliases, tags), and duplicate names of a mapping are found when it is complete.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "scene/tree.h"

enum { DEEPEST = 8, LARGEST = 1 << 28 };

void hawser__tree_clear(struct hawser__tree *tree)
{
	while (tree) {
		struct hawser__tree *next = tree->next;

		hawser__tree_clear(tree->child); /* at most DEEPEST levels */
		free(tree->name);
		free(tree->text);
		free(tree);
		tree = next;
	}
}

struct hawser__tree *hawser__tree_find(const struct hawser__tree *tree, const char *name)
{
	struct hawser__tree *child = tree ? tree->child : NULL;

	while (child && (!child->name || strcmp(child->name, name) != 0))
		child = child->next;
	return child;
}

const struct hawser__tree *hawser__tree_at(const struct hawser__tree *tree, const char *path)
{
	while (tree && *path) {
		size_t length = strcspn(path, ".");
		const struct hawser__tree *child = tree->child;

		while (child && (!child->name || strncmp(child->name, path, length) != 0 ||
		                 child->name[length]))
			child = child->next;
		tree = child;
		path += length + (path[length] == '.');
	}
	return tree;
}

void hawser__tree_append(struct hawser__tree *parent, struct hawser__tree *child)
{
	if (parent->last)
		parent->last->next = child;
	else
		parent->child = child;
	parent->last = child;
	parent->children++;
}

/* `path` names the value in messages; "" is the outermost one. */
static enum hawser_status value(struct hawser__tree **made, struct hawser__reader *reader,
                                const yaml_event_t *event, int depth, const char *path);

/* The name of an entry; *end is 1 at the end of the mapping. */
static enum hawser_status name_of(char name[HAWSER__TEXT_ROOM], struct hawser__mark *place, int *end,
                                  struct hawser__reader *reader)
{
	yaml_event_t event;
	enum hawser_status status = hawser__event_next(reader, &event);

	if (status)
		return status;
	*place = hawser__event_place(reader, &event);
	*end = event.type == YAML_MAPPING_END_EVENT;
	if (!*end && event.type != YAML_SCALAR_EVENT)
		status = hawser__reader_fail(reader, place, "a key must be a word, not a %s",
		                             event.type == YAML_SEQUENCE_START_EVENT ? "list" : "mapping");
	else if (!*end)
		status = hawser__event_text(reader, name, &event, "this key");
	yaml_event_delete(&event);
	return status;
}

static int by_name(const void *a, const void *b)
{
	return strcmp((*(struct hawser__tree *const *)a)->name, (*(struct hawser__tree *const *)b)->name);
}

static enum hawser_status no_twins(struct hawser__reader *reader, const struct hawser__tree *tree,
                                   const char *path)
{
	struct hawser__tree **list = malloc(((size_t)tree->children + 1)*sizeof(struct hawser__tree *));
	enum hawser_status status = HAWSER_OK;
	size_t count = 0;
	char shown[HAWSER__SHOWN], where[48];

	if (!list)
		return hawser__no_memory(reader->report, "scene");
	for (struct hawser__tree *child = tree->child; child; child = child->next)
		list[count++] = child;
	qsort(list, count, sizeof *list, by_name);
	for (size_t i = 1; i < count && !status; i++)
		if (!strcmp(list[i]->name, list[i - 1]->name)) {
			const struct hawser__mark *a = &list[i - 1]->at, *b = &list[i]->at;
			int later = a->line != b->line ? b->line > a->line : b->column > a->column;

			status = hawser__reader_fail(reader, later ? b : a, "duplicate key %s%s%s, already given "
			                             "%s: keep one", path, *path ? "." : "",
			                             hawser__shown(shown, list[i]->name),
			                             hawser__mark_text(where, sizeof where, later ? a : b));
		}
	free(list);
	return status;
}

static enum hawser_status entries(struct hawser__tree *tree, struct hawser__reader *reader, int depth,
                                  const char *path)
{
	enum hawser_status status = HAWSER_OK;

	for (int end = 0; !status && !end;) {
		char name[HAWSER__TEXT_ROOM], below[HAWSER__TEXT_ROOM];
		struct hawser__mark place;
		struct hawser__tree *child = NULL;
		yaml_event_t event;

		status = name_of(name, &place, &end, reader);
		if (status || end)
			break;
		status = hawser__event_next(reader, &event);
		if (status)
			break;
		snprintf(below, sizeof below, "%.120s%s%.120s", path, *path ? "." : "", name);
		status = value(&child, reader, &event, depth, below);
		yaml_event_delete(&event);
		if (!child)
			break;
		hawser__tree_append(tree, child);
		child->at = place;
		child->name = strdup(name);
		if (!child->name)
			status = hawser__no_memory(reader->report, "scene");
	}
	return status ? status : no_twins(reader, tree, path);
}

static enum hawser_status items(struct hawser__tree *tree, struct hawser__reader *reader, int depth,
                                const char *path)
{
	enum hawser_status status = HAWSER_OK;

	for (int end = 0; !status && !end;) {
		struct hawser__tree *child = NULL;
		yaml_event_t event;

		status = hawser__event_next(reader, &event);
		if (status)
			break;
		end = event.type == YAML_SEQUENCE_END_EVENT;
		if (!end)
			status = value(&child, reader, &event, depth, path);
		yaml_event_delete(&event);
		if (child)
			hawser__tree_append(tree, child);
	}
	return status;
}

static enum hawser_status value(struct hawser__tree **made, struct hawser__reader *reader,
                                const yaml_event_t *event, int depth, const char *path)
{
	struct hawser__tree *tree = calloc(1, sizeof *tree);
	char text[HAWSER__TEXT_ROOM];
	enum hawser_status status;

	*made = tree;
	if (!tree)
		return hawser__no_memory(reader->report, "scene");
	tree->at = tree->value = hawser__event_place(reader, event);
	if (depth > DEEPEST)
		return hawser__reader_fail(reader, &tree->at, "nothing in a scene is nested that deep");
	if (event->type == YAML_MAPPING_START_EVENT) {
		tree->kind = HAWSER__MAPPING;
		return entries(tree, reader, depth + 1, path);
	}
	if (event->type == YAML_SEQUENCE_START_EVENT) {
		tree->kind = HAWSER__SEQUENCE;
		return items(tree, reader, depth + 1, path);
	}
	status = hawser__event_text(reader, text, event, *path ? path : "this value");
	if (status)
		return status;
	tree->text = strdup(text);
	return tree->text ? HAWSER_OK : hawser__no_memory(reader->report, "scene");
}

enum hawser_status hawser__tree_document(struct hawser__tree **tree, struct hawser__reader *reader,
                                         const char *text, size_t length)
{
	yaml_parser_t yaml;
	enum hawser_status status = HAWSER_OK;

	*tree = NULL;
	memset(&yaml, 0, sizeof yaml);
	if (!yaml_parser_initialize(&yaml))
		return hawser__no_memory(reader->report, "scene");
	/* cppcheck-suppress autoVariables ; until it is NULL again, below */
	reader->yaml = &yaml;
	yaml_parser_set_input_string(&yaml, (const unsigned char *)text, length);
	for (int ended = 0; !status && !ended;) {
		yaml_event_t event;
		struct hawser__mark here;

		status = hawser__event_next(reader, &event);
		if (status)
			break;
		here = hawser__event_place(reader, &event);
		ended = event.type == YAML_STREAM_END_EVENT;
		if (event.type == YAML_DOCUMENT_START_EVENT && *tree)
			status = hawser__reader_fail(reader, &here, "a second document begins here: a scene is "
			                             "one document, so remove what follows");
		else if (event.type == YAML_SCALAR_EVENT || event.type == YAML_MAPPING_START_EVENT ||
		         event.type == YAML_SEQUENCE_START_EVENT)
			status = value(tree, reader, &event, 0, "");
		yaml_event_delete(&event);
	}
	yaml_parser_delete(&yaml);
	reader->yaml = NULL;
	return status;
}

int hawser__tree_parse(struct hawser__tree **tree, const char *text, size_t length)
{
	struct hawser__reader reader = {.name = "", .pass = 1};
	enum hawser_status status = HAWSER_ERR_SCENE;

	*tree = NULL;
	if (length <= LARGEST)
		status = hawser__tree_document(tree, &reader, text, length);
	hawser__units_clear(&reader.units);
	return !status;
}

static enum hawser_status copy(struct hawser__tree **made, const struct hawser__tree *from)
{
	struct hawser__tree *tree = calloc(1, sizeof *tree);

	*made = tree;
	if (!tree)
		return HAWSER_ERR_MEMORY;
	tree->kind = from->kind;
	tree->at = from->at;
	tree->value = from->value;
	if ((from->name && !(tree->name = strdup(from->name))) ||
	    (from->text && !(tree->text = strdup(from->text))))
		return HAWSER_ERR_MEMORY;
	for (const struct hawser__tree *child = from->child; child; child = child->next) {
		struct hawser__tree *twin;
		enum hawser_status status = copy(&twin, child); /* at most DEEPEST levels */

		if (twin)
			hawser__tree_append(tree, twin);
		if (status)
			return status;
	}
	return HAWSER_OK;
}

/* The tree of a document, or why it has none, with the overrides. */
static enum hawser_status tree_of(struct hawser__tree **tree, struct hawser__reader *reader,
                                  const struct hawser_document *from,
                                  const struct hawser__tree_words *words, const char *const *set,
                                  size_t nset)
{
	enum hawser_status status;

	reader->set = NULL;
	reader->pass = 1;
	if (from->tree && copy(tree, from->tree))
		return hawser__no_memory(reader->report, "scene");
	status = from->tree ? HAWSER_OK
	                    : hawser__tree_document(tree, reader, from->text, from->length);
	if (!status && (!*tree || (*tree)->kind != HAWSER__MAPPING))
		status = hawser__reader_fail(reader, &(struct hawser__mark){.pass = 1}, "%s", words->scene);
	for (size_t i = 0; i < nset && !status; i++)
		status = hawser__tree_set(*tree, reader, set[i], words);
	return status;
}

enum hawser_status hawser__tree_scene(void *scene, const struct hawser__tree_form *form,
                                      const struct hawser_document *from, const char *const *set,
                                      size_t nset, struct hawser_report *report)
{
	struct hawser__reader reader = {.report = report, .name = from->name, .kind = from->kind};
	struct hawser__tree *tree = NULL;
	char **name = (char **)(void *)((char *)scene + form->name);
	enum hawser_status status;

	memset(scene, 0, form->size);
	status = tree_of(&tree, &reader, from, &form->words, set, nset);
	if (!status)
		status = form->interpret(&reader, scene, tree);
	if (!status && !(*name = strdup(from->name)))
		status = hawser__no_memory(report, "scene");
	hawser__tree_clear(tree);
	hawser__units_clear(&reader.units);
	if (status)
		form->clear(scene);
	return status;
}

enum hawser_status hawser__tree_scene_open(void *scene, const struct hawser__tree_form *form,
                                           const char *path, const char *const *set, size_t nset,
                                           struct hawser_report *report)
{
	struct hawser_document from;
	enum hawser_status status = hawser_document_open(&from, path, report);

	memset(scene, 0, form->size);
	if (!status)
		status = hawser__tree_scene(scene, form, &from, set, nset, report);
	hawser_document_clear(&from);
	return status;
}

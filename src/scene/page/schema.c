/* scene/page/schema.c - the JSON Schema of scenes: those of the tables of keys (tree_keys.h), and
 * which kind a scene is of.
 *
 * Draft-07 is what the language servers of editors take. The kinds are told apart by if and else, as
 * the program does, so that a mistake is reported for one kind and not for all.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include <hawser/schema.h>

#include "core/report.h"
#include "scene/page/schema.h"
#include "scene/tree_keys.h"

#define DRAFT "http://json-schema.org/draft-07/schema#"

static json_t *value_of(struct hawser__schema *schema, const char *path);

/* The path whose keys a mapping or list has: of a mesh that of nets where it has none of its own. */
static const char *shared(char to[HAWSER__TREE_LIST_SIZE], const char *path)
{
	const char *of = strchr(path, '.');
	const struct hawser__tree_key *row;
	size_t length = strlen(path);

	if (!of || strncmp(path, "mesh.", (size_t)(of + 1 - path)) != 0)
		return path;
	for (int i = 0; (row = hawser__tree_row(i)); i++)
		if (!strncmp(row->path, path, length) && row->path[length])
			return path;
	snprintf(to, HAWSER__TREE_LIST_SIZE, "net%s", of);
	return to;
}

/* "sag (0) [m, > 0]" */
static json_t *described(const struct hawser__tree_key *row)
{
	const char *range = row->range ? hawser__tree_limits(row->range)->text : "";
	int number = row->type == HAWSER__TREE_NUMBER && row->unit && strcmp(row->unit, "1") != 0;
	int given = row->given && *row->given, both = number && *range, any = number || *range;

	return json_sprintf("%s%s%s%s%s%s%s%s%s", row->doc, given ? " (" : "", given ? row->given : "",
	                    given ? ")" : "", any ? " [" : "", number ? row->unit : "", both ? ", " : "",
	                    range, any ? "]" : "");
}

static json_t *list_of(struct hawser__schema *schema, const struct hawser__tree_key *row)
{
	json_t *list = hawser__schema_type(schema, "array");
	char item[HAWSER__TREE_LIST_SIZE], of[HAWSER__TREE_LIST_SIZE];

	snprintf(item, sizeof item, "%s[]", shared(of, row->path));
	hawser__schema_put(schema, list, "items", value_of(schema, item));
	if (row->most > 0.0)
		hawser__schema_put(schema, list, "maxItems", json_integer((long)row->most));
	return list;
}

static json_t *form_of(struct hawser__schema *schema, const struct hawser__tree_key *row)
{
	const struct hawser__tree_limits *limits = hawser__tree_limits(row->range);
	const struct hawser__schema_range range = {
		row->type == HAWSER__TREE_INTEGER ? row->least : limits->least,
		row->most > 0.0 ? row->most : limits->most, limits->above && row->least == 0.0,
		row->type == HAWSER__TREE_INTEGER};
	char of[HAWSER__TREE_LIST_SIZE];
	json_t *form = NULL;

	switch (row->type) {
	case HAWSER__TREE_NUMBER:
	case HAWSER__TREE_INTEGER:
		form = row->count ? hawser__schema_numbers(schema, row->count, row->unit, &range)
		                  : hawser__schema_number(schema, row->unit, &range);
		break;
	case HAWSER__TREE_POSITION: form = hawser__schema_number(schema, row->unit, &range); break;
	case HAWSER__TREE_LIMIT:
	case HAWSER__TREE_WORD: form = hawser__schema_words(schema, row->unit); break;
	case HAWSER__TREE_TEXT: form = hawser__schema_type(schema, "string"); break;
	case HAWSER__TREE_MAPPING: form = hawser__schema_of(schema, shared(of, row->path)); break;
	case HAWSER__TREE_LIST: form = list_of(schema, row); break;
	}
	hawser__schema_put(schema, form, "description", described(row));
	return form;
}

static int is_choice(const struct hawser__tree_key *row)
{
	return row->need == HAWSER__TREE_ONE_OF || row->need == HAWSER__TREE_AT_MOST_ONE ||
	       (row->need == HAWSER__TREE_MESH && row->type == HAWSER__TREE_MAPPING);
}

/* All forms of the value of this path. */
static json_t *value_of(struct hawser__schema *schema, const char *path)
{
	const struct hawser__tree_key *row;
	json_t *forms = json_array();

	for (int i = 0; (row = hawser__tree_row(i)); i++)
		if (!strcmp(row->path, path))
			hawser__schema_add(schema, forms, form_of(schema, row));
	return hawser__schema_any(schema, forms);
}

/* The keys of a mapping of which one must be given, those with the same `pick`, of which `first` is the
 * first one; or none. */
static void choose(struct hawser__schema *schema, json_t *mapping, const struct hawser__tree_key *first,
                   const char *path)
{
	json_t *list = json_array(), *none = json_object(), *some = json_object();
	const struct hawser__tree_key *row;

	for (int i = 0; (row = hawser__tree_row(i)); i++)
		if (is_choice(row) && row->pick == first->pick && hawser__tree_key_of(row->path, path) &&
		    hawser__tree_next(NULL, row->path) == row)
			hawser__schema_add(schema, list,
			                   hawser__schema_needs(schema, hawser__tree_key_of(row->path, path)));
	hawser__schema_put(schema, some, "anyOf", json_deep_copy(list));
	hawser__schema_put(schema, none, "not", some);
	if (first->need == HAWSER__TREE_AT_MOST_ONE)
		hawser__schema_add(schema, list, none);
	else
		json_decref(none);
	hawser__schema_put(schema, mapping, "oneOf", list);
}

json_t *hawser__schema_of(struct hawser__schema *schema, const char *path)
{
	const struct hawser__tree_key *row;
	json_t *mapping = hawser__schema_mapping(schema), *names = json_array(), *together = json_array();

	for (int i = 0; (row = hawser__tree_row(i)); i++) {
		const char *key = hawser__tree_key_of(row->path, path);

		if (!key || hawser__tree_next(NULL, row->path) != row)
			continue;
		if (*key == '*') { /* names of the user */
			hawser__schema_add(schema, names, value_of(schema, row->path));
			continue;
		}
		hawser__schema_key(schema, mapping, key, value_of(schema, row->path),
		                   row->need == HAWSER__TREE_REQUIRED);
		if (row->need == HAWSER__TREE_TOGETHER)
			hawser__schema_add(schema, together, json_string(key));
		if (is_choice(row) && !json_object_get(mapping, "oneOf"))
			choose(schema, mapping, row, path);
	}
	if (json_array_size(names))
		hawser__schema_put(schema, mapping, "additionalProperties", hawser__schema_any(schema, names));
	else
		json_decref(names);
	if (json_array_size(together))
		hawser__schema_together(schema, mapping, together);
	json_decref(together);
	return mapping;
}

#define WORD(name, NAME) #name,
static const char *const kinds[] = {"cable", "beam", HAWSER_SCENE_KINDS(WORD)};
enum { KINDS = sizeof kinds/sizeof *kinds };

int hawser_schema_key(char *key, int index)
{
	const struct hawser__tree_key *row = hawser__tree_row(index);
	size_t used = 0;

	*key = '\0';
	if (!row || row->type == HAWSER__TREE_MAPPING || row->type == HAWSER__TREE_LIST ||
	    strchr(row->path, '*'))
		return row != NULL;
	for (const char *at = strchr(row->path, '.') + 1; *at && used + 3 < HAWSER_SCHEMA_KEY; at++)
		if (*at != ']')
			used += (size_t)sprintf(key + used, *at == '[' ? ".0" : "%c", *at);
	return 1;
}

/* Spans that are meshes: in water, or over obstacles that are not all circles. */
static json_t *or_mesh(struct hawser__schema *schema, json_t *other, int obstacles)
{
	static const char *const flat[] = {"plane", "segment", "profile", "grid"};
	json_t *root = json_object(), *any = json_array(), *kinds_of = json_array();

	hawser__schema_add(schema, any, hawser__schema_needs(schema, "water"));
	for (size_t i = 0; i < sizeof flat/sizeof *flat; i++)
		hawser__schema_add(schema, kinds_of, hawser__schema_needs(schema, flat[i]));
	if (obstacles)
		hawser__schema_add(schema, any, json_pack("{s:{s:{s:{s:O}}}}", "properties", "obstacles",
		                                          "contains", "anyOf", kinds_of));
	json_decref(kinds_of);
	hawser__schema_put(schema, root, "if", json_pack("{s:o}", "anyOf", any));
	hawser__schema_put(schema, root, "then", hawser__schema_of(schema, "mesh"));
	hawser__schema_put(schema, root, "else", other);
	return root;
}

static json_t *kind_of(struct hawser__schema *schema, int index)
{
	const struct hawser__tree_table *table = hawser__tree_table(kinds[index]);
	json_t *root = table ? hawser__schema_of(schema, table->kind) : hawser__schema_span(schema, index);
	int obstacles = table && table == hawser__tree_kind(HAWSER_KIND_OBSTACLES);

	if (obstacles || index == 0)
		root = or_mesh(schema, root, obstacles);
	hawser__schema_put(schema, root, "title", json_string(
		table ? table->title : index ? "A travelling beam or string" : "A span of cable"));
	return root;
}

/* What the outermost mapping must have (hawser__kind_sign): the key, with this word if there is one. */
static json_t *condition(struct hawser__schema *schema, const char *key, const char *word)
{
	json_t *value = json_object(), *list = json_array(), *properties, *is;

	hawser__schema_add(schema, list, json_string(key));
	hawser__schema_put(schema, value, "required", list);
	if (!word)
		return value;
	properties = json_object();
	is = json_object();
	hawser__schema_put(schema, is, "const", json_string(word));
	hawser__schema_put(schema, properties, "kind", is);
	hawser__schema_put(schema, value, "properties", properties);
	return value;
}

static json_t *reference(struct hawser__schema *schema, const char *kind)
{
	json_t *value = json_object();

	hawser__schema_put(schema, value, "$ref", json_sprintf("#/definitions/%s", kind));
	return value;
}

/* {if sign, then kind, else ...}, from sign `index` on; beams and cables have no sign of their own. */
static json_t *choice(struct hawser__schema *schema, int index)
{
	struct hawser__kind_sign sign;
	int any = hawser__kind_sign(&sign, index);
	json_t *value = json_object();

	hawser__schema_put(schema, value, "if", any ? condition(schema, sign.key, sign.word)
	                                            : condition(schema, "beam", NULL));
	hawser__schema_put(schema, value, "then",
	                   reference(schema, !any ? "beam" : sign.kind == HAWSER_KIND_SPAN ? "cable"
	                                     : hawser_kind_name(sign.kind)));
	hawser__schema_put(schema, value, "else", any ? choice(schema, index + 1)
	                                              : reference(schema, "cable"));
	return value;
}

static json_t *all(struct hawser__schema *schema)
{
	json_t *root = choice(schema, 0), *definitions = json_object();

	for (int i = 0; i < KINDS; i++)
		hawser__schema_put(schema, definitions, kinds[i], kind_of(schema, i));
	hawser__schema_put(schema, root, "title", json_string("A scene of hawser"));
	hawser__schema_put(schema, root, "type", json_string("object"));
	hawser__schema_put(schema, root, "definitions", definitions);
	return root;
}

enum hawser_status hawser_schema_write(FILE *stream, const char *kind, struct hawser_report *report)
{
	struct hawser__schema schema = {0};
	enum hawser_status status = HAWSER_OK;
	json_t *root;
	int index = 0;

	while (kind && index < KINDS && strcmp(kinds[index], kind) != 0)
		index++;
	if (index == KINDS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "schema", "there is no kind %s of scenes: "
		                    "hawser schema --help names them", kind);
	root = kind ? kind_of(&schema, index) : all(&schema);
	hawser__schema_put(&schema, root, "$schema", json_string(DRAFT));
	if (schema.failed || !root)
		status = hawser__no_memory(report, "schema");
	else if (json_dumpf(root, stream, JSON_INDENT(1) | JSON_REAL_PRECISION(9)) ||
	         fputc('\n', stream) == EOF)
		status = hawser__fail(report, HAWSER_ERR_IO, "schema", "cannot write the schema");
	json_decref(root);
	return status;
}

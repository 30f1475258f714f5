/* scene/page/schema_span.c - the part of the JSON Schema about cables and beams, from the table of
 * keys.
 *
 * Rules of check.c that a schema can say are said: required keys, and keys that exclude each other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/keys.h"
#include "scene/page/schema.h"

static struct hawser__schema_range limits(enum hawser__range range)
{
	const struct hawser__schema_range none = {-INFINITY, INFINITY, 0, 0};

	switch (range) {
	case HAWSER__POSITIVE:
	case HAWSER__POSITIVE_OR_INF:
	case HAWSER__INSIDE: return (struct hawser__schema_range){0.0, INFINITY, 1, 0};
	case HAWSER__NOT_NEGATIVE:
	case HAWSER__NOT_NEGATIVE_OR_INF:
	case HAWSER__WITHIN: return (struct hawser__schema_range){0.0, INFINITY, 0, 0};
	case HAWSER__OPEN_UNIT: return (struct hawser__schema_range){0.0, 1.0, 1, 0};
	case HAWSER__INCREASING: return (struct hawser__schema_range){0.0, 1.0, 0, 0};
	case HAWSER__MODES: return (struct hawser__schema_range){1.0, 1000.0, 0, 1};
	case HAWSER__MULTIPLE: return (struct hawser__schema_range){1.0, 20.0, 0, 1};
	case HAWSER__BASIS: return (struct hawser__schema_range){0.0, 100000.0, 0, 1};
	case HAWSER__CHANGE: return (struct hawser__schema_range){-300.0, 300.0, 0, 0};
	case HAWSER__ANY:
	case HAWSER__RIGHT_ANGLE:
	case HAWSER__NAMES:
	case HAWSER__WORDS: break;
	}
	return none;
}

/* "axial stiffness (N; > 0; default 5)" */
static json_t *described(const struct hawser_scene_key *key)
{
	const char *unit = strcmp(key->unit, "1") ? key->unit : "";

	return json_sprintf("%s%s%s%s%s%s%s%s", key->doc, *unit || *key->range ? " (" : "", unit,
	                    *unit && *key->range ? "; " : "", key->range,
	                    *unit || *key->range ? ")" : "",
	                    key->fallback && *key->fallback ? "; default " : "",
	                    key->fallback ? key->fallback : "");
}

static json_t *value_of(struct hawser__schema *schema, int index)
{
	const struct hawser_scene_key *key = hawser_scene_key(index);
	const struct hawser__row *row = &hawser__rows()[index];
	const struct hawser__schema_range range = limits(row->range);
	json_t *forms = json_array(), *value, *list;

	if (key->words)
		hawser__schema_add(schema, forms, hawser__schema_words(schema, key->words));
	if (row->type == HAWSER__NUMBER || row->type == HAWSER__INTEGER || row->type == HAWSER__PLACE ||
	    row->type == HAWSER__SERIES)
		hawser__schema_add(schema, forms, hawser__schema_number(schema, key->unit, &range));
	if (row->type == HAWSER__PAIR || row->type == HAWSER__TRIPLE)
		hawser__schema_add(schema, forms, hawser__schema_numbers(schema, hawser__type_count(row->type),
		                                                         key->unit, &range));
	if (row->type == HAWSER__SERIES) {
		list = hawser__schema_type(schema, "array");
		hawser__schema_put(schema, list, "items", hawser__schema_number(schema, key->unit, &range));
		hawser__schema_add(schema, forms, list);
	}
	if (row->type == HAWSER__NAME)
		hawser__schema_add(schema, forms, hawser__schema_type(schema, "string"));
	value = hawser__schema_any(schema, forms);
	hawser__schema_put(schema, value, "description", described(key));
	return value;
}

/* A key may be missing that has a default or is one of a group. */
static int required(int index)
{
	return !hawser_scene_key(index)->fallback && !hawser__rows()[index].group;
}

/* Of the groups whose selector is in this section: exactly one member. */
static void choose(struct hawser__schema *schema, json_t *mapping, const char *section)
{
	size_t length = strlen(section);

	for (int g = 1; g < HAWSER__GROUPS; g++) {
		json_t *list, *before = NULL, *some;

		if (strcmp(hawser__choice((enum hawser__group)g)->section, section) != 0 ||
		    g == HAWSER__WEIGHT) /* of beams in SI only */
			continue;
		list = json_array();
		for (int i = 0; hawser_scene_key(i); i++) {
			char name[64];
			const char *rest = hawser_scene_key(i)->path + length + 1;
			json_t *one;

			if (hawser__rows()[i].group != (enum hawser__group)g)
				continue;
			snprintf(name, sizeof name, "%.*s", (int)strcspn(rest, "."), rest);
			one = hawser__schema_needs(schema, name);
			if (json_equal(one, before)) { /* a second key of rayleigh */
				json_decref(one);
				continue;
			}
			before = one;
			hawser__schema_add(schema, list, one);
		}
		if (g == HAWSER__DAMPING) { /* or none, with drag */
			json_t *none = hawser__schema_needs(schema, "drag"), *not = json_object();

			some = json_deep_copy(list);
			hawser__schema_put(schema, not, "anyOf", some);
			hawser__schema_put(schema, none, "not", not);
			hawser__schema_add(schema, list, none);
		}
		hawser__schema_put(schema, mapping, "oneOf", list);
	}
}

static json_t *section_of(struct hawser__schema *schema, const char *path, int complete);

/* The keys and sections directly in `path`. `complete`: 0: none is required. */
static void fill(struct hawser__schema *schema, json_t *mapping, const char *path, int complete)
{
	size_t sections;
	const struct hawser__section *section = hawser__sections(&sections);

	for (int i = 0; hawser_scene_key(i); i++)
		if (hawser__child_of(hawser_scene_key(i)->path, path))
			hawser__schema_key(schema, mapping, hawser__leaf(hawser_scene_key(i)->path),
			                   value_of(schema, i), complete && required(i));
	for (size_t s = 0; s < sections; s++)
		if (*path && hawser__child_of(section[s].path, path))
			hawser__schema_key(schema, mapping, hawser__leaf(section[s].path),
			                   section_of(schema, section[s].path, complete), 0);
}

/* A varying load needs all its keys, and load.static none of them. */
static void together(struct hawser__schema *schema, json_t *mapping)
{
	json_t *list = json_object_get(mapping, "required"), *rules = json_object();

	for (size_t i = 0; i < json_array_size(list); i++)
		hawser__schema_put(schema, rules, json_string_value(json_array_get(list, i)),
		                   json_deep_copy(list));
	json_object_del(mapping, "required");
	hawser__schema_put(schema, mapping, "dependencies", rules);
}

/* What each form of a beam needs besides the key that tells it. */
static void forms(struct hawser__schema *schema, json_t *mapping)
{
	struct hawser_scene *scene = calloc(1, sizeof *scene);
	json_t *rules = json_object(), *two = json_array();

	schema->failed |= !scene;
	for (int i = 0; scene && hawser_scene_key(i); i++) {
		json_t *needs, *rule;

		if (hawser__rows()[i].group != HAWSER__BEAM)
			continue;
		needs = json_array();
		hawser__choose(scene, HAWSER__BEAM, hawser__rows()[i].member);
		for (int k = 0; hawser_scene_key(k); k++)
			if (required(k) && hawser__child_of(hawser_scene_key(k)->path, "beam") &&
			    hawser__applies(scene, k))
				hawser__schema_add(schema, needs, json_string(hawser__leaf(hawser_scene_key(k)->path)));
		rule = json_object();
		hawser__schema_put(schema, rule, "required", needs);
		hawser__schema_put(schema, rules, hawser__leaf(hawser_scene_key(i)->path), rule);
		if (hawser__rows()[i].member == HAWSER_BEAM_EI) {
			for (int k = 0; hawser_scene_key(k); k++)
				if (hawser__rows()[k].group == HAWSER__WEIGHT)
					hawser__schema_add(schema, two, hawser__schema_needs(
						schema, hawser__leaf(hawser_scene_key(k)->path)));
			hawser__schema_put(schema, rule, "oneOf", two);
			two = NULL;
		}
	}
	json_decref(two);
	json_object_del(mapping, "required");
	hawser__schema_put(schema, mapping, "dependencies", rules);
	free(scene);
}

static json_t *section_of(struct hawser__schema *schema, const char *path, int complete)
{
	json_t *mapping = hawser__schema_mapping(schema);
	int section = hawser__section_find(path);
	size_t sections;

	if (section >= 0)
		hawser__schema_put(schema, mapping, "description",
		                   json_string(hawser__sections(&sections)[section].doc));
	fill(schema, mapping, path, complete);
	choose(schema, mapping, path);
	if (!strcmp(path, "load"))
		together(schema, mapping);
	if (!strcmp(path, "beam"))
		forms(schema, mapping);
	if (!strcmp(path, "damping.rayleigh")) { /* members of a group, both of which are needed */
		json_t *both = json_array();

		hawser__schema_add(schema, both, json_string("mass"));
		hawser__schema_add(schema, both, json_string("stiffness"));
		hawser__schema_put(schema, mapping, "required", both);
	}
	return mapping;
}

/* An item of the list of cases is a scene with few keys. */
static json_t *load_case(struct hawser__schema *schema)
{
	json_t *mapping = hawser__schema_mapping(schema), *load = hawser__schema_mapping(schema);

	hawser__schema_key(schema, load, "static", section_of(schema, "load.static", 0), 1);
	hawser__schema_key(schema, mapping, "name", hawser__schema_type(schema, "string"), 1);
	hawser__schema_key(schema, mapping, "load", load, 0);
	hawser__schema_key(schema, mapping, "temperature", section_of(schema, "temperature", 0), 0);
	return mapping;
}

static json_t *list_of(struct hawser__schema *schema, const struct hawser__items *list)
{
	json_t *value = hawser__schema_type(schema, "array"), *item;

	if (list->read) {
		item = load_case(schema);
	} else {
		item = section_of(schema, list->name, 0);
		if (list->required)
			hawser__schema_put(schema, item, "required",
			                   json_pack("[s]", hawser__leaf(list->required)));
	}
	hawser__schema_put(schema, value, "description", json_sprintf("each %s such as %s", list->one,
	                                                              list->example));
	hawser__schema_put(schema, value, "items", item);
	hawser__schema_put(schema, value, "maxItems", json_integer(list->most));
	return value;
}

json_t *hawser__schema_cable(struct hawser__schema *schema)
{
	json_t *mapping = hawser__schema_mapping(schema);
	const struct hawser__items *list;
	size_t sections;
	const struct hawser__section *section = hawser__sections(&sections);

	fill(schema, mapping, "", 1);
	for (size_t s = 0; s < sections; s++)
		if (!strchr(section[s].path, '.') && strcmp(section[s].path, "beam") != 0)
			hawser__schema_key(schema, mapping, section[s].path,
			                   section_of(schema, section[s].path, 1), section[s].required);
	for (int i = 0; (list = hawser__list_row(i)); i++)
		hawser__schema_key(schema, mapping, list->name, list_of(schema, list), 0);
	return mapping;
}

json_t *hawser__schema_beam(struct hawser__schema *schema)
{
	json_t *mapping = hawser__schema_mapping(schema);

	fill(schema, mapping, "", 1);
	hawser__schema_key(schema, mapping, "beam", section_of(schema, "beam", 1), 1);
	return mapping;
}

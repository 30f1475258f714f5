/* scene/span_read.c - read a span of cable, or a beam. The table of keys (span_rows.c) says most; here
 * are lists, and what is required of which scene. Rules over several keys are in check.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/report.h"
#include "scene/keys.h"
#include "scene/reader.h"
#include "scene/tree.h"

enum { SIZE_LIMIT = 1 << 20 };

/* A key of the outermost mapping that tells another kind of scenes. */
static enum hawser_status foreign(struct hawser__reader *reader, const struct hawser__tree *root)
{
	struct hawser__kind_sign sign;

	for (int i = 0; hawser__kind_sign(&sign, i); i++) {
		const struct hawser__tree *found = hawser__tree_find(root, sign.key);

		if (!found || (found->text && !strcmp(sign.key, "kind") && !strcmp(found->text, "span")))
			continue;
		return hawser__reader_fail(reader, &found->at, "%s is a key of another kind of scenes (%s), "
		                           "and this one is read as a span: see hawser-scene(5)", sign.key,
		                           hawser_kind_name(!strcmp(sign.key, "kind") ? reader->kind
		                                            : sign.kind));
	}
	return HAWSER_OK;
}

/* A key of at most `most` numbers that is given as a list. */
static enum hawser_status series(struct hawser__reader *reader, struct hawser_scene *scene,
                                 const struct hawser__tree *root, const char *key, int most)
{
	const struct hawser__tree *tree = hawser__tree_at(root, key);
	const struct hawser__tree_key *row = hawser__row(hawser__key_find(key));
	double *value = (double *)(void *)((char *)scene + row->at);
	enum hawser_status status = HAWSER_OK;
	int n = 0;

	if (!tree || tree->kind != HAWSER__SEQUENCE)
		return HAWSER_OK;
	if (tree->children < 1 || tree->children > most)
		return hawser__reader_fail(reader, &tree->value, "%s has %d values: give a "
		                           "number, or a list of 1 to %d numbers", key, tree->children, most);
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next, n++) {
		char what[40];

		snprintf(what, sizeof what, "%.20s[%d]", key, n);
		status = hawser__tree_number(reader, &value[n], one, what, "1", row->range);
	}
	*hawser__series(scene, row->at) = n;
	return status;
}

/* Names of cases are a word or a few; others are parts of keys and columns. */
static enum hawser_status name_of(struct hawser__reader *reader, char name[HAWSER_NAME_SIZE],
                                  const struct hawser__tree *tree, const char *what)
{
	const struct hawser__tree *given = hawser__tree_find(tree, "name");
	int is_case = !strncmp(what, "cases", 5);
	char called[64];
	const char *text;
	enum hawser_status status = HAWSER_OK;

	snprintf(called, sizeof called, "%.40s.name", what);
	if (!given)
		return is_case ? hawser__reader_fail(reader, &tree->at, "%s has no name: give it one, such as "
		                                     "name: ice", what) : HAWSER_OK;
	status = hawser__tree_text(reader, &text, given, called);
	if (status || !is_case)
		return status ? status : hawser__tree_name(reader, name, given, text, called);
	if (strlen(text) >= HAWSER_NAME_SIZE || strpbrk(text, "\"\\\t#{}[],:"))
		return hawser__reader_fail(reader, &given->value, "%s must be a word or a few, of at most %d "
		                           "characters, without quotes, tabs and \\ # { } [ ] , :", called,
		                           HAWSER_NAME_SIZE - 1);
	memcpy(name, text, strlen(text) + 1);
	return HAWSER_OK;
}

static enum hawser_status items(struct hawser__reader *reader, struct hawser_scene *scene,
                                const struct hawser__items *list, const struct hawser__tree *tree)
{
	int *count = hawser__list_count(list, scene);
	char what[40], of[40];
	enum hawser_status status = HAWSER_OK;

	snprintf(of, sizeof of, "span.%s[]", list->name);
	if (tree->kind != HAWSER__SEQUENCE)
		return hawser__reader_fail(reader, &tree->value, "%s must be a list of mappings, such as [%s]",
		                           list->name, list->example);
	if (tree->children > list->most)
		return hawser__reader_fail(reader, &tree->at, "%s has more than %d items: give fewer",
		                           list->name, list->most);
	for (const struct hawser__tree *one = tree->child; one && !status; one = one->next, ++*count) {
		char *name = (char *)hawser__item(list, scene, *count) + list->called;

		snprintf(what, sizeof what, "%s[%d]", list->name, *count);
		if (one->kind != HAWSER__MAPPING)
			return hawser__reader_fail(reader, &one->value, "%s must be a mapping, such as %s", what,
			                           list->example);
		status = hawser__tree_fill(reader, hawser__item(list, scene, *count), one, what, of);
		if (!status)
			status = name_of(reader, name, one, what);
		for (int i = 0; i < *count && *name && !status; i++)
			if (!strcmp(name, hawser__item_name(list, scene, i)))
				return hawser__reader_fail(reader, &one->at, "%s[%d] and %s have the same name %s: "
				                           "give different ones", list->name, i, what, name);
	}
	return status;
}

/* What a load case has. */
static void mark_cases(struct hawser_scene *scene, const struct hawser__tree *tree)
{
	struct hawser_case *one = scene->load_case;

	for (tree = tree ? tree->child : NULL; tree; tree = tree->next, one++) {
		one->loaded = hawser__tree_find(tree, "load") != NULL;
		one->heated = hawser__tree_find(tree, "temperature") != NULL;
		if (!hawser__tree_at(tree, "temperature.expansion"))
			one->expansion = NAN;
	}
}

/* A beam has no other mappings, but defaults of all. */
static enum hawser_status beam(struct hawser__reader *reader, struct hawser_scene *scene,
                               const struct hawser__tree *root)
{
	const struct hawser__tree *g = hawser__tree_find(root, "g");
	enum hawser_status status = hawser__tree_keys(reader, root, "the scene", "span");

	for (const struct hawser__tree *one = root->child; one && !status; one = one->next)
		if (strcmp(one->name, "g") != 0 && strcmp(one->name, "kind") != 0 &&
		    strcmp(one->name, "beam") != 0)
			status = hawser__reader_fail(reader, &one->at, "%s contradicts beam: a scene is of a "
			                             "cable or of a beam, remove one of them", one->name);
	if (!status)
		status = hawser__tree_fill(reader, scene, NULL, "", "span");
	if (!status && g)
		status = hawser__tree_value(reader, scene, g, "g", "span.g");
	return status ? status : hawser__tree_value(reader, scene, hawser__tree_find(root, "beam"), "beam",
	                                            "span.beam");
}

static enum hawser_status interpret(struct hawser__reader *reader, void *to,
                                    const struct hawser__tree *root)
{
	struct hawser_scene *scene = to;
	const struct hawser__tree *wind = hawser__tree_find(root, "wind");
	const struct hawser__items *list;
	enum hawser_status status = foreign(reader, root);

	reader->any_size = 1;
	if (!status)
		status = hawser__tree_find(root, "beam") ? beam(reader, scene, root)
		         : hawser__tree_fill(reader, scene, root, "", "span");
	if (!status && scene->damping.kind == HAWSER_DAMPING_RATIO)
		status = series(reader, scene, root, "damping.ratio", HAWSER_RATIOS);
	if (!status && wind)
		status = hawser__wind_lists(reader, &scene->wind, wind, "wind", "span.wind");
	for (int i = 0; (list = hawser__list_row(i)) && !status; i++) {
		const struct hawser__tree *tree = hawser__tree_find(root, list->name);

		if (tree)
			status = items(reader, scene, list, tree);
	}
	if (status)
		return status;
	mark_cases(scene, hawser__tree_find(root, "cases"));
	for (int i = 0; hawser_scene_key(i); i++)
		scene->written[i] = hawser__tree_at(root, hawser_scene_key(i)->path) != NULL;
	return hawser__check(reader, scene, root);
}

static void clear(void *scene)
{
	hawser_scene_clear(scene);
}

enum hawser_status hawser_scene_of(struct hawser_scene *scene, const struct hawser_document *from,
                                   const char *const *set, size_t nset,
                                   struct hawser_report *report)
{
	static const struct hawser__tree_form form = {
		.words = {.table = "span", .set = "cable.EA=400 MN",
		          .scene = "a scene is a mapping of keys to values, such as \"cable: {EA: 400 MN, "
		                   "rho: 6 kg/m}\", and needs at least cable, span and tension (see "
		                   "hawser-scene(5))"},
		.size = sizeof(struct hawser_scene), .name = offsetof(struct hawser_scene, name),
		.interpret = interpret, .clear = clear};

	if (from->length <= SIZE_LIMIT)
		return hawser__tree_scene(scene, &form, from, set, nset, report);
	memset(scene, 0, sizeof *scene);
	return hawser__fail(report, HAWSER_ERR_SCENE, "scene",
	                    "%s: larger than 1 MiB, so this is not a scene", from->name);
}

void hawser_scene_case(struct hawser_scene *to, const struct hawser_scene *scene, int index)
{
	const struct hawser_case *c = &scene->load_case[index];

	*to = *scene;
	to->static_load.present = c->loaded;
	memcpy(to->static_load.per_length, c->per_length, sizeof c->per_length);
	to->static_load.mass = c->mass;
	to->temperature.present = c->heated;
	to->temperature.change = c->heated ? c->change : 0.0;
	to->temperature.expansion = c->heated ? c->expansion : 0.0;
	to->wind.speed = c->wind;
}

/* scene/page/schema_span.c - the part of the JSON Schema about spans: the table of keys has those of
 * cables and of beams, which exclude each other.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "scene/keys.h"
#include "scene/page/schema.h"

static const struct {
	const char *key;
	enum hawser_beam_form form;
} forms[] = {{"mu", HAWSER_BEAM_MU}, {"theta", HAWSER_BEAM_THETA}, {"EI", HAWSER_BEAM_EI}};

/* What each form of a beam needs besides the key that tells it. */
static void of_form(struct hawser__schema *schema, json_t *rules, size_t form)
{
	struct hawser_scene *scene = calloc(1, sizeof *scene);
	json_t *needs = json_array(), *rule = json_object(), *two = json_array();

	schema->failed |= !scene;
	if (scene)
		scene->beam.form = forms[form].form;
	for (int i = 0; scene && hawser_scene_key(i); i++) {
		const char *path = hawser_scene_key(i)->path;

		if (!hawser__child_of(path, "beam"))
			continue;
		if (hawser__row(i)->pick == offsetof(struct hawser_scene, beam.weight))
			hawser__schema_add(schema, two, hawser__schema_needs(schema, hawser__leaf(path)));
		else if (!hawser_scene_key(i)->fallback && hawser__applies(scene, i))
			hawser__schema_add(schema, needs, json_string(hawser__leaf(path)));
	}
	hawser__schema_put(schema, rule, "required", needs);
	if (forms[form].form == HAWSER_BEAM_EI)
		hawser__schema_put(schema, rule, "oneOf", two);
	else
		json_decref(two);
	hawser__schema_put(schema, rules, forms[form].key, rule);
	free(scene);
}

json_t *hawser__schema_span(struct hawser__schema *schema, int beam)
{
	json_t *root = hawser__schema_of(schema, "span"), *properties = json_object_get(root, "properties");
	json_t *rules = json_object(), *kept = json_object();
	size_t form = 0;

	if (!beam) {
		json_object_del(properties, "beam");
		json_decref(rules);
		json_decref(kept);
		return root;
	}
	for (; form < sizeof forms/sizeof *forms; form++)
		of_form(schema, rules, form);
	hawser__schema_put(schema, json_object_get(properties, "beam"), "dependencies", rules);
	hawser__schema_put(schema, kept, "g", json_incref(json_object_get(properties, "g")));
	hawser__schema_put(schema, kept, "kind", json_incref(json_object_get(properties, "kind")));
	hawser__schema_put(schema, kept, "beam", json_incref(json_object_get(properties, "beam")));
	hawser__schema_put(schema, root, "properties", kept);
	hawser__schema_put(schema, root, "required", json_pack("[s]", "beam"));
	return root;
}

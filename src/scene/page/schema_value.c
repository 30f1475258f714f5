/* scene/page/schema_value.c - values in the JSON Schema of scenes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "scene/page/schema.h"

/* Text that begins with a number; what follows is a unit, which udunits2 alone can check. */
#define DIGITS "([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?"
#define UNIT "( +[^ ].*|[^-+0-9. ].*)?$"
static const char any_sign[] = "^ *[-+]?" DIGITS UNIT, no_minus[] = "^ *\\+?" DIGITS UNIT;

/* Values that editors suggest: units as they are written in practice. */
static const struct {
	const char *unit, *example[2];
} suggested[] = {
	{"N", {"80 kN", "400 MN"}}, {"kg/m", {"6 kg/m", "58 g/m"}}, {"m", {"250 m", "8 mm"}},
	{"m/s", {"5 m/s", "18 km/h"}}, {"rad", {"0.5", "90 degree"}}, {"rad/s", {"2 rad/s", "0.3 Hz"}},
	{"N.m^2", {"1.2 MN.m^2", "40 N.m^2"}}, {"N/m", {"0.8 N/m", "3 MN/m"}}, {"kg", {"20 kg", "2 t"}},
	{"s", {"20 s", "2 min"}}, {"1", {NULL, NULL}},
};

void hawser__schema_put(struct hawser__schema *schema, json_t *into, const char *key, json_t *value)
{
	schema->failed |= json_object_set_new(into, key, value) != 0;
}

void hawser__schema_add(struct hawser__schema *schema, json_t *list, json_t *value)
{
	schema->failed |= json_array_append_new(list, value) != 0;
}

static json_t *examples(struct hawser__schema *schema, const char *unit)
{
	json_t *list = json_array();
	size_t i = 0;

	while (i < sizeof suggested/sizeof *suggested && strcmp(suggested[i].unit, unit) != 0)
		i++;
	if (i < sizeof suggested/sizeof *suggested)
		for (int k = 0; k < 2 && suggested[i].example[k]; k++)
			hawser__schema_add(schema, list, json_string(suggested[i].example[k]));
	else
		hawser__schema_add(schema, list, json_sprintf("1 %s", unit));
	return list;
}

json_t *hawser__schema_type(struct hawser__schema *schema, const char *type)
{
	json_t *value = json_object();

	hawser__schema_put(schema, value, "type", json_string(type));
	return value;
}

json_t *hawser__schema_number(struct hawser__schema *schema, const char *unit,
                              const struct hawser__schema_range *range)
{
	json_t *forms = json_array(), *value;
	json_t *number = hawser__schema_type(schema, range->whole ? "integer" : "number");
	json_t *text = hawser__schema_type(schema, "string");

	if (isfinite(range->least))
		hawser__schema_put(schema, number, range->open ? "exclusiveMinimum" : "minimum",
		                   json_real(range->least));
	if (isfinite(range->most))
		hawser__schema_put(schema, number, "maximum", json_real(range->most));
	hawser__schema_put(schema, text, "pattern", json_string(range->least >= 0.0 ? no_minus : any_sign));
	hawser__schema_add(schema, forms, number);
	hawser__schema_add(schema, forms, text);
	value = hawser__schema_any(schema, forms);
	if (unit && *unit && strcmp(unit, "1") != 0)
		hawser__schema_put(schema, value, "examples", examples(schema, unit));
	return value;
}

json_t *hawser__schema_numbers(struct hawser__schema *schema, int count, const char *unit,
                               const struct hawser__schema_range *range)
{
	json_t *value = hawser__schema_type(schema, "array");

	hawser__schema_put(schema, value, "items", hawser__schema_number(schema, unit, range));
	hawser__schema_put(schema, value, "minItems", json_integer(count));
	hawser__schema_put(schema, value, "maxItems", json_integer(count));
	return value;
}

json_t *hawser__schema_words(struct hawser__schema *schema, const char *words)
{
	static const struct {
		const char *word;
		int truth;
	} truths[] = {{"yes", 1}, {"on", 1}, {"no", 0}, {"off", 0}};
	json_t *value = json_object(), *list = json_array();

	while (*words) {
		size_t length = strcspn(words, "|");

		hawser__schema_add(schema, list, json_stringn(words, length));
		for (size_t i = 0; i < sizeof truths/sizeof *truths; i++)
			if (strlen(truths[i].word) == length && !strncmp(words, truths[i].word, length))
				hawser__schema_add(schema, list, json_boolean(truths[i].truth));
		words += length + (words[length] == '|');
	}
	hawser__schema_put(schema, value, "enum", list);
	return value;
}

json_t *hawser__schema_any(struct hawser__schema *schema, json_t *forms)
{
	json_t *value;

	if (json_array_size(forms) == 1) {
		value = json_incref(json_array_get(forms, 0));
		json_decref(forms);
		return value;
	}
	value = json_object();
	hawser__schema_put(schema, value, "anyOf", forms);
	return value;
}

json_t *hawser__schema_needs(struct hawser__schema *schema, const char *key)
{
	json_t *value = json_object(), *list = json_array();

	hawser__schema_add(schema, list, json_string(key));
	hawser__schema_put(schema, value, "required", list);
	return value;
}

json_t *hawser__schema_mapping(struct hawser__schema *schema)
{
	json_t *value = hawser__schema_type(schema, "object");

	hawser__schema_put(schema, value, "additionalProperties", json_false());
	hawser__schema_put(schema, value, "properties", json_object());
	return value;
}

void hawser__schema_key(struct hawser__schema *schema, json_t *mapping, const char *key, json_t *value,
                        int required)
{
	json_t *list = json_object_get(mapping, "required");

	hawser__schema_put(schema, json_object_get(mapping, "properties"), key, value);
	if (!required)
		return;
	if (!list) {
		list = json_array();
		hawser__schema_put(schema, mapping, "required", list);
	}
	hawser__schema_add(schema, list, json_string(key));
}

void hawser__schema_together(struct hawser__schema *schema, json_t *mapping, json_t *together)
{
	json_t *rules = json_object();

	for (size_t i = 0; i < json_array_size(together); i++)
		hawser__schema_put(schema, rules, json_string_value(json_array_get(together, i)),
		                   json_deep_copy(together));
	hawser__schema_put(schema, mapping, "dependencies", rules);
}

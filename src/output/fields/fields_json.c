/* output/fields/fields_json.c - members and lists of JSON. See fields.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "output/fields/visit.h"
#include "output/fields/fields.h"

/* The object of which the last part of "certificate.error" is a member; it is created if missing. A
 * name that ends with the separator is that of an array: *key NULL, for an element of it. */
static json_t *holder(struct hawser__json *json, json_t *into, const char **key, char separator)
{
	const char *dot;

	for (; *key && (dot = strchr(*key, separator)) != NULL; *key = dot[1] ? dot + 1 : NULL) {
		json_t *inner = NULL;
		char name[HAWSER__NAME_SIZE];

		snprintf(name, sizeof name, "%.*s", (int)(dot - *key), *key);
		if (!json->status)
			inner = json_object_get(into, name);
		into = inner ? inner : dot[1] ? hawser__json_object(json, into, name)
		                              : hawser__json_array(json, into, name);
	}
	return into;
}

/* "[{"log_modulus": ..., "argument": ...}, ...]" */
static void pairs_json(struct hawser__json *json, json_t *list, const char *const pair[2],
                       const double *values, int count)
{
	for (int k = 0; k + 1 < count; k += 2) {
		json_t *object = hawser__json_object(json, list, NULL);

		hawser__json_number(json, object, pair[0], values[k]);
		hawser__json_number(json, object, pair[1], values[k + 1]);
	}
}

static int with_units;

void hawser__fields_with_units(int with)
{
	with_units = with;
}

/* A number, or null, with its unit if that is asked for: *into and *key become those of the number. */
static void wrap(struct hawser__json *json, json_t **into, const char **key, enum hawser__unit unit,
                 const struct hawser__view *view)
{
	const char *suffix = with_units ? hawser__unit_suffix(unit, &view->scale) : "";

	if (!*suffix)
		return;
	*into = hawser__json_object(json, *into, *key);
	*key = HAWSER__VALUE_KEY;
	hawser__json_text(json, *into, HAWSER__UNIT_KEY, hawser__unit_name(unit));
	hawser__json_text(json, *into, HAWSER__SUFFIX_KEY, suffix);
}

static void value_json(struct hawser__json *json, json_t *into, const char *key,
                       struct hawser__value value, unsigned flags, enum hawser__unit unit,
                       const struct hawser__view *view)
{
	if (value.is == HAWSER__IS_UNKNOWN && (flags & HAWSER__OMIT))
		return;
	if (value.is == HAWSER__IS_UNKNOWN || value.is == HAWSER__IS_NUMBER)
		wrap(json, &into, &key, unit, view);
	switch (value.is) {
	case HAWSER__IS_UNKNOWN:
		hawser__json_null(json, into, key);
		break;
	case HAWSER__IS_WORD:
		hawser__json_text(json, into, key, value.word);
		break;
	case HAWSER__IS_NUMBER:
		hawser__json_number(json, into, key, value.number);
		break;
	case HAWSER__IS_INTEGER:
		hawser__json_integer(json, into, key, value.integer);
		break;
	case HAWSER__IS_FLAG:
		hawser__json_flag(json, into, key, (int)value.integer);
		break;
	}
}

static void vector_json(struct hawser__json *json, json_t *into, const char *key,
                        const struct hawser__field *field, const struct hawser__at *at,
                        const struct hawser__view *view)
{
	const struct hawser__vector *vector = field->vector;
	int count = vector->count(view->context);
	const double *values = hawser__member(field, at, count);
	json_t *list, *place;

	if (!values)
		return;
	list = vector->object ? hawser__json_object(json, into, key)
	                      : hawser__json_array(json, into, key);
	if (vector->pair[0])
		pairs_json(json, list, vector->pair, values, count);
	for (int k = 0; !vector->pair[0] && k < count; k++) {
		char name[HAWSER__NAME_SIZE];
		const char *last = vector->object ? name : NULL;

		if (vector->object)
			vector->name(name, sizeof name, view->context, k);
		if (last && !*last)
			continue;
		place = holder(json, list, &last, HAWSER__NESTED);
		value_json(json, place, last,
		           hawser__vector_at(field, at, values, count, k, view), field->flags,
		           hawser__vector_unit(field, count, k, view), view);
	}
}

static void integers_json(struct hawser__json *json, json_t *into, const char *key,
                          const struct hawser__field *field, const struct hawser__at *at,
                          const struct hawser__view *view)
{
	const int *integers = hawser__member(field, at, 0);
	json_t *list = hawser__json_array(json, into, key);

	for (size_t k = 0; k < field->size/sizeof *integers; k++)
		if (field->label)
			hawser__json_text(json, list, NULL, field->label(integers[k]));
		else
			value_json(json, list, NULL, hawser__integer_value(integers[k], field->flags), field->flags,
			           HAWSER__NONE, view);
}

/* The keys of the fields that are shown. */
static void keys_json(struct hawser__json *json, json_t *into, const char *key,
                      const struct hawser__field *field, const struct hawser__view *view)
{
	json_t *list = hawser__json_array(json, into, key);

	for (; !hawser__is_end(field); field++)
		if (field->key && hawser__is_shown(field, view))
			hawser__json_text(json, list, NULL, field->key);
}

static void fields_json(struct hawser__json *json, json_t *into, const struct hawser__field *field,
                        const struct hawser__at *at, const struct hawser__view *view);

static void object_json(struct hawser__json *json, json_t *into, const char *key,
                        const struct hawser__field *field, const struct hawser__at *at,
                        const struct hawser__view *view)
{
	struct hawser__at inner = *at;

	inner.row = hawser__member(field, at, 0);
	if (field->through)
		/* cppcheck-suppress pointerSize ; the member is a pointer, and is copied */
		memcpy(&inner.row, inner.row, sizeof inner.row);
	if (!inner.row)
		return;
	if (!key || *key)
		into = hawser__json_object(json, into, key);
	fields_json(json, into, field->inner, &inner, view);
}

static void list_json(struct hawser__json *json, json_t *into, const char *key,
                      const struct hawser__field *field, const struct hawser__at *at,
                      const struct hawser__view *view);

static void member_json(struct hawser__json *json, json_t *into, const char *key,
                        const struct hawser__field *field, const struct hawser__at *at,
                        const struct hawser__view *view)
{
	switch (field->kind) {
	case HAWSER__VECTOR:
		vector_json(json, into, key, field, at, view);
		break;
	case HAWSER__NUMBERS:
		hawser__json_numbers(json, into, key, hawser__member(field, at, 0),
		                     (int)(field->size/sizeof(double)),
		                     hawser__in_unit(1.0, field->unit, &view->scale));
		break;
	case HAWSER__INTEGERS:
		integers_json(json, into, key, field, at, view);
		break;
	case HAWSER__KEYS:
		keys_json(json, into, key, field->list->field, view);
		break;
	case HAWSER__OBJECTS:
	case HAWSER__ROWS:
	case HAWSER__ARRAYS:
		list_json(json, into, key, field, at, view);
		break;
	case HAWSER__OBJECT:
		object_json(json, into, key, field, at, view);
		break;
	case HAWSER__CALL:
		field->call(json, into, at->row);
		break;
	default:
		value_json(json, into, key, hawser__value_of(field, at, view), field->flags, field->unit,
		           view);
	}
}

static int is_omitted(const struct hawser__field *field, const struct hawser__at *at,
                      const struct hawser__view *view)
{
	return (field->given && !field->given(at->row, at->parent)) ||
	       ((field->flags & HAWSER__OMIT) && field->kind <= HAWSER__CONSTANT &&
	        hawser__value_of(field, at, view).is == HAWSER__IS_UNKNOWN);
}

/* Write one field. If the field is not shown or its value is unknown, nothing is created, not even
 * the object of which it would be a member. */
static void field_json(struct hawser__json *json, json_t *into, const struct hawser__field *field,
                       const struct hawser__at *at, const struct hawser__view *view)
{
	const char *key = field->key;
	int omitted;

	if (!key || !hawser__is_shown(field, view))
		return;
	omitted = is_omitted(field, at, view);
	if (omitted && !(field->kind == HAWSER__OBJECT && (field->flags & HAWSER__NULL)))
		return;
	if (json_is_array(into))
		key = NULL; /* an element of a row */
	else if (field->kind != HAWSER__CALL)
		into = holder(json, into, &key, '.');
	if (omitted)
		hawser__json_null(json, into, key);
	else
		member_json(json, into, key, field, at, view);
}

static void fields_json(struct hawser__json *json, json_t *into, const struct hawser__field *field,
                        const struct hawser__at *at, const struct hawser__view *view)
{
	for (; !hawser__is_end(field) && !json->status; field++)
		field_json(json, into, field, at, view);
}

void hawser__fields_json(struct hawser__json *json, json_t *into, const struct hawser__field *field,
                         const void *row, const struct hawser__view *view)
{
	const struct hawser__at at = {row, row, 0, 0};

	fields_json(json, into, field, &at, view);
}

enum { WHOLE = -1, ROW = -2 };
/* Element `index` of a list: an object (part WHOLE), an array of its values (ROW), a value of that
 * field, or number k of its vector (part: the field's index + HAWSER__COLUMNS*(k + 1)). */
static void element_json(struct hawser__json *json, json_t *list, const void *context, int part,
                         size_t index)
{
	const struct hawser__maker *maker = context;
	const struct hawser__field *field = maker->list->field;
	const struct hawser__view *view = &maker->view;
	struct hawser__at at;
	union hawser__room room;

	if (!hawser__make_row(&at, &room, maker->list, &maker->at, index))
		return;
	if (part < 0) {
		fields_json(json, part == WHOLE ? hawser__json_object(json, list, NULL)
		                                : hawser__json_array(json, list, NULL), field, &at, view);
	} else if (part < HAWSER__COLUMNS) {
		member_json(json, list, NULL, &field[part], &at, view);
	} else {
		int count, k = part/HAWSER__COLUMNS - 1;

		field += part % HAWSER__COLUMNS;
		count = field->vector->count(view->context);
		value_json(json, list, NULL,
		           hawser__vector_at(field, &at, hawser__member(field, &at, count), count, k, view),
		           field->flags, hawser__vector_unit(field, count, k, view), view);
	}
}

/* The elements are stored at once, or computed during output. */
static void elements_json(struct hawser__json *json, json_t *into, const char *key,
                          const struct hawser__maker *maker, int part, int streamed)
{
	size_t count = hawser__count_of(maker->list, &maker->at);
	json_t *list;

	if (streamed) {
		hawser__json_list(json, into, key, count, element_json, maker, part);
		return;
	}
	list = hawser__json_array(json, into, key);
	for (size_t i = 0; i < count && !json->status; i++)
		element_json(json, list, maker, part, i);
}

/* An array for each number of a vector with names. */
static void vector_arrays(struct hawser__json *json, json_t *into,
                          const struct hawser__maker *maker, int part, int streamed)
{
	const struct hawser__vector *vector = maker->list->field[part].vector;
	int count = vector->count(maker->view.context);

	for (int k = 0; k < count && !json->status; k++) {
		char name[HAWSER__NAME_SIZE];
		const char *last = name;
		json_t *place;

		vector->name(name, sizeof name, maker->view.context, k);
		place = holder(json, into, &last, HAWSER__NESTED);
		elements_json(json, place, last, maker, part + HAWSER__COLUMNS*(k + 1), streamed);
	}
}

static void list_json(struct hawser__json *json, json_t *into, const char *key,
                      const struct hawser__field *field, const struct hawser__at *at,
                      const struct hawser__view *view)
{
	const struct hawser__field *inner = field->list->field;
	const struct hawser__at parent = {at->row, at->row, 0, 0};
	struct hawser__maker stored = {field->list, *at, *view}, *maker = &stored;
	int streamed = (field->flags & HAWSER__STREAM) && json->owns < HAWSER__JSON_LISTS;

	if ((field->flags & HAWSER__OMIT) && hawser__count_of(field->list, at) == 0)
		return;
	if (streamed && !(maker = malloc(sizeof *maker))) {
		json->status = hawser__no_memory(&json->report, "json");
		return;
	}
	if (streamed) {
		*maker = stored;
		json->owned[json->owns++] = maker;
	}
	if (field->kind != HAWSER__ARRAYS) {
		elements_json(json, into, key, maker, field->kind == HAWSER__ROWS ? ROW : WHOLE, streamed);
		return;
	}
	if (*key)
		into = hawser__json_object(json, into, key);
	for (int part = 0; !hawser__is_end(&inner[part]) && !json->status; part++) {
		const char *name = inner[part].key;
		json_t *place;

		if (inner[part].from == HAWSER__IN_PARENT)
			field_json(json, into, &inner[part], &parent, view);
		if (!name || !hawser__is_shown(&inner[part], view) || inner[part].from == HAWSER__IN_PARENT)
			continue;
		place = holder(json, into, &name, '.');
		if (inner[part].vector && inner[part].vector->object)
			vector_arrays(json, place, maker, part, streamed);
		else
			elements_json(json, place, name, maker, part, streamed);
	}
}

/* --- places --- */

const struct hawser__field *hawser__fields_at(const struct hawser__field *field, const char *place)
{
	for (; !hawser__is_end(field); field++) {
		const struct hawser__field *within = field->list ? field->list->field : field->inner;
		size_t length = field->key ? strlen(field->key) : 0;
		const char *rest = place + length;

		if (!field->key || strncmp(place, field->key, length) != 0 ||
		    (length > 0 && *rest && *rest != '.' && *rest != '['))
			continue;
		if (!within && length > 0)
			return field;
		rest += *rest == '[' ? strcspn(rest, "]") + 1 : 0;
		rest += length > 0 && *rest == '.';
		within = within && *rest ? hawser__fields_at(within, rest) : NULL;
		if (within)
			return within;
	}
	return NULL;
}

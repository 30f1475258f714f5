/* output/fields/fields_read.c - read results written as JSON back by their fields. See fields.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "output/fields/fields.h"

enum { LABELS = 64 }; /* largest number of values of an enumeration */

/* The member of the object at a path of names, or NULL. */
static const json_t *find(const json_t *object, const char *path, char separator)
{
	const char *end;

	for (; (end = strchr(path, separator)) != NULL; path = end + 1) {
		char name[HAWSER__NAME_SIZE];

		snprintf(name, sizeof name, "%.*s", (int)(end - path), path);
		object = json_object_get(object, name);
	}
	return json_object_get(object, path);
}

/* Convert to the unit of the row. */
static double number_of(const json_t *value, enum hawser__unit unit, const struct hawser__scale *scale)
{
	return json_is_number(value) ? json_number_value(value)/hawser__in_unit(1.0, unit, scale) : NAN;
}

static void put_integer(const struct hawser__field *field, void *to, long value)
{
	int usual = (int)value;
	signed char narrow = (signed char)value;

	memcpy(to, field->size == sizeof value ? (void *)&value
	           : field->size == sizeof usual ? (void *)&usual : (void *)&narrow, field->size);
}

static void put_label(const struct hawser__field *field, void *to, const char *word)
{
	for (int k = 0; word && k < LABELS; k++)
		if (strcmp(field->label(k), word) == 0) {
			put_integer(field, to, k);
			return;
		}
}

/* If the length of the list differs from that of the row, no numbers are read. */
static void put_vector(const struct hawser__field *field, double *to, int count,
                       const json_t *value, const struct hawser__view *view)
{
	int fits = json_is_object(value) || json_array_size(value) == (size_t)count;

	for (int k = 0; k < count; k++) {
		const json_t *item = json_array_get(value, (size_t)k);
		char name[HAWSER__NAME_SIZE];

		if (json_is_object(value)) {
			field->vector->name(name, sizeof name, view->context, k);
			item = find(value, name, HAWSER__NESTED);
		}
		to[k] = number_of(fits ? item : NULL, hawser__vector_unit(field, count, k, view),
		                  &view->scale);
	}
}

static int is_computed(const struct hawser__field *field)
{
	return field->number || field->word ||
	       (field->vector && (field->vector->number || field->vector->pair[0]));
}

static void put_value(const struct hawser__field *field, const struct hawser__at *at,
                      const json_t *value, const struct hawser__view *view)
{
	int count = field->vector ? field->vector->count(view->context) : 0;
	void *to = (void *)hawser__member(field, at, count);
	double number;

	if (!to)
		return;
	switch (field->kind) {
	case HAWSER__REAL:
		number = number_of(value, field->unit, &view->scale);
		memcpy(to, &number, sizeof number);
		break;
	case HAWSER__INT:
		if (json_is_integer(value))
			put_integer(field, to, (long)json_integer_value(value) -
			                       ((field->flags & HAWSER__FROM_1) != 0));
		break;
	case HAWSER__FLAG:
	case HAWSER__NOT:
		if (json_is_boolean(value))
			put_integer(field, to, json_is_true(value) == (field->kind == HAWSER__FLAG));
		break;
	case HAWSER__LABEL:
		put_label(field, to, json_string_value(value));
		break;
	case HAWSER__VECTOR:
		put_vector(field, to, count, value, view);
		break;
	default:
		break;
	}
}

static void read_fields(const struct hawser__at *at, const struct hawser__field *field,
                        const json_t *object, const struct hawser__view *view);

/* Read the last row of a list into the first row of the parent, and set the number of rows to 1. */
static void read_list(const struct hawser__field *of, const struct hawser__at *at,
                      const json_t *value, const struct hawser__view *view)
{
	const struct hawser__list *list = of->list;
	const struct hawser__field *field = list->field;
	struct hawser__at row = {NULL, at->row, 0, 0};
	union hawser__room room;

	if (list->row || list->count || list->part || list->column || list->matrix ||
	    !hawser__make_row(&row, &room, list, at, 0) || (list->size > 0 && !row.row))
		return;
	if (of->kind == HAWSER__OBJECTS) {
		size_t count = json_array_size(value);

		if (count > 0)
			read_fields(&row, field, json_array_get(value, count - 1), view);
		put_integer(&(struct hawser__field){.size = sizeof(int)},
		            (char *)at->row + list->count_at, count > 0);
		return;
	}
	for (; !hawser__is_end(field); field++) {
		const json_t *items = field->key ? find(value, field->key, '.') : NULL;
		size_t count = json_array_size(items);

		if (count > 0 && !is_computed(field) && hawser__is_shown(field, view))
			put_value(field, &row, json_array_get(items, count - 1), view);
	}
}

static void read_object(const struct hawser__field *field, const struct hawser__at *at,
                        const json_t *value, const struct hawser__view *view)
{
	struct hawser__at inner = *at;

	inner.row = hawser__member(field, at, 0);
	if (field->through)
		/* cppcheck-suppress pointerSize ; the member is a pointer, and is copied */
		memcpy(&inner.row, inner.row, sizeof inner.row);
	if (inner.row)
		read_fields(&inner, field->inner, value, view);
}

static void read_fields(const struct hawser__at *at, const struct hawser__field *field,
                        const json_t *object, const struct hawser__view *view)
{
	for (; !hawser__is_end(field); field++) {
		const json_t *value;

		if (!field->key || is_computed(field) || !hawser__is_shown(field, view))
			continue;
		value = *field->key ? find(object, field->key, '.') : object;
		if (!value)
			continue;
		if (field->kind == HAWSER__OBJECT)
			read_object(field, at, value, view);
		else if (field->kind == HAWSER__OBJECTS || field->kind == HAWSER__ARRAYS)
			read_list(field, at, value, view);
		else
			put_value(field, at, value, view);
	}
}

void hawser__fields_read(void *row, const struct hawser__field *field, const json_t *object,
                         const struct hawser__view *view)
{
	const struct hawser__at at = {row, row, 0, 0};

	read_fields(&at, field, object, view);
}

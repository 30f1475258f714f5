/* output/fields/json.c - results as JSON with full precision; all numbers are finite.
 *
 * Members of the upper two levels are on separate lines; deeper levels are written without line
 * breaks. A point of a response is one line, which suits diff and grep.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "output/fields/visit.h"

enum { line_levels = 2, digits = 17 };

void hawser__json_begin(struct hawser__json *json)
{
	memset(json, 0, sizeof *json);
	json->root = json_object();
	if (!json->root)
		json->status = hawser__no_memory(&json->report, "json");
}

/* Add `value` to `into`; takes ownership of `value`. */
static void put(struct hawser__json *json, json_t *into, const char *key, json_t *value)
{
	int failed;

	if (json->status) {
		json_decref(value);
		return;
	}
	failed = key ? json_object_set_new(into, key, value) : json_array_append_new(into, value);
	if (failed)
		json->status = hawser__no_memory(&json->report, "json");
}

void hawser__json_number(struct hawser__json *json, json_t *into, const char *key, double number)
{
	if (!json->status && number - number != 0.0)
		json->status = hawser__fail(&json->report, HAWSER_ERR_NAN, "json",
		                            "%s is %g: the result is not written",
		                            key ? key : "an entry of an array", number);
	put(json, into, key, json->status ? NULL : json_real(number));
}

void hawser__json_integer(struct hawser__json *json, json_t *into, const char *key, long number)
{
	put(json, into, key, json_integer(number));
}

void hawser__json_flag(struct hawser__json *json, json_t *into, const char *key, int flag)
{
	put(json, into, key, json_boolean(flag));
}

/* jansson rejects text that is not UTF-8, such as file names in Latin-1. The name of the scene is
 * then omitted, so that the result can be written. */
void hawser__json_text(struct hawser__json *json, json_t *into, const char *key, const char *text)
{
	json_t *value = json_string(text);

	/* a second attempt distinguishes a failed allocation from invalid UTF-8 */
	if (!value)
		value = json_string(text);
	put(json, into, key, value ? value : json_null());
}

void hawser__json_null(struct hawser__json *json, json_t *into, const char *key)
{
	put(json, into, key, json_null());
}

json_t *hawser__json_object(struct hawser__json *json, json_t *into, const char *key)
{
	json_t *object = json_object();

	put(json, into, key, object);
	return json->status ? NULL : object;
}

json_t *hawser__json_array(struct hawser__json *json, json_t *into, const char *key)
{
	json_t *array = json_array();

	put(json, into, key, array);
	return json->status ? NULL : array;
}

void hawser__json_numbers(struct hawser__json *json, json_t *into, const char *key,
                          const double *numbers, int count, double factor)
{
	json_t *array = hawser__json_array(json, into, key);
	int i;

	for (i = 0; i < count && !json->status; i++) {
		double number = factor*numbers[i];

		if (number - number != 0.0)
			json->status = hawser__fail(&json->report, HAWSER_ERR_NAN, "json",
			                            "%s[%d] is %g: the result is not written",
			                            key ? key : "an array", i, number);
		put(json, array, NULL, json->status ? NULL : json_real(number));
	}
}

void hawser__json_list(struct hawser__json *json, json_t *into, const char *key, size_t count,
                       void (*fill)(struct hawser__json *json, json_t *list, const void *context,
                                    int part, size_t index),
                       const void *context, int part)
{
	json_t *place = hawser__json_array(json, into, key);
	size_t i;

	if (json->lists == HAWSER__JSON_LISTS) { /* the table of lists is full: store the elements */
		for (i = 0; i < count && !json->status; i++)
			fill(json, place, context, part, i);
		return;
	}
	json->list[json->lists] = (struct hawser__json_list){place, count, fill, context, part};
	for (i = 0; i < count && !json->status; i++) {
		fill(json, place, context, part, i);
		json_array_clear(place);
	}
	json->lists++;
}

json_t *hawser__json_elements(struct hawser__json *json, json_t *array)
{
	for (int i = 0; i < json->lists; i++) {
		const struct hawser__json_list list = json->list[i];

		if (list.place != array)
			continue;
		json->list[i].place = NULL;
		for (size_t k = 0; k < list.count && !json->status; k++)
			list.fill(json, array, list.context, list.part, k);
	}
	return array;
}

void hawser__json_members(struct hawser__json *json,
                          int (*write)(FILE *stream, const void *context), const void *context)
{
	/* jansson keeps the order of members; the key is not written */
	json_t *place = hawser__json_object(json, json->root, "");

	json->members = (struct hawser__json_members){place, write, context};
}

/* State of the output. The functions below return nonzero if jansson ran out of memory; the text
 * written so far is then not valid JSON. */
struct printer {
	const struct hawser__json *json;
	FILE *stream;
};
static int print(const struct printer *printer, const json_t *value, int level);

/* The list whose elements belong at this place, or NULL. */
static const struct hawser__json_list *list_at(const struct hawser__json *json,
                                               const json_t *place)
{
	for (int i = 0; i < json->lists; i++)
		if (json->list[i].place == place)
			return &json->list[i];
	return NULL;
}

static int holds_list(const struct hawser__json *json, const json_t *value)
{
	const char *key;
	json_t *member;

	if (list_at(json, value))
		return 1;
	json_object_foreach((json_t *)value, key, member)
		if (holds_list(json, member))
			return 1;
	return 0;
}

/* 1 if the members of an object or array are on separate lines; a list of plain numbers is on one
 * line. */
static int is_broken(const json_t *value, const json_t *first, int level)
{
	if (level == 0 && json_is_object(value))
		return 1;
	return level < line_levels && json_is_array(value) &&
	       (json_is_object(first) || json_is_array(first));
}

/* Write the text before a member: the opening bracket of its container, or the separator. */
static void lead(FILE *stream, int first, char opening, int broken, int level)
{
	if (first)
		fputc(opening, stream);
	else
		fputs(broken ? "," : ", ", stream);
	if (broken)
		fprintf(stream, "\n%*s", level + 1, "");
}

static void finish(FILE *stream, int empty, char opening, int broken, int level)
{
	if (empty)
		fputc(opening, stream);
	else if (broken)
		fprintf(stream, "\n%*s", level, "");
	fputc(opening == '{' ? '}' : ']', stream);
}

static int print_object(const struct printer *printer, const json_t *value, int level)
{
	int first = 1, broken = is_broken(value, NULL, level), bad = 0;
	const char *key;
	json_t *member;

	json_object_foreach((json_t *)value, key, member) {
		const struct hawser__json_members *members = &printer->json->members;
		json_t *name;

		lead(printer->stream, first, '{', broken, level);
		first = 0;
		if (member == members->place) {
			bad |= members->write(printer->stream, members->context);
			continue;
		}
		name = json_string(key);
		bad |= !name || json_dumpf(name, printer->stream, JSON_ENCODE_ANY);
		fputs(": ", printer->stream);
		bad |= print(printer, member, level + 1);
		json_decref(name);
	}
	finish(printer->stream, first, '{', broken, level);
	return bad;
}

static int print_array(const struct printer *printer, const json_t *value, int level)
{
	int broken = is_broken(value, json_array_get(value, 0), level), bad = 0;
	json_t *element;
	size_t i;

	json_array_foreach((json_t *)value, i, element) {
		lead(printer->stream, i == 0, '[', broken, level);
		bad |= print(printer, element, level + 1);
	}
	finish(printer->stream, json_array_size(value) == 0, '[', broken, level);
	return bad;
}

static int print_list(const struct printer *printer, const struct hawser__json_list *list, int level)
{
	struct hawser__json scratch = {.root = json_array()};
	int first = 1, broken = 0, bad = !scratch.root;

	for (size_t i = 0; i < list->count && !bad && !ferror(printer->stream); i++) {
		const json_t *element;

		list->fill(&scratch, scratch.root, list->context, list->part, i);
		bad = scratch.status;
		element = bad ? NULL : json_array_get(scratch.root, 0);
		if (!element)
			continue;
		broken = is_broken(list->place, element, level);
		lead(printer->stream, first, '[', broken, level);
		first = 0;
		bad = json_dumpf(element, printer->stream,
		                 JSON_ENCODE_ANY | JSON_REAL_PRECISION(digits));
		json_array_clear(scratch.root);
	}
	finish(printer->stream, first, '[', broken, level);
	json_decref(scratch.root);
	return bad;
}

static int print(const struct printer *printer, const json_t *value, int level)
{
	const struct hawser__json_list *list = list_at(printer->json, value);

	if (list)
		return print_list(printer, list, level);
	if (json_is_object(value) && (level == 0 || holds_list(printer->json, value)))
		return print_object(printer, value, level);
	if (is_broken(value, json_array_get(value, 0), level))
		return print_array(printer, value, level);
	return json_dumpf(value, printer->stream, JSON_ENCODE_ANY | JSON_REAL_PRECISION(digits));
}

enum hawser_status hawser__json_write(const struct hawser__json *json, const char *path,
                                      struct hawser_report *report)
{
	struct printer printer = {.json = json};
	struct hawser__file file;
	enum hawser_status status = json->status;

	if (status) {
		if (report)
			*report = json->report;
		return status;
	}
	status = hawser__file_begin(&file, path, report);
	if (status)
		return status;
	/* the commit reports errors of the stream with their cause */
	printer.stream = file.stream;
	if (print(&printer, json->root, 0) && !ferror(file.stream)) {
		hawser__file_abort(&file);
		return hawser__no_memory(report, "json");
	}
	fputc('\n', file.stream);
	return hawser__file_commit(&file, report);
}

void hawser__json_clear(struct hawser__json *json)
{
	if (!json)
		return;
	json_decref(json->root);
	for (int i = 0; i < json->owns; i++)
		free(json->owned[i]);
	memset(json, 0, sizeof *json);
}

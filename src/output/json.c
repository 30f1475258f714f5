/* output/json.c - results as JSON, full precision, no number that is not finite.
 *
 * Two levels are broken into lines, deeper ones are written compactly: one point of a response is
 * one line, which diff and grep can work with.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "core/report.h"
#include "output/output.h"

enum { line_levels = 2, digits = 17 };

void hawser__json_begin(struct hawser__json *json)
{
	memset(json, 0, sizeof *json);
	json->root = json_object();
	if (!json->root)
		json->status = hawser__no_memory(&json->report, "json");
}

/* Takes `value` over. */
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

/* Latin-1 file names are no UTF-8, and jansson refuses them: better an unnamed scene than no result. */
void hawser__json_text(struct hawser__json *json, json_t *into, const char *key, const char *text)
{
	json_t *value = json_string(text);

	/* again, so that one failed allocation is not taken for a wrong letter */
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

/* These three return non-zero where jansson ran out of memory: what is written so far is no JSON. */
static int print(const json_t *value, FILE *stream, int level);

static int print_members(const json_t *value, FILE *stream, int level)
{
	const char *key, *between = "\n";
	json_t *member;
	int bad = 0;

	json_object_foreach((json_t *)value, key, member) {
		json_t *name = json_string(key);

		fprintf(stream, "%s%*s", between, level + 1, "");
		bad |= !name || json_dumpf(name, stream, JSON_ENCODE_ANY);
		fputs(": ", stream);
		bad |= print(member, stream, level + 1);
		json_decref(name);
		between = ",\n";
	}
	return bad;
}

static int print_elements(const json_t *value, FILE *stream, int level)
{
	const char *between = "\n";
	json_t *element;
	int bad = 0;
	size_t i;

	json_array_foreach((json_t *)value, i, element) {
		fprintf(stream, "%s%*s", between, level + 1, "");
		bad |= print(element, stream, level + 1);
		between = ",\n";
	}
	return bad;
}

/* A list of plain numbers stays on one line. */
static int is_broken(const json_t *value, int level)
{
	if (level == 0 && json_is_object(value))
		return 1;
	return level < line_levels && json_is_array(value) &&
	       (json_is_object(json_array_get(value, 0)) || json_is_array(json_array_get(value, 0)));
}

static int print(const json_t *value, FILE *stream, int level)
{
	int bad;

	if (!is_broken(value, level))
		return json_dumpf(value, stream, JSON_ENCODE_ANY | JSON_REAL_PRECISION(digits));
	fputc(json_is_object(value) ? '{' : '[', stream);
	bad = (json_is_object(value) ? print_members : print_elements)(value, stream, level);
	fprintf(stream, "\n%*s%c", level, "", json_is_object(value) ? '}' : ']');
	return bad;
}

enum hawser_status hawser__json_write(const struct hawser__json *json, const char *path,
                                      struct hawser_report *report)
{
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
	/* a stream's own trouble is told by the commit, with its cause */
	if (print(json->root, file.stream, 0) && !ferror(file.stream)) {
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
	memset(json, 0, sizeof *json);
}

/* tests/unit/test-fields-computed.c - fields that functions compute from a row, and their names.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "tests/fields-text.h"

struct part {
	double width;
	int number;
};

static const char *colour(int value)
{
	return value == 0 ? "red" : "green";
}

static void name_of(char *text, size_t size, const void *context, int k)
{
	(void)context;
	snprintf(text, size, "%d", k + 1);
}

/* Values that functions compute from a row. */
struct made {
	int rows, first, second;
	struct part part[2];
};

static double twice(const struct part *part)
{
	return 2.0*part->width;
}
HAWSER__NUMBERS_BY(twice_of, twice)

static double number_or_none(const void *row)
{
	const struct part *part = row;

	return part->number < 0 ? HAWSER__NO_INTEGER : part->number;
}

static double is_wide(const void *row)
{
	return ((const struct part *)row)->width > 1.0;
}

static const char *word_of(const void *row)
{
	return is_wide(row) != 0.0 ? "wide" : NULL;
}

static int is_given(const void *row, const void *parent)
{
	(void)row;
	return ((const struct made *)parent)->rows > 2;
}

/* 1, 2, NAN in row 0, 11, 12, NAN in the next. */
static double computed(const void *of, const void *parent, size_t index, int k)
{
	(void)of, (void)parent;
	return k == 2 ? NAN : 10.0*(double)index + k + 1;
}

static int three(const void *of)
{
	(void)of;
	return 3;
}

static enum hawser__unit unit_of(const void *of, int k)
{
	(void)of;
	return k == 0 ? HAWSER__M : HAWSER__NEWTON;
}

static void path_of(char *text, size_t size, const void *of, int k)
{
	(void)of;
	snprintf(text, size, "a.b%c%d", HAWSER__NESTED, k + 1);
}
static const struct hawser__vector
	made_vector = {.count = three, .name = name_of, .number = computed, .unit = unit_of},
	path_vector = {.count = three, .name = path_of, .number = computed, .object = 1};

static const struct hawser__field made_field[] = {
	{"width", "width", "computed", HAWSER__BY(twice_of), .unit = HAWSER__M},
	{"in.number", "number", "or nothing", HAWSER__COUNT_BY(number_or_none), .flags = HAWSER__OMIT},
	{"wide", NULL, "whether it is", HAWSER__FLAG_BY(is_wide)},
	{"word", "word", "or null", HAWSER__TEXT_BY(word_of)},
	{"colour", "colour", "of all", HAWSER__WORD_OF(1, colour)},
	{"no", NULL, "not given", HAWSER__CONSTANT_IS(1), .given = is_given},
	{NULL, "v_", "numbers", HAWSER__VECTOR_OF(made_vector), .flags = HAWSER__NULL},
	HAWSER__END,
};
static const struct hawser__field arrays_field[] = {
	{"", NULL, "by a path", HAWSER__VECTOR_OF(path_vector), .flags = HAWSER__NULL},
	HAWSER__END,
};
static const struct hawser__list
	made_list = HAWSER__ROWS_WITHIN(struct made, part, rows, made_field),
	arrays_list = {.field = arrays_field, .count_at = offsetof(struct made, rows)};
static const struct hawser__field all_field[] = {
	{"rows", NULL, "all", HAWSER__OBJECTS_OF(made_list), .flags = HAWSER__BRIEF},
	{"arrays", NULL, "by name", HAWSER__ARRAYS_OF(arrays_list)},
	{"pair", NULL, "two integers", HAWSER__INTEGER_PAIR_AT(struct made, first, second)},
	HAWSER__END,
};

static void test_computed(void)
{
	const struct made made = {2, 7, 8, {{0.25, 5}, {1.5, -1}}};
	struct hawser__view view = {hawser__scale_of(10.0, 4.0, 100.0, 1), NULL, 0};
	struct hawser__table table = {0};
	struct hawser__json json;
	FILE *stream;

	hawser__fields_table(&table, &made_list, &made, &view);
	same(table_text(&table), "width_m\tnumber\tword\tcolour\tv_1_m\tv_2_N\tv_3_N\n"
	                         "5\t5\t\tgreen\t10\t2\t\n30\t\twide\tgreen\t110\t12\t\n",
	     "computed numbers, words and vectors as a table");
	hawser__json_begin(&json);
	hawser__fields_json(&json, json.root, all_field, &made, &view);
	same(json_text(&json),
	     "{\n \"rows\": [\n"
	     "  {\"width\": 5.0, \"in\": {\"number\": 5}, \"wide\": false, \"word\": null, "
	     "\"colour\": \"green\"},\n"
	     "  {\"width\": 30.0, \"wide\": true, \"word\": \"wide\", \"colour\": \"green\"}\n ],\n"
	     " \"arrays\": {\"a.b\": {\"1\": [1.0, 11.0], \"2\": [2.0, 12.0], "
	     "\"3\": [null, null]}},\n \"pair\": [7, 8]\n}\n",
	     "the same as JSON, without an object of what is omitted, and arrays by a path");
	stream = fopen(path, "w");
	hawser__fields_print(stream, "JSON:", all_field, 1);
	fclose(stream);
	ok(!strstr(read_back(path), "width"), "a brief list does not repeat its fields");
}

static void axis_is(const struct hawser__field *field, const char *name,
                    const struct hawser__view *view, double largest, const char *title,
                    const char *unit, double per)
{
	struct hawser__axis axis = hawser__fields_axis(field, name, view, largest);

	ok(!strcmp(axis.title, title) && !strcmp(axis.unit, unit) && axis.per == per,
	   "%s up to %g: \"%s\", unit \"%s\", %g", name, largest, axis.title, axis.unit, axis.per);
}

static void test_axis(void)
{
	static const struct hawser__field axes[] = {
		{"width", NULL, "no title", HAWSER__AT(struct part, width), .unit = HAWSER__M},
		{NULL, "width", "on request", HAWSER__AT(struct part, width), .unit = HAWSER__HERTZ,
		 .when = 2, .axis = "Other"},
		{NULL, "width", "shown", HAWSER__AT(struct part, width), .unit = HAWSER__M,
		 .axis = "Width {/:Italic w}"},
		{"number", NULL, "without unit", HAWSER__AT(struct part, number), .axis = "Number"},
		{"force", NULL, "with prefixes", HAWSER__AT(struct part, width), .unit = HAWSER__NEWTON,
		 .axis = "Force"},
		HAWSER__END,
	};
	struct hawser__view view = {hawser__scale_of(10.0, 4.0, 100.0, 1), NULL, 0};

	axis_is(axes, "width", &view, 5e6, "Width {/:Italic w} (m)", "m", 1.0);
	axis_is(axes, "number", &view, 5e6, "Number (–)", "–", 1.0);
	axis_is(axes, "force", &view, 999.0, "Force (N)", "N", 1.0);
	axis_is(axes, "force", &view, -1e3, "Force (kN)", "kN", 1e3);
	axis_is(axes, "force", &view, 2.385e6, "Force (MN)", "MN", 1e6);
	view.scale.si = 0;
	axis_is(axes, "width", &view, 1.0, "Width {/:Italic w}", "", 1.0);
	view.scale.pure = 1;
	axis_is(axes, "width", &view, 1.0, "Width {/:Italic w} (–)", "–", 1.0);
	view.options = 2;
	axis_is(axes, "width", &view, 1.0, "Other (Hz)", "Hz", 1.0);
	axis_is(axes, "height", &view, 1.0, "", "", 1.0);
}

CASE(unit_fields_computed)
{
	close(mkstemp(path));
	test_computed();
	test_axis();
	unlink(path);
	return done_testing();
}

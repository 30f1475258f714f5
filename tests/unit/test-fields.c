/* tests/unit/test-fields.c - tables of fields: the same rows as a table and as JSON, compared as
 * text; units of a model, and a model without units; unknown values; stored lists and lists
 * computed during output.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include "output/fields/fields.h"
#include "tests/fields-text.h"

enum { OPTION = 4 };
enum colour { RED, GREEN };

struct part {
	double width;
	int number;
};

struct row {
	double omega, length, rest, limit;
	int unstable, place, count, pair[2];
	enum colour colour;
	signed char small;
	long many;
	const char *word;
	char name[8];
	double ends[2];
	const double *u;
	const struct part *part; /* [count] */
	struct part inner;
};

static const char *colour_name(enum colour colour)
{
	return colour == RED ? "red" : "green";
}
HAWSER__LABELS(colour_label, colour_name, enum colour)

static int two(const void *context)
{
	return *(const int *)context;
}

static void name_of(char *text, size_t size, const void *context, int k)
{
	(void)context;
	snprintf(text, size, "%d", k + 1);
}
static const struct hawser__vector coordinates = {.shown = "J", .count = two, .name = name_of};
static const struct hawser__vector state = {.count = two, .rate = HAWSER__M_S};
static const struct hawser__vector named = {.count = two, .name = name_of, .object = 1};
static const struct hawser__vector paired = {.count = two, .pair = {"a", "b"}};

static void call(struct hawser__json *json, json_t *into, const void *row)
{
	hawser__json_integer(json, into, "called", ((const struct row *)row)->many);
}

#define OF(member) HAWSER__AT(struct row, member)
static const struct hawser__field part_field[] = {
	{"width", "width", "how wide", HAWSER__AT(struct part, width), .unit = HAWSER__M},
	{"number", "number", "which", HAWSER__AT(struct part, number), .flags = HAWSER__FROM_1},
	HAWSER__END,
};
static const struct hawser__field field[] = {
	{"Omega", "Omega", "frequency", OF(omega), .unit = HAWSER__RAD_S},
	{"stable", "stable", "whether it is", HAWSER__NOT_AT(struct row, unstable)},
	{"deep.unstable", "unstable", "how often", OF(unstable)},
	{"u", "u_", "coordinates", OF(u), .unit = HAWSER__M, .vector = &coordinates},
	{"state", NULL, "u and u'", OF(u), .unit = HAWSER__M, .vector = &state},
	{"named", NULL, "by name", OF(u), .vector = &named},
	{"paired", NULL, "two by two", OF(u), .vector = &paired},
	{"deep.length", "length", "metres already", OF(length), .unit = HAWSER__METRE},
	{"rest", "rest", "may be unknown", OF(rest), .flags = HAWSER__NULL},
	{"limit", "limit", "may be infinite", OF(limit), .flags = HAWSER__MISSING},
	{"place", "place", "from 1", OF(place), .flags = HAWSER__FROM_1 | HAWSER__OMIT},
	{"colour", "colour", "its name", HAWSER__LABEL_AT(struct row, colour, colour_label)},
	{"small", "small", "a small integer", OF(small)},
	{"many", "many", "a large integer", OF(many)},
	{"word", "word", "text", OF(word), .flags = HAWSER__OMIT},
	{"name", "name", "text in the row", OF(name)},
	{"ends", NULL, "two numbers", OF(ends), .unit = HAWSER__RAD_S},
	{"pair", NULL, "two integers", OF(pair)},
	{"option", "option", "on request", OF(many), .when = OPTION},
	{"parts", NULL, "a list", HAWSER__STORED(struct row, part, count, part_field)},
	{"inner", NULL, "a structure within", HAWSER__PART_OF(struct row, inner, part_field)},
	{"called", NULL, "by a function", HAWSER__CALLS(call)},
	HAWSER__END,
};

static const double u[] = {0.5, 3.0};
static const struct part parts[] = {{1.5, 0}, {2.0, 6}};
static struct row row = {
	.omega = 2.0, .length = 7.0, .rest = NAN, .limit = INFINITY, .unstable = 0, .place = 3,
	.count = 2, .pair = {4, -5}, .colour = GREEN, .small = -3, .many = 5000000000, .word = "here",
	.name = "there", .ends = {1.0, 1.5}, .u = u, .part = parts, .inner = {0.25, 8}};
static const int context = 2;

static struct hawser__view scaled(unsigned options)
{
	return (struct hawser__view){hawser__scale_of(10.0, 4.0, 100.0, 1), &context, options};
}

static size_t one(const void *parent)
{
	(void)parent;
	return 1;
}

static const void *itself(void *to, const void *parent, size_t index)
{
	(void)to, (void)index;
	return parent;
}
static const struct hawser__list single = {.field = field, .size = sizeof row, .count = one,
                                           .row = itself};

/* Rows of another kind, with arrays of their own. */
struct other {
	int rows, same;
	double *omega;
	const double *u; /* [rows][2] */
	const signed char *place;
};
#define ALONG(member) HAWSER__ALONG(struct other, member)
static const struct hawser__field other_field[] = {
	{NULL, "word", "constant", HAWSER__CONSTANT_IS(9)},
	{NULL, "place", "last of two", ALONG(place), .stride = 2, .item = 1, .flags = HAWSER__FROM_1},
	{NULL, "Omega", "frequency", ALONG(omega), .unit = HAWSER__RAD_S},
	{NULL, "u_", "coordinates", HAWSER__VECTOR_ALONG(struct other, u, coordinates)},
	{NULL, "many", "one for all", HAWSER__IN(struct other, same)},
	HAWSER__END,
};
#undef ALONG
static const struct hawser__list other_list = {.field = other_field,
                                               .count_at = offsetof(struct other, rows)};

static void test_table(void)
{
	struct hawser__view view = scaled(0), plain = {hawser__si, &context, OPTION};
	double omega[] = {0.25, 0.5}, place[] = {1.0, 2.0, 3.0, 4.0};
	const signed char places[] = {7, -1, 7, 4};
	const struct other other = {2, 11, omega, place, places};
	struct hawser__table table = {0};

	hawser__fields_columns(&table, field, &view);
	hawser__fields_rows(&table, NULL, &single, &row, &view);
	hawser__fields_rows(&table, field, &other_list, &other, &view);
	same(table_text(&table),
	     "Omega_rad_s\tstable\tunstable\tu_1_m\tu_2_m\tlength_m\trest\tlimit\tplace\tcolour\tsmall\t"
	     "many\tword\tname\n"
	     "8\t1\t0\t5\t30\t7\t\tmissing\t4\tgreen\t-3\t5000000000\there\tthere\n"
	     "1\t\t\t1\t2\t\t\t\t\t\t\t11\t9\t\n2\t\t\t3\t4\t\t\t\t5\t\t\t11\t9\t\n",
	     "columns with units, values in SI, rows of another kind below the same columns");
	plain.scale.si = 0;
	hawser__fields_columns(&table, field, &plain);
	ok(table.columns == 15 && !strcmp(table.column[0], "Omega") &&
	   !strcmp(table.column[5], "length_m") && !strcmp(table.column[14], "option"),
	   "a model without units has no suffix, a fixed unit has; an option adds a column");
	hawser__table_clear(&table);
}

static void test_json(void)
{
	struct hawser__view view = scaled(0);
	struct row other = row;
	struct hawser__json json;

	hawser__json_begin(&json);
	hawser__fields_json(&json, json.root, field, &row, &view);
	same(json_text(&json),
	     "{\n \"Omega\": 8.0,\n \"stable\": true,\n \"deep\": {\"unstable\": 0, \"length\": 7.0},\n"
	     " \"u\": [5.0, 30.0],\n \"state\": [5.0, 120.0],\n \"named\": {\"1\": 0.5, \"2\": 3.0},\n"
	     " \"paired\": [\n  {\"a\": 0.5, \"b\": 3.0}\n ],\n"
	     " \"rest\": null,\n \"limit\": \"missing\",\n \"place\": 4,\n \"colour\": \"green\",\n"
	     " \"small\": -3,\n \"many\": 5000000000,\n \"word\": \"here\",\n \"name\": \"there\",\n"
	     " \"ends\": [4.0, 6.0],\n \"pair\": [4, -5],\n"
	     " \"parts\": [\n  {\"width\": 15.0, \"number\": 1},\n  {\"width\": 20.0, \"number\": 7}\n ],\n"
	     " \"inner\": {\"width\": 2.5, \"number\": 9},\n \"called\": 5000000000\n}\n",
	     "members of an object");
	other.place = -1;
	other.word = "";
	other.u = NULL;
	other.count = 0;
	hawser__json_begin(&json);
	hawser__fields_json(&json, json.root, field, &other, &view);
	ok(!json_object_get(json.root, "place") && !json_object_get(json.root, "word") &&
	   !json_object_get(json.root, "u") && json_array_size(json_object_get(json.root, "parts")) == 0,
	   "unknown members are left out");
	hawser__json_clear(&json);
	other.omega = NAN;
	hawser__json_begin(&json);
	hawser__fields_json(&json, json.root, field, &other, &view);
	ok(json.status == HAWSER_ERR_NAN && strstr(json.report.message, "Omega"),
	   "a number that must be known is refused by name: %s", json.report.message);
	hawser__json_clear(&json);
}

static size_t three(const void *parent)
{
	(void)parent;
	return 3;
}

/* There is no second row. */
static const void *made(void *to, const void *parent, size_t index)
{
	const double *width = parent;

	*(struct part *)to = (struct part){width[0]*(double)index, (int)index};
	return index == 1 ? NULL : to;
}
static const struct hawser__list list = {.field = part_field, .size = sizeof(struct part),
                                         .count = three, .row = made};
static const struct hawser__field streamed[] = {
	{"rows", NULL, "made on output", HAWSER__OBJECTS_OF(list), .flags = HAWSER__STREAM},
	{"columns", NULL, "the same by column", HAWSER__ARRAYS_OF(list), .flags = HAWSER__STREAM},
	HAWSER__END,
};
static const struct hawser__field stored[] = {
	{"rows", NULL, "made at once", HAWSER__OBJECTS_OF(list)},
	{"columns", NULL, "the same by column", HAWSER__ARRAYS_OF(list)},
	HAWSER__END,
};

static void test_lists(void)
{
	static const char want[] = "{\n \"rows\": [\n  {\"width\": 0.0, \"number\": 1},\n"
	                           "  {\"width\": 10.0, \"number\": 3}\n ],\n"
	                           " \"columns\": {\"width\": [0.0, 10.0], \"number\": [1, 3]}\n}\n";
	struct hawser__view view = scaled(0);
	const double width = 0.5;
	struct hawser__table table = {0};
	struct hawser__json json;

	hawser__json_begin(&json);
	hawser__fields_json(&json, json.root, stored, &width, &view);
	same(json_text(&json), want, "a list stored at once, as rows and as columns");
	hawser__json_begin(&json);
	hawser__fields_json(&json, json.root, streamed, &width, &view);
	ok(json.owns == 2, "lists that are made on output are remembered");
	same(json_text(&json), want, "the same made on output");
	hawser__fields_table(&table, &list, &width, &view);
	hawser__fields_rows(&table, NULL, &list, &width, &view);
	same(table_text(&table), "width_m\tnumber\n0\t1\n10\t3\n0\t1\n10\t3\n",
	     "a table made on output, and rows stored after it");
}

/* Numbers of outer and inner rows, as a matrix and by outer row. */
struct matrix {
	int outers, inners;
	const struct part *outer, *inner; /* [outers], [inners] */
	double *number;                   /* [outers][inners] */
};
static const struct hawser__field cell_field[] = {
	{NULL, "outer", "of the outer row", HAWSER__OUTER(struct matrix, outer, struct part, number)},
	{"inner", "inner", "of the inner row", HAWSER__INNER(struct matrix, inner, struct part, number)},
	{"number", "number", "of both", HAWSER__ALONG(struct matrix, number)},
	HAWSER__END,
};
static const struct hawser__list
	cells = HAWSER__MATRIX_ROWS(struct matrix, outers, inners, cell_field),
	outer_cells = HAWSER__MATRIX_PART(struct matrix, inners, cell_field);
static const struct hawser__field down_field[] = {
	{"down", NULL, "of each outer row", HAWSER__ALONG(struct matrix, number)},
	HAWSER__END,
};
static const struct hawser__list inner_cells =
	HAWSER__MATRIX_COLUMN(struct matrix, outers, inners, down_field);
static const struct hawser__field inner_field[] = {
	{"inner", NULL, "of the inner row", HAWSER__AT(struct part, number)},
	{"", NULL, "", HAWSER__ARRAYS_OF(inner_cells)},
	HAWSER__END,
};
static const struct hawser__field columns_field[] = {
	{"inners", NULL, "columns", HAWSER__STORED(struct matrix, inner, inners, inner_field)},
	HAWSER__END,
};
static const struct hawser__field outer_field[] = {
	{"outer", NULL, "of the outer row", HAWSER__AT(struct part, number)},
	{"cells", NULL, "inner rows", HAWSER__OBJECTS_OF(outer_cells)},
	HAWSER__END,
};
static const struct hawser__field matrix_field[] = {
	{"outers", NULL, "rows", HAWSER__STORED(struct matrix, outer, outers, outer_field)},
	HAWSER__END,
};

static void test_matrix(void)
{
	static const struct part outer[] = {{0.0, 10}, {0.0, 20}}, inner[] = {{0, 1}, {0, 2}, {0, 3}};
	double number[] = {0.5, 1.5, 2.5, 3.5, 4.5, 5.5};
	const struct matrix matrix = {2, 3, outer, inner, number};
	struct hawser__view view = scaled(0);
	struct hawser__table table = {0};
	struct hawser__json json;

	hawser__fields_table(&table, &cells, &matrix, &view);
	same(table_text(&table), "outer\tinner\tnumber\n10\t1\t0.5\n10\t2\t1.5\n10\t3\t2.5\n"
	                         "20\t1\t3.5\n20\t2\t4.5\n20\t3\t5.5\n", "a matrix as a table");
	hawser__json_begin(&json);
	hawser__fields_json(&json, json.root, matrix_field, &matrix, &view);
	same(json_text(&json),
	     "{\n \"outers\": [\n  {\"outer\": 10, \"cells\": [{\"inner\": 1, \"number\": 0.5}, "
	     "{\"inner\": 2, \"number\": 1.5}, {\"inner\": 3, \"number\": 2.5}]},\n"
	     "  {\"outer\": 20, \"cells\": [{\"inner\": 1, \"number\": 3.5}, "
	     "{\"inner\": 2, \"number\": 4.5}, {\"inner\": 3, \"number\": 5.5}]}\n ]\n}\n",
	     "and as lists in a list");
	hawser__json_begin(&json);
	hawser__fields_json(&json, json.root, columns_field, &matrix, &view);
	same(json_text(&json),
	     "{\n \"inners\": [\n  {\"inner\": 1, \"down\": [0.5, 3.5]},\n"
	     "  {\"inner\": 2, \"down\": [1.5, 4.5]},\n  {\"inner\": 3, \"down\": [2.5, 5.5]}\n ]\n}\n",
	     "and as arrays along its columns");
}

static void test_order(void)
{
	static const struct hawser__field placed[] = {
		{"width", "last", "last in the table", HAWSER__AT(struct part, width), .place = 2},
		{"number", "first", "first", HAWSER__AT(struct part, number)},
		{"again", "second", "second", HAWSER__AT(struct part, number), .unit = HAWSER__METRE,
		 .flags = HAWSER__BARE, .place = 1},
		{"third", "third", "third", HAWSER__AT(struct part, number), .place = 1},
		HAWSER__END,
	};
	struct hawser__view view = scaled(0);
	struct hawser__table table = {0};
	struct hawser__json json;

	hawser__fields_comments(&table, part_field, &parts[0], &view);
	hawser__fields_columns(&table, placed, &view);
	hawser__fields_row(&table, NULL, placed, &parts[1], &view);
	same(table_text(&table), "# width = 15 m\nfirst\tsecond\tthird\tlast\n6\t6\t6\t2\n",
	     "a table in another order than JSON");
	hawser__json_begin(&json);
	hawser__fields_json(&json, json.root, placed, &parts[1], &view);
	same(json_text(&json), "{\n \"width\": 2.0,\n \"number\": 6,\n \"again\": 6,\n \"third\": 6\n}\n",
	     "JSON in its own");
}

static void test_units(void)
{
	const struct hawser__scale scale = hawser__scale_of(3.0, 0.5, 7.0, 1);

	close_to(hawser__in_unit(2.0, HAWSER__S, &scale), 4.0, 0.0, "time");
	close_to(hawser__in_unit(2.0, HAWSER__M_S, &scale), 3.0, 0.0, "speed");
	close_to(hawser__in_unit(2.0, HAWSER__M_S2, &scale), 1.5, 0.0, "acceleration");
	close_to(hawser__in_unit(18.0, HAWSER__RAD_S_M2, &scale), 1.0, 0.0, "curvature of a backbone");
	close_to(hawser__in_unit(2.0, HAWSER__J, &scale), 14.0, 0.0, "energy");
	close_to(hawser__in_unit(M_PI, HAWSER__HERTZ, &scale), 0.5, 0.0, "frequency in Hz");
	close_to(hawser__in_unit(2.0, HAWSER__NEWTON, &scale), 2.0, 0.0, "a fixed unit");
	for (int unit = 0; unit < HAWSER__UNITS; unit++)
		ok((unit == HAWSER__NONE) == !*hawser__unit_suffix((enum hawser__unit)unit, &hawser__si) &&
		   (unit == HAWSER__NONE) == !*hawser__unit_name((enum hawser__unit)unit),
		   "unit %d has a name and a suffix", unit);
}

static void test_print(void)
{
	FILE *stream = fopen(path, "w");

	hawser__fields_print(stream, "Columns:", part_field, 0);
	hawser__fields_print(stream, "JSON:", stored, 1);
	fclose(stream);
	same(read_back(path),
	     "\nColumns:\n  width_m                   how wide (m)\n  number                    which\n"
	     "\nJSON:\n  rows                      made at once\n    width                   how wide (m)\n"
	     "    number                  which\n  columns                   the same by column\n"
	     "    width                   how wide (m)\n    number                  which\n",
	     "the list of fields");
}

CASE(unit_fields)
{
	close(mkstemp(path));
	test_table();
	test_json();
	test_lists();
	test_matrix();
	test_order();
	test_units();
	test_print();
	unlink(path);
	return done_testing();
}

/* tests/unit/test-fields-read.c - a row written as JSON and read back by the same fields has the
 * same values. Of lists the last row is read; members without room are skipped.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "output/fields/fields.h"
#include "tests/tap.h"

enum colour { RED, GREEN };

struct part {
	double width;
	int number;
};

struct row {
	double omega, missing;
	int number, place, flag, off;
	long many;
	signed char small;
	enum colour colour;
	const double *u, *named; /* [3] */
	struct part inner, *through, *part, within[2]; /* part: [parts] */
	int parts, times;
	double *time, *state; /* [times], [times][3] */
};

static const char *colour_name(int colour)
{
	return colour == RED ? "red" : "green";
}

static int three(const void *context)
{
	(void)context;
	return 3;
}

static void name_of(char *text, size_t size, const void *context, int k)
{
	(void)context;
	snprintf(text, size, "mid%c%c", HAWSER__NESTED, "xyz"[k]);
}

static double computed(const void *row)
{
	return 2.0*((const struct row *)row)->omega;
}
static const struct hawser__vector plain = {.count = three, .rate = HAWSER__M_S};
static const struct hawser__vector named = {.count = three, .name = name_of, .object = 1};

static const struct hawser__field part_field[] = {
	{"width", NULL, "wide", HAWSER__AT(struct part, width), .unit = HAWSER__M},
	{"in.number", NULL, "number", HAWSER__AT(struct part, number)},
	HAWSER__END,
};
static const struct hawser__field time_field[] = {
	{"times", NULL, "time", HAWSER__ALONG(struct row, time), .unit = HAWSER__S},
	{"states", NULL, "state", HAWSER__VECTOR_ALONG(struct row, state, plain), .unit = HAWSER__M},
	HAWSER__END,
};
static const struct hawser__list time_list = {
	.field = time_field, .count_at = offsetof(struct row, times)};
#define OF(member) HAWSER__AT(struct row, member)
static const struct hawser__field field[] = {
	{"Omega", NULL, "frequency", OF(omega), .unit = HAWSER__RAD_S},
	{"twice", NULL, "computed", HAWSER__BY(computed)},
	{"missing", NULL, "null", OF(missing), .flags = HAWSER__NULL},
	{"deep.number", NULL, "integer", OF(number)},
	{"place", NULL, "from 1", OF(place), .flags = HAWSER__FROM_1},
	{"flag", NULL, "whether", HAWSER__FLAG_AT(struct row, flag)},
	{"on", NULL, "whether not", HAWSER__NOT_AT(struct row, off)},
	{"many", NULL, "long", OF(many)},
	{"small", NULL, "short", OF(small)},
	{"colour", NULL, "word", HAWSER__LABEL_AT(struct row, colour, colour_name)},
	{"u", NULL, "vector", HAWSER__VECTOR_AT(struct row, u, plain), .unit = HAWSER__M},
	{"named", NULL, "by name", HAWSER__VECTOR_AT(struct row, named, named), .unit = HAWSER__M},
	{"inner", NULL, "object", HAWSER__PART_OF(struct row, inner, part_field)},
	{"", NULL, "members", HAWSER__THROUGH(struct row, through, part_field)},
	{"parts", NULL, "list", HAWSER__STORED(struct row, part, parts, part_field)},
	{"within", NULL, "list", HAWSER__STORED_WITHIN(struct row, within, parts, part_field)},
	{"", NULL, "arrays", HAWSER__ARRAYS_OF(time_list)},
	HAWSER__END,
};
#undef OF
static const struct hawser__view view = {
	.scale = {.factor = {1.0, 10.0, 0.25, 4.0, 4.0, 40.0, 100.0}, .si = 1}};

static void write_row(struct hawser__json *json)
{
	static const double u[] = {2.385, -0.5, 7.1}, probe[] = {1.0, 2.0, 3.25};
	static double time[] = {0.5, 1.5}, state[] = {1.0, 2.0, 3.0, 4.5, 5.5, 6.5};
	static struct part through = {0.3, 9}, part[] = {{1.1, 1}, {2.2, 2}};
	const struct row row = {
		.omega = 2.385, .missing = NAN, .number = -7, .place = 4, .flag = 1, .off = 0,
		.many = 1234567890123L, .small = -3, .colour = GREEN, .u = u, .named = probe,
		.inner = {0.7, 3}, .through = &through, .part = part, .within = {{3.3, 3}, {4.4, 4}},
		.parts = 2, .times = 2, .time = time, .state = state};

	hawser__json_begin(json);
	hawser__fields_json(json, json->root, field, &row, &view);
	ok(json->status == HAWSER_OK, "the row is written");
}

static void test_values(const struct hawser__json *json)
{
	double u[3] = {0.0}, probe[3] = {0.0}, time[1] = {0.0}, state[3] = {0.0};
	struct part through = {0.0, 0}, part[1] = {{0.0, 0}};
	struct row row = {.off = 1, .u = u, .named = probe, .through = &through, .part = part,
	                  .time = time, .state = state};

	hawser__fields_read(&row, field, json->root, &view);
	close_to(row.omega, 2.385, 1e-15, "a number in its unit");
	ok(isnan(row.missing), "null is no number");
	ok(row.number == -7 && row.place == 4 && row.many == 1234567890123L && row.small == -3,
	   "integers of three sizes, and one shown from 1");
	ok(row.flag == 1 && row.off == 0, "flags");
	ok(row.colour == GREEN, "a word is its value");
	ok(fabs(u[0] - 2.385) < 1e-15 && fabs(u[1] + 0.5) < 1e-15 && fabs(u[2] - 7.1) < 1e-14,
	   "a vector with two units");
	ok(probe[0] == 1.0 && probe[1] == 2.0 && probe[2] == 3.25, "a vector by names");
	ok(row.inner.width == 0.7 && row.inner.number == 3, "an object");
	ok(through.width == 0.3 && through.number == 9, "members of another structure");
	ok(row.parts == 1 && part[0].width == 2.2 && part[0].number == 2, "the last row of a list");
	ok(row.within[0].width == 4.4 && row.within[1].width == 0.0, "the last row of a list within");
	ok(time[0] == 1.5 && state[0] == 4.5 && state[2] == 6.5, "the last of arrays");
}

static void test_no_room(const struct hawser__json *json)
{
	struct row row = {.parts = 5};

	hawser__fields_read(&row, field, json->root, &view);
	ok(row.omega != 0.0 && !row.u && !row.part && row.within[0].number == 4,
	   "what has no room is left out, the rest is read");
}

/* A file may have any contents. */
static void test_other(void)
{
	json_t *root = json_pack("{s:s, s:s, s:[f,f], s:s, s:i, s:{s:f}, s:[i], s:i, s:[]}",
	                         "Omega", "fast", "colour", "blue", "u", 1.0, 2.0, "place", "one",
	                         "flag", 7, "named", "mid", 1.0, "parts", 3, "times", 4, "states");
	double u[3] = {0.0}, probe[3] = {0.0}, time[1] = {8.0}, state[3] = {8.0};
	struct part part[1] = {{0.5, 6}};
	struct row row = {.place = 2, .colour = GREEN, .u = u, .named = probe, .part = part, .time = time,
	                  .state = state};

	ok(root != NULL, "another object");
	hawser__fields_read(&row, field, root, &view);
	ok(isnan(row.omega), "a word for a number");
	ok(row.place == 2 && row.flag == 0 && row.colour == GREEN, "what does not fit stays as it is");
	ok(isnan(u[0]) && isnan(u[2]), "a vector of another length has no numbers");
	ok(isnan(probe[0]), "nor has one without its names");
	ok(part[0].width == 0.5 && part[0].number == 6 && time[0] == 8.0 && state[0] == 8.0,
	   "lists of something else");
	json_decref(root);
}

CASE(unit_fields_read)
{
	struct hawser__json json;

	write_row(&json);
	test_values(&json);
	test_no_room(&json);
	hawser__json_clear(&json);
	test_other();
	return done_testing();
}

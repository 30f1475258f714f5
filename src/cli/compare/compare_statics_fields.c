/* cli/compare/compare_statics_fields.c - columns and keys of hawser compare statics.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>

#include "cli/compare/compare_statics.h"

/* --- methods --- */

struct score {
	const char *name, *method, *start;
	int solved, compressed, failed, wrong;
	double success, iterations[HAWSER_NET_QUANTILES], seconds[HAWSER_NET_QUANTILES];
	double best, ratio, angle, residual;
};

static const char *start_name(enum hawser_net_start start)
{
	return start == HAWSER_NET_START_CHORD ? "chord" : start == HAWSER_NET_START_DENSITY ? "density"
	                                                                                     : "own";
}

/* A measured number; not a number if results are to be reproducible. */
static double timed(const struct cli_compare_statics *result, double number)
{
	return result->common->reproducible || !isfinite(number) ? NAN : number;
}

static const void *score_row(void *to, const void *parent, size_t index)
{
	const struct cli_compare_statics *result = parent;
	const struct hawser_net_score *from = &result->of.score[index];
	struct score *row = to;

	*row = (struct score){
		.name = from->way->name, .method = from->way->method, .start = start_name(from->way->start),
		.solved = from->solved, .compressed = from->compressed, .failed = from->failed,
		.wrong = from->wrong, .best = timed(result, from->best), .ratio = timed(result, from->ratio),
		.success = result->of.nets > 0 ? (double)from->solved/result->of.nets : NAN,
		.angle = from->solved > 0 ? from->angle : NAN,
		.residual = from->solved > 0 ? from->residual : NAN};
	for (int k = 0; k < HAWSER_NET_QUANTILES; k++) {
		row->iterations[k] = from->iterations[k];
		row->seconds[k] = timed(result, from->seconds[k]);
	}
	return row;
}

#define OF(member) HAWSER__AT(struct score, member)
#define MAYBE(member) OF(member), .flags = HAWSER__NULL
#define NUMBER(member) \
	.kind = HAWSER__REAL, HAWSER__PLACE(struct score, member), .flags = HAWSER__NULL
static const struct hawser__field score_field[] = {
	{"name", "method", "with /chord or /density if it begins elsewhere than by itself", OF(name)},
	{"method", NULL, "as in hawser statics --method", OF(method)},
	{"start", NULL, "own, chord (straight cables with noise) or density (force densities)", OF(start)},
	{"success", "success", "part of the nets that are solved", MAYBE(success)},
	{"solved", "solved", "nets: the method says so, and the certificate agrees", OF(solved)},
	{"compressed", "compressed", "nets: it ended with compressed elements", OF(compressed)},
	{"failed", "failed", "nets: the method found no equilibrium", OF(failed)},
	{"wrong", "wrong", "nets: the method says it is solved, and the certificate does not", OF(wrong)},
	{"iterations.median", "iterations", "half of the solved nets take at most so many",
	 NUMBER(iterations[0])},
	{"iterations.p90", "iterations_p90", "nine tenths do", NUMBER(iterations[1])},
	{"iterations.max", "iterations_max", "all do", NUMBER(iterations[2])},
	{"seconds.median", "time", "processor time of a solution: half of the solved nets take at most "
	 "this", NUMBER(seconds[0]), .unit = HAWSER__SECOND},
	{"seconds.p90", "time_p90", "nine tenths do", NUMBER(seconds[1]), .unit = HAWSER__SECOND},
	{"seconds.max", "time_max", "all do", NUMBER(seconds[2]), .unit = HAWSER__SECOND},
	{"best", "fastest", "part of the nets that it solves the fastest", MAYBE(best)},
	{"ratio", "time_ratio", "its time over that of the fastest on the same net: median of the solved",
	 MAYBE(ratio)},
	{"angle", "angle", "largest error of the solved nets: mean turn of the forces that the gap of the "
	 "energy allows", MAYBE(angle), .unit = HAWSER__RADIAN},
	{"residual", "residual", "largest of the solved nets: force that is not balanced, over all loads",
	 MAYBE(residual)},
	HAWSER__END,
};
#undef NUMBER
#undef MAYBE
#undef OF
const struct hawser__list cli_compare_statics_methods =
	HAWSER__MADE_ROWS(struct score, score_field, struct cli_compare_statics, of.ways, score_row);

/* --- profiles --- */

enum { PER_DECADE = 10 };

static int curves(const void *context)
{
	return 2*((const struct cli_compare_statics *)context)->of.ways;
}

/* Rows 1, 1.26, 1.58 ... up to the largest value of any curve. */
static size_t steps(const void *parent)
{
	const struct cli_compare_statics *result = parent;
	double most = 1.0;

	for (int by = 0; by < 2; by++)
		for (int i = 0; i < result->of.ways*result->of.nets; i++)
			if (isfinite(result->sorted[by][i]) && !(by == 0 && result->common->reproducible))
				most = fmax(most, result->sorted[by][i]);
	return (size_t)ceil(PER_DECADE*log10(most)) + 1;
}

static double within(size_t index)
{
	return pow(10.0, (double)index/PER_DECADE);
}

static const void *step_row(void *to, const void *parent, size_t index)
{
	(void)parent;
	*(double *)to = within(index);
	return to;
}

/* Part of the nets that a way has solved within this value. */
static double share(const struct cli_compare_statics *result, size_t index, int way, int by)
{
	const double *value = result->sorted[by] + (size_t)way*(size_t)result->of.nets;
	int count = 0;

	while (count < result->of.nets && value[count] <= within(index)*(1.0 + 1e-12))
		count++;
	return result->of.nets > 0 ? (double)count/result->of.nets : NAN;
}

/* Of the first half of the curves by time, of the others by iterations. */
static double part_at(const void *context, const void *parent, size_t index, int k)
{
	const struct cli_compare_statics *result = parent;
	int ways = result->of.ways;

	(void)context;
	return k < ways ? timed(result, share(result, index, k, 0)) : share(result, index, k - ways, 1);
}

static void column_name(char *text, size_t size, const void *context, int k)
{
	const struct cli_compare_statics *result = context;
	int ways = result->of.ways;

	snprintf(text, size, "%s_%s", k < ways ? "time" : "iterations",
	         result->of.score[k % ways].way->name);
}

static void key_name(char *text, size_t size, const void *context, int k)
{
	const struct cli_compare_statics *result = context;
	int ways = result->of.ways;

	snprintf(text, size, "%s%c%s", k < ways ? "time" : "iterations", HAWSER__NESTED,
	         result->of.score[k % ways].way->name);
}
static const struct hawser__vector
	column_vector = {.shown = "time_METHOD", .count = curves, .name = column_name, .number = part_at},
	key_vector = {.shown = "METHOD", .count = curves, .name = key_name, .number = part_at, .object = 1};
static const struct hawser__field step_field[] = {
	{"within", "within", "ratio of times, and number of iterations",
	 .kind = HAWSER__REAL, .offset = 0, .size = sizeof(double)},
	{NULL, "", "part of the nets solved within this multiple of the least time of all methods; "
	 "iterations_METHOD: within this number of iterations", HAWSER__VECTOR_OF(column_vector),
	 .flags = HAWSER__NULL},
	HAWSER__END,
};
static const struct hawser__field curve_field[] = {
	{"within", NULL, "ratios of times, and numbers of iterations",
	 .kind = HAWSER__REAL, .offset = 0, .size = sizeof(double)},
	{"time", NULL, "time.METHOD: part of the nets solved within this multiple of the least time of all "
	 "methods; iterations.METHOD: within this number of iterations", HAWSER__VECTOR_OF(key_vector),
	 .flags = HAWSER__NULL},
	HAWSER__END,
};
const struct hawser__list cli_compare_statics_profile = {
	.field = step_field, .size = HAWSER__MADE_SIZE(double), .count = steps, .row = step_row};
static const struct hawser__list curve_list = {
	.field = curve_field, .size = HAWSER__MADE_SIZE(double), .count = steps, .row = step_row};

/* --- nets --- */

struct each {
	int net, elements, iterations;
	const char *scene, *name, *end;
	double d, h, length0, rho, EA, seconds, angle, residual;
};

static size_t outcomes(const void *parent)
{
	const struct cli_compare_statics *result = parent;

	return (size_t)result->of.ways*(size_t)result->of.nets;
}

static const void *each_row(void *to, const void *parent, size_t index)
{
	const struct cli_compare_statics *result = parent;
	int i = (int)index/result->of.ways, w = (int)index % result->of.ways;
	const struct hawser_net_outcome *from = &result->of.outcome[w*result->of.nets + i];
	struct each *row = to;

	*row = (struct each){
		.net = i + 1, .scene = result->nets > 0 ? result->net[i].name : NULL,
		.name = result->of.score[w].way->name, .end = hawser_net_end_name(from->end),
		.iterations = from->iterations, .seconds = timed(result, from->seconds),
		.angle = from->angle, .residual = from->residual, .elements = HAWSER__NO_INTEGER,
		.d = NAN, .h = NAN, .length0 = NAN, .rho = NAN, .EA = NAN};
	if (result->of.random) {
		const struct hawser_net_random *cable = &result->of.random[i];

		row->d = cable->d;
		row->h = cable->h;
		row->length0 = cable->length0;
		row->rho = cable->rho;
		row->EA = cable->EA;
		row->elements = cable->elements;
	}
	return row;
}

#define OF(member) HAWSER__AT(struct each, member)
#define MAYBE(member) OF(member), .flags = HAWSER__OMIT | HAWSER__INFINITE
static const struct hawser__field each_field[] = {
	{"net", "net", "number of the net", OF(net)},
	{"scene", "scene", "its file; the next six are of a random cable", MAYBE(scene)},
	{"d", "d", "horizontal distance of its supports", MAYBE(d), .unit = HAWSER__METRE},
	{"h", "h", "vertical distance", MAYBE(h), .unit = HAWSER__METRE},
	{"length0", "length0", "unstretched length", MAYBE(length0), .unit = HAWSER__METRE},
	{"rho", "rho", "mass per unstretched length", MAYBE(rho), .unit = HAWSER__KILOGRAM_M},
	{"EA", "EA", "stiffness", MAYBE(EA), .unit = HAWSER__NEWTON},
	{"elements", "elements", "of the mesh", MAYBE(elements)},
	{"method", "method", "as in the table of methods", OF(name)},
	{"end", "end", "solved, compressed, failed or wrong", OF(end)},
	{"iterations", "iterations", "of this method", OF(iterations)},
	{"seconds", "time", "processor time", MAYBE(seconds), .unit = HAWSER__SECOND},
	{"angle", "angle", "of the certificate", MAYBE(angle), .unit = HAWSER__RADIAN},
	{"residual", "residual", "of the certificate, over all loads", MAYBE(residual)},
	HAWSER__END,
};
#undef MAYBE
#undef OF
const struct hawser__list cli_compare_statics_each = {
	.field = each_field, .size = HAWSER__MADE_SIZE(struct each), .count = outcomes, .row = each_row};

/* --- JSON --- */

#define OF(member) HAWSER__AT(struct cli_compare_statics, member)
const struct hawser__field cli_compare_statics_field[] = {
	{"nets", NULL, "number of nets", OF(of.nets)},
	{"seed", NULL, "of the random cables", OF(of.seed)},
	{"tolerance", NULL, "of the methods: unbalanced force over the loads", OF(tolerance)},
	{"methods", NULL, "one object a method", HAWSER__OBJECTS_OF(cli_compare_statics_methods)},
	{"profile", NULL, "performance profiles", HAWSER__ARRAYS_OF(curve_list)},
	{"each", NULL, "with --each: each method on each net",
	 HAWSER__OBJECTS_OF(cli_compare_statics_each), .when = CLI_COMPARE_STATICS_EACH,
	 .flags = HAWSER__STREAM},
	HAWSER__END,
};
#undef OF

const struct cli_listing cli_compare_statics_listing[] = {
	{"Columns of the table:", score_field, 0},
	{"Columns with --profile:", step_field, 0},
	{"Columns with --each:", each_field, 0},
	{"Keys of JSON:", cli_compare_statics_field, 1},
	{NULL, NULL, 0},
};

/* cli/motion/integrate_span.c - hawser integrate --model fe: a span as a mesh of cable elements
 * in time. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion/integrate_span.h"
#include "cli/frame/progress.h"
#include "core/append.h"
#include "core/report.h"
#include "output/curves/plot_motions.h"

enum { PROBES = HAWSER_SPAN_PROBES, KNOWN = 1 };

struct result {
	const struct cli_common *common;
	const struct cli_integrate_span *settings;
	struct cli_span_run of;
	struct hawser_net_span_motion run;
	double error[PROBES][3], size[PROBES][3]; /* m, root mean squares: of `off` and of x */
};

/* --- fields --- */

/* x, vx, y, vy, z, vz, T of each probe. */
enum { SHOWN = 7 };

static double probed_at(const void *context, const void *parent, size_t row, int k)
{
	const struct result *result = parent;
	size_t at = row*PROBES + (size_t)(k/SHOWN);
	int c = k % SHOWN;

	(void)context;
	return c == 6 ? result->run.motion.T[at]
	       : c % 2 ? result->run.motion.v[at][c/2] : result->run.x[at][c/2];
}

static enum hawser__unit probed_unit(const void *context, int k)
{
	(void)context;
	return k % SHOWN == 6 ? HAWSER__NEWTON : k % SHOWN % 2 ? HAWSER__M_S : HAWSER__M;
}

static void probed_name(char *text, size_t size, const void *context, int k)
{
	static const char *const name[SHOWN] = {"x", "vx", "y", "vy", "z", "vz", "T"};

	(void)context;
	snprintf(text, size, "%s%c%s", hawser_net_span_probe(k/SHOWN), HAWSER__NESTED, name[k % SHOWN]);
}

static void column_name(char *text, size_t size, const void *context, int k)
{
	static const char *const name[SHOWN] = {"x", "vx", "y", "vy", "z", "vz", "T"};

	(void)context;
	snprintf(text, size, "%s_%s", name[k % SHOWN], hawser_net_span_probe(k/SHOWN));
}

static int probed(const void *context)
{
	(void)context;
	return PROBES*SHOWN;
}

static int axes(const void *context)
{
	(void)context;
	return 3*PROBES;
}

static double error_at(const void *context, const void *parent, size_t row, int k)
{
	(void)context, (void)row;
	return ((const struct result *)parent)->error[k/3][k % 3];
}

static void error_name(char *text, size_t size, const void *context, int k)
{
	(void)context;
	snprintf(text, size, "%c_%s", "xyz"[k % 3], hawser_net_span_probe(k/3));
}
static const struct hawser__vector
	column_vector = {.shown = "x_PROBE", .count = probed, .name = column_name, .number = probed_at,
	                 .unit = probed_unit},
	probed_vector = {.count = probed, .name = probed_name, .number = probed_at, .unit = probed_unit,
	                 .object = 1},
	error_vector = {.count = axes, .name = error_name, .number = error_at, .object = 1};

#define OF(member) HAWSER__ALONG(struct result, run.motion.member)
const struct hawser__field cli_span_history_field[] = {
	{"times", "t", "time", OF(time), .unit = HAWSER__S, .axis = "Time {/:Italic t}"},
	{NULL, "", "displacement from the equilibrium at a probe; vx_PROBE_m_s: velocity; T_PROBE_N: "
	 "tension", HAWSER__VECTOR_OF(column_vector)},
	{NULL, "kinetic", "energy", OF(kinetic), .unit = HAWSER__J},
	{NULL, "potential", "of strain, weight and constant loads, since the beginning", OF(potential),
	 .unit = HAWSER__J},
	{NULL, "work", "of the load and of moving ends", OF(work), .unit = HAWSER__J},
	{NULL, "dissipated", "by damping", OF(dissipated), .unit = HAWSER__J},
	{NULL, "slack", "number of elements without tension", OF(slack)},
	HAWSER__END,
};
static const struct hawser__field times_field[] = {
	{"times", NULL, "of the rows", OF(time), .unit = HAWSER__S},
	{"slack", NULL, "number of elements without tension", OF(slack)},
	HAWSER__END,
};
static const struct hawser__field probes_field[] = {
	{"PROBE", NULL, "lists x, vx, y, vy, z, vz, T", HAWSER__VECTOR_OF(probed_vector)},
	HAWSER__END,
};
static const struct hawser__field energy_field[] = {
	{"kinetic", NULL, "energy", OF(kinetic), .unit = HAWSER__J},
	{"potential", NULL, "of strain, weight and constant loads, since the beginning", OF(potential),
	 .unit = HAWSER__J},
	{"work", NULL, "of the load and of moving ends", OF(work), .unit = HAWSER__J},
	{"dissipated", NULL, "by damping", OF(dissipated), .unit = HAWSER__J},
	HAWSER__END,
};
#undef OF
#define ROWS(fields) {.field = (fields), .count_at = offsetof(struct result, run.rows)}
static const struct hawser__list history_list = ROWS(cli_span_history_field),
                                 times_list = ROWS(times_field), probes_list = ROWS(probes_field),
                                 energy_list = ROWS(energy_field);

static const char *fe_word(int value)
{
	(void)value;
	return "fe";
}

HAWSER__OF(end_of, const char *, struct result, of->run.interrupted ? "interrupted" : "complete")

#define OF(member) HAWSER__AT(struct result, member)
const struct hawser__field cli_span_field[] = {
	{"model", NULL, "fe: a mesh of cable elements", HAWSER__WORD_OF(0, fe_word)},
	{"scheme", NULL, "of time integration", OF(run.motion.scheme)},
	{"Omega", NULL, "forcing frequency; 0: none", OF(of.Omega), .unit = HAWSER__RADIAN_S},
	{"end", NULL, "complete or interrupted", HAWSER__TEXT_BY(end_of)},
	{"mesh.elements", NULL, "of the cable", OF(run.elements)},
	{"mesh.step", NULL, "of time; 0: by the local error", OF(run.step), .unit = HAWSER__SECOND},
	{"mesh.other", NULL, "elements of the second run, by which the error is estimated; its steps are "
	 "twice as long", OF(run.other), .when = KNOWN},
	{"mesh.error", NULL, "estimated error of a displacement by mesh and steps, root mean square, in m",
	 HAWSER__VECTOR_OF(error_vector), .when = KNOWN},
	{"", NULL, "", HAWSER__ARRAYS_OF(times_list), .flags = HAWSER__STREAM},
	{"probes", NULL, "by name", HAWSER__ARRAYS_OF(probes_list), .flags = HAWSER__STREAM},
	{"energy", NULL, "of the mesh", HAWSER__ARRAYS_OF(energy_list), .flags = HAWSER__STREAM},
	{"energy.closure", NULL, "largest error of the ledger, over its largest term",
	 OF(run.motion.closure)},
	{"tension.min", NULL, "least tension of an element, of all steps", OF(run.motion.least),
	 .unit = HAWSER__NEWTON},
	{"tension.min_at", NULL, "its time", OF(run.motion.least_at), .unit = HAWSER__SECOND},
	{"slack_at", NULL, "when an element first has no tension; null: never", OF(run.motion.slack_at),
	 .unit = HAWSER__SECOND, .flags = HAWSER__NULL},
	{"slack_S", NULL, "where, from end A", OF(run.slack_S), .unit = HAWSER__METRE,
	 .flags = HAWSER__NULL},
	HAWSER__END,
};
static const struct hawser__field cost_field[] = {
	{"steps", NULL, "of time", OF(run.motion.steps)},
	{"iterations", NULL, "of Newton's method", OF(run.motion.iterations)},
	{"switches", NULL, "changes of elements between slack and taut", OF(run.motion.switches)},
	HAWSER__END,
};
#undef OF

/* --- output --- */

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return (struct cli_head){result->common, "integrate",
		"mesh of cable elements that carry tension only", &result->of.model.scene,
		cli_si_view(result->run.off ? KNOWN : 0u), NULL, NULL, NULL};
}

/* "y_mid 0.12 %": errors relative to the motion, of what moves. */
static void error_comment(struct hawser__table *table, const struct result *result)
{
	char text[400] = "";
	double most = 1e-4*result->of.model.statics.length0; /* 1e-13 of the length is round-off */

	for (int i = 0; i < 3*PROBES; i++)
		most = fmax(most, result->size[i/3][i % 3]);
	for (int i = 0; i < 3*PROBES; i++) {
		double size = result->size[i/3][i % 3];

		if (size > 1e-9*most)
			hawser__append(text, sizeof text, ", ", "%c_%s %.2g %%", "xyz"[i % 3],
			               hawser_net_span_probe(i/3), 100.0*result->error[i/3][i % 3]/size);
	}
	hawser__table_comment(table, "estimated errors by mesh and steps, relative, root mean square: %s",
	                      *text ? text : "nothing moves");
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_net_span_motion *run = &result->run;
	char step[64] = "by the local error";

	if (run->step > 0.0)
		snprintf(step, sizeof step, "%.4g s", run->step);
	if (result->of.Omega > 0.0)
		hawser__table_comment(table, "Omega = %.12g rad/s", result->of.Omega);
	hawser__table_comment(table, "%d elements, steps of %s, scheme %s: %ld steps", run->elements, step,
	                      run->motion.scheme, run->motion.steps);
	if (run->off)
		error_comment(table, result);
	hawser__table_comment(table, "energy ledger closed to %.1e of its largest term",
	                      run->motion.closure);
	hawser__table_comment(table, "least tension %.6g N, at t = %.6g s", run->motion.least,
	                      run->motion.least_at);
	if (!isnan(run->motion.slack_at))
		hawser__table_comment(table, "slack: an element first has no tension at t = %.6g s, at S = "
		                      "%.6g m; %ld changes of elements between slack and taut",
		                      run->motion.slack_at, run->slack_S, run->motion.switches);
	if (*result->of.warning)
		hawser__table_comment(table, "warning: %s", result->of.warning);
	hawser__table_comment(table, "end: %s", end_of(result));
}

/* Mid-span: y and, if the cable leaves its plane, z. */
static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	static const char *const label[] = {"", "{/:Italic y}, mid-span", "{/:Italic z}, mid-span"};
	static const char *const word[] = {"kinetic", "potential", "work less dissipated"};
	const struct result *result = of;
	const struct hawser_net_motion *motion = &result->run.motion;
	struct hawser__axis place = hawser__axis_of("Displacement", "m", 0.0);
	struct hawser__axis energy = hawser__axis_of("Energy", "J", 0.0);
	double *net = malloc(((size_t)result->run.rows + 1)*sizeof *net);
	const double *value[] = {motion->kinetic, motion->potential, net};
	struct hawser__motions shown = {.rows = result->run.rows, .time = motion->time, .panels = 2,
		.axis = hawser__axis_of("Time {/:Italic t}", "s", 0.0)};
	enum hawser_status status;

	if (!net)
		return hawser__no_memory(report, "picture");
	for (int i = 0; i < result->run.rows; i++)
		net[i] = motion->work[i] - motion->dissipated[i];
	shown.panel[0] = (struct hawser__motion_panel){place, .stride = 3*PROBES};
	for (int k = 1; k < 3; k++)
		if (k == 1 || result->size[1][2] > 1e-6*result->size[1][1])
			shown.panel[0].curve[shown.panel[0].curves++] = (struct hawser__motion_curve){
				label[k], k, &result->run.x[1][k]};
	shown.panel[1] = (struct hawser__motion_panel){energy, .stride = 1, .curves = 3};
	for (int c = 0; c < 3; c++)
		shown.panel[1].curve[c] = (struct hawser__motion_curve){word[c], c + 3, value[c]};
	status = hawser__plot_motions(path, &shown, report);
	free(net);
	return status;
}

static const struct cli_showing showing = {
	.head = head, .comments = comments, .rows = &history_list, .fields = cli_span_field,
	.stats = cost_field, .draw = draw};

/* --- the run --- */

static void measure(struct result *result)
{
	const struct hawser_net_span_motion *run = &result->run;

	for (int p = 0; p < PROBES; p++)
		for (int k = 0; k < 3; k++) {
			double size = 0.0, error = 0.0;

			for (int i = 0; i < run->rows; i++) {
				double x = run->x[i*PROBES + p][k], e = run->off ? run->off[i*PROBES + p][k] : 0.0;

				size += x*x;
				error += e*e;
			}
			result->size[p][k] = sqrt(size/run->rows);
			result->error[p][k] = sqrt(error/run->rows);
		}
}

static enum hawser_status scheme_of(const char *name, struct hawser_report *report)
{
	const char *names[8];
	int count = 0, chosen;

	for (; count < 8 && hawser_net_scheme(count); count++)
		names[count] = hawser_net_scheme(count)->name;
	return name ? cli_choose(&chosen, "integrate", "method", name, names, count, report) : HAWSER_OK;
}

static enum hawser_status solve(struct result *result, struct hawser_report *report)
{
	const struct cli_integrate_span *settings = result->settings;
	struct cli_watch watch = {{.quiet = result->common->quiet}, "integrate"};
	struct hawser_net_span_motion_options options = {
		.mesh.elements = settings->elements, .scheme = settings->scheme,
		.tolerance = settings->tolerance, .progress = {cli_watch, &watch}};
	enum hawser_status status = scheme_of(settings->scheme, report);

	if (!status)
		status = cli_span_run(&result->of, result->common, &settings->texts, "integrate", report);
	if (status)
		return status;
	options.mesh.Omega = result->of.Omega;
	options.until = result->of.until;
	options.every = result->of.every;
	options.step = result->of.step;
	status = hawser_net_span_integrate(&result->run, &result->of.model.scene,
	                                   &result->of.model.statics, &options, report);
	cli_progress_end(&watch.progress);
	if (!status)
		measure(result);
	return status;
}

enum hawser_status cli_integrate_span(const struct cli_common *common,
                                      const struct cli_integrate_span *settings,
                                      struct hawser_report *report)
{
	struct result *result = calloc(1, sizeof *result);
	enum hawser_status status;

	if (!result)
		return hawser__no_memory(report, "integrate");
	result->common = common;
	result->settings = settings;
	status = solve(result, report);
	if (!status && *result->of.warning)
		cli_warn(result->of.warning);
	if (!status)
		status = cli_show(common, &showing, result, report);
	hawser_net_span_motion_clear(&result->run);
	cli_model_clear(&result->of.model);
	free(result);
	return status;
}

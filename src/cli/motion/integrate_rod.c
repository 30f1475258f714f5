/* cli/motion/integrate_rod.c - hawser integrate of a scene of kind `rod`: places, forces,
 * energies in time. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion/integrate_net.h"
#include "cli/frame/progress.h"
#include "core/report.h"
#include "output/structures/structures.h"
#include "output/drawing/animate.h"
#include "output/report/vtk.h"

enum { PATH = 4096 };
#define STRAINED 0.05 /* strain beyond which forces that are linear in it are doubtful */
#define COARSE 0.02   /* lengths of the rod: an error of places that is visible in a picture */

struct result {
	const struct cli_common *common;
	const struct cli_integrate_net *settings;
	struct hawser_rod rod;
	struct hawser_rod_motion motion;
	double probe[CLI_PROBES];
	struct cli_probed probed;
	char warning[512];
	enum hawser_status failed; /* of a frame */
	struct hawser_report of_frame;
};

/* --- probes: start, end, or m from the start --- */

static enum hawser_status add(void *to, const char *given, struct hawser_report *report)
{
	struct result *result = to;
	char *name = result->probed.name[result->probed.probes - 1];
	double *s = &result->probe[result->probed.probes - 1];
	enum hawser_status status = HAWSER_OK;

	if (!strcmp(given, "start"))
		*s = 0.0;
	else if (!strcmp(given, "end"))
		*s = result->rod.length;
	else
		status = cli_quantity(s, given, "m", CLI_NOT_NEGATIVE, "integrate", "probe", report);
	if (!status && *s > result->rod.length*(1.0 + 1e-12))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate", "--probe %s: the rod ends at "
		                      "%.9g m: give start, end, or a length from the start", given,
		                      result->rod.length);
	for (char *at = name; *at; at++)
		if (*at == ' ')
			*at = '_'; /* in names of columns */
	return status;
}

/* Without --probe: the free ends, or the middle. */
static enum hawser_status probes(struct result *result, struct hawser_report *report)
{
	const char *given = result->settings->probe;
	const struct cli_probe_adder by = {add, &result->probed, result};
	enum hawser_status status = cli_probes_add(&by, given, report);

	for (int end = 1; end >= 0 && !given && !status; end--)
		if (result->rod.hold[end] == HAWSER_ROD_FREE)
			status = cli_probes_add(&by, end ? "end" : "start", report);
	if (!status && result->probed.probes == 0) {
		result->probe[0] = 0.5*result->rod.length;
		snprintf(result->probed.name[result->probed.probes++], CLI_PROBE_NAME, "middle");
	}
	return status;
}

/* --- VTK: one file a row --- */

static int frame(void *data, const struct hawser_rod_frame *frame)
{
	struct result *result = data;
	const struct hawser__vtk_scalar scalar[] = {{"tension_N", frame->T}, {"moment_Nm", frame->M}};
	char path[PATH], title[64];

	if (!result->settings->vtk)
		return 0;
	snprintf(path, sizeof path, "%s-%05d.vtk", result->settings->vtk, frame->row);
	snprintf(title, sizeof title, "hawser integrate: a rod at %.9g s", frame->t);
	result->failed = hawser__vtk_write(path, &(struct hawser__vtk){
		.title = title, .points = frame->nodes, .lines = frame->nodes - 1, .x = frame->x,
		.scalars = 2, .scalar = scalar}, &result->of_frame);
	return result->failed != HAWSER_OK;
}

/* --- results --- */

static void comments(struct hawser__table *table, const void *of)
{
	const struct result *result = of;
	const struct hawser_rod_motion *motion = &result->motion;

	hawser__table_comment(table, "g = %.10g m/s^2; elements: %d; rho_inf = %.6g; %ld steps, %ld made "
	                      "shorter for their error, %ld halved; %ld iterations, %ld factorizations",
	                      result->rod.g, motion->elements, motion->rho_inf, motion->steps,
	                      motion->rejected, motion->splits, motion->iterations, motion->factored);
	hawser__table_comment(table, "ledgers: energy closed to %.1e of its largest term, momentum to "
	                      "%.1e N s, angular momentum to %.1e N m s", motion->closure,
	                      motion->momentum_gap, motion->angular_gap);
	if (motion->checked)
		hawser__table_comment(table, "errors of places: %.2g m by the steps (a run with each in "
		                      "halves), %.2g m by the mesh (a run with twice as many elements)",
		                      motion->step_error, motion->mesh_error);
	else
		hawser__table_comment(table, "errors of places are not known%s%s; sum of the local errors of "
		                      "all steps: %.2g m", *motion->unchecked.message ? ": " : "",
		                      motion->unchecked.message, motion->local_error);
	if (motion->interrupted)
		hawser__table_comment(table, "interrupted at %.6g s", motion->reached);
	if (*result->warning)
		hawser__table_comment(table, "%s", result->warning);
}

enum { WATER = 1 };
#define ROWS_OF(member) HAWSER__ALONG(struct result, motion.member)
#define AXES_OF(member) HAWSER__VECTOR_ALONG(struct result, motion.member, cli_axes)
#define ONE(member) HAWSER__IN(struct result, motion.member)
#define JOULE .unit = HAWSER__J /* an energy */
const struct hawser__field cli_rod_motion_field[] = {
	{"scheme", NULL, "of time integration", ONE(scheme)},
	{"rho_inf", NULL, "its spectral radius at high frequencies", ONE(rho_inf)},
	{"times", "t", "time", ROWS_OF(time), .unit = HAWSER__SECOND},
	{"", NULL, "", HAWSER__PART_OF(struct result, probed, cli_probed_field),
	 .from = HAWSER__IN_PARENT},
	{NULL, "", "of each probe: its place, tension and moment", HAWSER__VECTOR_OF(cli_probed_vector)},
	{"energy.kinetic", "kinetic", "kinetic energy", ROWS_OF(kinetic), JOULE},
	{"energy.strain", "strain", "energy of strain", ROWS_OF(strain), JOULE},
	{"energy.height", "height", "of the weight, from y = 0", ROWS_OF(height), JOULE},
	{"energy.work", "work", "of the loads, since the beginning", ROWS_OF(work), JOULE},
	{"energy.support", "support", "of the ends that are held", ROWS_OF(support), JOULE},
	{"energy.damped", "damped", "by damping.alpha", ROWS_OF(damped), JOULE},
	{"energy.lost", "lost", "by the scheme", ROWS_OF(lost), JOULE},
	{"energy.winch", "winch", "work of the winch, with the energy of the material that enters",
	 ROWS_OF(winch), JOULE, .place = 1},
	{"energy.water", "water", "work of the water: of buoyancy, drag and added mass", ROWS_OF(water),
	 JOULE, .place = 1, .when = WATER},
	{"energy.closure", NULL, "largest |lost| over the largest term", ONE(closure)},
	{"momentum.linear", "P_", "momentum", AXES_OF(momentum), .unit = HAWSER__NEWTON_SECOND},
	{"momentum.angular", "H_", "angular momentum about the origin", AXES_OF(angular),
	 .unit = HAWSER__NEWTON_METRE_SECOND},
	{"momentum.linear_gap", NULL, "largest error of its ledger", ONE(momentum_gap),
	 .unit = HAWSER__NEWTON_SECOND},
	{"momentum.angular_gap", NULL, "the same of the angular one", ONE(angular_gap),
	 .unit = HAWSER__NEWTON_METRE_SECOND},
	{"start.force", "start_F", "force of what holds the start", AXES_OF(force),
	 .unit = HAWSER__NEWTON},
	{"start.moment", "start_M", "its moment", AXES_OF(moment), .unit = HAWSER__NEWTON_METRE},
	{"turned", "turned_rev", "mean rotation about z since the beginning, revolutions",
	 ROWS_OF(turned)},
	{"length", "length", "unstretched length", ROWS_OF(length), .unit = HAWSER__METRE, .place = 1},
	{"step_error", NULL, "of places, from a run with steps in halves; null: not known",
	 ONE(step_error), .unit = HAWSER__METRE, .flags = HAWSER__NULL},
	{"mesh_error", NULL, "the same from a run with twice as many elements", ONE(mesh_error),
	 .unit = HAWSER__METRE, .flags = HAWSER__NULL},
	{"local_error", NULL, "sum of the local errors of all steps", ONE(local_error),
	 .unit = HAWSER__METRE},
	{"interrupted", NULL, "whether the run ended early",
	 HAWSER__FLAG_AT(struct result, motion.interrupted), .from = HAWSER__IN_PARENT},
	HAWSER__END,
};
static const struct hawser__list row_list = {
	.field = cli_rod_motion_field, .count_at = offsetof(struct result, motion.rows)};
static const struct hawser__field result_field[] = {
	{"", NULL, "", HAWSER__ARRAYS_OF(row_list)},
	HAWSER__END,
};
#define OF(member) HAWSER__AT(struct result, motion.member)
static const struct hawser__field stats_field[] = {
	{"elements", NULL, "of the mesh", OF(elements)},
	{"unknowns", NULL, "of the mesh", OF(unknowns)},
	{"steps", NULL, "of the scheme", OF(steps)},
	{"iterations", NULL, "of Newton's method", OF(iterations)},
	{"factorizations", NULL, "of its matrix", OF(factored)},
	{"rejected", NULL, "steps made shorter for their error", OF(rejected)},
	{"splits", NULL, "steps made in halves", OF(splits)},
	HAWSER__END,
};
#undef OF

static struct cli_head head(const void *of)
{
	const struct result *result = of;

	return cli_si_head(result->common, "integrate", result->motion.scheme, &result->probed,
	                   result->rod.water.density > 0.0 ? WATER : 0u);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;

	return hawser__plot_rod_motion(path, &result->motion, result->probed.name[0], report);
}

static const struct cli_showing showing = {.head = head, .comments = comments, .rows = &row_list,
                                           .fields = result_field, .stats = stats_field,
                                           .draw = draw};

/* --- the run --- */

static void gather(struct cli_probed *probed, const struct result *result)
{
	const struct hawser_rod_motion *motion = &result->motion;

	probed->rows = motion->rows;
	probed->x = (const double (*)[3])motion->x;
	probed->v = (const double (*)[3])motion->v;
	probed->T = motion->T;
	probed->M = motion->M;
	probed->s = result->probe;
}

static void judge(struct result *result)
{
	struct hawser_rod_motion *motion = &result->motion;
	double error = fmax(motion->step_error, motion->mesh_error);

	if (!motion->checked)
		motion->step_error = motion->mesh_error = NAN;
	if (motion->strain_most > STRAINED)
		snprintf(result->warning, sizeof result->warning,
		         "strains of up to %.3g %%: forces are linear in the strains, which holds for small "
		         "ones; check EA, GA and the loads, and their units", 100.0*motion->strain_most);
	else if (motion->checked && error > COARSE*result->rod.length)
		snprintf(result->warning, sizeof result->warning, "the error of places is %.2g m, or %.2g %% "
		         "of the length: give %s", error, 100.0*error/result->rod.length,
		         motion->mesh_error > motion->step_error ? "more elements"
		         : "a shorter --step or a smaller --rtol");
}

static enum hawser_status options_of(struct hawser_rod_motion_options *options,
                                     const struct result *result, struct hawser_report *report)
{
	const struct cli_integrate_net *settings = result->settings;
	enum hawser_status status;
	int known = 0;

	status = cli_integrate_times(&options->until, &options->every, &options->step, settings, "rod",
	                             report);
	for (int i = 0; hawser_rod_scheme(i) && settings->scheme; i++)
		known |= strcmp(hawser_rod_scheme(i)->name, settings->scheme) == 0;
	options->scheme = settings->scheme;
	if (!status && settings->scheme && !known)
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate", "--method %s: the scheme of "
		                      "rods is alpha", settings->scheme);
	return status;
}

static enum hawser_status solve(struct result *result, struct hawser_report *report)
{
	const struct cli_integrate_net *settings = result->settings;
	struct cli_watch watch = {{.quiet = result->common->quiet}, "integrate"};
	struct hawser_rod_motion_options options = {
		.initial = settings->initial, .tolerance = settings->tolerance,
		.skip_error = settings->skip_error, .probe = result->probe, .frame = frame, .data = result,
		.progress = {cli_watch, &watch}};
	enum hawser_status status = hawser__animate_check(settings->animate, "integrate", report);

	if (!status)
		status = cli_read_rod(&result->rod, result->common, report);
	if (!status)
		status = probes(result, report);
	options.probes = result->probed.probes;
	if (!status)
		status = options_of(&options, result, report);
	if (!status)
		status = hawser_rod_integrate(&result->motion, &result->rod, &options, report);
	cli_progress_end(&watch.progress);
	if (!status && result->failed) {
		*report = result->of_frame;
		status = result->failed;
	}
	if (!status && settings->vtk)
		status = hawser__vtk_series(settings->vtk, result->motion.time, result->motion.rows, report);
	if (!status && settings->animate)
		status = hawser__animate(settings->animate, &(struct hawser__animation){
			.time = result->motion.time, .x = (const double (*)[3])result->motion.shape,
			.rows = (int)result->motion.rows, .points = (int)result->motion.nodes,
			.frames = settings->frames,
			.water = result->rod.water.density > 0.0 ? &result->rod.water : NULL}, report);
	return status;
}

enum hawser_status cli_integrate_rod(const void *context, struct hawser_report *report)
{
	const struct cli_integrate_net *settings = context;
	struct result *result = calloc(1, sizeof *result);
	enum hawser_status status;

	if (!result)
		return hawser__no_memory(report, "integrate");
	result->common = settings->common;
	result->settings = settings;
	status = solve(result, report);
	if (!status && settings->state)
		status = hawser_rod_state_write(&result->motion, settings->state, report);
	if (!status) {
		judge(result);
		gather(&result->probed, result);
		if (*result->warning)
			cli_warn(result->warning);
		status = cli_show(settings->common, &showing, result, report);
	}
	hawser_rod_motion_clear(&result->motion);
	hawser_rod_clear(&result->rod);
	free(result);
	return status;
}

/* cli/motion/integrate_rod.c - hawser integrate of a scene of kind `rod`: places, forces,
 * energies in time. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/motion/integrate_net.h"
#include "cli/frame/progress.h"
#include "core/report.h"
#include "output/structures/plot_rod.h"
#include "output/drawing/animate.h"
#include "output/report/vtk.h"

enum { PROBES = 64, NAME = 32, PATH = 4096 };
#define STRAINED 0.05 /* strain beyond which forces that are linear in it are doubtful */
#define COARSE 0.02   /* lengths of the rod: an error of places that is visible in a picture */

struct result {
	const struct cli_common *common;
	const struct cli_integrate_net *settings;
	struct hawser_rod rod;
	struct hawser_rod_motion motion;
	double probe[PROBES];
	char name[PROBES][NAME], warning[512];
	int probes;
	enum hawser_status failed; /* of a frame */
	struct hawser_report of_frame;
};

/* --- probes: start, end, or m from the start --- */

static enum hawser_status add(struct result *result, const char *text, size_t length,
                              struct hawser_report *report)
{
	char *name;
	double *s;
	enum hawser_status status = HAWSER_OK;

	if (result->probes == PROBES || length >= NAME || length == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate", "--probe: at most %d places, "
		                    "with commas between them, of at most %d characters", PROBES, NAME - 1);
	name = result->name[result->probes];
	s = &result->probe[result->probes++];
	memcpy(name, text, length);
	name[length] = '\0';
	if (!strcmp(name, "start"))
		*s = 0.0;
	else if (!strcmp(name, "end"))
		*s = result->rod.length;
	else
		status = cli_quantity(s, name, "m", CLI_NOT_NEGATIVE, "integrate", "probe", report);
	if (!status && *s > result->rod.length*(1.0 + 1e-12))
		status = hawser__fail(report, HAWSER_ERR_ARGUMENT, "integrate", "--probe %s: the rod ends at "
		                      "%.9g m: give start, end, or a length from the start", name,
		                      result->rod.length);
	for (char *at = name; *at; at++)
		if (*at == ' ')
			*at = '_'; /* in names of columns */
	return status;
}

/* Without --probe: the free ends, or the middle. */
static enum hawser_status probes(struct result *result, struct hawser_report *report)
{
	const char *at = result->settings->probe;
	enum hawser_status status = HAWSER_OK;

	while (at && !status) {
		size_t length = strcspn(at, ",");

		status = add(result, at, length, report);
		at = at[length] ? at + length + 1 : NULL;
	}
	for (int end = 1; end >= 0 && !result->settings->probe && !status; end--)
		if (result->rod.hold[end] == HAWSER_ROD_FREE)
			status = add(result, end ? "end" : "start", end ? 3 : 5, report);
	if (!status && result->probes == 0) {
		result->probe[0] = 0.5*result->rod.length;
		snprintf(result->name[result->probes++], NAME, "middle");
	}
	return status;
}

/* --- VTK: one file a row --- */

static int frame(void *data, const struct hawser_rod_frame *frame)
{
	struct result *result = data;
	const struct hawser__vtk_scalar scalar[] = {{"tension_N", frame->T}, {"moment_Nm", frame->M}};
	char path[PATH], title[64];
	int (*end)[2];

	if (!result->settings->vtk)
		return 0;
	end = malloc((size_t)frame->nodes*sizeof *end);
	if (!end) {
		result->failed = hawser__no_memory(&result->of_frame, "integrate");
		return 1;
	}
	for (int i = 0; i < frame->nodes - 1; i++) {
		end[i][0] = i;
		end[i][1] = i + 1;
	}
	snprintf(path, sizeof path, "%s-%05d.vtk", result->settings->vtk, frame->row);
	snprintf(title, sizeof title, "hawser integrate: a rod at %.9g s", frame->t);
	result->failed = hawser__vtk_write(path, &(struct hawser__vtk){
		.title = title, .points = frame->nodes, .lines = frame->nodes - 1, .x = frame->x,
		.end = (const int (*)[2])end, .scalars = 2, .scalar = scalar}, &result->of_frame);
	free(end);
	return result->failed != HAWSER_OK;
}

/* --- results --- */

static void fill_row(struct hawser__table *row, const void *of, size_t index)
{
	const struct result *result = of;
	const struct hawser_rod_motion *motion = &result->motion;
	const double *one[] = {motion->kinetic, motion->strain, motion->height, motion->work,
	                       motion->support, motion->damped, motion->lost};
	double (*const three[])[3] = {motion->momentum, motion->angular, motion->force, motion->moment};

	hawser__table_number(row, motion->time[index]);
	for (int p = 0; p < motion->probes; p++) {
		size_t at = index*(size_t)motion->probes + (size_t)p;

		for (int k = 0; k < 3; k++)
			hawser__table_number(row, motion->x[at][k]);
		hawser__table_number(row, motion->T[at]);
		hawser__table_number(row, motion->M[at]);
	}
	for (size_t i = 0; i < sizeof one/sizeof *one; i++)
		hawser__table_number(row, one[i][index]);
	for (size_t i = 0; i < sizeof three/sizeof *three; i++)
		for (int k = 0; k < 3; k++)
			hawser__table_number(row, three[i][index][k]);
	hawser__table_number(row, motion->turned[index]);
	hawser__table_number(row, motion->winch[index]);
	hawser__table_number(row, motion->length[index]);
}

static void comments(struct hawser__table *table, const struct result *result)
{
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

static void table(struct hawser__table *table, const void *of)
{
	static const char *const last[] = {
		"kinetic_J", "strain_J", "height_J", "work_J", "support_J", "damped_J", "lost_J", "P_x_Ns",
		"P_y_Ns", "P_z_Ns", "H_x_Nms", "H_y_Nms", "H_z_Nms", "start_Fx_N", "start_Fy_N", "start_Fz_N",
		"start_Mx_Nm", "start_My_Nm", "start_Mz_Nm", "turned_rev", "winch_J", "length_m"};
	const struct result *result = of;
	const struct hawser_rod_motion *motion = &result->motion;

	cli_echo_table(table, result->common, "integrate", NULL, motion->scheme);
	comments(table, result);
	hawser__table_column(table, "t_s");
	for (int p = 0; p < motion->probes; p++) {
		for (int k = 0; k < 3; k++)
			hawser__table_column(table, "%s_%c_m", result->name[p], "xyz"[k]);
		hawser__table_column(table, "%s_T_N", result->name[p]);
		hawser__table_column(table, "%s_M_Nm", result->name[p]);
	}
	for (size_t i = 0; i < sizeof last/sizeof *last; i++)
		hawser__table_column(table, "%s", last[i]);
	hawser__table_rows(table, (size_t)motion->rows, fill_row, result);
}

static void vectors(struct hawser__json *json, json_t *into, const char *key,
                    double (*const value)[3], int count)
{
	json_t *list = hawser__json_array(json, into, key);

	for (int i = 0; i < count; i++)
		hawser__json_numbers(json, list, NULL, value[i], 3, 1.0);
}

static void probes_json(struct hawser__json *json, const struct result *result)
{
	const struct hawser_rod_motion *motion = &result->motion;
	json_t *into = hawser__json_object(json, json->root, "probes");

	for (int p = 0; p < motion->probes; p++) {
		json_t *one = hawser__json_object(json, into, result->name[p]), *x, *v, *T, *M;

		hawser__json_number(json, one, "s", result->probe[p]);
		x = hawser__json_array(json, one, "x");
		v = hawser__json_array(json, one, "v");
		T = hawser__json_array(json, one, "T");
		M = hawser__json_array(json, one, "M");
		for (int i = 0; i < motion->rows; i++) {
			int at = i*motion->probes + p;

			hawser__json_numbers(json, x, NULL, motion->x[at], 3, 1.0);
			hawser__json_numbers(json, v, NULL, motion->v[at], 3, 1.0);
			hawser__json_number(json, T, NULL, motion->T[at]);
			hawser__json_number(json, M, NULL, motion->M[at]);
		}
	}
}

static void energy_json(struct hawser__json *json, const struct hawser_rod_motion *motion)
{
	const struct {
		const char *key;
		const double *value;
	} of[] = {{"kinetic", motion->kinetic}, {"strain", motion->strain}, {"height", motion->height},
	          {"work", motion->work}, {"support", motion->support}, {"damped", motion->damped},
	          {"lost", motion->lost}, {"winch", motion->winch}};
	json_t *into = hawser__json_object(json, json->root, "energy");

	for (size_t i = 0; i < sizeof of/sizeof *of; i++)
		hawser__json_numbers(json, into, of[i].key, of[i].value, motion->rows, 1.0);
	hawser__json_number(json, into, "closure", motion->closure);
	into = hawser__json_object(json, json->root, "momentum");
	vectors(json, into, "linear", motion->momentum, motion->rows);
	vectors(json, into, "angular", motion->angular, motion->rows);
	hawser__json_number(json, into, "linear_gap", motion->momentum_gap);
	hawser__json_number(json, into, "angular_gap", motion->angular_gap);
	into = hawser__json_object(json, json->root, "start");
	vectors(json, into, "force", motion->force, motion->rows);
	vectors(json, into, "moment", motion->moment, motion->rows);
}

static void json(struct hawser__json *json, const void *of)
{
	const struct result *result = of;
	const struct hawser_rod_motion *motion = &result->motion;
	json_t *into;

	cli_echo_json(json, result->common, "integrate", NULL);
	hawser__json_text(json, json->root, "scheme", motion->scheme);
	hawser__json_number(json, json->root, "rho_inf", motion->rho_inf);
	hawser__json_numbers(json, json->root, "times", motion->time, motion->rows, 1.0);
	probes_json(json, result);
	energy_json(json, motion);
	hawser__json_numbers(json, json->root, "turned", motion->turned, motion->rows, 1.0);
	hawser__json_numbers(json, json->root, "length", motion->length, motion->rows, 1.0);
	if (motion->checked) {
		hawser__json_number(json, json->root, "step_error", motion->step_error);
		hawser__json_number(json, json->root, "mesh_error", motion->mesh_error);
	} else {
		hawser__json_null(json, json->root, "step_error");
		hawser__json_null(json, json->root, "mesh_error");
	}
	hawser__json_number(json, json->root, "local_error", motion->local_error);
	hawser__json_flag(json, json->root, "interrupted", motion->interrupted);
	cli_warnings_json(json, *result->warning ? result->warning : NULL);
	into = cli_stats_json(json, result->common);
	hawser__json_integer(json, into, "elements", motion->elements);
	hawser__json_integer(json, into, "unknowns", motion->unknowns);
	hawser__json_integer(json, into, "steps", motion->steps);
	hawser__json_integer(json, into, "iterations", motion->iterations);
	hawser__json_integer(json, into, "factorizations", motion->factored);
	hawser__json_integer(json, into, "rejected", motion->rejected);
	hawser__json_integer(json, into, "splits", motion->splits);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct result *result = of;

	return hawser__plot_rod_motion(path, &result->motion, result->name[0], report);
}

static const struct cli_showing showing = {.table = table, .json = json, .draw = draw};

/* --- the run --- */

static void judge(struct result *result)
{
	const struct hawser_rod_motion *motion = &result->motion;
	double error = fmax(motion->step_error, motion->mesh_error);

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
	options.probes = result->probes;
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
			.frames = settings->frames}, report);
	return status;
}

enum hawser_status cli_integrate_rod(const struct cli_common *common,
                                     const struct cli_integrate_net *settings,
                                     struct hawser_report *report)
{
	struct result *result = calloc(1, sizeof *result);
	enum hawser_status status;

	if (!result)
		return hawser__no_memory(report, "integrate");
	result->common = common;
	result->settings = settings;
	status = solve(result, report);
	if (!status && settings->state)
		status = hawser_rod_state_write(&result->motion, settings->state, report);
	if (!status) {
		judge(result);
		status = cli_show(common, &showing, result, report);
	}
	if (!status && *result->warning)
		cli_warn(result->warning);
	hawser_rod_motion_clear(&result->motion);
	hawser_rod_clear(&result->rod);
	free(result);
	return status;
}

/* cli/statics/statics_rod.c - hawser statics of a scene of kind `rod`: shape, forces and moments.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/statics/statics_kinds.h"
#include "core/report.h"
#include "output/structures/structures.h"
#include "output/report/vtk.h"

#define STRAINED 0.05 /* strain beyond which forces that are linear in it are doubtful */
#define NO_STRAIN 1e-12 /* strains of an unloaded rod are rounding */
#define ROUGH 0.2     /* mesh error of forces over the largest force: a warning */
#define COARSE 0.02   /* mesh error, in lengths of the rod, that is visible in a picture */

static unsigned columns(const struct cli_rod *result)
{
	return result->scene.water.density > 0.0 ? CLI_ROD_WATER : 0u;
}

static struct cli_head head(const void *of)
{
	const struct cli_rod *result = of;

	return cli_si_head(result->common, "statics", result->st.flow ? "damped motion under the full load"
	                   : "Newton's method, load steps", NULL, columns(result));
}

static void support_comment(struct hawser__table *table, const struct hawser_rod_statics *st, int end)
{
	const double *f = st->force[end], *m = st->moment[end];

	hawser__table_comment(table, "support at the %s: force (%.9g, %.9g, %.9g) N, moment (%.9g, %.9g, "
	                      "%.9g) N.m", end ? "end" : "start", f[0], f[1], f[2], m[0], m[1], m[2]);
}

static void comments(struct hawser__table *table, const void *of)
{
	const struct cli_rod *result = of;
	const struct hawser_rod_statics *st = &result->st;
	const struct hawser__view view = cli_si_view(columns(result));

	hawser__table_comment(table, "g = %.10g m/s^2; elements: %d; %s: %d; iterations: %d",
	                      result->scene.g, st->elements, st->flow ? "steps of a damped motion"
	                      : "load steps", st->steps, st->iterations);
	for (int end = 0; end < 2; end++)
		if (result->scene.hold[end] != HAWSER_ROD_FREE)
			support_comment(table, st, end);
	hawser__fields_comments(table, cli_rod_number_field, st, &view);
	if (st->judged)
		hawser__table_comment(table, "the equilibrium is %s", st->negative ? "unstable" : "stable");
	else
		hawser__table_comment(table, "stability not judged: moments, following forces and a current "
		                      "have no potential");
	if (st->checked)
		hawser__table_comment(table, "mesh errors, from twice as many elements: %.2g m of places, "
		                      "%.2g N of forces, %.2g N.m of moments", st->error_x, st->error_N,
		                      st->error_M);
	else
		hawser__table_comment(table, "mesh errors are not known: %s", st->unchecked.message);
	if (*result->warning)
		hawser__table_comment(table, "%s", result->warning);
}

static enum hawser_status draw(const char *path, const void *of, struct hawser_report *report)
{
	const struct cli_rod *result = of;

	return hawser__plot_rod(path, &result->scene, &result->st, report);
}

static const struct cli_showing showing = {.head = head, .comments = comments,
                                           .rows = &cli_rod_point_list, .fields = cli_rod_field,
                                           .draw = draw};

static double largest_force(const struct hawser_rod_statics *st)
{
	double most = 0.0;

	for (int i = 0; i < st->points; i++) {
		const double *N = st->point[i].N;

		most = fmax(most, sqrt(N[0]*N[0] + N[1]*N[1] + N[2]*N[2]));
	}
	return most;
}

static void judge(struct cli_rod *result)
{
	const struct hawser_rod_statics *st = &result->st;

	result->stable = st->judged ? st->negative == 0 : HAWSER__NO_INTEGER;
	result->error_x = st->checked ? st->error_x : NAN;
	result->error_N = st->checked ? st->error_N : NAN;
	result->error_M = st->checked ? st->error_M : NAN;
	if (st->negative > 0)
		snprintf(result->warning, sizeof result->warning,
		         "the equilibrium is unstable, in %d direction%s: --load-steps 50 follows the rod as "
		         "the load grows, and a small load in the direction in which it gives way selects "
		         "what it does then", st->negative, st->negative == 1 ? "" : "s");
	else if (st->jump > 0.0)
		snprintf(result->warning, sizeof result->warning,
		         "from %.3g of the load on there is no equilibrium near the one that the rod comes to "
		         "as the load grows: it would move to another one, and this is one of them", st->jump);
	else if (st->other > 0.0)
		snprintf(result->warning, sizeof result->warning,
		         "there are several equilibria: this is the one that the rod comes to as the load "
		         "grows from none, and in another one a point is %.3g m away", st->other);
	else if (st->strain > STRAINED)
		snprintf(result->warning, sizeof result->warning,
		         "strains of up to %.3g %%: forces are linear in the strains, which holds for small "
		         "ones; check EA, GA and the loads, and their units", 100.0*st->strain);
	else if (st->checked && st->error_x > COARSE*result->scene.length)
		snprintf(result->warning, sizeof result->warning,
		         "the mesh error of places is %.2g m, or %.2g %% of the length: give more elements",
		         st->error_x, 100.0*st->error_x/result->scene.length);
	else if (!st->checked)
		snprintf(result->warning, sizeof result->warning,
		         "mesh errors are not known, since twice as many elements have no equilibrium near "
		         "this one: give more elements");
	else if (st->strain > NO_STRAIN && st->error_N > ROUGH*largest_force(st))
		snprintf(result->warning, sizeof result->warning,
		         "the mesh error of forces is %.2g N, of %.2g N at most: give more elements, above "
		         "all where the rod bends most", st->error_N, largest_force(st));
}

/* The nodes, and of each element the mean tension and moment. */
static enum hawser_status write_vtk(const char *path, const struct hawser_rod_statics *st,
                                    struct hawser_report *report)
{
	size_t points = (size_t)st->points;
	double (*x)[3] = malloc(points*sizeof *x), *T = malloc(points*sizeof *T);
	double *M = malloc(points*sizeof *M);
	const struct hawser__vtk_scalar scalar[] = {{"tension_N", T}, {"moment_Nm", M}};
	enum hawser_status status = x && T && M ? HAWSER_OK : hawser__no_memory(report, "statics");

	for (int i = 0; i < st->points && !status; i++) {
		const struct hawser_rod_point *p = &st->point[i], *next = p + (i + 1 < st->points);

		memcpy(x[i], p->x, sizeof x[i]);
		T[i] = 0.5*(p->N[0] + next->N[0]);
		M[i] = 0.5*(sqrt(p->M[0]*p->M[0] + p->M[1]*p->M[1] + p->M[2]*p->M[2]) +
		            sqrt(next->M[0]*next->M[0] + next->M[1]*next->M[1] + next->M[2]*next->M[2]));
	}
	if (!status)
		status = hawser__vtk_write(path, &(struct hawser__vtk){
			.title = "hawser statics: a rod", .points = st->points, .lines = st->points - 1,
			.x = (const double (*)[3])x, .scalars = 2, .scalar = scalar}, report);
	free(x);
	free(T);
	free(M);
	return status;
}

enum hawser_status cli_statics_rod(const void *settings, struct hawser_report *report)
{
	const struct cli_statics_kinds *kinds = settings;
	struct cli_rod result = {.common = &kinds->common};
	struct hawser_rod_options options = {.steps = kinds->load_steps};
	enum hawser_status status = cli_vtk_check(kinds->vtk, "statics", report);

	if (!status)
		status = cli_read_rod(&result.scene, &kinds->common, report);
	if (!status)
		status = hawser_rod_solve(&result.st, &result.scene, &options, report);
	if (!status) {
		judge(&result);
		if (kinds->vtk)
			status = write_vtk(kinds->vtk, &result.st, report);
	}
	if (!status && *result.warning)
		cli_warn(result.warning);
	if (!status)
		status = cli_show(&kinds->common, &showing, &result, report);
	hawser_rod_statics_clear(&result.st);
	hawser_rod_clear(&result.scene);
	return status;
}

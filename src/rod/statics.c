/* rod/statics.c - hawser_rod_solve: the equilibrium of a rod, and its mesh error.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/settle.h"
#include "rod/mesh.h"
#include "rod/so3.h"

#define ALIKE 1e-6 /* of the length: an equilibrium that is nearer is the same one */

void hawser_rod_settle(struct hawser_rod_options *options)
{
	hawser__settle_count(&options->refine, 1);
	hawser__settle_count(&options->steps, 1);
	hawser__settle(&options->tolerance, 1e-9); /* the next one would be 1e-16 */
}

/* Forces of fixed direction and buoyancy have a potential; moments in general and the drag of a current
 * have not. */
int hawser__rod_potential(const struct hawser_rod *rod)
{
	for (int i = 0; i < rod->water.levels; i++)
		if (hawser__dot(rod->water.current[i].u, rod->water.current[i].u) > 0.0)
			return 0;
	for (int i = 0; i < rod->loads; i++) {
		const struct hawser_rod_load *load = &rod->load[i];

		if (load->follower && hawser__dot(load->force, load->force) > 0.0)
			return 0;
		if (hawser__dot(load->moment, load->moment) > 0.0)
			return 0;
	}
	return 1;
}

static int negative(struct hawser__rod_mesh *mesh)
{
	(void)hawser__rod_strains(mesh);
	hawser__rod_tangent(mesh);
	return hawser__band_negative(&mesh->band, mesh->held, mesh->work);
}

/* Whether the equilibrium is stable. From an unstable one, look for another by a damped motion, which
 * finds one only if something pushes the rod out of its symmetry. */
static void judge(struct hawser_rod_statics *st, struct hawser__rod_mesh *mesh,
                  struct hawser__rod_effort *effort, double tolerance)
{
	struct hawser__rod_effort other = {.bent = -1};
	int left;
	size_t size = (size_t)mesh->nodes*sizeof *mesh->node;

	st->judged = hawser__rod_potential(mesh->rod);
	if (!st->judged)
		return;
	st->negative = negative(mesh);
	if (!st->negative || effort->flow)
		return;
	memcpy(mesh->found, mesh->node, size);
	other.iterations = effort->iterations;
	if (hawser__rod_flow(mesh, &other, tolerance) && (left = negative(mesh)) < st->negative) {
		*effort = other;
		st->negative = left;
	} else {
		memcpy(mesh->node, mesh->found, size);
	}
}

/* The state of `from` on a mesh with every element halved, with its strains. */
static void refine(struct hawser__rod_mesh *to, const struct hawser__rod_mesh *from)
{
	for (int e = 0; e < from->elements; e++) {
		const struct hawser__rod_node *a = &from->node[e], *b = &from->node[e + 1];
		struct hawser__rod_node *middle = &to->node[2*e + 1];
		double half[3];

		to->node[2*e] = *middle = *a;
		to->node[2*e + 2] = *b;
		for (int k = 0; k < 3; k++) {
			half[k] = 0.5*from->strain[e].psi[k];
			for (int part = 0; part < 2; part++)
				to->strain[2*e + part].w[k] = to->element[2*e + part].w0[k] + from->strain[e].w[k] -
				                              from->element[e].w0[k];
		}
		hawser__quaternion_turn(middle->q, half);
	}
	hawser__rod_place(to);
}

/* Errors of order h^2: 4/3 of the largest difference from twice as many elements. */
static void compare(struct hawser_rod_statics *st, const struct hawser_rod_statics *fine)
{
	double x = 0.0, N = 0.0, M = 0.0;

	for (int i = 0; i < st->points; i++) {
		const struct hawser_rod_point *a = &st->point[i], *b = &fine->point[2*i];
		double dx = 0.0, dN = 0.0, dM = 0.0;

		for (int k = 0; k < 3; k++) {
			dx += (a->x[k] - b->x[k])*(a->x[k] - b->x[k]);
			dN += (a->N[k] - b->N[k])*(a->N[k] - b->N[k]);
			dM += (a->M[k] - b->M[k])*(a->M[k] - b->M[k]);
		}
		x = fmax(x, dx);
		N = fmax(N, dN);
		M = fmax(M, dM);
	}
	st->checked = 1;
	st->error_x = 4.0/3.0*sqrt(x);
	st->error_N = 4.0/3.0*sqrt(N);
	st->error_M = 4.0/3.0*sqrt(M);
}

/* Only the lack of memory is a failure; without another solution the errors are not known. */
static enum hawser_status check(struct hawser_rod_statics *st, const struct hawser__rod_mesh *mesh,
                                const struct hawser_rod_options *options, struct hawser_report *report)
{
	struct hawser__rod_mesh fine;
	struct hawser__rod_effort effort;
	struct hawser_rod_statics other = {0};
	enum hawser_status status = hawser__rod_mesh_open(&fine, mesh->rod, 2*options->refine,
	                                                  &st->unchecked);

	if (!status) {
		refine(&fine, mesh);
		status = hawser__rod_equilibrium(&fine, &effort, 1, options->steps, NULL,
		                                 options->tolerance, &st->unchecked);
	}
	if (!status)
		status = hawser__rod_points(&other, &fine, &st->unchecked);
	if (!status)
		compare(st, &other);
	hawser_rod_statics_clear(&other);
	hawser__rod_mesh_clear(&fine);
	return status == HAWSER_ERR_MEMORY ? hawser__no_memory(report, "statics") : HAWSER_OK;
}

static enum hawser_status solve(struct hawser_rod_statics *st, struct hawser__rod_mesh *mesh,
                                const struct hawser_rod_options *options, struct hawser_report *report)
{
	struct hawser__rod_effort effort;
	enum hawser_status status = hawser__rod_equilibrium(mesh, &effort, 0, options->steps, NULL,
	                                                    options->tolerance, report);

	if (status)
		return status;
	judge(st, mesh, &effort, options->tolerance);
	st->elements = mesh->elements;
	st->steps = effort.steps;
	st->iterations = effort.iterations;
	st->flow = effort.flow;
	st->jump = effort.flow ? 0.0 : effort.jump;
	st->other = effort.other > ALIKE*mesh->rod->length ? effort.other : 0.0;
	st->increment = effort.increment;
	status = hawser__rod_points(st, mesh, report);
	return status || options->skip_error ? status : check(st, mesh, options, report);
}

enum hawser_status hawser_rod_solve(struct hawser_rod_statics *st, const struct hawser_rod *rod,
                                    const struct hawser_rod_options *given,
                                    struct hawser_report *report)
{
	struct hawser_rod_options options = given ? *given : (struct hawser_rod_options){0};
	struct hawser__rod_mesh mesh;
	enum hawser_status status;

	memset(st, 0, sizeof *st);
	hawser_rod_settle(&options);
	if (options.refine < 1 || options.steps < 1 || !(options.tolerance > 0.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "statics", "refine (%d), steps (%d) and "
		                    "tolerance (%g) must be positive", options.refine, options.steps,
		                    options.tolerance);
	if (rod->hold[0] == HAWSER_ROD_FREE && rod->hold[1] == HAWSER_ROD_FREE)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "statics", "both ends of the rod are free, "
		                    "so that nothing holds it: give start: {hold: clamped} or hinged, or the "
		                    "same of the end");
	status = hawser__rod_mesh_open(&mesh, rod, options.refine, report);
	if (!status)
		status = solve(st, &mesh, &options, report);
	hawser__rod_mesh_clear(&mesh);
	if (status)
		hawser_rod_statics_clear(st);
	return status;
}

void hawser_rod_statics_clear(struct hawser_rod_statics *st)
{
	if (!st)
		return;
	free(st->point);
	free(st->rest);
	memset(st, 0, sizeof *st);
}

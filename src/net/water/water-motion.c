/* net/water/water-motion.c - loads of the water in the time steps of a mesh.
 *
 * The loads are those at the middle of a step: of the mean places and the mean velocities, with the
 * direction of the elements there, so that drag and added mass are implicit. The flow is that where
 * the nodes are expected to be then, and does not change within a step.
 *
 * The ledger of a step, with the force f on a node, its increment x, and r = u - v:
 *   dissipated   h*(drag.r), >= 0
 * work f.x plus what is dissipated: so of drag h*f.u; and the change of the kinetic energy of
 * the added mass M: together with its inertia in f.x that is h*v'*(dM/dt)*v/2, as it turns
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/hold.h"
#include "core/report.h"
#include "core/vec3.h"
#include "net/motion/motion.h"
#include "net/water/water.h"

struct hawser__water_motion {
	double (*still)[3];  /* [nodes] N: loads at rest at the reference, which motion->base has */
	double (*force)[3];  /* [nodes] N, of the last residual, without those */
	double (*mid)[3];    /* [nodes] m: places in the step */
	struct hawser__water_there *there; /* [nodes] the flow there */
	double part;         /* of the increment, in the places of the step */
	double lost;         /* W, of the drag at the last residual */
	struct hawser__water_flow flow;
	struct hawser__hold hold;
};

void hawser__water_motion_clear(struct hawser__water_motion *water)
{
	if (!water)
		return;
	hawser__water_flow_clear(&water->flow);
	hawser__hold_clear(&water->hold);
	free(water);
}

void hawser__water_still(struct hawser__motion *motion)
{
	struct hawser__mesh *mesh = motion->mesh;

	hawser__water_load(mesh); /* at the reference */
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++)
			motion->water->still[i][k] = mesh->force[i][k] - mesh->water->dead[i][k];
}

enum hawser_status hawser__water_motion_open(struct hawser__motion *motion,
                                             struct hawser_report *report)
{
	struct hawser__mesh *mesh = motion->mesh;
	size_t nodes = (size_t)mesh->nodes;
	struct hawser__water_motion *water;
	enum hawser_status status;

	if (!mesh->water)
		return HAWSER_OK;
	water = motion->water = calloc(1, sizeof *water);
	if (!water)
		return hawser__no_memory(report, "net");
	water->still = hawser__hold(&water->hold, nodes, sizeof *water->still);
	water->force = hawser__hold(&water->hold, nodes, sizeof *water->force);
	water->mid = hawser__hold(&water->hold, nodes, sizeof *water->mid);
	water->there = hawser__hold(&water->hold, nodes, sizeof *water->there);
	motion->block = hawser__hold(&water->hold, nodes, sizeof *motion->block);
	motion->other = hawser__hold(&water->hold, (size_t)mesh->elements + 1, sizeof *motion->other);
	if (water->hold.short_of_memory)
		return hawser__no_memory(report, "net");
	status = hawser__water_flow_open(&water->flow, mesh->water->of, mesh->nodes, report);
	if (status)
		return status;
	hawser__water_still(motion);
	return HAWSER_OK;
}

/* The flow at the places and a time; exact: of rows, which must not change what comes later. */
static void flow(struct hawser__motion *motion, int exact, double t)
{
	struct hawser__water_motion *water = motion->water;

	hawser__water_flow_time(&water->flow, t);
	for (int i = 0; i < motion->nodes; i++)
		hawser__water_flow_at(&water->there[i], &water->flow, exact ? -1 : i, water->mid[i]);
}

/* Places of the step, with this part of the increment. */
static void place(struct hawser__motion *motion, double part)
{
	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++)
			motion->water->mid[i][k] = motion->reference[i][k] + motion->u0[i][k] +
			                           part*motion->x[i][k];
}

void hawser__water_prepare(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                           double h)
{
	/* without a velocity by the increment it is an acceleration, at the beginning */
	double part = rule->c[0] > 0.0 ? 0.5 : 0.0;

	motion->water->part = part;
	place(motion, part);
	flow(motion, 0, motion->t + part*h);
}

/* What flows past a node with the velocity v and the acceleration a. */
static void past(struct hawser__water_past *past, const struct hawser__water_motion *water, int node,
                 const double v[3], const double a[3])
{
	const struct hawser__water_there *there = &water->there[node];

	past->height = water->mid[node][1] - there->surface;
	for (int k = 0; k < 3; k++) {
		past->u[k] = there->u[k];
		past->r[k] = past->u[k] - v[k];
		past->du[k] = there->du[k];
		past->a[k] = a[k];
	}
}

/* The ends of an element, with the velocities v and accelerations a [nodes]. */
static void ends(struct hawser__water_end end[2], const struct hawser__motion *motion, int e,
                 const double (*v)[3], const double (*a)[3], struct hawser__water_past flow[2],
                 int slopes)
{
	const struct hawser__motion_element *el = &motion->element[e];
	const double *from = motion->water->mid[el->a], *to = motion->water->mid[el->b];
	const double d[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};

	past(&flow[0], motion->water, el->a, v[el->a], a[el->a]);
	past(&flow[1], motion->water, el->b, v[el->b], a[el->b]);
	hawser__water_ends(end, motion->mesh, e, d, flow, slopes);
}

/* Load and derivatives of an end at a node; m, c: of the acceleration and the velocity by x. */
static void put(struct hawser__motion *motion, int node, const struct hawser__water_end *end,
                const struct hawser__water_past *flow, double m, double c, int tangent)
{
	struct hawser__water_motion *water = motion->water;

	water->lost += hawser__dot(end->drag, flow->r);
	for (int k = 0; k < 3; k++)
		water->force[node][k] += end->load[k];
	for (int k = 0; k < 9 && tangent; k++)
		motion->block[node][k] += c*end->by_r[k/3][k%3] + m*end->mass[k/3][k%3];
}

/* The derivatives of the load of end i of an element by the places: rows [B, -B] or [-B, B] with a
 * block at the node. */
static void turn(struct hawser__motion *motion, int e, int i, const struct hawser__water_end *end)
{
	const struct hawser__motion_element *el = &motion->element[e];
	double *B = i ? motion->other[e] : motion->B[e], *block = motion->block[i ? el->b : el->a];
	double sign = i ? -motion->water->part : motion->water->part;

	for (int k = 0; k < 9; k++)
		B[k] += sign*end->by_d[k/3][k%3];
	for (int k = 0; k < 3; k++) {
		B[3*k + 1] += motion->water->part*end->by_y[!i][k];
		block[3*k + 1] -= motion->water->part*(end->by_y[0][k] + end->by_y[1][k]);
	}
}

double hawser__water_residual(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                              int tangent)
{
	const struct hawser__mesh *mesh = motion->mesh;
	struct hawser__water_motion *water = motion->water;
	const double (*v)[3] = (const double (*)[3])motion->vel, (*a)[3] = (const double (*)[3])motion->acc;
	struct hawser__water_past flow[2];
	struct hawser__water_end end[2];
	double most = 0.0;

	place(motion, water->part);
	water->lost = 0.0;
	memset(water->force, 0, (size_t)motion->nodes*sizeof *water->force);
	for (int e = 0; e < motion->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];

		ends(end, motion, e, v, a, flow, tangent);
		for (int i = 0; i < 2; i++) {
			put(motion, i ? el->b : el->a, &end[i], &flow[i], rule->m[0], rule->c[0], tangent);
			if (tangent)
				turn(motion, e, i, &end[i]);
		}
	}
	for (int i = 0; i < mesh->water->buoys; i++) {
		const struct hawser__mesh_buoy *buoy = &mesh->water->buoy[i];

		past(flow, water, buoy->node, v[buoy->node], a[buoy->node]);
		hawser__water_buoy(end, mesh, buoy->of, flow);
		put(motion, buoy->node, end, flow, rule->m[0], rule->c[0], tangent);
		for (int k = 0; k < 3 && tangent; k++)
			motion->block[buoy->node][3*k + 1] -= water->part*end->by_y[0][k];
	}
	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++) {
			water->force[i][k] -= water->still[i][k];
			motion->r[i][k] -= water->force[i][k];
			most = hawser__larger(most, fabs(water->force[i][k]));
		}
	return most;
}

/* To the state: the places. */
static void stay(struct hawser__motion *motion)
{
	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++)
			motion->water->mid[i][k] = motion->reference[i][k] + motion->u[i][k];
}

double hawser__water_kinetic(struct hawser__motion *motion)
{
	const struct hawser__mesh *mesh = motion->mesh;
	const struct hawser__water_motion *water = motion->water;
	double sum = 0.0;

	stay(motion);
	for (int e = 0; e < motion->elements; e++) {
		const int end[2] = {motion->element[e].a, motion->element[e].b};
		const double *v[2] = {motion->v[end[0]], motion->v[end[1]]};
		double d[3], height[2];

		for (int i = 0; i < 2; i++)
			height[i] = water->mid[end[i]][1] - water->there[end[i]].surface;
		for (int k = 0; k < 3; k++)
			d[k] = water->mid[end[1]][k] - water->mid[end[0]][k];
		sum += hawser__water_carried(mesh, e, d, height, v);
	}
	for (int i = 0; i < mesh->water->buoys; i++) {
		const struct hawser__mesh_buoy *buoy = &mesh->water->buoy[i];
		const double *v = motion->v[buoy->node];
		struct hawser__water_past flow;
		struct hawser__water_end end;

		past(&flow, water, buoy->node, v, v);
		hawser__water_buoy(&end, mesh, buoy->of, &flow);
		sum += 0.5*end.mass[0][0]*hawser__dot(v, v);
	}
	return sum;
}

void hawser__water_account(struct hawser__motion *motion, double h)
{
	double lost = h*motion->water->lost;

	motion->energy.dissipated += lost;
	motion->energy.work += lost;
	for (int i = 0; i < motion->nodes; i++)
		motion->energy.work += hawser__dot(motion->water->force[i], motion->x[i]);
}

void hawser__water_row(struct hawser__motion *motion, const double (*a)[3])
{
	struct hawser__water_past past[2];
	struct hawser__water_end end[2];

	stay(motion);
	flow(motion, 1, motion->t);
	for (int e = 0; e < motion->elements; e++) {
		ends(end, motion, e, (const double (*)[3])motion->v, a, past, 0);
		for (int k = 0; k < 6; k++)
			motion->mesh->water->load[e][k/3][k%3] = end[k/3].load[k%3];
	}
}

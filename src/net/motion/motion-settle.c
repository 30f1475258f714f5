/* net/motion/motion-settle.c - the equilibrium of a mesh that lies on planes which give way, as its
 * motion has it.
 *
 * Statics lets a cable leave a plane at nodes, the motion between them (net/motion/motion-touchdown.c):
 * at rest it begins where its own forces are in balance, which is nearer to that of a finer mesh. The
 * friction stays as it is. Loads, supports and waves that move are left out, as statics does.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/body.h"
#include "net/motion/motion-bed.h"
#include "net/water/water.h"

/* Most solutions, for the loads of the water, which are those of the places of the one before; and for
 * the tension by which cables rise from the plane, which is that of the reference. */
enum { ROUNDS = 5, DAMPED = 80, REFERENCES = 8 };
/* Of the longest element: it does not move any more. */
static const double STILL = 1e-12;
/* The same, from the last reference to the one before: it does not drift away. Chosen. */
static const double CREEP = 1e-3;
/* 1/s2, inverse squares of steps: the first, and the last before one without end; and the ratio of
 * two. Chosen: with the first, STILL is round-off of the forces. */
static const double SHORT = 1e4, LONG = 1e-3, LONGER = 4.0;

static double longest(const struct hawser__mesh *mesh)
{
	double most = 0.0;

	for (int e = 0; e < mesh->elements; e++)
		most = fmax(most, mesh->length0[e]);
	return most;
}

/* Add the last solution to motion->u; its largest part along an axis, and of motion->u in *far. */
static double advance(double *far, struct hawser__motion *motion)
{
	double most = 0.0;

	*far = 0.0;
	for (int n = 0; n < motion->nodes; n++)
		for (int k = 0; k < 3; k++)
			if (motion->mesh->unknown[n][k] >= 0) {
				most = fmax(most, fabs(motion->x[n][k]));
				motion->u[n][k] += motion->x[n][k];
				*far = fmax(*far, fabs(motion->u[n][k]));
			}
	return most;
}

/* Add the displacement to the equilibrium near the reference to motion->u; *found is 0 if there is
 * none, or a node moves by the length of an element. Where the matrix of Newton's method is not
 * definite, as where a cable leaves a bed that is bent, implicit steps of a motion that begins at rest
 * each time lead there: with the mass over the square of their length in the matrix. */
static enum hawser_status relax(struct hawser__motion *motion, int *found,
                                struct hawser_report *report)
{
	struct hawser__motion_rule rule = {.m = {0.0}, .c = {0.0}, .weight = 1.0};
	size_t size = (size_t)motion->nodes*sizeof *motion->u;
	double reach = longest(motion->mesh), last, far = 0.0;
	int rounds = ROUNDS, still = 0;
	enum hawser_status status = HAWSER_OK;

	memset(motion->v, 0, size);
	memset(motion->v0, 0, size);
	memset(motion->a0, 0, size);
	for (int i = 0; i < rounds && !status && !still && far < reach; i++) {
		memcpy(motion->u0, motion->u, size);
		memset(motion->x, 0, size);
		hawser__motion_prepare(motion, &rule, 1.0);
		status = hawser__motion_solve(motion, found, &rule, 1.0, report);
		if (!*found) {
			rule.m[0] = fmax(LONGER*rule.m[0], SHORT);
			rounds = DAMPED;
			continue;
		}
		last = advance(&far, motion);
		still = last <= STILL*reach && rule.m[0] <= SHORT;
		*found = far < reach && (still || rule.m[0] == 0.0);
		rule.m[0] = rule.m[0] > LONG ? rule.m[0]/LONGER : 0.0;
	}
	return status;
}

/* *most: how far a node moves, m; *found is 0 where no equilibrium was, and the places are as
 * before. */
static enum hawser_status settle(struct hawser__mesh *mesh, double *most, int *found,
                                 struct hawser_report *report)
{
	struct hawser__motion motion;
	enum hawser_status status;

	*most = 0.0;
	status = hawser__motion_open(&motion, mesh, NULL, 0.0, 1, NULL, report);
	for (int i = 0; i < mesh->touches && !status; i++)
		for (int k = 0; k < 3; k++)
			motion.base[mesh->touch[i].node][k] += mesh->touch[i].friction[k];
	if (!status && motion.bed->touchdowns)
		status = relax(&motion, found, report);
	for (int i = 0; i < motion.nodes && !status && *found; i++)
		for (int k = 0; k < 3; k++) {
			mesh->q[i][k] += motion.u[i][k];
			*most = fmax(*most, fabs(motion.u[i][k]));
		}
	if (!status && *found && motion.bed->touchdowns)
		hawser__bed_forces(mesh, motion.bed);
	hawser__motion_clear(&motion);
	return status;
}

enum hawser_status hawser__motion_settle(struct hawser__mesh *mesh, int *found,
                                         struct hawser_report *report)
{
	const struct hawser_water *water = mesh->water ? mesh->water->of : NULL;
	struct hawser_water calm;
	int waves = mesh->waves, motions = mesh->motions, soft = 0;
	double reach = longest(mesh), most = INFINITY;
	enum hawser_status status = HAWSER_OK;

	*found = 1;
	for (int i = 0; i < mesh->touches; i++)
		soft |= mesh->touch[i].give > 0.0;
	if (!soft)
		return HAWSER_OK;
	mesh->waves = mesh->motions = 0;
	if (water) {
		calm = *water;
		calm.waves.count = 0;
		mesh->water->of = &calm;
	}
	for (int i = 0; i < REFERENCES && !status && most > STILL*reach; i++)
		status = settle(mesh, &most, found, report);
	*found = *found && most <= CREEP*reach;
	mesh->waves = waves;
	mesh->motions = motions;
	if (water)
		mesh->water->of = water;
	return status;
}

enum hawser_status hawser__motion_seat(struct hawser_net *seated, const struct hawser_net *net,
                                       struct hawser__support_table *table, int tables,
                                       struct hawser_report *report)
{
	struct hawser_net first = *net; /* with its supports where they are at t = 0 */
	size_t nodes = (size_t)net->nodes;
	double rest, (*x)[3];
	enum hawser_status status;

	*seated = *net;
	if (!net->bodies)
		return HAWSER_OK;
	first.node = malloc(nodes*sizeof *first.node);
	x = malloc(nodes*sizeof *x);
	memset(seated, 0, sizeof *seated);
	status = first.node && x ? HAWSER_OK : hawser__no_memory(report, "net");
	for (size_t i = 0; i < nodes && !status; i++)
		memcpy(x[i], net->node[i].x, sizeof *x);
	if (!status)
		hawser__supports_begin(x, net, table, tables);
	for (size_t i = 0; i < nodes && !status; i++) {
		first.node[i] = net->node[i];
		memcpy(first.node[i].x, x[i], sizeof *x);
	}
	if (!status)
		status = hawser__bodies_seat(seated, &rest, &first, 1, report);
	for (size_t i = 0; i < nodes && !status; i++)
		if (!net->node[i].body)
			memcpy(seated->node[i].x, net->node[i].x, sizeof *x);
	free(first.node);
	free(x);
	return status;
}

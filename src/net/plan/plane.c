/* net/plan/plane.c - directions in which nothing moves a net.
 *
 * If the supports have one place along a horizontal axis, and no load, motion of a support or first
 * state has a component along it, all positions keep that place: the forces of the elements have no
 * component along it, exactly. The motion is then the same without these unknowns.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "net/motion/motion.h"

/* Vectors of a load: one, or those of the nodes of its cable. */
static int vectors(const struct hawser_net *net, const struct hawser_net_load *load)
{
	return load->along ? net->cable[load->cable].elements + 1 : 1;
}

static int loaded(const struct hawser_net *net, const struct hawser_net_load *load, int loads, int k)
{
	for (int i = 0; i < loads; i++)
		for (int j = 0; j < vectors(net, &load[i]); j++)
			if ((load[i].along ? load[i].along[j] : load[i].value)[k] != 0.0)
				return 1;
	return 0;
}

/* 1 if a groove holds nodes at another place along z than this. */
static int guided(const struct hawser_net *net, int k, double place)
{
	for (int s = 0; s < net->surfaces && k == 2; s++)
		if (net->surface[s].groove && net->surface[s].at[2] != place)
			return 1;
	return 0;
}

int hawser__net_still(double *place, const struct hawser_net *net, int k,
                      const struct hawser__support_table *table, int tables)
{
	int found = 0;

	*place = 0.0;
	if (k == 1 || net->water.file || net->water.air || loaded(net, net->load, net->loads, k) ||
	    loaded(net, net->motion, net->motions, k))
		return 0;
	if (net->water.waves.count && net->water.waves.along[k == 2] != 0.0)
		return 0;
	for (int i = 0; i < net->water.levels; i++)
		if (net->water.current[i].u[k] != 0.0)
			return 0;
	for (int i = 0; i < net->nodes; i++) {
		const struct hawser_net_node *node = &net->node[i];

		if (!node->held[k])
			continue;
		if (found++ == 0)
			*place = node->x[k];
		if (node->x[k] != *place)
			return 0;
	}
	for (int i = 0; i < net->bodies; i++) /* whose weight turns it */
		if (net->body[i].mass > 0.0 && net->body[i].centre[k] != *place)
			return 0;
	for (int i = 0; i < net->surfaces; i++) {
		const struct hawser_surface *surface = &net->surface[i];
		int flat = surface->kind == HAWSER_SURFACE_PLANE;

		/* circles, segments and profiles are in the plane of x and y, and move in it */
		if (flat ? surface->normal[k] != 0.0 || surface->velocity[k] != 0.0
		         : k == 0 || surface->kind == HAWSER_SURFACE_GRID)
			return 0;
	}
	for (int i = 0; i < net->absorbers; i++) /* one along k moves nothing else */
		if (net->absorber[i].direction[k] != 0.0 && fabs(net->absorber[i].direction[k]) < 1.0)
			return 0;
	for (int i = 0; i < tables; i++)
		for (int row = 0; row < table[i].rows; row++)
			if (table[i].x[row][k] != 0.0)
				return 0;
	return !guided(net, k, *place);
}

/* Horizontal vectors that span the plane: between supports, of loads and of motions. */
struct span {
	double along[2], size; /* the longest one so far, as a unit vector */
	int lines;             /* 1 while all are zero */
	int plane;             /* 0: not in one plane */
};

static void take(struct span *span, double x, double z, int compare)
{
	double length = hypot(x, z);

	if (length == 0.0)
		return;
	span->lines = 0;
	if (compare && fabs(x*span->along[1] - z*span->along[0]) > 1e-12*length)
		span->plane = 0;
	if (!compare && length > span->size) {
		span->along[0] = x/length;
		span->along[1] = z/length;
		span->size = length;
	}
}

static void take_all(struct span *span, const struct hawser_net *net, int compare)
{
	const double *origin = NULL;

	for (int i = 0; i < net->nodes; i++) {
		const struct hawser_net_node *node = &net->node[i];

		if (node->table || node->held[0] != node->held[2])
			span->plane = 0;
		if (!node->held[0])
			continue;
		origin = origin ? origin : node->x;
		take(span, node->x[0] - origin[0], node->x[2] - origin[2], compare);
	}
	for (int i = 0; i < net->loads + net->motions; i++) {
		const struct hawser_net_load *load = i < net->loads ? &net->load[i]
		                                                    : &net->motion[i - net->loads];

		for (int j = 0; j < vectors(net, load); j++) {
			const double *v = load->along ? load->along[j] : load->value;

			take(span, v[0], v[2], compare);
		}
	}
}

int hawser__net_plane(double normal[3], const struct hawser_net *net)
{
	struct span span = {.lines = 1, .plane = 1, .along = {1.0, 0.0}};

	take_all(&span, net, 0);
	take_all(&span, net, 1);
	normal[0] = -span.along[1];
	normal[1] = 0.0;
	normal[2] = span.along[0];
	return !span.plane ? 0 : span.lines ? 2 : 1;
}

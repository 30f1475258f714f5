/* net/read/pulled.c - contact.sliding: pulled: the ways of supports that are drawn from where
 * their lines hang loose, so that all friction acts towards the anchors.
 *
 * An anchor is a support on a plane. A support above it, at the height g over the plane and the
 * distance D from the anchor along it, has a line of length L between them, the shortest one over
 * the cables. At the distance L - g the line hangs straight down from the support to the plane,
 * without tension on it: its way begins there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/read/read.h"

/* Of the coordinates: a support is on a plane. */
static const double ON = 1e-9;
/* Of the way from there: it begins so much later, since with next to no tension it takes ten times
 * the iterations. Friction is less only where the tension does not come to that at this place. */
static const double LATER = 0.1;

/* The plane or bed with friction that the support is on, or NULL. */
static const struct hawser_surface *plane_of(const struct hawser_net *net, int node)
{
	const double *x = net->node[node].x;

	for (int s = 0; s < net->surfaces && net->node[node].support; s++) {
		const struct hawser_surface *plane = &net->surface[s];

		if ((plane->kind == HAWSER_SURFACE_PLANE || plane->heights) && plane->friction > 0.0 &&
		    fabs(hawser_surface_gap(NULL, NULL, plane, x)) <= ON*(1.0 + hawser__norm(x)))
			return plane;
	}
	return NULL;
}

/* Length of the shortest line over the cables from a node to all others, length [nodes]. */
static void lengths(double *length, const struct hawser_net *net, int node)
{
	int changed = 1;

	for (int i = 0; i < net->nodes; i++)
		length[i] = i == node ? 0.0 : INFINITY;
	while (changed) {
		changed = 0;
		for (int c = 0; c < 2*net->cables; c++) {
			const struct hawser_net_cable *cable = &net->cable[c/2];
			int a = c%2 ? cable->to : cable->from, b = c%2 ? cable->from : cable->to;

			if (length[a] + cable->value < length[b]) {
				length[b] = length[a] + cable->value;
				changed = 1;
			}
		}
	}
}

/* Where a line hangs down to from x: along the normal of a plane, below x on a bed. */
static void foot_of(double foot[3], const struct hawser_surface *plane, const double x[3])
{
	double n[3], g = hawser_surface_gap(n, NULL, plane, x);

	for (int k = 0; k < 3; k++)
		foot[k] = plane->heights ? x[k] : x[k] - g*n[k];
	if (plane->heights)
		foot[1] = hawser_heights_at(plane->heights, x[0], x[2]);
}

/* Where the way of a support begins; 0 if it has none. length [nodes] is for use here. */
static int begin_of(double x[3], double *length, const struct hawser_net *net, int node)
{
	const double *at = net->node[node].x;
	const struct hawser_surface *plane = NULL;
	double g, D, loose, way[3], foot[3];
	int anchor = -1;

	lengths(length, net, node);
	for (int i = 0; i < net->nodes; i++)
		if (isfinite(length[i]) && plane_of(net, i) && (anchor < 0 || length[i] < length[anchor])) {
			anchor = i;
			plane = plane_of(net, i);
		}
	if (anchor < 0 || anchor == node)
		return 0;
	foot_of(foot, plane, at);
	for (int k = 0; k < 3; k++)
		way[k] = foot[k] - net->node[anchor].x[k];
	g = hypot(hypot(at[0] - foot[0], at[1] - foot[1]), at[2] - foot[2]);
	D = hawser__norm(way);
	loose = fmax(length[anchor] - g, 0.0);
	if (!(loose < D))
		return 0;
	for (int k = 0; k < 3; k++)
		x[k] = at[k] - (1.0 - LATER)*(1.0 - loose/D)*way[k];
	return 1;
}

enum hawser_status hawser__net_pulled(struct hawser__reader *reader, struct hawser_net *net,
                                      const struct hawser__tree *tree)
{
	struct hawser_net_contact_given *contact = &net->contact;
	double *length = calloc((size_t)net->nodes + 1, sizeof *length), x[3];
	enum hawser_status status = HAWSER_OK;

	contact->path = calloc((size_t)net->nodes + 1, sizeof *contact->path);
	if (!length || !contact->path)
		status = hawser__no_memory(reader->report, "scene");
	for (int i = 0; i < net->nodes && !status; i++) {
		struct hawser_net_path *path = &contact->path[contact->paths];

		if (!net->node[i].support || !begin_of(x, length, net, i))
			continue;
		path->x = calloc(1, sizeof *path->x);
		if (!path->x)
			status = hawser__no_memory(reader->report, "scene");
		else
			memcpy(path->x[0], x, sizeof x);
		path->node = i;
		path->points = 1;
		contact->paths += !status;
	}
	free(length);
	if (!status && !contact->paths)
		status = hawser__reader_fail(reader, &tree->at,
		                             "contact.sliding: pulled: no support is drawn over a plane, "
		                             "profile or grid with friction: it needs an anchor on it, and "
		                             "a support above it whose line is not loose");
	return status;
}

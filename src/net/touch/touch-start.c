/* net/touch/touch-start.c - which nodes may touch which obstacle, and a start on the free side.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/touch/touch.h"

/* Of an element: where nodes begin above a circle or segment. */
static const double OFF = 0.1;

static int movable(const struct hawser__mesh *mesh, int node)
{
	const int *unknown = mesh->unknown[node];

	return unknown[0] >= 0 || unknown[1] >= 0 || unknown[2] >= 0;
}

int hawser__touch_around(const struct hawser_net *net)
{
	for (int s = 0; s < net->surfaces; s++)
		if (net->surface[s].side == HAWSER_SIDE_AROUND)
			return 1;
	return 0;
}

/* The area of nodes [nodes] on a surface that gives way: the diameters of cables times the halves of
 * their elements there, and what bodies have; NULL: no memory. */
static double *areas(const struct hawser__mesh *mesh, const struct hawser_net *net)
{
	double *area = calloc((size_t)mesh->nodes + 1, sizeof *area);

	for (int e = 0; area && e < 2*mesh->elements; e++)
		area[mesh->end[e/2][e%2]] += 0.5*mesh->length0[e/2]*net->cable[mesh->cable[e/2]].line.diameter;
	for (int i = 0; area && i < net->nodes; i++)
		area[i] += net->node[i].body ? net->body[net->node[i].body - 1].bearing : 0.0;
	return area;
}

/* Whether a node may touch a surface. */
static int may_touch(const struct hawser__mesh *mesh, int node, int element, double area,
                     const struct hawser_surface *surface)
{
	if (movable(mesh, node))
		return element >= 0;
	return mesh->stands && mesh->rigid[node] && area > 0.0 && surface->stiffness > 0.0 &&
	       (node >= mesh->net->nodes || mesh->stands[node]);
}

enum hawser_status hawser__touch_open(struct hawser__mesh *mesh, const struct hawser_net *net,
                                      struct hawser_report *report)
{
	size_t pairs = (size_t)mesh->nodes*(size_t)net->surfaces;
	int (*at)[2]; /* of a node, the last element with its end, and the one before */
	double *area;

	mesh->around = hawser__touch_around(net);
	if (!pairs)
		return HAWSER_OK;
	at = malloc((size_t)mesh->nodes*sizeof *at);
	mesh->touch = calloc(pairs, sizeof *mesh->touch);
	area = areas(mesh, net);
	for (int i = 0; at && i < mesh->nodes; i++)
		at[i][0] = at[i][1] = -1;
	for (int e = 0; at && e < mesh->elements; e++)
		for (int end = 0; end < 2; end++) {
			int *last = at[mesh->end[e][end]];

			last[1] = last[0];
			last[0] = 2*e + end;
		}
	for (int i = 0; at && area && mesh->touch && i < mesh->nodes*net->surfaces; i++) {
		const struct hawser_surface *surface = &net->surface[i % net->surfaces];
		int node = i/net->surfaces, *last = at[node];

		if (!may_touch(mesh, node, last[0], area[node], surface))
			continue;
		mesh->touch[mesh->touches++] = (struct hawser__touch){
			.surface = surface, .number = i % net->surfaces, .node = node,
			.element = last[0] < 0 ? -1 : last[0]/2, .end = last[0] < 0 ? 0 : last[0] % 2,
			.other = last[1] < 0 ? -1 : last[1]/2,
			.give = surface->stiffness > 0.0 ? 1.0/(surface->stiffness*area[node]) : 0.0};
	}
	pairs = at && area && mesh->touch;
	free(at);
	free(area);
	return pairs ? HAWSER_OK : hawser__no_memory(report, "net");
}

enum hawser_status hawser__touch_again(struct hawser__mesh *mesh, const struct hawser_net *net,
                                       struct hawser_report *report)
{
	struct hawser__touch *old = mesh->touch;
	int count = mesh->touches;
	enum hawser_status status;

	mesh->touch = NULL;
	mesh->touches = 0;
	status = hawser__touch_open(mesh, net, report);
	for (int i = 0, j = 0; !status && i < mesh->touches; i++) { /* both are in the order of the nodes */
		while (j < count && old[j].node < mesh->touch[i].node)
			j++;
		if (j < count && old[j].node == mesh->touch[i].node) {
			mesh->touch[i].r = old[j].r;
			mesh->touch[i].slides = old[j].slides;
			memcpy(mesh->touch[i].friction, old[j++].friction, sizeof mesh->touch[i].friction);
		}
	}
	free(old);
	return status;
}

enum hawser_status hawser__touch_none(const struct hawser_net *net, const char *command,
                                      struct hawser_report *report)
{
	const char *what = net->surfaces ? "obstacles" : net->water.air ? "wind"
		: net->water.density > 0.0 ? "water" : NULL;

	return !what ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: %s does not know %s in nets yet, "
	                      "hawser statics does: leave the section %s out",
	                      net->name ? net->name : "the net", command, what, what);
}

int hawser__touch_convex(const struct hawser__mesh *mesh)
{
	int convex = 1;

	for (int i = 0; i < mesh->touches && mesh->touch[i].node == mesh->touch[0].node; i++)
		convex = convex && hawser_surface_convex(mesh->touch[i].surface);
	return convex;
}

/* Off a circle or segment, by a part of an element: see hawser__touch_follow. */
static void lift(struct hawser__mesh *mesh, const struct hawser__touch *touch)
{
	const int *unknown = mesh->unknown[touch->node];
	double n[3], g = hawser_surface_gap(n, NULL, touch->surface, mesh->q[touch->node]);
	double off = OFF*mesh->length0[touch->element] - g;

	for (int k = 0; off > 0.0 && !hawser_surface_convex(touch->surface) && k < 3; k++)
		if (unknown[k] >= 0)
			mesh->q[touch->node][k] += off*n[k];
}

static double chord(const double a[3], const double b[3])
{
	return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* Nodes of a cable along its polygon `way` [n + 1], so that all elements have the same part of it. */
static void spread(struct hawser__mesh *mesh, int cable, const double (*way)[3], int n)
{
	double length = 0.0, begin = 0.0, next;
	int at = 0;

	for (int i = 0; i < n; i++)
		length += chord(way[i], way[i + 1]);
	next = chord(way[0], way[1]);
	for (int i = 1; i < n; i++) {
		double want = length*i/n, part, *q = mesh->q[mesh->inner[cable] + i - 1];

		while (at < n - 1 && begin + next < want) {
			begin += next;
			at++;
			next = chord(way[at], way[at + 1]);
		}
		part = next > 0.0 ? fmin((want - begin)/next, 1.0) : 0.0;
		for (int k = 0; k < 3; k++)
			q[k] = way[at][k] + part*(way[at + 1][k] - way[at][k]);
	}
}

/* A straight cable that was lifted over an obstacle has long elements beside it, from which the
 * interior point would draw the others at an element's length a step. */
static enum hawser_status spread_all(struct hawser__mesh *mesh, struct hawser_report *report)
{
	double (*way)[3] = malloc(((size_t)mesh->elements + 1)*sizeof *way);

	if (!way)
		return hawser__no_memory(report, "net");
	for (int c = 0; c < mesh->cables; c++) {
		int first = mesh->first[c], n = mesh->first[c + 1] - first;

		for (int i = 0; i <= n; i++)
			memcpy(way[i], mesh->q[i < n ? mesh->end[first + i][0] : mesh->end[first + n - 1][1]],
			       sizeof *way);
		spread(mesh, c, (const double (*)[3])way, n);
	}
	free(way);
	return HAWSER_OK;
}

/* Out of the obstacles that chords between nodes cut, by the shortest way. */
static void out(struct hawser__mesh *mesh)
{
	for (int i = 0; i < mesh->touches; i++) {
		const int *unknown = mesh->unknown[mesh->touch[i].node];
		double n[3], *q = mesh->q[mesh->touch[i].node];
		double g = hawser_surface_gap(n, NULL, mesh->touch[i].surface, q);

		for (int k = 0; g < 0.0 && k < 3; k++)
			if (unknown[k] >= 0)
				q[k] -= g*n[k];
	}
}

/* Twice, since obstacles may overlap. */
static void clear(struct hawser__mesh *mesh)
{
	for (int i = 0; i < 2*mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i % mesh->touches];
		const int *unknown = mesh->unknown[touch->node];
		double x[3];

		memcpy(x, mesh->q[touch->node], sizeof x);
		if (!hawser_surface_clear_of(x, touch->surface))
			continue;
		for (int k = 0; k < 3; k++)
			if (unknown[k] >= 0)
				mesh->q[touch->node][k] = x[k];
	}
}

enum hawser_status hawser__touch_start(struct hawser__mesh *mesh, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	clear(mesh);
	if (!hawser__touch_convex(mesh) && !mesh->around) {
		status = spread_all(mesh, report);
		out(mesh);
	}
	for (int i = 0; i < mesh->touches; i++)
		lift(mesh, &mesh->touch[i]);
	hawser__touch_measure(mesh);
	return status;
}

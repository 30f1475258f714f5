/* net/touch/touched.c - the contacts of a result, whether the net is on the side of the obstacles that
 * the scene says, and what is said where no equilibrium was found.
 *
 * A node that slides over the end of a segment leaves it, so that an element cuts the end. The ratio of
 * the tensions on both sides is then the cosine of the angle there, also without friction and with any
 * number of elements. Such a result is refused: the edge should be a circle. Where a circle goes on
 * from the end, an element from the segment to it cuts the end by no more than others cut the
 * circle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/touch/touch.h"

/* Of an element: a node is no further behind a surface that holds it. */
static const double ROUND = 1e-9;
/* Of an element: without an equilibrium, ends of segments within it are named as the reason. */
static const double NEAR = 2.0;
/* Friction at its bound, as of a surface that moves, has the round-off of a few products. */
static const double AT_BOUND = 1e-12;
/* Of an element: depth in a bed between its nodes beyond that of a parabola, which is what a rounded
 * corner is there, whatever its slopes. PLACES: where it is looked for. */
static const double DEEP = 0.1;
enum { PLACES = 8 };
/* Of a radius: the end of a segment that is no further from a circle is meant to be on it. */
static const double CLOSE = 1e-3;

double hawser__touch_friction(const struct hawser__touch *touch)
{
	return touch->surface->rotation == HAWSER_SURFACE_FREE ? 0.0 : touch->surface->friction;
}

int hawser__touch_sticks(const struct hawser__touch *touch)
{
	double bound = hawser__touch_friction(touch)*touch->r;
	const double *f = touch->friction;

	return bound > 0.0 && !touch->slides && !(touch->surface->axial > 0.0) &&
	       hawser__norm(f) < (1.0 - AT_BOUND)*bound;
}

/* Elements of one cable are of one length: form finding does not go with obstacles. */
static void contact_of(struct hawser_net_contact *to, const struct hawser__mesh *mesh,
                       const struct hawser__touch *touch, int nodes)
{
	*to = (struct hawser_net_contact){.surface = touch->number, .node = -1, .cable = -1, .r = touch->r};
	if (touch->node < nodes) {
		to->node = touch->node;
	} else {
		int e = touch->element, cable = mesh->cable[e];

		to->cable = cable;
		to->S = (e - mesh->first[cable] + touch->end)*hawser__mesh_length(mesh, e);
	}
	memcpy(to->x, mesh->q[touch->node], sizeof to->x);
	memcpy(to->friction, touch->friction, sizeof to->friction);
	to->sticks = hawser__touch_sticks(touch);
}

enum hawser_status hawser__touch_list(struct hawser_net_contact **list, int *count,
                                      const struct hawser__mesh *mesh, int nodes,
                                      struct hawser_report *report)
{
	double *half = calloc((size_t)mesh->nodes + 1, sizeof *half);
	int most = 0;

	for (int i = 0; i < mesh->touches; i++)
		most += mesh->touch[i].r > 0.0;
	*count = 0;
	*list = calloc((size_t)(most + nodes) + 1, sizeof **list);
	for (int e = 0; half && e < 2*mesh->elements; e++)
		half[mesh->end[e/2][e%2]] += hawser__mesh_length(mesh, e/2)/2.0;
	for (int i = 0; half && *list && i < mesh->touches; i++)
		if (mesh->touch[i].r > 0.0) {
			contact_of(&(*list)[*count], mesh, &mesh->touch[i], nodes);
			(*list)[(*count)++].length0 = half[mesh->touch[i].node];
		}
	most = half && *list;
	free(half);
	return most ? HAWSER_OK : hawser__no_memory(report, "net");
}

/* Distance of the axis through c from an element, seen along z. */
static double distance(const double c[3], const double a[3], const double b[3])
{
	double d[2] = {b[0] - a[0], b[1] - a[1]}, u[2] = {c[0] - a[0], c[1] - a[1]};
	double square = d[0]*d[0] + d[1]*d[1], part = square > 0.0 ? (u[0]*d[0] + u[1]*d[1])/square : 0.0;

	part = fmin(fmax(part, 0.0), 1.0);
	return hypot(u[0] - part*d[0], u[1] - part*d[1]);
}

/* 1 if an element passes the axis of a circle on the other side, or cuts it far from its rim. */
static int across(const struct hawser__mesh *mesh, int element, const struct hawser_surface *surface)
{
	const double *a = mesh->q[mesh->end[element][0]], *b = mesh->q[mesh->end[element][1]];
	double x = surface->at[0], y;

	if (surface->kind != HAWSER_SURFACE_CIRCLE || surface->side == HAWSER_SIDE_INSIDE)
		return 0;
	if (surface->side == HAWSER_SIDE_AROUND)
		return distance(surface->at, a, b) < 0.5*surface->radius;
	if ((a[0] - x)*(b[0] - x) >= 0.0)
		return 0;
	y = a[1] + (b[1] - a[1])*(x - a[0])/(b[0] - a[0]);
	return surface->side == HAWSER_SIDE_BELOW ? y > surface->at[1] : y < surface->at[1];
}

static enum hawser_status fail(const struct hawser__mesh *mesh, const struct hawser_net *net, int s,
                               int e, struct hawser_report *report)
{
	const char *cable = net->cable[mesh->cable[e]].name;
	const struct hawser_surface *surface = &net->surface[s];

	if (surface->side == HAWSER_SIDE_AROUND)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: cable %s cuts obstacle %s, "
		                    "since its elements of %.3g m are too long for the radius of %.3g m, or "
		                    "the places of its nodes do not lead around it: correct them, or give more "
		                    "elements", net->name, cable, surface->name, mesh->length0[e],
		                    surface->radius);
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: cable %s passes obstacle %s on the "
	                    "side that is not %s: there is no equilibrium there, or the elements of %.3g m "
	                    "are too long for the radius of %.3g m: correct its side, or give more "
	                    "elements", net->name, cable, surface->name,
	                    surface->side == HAWSER_SIDE_BELOW ? "below" : "above", mesh->length0[e],
	                    surface->radius);
}

/* 1 if a circle goes on from this end of a segment, as far as elements of length h tell: the end is no
 * further out than their sagitta, and the turn there no larger than that of one of them. */
static int goes_on(const struct hawser__mesh *mesh, const struct hawser_surface *segment,
                   const double end[3], double h)
{
	for (int i = 0; i < mesh->touches && mesh->touch[i].node == mesh->touch[0].node; i++) {
		const struct hawser_surface *circle = mesh->touch[i].surface;
		double n[3], cosine, g;

		if (circle->kind != HAWSER_SURFACE_CIRCLE || circle->side == HAWSER_SIDE_INSIDE)
			continue;
		g = hawser_surface_gap(n, NULL, circle, end);
		cosine = n[0]*segment->normal[0] + n[1]*segment->normal[1];
		if (h < circle->radius && g <= h*h/(8.0*circle->radius) && cosine >= cos(h/circle->radius))
			return 1;
	}
	return 0;
}

/* 1 if an element goes from the free side of a segment to the other one between its ends, at the point
 * x. Where the crossing is at an end to round-off, a node is on it. */
static int cuts(double x[2], const struct hawser__mesh *mesh, int element,
                const struct hawser_surface *segment)
{
	const double *a = mesh->q[mesh->end[element][0]], *b = mesh->q[mesh->end[element][1]];
	double least = ROUND*mesh->length0[element], l, along, side[2] = {0.0, 0.0}, part, beyond;
	double way[2] = {segment->to[0] - segment->at[0], segment->to[1] - segment->at[1]};
	int to;

	for (int k = 0; k < 2; k++) {
		side[0] += segment->normal[k]*(a[k] - segment->at[k]);
		side[1] += segment->normal[k]*(b[k] - segment->at[k]);
	}
	if ((side[0] < -least) == (side[1] < -least))
		return 0;
	part = fmin(fmax(side[0]/(side[0] - side[1]), 0.0), 1.0);
	for (int k = 0; k < 2; k++)
		x[k] = a[k] + part*(b[k] - a[k]);
	l = hypot(way[0], way[1]);
	along = ((x[0] - segment->at[0])*way[0] + (x[1] - segment->at[1])*way[1])/l;
	if (!(along > least && along < l - least))
		return 0;
	to = along > l/2.0;
	beyond = to ? l - along : along;
	return beyond > mesh->length0[element] ||
	       !goes_on(mesh, segment, to ? segment->to : segment->at, mesh->length0[element]);
}

/* The circle on which an end of a segment lies, with a radius that elements of length h are too long
 * for; NULL: none. */
static const struct hawser_surface *too_round(const struct hawser_net *net,
                                              const struct hawser_surface *segment, double h)
{
	for (int i = 0; i < 2*net->surfaces; i++) {
		const struct hawser_surface *circle = &net->surface[i/2];
		double n[3];

		if (circle->kind == HAWSER_SURFACE_CIRCLE && circle->radius <= h &&
		    fabs(hawser_surface_gap(n, NULL, circle, i%2 ? segment->to : segment->at)) <=
		    CLOSE*circle->radius)
			return circle;
	}
	return NULL;
}

static enum hawser_status cut(const struct hawser__mesh *mesh, const struct hawser_net *net, int s,
                              int e, const double x[2], struct hawser_report *report)
{
	const struct hawser_surface *circle = too_round(net, &net->surface[s], mesh->length0[e]);
	int c = mesh->cable[e], elements = mesh->first[c + 1] - mesh->first[c];

	if (circle)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: cable %s goes through obstacle "
		                    "%s at (%.6g, %.6g) m, since its elements of %.3g m are too long for the "
		                    "radius of %s, %.3g m: give it more elements than %.0f", net->name,
		                    net->cable[c].name, net->surface[s].name, x[0], x[1], mesh->length0[e],
		                    circle->name, circle->radius,
		                    ceil(elements*mesh->length0[e]/circle->radius));
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: cable %s goes through obstacle %s "
	                    "at (%.6g, %.6g) m: nodes do not stay on the sharp end of a segment, whatever "
	                    "their number: where the cable bends over it, end the segment on a circle with "
	                    "a radius above the elements' %.3g m; otherwise correct its side", net->name,
	                    net->cable[mesh->cable[e]].name, net->surface[s].name, x[0], x[1],
	                    mesh->length0[e]);
}

enum hawser_status hawser__touch_beyond(const struct hawser__mesh *mesh,
                                        const struct hawser__touch *touch, const double x[3], double t,
                                        struct hawser_report *report)
{
	const struct hawser_net *net = mesh->net;
	int e = touch->element;

	if (mesh->rigid[touch->node] || e < 0)
		return hawser__net_beyond(net, &net->node[touch->node], NULL, touch->surface, x, t, report);
	return hawser__net_beyond(net, NULL, net->cable[mesh->cable[e]].name, touch->surface, x, t, report);
}

enum hawser_status hawser__net_beyond(const struct hawser_net *net, const struct hawser_net_node *node,
                                      const char *cable, const struct hawser_surface *bed,
                                      const double x[3], double t, struct hawser_report *report)
{
	const struct hawser_heights *of = bed->heights;
	const char *body = node && node->body ? net->body[node->body - 1].name : NULL;
	char when[40] = "", across[80] = "";

	if (!isnan(t))
		snprintf(when, sizeof when, "at %.6g s ", t);
	if (of->nz > 1)
		snprintf(across, sizeof across, " and z from %.6g to %.6g m", of->z[0], of->z[of->nz - 1]);
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net",
	                    "%s: %s%s%s%s%s touches the bed %s at x = %.6g, z = %.6g m, beyond its "
	                    "points, x from %.6g to %.6g m%s: add points there, or hold the %s within "
	                    "them", net->name, when, node ? "node " : "cable ",
	                    node ? node->name : cable, body ? " of body " : "", body ? body : "", bed->name,
	                    x[0], x[2], of->x[0], of->x[of->nx - 1], across,
	                    body ? "body" : node ? "node" : "cable");
}

/* Depth in a bed at this part of the way from a to b; *most and x: the largest one, and where. */
static double depth(double *most, double x[3], const struct hawser_surface *bed, const double *a,
                    const double *b, double part)
{
	double at[3], deep;

	for (int k = 0; k < 3; k++)
		at[k] = a[k] + part*(b[k] - a[k]);
	deep = hawser_heights_at(bed->heights, at[0], at[2]) - at[1];
	if (deep > *most) {
		*most = deep;
		memcpy(x, at, sizeof at);
	}
	return deep;
}

/* Largest depth of an element in a bed between its ends, beyond that of these (m): at eight places, and
 * where it crosses the lines of the bed's points, at which crests are. It is 0 unless more than DEEP of
 * the length is beyond the sagitta of the parabola that has the bed's slopes near both ends: with their
 * difference s and the places l apart, s*l*PLACES^2/(PLACES - 1)/8. */
static double cut_of(double x[3], const struct hawser__mesh *mesh, const double (*q)[3], int e,
                     const struct hawser_surface *bed)
{
	const struct hawser_heights *of = bed->heights;
	const double *a = q[mesh->end[e][0]], *b = q[mesh->end[e][1]];
	double deep[PLACES + 1], most = -INFINITY, ends, sagitta;

	for (int i = 0; i <= PLACES; i++)
		deep[i] = depth(&most, x, bed, a, b, (double)i/PLACES);
	for (int i = 0; i < of->nx + of->nz; i++) {
		int k = i < of->nx ? 0 : 2;
		double line = k ? of->z[i - of->nx] : of->x[i];

		if ((line - a[k])*(line - b[k]) < 0.0)
			(void)depth(&most, x, bed, a, b, (line - a[k])/(b[k] - a[k]));
	}
	ends = fmax(fmax(deep[0], deep[PLACES]), 0.0);
	sagitta = (deep[1] - deep[0] + deep[PLACES - 1] - deep[PLACES])*PLACES*PLACES/(PLACES - 1.0)/8.0;
	most -= ends;
	return most - fmax(sagitta, 0.0) > DEEP*mesh->length0[e] ? most : 0.0;
}

enum hawser_status hawser__touch_passes(const struct hawser__mesh *mesh, const double (*q)[3],
                                        double t, struct hawser_report *report)
{
	const struct hawser_net *net = mesh->net;
	double x[3];
	char when[40] = "";

	if (!isnan(t))
		snprintf(when, sizeof when, "at %.6g s ", t);
	for (int i = 0; i < net->surfaces*mesh->elements; i++) {
		const struct hawser_surface *bed = &net->surface[i/mesh->elements];
		int e = i % mesh->elements;
		double deep = bed->heights ? cut_of(x, mesh, q, e, bed) : 0.0;

		if (deep > 0.0)
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: %scable %s passes through "
			                    "the bed %s at (%.6g, %.6g, %.6g) m, %.3g m below it, between two "
			                    "nodes: its elements of %.3g m are too long for what rises there: give "
			                    "it more elements, or obstacles.%s a rounding above them, with places "
			                    "further apart", net->name, when,
			                    net->cable[mesh->cable[e]].name, bed->name, x[0], x[1], x[2],
			                    deep, mesh->length0[e], bed->name);
	}
	return HAWSER_OK;
}

/* Beds with heights: cables that touch beyond the points, and elements that pass through what rises
 * between two nodes. */
static enum hawser_status beds(const struct hawser__mesh *mesh, struct hawser_report *report)
{
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];

		if (touch->r > 0.0 && hawser_surface_beyond(touch->surface, mesh->q[touch->node]))
			return hawser__touch_beyond(mesh, touch, mesh->q[touch->node], NAN, report);
	}
	return hawser__touch_passes(mesh, (const double (*)[3])mesh->q, NAN, report);
}

enum hawser_status hawser__touch_sides(const struct hawser__mesh *mesh, const struct hawser_net *net,
                                       struct hawser_report *report)
{
	double x[2];

	for (int s = 0; s < net->surfaces; s++)
		for (int e = 0; e < mesh->elements; e++) {
			if (across(mesh, e, &net->surface[s]))
				return fail(mesh, net, s, e, report);
			if (net->surface[s].kind == HAWSER_SURFACE_SEGMENT &&
			    cuts(x, mesh, e, &net->surface[s]))
				return cut(mesh, net, s, e, x, report);
		}
	return beds(mesh, report);
}

/* The end of a segment that is nearest to an element, within NEAR of its length; NULL if none is.
 * *surface, *element: of which. */
static const double *end_near(const struct hawser_surface **surface, int *element,
                              const struct hawser__mesh *mesh)
{
	const double *found = NULL;
	double least = NEAR;

	for (int i = 0; i < mesh->touches && mesh->touch[i].node == mesh->touch[0].node; i++) {
		const struct hawser_surface *of = mesh->touch[i].surface;
		const double *end[] = {of->at, of->to};

		for (int e = 0; e < 2*mesh->elements && of->kind == HAWSER_SURFACE_SEGMENT; e++) {
			const int *node = mesh->end[e/2];
			double off = distance(end[e % 2], mesh->q[node[0]], mesh->q[node[1]])/mesh->length0[e/2];

			if (!(off < least) || goes_on(mesh, of, end[e % 2], mesh->length0[e/2]))
				continue;
			least = off;
			found = end[e % 2];
			*surface = of;
			*element = e/2;
		}
	}
	return found;
}

enum hawser_status hawser__touch_lost(struct hawser__equilibrium *found, struct hawser__net_work *work,
                                      struct hawser_report *report)
{
	struct hawser__mesh *mesh = work->mesh;
	const struct hawser_surface *surface = NULL;
	const double *at;
	int e = 0;

	if (!isfinite(work->rest))
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "net", work->iterations, found->residual,
		                       "the equilibrium with obstacles was not found: the iteration left the "
		                       "range of numbers: check EA, rho, lengths and loads, and their units");
	memcpy(mesh->q, work->near, (size_t)mesh->nodes*sizeof *mesh->q);
	hawser__touch_measure(mesh);
	found->residual = work->residual_near;
	found->apart = work->apart_near;
	at = end_near(&surface, &e, mesh);
	if (at)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "net", work->iterations, found->residual,
		                       "the equilibrium with obstacles was not found: the net is at the end "
		                       "(%.6g, %.6g) m of obstacle %s, and nodes do not stay on the sharp end "
		                       "of a segment: end it on a circle with a radius above the elements' "
		                       "%.3g m",
		                       at[0], at[1], surface->name, mesh->length0[e]);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "net", work->iterations, found->residual,
	                       "the equilibrium with obstacles was not found: where it came nearest in %d "
	                       "iterations, the largest force that is not balanced is %.3g N, and nodes "
	                       "that touch are up to %.3g m off: %s", work->iterations, found->residual,
	                       found->apart, work->rubs ? "try smaller steps (contact.steps)"
	                                                : "try another number of elements");
}

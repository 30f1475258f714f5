/* net/touched.c - the contacts of a result, and whether the net is on the side of the obstacles that
 * the scene says. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/touch.h"

double hawser__touch_friction(const struct hawser__touch *touch)
{
	return touch->surface->rotation == HAWSER_SURFACE_FREE ? 0.0 : touch->surface->friction;
}

int hawser__touch_sticks(const struct hawser__touch *touch)
{
	double bound = hawser__touch_friction(touch)*touch->r;
	const double *f = touch->friction;

	return bound > 0.0 && !touch->slides && sqrt(f[0]*f[0] + f[1]*f[1] + f[2]*f[2]) < bound;
}

/* Elements of one cable are of one length: form finding does not go with obstacles. */
static void contact_of(struct hawser_net_contact *to, const struct hawser__mesh *mesh,
                       const struct hawser__touch *touch, int nodes)
{
	int cable = mesh->cable[touch->element], at = touch->element - mesh->first[cable] + touch->end;

	*to = (struct hawser_net_contact){.surface = touch->number, .node = -1, .cable = -1, .r = touch->r};
	if (touch->node < nodes) {
		to->node = touch->node;
	} else {
		to->cable = cable;
		to->S = at*mesh->length0[touch->element];
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
	*list = calloc((size_t)most + 1, sizeof **list);
	for (int e = 0; half && e < 2*mesh->elements; e++)
		half[mesh->end[e/2][e%2]] += mesh->length0[e/2]/2.0;
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

enum hawser_status hawser__touch_sides(const struct hawser__mesh *mesh, const struct hawser_net *net,
                                       struct hawser_report *report)
{
	for (int s = 0; s < net->surfaces; s++)
		for (int e = 0; e < mesh->elements; e++)
			if (across(mesh, e, &net->surface[s]))
				return fail(mesh, net, s, e, report);
	return HAWSER_OK;
}

/* net/touched.c - the contacts of a result, and whether the net is on the side of the obstacles that
 * the scene says. SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/touch.h"

/* Elements of one cable are of one length: form finding does not go with obstacles. */
static void contact_of(struct hawser_net_contact *to, const struct hawser__mesh *mesh,
                       const struct hawser__touch *touch, int nodes)
{
	int cable = mesh->cable[touch->element], at = touch->element - mesh->first[cable] + touch->end;
	double bound = touch->surface->friction*touch->r;
	const double *f = touch->friction;

	*to = (struct hawser_net_contact){.surface = touch->number, .node = -1, .cable = -1, .r = touch->r};
	if (touch->node < nodes) {
		to->node = touch->node;
	} else {
		to->cable = cable;
		to->S = at*mesh->length0[touch->element];
	}
	memcpy(to->x, mesh->q[touch->node], sizeof to->x);
	memcpy(to->friction, touch->friction, sizeof to->friction);
	to->sticks = bound > 0.0 && !touch->slides && sqrt(f[0]*f[0] + f[1]*f[1] + f[2]*f[2]) < bound;
}

enum hawser_status hawser__touch_list(struct hawser_net_statics *st, const struct hawser__mesh *mesh,
                                      struct hawser_report *report)
{
	int count = 0;
	double *half = calloc((size_t)mesh->nodes + 1, sizeof *half);

	for (int i = 0; i < mesh->touches; i++)
		count += mesh->touch[i].r > 0.0;
	st->contact = calloc((size_t)count + 1, sizeof *st->contact);
	for (int e = 0; half && e < 2*mesh->elements; e++)
		half[mesh->end[e/2][e%2]] += mesh->length0[e/2]/2.0;
	for (int i = 0; half && st->contact && i < mesh->touches; i++)
		if (mesh->touch[i].r > 0.0) {
			contact_of(&st->contact[st->contacts], mesh, &mesh->touch[i], st->nodes);
			st->contact[st->contacts++].length0 = half[mesh->touch[i].node];
		}
	count = half && st->contact;
	free(half);
	return count ? HAWSER_OK : hawser__no_memory(report, "net");
}

/* 1 if an element passes the axis of a circle on the other side. */
static int across(const struct hawser__mesh *mesh, int element, const struct hawser_surface *surface)
{
	const double *a = mesh->q[mesh->end[element][0]], *b = mesh->q[mesh->end[element][1]];
	double x = surface->at[0], y;

	if (surface->kind != HAWSER_SURFACE_CIRCLE || surface->side == HAWSER_SIDE_INSIDE ||
	    (a[0] - x)*(b[0] - x) >= 0.0)
		return 0;
	y = a[1] + (b[1] - a[1])*(x - a[0])/(b[0] - a[0]);
	return surface->side == HAWSER_SIDE_BELOW ? y > surface->at[1] : y < surface->at[1];
}

enum hawser_status hawser__touch_sides(const struct hawser__mesh *mesh, const struct hawser_net *net,
                                       struct hawser_report *report)
{
	for (int s = 0; s < net->surfaces; s++)
		for (int e = 0; e < mesh->elements; e++)
			if (across(mesh, e, &net->surface[s]))
				return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: cable %s passes "
				                    "obstacle %s on the side that is not %s: there is no equilibrium "
				                    "there, or the elements of %.3g m are too long for the radius "
				                    "of %.3g m: correct its side, or give more elements", net->name,
				                    net->cable[mesh->cable[e]].name, net->surface[s].name,
				                    net->surface[s].side == HAWSER_SIDE_BELOW ? "below" : "above",
				                    mesh->length0[e], net->surface[s].radius);
	return HAWSER_OK;
}

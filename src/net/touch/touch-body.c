/* net/touch/touch-body.c - nodes of rigid bodies on planes that give way.
 *
 * Statics of the lines has bodies as supports. In their own balance, and in all that follows, each of
 * their nodes has the force of a spring, -g/give along the normal where its gap g is below 0, and
 * friction only of a plane that moves: as nodes of lines that lie there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include "core/report.h"
#include "net/body.h"
#include "net/touch/touch.h"

/* Of the distance from the origin: what is less inside an obstacle is at its surface. */
static const double INSIDE = 1e-9;

enum hawser_status hawser__bodies_stand(struct hawser__mesh *mesh, const struct hawser_net *net,
                                        const unsigned char *loose, struct hawser_report *report)
{
	enum hawser_status status;

	if (!net->bodies || !net->surfaces)
		return HAWSER_OK;
	if (!mesh->stands)
		mesh->stands = hawser__hold(&mesh->hold, (size_t)net->nodes + 1, sizeof *mesh->stands);
	if (!mesh->stands)
		return hawser__no_memory(report, "net");
	for (int i = 0; i < net->nodes; i++)
		mesh->stands[i] = net->node[i].body && (!net->node[i].support || (loose && loose[i]));
	status = hawser__touch_again(mesh, net, report);
	if (!status)
		hawser__touch_measure(mesh);
	return status;
}

enum hawser_status hawser__bodies_land(struct hawser__mesh *mesh, const struct hawser_net *net,
                                       struct hawser_report *report)
{
	enum hawser_status status = hawser__bodies_stand(mesh, net, NULL, report);

	if (status || !mesh->stands)
		return status;
	for (int i = 0; i < mesh->touches; i++) {
		struct hawser__touch *touch = &mesh->touch[i];

		if (mesh->rigid[touch->node])
			touch->r = fmax(-touch->g/touch->give, 0.0);
	}
	hawser__touch_follow(mesh);
	return HAWSER_OK;
}

/* 1 if a node of a body has an area, with which it stands on an obstacle that gives way. */
static int has_area(const struct hawser_net *net, int node)
{
	int has = net->body[net->node[node].body - 1].bearing > 0.0;

	for (int c = 0; c < net->cables; c++)
		has |= (net->cable[c].from == node || net->cable[c].to == node) &&
		       net->cable[c].line.diameter > 0.0;
	return has;
}

enum hawser_status hawser__bodies_outside(const struct hawser_net *net, const double (*x)[3],
                                          double t, struct hawser_report *report)
{
	for (int i = 0; i < net->nodes*net->surfaces; i++) {
		const struct hawser_net_node *node = &net->node[i/net->surfaces];
		const struct hawser_surface *surface = &net->surface[i % net->surfaces];
		const double *at = x ? x[i/net->surfaces] : node->x;
		double size = fabs(at[0]) + fabs(at[1]) + fabs(at[2]), g;
		int soft = surface->stiffness > 0.0;
		char when[40] = "";

		if (!node->body || node->support)
			continue;
		g = hawser_surface_gap(NULL, NULL, surface, at);
		if (soft && has_area(net, i/net->surfaces)) {
			if (g < 0.0 && hawser_surface_beyond(surface, at))
				return hawser__net_beyond(net, node, NULL, surface, at, t, report);
			continue;
		}
		if (!isnan(t))
			snprintf(when, sizeof when, "at %.6g s ", t);
		if (g < -INSIDE*size)
			return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: %snode %s of body %s is "
			                    "%.4g m inside obstacle %s%s.%s%s, move the obstacle, or hold the body "
			                    "by lines", net->name, when, node->name,
			                    net->body[node->body - 1].name, -g, surface->name,
			                    soft ? ", on which it has no area: give bodies"
			                         : ", which is rigid, and bodies touch planes that give way: give "
			                           "obstacles",
			                    soft ? net->body[node->body - 1].name : surface->name,
			                    soft ? ".bearing (m2)" : ".stiffness, such as 3 MPa/m");
	}
	return HAWSER_OK;
}

/* net/body.c - rigid bodies of a net as parts of its mesh; see net/body.h.
 *
 * m, J   mass and moments of inertia of a body, about its axes
 * a      distance of the points of its mass from the centre, two on each axis, with the masses
 *        mu_k: J_x = 2 a^2 (mu_y + mu_z) and so on, 2 (mu_x + mu_y + mu_z) = m
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/body.h"

/* Of the distance of two hinges: what is nearer to their line is on it. */
static const double STRAIGHT = 1e-9;

static void points(struct hawser__mesh *mesh, const struct hawser_net_body *body, int number, int first)
{
	const double *centre = body->mass > 0.0 ? body->centre : mesh->q[body->node[0]];
	const double *J = body->inertia, sum = J[0] + J[1] + J[2];
	double square = body->mass > 0.0 ? sum/(2.0*body->mass) : 0.0, a = sqrt(square);

	for (int i = 0; i < HAWSER__BODY_POINTS; i++) {
		const double *axis = body->axes[i/2];
		int node = first + i;

		mesh->rigid[node] = number + 1;
		mesh->mass[node] = square > 0.0 ? fmax(0.5*sum - J[i/2], 0.0)/(2.0*square)
		                                : body->mass/HAWSER__BODY_POINTS;
		for (int k = 0; k < 3; k++) {
			mesh->q[node][k] = centre[k] + (i % 2 ? -a : a)*axis[k];
			mesh->unknown[node][k] = -1;
		}
	}
}

void hawser__bodies_open(struct hawser__mesh *mesh, const struct hawser_net *net, int first)
{
	for (int b = 0; b < net->bodies; b++)
		points(mesh, &net->body[b], b, first + HAWSER__BODY_POINTS*b);
}

/* 1 if a turn about this line moves neither a node nor the centre. */
static int on_line(const struct hawser_net *net, const struct hawser_net_body *body, const double at[3],
                   const double axis[3], double size)
{
	for (int i = 0; i <= body->nodes; i++) {
		const double *x = i < body->nodes ? net->node[body->node[i]].x : body->centre;
		double d[3], off[3];

		for (int k = 0; k < 3; k++)
			d[k] = x[k] - at[k];
		hawser__cross(off, axis, d);
		if (hawser__norm(off) > STRAIGHT*size && (i < body->nodes || body->mass > 0.0))
			return 0;
	}
	return 1;
}

int hawser__body_motions(double motion[6][6], double about[3], const struct hawser_net *net,
                         const struct hawser_net_body *body, const unsigned char *free)
{
	int hinge[3], hinges = 0;
	double axis[3] = {0.0}, size;

	memset(motion, 0, 36*sizeof(double));
	memset(about, 0, 3*sizeof *about);
	for (int i = 0; i < body->nodes && hinges < 3; i++)
		if (net->node[body->node[i]].support && !(free && free[body->node[i]]))
			hinge[hinges++] = body->node[i];
	for (int k = 0; k < 3 && !hinges; k++)
		for (int i = 0; i < body->nodes; i++)
			about[k] += net->node[body->node[i]].x[k]/body->nodes;
	if (hinges)
		memcpy(about, net->node[hinge[0]].x, 3*sizeof *about);
	for (int k = 0; k < (hinges ? 3 : 6) && hinges < 2; k++)
		motion[hinges ? 3 + k : k][k] = 1.0;
	if (hinges < 2)
		return hinges ? 3 : 6;
	for (int k = 0; k < 3; k++)
		axis[k] = net->node[hinge[1]].x[k] - net->node[hinge[0]].x[k];
	size = hawser__norm(axis);
	for (int k = 0; k < 3; k++)
		motion[3 + k][0] = axis[k] /= size;
	return hinges == 2 && !on_line(net, body, about, axis, size);
}

enum hawser_status hawser__bodies_none(const struct hawser_net *net, const char *what,
                                       struct hawser_report *report)
{
	return !net->bodies ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: %s does not know rigid bodies, "
	                      "which statics and integrate do: give supports in place of bodies",
	                      net->name ? net->name : "the net", what);
}

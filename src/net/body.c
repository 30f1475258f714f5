/* net/body.c - rigid bodies of a net as parts of its mesh; see net/body.h.
 *
 * m, J   mass and moments of inertia of a body, about its axes
 * a      distance of the points of its mass from the centre, two on each axis, with the masses
 *        mu_k: J_x = 2 a^2 (mu_y + mu_z) and so on, 2 (mu_x + mu_y + mu_z) = m
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
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

/* The displacement of a node by motion j of its body. */
static void moved(double x[3], const struct hawser__mesh *mesh, int node, int j)
{
	const struct hawser__mesh_body *body = &mesh->body[mesh->rigid[node] - 1];
	const double turn[3] = {body->motion[3][j], body->motion[4][j], body->motion[5][j]};
	const double *q = mesh->q[node], *at = body->about;

	hawser__cross(x, turn, (const double [3]){q[0] - at[0], q[1] - at[1], q[2] - at[2]});
	for (int k = 0; k < 3; k++)
		x[k] += body->motion[k][j];
}

void hawser__body_place(double x[3], const double *z, const struct hawser__mesh *mesh, int node)
{
	double one[3];

	memset(x, 0, 3*sizeof *x);
	for (int j = 0; j < mesh->body[mesh->rigid[node] - 1].motions; j++) {
		moved(one, mesh, node, j);
		for (int k = 0; k < 3; k++)
			x[k] += z[j]*one[k];
	}
}

void hawser__body_push(double *z, const struct hawser__mesh *mesh, int node, const double v[3])
{
	double one[3];

	for (int j = 0; j < mesh->body[mesh->rigid[node] - 1].motions; j++) {
		moved(one, mesh, node, j);
		z[j] += hawser__dot(one, v);
	}
}

/* The line of all that a body has, if there is one through its place: without it 0. */
static int straight(double axis[3], const struct hawser__mesh *mesh, int number)
{
	double size = 0.0, off[3], most = 0.0;

	for (int pass = 0; pass < 2; pass++)
		for (int i = 0; i < mesh->nodes; i++) {
			double r[3];

			if (mesh->rigid[i] != number + 1 || (i >= mesh->net->nodes && !(mesh->mass[i] > 0.0)))
				continue;
			for (int k = 0; k < 3; k++)
				r[k] = mesh->q[i][k] - mesh->body[number].about[k];
			if (pass == 0 && hawser__norm(r) > size) {
				size = hawser__norm(r);
				for (int k = 0; k < 3; k++)
					axis[k] = r[k]/size;
			}
			hawser__cross(off, axis, r);
			most = pass ? fmax(most, hawser__norm(off)) : 0.0;
		}
	return size > 0.0 && most <= STRAIGHT*size;
}

/* Without the turn about an axis: the two turns about those across it. */
static void two_turns(struct hawser__mesh_body *body, const double axis[3])
{
	int first = body->motions - 3, least = 0;
	double from[3] = {0.0}, across[2][3];

	for (int k = 1; k < 3; k++)
		least = fabs(axis[k]) < fabs(axis[least]) ? k : least;
	from[least] = 1.0;
	hawser__cross(across[0], axis, from);
	hawser__cross(across[1], axis, across[0]);
	for (int j = 0; j < 2; j++)
		for (int k = 0; k < 3; k++)
			body->motion[3 + k][first + j] = across[j][k]/hawser__norm(across[j]);
	body->motions--;
}

/* The moments of the forces that hold the body at rest, as their arms turn. At rest they are
 * symmetric. */
static void turns(struct hawser__mesh *mesh, int number, const double (*held)[3])
{
	struct hawser__mesh_body *body = &mesh->body[number];

	for (int i = 0; i < mesh->nodes; i++)
		for (int j = 0; j < body->motions && mesh->rigid[i] == number + 1; j++) {
			double x[3], moment[3];

			moved(x, mesh, i, j);
			for (int k = 0; k < 3; k++)
				x[k] -= body->motion[k][j];
			hawser__cross(moment, x, held[i]);
			for (int row = 0; row < body->motions; row++)
				for (int k = 0; k < 3; k++) {
					double half = 0.5*body->motion[3 + k][row]*moment[k];

					body->turned[row][j] += half;
					body->turned[j][row] += half;
				}
		}
}

enum hawser_status hawser__bodies_release(struct hawser__mesh *mesh, const struct hawser_net *net,
                                          struct hawser_report *report)
{
	double (*held)[3], axis[3];

	if (!net->bodies)
		return HAWSER_OK;
	mesh->body = hawser__hold(&mesh->hold, (size_t)net->bodies, sizeof *mesh->body);
	held = hawser__hold(&mesh->hold, (size_t)mesh->nodes + 1, sizeof *held);
	if (!mesh->body || !held)
		return hawser__no_memory(report, "net");
	hawser__mesh_gradient(held, NULL, mesh);
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];

		for (int k = 0; k < 3 && touch->r > 0.0; k++)
			held[touch->node][k] -= touch->r*touch->n[k] + touch->friction[k];
	}
	for (int b = 0; b < net->bodies; b++) {
		struct hawser__mesh_body *body = &mesh->body[b];

		body->first = mesh->unknowns;
		body->motions = hawser__body_motions(body->motion, body->about, net, &net->body[b], NULL);
		if (body->motions >= 3 && straight(axis, mesh, b))
			two_turns(body, axis);
		turns(mesh, b, (const double (*)[3])held);
		mesh->unknowns += body->motions;
		mesh->body_unknowns += body->motions;
	}
	return HAWSER_OK;
}

enum hawser_status hawser__bodies_none(const struct hawser_net *net, const char *what,
                                       struct hawser_report *report)
{
	return !net->bodies ? HAWSER_OK
	       : hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: %s does not know rigid bodies, "
	                      "which statics, modes, integrate and waves of frf do: give supports in place "
	                      "of bodies",
	                      net->name ? net->name : "the net", what);
}

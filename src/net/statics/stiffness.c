/* net/statics/stiffness.c - the tangent stiffness of an equilibrium at nodes that move as rigid
 * bodies.
 *
 * K     second derivative of the energy of the mesh, and what friction that slides and water add
 * u     displacements of all nodes for a unit motion of the body: those of its nodes are given, and
 *       K u = 0 at all others that are free
 * T, h  tension and length of an element
 *
 * The nodes of the bodies are held, and the others follow. Contacts stay as they are: a stiff spring
 * along the normal, and along the surface where a node sticks; the friction of one that slides
 * follows the normal force, which makes K unsymmetric.
 *
 * On a plane the cable leaves the ground between two nodes of the mesh, at the point where its
 * shear is zero, which the force of the last node that touches tells. To count the contact of that
 * node as it is would give a stiffness that jumps as nodes lift, with an error of the order of h.
 * So the cable is held at that point: a spring at the node before it, or a stiffer element behind
 * it. The error is of order h^2 then.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <hawser/net.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/body.h"
#include "net/motion/motion.h"
#include "net/touch/touch.h"
#include "net/water/water.h"

enum { MOTIONS = 6 };
/* The springs of contacts over the stiffness of the elements there: the error is the inverse. */
static const double STIFFER = 1e7;
/* Of that of an element without tension, at its nodes: nothing else may hold them. */
static const double LIFT = 1e-13;

struct tangent {
	const struct hawser_net *net;
	struct hawser__mesh *mesh;
	struct hawser__klu *klu;
	int *group;          /* [nodes of the mesh] 1 + number of the body that moves it; 0: none */
	int groups, size;    /* bodies; motions of each */
	int slips;           /* 1: what touches at rest has no friction, as in the equilibrium */
	const double (*about)[3]; /* [groups] */
	double (*held)[3];   /* [nodes of the mesh] N: force of the outside on those of bodies */
	double *total;       /* [groups][6] force and moment of the outside on each */
	double *K;           /* [6 groups][6 groups], column by column: change of these by a motion */
	double *T;           /* [elements] N */
	double (*block)[9];  /* [elements] N/m */
	double (*bed)[9];    /* [touches] N/m: of nodes of bodies */
	double (*u)[3];      /* [nodes of the mesh] m */
	double (*force)[3];  /* [nodes of the mesh] N */
	double *x;           /* [unknowns] */
	unsigned char *on;   /* [nodes of the mesh] 1: it touches an obstacle */
	struct hawser__hold memory;
};

/* A part of an element's block: stiffness along a direction. */
static void along(double block[9], double stiffness, const double n[3])
{
	for (int k = 0; k < 9; k++)
		block[k] += stiffness*n[k/3]*n[k%3];
}

static void elements(struct tangent *at)
{
	const struct hawser__mesh *mesh = at->mesh;

	for (int i = 0; i < mesh->elements; i++) {
		double e[3], h = hawser__mesh_direction(e, mesh, i);
		double across = at->T[i] > 0.0 ? at->T[i]/h : 0.0;

		memset(at->block[i], 0, sizeof at->block[i]);
		for (int k = 0; k < 3; k++)
			at->block[i][4*k] = across;
		if (at->T[i] > 0.0)
			along(at->block[i], mesh->EA[i]/mesh->length0[i] - across, e);
	}
}

/* The element from a node on a cable that touches a plane, or a flat part of a bed, to one that does
 * not, or -1. A node on a cable has one touch with each surface, and its elements have successive
 * numbers. */
static int leaving(const struct tangent *at, const struct hawser__touch *touch)
{
	const struct hawser__mesh *mesh = at->mesh;
	int e = touch->element - !touch->end, a, b; /* the element before the node, and behind it */

	if (touch->node < at->net->nodes ||
	    !(touch->surface->kind == HAWSER_SURFACE_PLANE || touch->surface->heights) ||
	    touch->H[0][0] + touch->H[1][1] + touch->H[2][2] != 0.0)
		return -1;
	a = mesh->end[e][0];
	b = mesh->end[e + 1][1];
	return at->on[a] == at->on[b] ? -1 : at->on[a] ? e + 1 : e;
}

/* The stiffness of the contact along its normal. Where the cable leaves a plane, the point without
 * shear is `off` behind the node: force/load = off/h + 1/2, of the load on the node along the
 * normal. */
static double normal(struct tangent *at, const struct hawser__touch *touch)
{
	const struct hawser__mesh *mesh = at->mesh;
	int e = leaving(at, touch), a = touch->element;
	double stiff = STIFFER*mesh->EA[a]/mesh->length0[a], load, off, h, d[3];

	load = -hawser__dot(mesh->force[touch->node], touch->n);
	stiff = 1.0/(1.0/stiff + touch->give);
	if (e < 0 || !(load > 0.0) || !(at->T[e] > 0.0))
		return stiff;
	h = hawser__mesh_direction(d, mesh, e);
	off = fmin(fmax(touch->r/load - 0.5, -0.5), 0.5)*h;
	if (off < 0.0)
		return 1.0/(1.0/stiff + 1.0/(at->T[e]*(-1.0/off - 1.0/h)));
	along(at->block[e], at->T[e]*(1.0/(h - off) - 1.0/h), touch->n);
	return stiff;
}

static int at_rest(const struct hawser_surface *of)
{
	return of->speed == 0.0 && hawser__dot(of->velocity, of->velocity) == 0.0;
}

/* What a contact adds to the matrix at its node. */
static void contact(struct tangent *at, const struct hawser__touch *touch, double *of_body)
{
	const int rigid = at->mesh->rigid[touch->node];
	double stiff = rigid ? 1.0/touch->give : normal(at, touch);
	double block[3][3], hold = 0.0, follows = 1.0/touch->r;

	if (hawser__touch_sticks(touch) && !(at->slips && at_rest(touch->surface))) {
		hold = rigid ? HAWSER__STIFFER_ALONG*stiff
		             : STIFFER*at->mesh->EA[touch->element]/at->mesh->length0[touch->element];
		follows = 0.0;
	}
	for (int i = 0; i < 3; i++)
		for (int j = 0; j < 3; j++)
			block[i][j] = stiff*(touch->n[i] + follows*touch->friction[i])*touch->n[j] +
			              hold*((i == j) - touch->n[i]*touch->n[j]) -
			              touch->r*touch->H[i][j] + touch->turn[i][j];
	if (rigid) {
		memcpy(of_body, block, sizeof block);
		return;
	}
	if (touch->surface->groove)
		block[2][2] += stiff;
	hawser__klu_node(at->klu, touch->element, touch->end, (const double (*)[3])block);
	hawser__touch_oval_matrix(at->klu, at->mesh, touch);
}

static void assemble(struct tangent *at)
{
	const struct hawser__mesh *mesh = at->mesh;

	for (int i = 0; i < mesh->touches; i++)
		at->on[mesh->touch[i].node] |= mesh->touch[i].r > 0.0;
	elements(at);
	hawser__klu_zero(at->klu);
	for (int i = 0; i < mesh->touches; i++)
		if (mesh->touch[i].r > 0.0)
			contact(at, &mesh->touch[i], at->bed[i]);
	for (int i = 0; i < mesh->elements; i++) {
		const double lift[2] = {at->T[i] > 0.0 ? 0.0 : LIFT*mesh->EA[i]/mesh->length0[i], 0.0};

		hawser__klu_element(at->klu, i, at->block[i], lift);
	}
	if (mesh->water)
		hawser__water_matrix(at->klu, mesh);
}

/* The forces on the nodes by the displacements u. */
static void forces(struct tangent *at)
{
	const struct hawser__mesh *mesh = at->mesh;

	memset(at->force, 0, (size_t)mesh->nodes*sizeof *at->force);
	for (int i = 0; i < mesh->elements; i++) {
		const int *end = mesh->end[i];
		double d[3];

		for (int k = 0; k < 3; k++)
			d[k] = at->u[end[1]][k] - at->u[end[0]][k];
		for (int k = 0; k < 3; k++) {
			double f = hawser__dot(&at->block[i][3*k], d);

			at->force[end[0]][k] -= f;
			at->force[end[1]][k] += f;
		}
	}
	for (int i = 0; i < mesh->touches; i++)
		for (int k = 0; k < 3; k++)
			at->force[mesh->touch[i].node][k] += hawser__dot(&at->bed[i][3*k],
			                                                 at->u[mesh->touch[i].node]);
	if (mesh->water)
		hawser__water_spread(at->force, mesh, (const double (*)[3])at->u);
}

/* The displacement of a point with the arm r from the reference, for a unit motion. */
static void moved(double u[3], int motion, const double r[3])
{
	double turn[3] = {motion == 3, motion == 4, motion == 5};

	hawser__cross(u, turn, r);
	if (motion < 3)
		u[motion] = 1.0;
}

static void arm_of(double arm[3], const struct tangent *at, int node)
{
	for (int k = 0; k < 3; k++)
		arm[k] = at->mesh->q[node][k] - at->about[at->group[node] - 1][k];
}

/* The unit motion of a body at its nodes, in u, and 0 at all others. */
static void give(struct tangent *at, int body, int motion)
{
	double arm[3];

	memset(at->u, 0, (size_t)at->mesh->nodes*sizeof *at->u);
	for (int i = 0; i < at->mesh->nodes; i++)
		if (at->group[i] == body + 1) {
			arm_of(arm, at, i);
			moved(at->u[i], motion, arm);
		}
}

/* The displacements of all nodes that follow those in u. */
static enum hawser_status follow(struct tangent *at, struct hawser_report *report)
{
	const struct hawser__mesh *mesh = at->mesh;
	int good;
	enum hawser_status status;

	forces(at);
	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0)
			at->x[mesh->unknown[i/3][i%3]] = -at->force[i/3][i%3];
	status = hawser__klu_divide(at->x, &good, at->klu, report);
	if (status || !good)
		return status ? status
			: hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "%s: the equilibrium has no "
			               "stiffness: a part of the net moves freely", at->net->name);
	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0)
			at->u[i/3][i%3] = at->x[mesh->unknown[i/3][i%3]];
	return HAWSER_OK;
}

/* Change of forces and moments on the bodies for the displacements u: of the elements, and of the
 * forces of the equilibrium, whose arms turn with the body that moves. */
static void collect(double *column, struct tangent *at, int body, int motion)
{
	forces(at);
	for (int i = 0; i < at->mesh->nodes; i++) {
		double arm[3], turned[3] = {0.0}, moment[3], *to = column + 6*(at->group[i] - 1);

		if (!at->group[i])
			continue;
		arm_of(arm, at, i);
		hawser__cross(moment, arm, at->force[i]);
		if (motion >= 3 && at->group[i] == body + 1)
			hawser__cross(turned, at->u[i], at->held[i]);
		for (int k = 0; k < 3; k++) {
			to[k] += at->force[i][k];
			to[3 + k] += moment[k] + turned[k];
		}
	}
}

/* Force and moment of the outside on the bodies in the equilibrium. */
static enum hawser_status hold(struct tangent *at, struct hawser_report *report)
{
	static const unsigned char all[3] = {1, 1, 1};
	double arm[3], moment[3];
	enum hawser_status status;

	if (at->mesh->water) /* with derivatives at the equilibrium */
		hawser__water_load(at->mesh);
	hawser__mesh_gradient(at->held, NULL, at->mesh);
	for (int i = 0; i < at->mesh->touches; i++) {
		const struct hawser__touch *touch = &at->mesh->touch[i];

		for (int k = 0; k < 3 && at->mesh->rigid[touch->node]; k++)
			at->held[touch->node][k] -= touch->r*touch->n[k] + touch->friction[k];
	}
	for (int i = 0; i < at->mesh->nodes; i++) {
		double *to = at->total + 6*(at->group[i] - 1);

		if (!at->group[i])
			continue;
		arm_of(arm, at, i);
		hawser__cross(moment, arm, at->held[i]);
		for (int k = 0; k < 3; k++) {
			to[k] += at->held[i][k];
			to[3 + k] += moment[k];
		}
		hawser__mesh_hold(at->mesh, i, all);
	}
	status = at->mesh->touches ? hawser__touch_again(at->mesh, at->net, report) : HAWSER_OK;
	hawser__touch_measure(at->mesh);
	hawser__touch_follow(at->mesh); /* the friction of surfaces that move, with its derivative */
	return status;
}

static double asymmetry(const struct hawser_net_stiffness *to)
{
	double most = 0.0;

	for (int i = 0; i < to->size; i++)
		for (int j = 0; j < i; j++) {
			double a = to->K[i][j], b = to->K[j][i];
			double scale = sqrt(fabs(to->K[i][i]*to->K[j][j])) + fabs(a) + fabs(b);

			most = fmax(most, scale > 0.0 ? fabs(a - b)/scale : 0.0);
		}
	return most;
}

static enum hawser_status solve(struct tangent *at, struct hawser_report *report)
{
	size_t nodes = (size_t)at->mesh->nodes + 1, elements = (size_t)at->mesh->elements + 1;
	size_t motions = MOTIONS*(size_t)at->groups;
	enum hawser_status status;

	at->block = hawser__hold(&at->memory, elements, sizeof *at->block);
	at->u = hawser__hold(&at->memory, nodes, sizeof *at->u);
	at->force = hawser__hold(&at->memory, nodes, sizeof *at->force);
	at->held = hawser__hold(&at->memory, nodes, sizeof *at->held);
	at->on = hawser__hold(&at->memory, nodes, sizeof *at->on);
	at->x = hawser__hold(&at->memory, 3*nodes, sizeof *at->x);
	at->bed = hawser__hold(&at->memory, (size_t)at->mesh->touches + 1, sizeof *at->bed);
	at->total = hawser__hold(&at->memory, motions + 1, sizeof *at->total);
	at->K = hawser__hold(&at->memory, motions*motions + 1, sizeof *at->K);
	status = at->memory.short_of_memory ? hawser__no_memory(report, "net") : hold(at, report);
	if (!status)
		status = hawser__klu_open(&at->klu, at->mesh, report);
	if (!status)
		assemble(at);
	for (int i = 0; i < at->groups*at->size && !status; i++) {
		int body = i/at->size, motion = i % at->size;

		give(at, body, motion);
		status = at->mesh->unknowns ? follow(at, report) : HAWSER_OK;
		collect(at->K + motions*(size_t)(MOTIONS*body + motion), at, body, motion);
	}
	return status;
}

static void clear(struct tangent *at)
{
	hawser__klu_clear(at->klu);
	hawser__hold_clear(&at->memory);
}

enum hawser_status hawser__bodies_tangent(double *K, double *force, double *scale,
                                          struct hawser__mesh *mesh, double *T,
                                          const struct hawser_net *net, const double (*about)[3],
                                          struct hawser_report *report)
{
	struct tangent at = {.net = net, .mesh = mesh, .T = T, .group = mesh->rigid, .groups = net->bodies,
	                     .size = MOTIONS, .slips = 1, .about = about};
	size_t motions = MOTIONS*(size_t)net->bodies;
	enum hawser_status status = solve(&at, report);

	if (!status) {
		memcpy(K, at.K, motions*motions*sizeof *K);
		memcpy(force, at.total, motions*sizeof *force);
		memset(scale, 0, (size_t)net->bodies*sizeof *scale);
	}
	for (int i = 0; i < mesh->nodes && !status; i++)
		if (mesh->rigid[i])
			scale[mesh->rigid[i] - 1] += hawser__norm(at.held[i]);
	for (int i = 0; i < mesh->touches && !status; i++)
		if (mesh->rigid[mesh->touch[i].node])
			scale[mesh->rigid[mesh->touch[i].node] - 1] += mesh->touch[i].r;
	clear(&at);
	return status;
}

/* Nodes that move, with those of their bodies. */
static void mark(struct tangent *at, const int *node, int nodes)
{
	for (int i = 0; i < nodes; i++) {
		at->group[node[i]] = 1;
		for (int j = 0; j < at->mesh->nodes && at->mesh->rigid[node[i]]; j++)
			if (at->mesh->rigid[j] == at->mesh->rigid[node[i]])
				at->group[j] = 1;
	}
}

/* Of a net whose bodies are where they belong. */
static enum hawser_status stiffness_at(struct hawser_net_stiffness *to, const struct hawser_net *net,
                                       const int *node, int nodes, struct hawser_report *report)
{
	struct hawser__mesh mesh;
	struct tangent at = {.net = net, .mesh = &mesh, .groups = 1, .size = to->size,
	                     .about = (const double (*)[3])&to->about};
	enum hawser_status status = hawser__mesh_build(&mesh, net, report);

	if (status)
		return status;
	at.T = hawser__hold(&at.memory, (size_t)mesh.elements + 1, sizeof *at.T);
	at.group = hawser__hold(&at.memory, (size_t)mesh.nodes + 1, sizeof *at.group);
	status = at.memory.short_of_memory ? hawser__no_memory(report, "net")
	                                   : hawser__net_equilibrium(&mesh, at.T, net, report);
	if (!status)
		status = hawser__bodies_land(&mesh, net, report);
	if (!status) {
		mark(&at, node, nodes);
		status = solve(&at, report);
	}
	for (int i = 0; i < MOTIONS*MOTIONS && !status; i++)
		to->K[i % MOTIONS][i/MOTIONS] = at.K[i];
	if (!status)
		memcpy(to->force, at.total, sizeof to->force);
	to->asymmetry = asymmetry(to);
	clear(&at);
	hawser__mesh_clear(&mesh);
	return status;
}

enum hawser_status hawser_net_stiffness_of(struct hawser_net_stiffness *to,
                                           const struct hawser_net *net, const int *node, int nodes,
                                           const double *about, struct hawser_report *report)
{
	struct hawser_net seated;
	double rest, motion[6][6];
	int body = net->node[node[0]].body;
	enum hawser_status status = hawser__bodies_seat(&seated, &rest, net, 0, report);

	*to = (struct hawser_net_stiffness){.size = about || body ? 6 : 3};
	if (about)
		memcpy(to->about, about, sizeof to->about);
	else if (body && !status)
		(void)hawser__body_motions(motion, to->about, &seated, &seated.body[body - 1], NULL);
	if (!status)
		status = stiffness_at(to, &seated, node, nodes, report);
	hawser__bodies_unseat(&seated, net);
	return status;
}

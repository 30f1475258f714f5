/* net/touch/touch-hold.c - modes about a state of contact: the directions that obstacles leave to
 * the nodes.
 *
 * A node that touches keeps its gap, to first order, and does not move along the normal; one that
 * sticks does not move at all; one in a groove does not move along z. The directions that are
 * left are the unknowns of the node (mesh->frame): elimination leaves a matrix of the same
 * pattern, positive definite as the net is, where multipliers would not and a stiff spring would
 * be an approximation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/touch/touch.h"

enum { HELD = -1, NEW = -2 }; /* unknowns of rotors */
/* Sine of the angle of two normals below which they are one: a node in a corner has two. */
static const double ONE = 1e-6;
/* Of the largest tension, and of an element: a node with less force and less gap is neither open nor
 * closed for certain. Round-off of both is some 1e-12. */
static const double BARELY = 1e-9;

/* Add v to the directions d [*count], if it is not among them. */
static void add(double d[3][3], int *count, const double v[3])
{
	double rest[3] = {v[0], v[1], v[2]}, l;

	if (*count == 3)
		return;
	for (int pass = 0; pass < 2; pass++) /* twice: at right angles to round-off */
		for (int i = 0; i < *count; i++) {
			double along = rest[0]*d[i][0] + rest[1]*d[i][1] + rest[2]*d[i][2];

			for (int k = 0; k < 3; k++)
				rest[k] -= along*d[i][k];
		}
	l = sqrt(rest[0]*rest[0] + rest[1]*rest[1] + rest[2]*rest[2]);
	if (!(l > ONE))
		return;
	for (int k = 0; k < 3; k++)
		d[*count][k] = rest[k]/l;
	++*count;
}

/* The part of the axes at right angles to d, largest first, until there are three. */
static void complete(double d[3][3], int count)
{
	while (count < 3) {
		double best = -1.0, left;
		int axis = 0;

		for (int k = 0; k < 3; k++) {
			left = 1.0;
			for (int i = 0; i < count; i++)
				left -= d[i][k]*d[i][k];
			if (left > best*(1.0 + ONE)) {
				best = left;
				axis = k;
			}
		}
		add(d, &count, (double[3]){axis == 0, axis == 1, axis == 2});
	}
}

/* Directions that the supports, and the obstacles from touch number `first` on, take from a node.
 * roll: the touch of a circle that turns freely, to which the node sticks; or NULL. */
static void hold(struct hawser__mesh *mesh, int node, int first, enum hawser_net_contact_state state,
                 const struct hawser__touch *roll)
{
	static const double axes[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
	double (*d)[3] = mesh->frame[node];
	int count = 0;

	for (int k = 0; k < 3; k++)
		if (mesh->unknown[node][k] < 0 || (state == HAWSER_NET_STICK && !roll))
			add(d, &count, axes[k]);
	for (int i = first; i < mesh->touches && mesh->touch[i].node == node; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];

		if (touch->r > 0.0 && !(touch->give > 0.0))
			add(d, &count, touch->n);
		if (touch->r > 0.0 && (touch->surface->groove || roll))
			add(d, &count, axes[2]);
	}
	for (int k = 0; k < 3; k++)
		mesh->unknown[node][k] = k < count ? -1 : 0;
	complete(d, count);
	if (!roll || count != 2)
		return;
	d[2][0] = -roll->n[1]; /* counterclockwise, whatever the side */
	d[2][1] = roll->n[0];
	d[2][2] = 0.0;
}

static enum hawser_status no_friction(const struct hawser_net *net, struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "%s: contact.modes: stick: no node touches "
	                    "an obstacle with friction, so that none sticks: give it a friction, or "
	                    "contact.modes: slip", net->name);
}

/* mesh->edge. */
static enum hawser_status edges(struct hawser__mesh *mesh, struct hawser_report *report)
{
	int *on = malloc(((size_t)mesh->nodes + 1)*sizeof *on); /* a touch of each node, or -1 */

	mesh->edge = malloc(((size_t)mesh->elements + 1)*sizeof *mesh->edge);
	if (!on || !mesh->edge) {
		free(on);
		return hawser__no_memory(report, "net");
	}
	for (int i = 0; i < mesh->nodes; i++)
		on[i] = -1;
	for (int i = 0; i < mesh->touches; i++)
		if (mesh->touch[i].r > 0.0)
			on[mesh->touch[i].node] = i;
	for (int e = 0; e < mesh->elements; e++) {
		int a = on[mesh->end[e][0]], b = on[mesh->end[e][1]], i = a < 0 ? b : a;

		if ((a < 0) == (b < 0) || mesh->touch[i].give > 0.0 ||
		    mesh->touch[i].H[0][0] + mesh->touch[i].H[1][1] + mesh->touch[i].H[2][2] == 0.0)
			continue;
		mesh->edge[mesh->edges].element = e;
		mesh->edge[mesh->edges++].touch = i;
	}
	free(on);
	return HAWSER_OK;
}

/* Whether a node that touches sticks to this obstacle. */
static int sticks(const struct hawser__touch *touch, enum hawser_net_contact_modes how)
{
	if (how == HAWSER_NET_MODES_SLIP || !(touch->surface->friction > 0.0))
		return 0;
	return how == HAWSER_NET_MODES_STICK || touch->surface->rotation == HAWSER_SURFACE_FREE ||
	       hawser__touch_sticks(touch);
}

/* A bed that gives way is a spring, which modes have as the curvature of an obstacle: -r*H. So is the
 * friction that holds a node of a body. */
static void spring(struct hawser__touch *touch, int holds)
{
	const double along = holds ? HAWSER__STIFFER_ALONG : 0.0;

	for (int k = 0; k < 9 && touch->give > 0.0; k++)
		touch->H[k/3][k%3] -= ((1.0 - along)*touch->n[k/3]*touch->n[k%3] + along*(k % 4 == 0))/
		                      (touch->give*touch->r);
}

/* The one obstacle to which a node sticks, if it turns freely; NULL if it does not, or there are
 * more. */
static const struct hawser__touch *rolling(const struct hawser__mesh *mesh, int first, int node,
                                           enum hawser_net_contact_modes how)
{
	const struct hawser__touch *found = NULL;

	for (int i = first; i < mesh->touches && mesh->touch[i].node == node; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];

		if (!(touch->r > 0.0) || !sticks(touch, how))
			continue;
		if (found || touch->surface->rotation != HAWSER_SURFACE_FREE)
			return NULL;
		found = touch;
	}
	return found;
}

/* The number of the circle among the rotors, a new one if it is not yet. */
static int rotor_of(struct hawser__mesh *mesh, const struct hawser__touch *touch)
{
	const struct hawser_surface *circle = touch->surface;

	for (int i = 0; i < mesh->rotors; i++)
		if (mesh->rotor[i].surface == touch->number)
			return i;
	mesh->rotor[mesh->rotors] = (struct hawser__mesh_rotor){
		NEW, touch->number, circle->inertia/(circle->radius*circle->radius)};
	return mesh->rotors++;
}

/* Number the unknowns: those of rotors once. roll [nodes]: the rotor of a node's third direction. */
static void number(struct hawser__mesh *mesh, const int *roll)
{
	mesh->unknowns = 0;
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++) {
			int *own = &mesh->unknown[i][k], *all;

			if (*own < 0)
				continue;
			all = roll[i] >= 0 ? &mesh->rotor[roll[i]].unknown : NULL;
			if (all && *all == NEW)
				*all = mesh->unknowns++;
			*own = all ? *all : mesh->unknowns++; /* HELD is -1, too */
		}
	for (int i = 0; i < mesh->rotors; i++)
		if (mesh->rotor[i].unknown < 0)
			mesh->rotor[i--] = mesh->rotor[--mesh->rotors];
}

enum hawser_status hawser__touch_hold(unsigned char *state, struct hawser__mesh *mesh,
                                      const struct hawser_net *net, enum hawser_net_contact_modes how,
                                      struct hawser_report *report)
{
	int touches = 0, stick = 0, *roll = malloc(((size_t)mesh->nodes + 1)*sizeof *roll);

	mesh->frame = calloc((size_t)mesh->nodes + 1, sizeof *mesh->frame);
	mesh->rotor = malloc(((size_t)net->surfaces + 1)*sizeof *mesh->rotor);
	if (!mesh->frame || !mesh->rotor || !roll) {
		free(roll);
		return hawser__no_memory(report, "net");
	}
	memset(state, HAWSER_NET_OPEN, (size_t)mesh->nodes);
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__touch *touch = &mesh->touch[i];

		if (!(touch->r > 0.0))
			continue;
		spring(&mesh->touch[i], mesh->rigid[touch->node] && sticks(touch, how));
		touches++;
		stick += sticks(touch, how);
		if (state[touch->node] != HAWSER_NET_STICK)
			state[touch->node] = sticks(touch, how) ? HAWSER_NET_STICK : HAWSER_NET_SLIP;
	}
	if (how == HAWSER_NET_MODES_STICK && touches > 0 && stick == 0) {
		free(roll);
		return no_friction(net, report);
	}
	for (int i = 0, first = 0; i < mesh->nodes; i++) {
		const struct hawser__touch *on;

		while (first < mesh->touches && mesh->touch[first].node < i)
			first++;
		on = rolling(mesh, first, i, how);
		hold(mesh, i, first, (enum hawser_net_contact_state)state[i], on);
		roll[i] = on ? rotor_of(mesh, on) : -1;
		if (on && mesh->unknown[i][2] < 0) /* a support holds the node, and so the circle */
			mesh->rotor[roll[i]].unknown = HELD;
	}
	number(mesh, roll);
	free(roll);
	return edges(mesh, report);
}

int hawser__touch_doubtful(int *node, struct hawser__mesh *mesh, const double *T)
{
	double most = 0.0, least;
	int count = 0;

	for (int e = 0; e < mesh->elements; e++)
		most = fmax(most, T[e]);
	least = BARELY*most + 10.0*hawser__mesh_floor(mesh);
	for (int i = 0; i < mesh->touches; i++) {
		struct hawser__touch *touch = &mesh->touch[i];

		if (touch->r > least || mesh->rigid[touch->node] ||
		    touch->g > BARELY*mesh->length0[touch->element])
			continue;
		touch->r = 0.0;
		if (count++ == 0)
			*node = touch->node;
	}
	return count;
}

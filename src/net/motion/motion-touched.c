/* net/motion/motion-touched.c - contacts of a motion as results: rows, states as numbers, the
 * last state. SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/motion/motion-contact.h"
#include "net/touch/touch.h"

enum hawser_status hawser__contact_room(struct hawser__net_touched *touched, int nodes,
                                        struct hawser_report *report)
{
	touched->state = calloc((size_t)nodes, sizeof *touched->state);
	touched->r_N = calloc(2*(size_t)nodes, sizeof *touched->r_N);
	if (!touched->state || !touched->r_N)
		return hawser__no_memory(report, "net");
	touched->r_T = touched->r_N + nodes;
	return HAWSER_OK;
}

void hawser__contact_row(struct hawser_net_motion *to, int row, struct hawser__net_touched *touched,
                         struct hawser__motion *motion)
{
	struct hawser__motion_contact *all = motion->contact;

	memset(touched->state, 0, (size_t)motion->nodes*sizeof *touched->state);
	memset(touched->r_N, 0, 2*(size_t)motion->nodes*sizeof *touched->r_N);
	for (int i = 0; i < all->touches; i++) {
		const struct hawser__motion_touch *touch = &all->touch[i];
		int node = motion->mesh->touch[i].node;

		if (touch->state == HAWSER_CONTACT_OPEN)
			continue;
		to->touching[row]++;
		to->sliding[row] += touch->state == HAWSER_CONTACT_SLIP;
		if (touch->N < touched->r_N[node])
			continue;
		touched->state[node] = (unsigned char)touch->state;
		touched->r_N[node] = touch->N;
		touched->r_T[node] = hawser__norm(touch->T);
	}
	to->friction[row] = all->friction;
	to->impacts[row] = all->impacts;
	to->apart[row] = all->apart;
	all->apart = 0.0;
	to->laws = all->laws;
}

enum hawser_status hawser__contact_result(struct hawser_net_motion *to, const struct hawser_net *net,
                                          struct hawser__motion *motion, struct hawser_report *report)
{
	struct hawser__mesh *mesh = motion->mesh;
	struct hawser_net_statics last = {.nodes = net->nodes};
	enum hawser_status status;

	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++)
			mesh->q[i][k] = motion->reference[i][k] + motion->u[i][k];
	for (int i = 0; i < mesh->touches; i++) {
		const struct hawser__motion_touch *touch = &motion->contact->touch[i];

		mesh->touch[i].r = touch->state == HAWSER_CONTACT_OPEN ? 0.0 : touch->N;
		mesh->touch[i].slides = touch->state == HAWSER_CONTACT_SLIP;
		memcpy(mesh->touch[i].friction, touch->T, sizeof mesh->touch[i].friction);
	}
	status = hawser__touch_list(&last.contact, &last.contacts, mesh, last.nodes, report);
	to->contact = last.contact;
	to->contacts = last.contacts;
	return status;
}

int hawser__contact_outside(const struct hawser__motion *motion, int touch)
{
	const struct hawser__touch *of = &motion->mesh->touch[touch];
	double at[3];

	for (int k = 0; k < 3; k++)
		at[k] = motion->reference[of->node][k] + motion->u[of->node][k];
	return hawser_surface_beyond(of->surface, at);
}

enum hawser_status hawser__contact_beyond(const struct hawser__motion *motion,
                                          struct hawser_report *report)
{
	const struct hawser__touch *touch;
	double at[3];

	if (!motion->contact || !motion->contact->beyond)
		return HAWSER_OK;
	touch = &motion->mesh->touch[motion->contact->beyond - 1];
	for (int k = 0; k < 3; k++)
		at[k] = motion->reference[touch->node][k] + motion->u[touch->node][k];
	return hawser__touch_beyond(motion->mesh, touch, at, motion->t, report);
}

/* --- the state as numbers --- */

void hawser__contact_save(double *to, const struct hawser__motion_contact *contact)
{
	*to++ = contact->friction;
	*to++ = contact->impacts;
	*to++ = contact->surfaces;
	for (int i = 0; i < contact->touches; i++) {
		const struct hawser__motion_touch *touch = &contact->touch[i];

		*to++ = touch->closed;
		*to++ = touch->state;
		for (int k = 0; k < 3; k++) {
			*to++ = touch->reply.impulse[k];
			*to++ = touch->reply.velocity[k];
		}
	}
}

void hawser__contact_restore(struct hawser__motion *motion, const double *from)
{
	struct hawser__motion_contact *contact = motion->contact;

	contact->friction = *from++;
	contact->impacts = *from++;
	contact->surfaces = *from++;
	for (int i = 0; i < contact->touches; i++) {
		struct hawser__motion_touch *touch = &contact->touch[i];

		*touch = (struct hawser__motion_touch){.candidate = -1};
		touch->closed = *from++ != 0.0;
		touch->state = (enum hawser_contact_state)*from++;
		for (int k = 0; k < 3; k++) {
			touch->reply.impulse[k] = *from++;
			touch->reply.velocity[k] = *from++;
		}
		touch->N = touch->reply.impulse[0];
		if (motion->mesh->touch[i].give > 0.0)
			memcpy(touch->T, touch->reply.velocity, sizeof touch->T);
	}
}

/* net/motion/motion-impact.c - the end part of a step with contact; see net/motion/motion-contact.h.
 *
 * m, v    mass of a node; its velocity at the end of the step, at first that of the mean part
 * n       gradient of the gap at the end
 * w       velocity along the surface, relative to it
 * f, R    what the obstacle gave: in the mean part, and in the whole step, over the step N
 *
 * Work, per node: normal: m*(v_N'^2 - v_N^2)/2 - f_N*g0 = m*(e^2 - 1)*c^2/2 at most. Along the surface
 * R_T is the point of the disc of radius b nearest to what would stop the node, and f_T is in the disc,
 * so that (R_T - f_T).w' <= 0; the work is less by (R_T - f_T)^2/(2*m). b is mu*R_N, or mu*f_N if that
 * is larger. What slid in the mean part and has not turned back keeps its f_T: sliding is of order 2.
 *
 * A node with several obstacles takes them one after another.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/vec3.h"
#include "net/motion/motion-contact.h"

enum { RECENT = 3 }; /* steps whose differences see a jump */
/* Of the velocities of a step: a bounce below this has ended. Of its ways: a gap below is round-off. */
static const double REST = 1e-9, ROUND = 1e-9;
/* Of its bound: friction below this part of it holds. */
static const double HOLDS = 1.0 - 1e-9;
/* At a node with several obstacles: times that normal velocities into them are taken away. */
enum { AGAIN = 30 };

/* The part of a along the surface with normal n; 0 in held directions. */
static void along(double to[3], const double a[3], const double n[3], unsigned held)
{
	double part = hawser__dot(a, n);

	for (int k = 0; k < 3; k++)
		to[k] = held & 1U << k ? 0.0 : a[k] - part*n[k];
}

struct node {
	double m, v[3], h;
	unsigned held;
};

/* Velocity along the surface: v gets that at the end, and the touch the friction of the step. */
static void rub(struct hawser__motion_contact *all, struct node *node,
                struct hawser__motion_touch *touch, const struct hawser_contact *contact,
                const struct hawser_contact_reply *reply, const double n[3], const double surface[3],
                double mu)
{
	const double *f = reply->impulse, *slip = reply->velocity;
	double w[3], w1[3], T[3], mean[3], bound, size, slid = 0.0;
	const double m = node->m, h = node->h;

	for (int k = 0; k < 3; k++) {
		w[k] = node->v[k] - surface[k];
		T[k] = f[1]*contact->tangent[0][k] + f[2]*contact->tangent[1][k];
	}
	along(w, w, n, node->held);
	along(mean, T, n, node->held);
	for (int k = 0; k < 3; k++)
		slid += w[k]*(slip[1]*contact->tangent[0][k] + slip[2]*contact->tangent[1][k]);
	memcpy(touch->rubbed, T, sizeof touch->rubbed);
	touch->becomes = reply->state;
	if (touch->closed && reply->state == HAWSER_CONTACT_SLIP && slid > 0.0)
		return;
	bound = mu*(touch->closed ? fmax(touch->given, f[0]) : touch->given);
	for (int k = 0; k < 3; k++)
		T[k] = mean[k] - m/h*w[k];
	size = sqrt(hawser__dot(T, T));
	touch->becomes = size <= bound && bound > 0.0 ? HAWSER_CONTACT_STICK : HAWSER_CONTACT_SLIP;
	for (int k = 0; k < 3; k++) {
		T[k] = size <= bound ? T[k] : T[k]*(bound/size);
		w1[k] = size <= bound && bound > 0.0 ? 0.0 : w[k] + h/m*(T[k] - mean[k]);
		all->rubs -= 0.5*h*(T[k] - mean[k])*(w1[k] + w[k]);
		all->drives += h*(T[k] - mean[k])*surface[k];
		node->v[k] += w1[k] - w[k];
		touch->rubbed[k] += T[k] - mean[k];
	}
}

/* One contact with f_N > 0. */
static void end(struct hawser__motion *motion, struct node *node, int number)
{
	struct hawser__motion_contact *all = motion->contact;
	struct hawser__motion_touch *touch = &all->touch[all->which[number]];
	const struct hawser__touch *of = &motion->mesh->touch[all->which[number]];
	const struct hawser_contact *contact = &all->contact[number];
	const struct hawser_contact_reply *reply = &all->reply[number];
	const double f = reply->impulse[0], m = node->m, h = node->h;
	double at[3], n[3], surface[3], v, free, want, loss, came;

	for (int k = 0; k < 3; k++)
		at[k] = motion->reference[of->node][k] + motion->u0[of->node][k] + motion->x[of->node][k];
	(void)hawser__contact_gap(n, of->surface, at);
	hawser_surface_velocity(surface, of->surface, at);
	v = hawser__dot(n, node->v);
	loss = -f*hawser__dot(contact->normal, motion->x[of->node]);
	free = v - h*f/m;
	/* a gap that is round-off brings no velocity */
	came = touch->g0 > ROUND*h*(fabs(v) + h*f/m) ? fmax(loss, 0.0) : 0.0;
	want = all->restitution*sqrt(v*v + 2.0*came/m);
	want = fmax(want, fmax(free, 0.0));
	if (want <= REST*(fabs(v) + h*f/m))
		want = 0.0;
	touch->closes = want == 0.0;
	touch->given = f + m/h*(want - v);
	all->bounces += loss + 0.5*m*(v*v - want*want);
	for (int k = 0; k < 3; k++)
		node->v[k] += (want - v)*n[k];
	rub(all, node, touch, contact, reply, n, surface, of->surface->friction);
	/* exactly, so that round-off does not let it creep */
	for (int k = 0; k < 3 && touch->closes && touch->becomes == HAWSER_CONTACT_STICK; k++)
		if (!(node->held & 1U << k))
			node->v[k] = surface[k];
}

/* Several contacts at a node: none may be left with a velocity into its obstacle. */
static void corner(struct hawser__motion *motion, struct node *node, int first, int count)
{
	struct hawser__motion_contact *all = motion->contact;
	int again = 1;

	for (int round = 0; again && round < AGAIN; round++) {
		again = 0;
		for (int c = first; c < first + count; c++) {
			const double *n = all->contact[c].normal;
			double v = hawser__dot(n, node->v);

			if (all->reply[c].impulse[0] <= 0.0 || v >= 0.0)
				continue;
			again = 1;
			all->bounces += 0.5*node->m*v*v;
			all->touch[all->which[c]].given -= node->m/node->h*v;
			for (int k = 0; k < 3; k++)
				node->v[k] -= v*n[k];
		}
	}
}

/* Work of the mean part, and what the touch has without the end part. */
static void mean(struct hawser__motion *motion, int number)
{
	struct hawser__motion_contact *all = motion->contact;
	struct hawser__motion_touch *touch = &all->touch[all->which[number]];
	const struct hawser_contact_reply *reply = &all->reply[number];
	const double *x = motion->x[all->contact[number].node];
	double gap = touch->g1;

	touch->closes = 0;
	touch->becomes = HAWSER_CONTACT_OPEN;
	touch->given = 0.0;
	memset(touch->rubbed, 0, sizeof touch->rubbed);
	for (int i = 0; i < 2; i++) {
		const double *t = all->contact[number].tangent[i];

		all->rubs -= reply->impulse[1 + i]*reply->velocity[1 + i];
		all->drives += reply->impulse[1 + i]*(hawser__dot(t, x) - reply->velocity[1 + i]);
	}
	all->apart_now = fmax(all->apart_now, reply->impulse[0] > 0.0 ? fabs(gap) : fmax(0.0, -gap));
}

void hawser__contact_jump(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                          double h)
{
	struct hawser__motion_contact *all = motion->contact;

	all->rubs = all->bounces = all->drives = all->jump_error = all->apart_now = 0.0;
	memset(all->jump, 0, (size_t)motion->nodes*sizeof *all->jump);
	for (int c = 0, next; c < all->candidates; c = next) {
		int i = all->contact[c].node;
		struct node node = {.m = all->weight[i], .h = h, .held = all->held[i]};
		double v[3], size = 0.0;

		for (int k = 0; k < 3; k++)
			node.v[k] = v[k] = motion->mesh->unknown[i][k] < 0 ? motion->v[i][k]
				: rule->to_v[0]*motion->x[i][k] + rule->to_v[1]*motion->v0[i][k];
		for (next = c; next < all->candidates && all->contact[next].node == i; next++) {
			mean(motion, next);
			if (all->reply[next].impulse[0] > 0.0)
				end(motion, &node, next);
		}
		if (next - c > 1)
			corner(motion, &node, c, next - c);
		for (int k = 0; k < 3; k++) {
			all->jump[i][k] = node.v[k] - v[k];
			size += all->jump[i][k]*all->jump[i][k];
		}
		all->jump_error = fmax(all->jump_error, 0.5*h*sqrt(size));
	}
}

void hawser__contact_finish(struct hawser__motion *motion)
{
	struct hawser__motion_contact *all = motion->contact;

	for (int i = 0; i < motion->nodes; i++) {
		all->recent[i] = (unsigned char)(all->recent[i] ? all->recent[i] - 1 : 0);
		for (int k = 0; k < 3; k++) {
			motion->v[i][k] += all->jump[i][k];
			/* what impacts take of the water is no work of it */
			motion->energy.work -= all->added[i]*all->jump[i][k]*
			                       (motion->v[i][k] - 0.5*all->jump[i][k]);
		}
	}
	for (int i = 0; i < all->touches; i++) {
		struct hawser__motion_touch *touch = &all->touch[i];
		enum hawser_contact_state before = touch->state;

		if (touch->given > 0.0 && (touch->candidate >= 0 || motion->mesh->touch[i].give > 0.0) &&
		    !all->beyond && hawser__contact_outside(motion, i))
			all->beyond = i + 1;
		if (motion->mesh->touch[i].give > 0.0) { /* net/motion/motion-bed.c */
			touch->N = touch->given;
			memcpy(touch->reply.velocity, touch->rubbed, sizeof touch->rubbed); /* is in a state */
			touch->state = touch->N <= 0.0 ? HAWSER_CONTACT_OPEN
				: hawser__norm(touch->rubbed) <
				  HOLDS*motion->mesh->touch[i].surface->friction*touch->N
				? HAWSER_CONTACT_STICK : HAWSER_CONTACT_SLIP;
			continue;
		}
		if (touch->candidate < 0) {
			touch->closed = 0;
			touch->N = touch->T[0] = touch->T[1] = touch->T[2] = 0.0;
			touch->state = HAWSER_CONTACT_OPEN;
		} else {
			touch->reply = all->reply[touch->candidate];
			touch->closed = touch->closes;
			touch->N = touch->given;
			memcpy(touch->T, touch->rubbed, sizeof touch->T);
			touch->state = touch->becomes;
		}
		if (touch->state != before)
			all->recent[motion->mesh->touch[i].node] = RECENT;
	}
	all->friction += all->rubs;
	all->impacts += all->bounces;
	all->surfaces += all->drives;
	all->laws = fmax(all->laws, all->candidates ? all->laws_now : 0.0);
	all->apart = fmax(all->apart, all->apart_now);
	motion->energy.work += all->drives;
	motion->energy.dissipated += all->rubs + all->bounces;
}

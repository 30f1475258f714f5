/* net/motion/motion-contact.c - the mean part of a step with contact; see net/motion/motion-contact.h.
 *
 * Newton's method for the increments x: in each iteration the forces of elements are linear in x, and
 * the laws of contact and friction are solved exactly (hawser/friction.h, displacements and forces for
 * velocities and impulses). Normals follow from iteration to iteration; on planes they do not change.
 *
 * n, scale  discrete gradient of the gap as a unit vector, and its length
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/motion/motion-contact.h"
#include "net/water/water.h"

/* Iterations; and how often nodes that came into an obstacle are added to the list. */
enum { ITERATIONS = 30, ROUNDS = 12 };
/* Of the distance from the origin: a gap of this size is round-off. */
static const double TOUCHES = 1e-12;
/* Of the laws in an iteration. */
static const double LAWS = 1e-12;
/* Cosine of the angle by which a normal may turn in a step: more, and a node may have passed through
 * the obstacle. */
static const double TURN = 0.5;

void hawser__contact_clear(struct hawser__motion_contact *contact)
{
	if (!contact)
		return;
	hawser__hold_clear(&contact->hold);
	hawser_friction_clear(contact->solver);
	free(contact);
}

static int allocate(struct hawser__motion_contact *contact, size_t nodes, size_t elements)
{
	size_t touches = (size_t)contact->touches + 1;

	contact->touch = hawser__hold(&contact->hold, touches, sizeof *contact->touch);
	contact->contact = hawser__hold(&contact->hold, touches, sizeof *contact->contact);
	contact->reply = hawser__hold(&contact->hold, touches, sizeof *contact->reply);
	contact->which = hawser__hold(&contact->hold, touches, sizeof *contact->which);
	contact->diagonal = hawser__hold(&contact->hold, nodes, sizeof *contact->diagonal);
	contact->off = hawser__hold(&contact->hold, elements + 1, sizeof *contact->off);
	contact->back = hawser__hold(&contact->hold, elements + 1, sizeof *contact->back);
	contact->right = hawser__hold(&contact->hold, 3*nodes, sizeof *contact->right);
	contact->weight = hawser__hold(&contact->hold, nodes, sizeof *contact->weight);
	contact->added = hawser__hold(&contact->hold, nodes, sizeof *contact->added);
	contact->held = hawser__hold(&contact->hold, 2*nodes, sizeof *contact->held);
	if (contact->hold.short_of_memory)
		return 0;
	contact->dx = contact->right + nodes;
	contact->jump = contact->dx + nodes;
	contact->recent = contact->held + nodes;
	return 1;
}

/* The water that moves with a node at the reference: as much in each direction as across the cable. */
static void across(struct hawser__motion_contact *contact, const struct hawser__mesh *mesh)
{
	struct hawser__water_mass at;

	for (int j = 0; hawser__water_mass(&at, mesh, j); j++) {
		double e[3], all = at.mass[0][0] + at.mass[1][1] + at.mass[2][2], along = 0.0;
		int node = at.node;

		hawser__mesh_direction(e, mesh, at.element);
		for (int k = 0; k < 3; k++)
			along += e[k]*hawser__dot(at.mass[k], e);
		contact->added[node] += 0.5*(all - along);
		contact->weight[node] += 0.5*(all - along);
	}
}

enum hawser_status hawser__contact_open(struct hawser__motion *motion, double restitution,
                                        struct hawser_report *report)
{
	const struct hawser__mesh *mesh = motion->mesh;
	struct hawser__motion_contact *contact = calloc(1, sizeof *contact);
	enum hawser_status status;

	if (!contact)
		return hawser__no_memory(report, "net");
	motion->contact = contact;
	for (int i = 0; i < mesh->touches; i++) /* impacts are of lumped masses, planes that give way not */
		motion->far = mesh->touch[i].give > 0.0 ? motion->far : 0.0;
	contact->touches = mesh->touches;
	contact->restitution = restitution;
	if (!allocate(contact, (size_t)mesh->nodes, (size_t)mesh->elements))
		return hawser__no_memory(report, "net");
	status = hawser_friction_open(&contact->solver, mesh->nodes, (const int (*)[2])mesh->end,
	                              mesh->elements, mesh->touches, report);
	for (int i = 0; i < mesh->nodes; i++) {
		contact->weight[i] = mesh->mass[i];
		for (int k = 0; k < 3; k++)
			contact->held[i] |= (unsigned char)(mesh->unknown[i][k] < 0 ? 1U << k : 0U);
	}
	for (int e = 0; e < mesh->elements; e++)
		contact->reach = fmax(contact->reach, mesh->length0[e]);
	for (int e = 0; e < mesh->elements; e++)
		for (int end = 0; end < 2; end++)
			contact->weight[mesh->end[e][end]] += 0.5*motion->element[e].m;
	across(contact, mesh);
	return status;
}

double hawser__contact_gap(double n[3], const struct hawser_surface *surface, const double at[3])
{
	double d[3] = {at[0] - surface->at[0], at[1] - surface->at[1], at[2] - surface->at[2]};

	if (surface->kind != HAWSER_SURFACE_SEGMENT)
		return hawser_surface_gap(n, NULL, surface, at);
	memcpy(n, surface->normal, 3*sizeof *n);
	return hawser__dot(n, d);
}

/* 1 if a node that goes from a place to another may touch the surface: a segment if it is at its free
 * side above it, or passes its line there. What has gone around its ends is behind it. */
static int reaches(const struct hawser_surface *surface, const double from[3], const double to[3],
                   double g0, double g1, double round)
{
	double way[2] = {surface->to[0] - surface->at[0], surface->to[1] - surface->at[1]}, part[2], s;

	if (surface->kind != HAWSER_SURFACE_SEGMENT)
		return 1;
	if (g0 < -round)
		return 0;
	s = g1 < 0.0 && g0 > 0.0 ? g0/(g0 - g1) : 0.0;
	for (int i = 0; i < 2; i++) {
		double x = from[0] + i*s*(to[0] - from[0]), y = from[1] + i*s*(to[1] - from[1]);

		part[i] = ((x - surface->at[0])*way[0] + (y - surface->at[1])*way[1])/
		          (way[0]*way[0] + way[1]*way[1]);
	}
	return (part[1] >= 0.0 && part[1] <= 1.0) || (g0 <= round && part[0] >= 0.0 && part[0] <= 1.0);
}

/* Where a node is, with the increment x or without (NULL). */
static void place(double at[3], const struct hawser__motion *motion, int node, const double *x)
{
	for (int k = 0; k < 3; k++)
		at[k] = motion->reference[node][k] + (x ? motion->u0[node][k] + x[k] : motion->u[node][k]);
}

/* What round-off makes of a gap there. */
static double round_off(const struct hawser__motion_contact *all, const struct hawser_surface *surface,
                        const double at[3])
{
	return TOUCHES*(all->reach + fabs(at[0]) + fabs(at[1]) + fabs(at[2]) + surface->radius +
	                fabs(surface->at[0]) + fabs(surface->at[1]) + fabs(surface->at[2]));
}

void hawser__contact_begin(struct hawser__motion *motion)
{
	struct hawser__motion_contact *contact = motion->contact;

	contact->friction = contact->impacts = contact->surfaces = contact->apart = contact->laws = 0.0;
	for (int i = 0; i < contact->touches; i++) {
		const struct hawser__touch *of = &motion->mesh->touch[i];
		struct hawser__motion_touch *touch = &contact->touch[i];
		double at[3], n[3], round;

		*touch = (struct hawser__motion_touch){.candidate = -1, .N = of->r};
		place(at, motion, of->node, NULL);
		touch->g0 = touch->g1 = hawser__contact_gap(n, of->surface, at);
		round = round_off(contact, of->surface, at);
		touch->closed = !(of->give > 0.0) &&
		                reaches(of->surface, at, at, touch->g0, touch->g0, round) &&
		                (of->r > 0.0 ||
		                 (touch->g0 <= round && hawser__dot(n, motion->v[of->node]) <= 0.0));
		memcpy(touch->T, of->friction, sizeof touch->T);
		if (of->give > 0.0)
			memcpy(touch->reply.velocity, of->friction, sizeof touch->T); /* is in a state */
		touch->reply.impulse[0] = of->r;
		touch->state = of->r <= 0.0 ? HAWSER_CONTACT_OPEN
			: of->slides || of->surface->friction == 0.0 ? HAWSER_CONTACT_SLIP : HAWSER_CONTACT_STICK;
	}
}

/* The discrete gradient of the gap between two places, which changes by `change`: it is linear but for
 * circles and beds. n1: the gradient at the second one. */
static void gradient(double n[3], const struct hawser_surface *surface, const double from[3],
                     const double to[3], double change, const double n1[3])
{
	double sign = surface->side == HAWSER_SIDE_INSIDE ? -1.0 : 1.0, D[2], sum;

	if (surface->heights) {
		double n0[3];

		(void)hawser_surface_gap(n0, NULL, surface, from);
		hawser__mean_normal(n, NULL, surface, from, to, change, n0, n1, NULL);
		return;
	}
	memcpy(n, n1, 3*sizeof *n);
	if (surface->kind != HAWSER_SURFACE_CIRCLE)
		return;
	D[0] = from[0] + to[0] - 2.0*surface->at[0];
	D[1] = from[1] + to[1] - 2.0*surface->at[1];
	sum = hypot(from[0] - surface->at[0], from[1] - surface->at[1]) +
	      hypot(to[0] - surface->at[0], to[1] - surface->at[1]);
	n[0] = sign*D[0]/sum;
	n[1] = sign*D[1]/sum;
	n[2] = 0.0;
}

/* 1 if its node has another contact in the list, which is in the order of the nodes. What comes to rest
 * between two obstacles is held by the friction of both. */
static int shared(const struct hawser__motion_contact *all, const struct hawser__mesh *mesh, int number)
{
	int node = mesh->touch[all->which[number]].node;

	return (number > 0 && mesh->touch[all->which[number - 1]].node == node) ||
	       (number + 1 < all->candidates && mesh->touch[all->which[number + 1]].node == node);
}

/* The frame and the gap of a contact of the list, for motion->x; 0 if it has no normal, or has turned
 * too far. */
static int frame(struct hawser__motion *motion, int number, double h)
{
	struct hawser__motion_contact *all = motion->contact;
	struct hawser__motion_touch *touch = &all->touch[all->which[number]];
	const struct hawser__touch *of = &motion->mesh->touch[all->which[number]];
	struct hawser_contact *contact = &all->contact[number];
	const double *x = motion->x[of->node];
	double from[3], to[3], middle[3], n[3], n1[3], v[3], scale;

	for (int k = 0; k < 3; k++) {
		from[k] = motion->reference[of->node][k] + motion->u0[of->node][k];
		to[k] = from[k] + x[k];
		middle[k] = 0.5*(from[k] + to[k]);
	}
	touch->g1 = hawser__contact_gap(n1, of->surface, to);
	gradient(n, of->surface, from, to, touch->g1 - touch->g0, n1);
	scale = sqrt(hawser__dot(n, n));
	if (!(scale > 0.0) || !hawser_contact_frame(contact, n))
		return 0;
	hawser_surface_velocity(v, of->surface, middle);
	contact->node = of->node;
	contact->friction = touch->closed || shared(all, motion->mesh, number) ? of->surface->friction
	                                                                       : 0.0;
	contact->gap_rate = touch->g0/scale;
	for (int k = 0; k < 3; k++)
		contact->surface[k] = h*v[k] - x[k];
	return hawser_surface_convex(of->surface) || scale > sqrt(0.5*(1.0 + TURN)) ||
	       touch->g0 > sqrt(hawser__dot(x, x));
}

static void add(struct hawser__motion_contact *all, int which)
{
	int at = all->candidates;

	/* in the order of the nodes: of a list that is sorted already but for what is added */
	while (at > 0 && all->which[at - 1] > which) {
		all->which[at] = all->which[at - 1];
		all->reply[at] = all->reply[at - 1];
		all->touch[all->which[at]].candidate = at;
		at--;
	}
	all->which[at] = which;
	all->reply[at] = all->touch[which].reply;
	all->touch[which].candidate = at;
	all->candidates++;
}

/* Nodes that touch, or would be in an obstacle with the increments x, and are not in the list; returns
 * their number. */
static int list(struct hawser__motion *motion, int first)
{
	struct hawser__motion_contact *all = motion->contact;
	int before = first ? 0 : all->candidates;

	if (first)
		all->candidates = 0;
	for (int i = 0; i < all->touches; i++) {
		const struct hawser__touch *of = &motion->mesh->touch[i];
		struct hawser__motion_touch *touch = &all->touch[i];
		double from[3], to[3], n[3], n0[3], round;

		if (of->give > 0.0)
			touch->candidate = -1;
		if (of->give > 0.0 || (!first && touch->candidate >= 0))
			continue;
		place(to, motion, of->node, motion->x[of->node]);
		round = round_off(all, of->surface, to);
		for (int k = 0; k < 3; k++)
			from[k] = motion->reference[of->node][k] + motion->u0[of->node][k];
		if (first) {
			touch->candidate = -1;
			touch->g0 = hawser__clear_gap(n0, &touch->clear, of->surface, from, round);
		}
		touch->g1 = hawser__clear_gap(n, &touch->clear, of->surface, to, round);
		if (touch->g1 < (first ? round : -round) || (first && (touch->closed || touch->g0 <= round)))
			if (reaches(of->surface, from, to, touch->g0, touch->g1, round)) {
				touch->g0 = hawser__contact_gap(n0, of->surface, from);
				add(all, i);
			}
	}
	return all->candidates - before;
}

/* Matrix and right side without the forces of obstacles, which are then taken from the residual;
 * returns the largest of what is left. */
static double assemble(struct hawser__motion *motion)
{
	struct hawser__motion_contact *all = motion->contact;
	const struct hawser__mesh *mesh = motion->mesh;
	double most = 0.0;

	for (int i = 0; i < motion->nodes; i++) {
		for (int k = 0; k < 9; k++)
			all->diagonal[i][k] = motion->block ? motion->block[i][k] : 0.0;
		for (int k = 0; k < 3; k++) {
			all->diagonal[i][4*k] += motion->point[i];
			all->right[i][k] = mesh->unknown[i][k] < 0 ? 0.0 : -motion->r[i][k];
			all->dx[i][k] = all->right[i][k];
			if (mesh->unknown[i][k] >= 0) /* masses, which are not in the forces of elements */
				motion->scale = fmax(motion->scale, fabs(motion->load[i][k]) +
				                     fabs(mesh->mass[i]*motion->acc[i][k]));
		}
	}
	for (int e = 0; e < motion->elements; e++) {
		const double *B = motion->B[e], *other = motion->other ? motion->other[e] : B;
		const double near = motion->mass[e][0];
		double *a = all->diagonal[mesh->end[e][0]], *b = all->diagonal[mesh->end[e][1]];

		for (int k = 0; k < 9; k++) {
			double one = k%4 == 0 ? near : 0.0;

			a[k] += B[k] + one;
			b[k] += other[k] + one;
			all->off[e][k] = -B[k];
			all->back[e][k] = -other[k];
		}
	}
	for (int c = 0; c < all->candidates; c++) {
		const struct hawser_contact *contact = &all->contact[c];
		const double *f = all->reply[c].impulse;

		for (int k = 0; k < 3; k++)
			if (mesh->unknown[contact->node][k] >= 0)
				all->dx[contact->node][k] += f[0]*contact->normal[k] + f[1]*contact->tangent[0][k] +
				                             f[2]*contact->tangent[1][k];
		motion->scale = fmax(motion->scale, f[0]);
	}
	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++)
			most = fabs(all->dx[i][k]) <= most ? most : fabs(all->dx[i][k]);
	return most;
}

/* Largest penetration, or gap of what touches, of the list. */
static double apart(double *allowed, const struct hawser__motion *motion)
{
	const struct hawser__motion_contact *all = motion->contact;
	double most = 0.0;

	*allowed = 0.0;
	for (int c = 0; c < all->candidates; c++) {
		const struct hawser__motion_touch *touch = &all->touch[all->which[c]];
		const struct hawser__touch *of = &motion->mesh->touch[all->which[c]];
		double at[3], gap = touch->g1;

		place(at, motion, of->node, motion->x[of->node]);
		*allowed = fmax(*allowed, round_off(all, of->surface, at));
		most = fmax(most, all->reply[c].impulse[0] > 0.0 ? fabs(gap) : fmax(0.0, -gap));
	}
	return most;
}

static enum hawser_status solve_laws(struct hawser__motion *motion, int *done,
                                     struct hawser_report *report)
{
	struct hawser__motion_contact *all = motion->contact;
	const struct hawser_friction_problem problem = {
		.diagonal = (const double (*)[9])all->diagonal, .off = (const double (*)[9])all->off,
		.back = (const double (*)[9])all->back, .right = (const double (*)[3])all->right,
		.held = all->held, .contact = all->contact, .contacts = all->candidates};
	const struct hawser_friction_options options = {.tolerance = LAWS, .warm = 1};
	struct hawser_friction_counts counts;
	struct hawser_report own = {.status = HAWSER_OK};
	enum hawser_status status = hawser_friction_solve(all->solver, all->dx, all->reply, &counts,
	                                                  &problem, &options, &own);

	motion->iterations += counts.iterations;
	*done = !status;
	if (!status) {
		all->laws_now = counts.residual;
		return HAWSER_OK;
	}
	if (status == HAWSER_ERR_NO_SOLUTION)
		all->refusal = own;
	else if (status == HAWSER_ERR_CONVERGENCE)
		hawser__contact_wedged(motion);
	if (status == HAWSER_ERR_NO_SOLUTION || status == HAWSER_ERR_CONVERGENCE ||
	    status == HAWSER_ERR_NAN)
		return HAWSER_OK; /* a shorter step may have a solution */
	if (report)
		*report = own;
	return status;
}

/* Fail for two contacts of a node where the solver of a step takes one. */
static enum hawser_status single(const struct hawser__motion *motion, struct hawser_report *report)
{
	const struct hawser__motion_contact *all = motion->contact;

	for (int c = 1; c < all->candidates && !hawser__blocks_chain(motion->blocks); c++)
		if (all->contact[c].node == all->contact[c - 1].node)
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "net", "at %.6g s a node touches the "
			                    "obstacles %s and %s at once: where cables branch or form a ring, a "
			                    "node may touch one: move them apart, or leave one out", motion->t,
			                    motion->mesh->touch[all->which[c - 1]].surface->name,
			                    motion->mesh->touch[all->which[c]].surface->name);
	return HAWSER_OK;
}

/* Newton's method with the contacts of the list. */
static enum hawser_status newton(struct hawser__motion *motion, int *done,
                                 const struct hawser__motion_rule *rule, double h,
                                 struct hawser_report *report)
{
	struct hawser__motion_contact *all = motion->contact;
	double last = INFINITY, gap_last = INFINITY;
	int fresh = 1;

	*done = 0;
	for (int i = 0; i < ITERATIONS; i++) {
		double rest, tolerance, gap, round;
		enum hawser_status status;
		int good = 1;

		hawser__motion_residual(motion, rule, h, fresh);
		for (int c = 0; c < all->candidates && good; c++)
			good = frame(motion, c, h);
		if (!good)
			return HAWSER_OK;
		rest = assemble(motion);
		gap = apart(&round, motion);
		tolerance = 5000.0*DBL_EPSILON*motion->scale;
		motion->undefined = i == 0 && !isfinite(rest);
		motion->singular = i == 1 && !isfinite(rest);
		*done = i > 0 && (rest <= tolerance || (rest <= 1e3*tolerance && rest > 0.25*last)) &&
		        (gap <= round || (gap <= 1e3*round && gap > 0.25*gap_last));
		if (*done || !isfinite(rest))
			return HAWSER_OK;
		fresh = i == 0 || !(rest <= HAWSER__KEEPS*last);
		last = rest;
		gap_last = gap;
		status = single(motion, report);
		if (!status)
			status = solve_laws(motion, &good, report);
		if (status || !good)
			return status;
		for (int n = 0; n < motion->nodes; n++)
			for (int k = 0; k < 3; k++)
				motion->x[n][k] += all->dx[n][k];
	}
	return HAWSER_OK;
}

enum hawser_status hawser__contact_solve(struct hawser__motion *motion, int *done,
                                         const struct hawser__motion_rule *rule, double h,
                                         struct hawser_report *report)
{
	struct hawser__motion_contact *all = motion->contact;
	enum hawser_status status;

	all->refusal.status = HAWSER_OK;
	(void)list(motion, 1);
	for (int round = 0; round < ROUNDS; round++) {
		status = all->candidates ? newton(motion, done, rule, h, report)
		                         : hawser__motion_solve(motion, done, rule, h, report);
		if (status || !*done || list(motion, 0) == 0)
			return status;
	}
	*done = 0;
	return HAWSER_OK;
}

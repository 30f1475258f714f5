/* net/motion/motion-probe.c - places, velocities and tensions at the probes of a motion.
 *
 * Tensions at nodes are by the balance of the halves of elements there, inertia and drag included
 * (net/statics/tension.c). The accelerations are differences of the mean velocities of the last two
 * steps, since the velocities of schemes without numerical damping alternate where axial damping is
 * strong; with obstacles, whose forces are means over a step and may be impacts, the mean over the
 * last step; and of CVODE, which has steps of its own, those of the equations of motion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "net/motion/motion-contact.h"
#include "net/motion/motion-ode.h"

void hawser__probes_clear(struct hawser__probes *probes)
{
	hawser__ode_clear(&probes->ode);
	free(probes->a); /* with obstacle */
	free(probes->state);
	memset(probes, 0, sizeof *probes);
}

enum hawser_status hawser__probes_open(struct hawser__probes *probes, struct hawser__motion *motion,
                                       const struct hawser_net *net, const double (*x)[3],
                                       const double *T, struct hawser_report *report)
{
	size_t nodes = (size_t)motion->nodes;

	*probes = (struct hawser__probes){.motion = motion};
	probes->a = calloc(2*nodes + 1, sizeof *probes->a);
	probes->state = calloc(3*(size_t)motion->mesh->unknowns + 1, sizeof *probes->state);
	if (!probes->a || !probes->state)
		return hawser__no_memory(report, "net");
	probes->obstacle = probes->a + nodes;
	probes->tensions = (struct hawser__tensions){
		.mesh = motion->mesh, .net = net, .x = x, .T = T, .far = motion->far,
		.obstacle = motion->contact ? (const double (*)[3])probes->obstacle : NULL,
		.v = (const double (*)[3])motion->v, .a = (const double (*)[3])probes->a};
	return motion->scheme->advance ? hawser__ode_open(&probes->ode, motion, report) : HAWSER_OK;
}

static double acceleration(const struct hawser__motion *motion, int i, int k)
{
	double h = motion->past_h, h2 = motion->past2_h;

	if (motion->contact && h > 0.0)
		return (motion->v[i][k] - motion->v0[i][k])/h;
	if (h <= 0.0 || h2 <= 0.0)
		return motion->a[i][k];
	return 2.0*(motion->past[i][k]/h - motion->past2[i][k]/h2)/(h + h2);
}

/* The mean forces of obstacles over the last step. */
static void touched(struct hawser__probes *probes)
{
	const struct hawser__motion *motion = probes->motion;
	const struct hawser__motion_contact *contact = motion->contact;

	memset(probes->obstacle, 0, (size_t)motion->nodes*sizeof *probes->obstacle);
	for (int i = 0; i < contact->touches; i++) {
		const struct hawser__touch *touch = &motion->mesh->touch[i];
		double n[3];

		if (contact->touch[i].state == HAWSER_CONTACT_OPEN)
			continue;
		hawser__contact_gap(n, touch->surface, probes->tensions.x[touch->node]);
		for (int k = 0; k < 3; k++)
			probes->obstacle[touch->node][k] += contact->touch[i].N*n[k] + contact->touch[i].T[k];
	}
}

enum hawser_status hawser__probes_state(struct hawser__probes *probes, struct hawser_report *report)
{
	const struct hawser__motion *motion = probes->motion;
	size_t n = (size_t)motion->mesh->unknowns;
	enum hawser_status status = HAWSER_OK;

	probes->tensions.t = motion->t;
	hawser__motion_support_accelerations(probes->a, motion, motion->t);
	if (motion->contact)
		touched(probes);
	for (int i = 0; i < 3*motion->nodes && !motion->scheme->advance; i++)
		if (motion->mesh->unknown[i/3][i%3] >= 0 || motion->mesh->rigid[i/3])
			probes->a[i/3][i%3] = acceleration(motion, i/3, i%3);
	if (motion->water)
		hawser__water_row(probes->motion, (const double (*)[3])probes->a);
	if (!motion->scheme->advance)
		return HAWSER_OK;
	for (int i = 0; i < 3*motion->nodes; i++) {
		int j = motion->mesh->unknown[i/3][i%3];

		if (j >= 0) {
			probes->state[j] = motion->u[i/3][i%3];
			probes->state[n + (size_t)j] = motion->v[i/3][i%3];
		}
	}
	status = hawser__ode_accelerate(probes->state + 2*n, &probes->ode, motion->t, probes->state,
	                                probes->state + n, report);
	for (int i = 0; i < 3*motion->nodes; i++) {
		int j = motion->mesh->unknown[i/3][i%3];

		if (j >= 0)
			probes->a[i/3][i%3] = probes->state[2*n + (size_t)j];
	}
	return status;
}

/* The largest tension of the cables that end at a node. */
static double at_node(const struct hawser__tensions *of, int node)
{
	const struct hawser_net *net = of->net;
	double T = 0.0;

	for (int c = 0; c < net->cables; c++) {
		if (net->cable[c].from == node)
			T = fmax(T, hawser__tension_at(of, c, 0));
		if (net->cable[c].to == node)
			T = fmax(T, hawser__tension_at(of, c, net->cable[c].elements));
	}
	return T;
}

/* 1 if a support holds a node, and has not let go. */
static int supports(const struct hawser__tensions *of, int node)
{
	int holds = 0;

	for (int k = 0; k < 3; k++)
		holds |= of->net->node[node].held[k] && of->mesh->unknown[node][k] < 0;
	return holds;
}

/* What the cables that end at a node pull on it. */
static void pull_at(double pull[3], const struct hawser__tensions *of, int node)
{
	const struct hawser_net *net = of->net;
	double t[3];

	for (int j = 0; j < 2*net->cables; j++) {
		const struct hawser_net_cable *cable = &net->cable[j/2];

		if ((j%2 ? cable->to : cable->from) != node)
			continue;
		hawser__tension_vector(t, of, j/2, j%2 ? cable->elements : 0);
		for (int k = 0; k < 3; k++)
			pull[k] += j%2 ? -t[k] : t[k];
	}
}

void hawser__probe(double x[3], double v[3], double *T, double pull[3],
                   const struct hawser__probes *probes, const struct hawser_net_probe *at)
{
	const struct hawser__tensions *of = &probes->tensions;
	int n = at->cable < 0 ? 1 : of->net->cable[at->cable].elements, i, a, b;
	double along = fmin(fmax(at->part, 0.0), 1.0)*n, part;

	if (at->cable < 0) {
		memcpy(x, of->x[at->node], 3*sizeof *x);
		memcpy(v, of->v[at->node], 3*sizeof *v);
		*T = at_node(of, at->node);
		if (supports(of, at->node))
			pull_at(pull, of, at->node);
		return;
	}
	i = (int)fmin(along, n - 1);
	part = along - i;
	a = of->mesh->end[of->mesh->first[at->cable] + i][0];
	b = of->mesh->end[of->mesh->first[at->cable] + i][1];
	for (int k = 0; k < 3; k++) {
		x[k] = (1.0 - part)*of->x[a][k] + part*of->x[b][k];
		v[k] = (1.0 - part)*of->v[a][k] + part*of->v[b][k];
	}
	*T = (1.0 - part)*hawser__tension_at(of, at->cable, i) +
	     part*hawser__tension_at(of, at->cable, i + 1);
}

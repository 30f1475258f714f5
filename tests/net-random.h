/* tests/net-random.h - random nets: 2 to 4 supports, 1 to 6 joints, 1 to 40 cables, slack and taut,
 * badly scaled (lengths over three decades, stiffness over five, strains to 40 %).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_NET_RANDOM_H
#define HAWSER_TESTS_NET_RANDOM_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <hawser/net.h>

enum random_kind { HEAVY, SOME_LIGHT, BARS }; /* weight: all cables, half of them, none (one element) */

struct random_net {
	struct hawser_net net;
	struct hawser_net_node node[12];
	struct hawser_net_cable cable[40];
	struct hawser_net_load load[12];
	double size, weight; /* m; N, sum of all forces */
};

/* Uniform in 0..1: the same numbers on every machine. */
static inline double uniform(uint64_t *state)
{
	*state = *state*6364136223846793005u + 1442695040888963407u;
	return (double)(*state >> 11)/9007199254740992.0;
}

static inline void random_joints(struct random_net *r, uint64_t *state, int supports)
{
	for (int i = 0; i < r->net.nodes; i++) {
		struct hawser_net_node *node = &r->node[i];

		snprintf(node->name, sizeof node->name, "n%d", i);
		node->placed = 1;
		node->support = i < supports;
		memset(node->held, i < supports, sizeof node->held);
		for (int k = 0; k < 3; k++)
			node->x[k] = r->size*(2.0*uniform(state) - 1.0);
		node->mass = i >= supports && uniform(state) < 0.3 ? pow(10.0, 2.0*uniform(state)) : 0.0;
	}
}

static inline void random_cable(struct random_net *r, uint64_t *state, int from, int to, int supports,
                                enum random_kind kind)
{
	struct hawser_net_cable *cable = &r->cable[r->net.cables];
	int held = from < supports && to < supports;
	double d = 0.0, u;

	if (from == to || r->net.cables >= 40)
		return;
	snprintf(cable->name, sizeof cable->name, "c%d", r->net.cables++);
	cable->from = from;
	cable->to = to;
	for (int k = 0; k < 3; k++)
		d += pow(r->node[from].x[k] - r->node[to].x[k], 2.0);
	u = uniform(state);
	cable->value = sqrt(d)*(1.0 + (u < 0.6 ? pow(10.0, -3.0 + 5.0*u)
	                               : held ? -pow(10.0, -4.0 + 5.0*(u - 0.6)) : -0.7*(u - 0.6)));
	cable->rho = kind == BARS || (kind == SOME_LIGHT && uniform(state) < 0.5) ? 0.0
		: 0.1*pow(10.0, 2.0*uniform(state));
	cable->EA = pow(10.0, 1.5 + 5.0*uniform(state))*r->size*fmax(cable->rho, 0.1)*9.81;
	cable->elements = kind == BARS ? 1 : 8;
}

static inline void random_net(struct random_net *r, uint64_t *state, enum random_kind kind)
{
	int supports = 2 + (int)(3.0*uniform(state)), joints = 1 + (int)(6.0*uniform(state)), extra;

	memset(r, 0, sizeof *r);
	r->net = (struct hawser_net){.name = r->node[0].name, .g = 9.81, .node = r->node, .cable = r->cable,
	                             .load = r->load, .nodes = supports + joints};
	r->size = pow(10.0, 3.0*uniform(state));
	random_joints(r, state, supports);
	for (int i = supports; i < r->net.nodes; i++)
		random_cable(r, state, (int)(i*uniform(state)), i, supports, kind);
	extra = (int)(2.0*r->net.nodes*uniform(state));
	for (int i = 0; i < extra; i++) {
		int from = (int)(r->net.nodes*uniform(state)), to = (int)(r->net.nodes*uniform(state));

		random_cable(r, state, from, to, supports, kind);
	}
	for (int i = supports; i < r->net.nodes; i++) {
		struct hawser_net_load *load = &r->load[r->net.loads];
		double factor = uniform(state) < 0.5 ? 10.0 : 1.0;

		if (kind != BARS && uniform(state) > 0.4)
			continue;
		*load = (struct hawser_net_load){.node = i, .cable = -1};
		for (int k = 0; k < 3; k++) {
			load->value[k] = factor*r->size*(2.0*uniform(state) - 1.0);
			r->weight += fabs(load->value[k]);
		}
		r->net.loads++;
	}
	for (int i = 0; i < r->net.cables; i++)
		r->weight += 9.81*r->cable[i].rho*r->cable[i].value;
	for (int i = 0; i < r->net.nodes; i++)
		r->weight += 9.81*r->node[i].mass;
}

#endif

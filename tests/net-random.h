/* tests/net-random.h - random nets: 2 to 4 supports, 1 to 6 joints, 1 to 40 cables, slack and taut,
 * badly scaled (lengths over three decades, stiffness over five, strains to 40 %). Harder ones have
 * what random_harder() changes.
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
	struct hawser_net_load load[52];
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

/* Sum of all forces. */
static inline void random_weigh(struct random_net *r)
{
	r->weight = 0.0;
	for (int i = 0; i < r->net.loads; i++) {
		int cable = r->load[i].cable;

		for (int k = 0; k < 3; k++)
			r->weight += fabs(r->load[i].value[k])*(cable < 0 ? 1.0 : r->cable[cable].value);
	}
	for (int i = 0; i < r->net.cables; i++)
		r->weight += r->net.g*r->cable[i].rho*r->cable[i].value;
	for (int i = 0; i < r->net.nodes; i++)
		r->weight += r->net.g*r->node[i].mass;
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
		}
		r->net.loads++;
	}
	random_weigh(r);
}

/* What random_harder() does to a net; several at once. */
enum random_change {
	PARTLY = 1,    /* some supports hold one or two directions only */
	WIND = 2,      /* loads per length, up to 3 times the weight */
	STIFF = 4,     /* EA larger by up to six decades */
	LONG = 8,      /* some cables up to 30 times as long */
	UNEVEN = 16,   /* 1 to 30 elements a cable */
	UNITS = 32,    /* lengths and forces times powers of ten */
	FLOATING = 64, /* no gravity, loads on a few nodes or none */
	RIGID = 128,   /* some cables 10^3 to 10^9 times as stiff as the others */
	CHANGES = 8
};

/* Hold some directions of the supports beyond the first only. A cable from there keeps the part of the
 * net supported. */
static inline void random_rollers(struct random_net *r, uint64_t *state, int supports,
                                  enum random_kind kind)
{
	for (int i = 1; i < supports; i++) {
		int cables = r->net.cables;

		random_cable(r, state, 0, i, supports, kind);
		for (int k = 0; k < 3; k++)
			if (uniform(state) < 0.3 && r->net.cables > cables)
				r->node[i].held[k] = 0;
	}
}

static inline void random_wind(struct random_net *r, uint64_t *state)
{
	for (int c = 0; c < r->net.cables; c++) {
		struct hawser_net_load *load = &r->load[r->net.loads];

		if (uniform(state) < 0.5)
			continue;
		*load = (struct hawser_net_load){.node = -1, .cable = c};
		for (int k = 0; k < 3; k++)
			load->value[k] = 3.0*9.81*fmax(r->cable[c].rho, 0.1)*(2.0*uniform(state) - 1.0);
		r->net.loads++;
	}
}

/* The same net in other units of length and force. */
static inline void random_units(struct random_net *r, uint64_t *state)
{
	double m = pow(10.0, 8.0*uniform(state) - 4.0), N = pow(10.0, 12.0*uniform(state) - 6.0);

	for (int i = 0; i < r->net.nodes; i++) {
		r->node[i].mass *= N;
		for (int k = 0; k < 3; k++)
			r->node[i].x[k] *= m;
	}
	for (int c = 0; c < r->net.cables; c++) {
		r->cable[c].value *= m;
		r->cable[c].EA *= N;
		r->cable[c].rho *= N/m;
	}
	for (int i = 0; i < r->net.loads; i++)
		for (int k = 0; k < 3; k++)
			r->load[i].value[k] *= r->load[i].cable < 0 ? N : N/m;
	r->size *= m;
}

static inline void random_floating(struct random_net *r, uint64_t *state)
{
	r->net.g = 0.0;
	if (uniform(state) < 0.2)
		r->net.loads = 0;
}

static inline void random_harder(struct random_net *r, uint64_t *state, enum random_kind kind,
                                 int changes)
{
	double stiffer = pow(10.0, 6.0*uniform(state)), rigid = pow(10.0, 3.0 + 6.0*uniform(state));
	int supports = 0;

	for (int i = 0; i < r->net.nodes; i++)
		supports += r->node[i].support;
	if (changes & PARTLY)
		random_rollers(r, state, supports, kind);

	for (int c = 0; c < r->net.cables; c++) {
		struct hawser_net_cable *cable = &r->cable[c];
		double longer = uniform(state) < 0.3 ? pow(10.0, 1.5*uniform(state)) : 1.0;
		int rigid_one = uniform(state) < 0.3, elements = 1 + (int)(30.0*uniform(state));

		cable->EA *= changes & STIFF ? stiffer : 1.0;
		cable->EA *= changes & RIGID && rigid_one ? rigid : 1.0;
		cable->elements = changes & UNEVEN && cable->rho > 0.0 ? elements : cable->elements;
		cable->value *= changes & LONG ? longer : 1.0;
	}
	if (changes & WIND)
		random_wind(r, state);
	if (changes & FLOATING)
		random_floating(r, state);
	if (changes & UNITS)
		random_units(r, state);
	random_weigh(r);
}

#endif

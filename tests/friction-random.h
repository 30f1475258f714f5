/* tests/friction-random.h - random steps with contact: chains over floors, slopes, arcs and moving
 * surfaces, in a plane and in space, stiff and soft. The same seed gives the same problem everywhere.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_FRICTION_RANDOM_H
#define HAWSER_TESTS_FRICTION_RANDOM_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#include <hawser/friction.h>

enum { FRICTION_NODES = 40 };

struct friction_case {
	uint64_t state;
	int nodes, contacts, space, rings; /* rings: links beyond those of the chain */
	double stiffness; /* of an element over the mass of a node */
	int link[FRICTION_NODES][2];
	double diagonal[FRICTION_NODES][9], off[FRICTION_NODES][9], right[FRICTION_NODES][3];
	unsigned char held[FRICTION_NODES];
	struct hawser_contact contact[FRICTION_NODES];
};

/* Uniform in low to high (xorshift64*). */
static inline double friction_between(struct friction_case *of, double low, double high)
{
	of->state ^= of->state >> 12;
	of->state ^= of->state << 25;
	of->state ^= of->state >> 27;
	return low + (high - low)*(double)((of->state*UINT64_C(2685821657736338717)) >> 11)*0x1p-53;
}

static inline void friction_element(struct friction_case *of, int i, double angle)
{
	double d[3] = {cos(angle), sin(angle), of->space ? friction_between(of, -0.3, 0.3) : 0.0};
	double k = of->stiffness*exp(friction_between(of, -1.0, 1.0)), l = sqrt(1.0 + d[2]*d[2]);

	for (int j = 0; j < 9; j++) {
		double value = (j%4 ? 0.0 : 1e-3*k) + k*d[j/3]*d[j%3]/(l*l);

		of->diagonal[i][j] += value;
		of->diagonal[i + 1][j] += value;
		of->off[i][j] -= value;
	}
}

static inline void friction_contact(struct friction_case *of, int i, double angle, double mu)
{
	struct hawser_contact *c = &of->contact[of->contacts++];
	double normal[3] = {-sin(angle), cos(angle), of->space ? friction_between(of, -0.2, 0.2) : 0.0};

	*c = (struct hawser_contact){.node = i, .friction = mu*friction_between(of, 0.2, 1.0)};
	hawser_contact_frame(c, normal);
	if (friction_between(of, 0.0, 1.0) < 0.3)
		c->gap_rate = friction_between(of, 0.0, 1.0);
	if (friction_between(of, 0.0, 1.0) < 0.2) {
		c->restitution = friction_between(of, 0.0, 1.0);
		c->before = friction_between(of, -1.0, 0.2);
	}
	if (friction_between(of, 0.0, 1.0) < 0.3)
		for (int k = 0; k < (of->space ? 3 : 2); k++)
			c->surface[k] = friction_between(of, -0.3, 0.3);
}

/* mu: the largest coefficient of friction; stiff: the largest stiffness. */
static inline void friction_random(struct friction_case *of, int number, double mu, double stiff)
{
	double turn, angle = 0.0;

	memset(of, 0, sizeof *of);
	of->state = UINT64_C(88172645463325252)*(2*(uint64_t)number + 1);
	for (int i = 0; i < 8; i++)
		(void)friction_between(of, 0.0, 1.0);
	of->nodes = 2 + (int)friction_between(of, 0.0, FRICTION_NODES - 2.0);
	of->space = friction_between(of, 0.0, 1.0) < 0.5;
	of->stiffness = pow(stiff, friction_between(of, -0.3, 1.0));
	turn = friction_between(of, 0.0, 1.0) < 0.5 ? 0.0 : friction_between(of, -3.0, 3.0)/of->nodes;
	for (int i = 0; i < of->nodes; i++) {
		double rough = friction_between(of, -0.1, 0.1);

		of->link[i][0] = i;
		of->link[i][1] = i + 1;
		of->held[i] = of->space ? 0 : 4;
		for (int k = 0; k < 3; k++)
			of->diagonal[i][4*k] += friction_between(of, 0.5, 1.5);
		if (i + 1 < of->nodes)
			friction_element(of, i, angle + turn/2.0);
		if (friction_between(of, 0.0, 1.0) < 0.9)
			friction_contact(of, i, angle + rough, mu);
		for (int k = 0; k < (of->space ? 3 : 2); k++)
			of->right[i][k] = friction_between(of, -1.0, 1.0) - (k == 1 ? 0.8 : 0.0);
		angle += turn;
	}
	if (friction_between(of, 0.0, 1.0) < 0.3) { /* a support that moves */
		of->held[0] = 7;
		if (of->contacts && of->contact[0].node == 0)
			of->contact[0] = of->contact[--of->contacts];
	}
	if (friction_between(of, 0.0, 1.0) < 0.5) /* a pull at the end */
		of->right[of->nodes - 1][0] += 0.3*of->nodes;
}

static inline struct hawser_friction_problem friction_problem(const struct friction_case *of)
{
	return (struct hawser_friction_problem){
		.diagonal = of->diagonal, .off = of->off, .right = of->right, .held = of->held,
		.contact = of->contact, .contacts = of->contacts};
}

/* Status as of the library. */
static inline enum hawser_status friction_solve(double (*u)[3], struct hawser_contact_reply *reply,
                                                struct hawser_friction_counts *counts,
                                                const struct friction_case *of,
                                                struct hawser_report *report)
{
	const struct hawser_friction_problem problem = friction_problem(of);
	struct hawser_friction *solver;
	enum hawser_status status = hawser_friction_open(&solver, of->nodes, of->link,
	                                                 of->nodes - 1 + of->rings, of->contacts, report);

	if (!status)
		status = hawser_friction_solve(solver, u, reply, counts, &problem, NULL, report);
	hawser_friction_clear(solver);
	return status;
}

#endif

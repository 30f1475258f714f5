/* net/motion/motion-bed.c - planes that give way, as a seabed, in the time steps of a mesh.
 *
 * s0, s1  depth of a node in the plane at both ends of the step, below 0 above it
 * p       max(s, 0); W = k*p^2/2 its energy, and c*p' the damping of its rate
 *
 * The force along the normal is the discrete gradient of W, (W1 - W0)/(s1 - s0), and c*(p1 -
 * p0)/h, as that of an element along itself (net/motion/motion-law.c); it does not pull. So the
 * change of W is kept exactly, and the damping only takes energy.
 *
 * Friction T is that of springs along the plane, which slide where |T| would be above mu*N: with the
 * slip x relative to the plane it is T0 - stiff*x, or as much of it as mu*N. It acts over all of the
 * step, so that springs that stick lose some energy too, and none is won.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/motion/motion-contact.h"

/* Of a spring along the plane over that across it: the slip before it slides is this part of mu times
 * the depth, of which the friction of moorings feels nothing. */
static const double STIFFER_ALONG = 10.0;

struct step {
	double k, c, n[3], s0, s1;
};

/* Friction of the step, for the force N across the plane whose derivative by s1 is `slope`, and what
 * it adds to the block of the node. */
static void rub(double T[3], double *block, const struct hawser__motion *motion, int number,
                const struct step *of, double N, double slope, double h)
{
	const struct hawser__touch *touch = &motion->mesh->touch[number];
	const struct hawser__motion_touch *now = &motion->contact->touch[number];
	const double *x = motion->x[touch->node], stiff = STIFFER_ALONG*of->k;
	const double *v = touch->surface->velocity;
	double across = hawser__dot(of->n, x), size, most, part;

	for (int k = 0; k < 3; k++)
		T[k] = now->T[k] - stiff*(x[k] - across*of->n[k] - h*v[k]);
	size = hawser__norm(T);
	most = touch->surface->friction*N;
	part = size > most ? most/size : 1.0;
	for (int i = 0; i < 9 && block; i++) {
		double along = part < 1.0 ? T[i/3]*T[i % 3]/(size*size) : 0.0;
		double plane = (i % 4 ? 0.0 : 1.0) - of->n[i/3]*of->n[i % 3];

		block[i] += part*stiff*(plane - along);
		if (part < 1.0)
			block[i] += touch->surface->friction*slope*T[i/3]/size*of->n[i % 3];
	}
	for (int k = 0; k < 3; k++)
		T[k] *= part;
}

/* 0 for a touch of a rigid obstacle. x: the increment of its node, or NULL: the state, as s0 and
 * s1. */
static int soft(struct step *step, const struct hawser__motion *motion, int number, int moves)
{
	const struct hawser__touch *touch = &motion->mesh->touch[number];
	const double *from = (moves ? motion->u0 : motion->u)[touch->node];
	double at[3];

	if (!(touch->give > 0.0))
		return 0;
	for (int k = 0; k < 3; k++)
		at[k] = motion->reference[touch->node][k] + from[k];
	step->k = 1.0/touch->give;
	step->c = step->k*touch->surface->damping/touch->surface->stiffness;
	step->s0 = step->s1 = -hawser_surface_gap(step->n, NULL, touch->surface, at);
	if (moves)
		step->s1 -= hawser__dot(step->n, motion->x[touch->node]);
	return 1;
}

/* Force of the step, and its derivative by s1. */
static double force(double *slope, const struct step *of, const struct hawser__motion_rule *rule,
                    double h)
{
	double p0 = fmax(of->s0, 0.0), p1 = fmax(of->s1, 0.0), N = of->k*p0, ratio;

	*slope = 0.0;
	if (rule->weight >= 0.0) /* at the beginning */
		return N;
	if (p0 > 0.0 && p1 > 0.0) {
		N = 0.5*of->k*(p0 + p1);
		*slope = 0.5*of->k;
	} else if (p1 > 0.0) {
		ratio = p1/(of->s1 - of->s0);
		N = 0.5*of->k*p1*ratio;
		*slope = of->k*ratio*(1.0 - 0.5*ratio);
	} else if (p0 > 0.0) {
		ratio = p0/(of->s0 - of->s1);
		N = 0.5*of->k*p0*ratio;
		*slope = 0.5*of->k*ratio*ratio;
	}
	N += of->c*(p1 - p0)/h;
	*slope += p1 > 0.0 ? of->c/h : 0.0;
	if (N >= 0.0)
		return N;
	*slope = 0.0;
	return 0.0;
}

enum hawser_status hawser__bed_open(struct hawser__motion *motion, struct hawser_report *report)
{
	int count = 0;

	for (int i = 0; i < motion->mesh->touches; i++)
		count += motion->mesh->touch[i].give > 0.0;
	if (!count)
		return HAWSER_OK;
	motion->soft = 1;
	if (motion->block)
		return HAWSER_OK;
	motion->bed = calloc((size_t)motion->nodes + 1, sizeof *motion->bed);
	motion->block = motion->bed;
	return motion->bed ? HAWSER_OK : hawser__no_memory(report, "net");
}

double hawser__bed_residual(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                            double h, int tangent)
{
	double most = 0.0, slope;
	struct step step;

	for (int i = 0; i < motion->mesh->touches; i++) {
		int node = motion->mesh->touch[i].node;
		double N;

		if (!soft(&step, motion, i, 1))
			continue;
		N = force(&slope, &step, rule, h);
		for (int k = 0; k < 3; k++)
			motion->r[node][k] -= N*step.n[k];
		for (int k = 0; k < 9 && tangent; k++)
			motion->block[node][k] += slope*step.n[k/3]*step.n[k%3];
		if (motion->contact) {
			double *T = motion->contact->touch[i].rubbed;

			motion->contact->touch[i].given = N;
			if (motion->mesh->touch[i].surface->friction > 0.0 && rule->weight < 0.0)
				rub(T, tangent ? motion->block[node] : NULL, motion, i, &step, N, slope, h);
			for (int k = 0; k < 3; k++)
				motion->r[node][k] -= T[k];
		}
		most = fmax(most, N);
	}
	return most;
}

double hawser__bed_energy(const struct hawser__motion *motion)
{
	double sum = 0.0;
	struct step step;

	for (int i = 0; i < motion->mesh->touches; i++)
		if (soft(&step, motion, i, 0)) {
			const double *T = motion->contact ? motion->contact->touch[i].T : NULL;

			sum += 0.5*step.k*fmax(step.s0, 0.0)*fmax(step.s0, 0.0);
			sum += T ? 0.5*hawser__dot(T, T)/(STIFFER_ALONG*step.k) : 0.0;
		}
	return sum;
}

/* What the friction of a step takes, and what the plane gives where it moves. */
static void rubbed(struct hawser__motion *motion, int number, const struct step *of, double h)
{
	const struct hawser__touch *at = &motion->mesh->touch[number];
	struct hawser__motion_touch *touch = &motion->contact->touch[number];
	const double *x = motion->x[at->node], *T = touch->rubbed, *before = touch->T;
	double drives = h*hawser__dot(T, at->surface->velocity);
	double lost = drives - hawser__dot(T, x) - 0.5*(hawser__dot(T, T) - hawser__dot(before, before))/
	                                    (STIFFER_ALONG*of->k);
	motion->contact->friction += lost;
	motion->contact->surfaces += drives;
	motion->energy.dissipated += lost;
	motion->energy.work += drives;
	memcpy(touch->T, T, sizeof touch->T);
}

void hawser__bed_account(struct hawser__motion *motion, double h)
{
	struct step step;

	for (int i = 0; i < motion->mesh->touches; i++) {
		double p0, p1;

		if (!soft(&step, motion, i, 1))
			continue;
		p0 = fmax(step.s0, 0.0);
		p1 = fmax(step.s1, 0.0);
		motion->energy.dissipated += motion->contact->touch[i].given*(step.s1 - step.s0) -
		                             0.5*step.k*(p1 - p0)*(p1 + p0);
		rubbed(motion, i, &step, h);
	}
}

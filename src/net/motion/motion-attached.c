/* net/motion/motion-attached.c - springs, dampers and absorbers of nodes in a step; see
 * net/motion/motion.h and net/absorbers.c.
 *
 * The row of a stroke s has its increment, with A = m*m0 + c*c0 + k*part, and that of its node u:
 *
 *   A s + m*m0 e.u = r,   so that s goes into the block of the node, - (m*m0)^2/A e e'
 *
 * and into its right side: the factors know nothing of absorbers, whose own block is 1.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "core/report.h"
#include "core/vec3.h"
#include "net/motion/motion.h"

static int has_attached(const struct hawser__mesh *mesh)
{
	int any = mesh->absorbers > 0;

	for (int i = 0; i < 3*mesh->nodes && !any; i++)
		any = mesh->unknown[i/3][i%3] >= 0 &&
		      (mesh->spring[i/3][i%3] > 0.0 || mesh->damper[i/3][i%3] > 0.0);
	return any;
}

enum hawser_status hawser__attached_open(struct hawser__motion *motion, struct hawser_report *report)
{
	motion->attached = has_attached(motion->mesh);
	if (!motion->attached)
		return HAWSER_OK;
	motion->stroke = calloc((size_t)motion->mesh->absorbers + 1, sizeof *motion->stroke);
	if (!motion->block)
		motion->block = motion->springs = calloc((size_t)motion->nodes + 1, sizeof *motion->block);
	return motion->stroke && motion->block ? HAWSER_OK : hawser__no_memory(report, "net");
}

/* Part of the increment in the force of a spring. */
static double part_of(const struct hawser__motion_rule *rule)
{
	return rule->weight < 0.0 ? 0.5 : rule->weight;
}

static double absorber(struct hawser__motion *motion, int i, const struct hawser__motion_rule *rule,
                       int tangent)
{
	const struct hawser__mesh_absorber *of = &motion->mesh->absorber[i];
	double inertia = of->mass*motion->acc[of->at][of->axis], coupled = of->mass*rule->m[0];
	double own = coupled + rule->c[0]*motion->mesh->damper[of->at][of->axis] +
	             part_of(rule)*motion->mesh->spring[of->at][of->axis];

	motion->r[of->at][of->axis] += inertia + of->mass*hawser__dot(of->e, motion->acc[of->node]);
	for (int k = 0; k < 3; k++)
		motion->r[of->node][k] += inertia*of->e[k];
	for (int k = 0; k < 9 && tangent; k++)
		motion->block[of->node][k] -= coupled*coupled/own*of->e[k/3]*of->e[k%3];
	if (tangent) {
		motion->stroke[i][0] = own;
		motion->stroke[i][1] = coupled;
		motion->block[of->at][4*of->axis] = 1.0;
	}
	return fabs(inertia);
}

double hawser__attached_residual(struct hawser__motion *motion, const struct hawser__motion_rule *rule,
                                 int tangent)
{
	const struct hawser__mesh *mesh = motion->mesh;
	double most = 0.0;

	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < 3; k++) {
			double spring = mesh->spring[i][k], damper = mesh->damper[i][k], force;

			if (mesh->unknown[i][k] < 0 || spring + damper == 0.0)
				continue;
			force = spring*(motion->u0[i][k] + part_of(rule)*motion->x[i][k]) +
			        damper*motion->vel[i][k];
			motion->r[i][k] += force;
			most = fmax(most, fabs(force));
			if (tangent)
				motion->block[i][4*k] += part_of(rule)*spring + rule->c[0]*damper;
		}
	for (int i = 0; i < mesh->absorbers; i++)
		most = fmax(most, absorber(motion, i, rule, tangent));
	return most;
}

void hawser__attached_eliminate(struct hawser__motion *motion, int solved)
{
	for (int i = 0; i < motion->mesh->absorbers; i++) {
		const struct hawser__mesh_absorber *of = &motion->mesh->absorber[i];
		const double *stroke = motion->stroke[i];
		double *r = &motion->r[of->at][of->axis];

		if (motion->mesh->unknown[of->at][of->axis] < 0)
			continue;
		if (solved)
			*r = (*r - stroke[1]*hawser__dot(of->e, motion->r[of->node]))/stroke[0];
		for (int k = 0; k < 3 && !solved; k++)
			if (motion->mesh->unknown[of->node][k] >= 0)
				motion->r[of->node][k] -= stroke[1]/stroke[0]*of->e[k]*(*r);
	}
}

void hawser__attached_energies(double *kinetic, double *potential, const struct hawser__motion *motion)
{
	const struct hawser__mesh *mesh = motion->mesh;

	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0)
			*potential += 0.5*mesh->spring[i/3][i%3]*motion->u[i/3][i%3]*motion->u[i/3][i%3];
	for (int i = 0; i < mesh->absorbers; i++) {
		const struct hawser__mesh_absorber *of = &mesh->absorber[i];
		double v = motion->v[of->at][of->axis];

		*kinetic += of->mass*v*(hawser__dot(of->e, motion->v[of->node]) + 0.5*v);
	}
}

double hawser__attached_loss(const struct hawser__motion *motion, double h)
{
	const struct hawser__mesh *mesh = motion->mesh;
	double lost = 0.0;

	for (int i = 0; i < 3*mesh->nodes; i++)
		if (mesh->unknown[i/3][i%3] >= 0)
			lost += mesh->damper[i/3][i%3]*motion->x[i/3][i%3]*motion->x[i/3][i%3]/h;
	return lost;
}

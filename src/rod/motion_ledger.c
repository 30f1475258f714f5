/* rod/motion_ledger.c - energy, momentum and angular momentum of a rod in motion, and its loads'.
 *
 * Work in a step: mean of the forces at its ends, by what moves and turns in it; momentum: mean
 * force times its length. These are of order 2, as the steps are. What is left of the energy is what
 * the scheme takes (rho_inf below 1), and the error of these sums.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "rod/motion.h"
#include "rod/so3.h"

/* Momenta and energy of one mass: c its place, v its velocity, L its angular momentum in the
 * section's axes. */
static void sum_mass(struct hawser__rod_motion *motion, double mass, const double c[3],
                     const double v[3], const double L[3], const double spin[3], const double R[9])
{
	struct hawser__rod_momentum *sum = &motion->momentum;
	double arm[3], turned[3], p[3];

	for (int k = 0; k < 3; k++)
		p[k] = mass*v[k];
	hawser__cross(arm, c, p);
	hawser__apply(turned, R, L);
	for (int k = 0; k < 3; k++) {
		sum->linear[k] += p[k];
		sum->angular[k] += arm[k] + turned[k];
	}
	motion->energy.kinetic += 0.5*(hawser__dot(p, v) + hawser__dot(L, spin));
	motion->energy.height += mass*motion->mesh->rod->g*c[1];
}

void hawser__rod_motion_sum(struct hawser__rod_motion *motion)
{
	struct hawser__rod_mesh *mesh = motion->mesh;
	struct hawser__rod_momentum *sum = &motion->momentum;

	memset(sum->linear, 0, sizeof sum->linear);
	memset(sum->angular, 0, sizeof sum->angular);
	motion->energy.kinetic = motion->energy.height = 0.0;
	motion->energy.strain = hawser__rod_strain_energy(mesh);
	for (int i = 0; i < mesh->nodes; i++) {
		const double *u = motion->velocity[i];
		double R[9], L[3], v[6];

		memcpy(v, u, sizeof v);
		hawser__quaternion_matrix(R, mesh->node[i].q);
		for (int k = 0; k < 3; k++) {
			L[k] = motion->mass[i][1 + k]*v[3 + k];
			v[k] += motion->winch.as ? motion->winch.slip[i][k] : 0.0;
		}
		sum_mass(motion, motion->mass[i][0], mesh->node[i].x, v, L, v + 3, R);
	}
	motion->energy.kinetic += hawser__rod_winch_kinetic(motion);
	for (int b = 0; b < motion->bodies; b++) {
		const struct hawser__rod_body *body = &motion->body[b];
		const double *spin = motion->velocity[body->node] + 3;
		double R[9], L[3], c[3], v[3], moved[3];

		hawser__quaternion_matrix(R, mesh->node[body->node].q);
		hawser__apply(L, body->inertia, spin);
		hawser__apply(c, R, body->offset);
		hawser__cross(moved, spin, body->offset);
		hawser__apply(v, R, moved);
		for (int k = 0; k < 3; k++) {
			c[k] += mesh->node[body->node].x[k];
			v[k] += motion->velocity[body->node][k];
		}
		sum_mass(motion, body->mass, c, v, L, spin, R);
	}
}

/* Force and moment of a node, times its part of the step, into the sums of momentum. */
static void impulse(struct hawser__rod_momentum *to, const double f[6],
                    const struct hawser__rod_node *node, double part)
{
	double R[9], moment[3], arm[3];

	hawser__quaternion_matrix(R, node->q);
	hawser__apply(moment, R, f + 3);
	hawser__cross(arm, node->x, f);
	for (int k = 0; k < 3; k++) {
		to->force[k] += part*f[k];
		to->moment[k] += part*(arm[k] + moment[k]);
	}
}

/* All on node i at the beginning (0) or end of the step: loads, weight, damping, supports. */
static void all_on(double f[6], const struct hawser__rod_motion *motion, int i, int end)
{
	const double *v = end ? motion->velocity[i] : motion->velocity0[i];
	const double *applied = end ? motion->applied[i] : motion->applied0[i];
	const double *pushed = end ? motion->pushed[i] : motion->pushed0[i];
	const double *reaction = end ? motion->reaction[i] : motion->reaction0[i];
	const double *mass = end ? motion->mass[i] : motion->mass0[i], none[6] = {0.0};
	const double *slip = !motion->winch.as ? none : end ? motion->winch.slip[i]
	                                                    : motion->winch.slip0[i];

	for (int k = 0; k < 6; k++)
		f[k] = applied[k] + pushed[k] + reaction[k] -
		       motion->alpha*mass[k < 3 ? 0 : k - 2]*(v[k] + (k < 3 ? slip[k] : 0.0)) +
		       (k < 3 ? 0.0 : slip[k]);
	f[1] -= mass[0]*motion->mesh->rod->g;
}

/* The largest defects so far, and the largest terms. */
static void gaps(struct hawser__rod_motion *motion)
{
	const struct hawser__rod_momentum *of = &motion->momentum;
	const struct hawser__rod_energy *e = &motion->energy;
	double line[3], turn[3], gained = e->kinetic + e->strain + e->height - motion->start_energy;

	for (int k = 0; k < 3; k++) {
		line[k] = of->linear[k] - motion->start[k] - of->force[k];
		turn[k] = of->angular[k] - motion->start[3 + k] - of->moment[k];
	}
	motion->momentum_gap = fmax(motion->momentum_gap, sqrt(hawser__dot(line, line)));
	motion->angular_gap = fmax(motion->angular_gap, sqrt(hawser__dot(turn, turn)));
	motion->most_momentum = fmax(motion->most_momentum,
	                             sqrt(fmax(hawser__dot(of->linear, of->linear),
	                                       hawser__dot(of->force, of->force))));
	motion->most_angular = fmax(motion->most_angular,
	                            sqrt(fmax(hawser__dot(of->angular, of->angular),
	                                      hawser__dot(of->moment, of->moment))));
	motion->energy_lost = e->work + e->pushed + e->support + e->winch - e->damped - gained;
	motion->most_energy = fmax(fmax(fmax(motion->most_energy, e->kinetic + e->strain), e->damped),
	                           fmax(fmax(fabs(e->work), fabs(e->support)),
	                                fmax(fabs(e->pushed), fabs(e->winch))));
}

/* Loads and damping act on the material, which moves through the nodes; the winch. */
static void account_winch(struct hawser__rod_motion *motion, double h)
{
	struct hawser__rod_winch *winch = &motion->winch;
	struct hawser__rod_energy *energy = &motion->energy;
	double power = winch->power, store = winch->store;

	hawser__rod_winch_power(motion);
	energy->winch += 0.5*h*(power + winch->power) + winch->store - store;
	for (int i = 0; i <= winch->elements; i++)
		for (int end = 0; end < 2; end++) {
			const double *slip = end ? winch->slip[i] : winch->slip0[i];
			const double *d = motion->step[i];
			const double *v = end ? motion->velocity[i] : motion->velocity0[i];
			double half = 0.5*h, mass = motion->alpha*(end ? motion->mass[i][0] : motion->mass0[i][0]);

			for (int k = 0; k < 3; k++) {
				energy->work += half*slip[k]*(end ? motion->applied[i][k] : motion->applied0[i][k]);
				energy->pushed += half*slip[k]*(end ? motion->pushed[i][k] : motion->pushed0[i][k]);
				energy->damped += mass*slip[k]*(half*(v[k] + slip[k]) + 0.5*d[k]);
			}
		}
}

void hawser__rod_motion_account(struct hawser__rod_motion *motion, double h)
{
	const struct hawser__rod_mesh *mesh = motion->mesh;
	struct hawser__rod_energy *energy = &motion->energy;

	for (int i = 0; i < mesh->nodes; i++) {
		const double *d = motion->step[i];
		double f[6];

		for (int k = 0; k < 6; k++) {
			double half = 0.5*d[k];

			energy->work += half*(motion->applied[i][k] + motion->applied0[i][k]);
			energy->pushed += half*(motion->pushed[i][k] + motion->pushed0[i][k]);
			energy->support += half*(motion->reaction[i][k] + motion->reaction0[i][k]);
			energy->damped += half*motion->alpha*
			                  (motion->mass[i][k < 3 ? 0 : k - 2]*motion->velocity[i][k] +
			                   motion->mass0[i][k < 3 ? 0 : k - 2]*motion->velocity0[i][k]);
		}
		all_on(f, motion, i, 0);
		impulse(&motion->momentum, f, &motion->node0[i], 0.5*h);
		all_on(f, motion, i, 1);
		impulse(&motion->momentum, f, &mesh->node[i], 0.5*h);
	}
	for (int b = 0; b < motion->bodies; b++) {
		const struct hawser__rod_body *body = &motion->body[b];

		for (int end = 0; end < 2; end++) {
			const struct hawser__rod_node *node = end ? &mesh->node[body->node]
			                                          : &motion->node0[body->node];
			double R[9], weight[6] = {0.0, -body->mass*mesh->rod->g, 0.0}, down[3];

			hawser__quaternion_matrix(R, node->q);
			hawser__apply_left(down, R, weight);
			hawser__cross(weight + 3, body->offset, down);
			impulse(&motion->momentum, weight, node, 0.5*h);
		}
	}
	if (motion->winch.as)
		account_winch(motion, h);
	hawser__rod_motion_sum(motion);
	gaps(motion);
}

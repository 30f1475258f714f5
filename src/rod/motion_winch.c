/* rod/motion_winch.c - inertia and energy of a rod that lengthens (motion.h).
 *
 * In an element of the first segment, of length h = part l and with the chord d = x2 - x1,
 *   c_k   = (1 - sigma_k) l', of the material through its node k; c_k/h = b g_k, b = l'/l
 *   V_k   = v_k + b g_k d, velocity of the material; m = rho h/2, half of its mass
 * The kinetic energy sum of m |V_k|^2/2 is that of half the mass at each node, of a rod that does not
 * lengthen. As the place of the start is given, and with it that of all material behind it, Hamilton's
 * principle for the rod between start and end has no term of the material that comes in (McIver 1973
 * has one for ends that are free), and Lagrange's equations d(dL/dv)/dt - dL/dx = Q hold as they stand:
 *   F_k = m (v_k' + b V_k + b' g_k d + b g_k d') -+ m b (g_1 V_1 + g_2 V_2)    (- of node 2)
 * With E = T + strain + height and L = T - strain - height,
 *   dE/dt = Q.v - dL/dt (of l alone) + d(sum of m V_k . b g_k d)/dt
 * and a load on the material does Q.V, not Q.v; what is left is the winch's: the work of the rod's
 * tension at the start along the material that runs out, and the energy of that material.
 *
 * The convective part of the inertia of rotation is left out, as small as the square of the radius of
 * gyration over the length of a wave: nodes have J w' + w x J w with the J of their length. Material
 * comes in with the spin that there is.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "rod/motion.h"
#include "rod/so3.h"

/* Of an element: see above. */
struct piece {
	double m, b, b1, g[2], d[3], d1[3], V[2][3]; /* b1, d1: b', d' */
};

static void piece_of(struct piece *p, const struct hawser__rod_motion *motion, int e)
{
	const struct hawser__rod_winch *winch = &motion->winch;
	const struct hawser__rod_mesh *mesh = motion->mesh;

	p->m = 0.5*mesh->rod->segment[0].rho*mesh->element[e].h;
	p->b = winch->speed/winch->length;
	p->b1 = winch->rate/winch->length - p->b*p->b;
	for (int k = 0; k < 3; k++) {
		p->d[k] = mesh->node[e + 1].x[k] - mesh->node[e].x[k];
		p->d1[k] = motion->velocity[e + 1][k] - motion->velocity[e][k];
	}
	for (int i = 0; i < 2; i++) {
		p->g[i] = winch->left[e + i]/winch->part[e];
		for (int k = 0; k < 3; k++)
			p->V[i][k] = motion->velocity[e + i][k] + p->b*p->g[i]*p->d[k];
	}
}

void hawser__rod_winch_slip(struct hawser__rod_motion *motion)
{
	struct hawser__rod_winch *winch = &motion->winch;
	const struct hawser__rod_mesh *mesh = motion->mesh;
	const double *J = mesh->rod->segment[0].inertia;

	memset(winch->slip, 0, (size_t)(winch->elements + 1)*sizeof *winch->slip);
	for (int e = 0; e < winch->elements; e++) {
		double through = winch->speed*winch->left[e], both = mesh->element[e].h;

		if (e > 0)
			both += mesh->element[e - 1].h;
		for (int i = e > 0 ? e - 1 : e; i <= e; i++)
			for (int k = 0; k < 3; k++)
				winch->slip[e][k] += through/both*(mesh->node[i + 1].x[k] - mesh->node[i].x[k]);
		for (int i = e; i < e + 2; i++)
			for (int k = 0; k < 3; k++)
				winch->slip[i][3 + k] += 0.5*winch->part[e]*winch->speed*J[k]*
				                         motion->velocity[i][3 + k];
	}
}

/* Coefficients of places and velocities j in the force of node i. */
static void matrix(struct hawser__rod_motion *motion, const struct piece *p, int e)
{
	const double sign[2] = {-1.0, 1.0};
	double square = p->b*p->b*(p->g[0]*p->g[0] + p->g[1]*p->g[1]);

	for (int i = 0; i < 2; i++)
		for (int j = 0; j < 2; j++) {
			double at = p->m*sign[j]*((p->b*p->b + p->b1 + motion->alpha*p->b)*p->g[i] -
			                          sign[i]*square);
			double by = p->m*p->b*((i == j ? 1.0 : 0.0) + p->g[i]*sign[j] - sign[i]*p->g[j]);

			for (int k = 0; k < 3; k++)
				*hawser__band_at(&motion->mesh->band, HAWSER__ROD_FREE*(e + i) + k,
				                 HAWSER__ROD_FREE*(e + j) + k) +=
					motion->by_place*at + motion->to_velocity*by;
		}
}

void hawser__rod_winch_form(struct hawser__rod_motion *motion, int tangent)
{
	for (int e = 0; e < motion->winch.elements; e++) {
		struct piece p;

		piece_of(&p, motion, e);
		for (int k = 0; k < 3; k++) {
			double pull = p.b*(p.g[0]*p.V[0][k] + p.g[1]*p.V[1][k]);

			for (int i = 0; i < 2; i++)
				motion->mesh->r[HAWSER__ROD_FREE*(e + i) + k] -=
					p.m*(p.b*p.V[i][k] + p.g[i]*(p.b1*p.d[k] + p.b*p.d1[k] +
					                             motion->alpha*p.b*p.d[k]) + (i ? -pull : pull));
		}
		if (tangent)
			matrix(motion, &p, e);
	}
}

double hawser__rod_winch_kinetic(const struct hawser__rod_motion *motion)
{
	double sum = 0.0;

	for (int e = 0; e < motion->winch.elements; e++) {
		struct piece p;

		piece_of(&p, motion, e);
		for (int i = 0; i < 2; i++)
			sum += 0.5*p.m*p.b*p.b*p.g[i]*p.g[i]*hawser__dot(p.d, p.d);
	}
	for (int i = 0; motion->winch.as && i <= motion->winch.elements; i++)
		sum -= 0.5*motion->mass[i][0]*hawser__dot(motion->winch.slip[i], motion->winch.slip[i]);
	return sum;
}

void hawser__rod_winch_power(struct hawser__rod_motion *motion)
{
	struct hawser__rod_winch *winch = &motion->winch;
	const struct hawser__rod_mesh *mesh = motion->mesh;
	double g = mesh->rod->g, rho = mesh->rod->segment[0].rho;

	if (!winch->as)
		return;
	winch->power = winch->store = 0.0;
	for (int e = 0; e < winch->elements; e++) {
		double longer = winch->part[e]*winch->speed;
		struct piece p;

		piece_of(&p, motion, e);
		winch->power += longer*hawser__rod_energy_by_length(&mesh->element[e], &mesh->strain[e]);
		for (int i = 0; i < 2; i++) {
			double along = hawser__dot(p.V[i], p.d)*p.g[i];

			winch->power += 0.5*longer*rho*g*mesh->node[e + i].x[1] - p.m*p.b1*along -
			                0.5*p.b*p.m*hawser__dot(p.V[i], p.V[i]);
			winch->store += p.m*p.b*along;
		}
	}
	for (int i = 0; i <= winch->elements; i++) {
		const double *slip = winch->slip[i], *v = motion->velocity[i];

		winch->power += 0.5*hawser__dot(slip + 3, v + 3);
		for (int k = 0; k < 3; k++)
			winch->power += slip[k]*(motion->alpha*motion->mass[i][0]*(v[k] + slip[k]) -
			                         motion->applied[i][k] - motion->pushed[i][k]);
	}
}

/* With s counted along the material the rod is a string of wave speed sqrt(T/(rho w)) at its start. If
 * the start moves through the material faster than that, the place of the start alone does not
 * determine the motion (pay-out) or is one condition too many (haul-in). A clamped start has bending,
 * whose waves have no largest speed. */
int hawser__rod_winch_watch(struct hawser__rod_motion *motion)
{
	struct hawser__rod_winch *winch = &motion->winch;
	const struct hawser__rod_mesh *mesh = motion->mesh;
	const struct hawser__rod_strain *at = mesh->strain;
	double square = fmax(at->N[0], 0.0)/(mesh->rod->segment[0].rho*at->w[0]);

	if (!winch->as || mesh->rod->hold[0] != HAWSER_ROD_HINGED)
		return 0;
	winch->over = winch->speed*winch->speed > square
		? winch->over + fabs(winch->speed)*motion->h : 0.0;
	return winch->over > mesh->element[0].h;
}

double hawser__rod_winch_through(const struct hawser__rod_motion *motion, int e)
{
	const struct hawser__rod_winch *winch = &motion->winch;

	return winch->as && e < winch->elements ? 0.5*winch->speed*(winch->left[e] + winch->left[e + 1])
	                                        : 0.0;
}

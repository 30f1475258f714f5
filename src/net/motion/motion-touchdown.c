/* net/motion/motion-touchdown.c - where a cable leaves a plane that gives way, within an element.
 *
 * An element is a bar, and the plane acts at its ends; so the place where a heavy cable leaves the
 * plane would jump from node to node, and the tension with it, with an error of the order of the
 * element's length L. Between the nodes the cable really lies on the plane, and rises from it as a
 * parabola: what this changes in the forces at the ends has an energy, which is added here.
 *
 * k     of the plane, of half an element at each end, N/m
 * s, z  depth of an end in the plane, and the height -s
 * w, c  weight per length across the plane, and the curvature w/H of the free cable, with the tension H
 *       of the reference
 * l     length that is free at an end, whose height is y = c*l^2/2
 *
 * On a rigid plane the energy of the shape between the ends, less that of the bar, is with
 * f = L - l_a - l_b > 0, the length that lies,
 *   V = w*c*(f^3*(f + 4*(l_a + l_b)) + 12*l_a*l_b*f^2)/(24*L),
 * convex in the heights y >= 0, and 0 where the cable is free. The plane gives way by springs k between
 * the ends at z and this shape: the energy is the least of V + k*(y - z)^2/2 over y (its Moreau
 * envelope), whose derivative k*(y - z) is continuous, with its own derivative. V grows towards y = 0
 * as -w*L*y/2, so that an element that lies has k*s at each end, as nodes alone have it, and fine
 * meshes have nothing else. For given y_b the condition for l_a is a quadratic equation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include "net/motion/motion-bed.h"
#include "net/water/water.h"

enum { SWEEPS = 100 };
/* Of the depth in which a cable lies: ways that are short. */
static const double SHORT = 1e-3;
/* Slope of an element that is free from one end on: above it the cable is no parabola. */
static const double STEEP = 1.0;
/* Of that depth: what is nearer to it has no force by its square. */
static const double LIES = 1e-8;

/* The lengths that are free. */
static void free_lengths(double l[2], const struct hawser__touchdown *of, const double z[2])
{
	const double A = 0.5*of->k*of->curvature - 0.5*of->w/of->L;

	for (int i = 0; i < 2; i++)
		l[i] = sqrt(2.0*fmax(z[i], 0.0)/of->curvature);
	for (int sweep = 0, moves = 1; sweep < SWEEPS && moves; sweep++) {
		moves = 0;
		for (int i = 0; i < 2; i++) {
			double C = of->k*z[i] + 0.5*of->w/of->L*(of->L - l[!i])*(of->L + l[!i]), now = 0.0;

			if (C > 0.0)
				now = 2.0*C/(of->w + sqrt(fmax(of->w*of->w + 4.0*A*C, 0.0)));
			moves |= fabs(now - l[i]) > 2.0*DBL_EPSILON*of->L;
			l[i] = now;
		}
	}
}

/* 1 if the whole element lies, or is free: the plane acts at its ends. */
static inline int plain(const struct hawser__touchdown *of, const double s[2])
{
	const double lies = 0.5*of->w*of->L*(1.0 - LIES)/of->k, top = 0.5*of->curvature*of->L*of->L;
	double a, b;

	if ((s[0] >= lies && s[1] >= lies) || s[0] <= -top || s[1] <= -top)
		return 1;
	if (s[0] >= 0.0 || s[1] >= 0.0)
		return 0;
	a = s[0] + s[1] + top; /* l/L is the root of -s/top; without roots l_a + l_b >= L is this */
	b = 4.0*s[0]*s[1];
	return a <= 0.0 || b >= a*a;
}

double hawser__touchdown_energy(double F[2], double (*F_s)[2], const struct hawser__touchdown *of,
                                const double s[2])
{
	const double z[2] = {-s[0], -s[1]}, k = of->k, w = of->w, c = of->curvature, L = of->L;
	double l[2], J[2][2], det, f, energy;

	memset(F, 0, 2*sizeof *F);
	if (F_s)
		memset(F_s, 0, 2*sizeof *F_s);
	if (plain(of, s))
		return s[0] > 0.0 && s[1] > 0.0 ? w*c*L*L*L/24.0 : 0.0;
	free_lengths(l, of, z);
	f = L - l[0] - l[1];
	energy = w*c*(f*f*f*(f + 4.0*(l[0] + l[1])) + 12.0*l[0]*l[1]*f*f)/(24.0*L);
	for (int i = 0; i < 2; i++) {
		double y = 0.5*c*l[i]*l[i], more = y - fmax(z[i], 0.0);

		F[i] = k*more;
		energy += 0.5*k*more*(y - z[i] + fmax(s[i], 0.0));
		J[i][i] = l[i] > 0.0 ? k*c*l[i] + w/L*(L - l[i]) : 1.0;
		J[i][!i] = l[i] > 0.0 ? w/L*l[!i] : 0.0;
	}
	det = J[0][0]*J[1][1] - J[0][1]*J[1][0];
	for (int i = 0; i < 2 && F_s; i++)
		for (int j = 0; j < 2; j++) {
			double inverse = (i == j ? J[!i][!i] : -J[i][j])/det;

			F_s[i][j] = l[j] > 0.0 ? -k*k*c*l[i]*inverse : 0.0;
			F_s[i][j] += i == j && z[i] > 0.0 ? k : 0.0;
		}
	return energy;
}

/* The mean force of a step is the gradient in the middle, and what it lacks to the change of the energy
 * along the way (Gonzalez 1996). On short ways, where round-off would be in that, it is by Simpson's
 * rule. */
void hawser__touchdown_mean(double F[2], double (*F_s)[2], const struct hawser__touchdown *of,
                            const double s0[2], const double s1[2])
{
	const double d[2] = {s1[0] - s0[0], s1[1] - s0[1]}, square = d[0]*d[0] + d[1]*d[1];
	const double middle[2] = {0.5*(s0[0] + s1[0]), 0.5*(s0[1] + s1[1])};
	const double lies = 0.5*of->w*of->L/of->k;
	double end[2], by[2][2], end_by[2][2], change, part;

	memset(F, 0, 2*sizeof *F);
	memset(F_s, 0, 2*sizeof *F_s);
	if (plain(of, s0) && plain(of, s1) && plain(of, middle))
		if ((fmin(s0[0], s0[1]) > 0.0) == (fmin(s1[0], s1[1]) > 0.0))
			return;
	(void)hawser__touchdown_energy(F, by, of, middle);
	change = hawser__touchdown_energy(end, end_by, of, s1) - of->energy0;
	if (square <= SHORT*lies*SHORT*lies) {
		for (int i = 0; i < 2; i++) {
			F[i] = (of->F0[i] + 4.0*F[i] + end[i])/6.0;
			for (int j = 0; j < 2; j++)
				F_s[i][j] = (2.0*by[i][j] + end_by[i][j])/6.0;
		}
		return;
	}
	part = (change - F[0]*d[0] - F[1]*d[1])/square;
	for (int i = 0; i < 2; i++)
		for (int j = 0; j < 2; j++) {
			double turned = 0.5*(by[0][j]*d[0] + by[1][j]*d[1]);

			F_s[i][j] = 0.5*by[i][j] + (i == j ? part : 0.0) +
			             d[i]*(end[j] - F[j] - turned - 2.0*part*d[j])/square;
		}
	for (int i = 0; i < 2; i++)
		F[i] += part*d[i];
}

void hawser__touchdown_begin(struct hawser__touchdown *of, const double s0[2])
{
	of->energy0 = hawser__touchdown_energy(of->F0, NULL, of, s0);
}

int hawser__touchdown_of(struct hawser__touchdown *of, const struct hawser__motion *motion, int e,
                         const struct hawser_surface *plane)
{
	const struct hawser__mesh *mesh = motion->mesh;
	const struct hawser__motion_element *el = &motion->element[e];
	const struct hawser_net_cable *cable = &mesh->net->cable[mesh->cable[e]];
	const double d = cable->line.diameter, L = mesh->length0[e];
	double n[3], H = hawser__elastic_tension(el, el->p_ref), m = mesh->rho[e];

	(void)hawser_surface_gap(n, NULL, plane, mesh->q[el->a]);
	if (mesh->water && !mesh->water->section)
		m -= 0.25*M_PI*d*d*mesh->water->of->density;
	*of = (struct hawser__touchdown){.element = e, .k = 0.5*plane->stiffness*d*L, .w = m*mesh->g*n[1],
	                                 .L = L};
	of->curvature = of->w/H;
	return of->k > 0.0 && of->w > 0.0 && H > 0.0 && of->curvature*L < STEEP;
}

/* net/motion/motion-normal.c - the mean normal of a bed with heights in a time step.
 *
 * x        way of the node in the step
 * m        normal in the middle of it
 *
 * The mean normal n is the discrete gradient of the gap, n.x = g1 - g0 (Gonzalez 1996), so that a force
 * along it has the work of the change of its energy:
 *   n = m + x*(g1 - g0 - m.x)/|x|^2.
 * On short ways round-off of the gaps would be in that: there it is the integral of the normal along
 * the way by Simpson's rule, whose error is of the fourth order of the way, and where the way passes
 * the begin of a rounding of the second.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "core/vec3.h"
#include "net/motion/motion-contact.h"

/* Of the coordinates: a way on which round-off of the gaps is 1e-10 of it. */
static const double SHORT = 1e-6;

void hawser__mean_normal(double n[3], double (*by)[3], const struct hawser_surface *surface,
                         const double from[3], const double to[3], double change,
                         const double n0[3], const double n1[3], const double (*H1)[3])
{
	double x[3], at[3], H[3][3], square, part, reach = 0.0;

	for (int k = 0; k < 3; k++) {
		x[k] = to[k] - from[k];
		at[k] = 0.5*(from[k] + to[k]);
		reach += fabs(at[k]) + fabs(surface->at[k]);
	}
	square = hawser__dot(x, x);
	(void)hawser_surface_gap(n, by ? H : NULL, surface, at);
	if (square <= SHORT*reach*SHORT*reach) {
		for (int k = 0; k < 3; k++)
			n[k] = (n0[k] + 4.0*n[k] + n1[k])/6.0;
		for (int k = 0; k < 9 && by; k++)
			by[k/3][k % 3] = (2.0*H[k/3][k % 3] + H1[k/3][k % 3])/6.0;
		return;
	}
	part = (change - hawser__dot(n, x))/square;
	for (int j = 0; j < 3 && by; j++) {
		double turned = 0.5*(H[0][j]*x[0] + H[1][j]*x[1] + H[2][j]*x[2]);

		for (int i = 0; i < 3; i++)
			by[i][j] = 0.5*H[i][j] + (i == j ? part : 0.0) +
			           x[i]*(n1[j] - n[j] - turned - 2.0*part*x[j])/square;
	}
	for (int k = 0; k < 3; k++)
		n[k] += part*x[k];
}

double hawser__clear_gap(double n[3], struct hawser__clear *clear, const struct hawser_surface *surface,
                         const double at[3], double near)
{
	double way[3], left;

	for (int k = 0; k < 3; k++)
		way[k] = at[k] - clear->at[k];
	left = clear->gap - hawser__norm(way);
	if (surface->heights && left > near)
		return left;
	memcpy(clear->at, at, sizeof clear->at);
	return clear->gap = hawser__contact_gap(n, surface, at);
}

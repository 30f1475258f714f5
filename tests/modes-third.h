/* tests/modes-third.h - the quadratic coupling of two modes to a third, by a route independent of
 * the library.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_MODES_THIRD_H
#define HAWSER_TESTS_MODES_THIRD_H

#include <hawser/modes.h>

/* T = D^3V3[Phi_j, Phi_k, Phi_s], from the definition a sigma/(2 g^2 eps). */
static inline double third(const struct hawser_modes *modes, int j, int k, int s)
{
	size_t points = (size_t)modes->grid.points;
	const double *x = modes->slope + 3*points*(size_t)j, *y = modes->slope + 3*points*(size_t)k;
	const double *z = modes->slope + 3*points*(size_t)s;
	double sum = 0.0;

	for (size_t p = 0; p < points; p++, x += 3, y += 3, z += 3) {
		double g = 1.0 + hawser_statics_frame(&modes->statics, modes->grid.s[p]).strain;

		sum += modes->grid.weight[p]/(g*g*modes->statics.epsilon)*
		       (x[0]*(y[1]*z[1] + y[2]*z[2]) + y[0]*(x[1]*z[1] + x[2]*z[2]) +
		        z[0]*(x[1]*y[1] + x[2]*y[2]));
	}
	return sum;
}

#endif

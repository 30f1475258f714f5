/* tests/velocity.h - the velocity of points of a cable against differences of their displacement.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_VELOCITY_H
#define HAWSER_TESTS_VELOCITY_H

#include <hawser/rom.h>

#include "tests/tap.h"

/* At the first `points` of the model's probes, forced at omega, in the state u [n], v [n]: central
 * differences over 2e-5 of the time unit, relative to the largest velocity. */
static inline void check_velocity(const struct hawser_rom *rom, int points, double omega,
                                  const double *u, const double *v, double tolerance)
{
	const double h = 1e-5;
	double *moved = malloc((size_t)rom->n*sizeof *moved), worst = 0.0, most = 0.0;

	for (int p = 0; moved && p < points; p++) {
		struct hawser_rom_moment moment = {.tau = 0.7, .omega = omega};
		double rate[3], side[2][3];

		hawser_rom_velocity_at(rom, rate, p, u, v, &moment);
		for (int k = 0; k < 2; k++) {
			double t = k ? h : -h;

			moment.tau = 0.7 + omega*t;
			for (int j = 0; j < rom->n; j++)
				moved[j] = u[j] + t*v[j];
			hawser_rom_displacement_at(rom, side[k], p, moved, &moment);
		}
		for (int i = 0; i < 3; i++) {
			most = fmax(most, fabs(rate[i]));
			worst = fmax(worst, fabs((side[1][i] - side[0][i])/(2.0*h) - rate[i]));
		}
	}
	free(moved);
	ok(most > 0.0 && worst < tolerance*most, "velocity is the derivative of displacement: %.1e",
	   worst/most);
}

#endif

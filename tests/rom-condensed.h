/* tests/rom-condensed.h - condensation by another route: the effect of modes that are not kept, mode by
 * mode, from their coupling to the kept ones (modes-third.h).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_ROM_CONDENSED_H
#define HAWSER_TESTS_ROM_CONDENSED_H

#include <math.h>
#include <stdlib.h>

#include <hawser/rom.h>

#include "tests/modes-third.h"
#include "tests/rom-entries.h"

enum { KEPT = 4 };

static inline int modes_of(struct hawser_modes *modes, const struct hawser_statics *st, int n)
{
	struct hawser_modes_options options = {.n = n, .tolerance = 1e-10};

	return !hawser_modes_solve(modes, st, &options, NULL);
}

/* Effect of the modes KEPT..upto on the entry: the sum over the three pairings of its four
 * indices. */
static inline double given_back(const double *T, const struct hawser_modes *modes, int upto,
                                const struct hawser_cubic *c)
{
	const int x[3][4] = {{c->j, c->k, c->l, c->m}, {c->j, c->l, c->k, c->m},
		{c->j, c->m, c->k, c->l}};
	double sum = 0.0;

	for (int w = 0; w < 3; w++)
		for (int s = KEPT; s < upto; s++)
			sum += T[(x[w][0]*KEPT + x[w][1])*modes->n + s]*
			       T[(x[w][2]*KEPT + x[w][3])*modes->n + s]/
			       pow(modes->mode[s].omega, 2);
	return sum/(c->k == c->m ? 6 : c->k == c->l || c->l == c->m ? 2 : 1);
}

static inline double *all_thirds(const struct hawser_modes *modes)
{
	double *T = malloc((size_t)KEPT*KEPT*modes->n*sizeof *T);

	for (int j = 0; T && j < KEPT; j++)
		for (int k = 0; k < KEPT; k++)
			for (int s = 0; s < modes->n; s++)
				T[(j*KEPT + k)*modes->n + s] = third(modes, j, k, s);
	return T;
}

/* Largest difference between condensed C and raw C minus the sum over modes, relative to the
 * largest entry. */
static inline double rest(const struct hawser_rom *condensed, const struct hawser_rom *raw,
                          const double *T, const struct hawser_modes *many, int upto)
{
	double worst = 0.0, largest = 0.0;

	for (int i = 0; i < raw->cubics; i++) {
		const struct hawser_cubic *c = &raw->C[i];
		double value = cubic_of(condensed, c->j, c->k, c->l, c->m);

		largest = fmax(largest, fabs(value));
		worst = fmax(worst, fabs(value - c->value + given_back(T, many, upto, c)));
	}
	return worst/largest;
}

/* The second-order displacement at mid-span as a sum over the same modes. */
static inline double rest_of_shape(const struct hawser_rom *condensed, const double *T,
                                   const struct hawser_modes *many)
{
	double worst = 0.0, largest = 0.0;

	for (int k = 0; k < KEPT; k++)
		for (int j = 0; j <= k; j++) {
			const double *w = condensed->shapes.second_shape +
			                  3*((size_t)(k*(k + 1)/2 + j)*condensed->shapes.points + 1);
			double sum[3] = {0.0}, shape[3];

			for (int s = KEPT; s < many->n; s++) {
				hawser_modes_at(many, shape, NULL, s, 0.5*many->statics.l);
				for (int c = 0; c < 3; c++)
					sum[c] -= T[(j*KEPT + k)*many->n + s]*shape[c]/
					          pow(many->mode[s].omega, 2);
			}
			for (int c = 0; c < 3; c++) {
				worst = fmax(worst, fabs(w[c] - sum[c]));
				largest = fmax(largest, fabs(w[c]));
			}
		}
	return worst/largest;
}

#endif

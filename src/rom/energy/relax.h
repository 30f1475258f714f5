/* rom/energy/relax.h - some coordinates of a model held, all others at the minimum of its
 * energy. relax.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_RELAX_H
#define HAWSER_ROM_RELAX_H

#include <hawser/rom.h>

#include "core/hold.h"

struct hawser__relax {
	const struct hawser_rom *rom; /* any kind of energy; owned by the caller */
	int N, frees;         /* coordinates; the relaxed ones */
	int *freed;           /* [frees] their indices, set by the caller; room for N */
	double *y;            /* [N] */
	double *R, *T;        /* [N], [N][N] restoring force and tangent of the last Newton step */
	double *step;         /* [frees] the last step */
	double *trial, *rest; /* [N] workspace; zeros */
	double *matrix;       /* [frees][frees] Cholesky factor, by columns */
	struct hawser__hold hold; /* its arrays */
};

/* Nothing is freed. Returns 1 if out of memory; _clear in any case. */
int hawser__relax_new(struct hawser__relax *relax, const struct hawser_rom *rom);
void hawser__relax_clear(struct hawser__relax *relax);

/* Minimise the energy over the relaxed coordinates, from relax->y on, which has the held ones. size > 0
 * is that of the motion; the last Newton step, which is not made, is 1e-9 of it or less. 0: no minimum
 * found. */
int hawser__relax(struct hawser__relax *relax, double size);

/* From a minimum that hawser__relax has found on: move coordinate `held` by du, and the relaxed ones
 * along the tangent of the minima. */
void hawser__relax_along(struct hawser__relax *relax, int held, double du);

/* The relaxed coordinates to second order in the held ones, which relax->y has: those that balance the
 * quadratic part of the force, each with its own stiffness (K is diagonal). */
void hawser__relax_place(struct hawser__relax *relax);

#endif

/* rom/condense/follow.h - static displacement of the condensed modes by a force, and the stiffness
 * that it adds to the kept modes.
 *
 *   p     the force, by its work: the integral of p.(a, b, c) over the cable on a displacement with the
 *         strains a, b, c
 *   z     the displacement with fixed ends, K-orthogonal to the kept modes, that minimises V2(z)
 *         minus that work
 *   T_jk  D^3V3[Phi_j, Phi_k, z], the stiffness that z adds
 *
 * With w_jk, the displacement of the same modes by a pair of kept ones (condense.h), T_jk is minus the
 * work of p on w_jk (Betti's reciprocal theorem). One z serves all pairs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_FOLLOW_H
#define HAWSER_ROM_FOLLOW_H

#include "core/hold.h"
#include "rom/condense/condense.h"
#include "rom/terms/ties.h"

/* Quadrature nodes, with the values of cable and modes there. */
struct hawser__stations {
	const struct hawser_modes *modes;
	int moving;                  /* number of kept modes, the first ones; shapes of inertia.h follow
	                              * them */
	int count, parts;            /* nodes, and parts into which they are grouped */
	double *edge;                /* [parts + 1] of the parts, of grid.order nodes each */
	double *s;                   /* [count] scaled arclength */
	struct hawser__place *place; /* [count] */
	double *slope;               /* [moving][count][3] a, b, c */
	double *p;                   /* [count][3] for the caller to fill, in the local frame */
	double *z;                   /* [count][3] strains of the displacement */
	double beyond[3];            /* of p: the whole load along x, y, z, for elastic supports */
	double start[3];             /* of z: displacement of end A along x, y, z */
	double load[HAWSER_ATTACH_MAX];   /* of p: forces on the strokes of absorbers; 0 on entry */
	double stroke[HAWSER_ATTACH_MAX]; /* of z */
	double stretch[HAWSER__TIE_SPRINGS]; /* of z: displacement of the springs along their axes */
	struct hawser__ties *ties; /* conditions at the ends and springs */
	struct hawser__bend *bend;       /* bending stiffness (bend.h), or NULL */
	struct hawser__hold hold; /* its arrays */
};

/* The nodes of the grid of the modes. Elements that contain a point of cut [cuts], ascending, are
 * divided there, for a p that is not smooth at these points; with bending stiffness also beside them,
 * where it makes layers. Clear *stations, on failure too. */
enum hawser_status hawser__stations_make(struct hawser__stations *stations,
                                         const struct hawser_modes *modes, int moving,
                                         const double *cut, int cuts, struct hawser_report *report);
void hawser__stations_clear(struct hawser__stations *stations);

/* p of harmonic h of the loads, scaled; the stations must be divided at their cuts.
 * condense_load.c. */
void hawser__load_pull(struct hawser__stations *stations, const struct hawser__loads *loads, int h);

/* p of a change of the travel speed, scaled: the force whose work on a displacement v is the
 * integral of v . x' (squared = 0) or of v' . x' (1), x the static shape. travel.c. */
void hawser__speed_pull(struct hawser__stations *stations, int squared);

/* Compute z from p. */
void hawser__follow(struct hawser__stations *stations);

/* T [n][n], n = modes->n: zero beyond the kept modes. Entries that vanish by symmetry but for
 * round-off are set to zero. Returns whether an entry is not zero. */
int hawser__follow_stiffness(double *T, const struct hawser__stations *stations);

#endif

/* rom/condense/condense.h - static condensation: displacement of all modes that are not kept under the
 * quadratic
 * forces of the kept ones.
 *
 * With the kept modes at u = sum_j u_j Phi_j, the static displacement of the others is
 * w = 1/2 sum_jk u_j u_k w_jk, where w_jk minimises V2(w) + 1/2 D^3V3[Phi_j, Phi_k, w] over all
 * displacements that are K-orthogonal to the kept modes. See condense.c and doc/theory-rom.md.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_CONDENSE_H
#define HAWSER_ROM_CONDENSE_H

#include <hawser/rom.h>
#include "rom/terms/load.h"

/* Pair (j, k), j <= k, has the index k(k+1)/2 + j. */
struct hawser__condensed {
	int n, points, pairs; /* n: the first n coordinates form the pairs */
	double *strain; /* [pairs][points][3] a, b, c of w_jk */
	double *start;  /* [pairs][3] of end A along x, y, z: 0 unless it is elastic */
	double *stroke; /* [pairs][attachments] of absorbers, or NULL */
	double *gram;   /* [pairs][pairs] second derivatives of V2 along w_x and w_y */
};

/* Pairs of the first `moving` modes; w is K-orthogonal to all of `modes`. */
enum hawser_status hawser__condense(struct hawser__condensed *condensed,
                                    const struct hawser_modes *modes, int moving,
                                    struct hawser_report *report);
void hawser__condensed_clear(struct hawser__condensed *condensed);

/* Derivative of the displacement in global axes at the points of the grid, [3][points]. */
void hawser__global_slopes(double *global, const struct hawser_modes *modes, const double *strain);

/* Displacement P, Q, B and strains a, b, c of all w_jk at scaled arclength s: shape and slope are
 * [pairs][3], `stride` doubles from one pair to the next. */
enum hawser_status hawser__condensed_at(const struct hawser__condensed *condensed,
                                        const struct hawser_modes *modes, double *shape,
                                        double *slope, int stride, double s,
                                        struct hawser_report *report);

/* T [n][n] of follow.h, n = modes->n, for harmonic h of the loads, scaled, and whether any entry is not
 * zero. condense_load.c. */
enum hawser_status hawser__follow_load(double *T, int *any, const struct hawser_modes *modes,
                                       int moving, const struct hawser__loads *loads, int h,
                                       struct hawser_report *report);

/* Strains [points of the grid][3] of the static response of the condensed modes to harmonic h of the
 * loads. condense_load.c. */
enum hawser_status hawser__follow_strains(double *strain, const struct hawser_modes *modes, int moving,
                                          const struct hawser__loads *loads, int h,
                                          struct hawser_report *report);

/* --- the condition that both ends are fixed --- */

/* The cable at a quadrature node. */
struct hawser__place {
	double weight, eps, k, g2; /* eps = H/EA; k geometric stiffness; g2 = |x'|^2 */
	double ex, ey;             /* tangent, in axes along and across the chord */
	int space;                 /* 1: `axis` takes the place of ex and ey (condense_space.c) */
	double axis[3][3];         /* e, n and the normal of the piece, in these axes and z' */
};
struct hawser__place hawser__place_at(const struct hawser_modes *modes, double s, double weight);

/* Compliance against the force at the ends, summed over the nodes: lambda solves it for r. */
struct hawser__ties {
	double m[3]; /* in the plane: along-along, along-across, across-across the chord */
	double mz;
	int space;
	double M[3][3]; /* in space, in the place of m and mz */
};
void hawser__ties_add(struct hawser__ties *ties, const struct hawser__place *at);
void hawser__ties_solve(double lambda[3], const struct hawser__ties *ties, const double r[3]);

/* Of a cable in space (condense_space.c). r [3] += factor times the vector with the local components
 * q [3]; component k of lambda in the local frame. */
struct hawser__place hawser__space_place(const struct hawser_modes *modes,
                                         const struct hawser_frame_point *at, double weight);
void hawser__space_ties_add(struct hawser__ties *ties, const struct hawser__place *at);
void hawser__space_ties_solve(double lambda[3], const struct hawser__ties *ties, const double r[3]);
void hawser__space_reach(double r[3], const struct hawser__place *at, const double q[3],
                         double factor);
double hawser__space_along(const struct hawser__place *at, const double lambda[3], int k);

#endif

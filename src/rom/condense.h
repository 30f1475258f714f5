/* rom/condense.h - the static answer of every mode that is not kept, to the quadratic forces of those
 * that are.
 *
 * With the kept modes moving as u = sum_j u_j Phi_j, the others follow statically as
 * w = 1/2 sum_jk u_j u_k w_jk, where w_jk minimises V2(w) + 1/2 D^3V3[Phi_j, Phi_k, w] over all
 * displacements that are K-orthogonal to the kept modes. See condense.c and doc/theory-rom.md.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_CONDENSE_H
#define HAWSER_ROM_CONDENSE_H

#include <hawser/rom.h>

/* Pairs (j, k), j <= k, stand at k(k+1)/2 + j. */
struct hawser__condensed {
	int n, points, pairs; /* n: coordinates of which there are pairs, the first ones */
	double *strain; /* [pairs][points][3] a, b, c of w_jk */
	double *gram;   /* [pairs][pairs] second derivatives of V2 along w_x and w_y */
};

/* Pairs of the first `moving` modes; w is K-orthogonal to all of `modes`. */
enum hawser_status hawser__condense(struct hawser__condensed *condensed,
                                    const struct hawser_modes *modes, int moving,
                                    struct hawser_report *report);
void hawser__condensed_clear(struct hawser__condensed *condensed);

/* Displacement P, Q, B and strains a, b, c of all w_jk at scaled arclength s: shape and slope are
 * [pairs][3], `stride` doubles from one pair to the next. */
enum hawser_status hawser__condensed_at(const struct hawser__condensed *condensed,
                                        const struct hawser_modes *modes, double *shape,
                                        double *slope, int stride, double s,
                                        struct hawser_report *report);

/* force [pairs] = integral of load.w_jk over the loaded part, in the units of scene and of s: what
 * the load does to coordinate j, times u_k. condense_load.c. */
enum hawser_status hawser__condensed_load(const struct hawser__condensed *condensed, double *force,
                                          const struct hawser_modes *modes,
                                          const struct hawser_scene *scene,
                                          struct hawser_report *report);

#endif

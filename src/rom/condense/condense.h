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
#include "modes/grid.h"
#include "rom/terms/load.h"

/* Pair (j, k), j <= k, has the index k(k+1)/2 + j. */
struct hawser__condensed {
	int n, points, pairs; /* n: the first n coordinates form the pairs */
	double *strain; /* [pairs][points][3] a, b, c of w_jk */
	double *start;  /* [pairs][3] of end A along x, y, z: 0 unless it is elastic */
	double *stroke; /* [pairs][attachments] of absorbers, or NULL */
	double *pairing; /* [pairs][pairs] what one way to pair four indices gives of the fourth
	                  * derivative of the energy (modes/pairing.h): that of V4, minus the second
	                  * derivatives of V2 along w_x and w_y */
};

/* Pairs of the first `moving` modes; w is K-orthogonal to all of `modes`. */
enum hawser_status hawser__condense(struct hawser__condensed *condensed,
                                    const struct hawser_modes *modes, int moving,
                                    struct hawser_report *report);
void hawser__condensed_clear(struct hawser__condensed *condensed);

/* along [3][points] along the axes of the cable, at the points of the grid: the displacement of strains
 * [points][3] and of end A. work [3][points]. */
void hawser__displacement(double *along, const struct hawser_grid *grid,
                          const struct hawser__reference *reference, const struct hawser_statics *st,
                          const double *strain, const double start[3], double *work);

/* P, Q, B (in space x, y, z) at shape point p of a displacement along [3][points of the grid], and of
 * the strokes [attachments] of absorbers, NULL: they are 0. */
void hawser__displaced_at(double u[3], const struct hawser_rom *rom, const struct hawser_statics *st,
                          const struct hawser_grid *grid, const double *along, const double *stroke,
                          int p);

/* Displacement and strains of `pairs` w_jk, from number `first` on, at the shape points of a model,
 * [pairs][points][3], and strains along its line, [pairs][line points][3]. */
enum hawser_status hawser__condensed_second(double *shape, double *slope, double *line,
                                            const struct hawser_rom *rom,
                                            const struct hawser__condensed *condensed,
                                            const struct hawser_modes *modes, int first, int pairs,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* The cable at a quadrature node. */
struct hawser__place {
	double weight, eps, k, g2; /* eps = H/EA; k geometric stiffness; g2 = |x'|^2 */
	double axis[3][3];         /* e, n and the normal of the plane of the piece, in axes along and
	                            * across the chord and z */
};
struct hawser__place hawser__place_at(const struct hawser_modes *modes, double s, double weight);

#endif

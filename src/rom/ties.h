/* rom/ties.h - springs of attachments in the static response of the condensed modes: see ties.c.
 *
 * Call hawser__springs_make, _add_place for every quadrature node, _factor. For every load: zero z,
 * _load at every node, _solve; then _force at every node gives F, to be subtracted from the strains
 * times the compliance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_TIES_H
#define HAWSER_ROM_TIES_H

#include "rom/condense.h"

enum { HAWSER__TIES = 3 + 3*HAWSER_ATTACH_MAX };

struct hawser__tie_spring {
	double s, k, h[3]; /* scaled place and stiffness; axis along, across the chord and along z */
	int attachment, axis;
};
struct hawser__springs {
	int size;          /* 3 + number of springs */
	int failed;        /* 1: A is not positive definite */
	struct hawser__tie_spring spring[3*HAWSER_ATTACH_MAX];
	double A[HAWSER__TIES*HAWSER__TIES], z[HAWSER__TIES];
};
/* *made is NULL if there are no springs; else free it. */
enum hawser_status hawser__springs_make(struct hawser__springs **made, const struct hawser_modes *modes,
                                        struct hawser_report *report);
void hawser__springs_add_place(struct hawser__springs *springs, const struct hawser__place *at,
                               double s);
void hawser__springs_factor(struct hawser__springs *springs);
/* Add strains x[3] without F to z, the right-hand side. */
void hawser__springs_load(struct hawser__springs *springs, const struct hawser__place *at, double s,
                          const double x[3]);
void hawser__springs_solve(struct hawser__springs *springs);
/* F along e, n and z. */
void hawser__springs_force(double f[3], const struct hawser__springs *springs,
                           const struct hawser__place *at, double s);
/* Displacement of spring m along its axis. */
double hawser__springs_stretch(const struct hawser__springs *springs, int m);

#endif

/* rom/ties.h - springs of attachments and of elastic supports in the static response of the condensed
 * modes: see ties.c.
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
	int attachment, axis; /* number of the point (hawser__point), axis x, y or z */
};
struct hawser__springs {
	int size;          /* 3 + number of springs of attachments */
	int joints;        /* springs of elastic supports, behind the others in `spring` */
	int ends;          /* number of the point of end A: the number of attachments */
	int failed;        /* 1: A is not positive definite */
	struct hawser__tie_spring spring[3*HAWSER_ATTACH_MAX + 6];
	double A[HAWSER__TIES*HAWSER__TIES], z[HAWSER__TIES];
	double beyond[3];  /* all of the load along x, y, z, whose integral from end A the strains have */
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
/* Displacement of spring m along its axis, joints included. */
double hawser__springs_stretch(const struct hawser__springs *springs, int m);
/* Displacement of end A along x, y, z, of all stretches: those of its joints. */
void hawser__springs_start(double u[3], const struct hawser__springs *springs, const double *stretch);

#endif

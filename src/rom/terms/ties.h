/* rom/terms/ties.h - springs of attachments and of elastic supports in the static response of the
 * condensed modes: see ties.c.
 *
 * Call hawser__springs_make, _assemble. For every load: zero z, _load at every node, _solve; then
 * _release subtracts from the strains what the force F answers.
 * A cable with bending stiffness is treated in this way without springs too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_TIES_H
#define HAWSER_ROM_TIES_H

#include "rom/condense/bend.h"
#include "rom/condense/condense.h"

enum { HAWSER__TIES = 3 + 3*HAWSER_ATTACH_MAX };

struct hawser__tie_spring {
	double s, k, h[3]; /* scaled place and stiffness; direction along, across the chord and along z */
	double way[3];     /* direction along the axes of the cable */
	int attachment;    /* number of the point (hawser__point) */
};
struct hawser__springs {
	int size;          /* 3 + number of springs of attachments */
	int joints;        /* springs of elastic supports, behind the others in `spring` */
	int ends;          /* number of the point of end A: the number of attachments */
	int failed;        /* 1: A is not positive definite */
	double *field;     /* [count][3] work space of hawser__springs_release */
	struct hawser__tie_spring spring[3*HAWSER_ATTACH_MAX + 6];
	double A[HAWSER__TIES*HAWSER__TIES], z[HAWSER__TIES];
	double beyond[3];  /* all of the load along the axes of the cable, of which the strains have the
	                    * integral from end A */
};
/* *made is NULL if there are no springs and no bending stiffness; else hawser__springs_free it. */
void hawser__springs_free(struct hawser__springs *springs);
enum hawser_status hawser__springs_make(struct hawser__springs **made, const struct hawser_modes *modes,
                                        struct hawser_report *report);
/* The matrix, from `count` nodes at s, factored. bend: of the same nodes, or NULL. Status: _MEMORY. */
enum hawser_status hawser__springs_assemble(struct hawser__springs *springs,
                                            const struct hawser__bend *bend,
                                            const struct hawser__place *place, const double *s,
                                            int count, struct hawser_report *report);
/* Add strains x[3] without F to z, the right-hand side. */
void hawser__springs_load(struct hawser__springs *springs, const struct hawser__place *at, double s,
                          const double x[3]);
void hawser__springs_solve(struct hawser__springs *springs);
/* Subtract from strains x [count][3] those of F. */
void hawser__springs_release(double *x, struct hawser__springs *springs,
                             const struct hawser__bend *bend, const struct hawser__place *place,
                             const double *s, int count);
/* Displacement of spring m along its axis, joints included. */
double hawser__springs_stretch(const struct hawser__springs *springs, int m);
/* Displacement of end A along the axes of the cable, of all stretches: those of its joints. */
void hawser__springs_start(double u[3], const struct hawser__springs *springs, const double *stretch);

#endif

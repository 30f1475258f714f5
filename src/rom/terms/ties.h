/* rom/terms/ties.h - the static response of a cable whose ends are held, with the springs of
 * attachments and of elastic supports: see ties.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_TIES_H
#define HAWSER_ROM_TIES_H

#include "rom/condense/bend.h"
#include "rom/condense/condense.h"

enum { HAWSER__TIES = 3 + 3*HAWSER_ATTACH_MAX, HAWSER__TIE_SPRINGS = 3*HAWSER_ATTACH_MAX + 6 };

struct hawser__tie_spring {
	double s, k, h[3]; /* scaled place and stiffness; direction along, across the chord and along z */
	double way[3];     /* direction along the axes of the cable */
	int attachment;    /* number of the point (hawser__point) */
};
struct hawser__ties {
	int size;          /* 3 + number of springs of attachments */
	int joints;        /* springs of elastic supports, behind the others in `spring` */
	int ends;          /* number of the point of end A: the number of attachments */
	int failed;        /* 1: A is not positive definite */
	int count;         /* nodes; of the caller are */
	const double *s;   /* [count] their places, */
	const struct hawser__place *place; /* [count] the cable there, */
	const struct hawser__bend *bend;   /* and its bending stiffness, or NULL */
	double *field;     /* [count][3] work space */
	struct hawser__tie_spring spring[HAWSER__TIE_SPRINGS];
	double A[HAWSER__TIES*HAWSER__TIES], z[HAWSER__TIES];
	double beyond[3];  /* all of the load along the axes of the cable, of which the forces have the
	                    * integral from end A */
};
/* The matrix, from `count` nodes, factored. hawser__ties_free it. Status: _MEMORY. */
enum hawser_status hawser__ties_make(struct hawser__ties **made, const struct hawser_modes *modes,
                                     const struct hawser__bend *bend,
                                     const struct hawser__place *place, const double *s, int count,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__ties_free(struct hawser__ties *ties);
static inline int hawser__ties_springs(const struct hawser__ties *ties)
{
	return ties->size - 3 + ties->joints;
}

/* Replace forces x [count][3] against the strains by the strains that answer them, with `beyond`. */
void hawser__ties_answer(struct hawser__ties *ties, double *x);
/* z = A^-1 z; and subtract from x [count][3] the strains of F then. */
void hawser__ties_solve(struct hawser__ties *ties);
void hawser__ties_settle(struct hawser__ties *ties, double *x);
/* Then: displacement of spring m along its axis, joints included. */
double hawser__ties_stretch(const struct hawser__ties *ties, int m);
/* Displacement of end A along the axes of the cable, of all stretches: those of its joints. */
void hawser__ties_start(double u[3], const struct hawser__ties *ties, const double *stretch);

#endif

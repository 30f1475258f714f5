/* ropeway/modes/segment.h - force, strain and displacement along one piece of rope.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_SEGMENT_H
#define HAWSER_ROPEWAY_SEGMENT_H

#include "ropeway/modes/modes.h"

/* out [D][points]: the derivative of the displacement, C F, and the strains, of the force F. */
void hawser__segment_gradient(double *out, const double *F, const struct hawser__lmode_segment *s);
void hawser__segment_strains(double *out, const double *F, const struct hawser__lmode_segment *s);
/* The force F with the ground's part: F += the integral of k X. Returns that over the whole length.
 * work [2][points] */
double hawser__segment_ground(double *F, const double *X, const struct hawser__lmode_segment *s,
                              double *work);
/* The part of the load in the end's displacement x[D] and force f[D], without displacement and force at
 * the beginning; F [D][points] keeps the force. work [6][points] */
void hawser__segment_load(double *x, double *f, double *F, const double *load,
                          const struct hawser__lmode_segment *s, double *work);
/* P of a segment without ground, and with. work [6][points] */
void hawser__segment_free(struct hawser__lmode_segment *s, double *work);
enum hawser_status hawser__segment_on_ground(struct hawser__lmode_segment *s, double *work,
                                             struct hawser_report *report);

/* Displacement of an end by value `dof` of its node, component c; -1: by a unit of border `border`. */
static inline double hawser__segment_reach(const struct hawser__lmode_system *t,
                                           const struct hawser__lmode_segment *s,
                    int end,
                    int c, int dof, int border)
{
	return border >= 0 ? s->border[(end*2 + c)*t->borders + border] : s->map[end][c][dof];
}

static inline int hawser__segment_dofs(const struct hawser__lmode_system *t,
                                       const struct hawser__lmode_segment *s, int end)
{
	return s->node[end] >= 0 ? t->node[s->node[end]].dofs : 0;
}

/* modes_equations.c: the band of the factors, for LAPACK. */
enum { HAWSER__BAND = 3, HAWSER__FACTOR_ROWS = 3*HAWSER__BAND + 1, HAWSER__SEGMENT_FIELDS = 6 };
/* What the rope pulls at border b: E0' F0 - E1' F(end), where F(end) = P10 X0 + P11 F0 + f. X0 is by
 * the unknowns and by the border values w, f [segments][2] by the load; each may be NULL. */
double hawser__lmode_pull(const struct hawser__lmode_system *t, int b, const double *unknown,
                          const double *w,
                   const double (*f)[2]);
/* modes_static.c: the motion of the held loop by a force along v, and its inertia; -1 without
 * memory. */
int hawser__lmode_circulation(struct hawser__lmode_system *t, const double *v);

#endif

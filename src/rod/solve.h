/* rod/solve.h - statics of a mesh. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROD_SOLVE_H
#define HAWSER_ROD_SOLVE_H

#include "rod/mesh.h"

/* What a solution took. */
struct hawser__rod_effort {
	int steps, iterations, flow; /* flow: 1, by damped motion */
	double increment;            /* the last one */
	double jump, other;          /* see struct hawser_rod_statics */
	int bent;                    /* element that turned by pi or more when it failed last; -1: none */
};

/* Find the equilibrium under full load, each load times factor [loads] (NULL: 1), from the state,
 * which is one with none (`start` 0) or near that with full load (1). The last increment is at most
 * `tolerance`. */
enum hawser_status hawser__rod_equilibrium(struct hawser__rod_mesh *mesh,
                                           struct hawser__rod_effort *effort, int start, int steps,
                                           const double *factors, double tolerance,
                                           struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* The equilibrium under the full load, which is set, by a damped motion from rest; 1: found. */
int hawser__rod_flow(struct hawser__rod_mesh *mesh, struct hawser__rod_effort *effort,
                     double tolerance);
/* statics.c: whether the loads have a potential. */
int hawser__rod_potential(const struct hawser_rod *rod);

/* points.c: the state as points, the forces of the supports; *st's point is allocated. */
enum hawser_status hawser__rod_points(struct hawser_rod_statics *st, struct hawser__rod_mesh *mesh,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

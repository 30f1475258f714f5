/* modes/halving.h - the part common to the finite-difference schemes: grids and error estimate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_HALVING_H
#define HAWSER_MODES_HALVING_H

#include <hawser/modes.h>

#include "modes/krylov.h"

/* A second-order scheme on N equal intervals of [0, l]. */
struct hawser__scheme {
	int displacements; /* 1: their differences are divided by epsilon */
	/* Compute the `count` largest 1/omega^2 of a plane, with eigenvectors. */
	enum hawser_status (*solve)(struct hawser__ritz *ritz, const struct hawser_statics *statics,
	                            enum hawser_plane plane, int N, int count,
	                            struct hawser_report *report);
	/* Compute shape and slope, [points][3] each and zero on entry, from the eigenvector x. */
	enum hawser_status (*sample)(double *shape, double *slope, const struct hawser_grid *grid,
	                             const double *x, const struct hawser_statics *statics,
	                             enum hawser_plane plane, int N, struct hawser_report *report);
};

enum hawser_status hawser__halving_solve(struct hawser_modes *modes,
                                         const struct hawser_statics *statics,
                                         const struct hawser_modes_options *options,
                                         const struct hawser__scheme *scheme,
                                         struct hawser_report *report);

/* 1 if a grid of M intervals does not resolve the profile or, for a scheme in displacements, the
 * stretch. Its lowest modes may then differ from the lowest modes of the cable. */
int hawser__unresolved(const struct hawser_statics *st, int M, int displacements);

/* Interpolate value[0..last], `stride` apart, at t (in intervals from the first point) by the
 * polynomial through the nearest six points, or all points if there are fewer. *derivative is per
 * interval. */
double hawser__six_points(double *derivative, const double *value, int last, int stride, double t);

#endif

/* modes/halving.h - finite-difference schemes: what is common to them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_HALVING_H
#define HAWSER_MODES_HALVING_H

#include <hawser/modes.h>

#include "modes/krylov.h"

/* A second-order scheme on N equal intervals of [0, l]. */
struct hawser__scheme {
	int displacements; /* 1: their differences are divided by epsilon */
	/* The `count` largest 1/omega^2 of a plane, with vectors. */
	enum hawser_status (*solve)(struct hawser__ritz *ritz, const struct hawser_statics *statics,
	                            enum hawser_plane plane, int N, int count,
	                            struct hawser_report *report);
	/* Shape and slope, [points][3] each and zero before, of the vector x[size of the scheme]. */
	enum hawser_status (*sample)(double *shape, double *slope, const struct hawser_grid *grid,
	                             const double *x, const struct hawser_statics *statics,
	                             enum hawser_plane plane, int N, struct hawser_report *report);
};

enum hawser_status hawser__halving_solve(struct hawser_modes *modes,
                                         const struct hawser_statics *statics,
                                         const struct hawser_modes_options *options,
                                         const struct hawser__scheme *scheme,
                                         struct hawser_report *report);

/* Does a grid of M intervals not see the profile; or, of a scheme of displacements, the stretch? Then
 * its lowest modes need not be the cable's lowest ones. */
int hawser__unseen(const struct hawser_statics *st, int M, int displacements);

/* Value and derivative at t (in intervals from the first point) of the polynomial through the six
 * points nearest to t of value[0..last] (fewer where there are fewer), `stride` apart. *derivative
 * is per interval. */
double hawser__six_points(double *derivative, const double *value, int last, int stride, double t);

#endif

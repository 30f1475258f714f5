/* modes/halving.h - the part common to the finite-difference schemes: grids and error estimate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_HALVING_H
#define HAWSER_MODES_HALVING_H

#include <hawser/modes.h>
#include <hawser/status.h>

/* --- krylov.c: the largest eigenvalues of an operator given by its product with a vector --- */

/* y[size] = A x[size]. */
struct hawser__operator {
	int size;
	void (*apply)(double *y, const double *x, void *context);
	void *context;
	int symmetric;
};

/* `count` eigenvalues by descending real part. A complex pair occupies two neighbours, whose
 * vectors are the real and the imaginary part of the eigenvector. */
struct hawser__ritz {
	int count, size;
	double *re, *im; /* [count] */
	double *miss;    /* [count] relative residual: norm of (A - theta) x over that of theta x */
	double *x;       /* [count][size] unit vectors */
};

/* count is reduced to the size of the operator if it is larger. Pairs that have not converged have
 * a large `miss`; the status does not report them. Statuses: _MEMORY, _NAN. */
enum hawser_status hawser__krylov(struct hawser__ritz *ritz, const struct hawser__operator *A,
                                  int count, struct hawser_report *report);
void hawser__ritz_clear(struct hawser__ritz *ritz);

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

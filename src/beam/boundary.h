/* beam/boundary.h - the equations of a stability boundary (minimally augmented systems).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_BOUNDARY_H
#define HAWSER_BEAM_BOUNDARY_H

#include <complex.h>

#include "beam/sample.h"

enum hawser__onset {
	HAWSER__STATIC = 0, /* divergence, l = 0:  g(v, p) = 0 */
	HAWSER__AXIS,       /* flutter, l = i w:   Re g = Im g = 0 in (v, p, w) */
	HAWSER__DOUBLE      /* double real l = w:  g = dg/dl = 0 in (v, p, w) */
};

/* Unknowns u: parameter, speed and w, each divided by its entry of scale. */
struct hawser__onset_equation {
	enum hawser__onset onset;
	const struct hawser_beam_integrals *is;
	const struct hawser_beam_family *family;
	double scale[3];
	int n, unknowns;           /* 2 or 3 */
	double *M;                 /* [3][n][n] M, C, K */
	double complex *A;         /* [n + 1][n + 1] column-major */
	double complex *b, *c;     /* [n] borders: left and right null vectors of the previous point */
	double complex *x, *y;     /* [n + 1] solutions of the bordered and of the adjoint system */
	int *pivot;
};

enum hawser_status hawser__onset_open(struct hawser__onset_equation *equation,
                                      enum hawser__onset onset,
                                      const struct hawser_beam_integrals *integrals,
                                      const struct hawser_beam_family *family,
                                      struct hawser_report *report);
void hawser__onset_clear(struct hawser__onset_equation *equation);

/* Set the borders to the eigenvectors of the eigenvalue of the sample that is nearest to l. */
void hawser__onset_border(struct hawser__onset_equation *equation,
                          const struct hawser__beam_sample *sample, double complex l);

/* Newton's iteration from u on the residuals and the constraint normal . (u - start) = 0, where
 * start is the given u. *iterations is the number of iterations. On success the borders are
 * updated. HAWSER_ERR_CONVERGENCE. */
enum hawser_status hawser__onset_correct(struct hawser__onset_equation *equation, double *u,
                                         const double *normal, int *iterations,
                                         struct hawser_report *report);
/* Unit tangent at u. */
enum hawser_status hawser__onset_tangent(struct hawser__onset_equation *equation, double *tangent,
                                         const double *u, struct hawser_report *report);

/* --- boundary_follow.c: continuation of one piece of a stability boundary --- */

struct hawser__boundary_work {
	struct hawser_beam_boundary *boundary;
	const struct hawser_beam_integrals *is;
	const struct hawser_beam_family *family;
	const struct hawser_beam_boundary_options *options;
	struct hawser__onset_equation equation;
	double range, longest; /* width of the parameter range; longest relative step */
	double low, high; /* parameter range of the current piece */
	int most;         /* largest number of points */
};

/* Why a piece ends. */
enum hawser__boundary_end {
	HAWSER__GOES_ON = 0, /* it does not end here */
	HAWSER__RANGE_ENDS,  /* end of the parameter range */
	HAWSER__SPEED_ENDS,  /* speed 0 */
	HAWSER__PIECE_LOST,  /* the corrector failed at the smallest step */
	HAWSER__OVERTAKEN    /* another mode becomes unstable at a lower speed */
};

/* Unit vectors of the parameter and of the speed. */
extern const double hawser__along_parameter[3], hawser__along_speed[3];

/* Append a point. HAWSER_ERR_CONVERGENCE if the boundary already has work->most points. */
enum hawser_status hawser__boundary_keep(struct hawser__boundary_work *work,
                                         const struct hawser_beam_boundary_point *point,
                                         struct hawser_report *report);

/* The point at u. *good is 1 if no mode grows just below it and at least one grows just above. */
enum hawser_status hawser__boundary_point(struct hawser_beam_boundary_point *point, int *good,
                                          struct hawser__boundary_work *work, const double *u,
                                          struct hawser_report *report);

/* Follow the boundary from the point `start`. The parameter first increases (sign 1) or decreases
 * (sign -1). Points are appended in the order of the continuation. *reached is the last parameter
 * at which the piece is known. */
enum hawser_status hawser__boundary_follow(enum hawser__boundary_end *end, double *reached,
                                           struct hawser__boundary_work *work, const double *start,
                                           double sign, struct hawser_report *report);

#endif

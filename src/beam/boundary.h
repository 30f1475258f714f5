/* beam/boundary.h - one equation whose zeros are a boundary of stability.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BEAM_BOUNDARY_H
#define HAWSER_BEAM_BOUNDARY_H

#include <complex.h>

#include "beam/stop.h"

enum hawser__onset {
	HAWSER__STATIC = 0, /* l = 0:   one equation, g(v, p) = 0 */
	HAWSER__AXIS,       /* l = i w: two, Re g and Im g of (v, p, w) */
	HAWSER__DOUBLE      /* l = w:   two, g and dg/dl of (v, p, w) */
};

/* Unknowns in u: parameter and speed in units of their scales, w in units of its own. */
struct hawser__onset_equation {
	enum hawser__onset onset;
	const struct hawser_beam_integrals *is;
	const struct hawser_beam_family *family;
	double scale[3];
	int n, unknowns;           /* 2 or 3 */
	double *M;                 /* [3][n][n] M, C, K */
	double complex *A;         /* [n + 1][n + 1] column-major */
	double complex *b, *c;     /* [n] borders: left and right null vectors of a point before */
	double complex *x, *y;     /* [n + 1] solutions */
	int *pivot;
};

enum hawser_status hawser__onset_open(struct hawser__onset_equation *equation,
                                      enum hawser__onset onset,
                                      const struct hawser_beam_integrals *integrals,
                                      const struct hawser_beam_family *family,
                                      struct hawser_report *report);
void hawser__onset_clear(struct hawser__onset_equation *equation);

/* Borders from the eigenvalue of a stop that is nearest to l. */
void hawser__onset_border(struct hawser__onset_equation *equation,
                          const struct hawser__beam_stop *stop, double complex l);

/* Newton from u on the residuals and one more row: normal . (u - start) = 0. *iterations and *distance
 * of the first step tell how it went. HAWSER_ERR_CONVERGENCE. On success the borders are renewed. */
enum hawser_status hawser__onset_correct(struct hawser__onset_equation *equation, double *u,
                                         const double *normal, int *iterations,
                                         struct hawser_report *report);
/* Unit tangent at u. */
enum hawser_status hawser__onset_tangent(struct hawser__onset_equation *equation, double *tangent,
                                         const double *u, struct hawser_report *report);

#endif

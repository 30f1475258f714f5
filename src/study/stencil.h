/* study/stencil.h - the top of a function that is known at a few points, with its error: see stencil.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_STENCIL_H
#define HAWSER_STUDY_STENCIL_H

enum { HAWSER__STENCIL = 5 }; /* points of a polynomial */
enum { HAWSER__REACH = 4 };   /* points on either side of the middle one that the error looks at */

/* Points (t, y) about a top of y, where z is wanted too. */
struct hawser__stencils {
	int count, centre; /* points, and the first of the five in the middle */
	double t[2*HAWSER__REACH + 1], y[2*HAWSER__REACH + 1], z[2*HAWSER__REACH + 1];
	double bounds[2];  /* in t, of the top */
	/* results */
	double top, y_top, z_top;
	double y_change, z_change; /* relative, to polynomials through four and to others through five */
};

/* The top by the polynomial through five points, and how much it changes with other points. 1: one of
 * the polynomials has no top between the bounds. */
int hawser__stencil_top(struct hawser__stencils *at);

/* By how much an error of y, of its own unit, moves z at the top that was found. */
double hawser__stencil_moved(const struct hawser__stencils *at, double error);

#endif

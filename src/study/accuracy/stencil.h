/* study/accuracy/stencil.h - the maximum of a function that is known at a few points, with its
 * error: see stencil.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_STENCIL_H
#define HAWSER_STUDY_STENCIL_H

enum { HAWSER__STENCIL = 5 }; /* points of a polynomial */
enum { HAWSER__REACH = 4 };   /* number of points on either side of the middle one that the error
                               * estimate uses */

/* Points (t, y) about a maximum of y, where z is evaluated too. */
struct hawser__stencils {
	int count, centre; /* number of points, and index of the first of the five in the middle */
	double t[2*HAWSER__REACH + 1], y[2*HAWSER__REACH + 1], z[2*HAWSER__REACH + 1];
	double bounds[2];  /* range of t for the maximum */
	/* results */
	double top, y_top, z_top;
	double y_change, z_change; /* relative differences from polynomials through four and through
	                            * other five points */
};

/* The maximum by the polynomial through five points, and its change with other points. Returns 1 if
 * one of the polynomials has no maximum within the bounds. */
int hawser__stencil_top(struct hawser__stencils *at);

/* Change of z at the maximum by an error of y, in the unit of y. */
double hawser__stencil_moved(const struct hawser__stencils *at, double error);

#endif

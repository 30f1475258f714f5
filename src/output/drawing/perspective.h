/* output/drawing/perspective.h - nets seen in perspective: the eye, and equal scales on both axes.
 *
 * The eye looks at the middle of a box from above and from one side, from a distance of some times
 * its size. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PERSPECTIVE_H
#define HAWSER_OUTPUT_PERSPECTIVE_H

#include <stdio.h>

/* A box in space, or (k < 2) on the picture. */
struct hawser__box {
	double low[3], high[3];
	int any; /* 0: nothing in it yet */
};
void hawser__box_add(struct hawser__box *box, const double *x, int size); /* x [size], size 2 or 3 */

struct hawser__eye {
	double middle[3], size, azimuth, elevation; /* m; rad, about the vertical and above the horizon */
};
/* What the box is of: */
enum hawser__view_of {
	HAWSER__IN_SPACE, /* anything: from above and one side; a plane z = constant from the front */
	HAWSER__ASLANT    /* a plane, and what moves across it: `normal` is turned away from the eye */
};
void hawser__eye_look(struct hawser__eye *eye, const struct hawser__box *box,
                      enum hawser__view_of of, const double normal[3] /* or NULL */);
void hawser__eye_see(double to[2], const struct hawser__eye *eye, const double x[3]);

/* Set both ranges so that the box fits a panel of that size (cm), with the same scale along both. */
void hawser__eye_fit(FILE *script, const struct hawser__box *seen, double width_cm, double height_cm);
/* A place in a picture of that size, cm from its lower left corner. */
struct hawser__corner {
	double x, y, width, height;
};
/* Short arrows along x, y and z from there, with their names, with the next plot. */
void hawser__eye_axes(FILE *script, const struct hawser__eye *eye, const struct hawser__corner *at);

#endif

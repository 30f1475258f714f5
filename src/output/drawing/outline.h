/* output/drawing/outline.h - outlines of obstacles, as they are seen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_OUTLINE_H
#define HAWSER_OUTPUT_OUTLINE_H

#include <stdio.h>

#include <hawser/surface.h>

#include "output/drawing/figure.h"

/* Puts places into a figure, or into the data of a script, or (both are NULL) adds them to `seen`. */
struct hawser__pen {
	struct hawser__figure *figure;
	FILE *script;
	struct hawser__box *seen;
	const struct hawser__eye *eye;
	double shift[2]; /* m: added to what the eye sees */
};
void hawser__pen_put(const struct hawser__pen *pen, const double x[3]);
/* The outline within the box of the net; a line is ended by an empty one. */
void hawser__pen_surface(const struct hawser__pen *pen, const struct hawser_surface *of,
                         const struct hawser__box *box);

#endif

/* output/drawing/labels.h - numbers beside the points of a panel that overlap neither each other nor a
 * line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_LABELS_H
#define HAWSER_OUTPUT_LABELS_H

#include <stdio.h>

#include <hawser/surface.h>

#include "output/drawing/figure.h"

/* The axes of a panel, and the rectangles in it that are occupied. */
struct hawser__labels {
	double panel[4];        /* left, bottom, right, top (cm) */
	double low[2], high[2]; /* ranges of both axes */
	int logarithmic[2];
	int boxes, labels;
	double box[1024][4];    /* left, bottom, right, top (cm) */
};

/* Range of an axis that shows low to high with a margin; low and high may be equal. */
void hawser__labels_range(struct hawser__labels *labels, int axis, double low, double high,
                          int logarithmic);
/* Open the panel with these ranges; to be called after both are set. No labels yet. */
void hawser__labels_panel(struct hawser__labels *labels, struct hawser__figure *figure,
                          const struct hawser__panel_frame *at);
/* Mark the symbol of a point, or the line from `from` to `to` (x, y), as occupied. */
void hawser__labels_symbol(struct hawser__labels *labels, double x, double y);
void hawser__labels_line(struct hawser__labels *labels, const double from[2], const double to[2]);
/* Place the number beside the point, in the colour of that line type, if there is space. */
void hawser__labels_put(struct hawser__labels *labels, struct hawser__picture *picture, double x,
                        double y, int number, int colour);

/* --- outline.c: outlines of obstacles, as they are seen --- */

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

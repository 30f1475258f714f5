/* output/drawing/panels.h - layout of pictures with one panel per mode, in rows of up to three.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PANELS_H
#define HAWSER_OUTPUT_PANELS_H

#include "output/drawing/figure.h"

enum { HAWSER__PANELS = 12 }; /* at most */

/* Position of panel k. */
struct hawser__panels {
	int panels, columns, rows;
	double height, bottom, top, left, width, tall;
};
struct hawser__panels hawser__panels_arrange(int modes);
/* Open panel k. Numbers stand below the lowest panels and left of the first column; the title of y once
 * for all. Places of *frame are not read. */
void hawser__panels_open(struct hawser__figure *figure, const struct hawser__panels *at, int k,
                         const struct hawser__panel_frame *frame);

/* Title of the panel of mode k with this frequency (rad/s). */
void hawser__panels_frequency(FILE *script, int k, double omega, const char *what);

/* Factor, 1, 2 or 5 times a power of ten, that magnifies a component too small to be visible. */
double hawser__panels_magnify(double mine, double other);

#endif

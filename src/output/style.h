/* output/style.h - what all pictures share: colours of stability, line styles, the legend.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_STYLE_H
#define HAWSER_OUTPUT_STYLE_H

#include <stdio.h>

struct hawser__picture;
struct hawser__map_picture;

#define HAWSER__UNSTABLE_DASH "dt (9,6)"    /* of unstable motions */
#define HAWSER__UNSTABLE_FILL "#f6c9a8"     /* of unstable parts of a plane: light vermilion */
#define HAWSER__LEGEND_CM 3.0 /* below the lowest panel: tics, axis title, two rows of legend */

/* gnuplot's linetypes, border, tics, grid. */
extern const char hawser__picture_look[];

/* Begin the legend below all panels: a "plot NaN ... title ..." line of the caller's follows. */
void hawser__picture_legend(struct hawser__picture *picture, int most_rows);

/* Data $tongue: x and y of both corners of boxes that fill tongues narrower than a pixel. */
void hawser__map_tongues(FILE *script, const struct hawser__map_picture *map);

/* Copy an SVG picture of gnuplot's. Each piece of its markup is an element of its own, and viewers drop
 * white space at the ends of elements: text is told to keep it. */
void hawser__picture_spaces(FILE *to, FILE *from);

#endif

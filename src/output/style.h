/* output/style.h - what all pictures share: colours of stability, line styles, the legend.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_STYLE_H
#define HAWSER_OUTPUT_STYLE_H

#include <stdio.h>

struct hawser__picture;
struct hawser__map_picture;

#define HAWSER__UNSTABLE_DASH "dt (9,6)"    /* of unstable motions */
#define HAWSER__UNSTABLE_FILL "#f6c9a8"     /* of unstable parts of a plane: light vermilion */
#define HAWSER__LEGEND_CM 3.0 /* below the lowest panel: tics, axis title, up to three rows of legend */
enum { HAWSER__LEGEND_MOST = 24 };

/* gnuplot's linetypes, border, tics, grid. */
extern const char hawser__picture_look[];

/* A legend below all panels, in as few rows as fit the picture's width. Every entry is put at its
 * own place: gnuplot overestimates the width of text in SVG, and would use more rows than there is
 * room for. */
struct hawser__legend {
	int count;
	struct hawser__legend_entry {
		char style[160], title[120];
	} entry[HAWSER__LEGEND_MOST];
};
/* `style` is a format: what stands between "plot NaN" and "title". What is beyond the most is left
 * out. */
void hawser__legend_add(struct hawser__legend *legend, const char *title, const char *style, ...)
	__attribute__((format(printf, 3, 4)));
void hawser__legend_draw(struct hawser__picture *picture, const struct hawser__legend *legend);

/* Data $tongue: x and y of both corners of boxes that fill tongues narrower than a pixel. */
void hawser__map_tongues(FILE *script, const struct hawser__map_picture *map);

/* Copy an SVG picture of gnuplot's. Each piece of its markup is an element of its own, and viewers drop
 * white space at the ends of elements: text is told to keep it. Browsers blur the pixels of a map into
 * each other, across the border of stability too: images are told to keep them. */
void hawser__picture_spaces(FILE *to, FILE *from);

#endif

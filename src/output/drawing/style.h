/* output/drawing/style.h - appearance common to all pictures: colours of stability, line styles, the
 * legend. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_STYLE_H
#define HAWSER_OUTPUT_STYLE_H

#include <stdio.h>

struct hawser__picture;

#define HAWSER__UNSTABLE_DASH "dt (9,6)"    /* of unstable motions */
#define HAWSER__UNSTABLE_FILL "#f6c9a8"     /* of unstable parts of a plane: light vermilion */
#define HAWSER__LEGEND_CM 2.6 /* below the lowest panel: tics, axis title, up to two rows of legend */
enum { HAWSER__LEGEND_MOST = 24 };

/* gnuplot's linetypes, border, tics, grid. */
extern const char hawser__picture_look[];
/* Border, tics and grid alone, after a panel without them. */
extern const char hawser__picture_axes[];

/* A legend below all panels, with as few rows as the width of the picture permits. Each entry has
 * an explicit position, since gnuplot overestimates the width of text in SVG and would use too many
 * rows. */
struct hawser__legend {
	int count;
	struct hawser__legend_entry {
		char style[160], title[120];
	} entry[HAWSER__LEGEND_MOST];
};
/* `style` is the format of the text between "plot NaN" and "title". Entries beyond
 * HAWSER__LEGEND_MOST are omitted. */
void hawser__legend_add(struct hawser__legend *legend, const char *title, const char *style, ...)
	__attribute__((format(printf, 3, 4)));
/* The same, unless an entry has that title. */
void hawser__legend_once(struct hawser__legend *legend, const char *title, const char *style);
/* Words for the legend of the next pictures; NULL: none any longer. */
void hawser__legend_caution(const char *brief);
/* Add them. */
void hawser__legend_cautions(struct hawser__legend *legend);
void hawser__legend_draw(struct hawser__picture *picture, const struct hawser__legend *legend);
/* Copy an SVG picture up to the attributes of its outermost element. */
void hawser__picture_head(FILE *to, FILE *from);
/* Copy the rest of an SVG picture of gnuplot with two changes. Text elements preserve white space:
 * gnuplot writes each piece of markup as a separate element, and viewers would remove the white space
 * at its ends. Images are not smoothed: browsers would interpolate the pixels of a map, also across
 * the stability boundary. */
void hawser__picture_spaces(FILE *to, FILE *from);

#endif

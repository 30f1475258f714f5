/* output/labels.h - numbers beside the points of a panel, none on another or on a line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_LABELS_H
#define HAWSER_OUTPUT_LABELS_H

struct hawser__picture;

/* A panel's axes, and rectangles in it that are taken. */
struct hawser__labels {
	double panel[4];        /* left, bottom, right, top (cm) */
	double low[2], high[2]; /* ranges of both axes */
	int logarithmic[2];
	int boxes, labels;
	double box[1024][4];    /* left, bottom, right, top (cm) */
};

/* Range of an axis that shows low to high with a margin; of one value too. */
void hawser__labels_range(struct hawser__labels *labels, int axis, double low, double high,
                          int logarithmic);
/* The panel between these parts of the picture, its ranges set, no label; after both ranges. */
void hawser__labels_panel(struct hawser__labels *labels, struct hawser__picture *picture,
                          double left, double right, double bottom, double top);
/* A point's symbol, and the line from `from` to `to` (x, y), are to be kept free. */
void hawser__labels_symbol(struct hawser__labels *labels, double x, double y);
void hawser__labels_line(struct hawser__labels *labels, const double from[2], const double to[2]);
/* The number beside the point, in the colour of that line type, where there is room; else none. */
void hawser__labels_put(struct hawser__labels *labels, struct hawser__picture *picture, double x,
                        double y, int number, int colour);

#endif

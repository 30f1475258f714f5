/* output/drawing/labels.c - numbers beside the points of a panel.
 *
 * Measured positions, such as processor times, differ between runs, so that a fixed position on one
 * side of a point would sometimes overlap a neighbour's number. Each number is placed at the first
 * of eight positions about its point that overlaps no number, symbol or line.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "output/drawing/labels.h"
#include "output/output.h"

enum { MOST = sizeof ((struct hawser__labels *)0)->box/sizeof ((struct hawser__labels *)0)->box[0] };

/* cm: half of a symbol's width, half the height of a digit of 9 points, half its width in a wide font,
 * room between two numbers */
static const double symbol = 0.12, half_height = 0.13, half_digit = 0.1, between = 0.13;

void hawser__labels_range(struct hawser__labels *labels, int axis, double low, double high,
                          int logarithmic)
{
	const double margin = 0.1; /* of the range, for numbers beside the outermost points */

	if (logarithmic) {
		double factor = high > low ? pow(high/low, margin) : 3.0;

		labels->low[axis] = low/factor;
		labels->high[axis] = high*factor;
	} else {
		double more = high > low ? margin*(high - low) : 1.0;

		labels->low[axis] = low - more;
		labels->high[axis] = high + more;
	}
	labels->logarithmic[axis] = logarithmic;
}

void hawser__labels_panel(struct hawser__labels *labels, struct hawser__figure *figure,
                          const struct hawser__panel_frame *at)
{
	struct hawser__panel_frame own = *at;

	labels->panel[0] = at->left*figure->out.width;
	labels->panel[1] = at->bottom*figure->out.height;
	labels->panel[2] = at->right*figure->out.width;
	labels->panel[3] = at->top*figure->out.height;
	labels->boxes = labels->labels = 0;
	for (int axis = 0; axis < 2; axis++) {
		struct hawser__panel_axis *scale = axis ? &own.y : &own.x;

		scale->from = labels->low[axis];
		scale->to = labels->high[axis];
		scale->logarithmic = labels->logarithmic[axis];
	}
	hawser__figure_panel(figure, &own);
}

/* cm in the picture, of a value on an axis. */
static double place(const struct hawser__labels *labels, int axis, double value)
{
	double low = labels->low[axis], high = labels->high[axis];
	double part = labels->logarithmic[axis] ? log(value/low)/log(high/low) : (value - low)/(high - low);

	return labels->panel[axis] + part*(labels->panel[axis + 2] - labels->panel[axis]);
}

static void take(struct hawser__labels *labels, double x, double y, double wide, double tall)
{
	double *box = labels->box[labels->boxes];

	if (labels->boxes == MOST)
		return;
	box[0] = x - wide;
	box[1] = y - tall;
	box[2] = x + wide;
	box[3] = y + tall;
	labels->boxes++;
}

static int free_at(const struct hawser__labels *labels, double x, double y, double wide, double tall)
{
	if (x - wide < labels->panel[0] || x + wide > labels->panel[2] || y - tall < labels->panel[1] ||
	    y + tall > labels->panel[3])
		return 0;
	for (int k = 0; k < labels->boxes; k++) {
		const double *box = labels->box[k];

		if (x - wide < box[2] && box[0] < x + wide && y - tall < box[3] && box[1] < y + tall)
			return 0;
	}
	return 1;
}

void hawser__labels_symbol(struct hawser__labels *labels, double x, double y)
{
	if (isfinite(x) && isfinite(y))
		take(labels, place(labels, 0, x), place(labels, 1, y), symbol, symbol);
}

void hawser__labels_line(struct hawser__labels *labels, const double from[2], const double to[2])
{
	const double thin = 0.03, pitch = 0.1;
	double x = place(labels, 0, from[0]), y = place(labels, 1, from[1]);
	double dx = place(labels, 0, to[0]) - x, dy = place(labels, 1, to[1]) - y;
	int steps = (int)fmin(ceil(hypot(dx, dy)/pitch), 400.0);

	for (int k = 1; k < steps; k++)
		take(labels, x + dx*k/steps, y + dy*k/steps, thin, thin);
}

void hawser__labels_put(struct hawser__labels *labels, struct hawser__picture *picture, double x,
                        double y, int number, int colour)
{
	static const double side[][2] = {{1, 1}, {-1, -1}, {1, -1}, {-1, 1},
	                                 {0, 1}, {0, -1}, {1, 0}, {-1, 0}};
	double wide = half_digit*snprintf(NULL, 0, "%d", number) + 0.5*between, gap = symbol + 0.02;

	for (size_t k = 0; isfinite(x) && isfinite(y) && k < sizeof side/sizeof *side; k++) {
		double at = place(labels, 0, x) + side[k][0]*(gap + wide);
		double up = place(labels, 1, y) + side[k][1]*(gap + half_height);

		if (!free_at(labels, at, up, wide, half_height))
			continue;
		take(labels, at, up, wide, half_height);
		fprintf(picture->script, "set label %d '%d' at screen %.4f, screen up(%.4f) center tc lt %d "
		                         "font ',9'\n", ++labels->labels, number, at/picture->width,
		        up/picture->height, colour);
		return;
	}
}

/* output/drawing/figure.h - the one writer of pictures: panels with two axes, and what is drawn in
 * them.
 *
 * Points are put in the units of the results. The panel divides them by `per` of its axes and takes the
 * ranges and tics of its axes from them, unless it gives ranges itself. What has been put since the
 * last call is drawn by hawser__figure_draw; the style and the name that it gets there are those of
 * the legend below all panels, too. Where no point was put, nothing is drawn, and the legend has no
 * entry.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_FIGURE_H
#define HAWSER_OUTPUT_FIGURE_H

#include <stdio.h>

#include "output/drawing/perspective.h"
#include "output/drawing/style.h"
#include "output/output.h"

/* How an axis of a panel is divided. */
struct hawser__panel_axis {
	const struct hawser__axis *axis; /* title and factor; NULL: no title, numbers as they are put */
	double from, to; /* ends, as points are put; equal: those of the points */
	double room;     /* beyond the ends of the points, parts of their range */
	int zero;        /* 1: begins at 0 */
	int logarithmic; /* 2: with tics at 1, 2 and 5 in up to four decades */
	int tics;        /* at most; 0: ends and tics are chosen by gnuplot */
	int open;        /* 1: with `tics`, the ends (but for a zero) are chosen by gnuplot all the same */
	int bare;        /* 1: neither numbers nor title, which another panel has */
	int other;       /* 1: the range that the user chooses is not for it */
	int as_set;      /* 1: range, tics and numbers are those that the caller writes into the script */
	int untitled;    /* 1: numbers without a title */
};
struct hawser__panel_frame {
	double left, right, bottom, top; /* fractions of the picture */
	struct hawser__panel_axis x, y;
	int keys;          /* 1: names stand above the panel instead of in the legend */
	int view;          /* 1: seen in perspective: no axes, the same scale along both */
	const char *title; /* of the vertical axis, if it is not that of `y`; or NULL */
	double aside;      /* from there to the panel, fraction of the width; 0: 0.107 */
};

/* Of branches of frequencies along a sweep, where two are closest. */
#define HAWSER__CROSSING "with points pt 6 ps 1.0 lw 1.2 lc rgb 'black'"
#define HAWSER__VEERING "with points pt 7 ps 0.5 lc rgb 'black'"

enum { HAWSER__STYLE = 200 }; /* letters of a style */
struct hawser__figure {
	struct hawser__picture out; /* `out.script` takes settings of gnuplot for the open panel,
		before points */
	struct hawser__legend legend;
	struct hawser__panel_frame at;    /* the open panel, whose axes are */
	struct hawser__axis axis[2];
	double low[2], high[2];     /* of its points, as they are shown */
	int blocks, rows, gap;      /* blocks of data; rows of the open block; 1: its last line is empty */
	int drawn;                  /* 1: the last block is in the plot */
	int panels;                 /* so far */
	char first[2][HAWSER__AXIS_SIZE]; /* titles of the axes of the first one */
	int logarithmic[2];         /* 1: the user has chosen a range of an axis that is logarithmic */
	FILE *plot;                 /* what the open panel draws; NULL: none is open */
	char *text;
	size_t size;
	int lacks_memory;
	FILE *marks;                /* labels and arrows of the open panel */
	char *mark_text;
	size_t mark_size;
};

/* *figure is all zero, but for entries of the legend that precede those of what is drawn. */
enum hawser_status hawser__figure_begin(struct hawser__figure *figure, const char *path, double width,
                                        double height, struct hawser_report *report) HAWSER_MUST_CHECK;
/* Ends of both axes with one scale, so that the box fits a panel of that size, cm: seen along z (k 1: y
 * over x) or from above (k 2: z over x, downwards). */
void hawser__panel_even(struct hawser__panel_frame *at, const struct hawser__box *box, int k,
                        double width, double height);
/* The next panel; labels, arrows and objects of the one before end. */
void hawser__figure_panel(struct hawser__figure *figure, const struct hawser__panel_frame *at);

/* A point. Where one of the two is no finite number, the line has a gap. */
void hawser__figure_put(struct hawser__figure *figure, double x, double y);
void hawser__figure_gap(struct hawser__figure *figure);
/* A row of several columns. `columns` has a letter for each: x, y: a place on that axis; X, Y: a
 * distance along it; any other: as it is. */
void hawser__figure_row(struct hawser__figure *figure, const char *columns, const double *value);
/* A place in space, as the eye of a view sees it. */
void hawser__figure_see(struct hawser__figure *figure, const struct hawser__eye *eye,
                        const double x[3]);
/* Points [count] at x[i] and y[i], each so many bytes after the one before. */
void hawser__figure_bind(struct hawser__figure *figure, int count, const double *x, size_t x_step,
                         const double *y, size_t y_step);

/* Draw what was put. The style is that of gnuplot's plot, "with lines lt 1", perhaps after "using 1:3";
 * title: in the legend, or NULL. */
void hawser__figure_draw(struct hawser__figure *figure, const char *title, const char *style, ...)
	HAWSER_PRINTF(3, 4);
/* Draw it once more in another style. */
void hawser__figure_again(struct hawser__figure *figure, const char *title, const char *style, ...)
	HAWSER_PRINTF(3, 4);
/* A function of x in shown units: "2*x with lines". */
void hawser__figure_function(struct hawser__figure *figure, const char *title, const char *formula, ...)
	HAWSER_PRINTF(3, 4);
/* A line from the foot to the top of the panel. The style is one of lines, "lt 7 dt (4,4)". */
void hawser__figure_upright(struct hawser__figure *figure, const char *title, double x,
                            const char *style,
                            ...) HAWSER_PRINTF(4, 5);

/* A text at a place, "at X,Y ...", with the settings of gnuplot's labels. */
void hawser__figure_label(struct hawser__figure *figure, double x, double y, const char *settings,
                          const char *text, ...) HAWSER_PRINTF(5, 6);
/* The same of a user's name, which has no markup. */
void hawser__figure_name(struct hawser__figure *figure, double x, double y, const char *settings,
                         const char *name);
/* A text above the panel, or at its upper end. */
void hawser__figure_above(struct hawser__figure *figure, double x, const char *settings,
                          const char *text);

/* Divide a place on an axis (0: x) by its unit; 1: there is a mark: the range that the user chose,
 * if any, has the place, beyond which gnuplot would draw it outside of the panel. */
int hawser__figure_marked(const struct hawser__figure *figure, int axis, double *place);

enum hawser_status hawser__figure_finish(struct hawser__figure *figure,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* In place of _finish, after a failure of the caller. */
void hawser__figure_abort(struct hawser__figure *figure);

/* map_tongues.c: put x and y of both corners of boxes that fill tongues narrower than a pixel. */
void hawser__map_tongues(struct hawser__figure *figure, const struct hawser__map_picture *map);

/* --- frames.c: where the panels of a picture are, and the ranges of their axes, for programs
 * that read values off an SVG picture (the report's script) ---
 *
 * gnuplot knows both after each plot only. So the script asks it to print them, with a word by
 * which they are found among its messages. */

struct hawser__picture;

/* Ask for the panel that was plotted last, if any. */
void hawser__frames_ask(struct hawser__picture *picture);
/* 1 if a line of gnuplot's messages is its answer. */
int hawser__frames_answer(const char *line);
/* Write the attribute data-panels of an SVG element of that height (px): for each panel "left right
 * top bottom x0 x1 y0 y1 log", px and units of the axes; log: bit 1: x is logarithmic, bit 2: y is;
 * panels are separated by ";". `messages` is what gnuplot wrote to standard error, read from its
 * beginning. */
void hawser__frames_write(FILE *to, FILE *messages, double height);

/* --- panels.c: layout of pictures with one panel per mode, in rows of up to three --- */

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

/* output/drawing/animate.h - lines and nets that move, as an animated GIF.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_ANIMATE_H
#define HAWSER_OUTPUT_ANIMATE_H

#include <hawser/status.h>
#include <hawser/surface.h>
#include <hawser/water.h>

enum { HAWSER__ANIMATE_FRAMES = 100 }; /* if the user does not say: smooth, some hundred kB */

struct hawser__animation {
	const double *time;    /* [rows] s */
	const double (*x)[3];  /* [rows][points] m: of a line, or of a net */
	int rows, points;
	int frames;            /* at most; 0: HAWSER__ANIMATE_FRAMES */
	const char *note;      /* after the time in the title; or NULL */
	const double (*mark)[3]; /* [rows] m: what has a mark and a trail; NULL: the last point */
	/* Of a net: */
	const int (*end)[2];   /* [elements] the points that each joins; NULL: a line */
	int elements;
	const int *held;       /* [helds] points at supports; NULL if there are none */
	int helds;
	const struct hawser_surface *surface; /* [surfaces] obstacles; NULL if there are none */
	int surfaces;
	const struct hawser_water *water; /* whose surface is drawn, with its waves; or NULL */
	const double (*origin)[3]; /* [rows] m: where the axes are in the water; NULL: at 0 */
};

/* That the name says GIF, gnuplot is there and the file can be written; path may be NULL. */
enum hawser_status hawser__animate_check(const char *path, const char *command,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
/* Axes stay, with equal scales; rows are left out evenly. It plays in real time, but not in less than
 * 5 s nor more than 20 s. */
enum hawser_status hawser__animate(const char *path, const struct hawser__animation *animation,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* output/drawing/frames.h - where the panels of a picture are, and the ranges of their axes, for
 * programs that read values off an SVG picture (the report's script).
 *
 * gnuplot knows both after each plot only. So the script asks it to print them, with a word by which
 * they are found among its messages.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_FRAMES_H
#define HAWSER_OUTPUT_FRAMES_H

#include <stdio.h>

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

#endif

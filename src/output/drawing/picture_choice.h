/* output/drawing/picture_choice.h - what the user has chosen of pictures: size, title, ranges.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_PICTURE_CHOICE_H
#define HAWSER_OUTPUT_PICTURE_CHOICE_H

#include <stdio.h>

#include <hawser/status.h>

/* What the user has chosen of all pictures, in place of what a picture has. */
struct hawser__picture_range {
	int given;
	double low, high; /* in the unit of the axis; -INFINITY, INFINITY: as the data are */
	const char *text; /* as the user wrote it */
};
struct hawser__picture_choice {
	const char *title;    /* above the picture; or NULL */
	double width, height; /* cm; 0: those of the picture */
	struct hawser__picture_range range[2]; /* x, y: of the first panel, and of others with its axis */
};
void hawser__picture_choose(const struct hawser__picture_choice *choice);

/* Into size [2] the width and height in cm, of a picture that has these itself; with room for a
 * title. Returns the factor of its letters: 1, or less if it is smaller. */
double hawser__picture_size(double size[2], double width, double height);

/* Fails with HAWSER_ERR_ARGUMENT if the chosen range of an axis, 'x' or 'y', is none of a logarithmic
 * one. */
enum hawser_status hawser__picture_logarithmic(char axis,
                                               struct hawser_report *report) HAWSER_MUST_CHECK;

/* Part of a picture of that height (cm) that is below its title; 1 without one. */
double hawser__picture_below_title(double height);
/* Write the title into the script, for the panel that is open. */
void hawser__picture_title(FILE *script);
/* What is chosen for the axis 0 (x) or 1 (y), or NULL. */
const struct hawser__picture_range *hawser__picture_range_of(int axis);

/* --- latex.c: pictures for LaTeX: the drawing as PDF, its texts set by LaTeX --- */

/* A picture of gnuplot's terminal cairolatex, which writes two files, in a folder of its own. */
struct hawser__latex {
	FILE *script;     /* for gnuplot */
	char folder[4096]; /* or "": as long as a path may be (PATH_MAX) */
};
/* Fails if LaTeX could not read the drawing's name ("x.pdf" of "x.tex"), or it cannot be written. */
enum hawser_status hawser__latex_check(const char *path,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* The script for that terminal, from one that is at its begin and sets it in its first line. Clear
 * *latex in any case. */
enum hawser_status hawser__latex_begin(struct hawser__latex *latex, FILE *script,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
/* Write the texts of the picture, with letters of that size (pt), and beside `path` the drawing. */
enum hawser_status hawser__latex_write(struct hawser__latex *latex, FILE *to, const char *path,
                                       double size, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__latex_clear(struct hawser__latex *latex);

#endif

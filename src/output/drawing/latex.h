/* output/drawing/latex.h - pictures for LaTeX: the drawing as PDF, its texts set by LaTeX.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_LATEX_H
#define HAWSER_OUTPUT_LATEX_H

#include <stdio.h>

#include <hawser/status.h>

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

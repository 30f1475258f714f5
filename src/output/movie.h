/* output/movie.h - the motion of a net as an animation: a .gif by gnuplot, an .mp4 by gnuplot and
 * ffmpeg. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_MOVIE_H
#define HAWSER_OUTPUT_MOVIE_H

#include <hawser/net_motion.h>

#include "output/output.h"

enum { HAWSER__MOVIE_FRAMES = 120, HAWSER__MOVIE_MOST = 2000 }; /* by default, and at most */

/* Frames are kept in a temporary file until all are there: the eye, the scales and the colours are the
 * same for all of them. */
struct hawser__movie;

/* Before the computation: the name, and the programs. NULL is legal. */
enum hawser_status hawser__movie_check(const char *path, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* `rows`: of the run; at most `frames` of them, evenly spaced, are kept. */
enum hawser_status hawser__movie_open(struct hawser__movie **movie, const char *path, int rows,
                                      int frames, struct hawser_report *report) HAWSER_MUST_CHECK;
/* Call it for each row. */
enum hawser_status hawser__movie_add(struct hawser__movie *movie, const struct hawser_net_frame *frame,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
int hawser__movie_frames(const struct hawser__movie *movie); /* kept so far */
/* Draw and write the file. supports [nodes of the net]: 1 where a support is drawn. */
enum hawser_status hawser__movie_finish(struct hawser__movie *movie, const unsigned char *supports,
                                        int nodes, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__movie_clear(struct hawser__movie *movie);

#endif

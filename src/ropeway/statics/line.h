/* ropeway/statics/line.h - internal: parts of hawser_line_solve().
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_LINE_H
#define HAWSER_ROPEWAY_LINE_H

#include "ropeway/statics/march.h"

enum hawser_status hawser__line_check(const struct hawser_line *line, struct hawser_report *report);
enum { HAWSER__LINE_CALLED = HAWSER_LINE_NAME + 44 }; /* size of such a name */
/* "sheave 3 (p2, line 7)", or "end A" for a number below 0, "end B" for one above the last. */
const char *hawser__line_name(char text[HAWSER__LINE_CALLED], const struct hawser_line *line,
                              int sheave);
/* Friction coefficient that acts on a sheave; > 0: the tension grows towards B. */
double hawser__line_grip(const struct hawser_line *line, int sheave);
/* S at the first and at the last point of contact with a sheave that is touched. */
void hawser__line_touch(double *from, double *to, const struct hawser_line_statics *st, int sheave);
/* Convert what the march has laid to the result, and check it. */
void hawser__line_finish(struct hawser_line_statics *st, struct hawser__march *march);
void hawser__line_release(struct hawser_line_statics *st);
/* The arc of a piece on a sheave. */
struct hawser__arc hawser__line_arc(const struct hawser_line *line,
                                    const struct hawser_line_piece *piece, double T0);
/* The rope at rest that has the shape of the line's; without masses. */
struct hawser__rope hawser__line_rope(const struct hawser_line *line);

#endif

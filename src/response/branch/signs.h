/* response/branch/signs.h - the reflections u_j -> -u_j of some coordinates under which a model
 * stays the same, and those with which its motions reversed in time are motions. See signs.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_SIGNS_H
#define HAWSER_RESPONSE_SIGNS_H

#include <hawser/rom.h>

struct hawser__signs {
	int n;
	unsigned char *row;  /* [n][n + 1] equations modulo 2 in echelon form: row p begins in column p; the
	                      * last column is the right side for reversal, of reflections it is 0 */
	unsigned char *used; /* [n] 1: row p is there */
	int never;           /* 1: no reflection goes with reversed motions */
};

/* Of a model with the velocities' matrix G [n][n], skew. Release with _free in any case. */
enum hawser_status hawser__signs_init(struct hawser__signs *signs, const struct hawser_rom *rom,
                                      const double *G, struct hawser_report *report);
void hawser__signs_free(struct hawser__signs *signs);

/* sign [n], 1 or -1: reflections that make a motion of a reversed one; all 1 if possible. 1: none. */
int hawser__signs_reversal(const struct hawser__signs *signs, int *sign);

/* flip [n], 1 or -1: reflections under which the model stays the same, with 1 where member [n] is
 * not 0, and -1 at coordinate j. 1: there are none. */
enum hawser_status hawser__signs_flip(const struct hawser__signs *signs, const unsigned char *member,
                                      int j, int *flip, int *none, struct hawser_report *report);

/* Motions in the coordinates `member` stay in those of class 0. Small motions of the others are
 * coupled within classes 1, 2, ... only, which the reflections that leave class 0 alone tell apart.
 * class_of [n]; *classes: their number, with class 0. */
enum hawser_status hawser__signs_classes(const struct hawser__signs *signs,
                                         const unsigned char *member, int *class_of, int *classes,
                                         struct hawser_report *report);

#endif

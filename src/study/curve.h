/* study/curve.h - how far apart two frequency responses are as curves: see curve.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_CURVE_H
#define HAWSER_STUDY_CURVE_H

#include <hawser/frf.h>

/* What is compared of a response; a copy, which outlives the response. */
struct hawser__curve {
	int points, width; /* width: displacement components, 3 for each probe */
	double *arc;       /* [points] ascending */
	double *value;     /* [points][1 + width] log Omega, then the amplitudes */
};

/* HAWSER_ERR_MEMORY. Release with hawser__curve_clear whatever the status. */
enum hawser_status hawser__curve_copy(struct hawser__curve *curve, const struct hawser_frf *frf,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__curve_clear(struct hawser__curve *curve);

/* *distance: the least t such that every point of either curve that is farther than t from the ends of
 * the range in Omega has a point of the other curve within t, both in Omega (relative) and in
 * amplitude (relative to the largest of that component). Components that reach half of the largest one
 * count. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__curve_distance(double *distance, const struct hawser__curve *a,
                                          const struct hawser__curve *b,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

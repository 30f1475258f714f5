/* study/distance.h - what of a response an accuracy is about: see distance.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_DISTANCE_H
#define HAWSER_STUDY_DISTANCE_H

#include <hawser/study.h>

#include "study/curve.h"

/* What of a response is compared with another's: its landmarks, of which strong[count] count and the
 * others may be partners of another response's strong ones; and the whole curve. */
struct hawser__marks {
	struct hawser_landmark *item;
	char *strong;
	int count;
	struct hawser__curve curve;
};

/* Peaks are sharpened to `wanted` where rom is not NULL (study/landmark.h). */
enum hawser_status hawser__marks_find(struct hawser__marks *marks, const struct hawser_frf *frf,
                                      const struct hawser_rom *rom,
                                      const struct hawser_frf_options *options, double wanted,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* How well the peaks that count are known: the largest error, relative, of Omega or amplitude. */
double hawser__marks_located(const struct hawser__marks *marks);
void hawser__marks_clear(struct hawser__marks *marks);

/* *distance as in hawser_accuracy_distance. */
enum hawser_status hawser__marks_distance(double *distance, const struct hawser__marks *a,
                                          const struct hawser__marks *b,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* study/compare/distance.h - the features of a response to which an accuracy refers: see distance.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_DISTANCE_H
#define HAWSER_STUDY_DISTANCE_H

#include <hawser/study.h>

#include "study/compare/curve.h"

/* The features of a response that are compared: its landmarks, of which those with strong[count]
 * set count, while the others may only be partners of strong landmarks of another response; and the
 * whole curve. */
struct hawser__marks {
	struct hawser_landmark *item;
	char *strong;
	int count;
	struct hawser__drawn_curve curve;
};

/* Find them. If rom is not NULL, peaks are located to `wanted` (study/accuracy/landmark.h). */
enum hawser_status hawser__marks_find(struct hawser__marks *marks, const struct hawser_frf *frf,
                                      const struct hawser_rom *rom,
                                      const struct hawser_frf_options *options, double wanted,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* Find them in a response of which hawser_study_run has located the peaks already. */
enum hawser_status hawser__marks_of(struct hawser__marks *marks,
                                    const struct hawser_study_curve *curve,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* The largest relative error of Omega or amplitude of the peaks that count. */
double hawser__marks_located(const struct hawser__marks *marks);
void hawser__marks_clear(struct hawser__marks *marks);

/* *distance as in hawser_accuracy_distance. */
enum hawser_status hawser__marks_distance(double *distance, const struct hawser__marks *a,
                                          const struct hawser__marks *b,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

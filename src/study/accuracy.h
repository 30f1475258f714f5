/* study/accuracy.h - parts of the search for a model of a requested accuracy: see accuracy.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_ACCURACY_H
#define HAWSER_STUDY_ACCURACY_H

#include <hawser/accuracy.h>

#include "study/distance.h"

/* Factor on first-order measures, for what terms of higher order add. */
#define HAWSER__SAFETY 3.0

/* Range, tolerances and steps of the responses for an accuracy. */
struct hawser_frf_options
hawser__accuracy_settle(const struct hawser_accuracy_options *options, double accuracy);

/* Of the modes that hawser_accuracy_choose keeps those of the first model. */
void hawser__accuracy_first(struct hawser_choice *choice);

/* Trace the next response, and measure how far it is from the one that *marks are of; they become those
 * of this one. functions = 0: the model of the modes that are kept now is built; else the full-order
 * model of so many functions stands in a->rom. Statuses of hawser_frf_trace and hawser_rom_build. */
enum hawser_status hawser__accuracy_attempt(struct hawser_accuracy *a, struct hawser__marks *marks,
                                            const struct hawser_scene *scene, int functions,
                                            const struct hawser_frf_options *options,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* The candidates: the modes that hawser_accuracy_choose looks at, `fewest` at the least. */
enum hawser_status hawser__accuracy_candidates(struct hawser_modes *modes,
                                               const struct hawser_statics *statics,
                                               const struct hawser_scene *scene, double from,
                                               double to, double accuracy, int fewest,
                                               struct hawser_report *report) HAWSER_MUST_CHECK;

/* The estimated error: `model`, and how well the peaks are located. */
void hawser__accuracy_claim(struct hawser_accuracy *a, double model,
                            const struct hawser__marks *marks);

/* 1: the last response is a part of a curve only, or its cable is slack. */
int hawser__accuracy_cut(const struct hawser_accuracy *a);

/* What follows the response of the last attempt, as far as its own motions tell. */
enum hawser__course {
	HAWSER__LAST,    /* nothing: its estimate reaches the accuracy; */
	HAWSER__ANOTHER, /* one more, of the modes that a->choice keeps now; */
	HAWSER__SEVERAL  /* more than one, or full-order models */
};
enum hawser__course hawser__accuracy_course(struct hawser_accuracy *a,
                                            const struct hawser_accuracy_options *options);
/* The same where the first response is known as `frf` alone, which need not be exact: weighs the modes
 * by its motions. Statuses of hawser_choice_weigh. */
enum hawser_status hawser__accuracy_foresee(enum hawser__course *course, struct hawser_accuracy *a,
                                            const struct hawser_frf *frf,
                                            const struct hawser_accuracy_options *options,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;

/* Full-order models of growing bases, until one agrees with the model before. Statuses of
 * hawser_rom_build_full and hawser_frf_trace. */
enum hawser_status hawser__accuracy_full(struct hawser_accuracy *a, struct hawser__marks *marks,
                                         const struct hawser_scene *scene,
                                         const struct hawser_accuracy_options *options,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

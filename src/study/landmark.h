/* study/landmark.h - peaks looked at again where the branch was followed more closely.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_LANDMARK_H
#define HAWSER_STUDY_LANDMARK_H

#include <hawser/study.h>

/* The same peak on a piece of the branch that was followed again: the highest of the maxima about the
 * one nearest to `arc` between which the amplitude falls by less than hawser_landmark_defaults
 * says. Changed where less of it is left to reading between points. Returns the index of the point,
 * or 0 for none. */
int hawser__peak_again(struct hawser_landmark *peak, const struct hawser_frf *frf, double arc);

/* Go over the branch again in short steps about every peak, and once more about those that are not
 * known to `wanted` then, relative. What cannot be followed again stays as it is, with its error. */
enum hawser_status hawser__study_sharpen(struct hawser_study_curve *curve,
                                         const struct hawser_rom *rom,
                                         const struct hawser_frf_options *options, double wanted,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

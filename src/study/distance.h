/* study/distance.h - see distance.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_DISTANCE_H
#define HAWSER_STUDY_DISTANCE_H

#include <hawser/study.h>

/* Peaks that count, when an accuracy is asked for. */
extern const struct hawser_landmark_options hawser__landmarks_strong;

#endif

/* study/motions.h - the motions of a response, for what they say of the modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MOTIONS_H
#define HAWSER_STUDY_MOTIONS_H

#include <hawser/frf.h>

#include "rom/weigh.h"
#include "study/distance.h"

/* Index of the traced point nearest along the branch. */
int hawser__nearest_point(const struct hawser_frf *frf, double arc);

/* The orbit at point i of the response of `rom`, which keeps what the choice does, weighs the choice's
 * modes: hawser__choice_weigh. Statuses of hawser_integrate and of that. */
enum hawser_status hawser__weigh_orbit(struct hawser_choice *choice, const struct hawser_rom *rom,
                                       const struct hawser_frf *frf, int i, int whole,
                                       unsigned counted, unsigned peaks,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* All measures anew, from the orbits at landmarks and ends, and from `between` others along the curve,
 * which tell what the motion makes unstable. */
enum { HAWSER__BETWEEN = 16 };
enum hawser_status hawser__weigh_response(struct hawser_choice *choice, const struct hawser_rom *rom,
                                          const struct hawser_frf *frf,
                                          const struct hawser__marks *marks, int between,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

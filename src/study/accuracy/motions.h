/* study/accuracy/motions.h - the motions of a response, by which modes are weighed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MOTIONS_H
#define HAWSER_STUDY_MOTIONS_H

#include <hawser/accuracy.h>
#include <hawser/frf.h>

#include "rom/choose/weigh.h"
#include "study/compare/distance.h"

/* Index of the traced point nearest to an arclength. */
int hawser__nearest_point(const struct hawser_frf *frf, double arc);

/* Weigh the modes of the choice by one period of the motion of `rom`, which keeps the modes of the
 * choice: hawser__choice_weigh. Statuses of hawser_integrate and of that function. */
enum hawser_status hawser__weigh_motion(struct hawser_choice *choice, const struct hawser_rom *rom,
                                        const struct hawser_accuracy_motion *start, int whole,
                                        unsigned counted, unsigned peaks,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* The same by the orbit at point i of the response of `rom`. */
enum hawser_status hawser__weigh_orbit(struct hawser_choice *choice, const struct hawser_rom *rom,
                                       const struct hawser_frf *frf, int i, int whole,
                                       unsigned counted, unsigned peaks,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* Compute all measures anew from the orbits at landmarks and ends. `between` further orbits along
 * the curve show which modes the motion makes unstable. */
enum { HAWSER__BETWEEN = 16 };
enum hawser_status hawser__weigh_response(struct hawser_choice *choice, const struct hawser_rom *rom,
                                          const struct hawser_frf *frf,
                                          const struct hawser__marks *marks, int between,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

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

/* A motion may be so unstable that it escapes within the period in which it is computed again. The
 * steps that the period takes at most, in which the fastest coordinate moves with its own frequency. */
long hawser__steps_of_period(const struct hawser_rom *rom, double omega);
static inline int hawser__escapes(enum hawser_status status)
{
	return status == HAWSER_ERR_CONVERGENCE || status == HAWSER_ERR_NAN;
}

/* Weigh the modes of the choice by one period of the motion of `rom`, which keeps the modes of the
 * choice: hawser__choice_weigh. One that escapes has the error 1. Statuses of hawser_integrate and of
 * that function. */
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

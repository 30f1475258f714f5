/* statics/travel.h - internal to the statics stage: the travelling cable.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_TRAVEL_H
#define HAWSER_STATICS_TRAVEL_H

#include <hawser/statics.h>

/* rho (v^2 + V^2/2), N, with the actual rho. */
static inline double hawser__thrust(const struct hawser_statics *st)
{
	const struct hawser_motion *motion = &st->motion;
	double square = motion->speed*motion->speed + 0.5*motion->fluctuation*motion->fluctuation;

	return st->span.rho/(1.0 - motion->mach2)*square;
}

/* The branch, taut or slack, to which a cable at rest belongs if T0 or T1 is given. */
enum hawser_status hawser__branch_of(enum hawser_branch *branch, const struct hawser_statics *rest,
                                     enum hawser_given given, struct hawser_report *report)
	HAWSER_MUST_CHECK;

/* Steady state at motion->speed and ->fluctuation with the apparent horizontal tension H (N). */
enum hawser_status hawser__travel_at(struct hawser_statics *statics, const struct hawser_span *span,
                                     const struct hawser_motion *motion, double H,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
/* Taut steady state whose actual quantity `given` is `value` (N or m). */
enum hawser_status hawser__travel_with(struct hawser_statics *statics,
                                       const struct hawser_span *span,
                                       const struct hawser_motion *motion,
                                       enum hawser_given given, double value,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

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

/* --- yield.c: ends on springs, which give way --- */

/* force[2]: of the cable at ends A and B, in the direction of +S, along x, y, z. */
void hawser__end_forces(double force[2][3], const struct hawser_statics *st);

/* Whether an end of the scene is on springs. */
int hawser__on_springs(const struct hawser_scene *scene);

/* Displacements of the ends of *equal, which is the span between the places of the scene, at the
 * unstretched length equal->value: sets the members from `yields` on, and chord[3], between the ends
 * where they are, along x, y, z. rest[2]: forces as above where the ends are at their places.
 * HAWSER_ERR_NO_SOLUTION if an end moves by more than a tenth of the distance of the ends. */
enum hawser_status hawser__yield(struct hawser_equivalent *equal, double chord[3],
                                 const struct hawser_scene *scene, double rest[2][3],
                                 struct hawser_report *report) HAWSER_MUST_CHECK;

/* Set st->moved and st->imbalance. */
void hawser__yield_moved(struct hawser_statics *st, const struct hawser_equivalent *equal);

#endif

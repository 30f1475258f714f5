/* statics/profile.h - internal to the statics stage: the closure error of a solved span.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_PROFILE_H
#define HAWSER_STATICS_PROFILE_H

#include <hawser/statics.h>

/* Distance, m, of the point computed by B (2.87) from end B, with eta, l, epsilon and delta of
 * *st. */
double hawser__statics_closure(const struct hawser_statics *st);

/* Of a cable in space (profile_space.c). */
double hawser__space_closure(const struct hawser_statics *st);
struct hawser_profile_point hawser__space_at(const struct hawser_statics *st, double S);
struct hawser_profile_point hawser__space_before(const struct hawser_statics *st, int i);
void hawser__space_frame(struct hawser_frame_point *at, const struct hawser_statics *st, double s);

#endif

/* statics/models.h - internal to the statics stage: the check of arguments common to all models,
 * and the models in separate files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_MODELS_H
#define HAWSER_STATICS_MODELS_H

#include <hawser/statics.h>

/* Returns HAWSER_ERR_ARGUMENT for an invalid argument; the report names it. */
enum hawser_status hawser__statics_check(const struct hawser_span *span, enum hawser_given given,
                                         double value, enum hawser_branch branch,
                                         struct hawser_report *report);

/* parabola.c */
enum hawser_status hawser__parabola_solve(struct hawser_statics *statics,
                                          const struct hawser_span *span, enum hawser_given given,
                                          double value, enum hawser_branch branch,
                                          struct hawser_report *report);
struct hawser_profile_point hawser__parabola_at(const struct hawser_statics *statics, double S);

/* --- profile.c: the closure error of a solved span --- */

/* Distance, m, of the point computed by B (2.87) from end B, with eta, l, epsilon and delta of
 * *st. */
double hawser__statics_closure(const struct hawser_statics *st);

/* Of a cable in space (profile_space.c). */
double hawser__space_closure(const struct hawser_statics *st);
struct hawser_profile_point hawser__space_at(const struct hawser_statics *st, double S);
struct hawser_profile_point hawser__space_before(const struct hawser_statics *st, int i);
void hawser__space_frame(struct hawser_frame_point *at, const struct hawser_statics *st, double s);

#endif

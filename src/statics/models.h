/* statics/models.h - inside the statics stage: the check of arguments that every model makes, and the
 * models that have a file of their own.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STATICS_MODELS_H
#define HAWSER_STATICS_MODELS_H

#include <hawser/statics.h>

/* HAWSER_ERR_ARGUMENT, and which argument it is. */
enum hawser_status hawser__statics_check(const struct hawser_span *span, enum hawser_given given,
                                         double value, enum hawser_branch branch,
                                         struct hawser_report *report);

/* parabola.c */
enum hawser_status hawser__parabola_solve(struct hawser_statics *statics,
                                          const struct hawser_span *span, enum hawser_given given,
                                          double value, enum hawser_branch branch,
                                          struct hawser_report *report);
struct hawser_profile_point hawser__parabola_at(const struct hawser_statics *statics, double S);

#endif

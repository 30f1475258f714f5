/* modes/irvine_range.h - the range of a sweep of the tension, and its stations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_IRVINE_RANGE_H
#define HAWSER_MODES_IRVINE_RANGE_H

#include <hawser/irvine.h>

/* x[points]: log of H (N) at the stations; strictly monotone. */
enum hawser_status hawser__irvine_place(double *x, int points, const struct hawser_span *span,
                                        const struct hawser_irvine_options *options,
                                        struct hawser_report *report);

/* The motion that the options describe. */
struct hawser_motion hawser__irvine_motion(const struct hawser_irvine_options *options);

/* hawser_irvine_range for a travelling cable. */
enum hawser_status hawser__irvine_range(double *from, double *to, const struct hawser_span *span,
                                        const struct hawser_motion *motion,
                                        enum hawser_given given, struct hawser_report *report);

#endif

/* modes/sweep/irvine_range.h - the range of a sweep of the tension, and its stations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_IRVINE_RANGE_H
#define HAWSER_MODES_IRVINE_RANGE_H

#include <hawser/irvine.h>

/* x[points]: log of H (N) at the stations; strictly monotone. */
enum hawser_status hawser__irvine_place(double *x, int points, const struct hawser_span *span,
                                        const struct hawser_irvine_options *options,
                                        struct hawser_report *report);

/* The static solution with the apparent horizontal tension H (N), with attachments and motion as in the
 * options. */
enum hawser_status hawser__irvine_at(struct hawser_statics *st, const struct hawser_span *span,
                                     const struct hawser_irvine_options *options, double H,
                                     struct hawser_report *report);

/* hawser_irvine_range, with attachments and motion as in the options. */
enum hawser_status hawser__irvine_range(double *from, double *to, const struct hawser_span *span,
                                        const struct hawser_irvine_options *options,
                                        enum hawser_given given, struct hawser_report *report);

#endif

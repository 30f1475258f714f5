/* modes/campbell_range.h - the speeds of a Campbell diagram.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_CAMPBELL_RANGE_H
#define HAWSER_MODES_CAMPBELL_RANGE_H

#include <hawser/campbell.h>

/* Defaults in place of zeros; *limit as in struct hawser_campbell. */
enum hawser_status hawser__campbell_settle(struct hawser_campbell_options *options, double *limit,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report);

/* *x: the stations' speeds, *count of them, of which the first *asked are those asked for; ascending,
 * below the limit; free it. */
enum hawser_status hawser__campbell_place(double **x, int *count, int *asked,
                                          const struct hawser_campbell_options *options,
                                          double limit, struct hawser_report *report);

#endif

/* modes/sweep/campbell_range.h - the range of speeds of a Campbell diagram, and its stations.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_CAMPBELL_RANGE_H
#define HAWSER_MODES_CAMPBELL_RANGE_H

#include <hawser/campbell.h>

/* Replace zeros by defaults and check the options; *limit as in struct hawser_campbell. */
enum hawser_status hawser__campbell_settle(struct hawser_campbell_options *options, double *limit,
                                           const struct hawser_scene *scene,
                                           struct hawser_report *report);

/* *x [*count]: speeds of the stations, m/s, ascending, below the limit; the first *asked are the
 * requested ones. Release with free(). */
enum hawser_status hawser__campbell_place(double **x, int *count, int *asked,
                                          const struct hawser_campbell_options *options,
                                          double limit, struct hawser_report *report);

#endif

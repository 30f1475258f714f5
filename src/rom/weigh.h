/* rom/weigh.h - what each mode does in a motion that it does not do statically. See weigh.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_WEIGH_H
#define HAWSER_ROM_WEIGH_H

#include <hawser/choose.h>

/* A measure, or a part of the largest load, that is round-off: no reason for anything. */
#define HAWSER__NEGLIGIBLE 1e-9

/* coordinate[rows][n] of all modes over a period; those that are not kept are not looked at. `spacing`:
 * how far on either side in omega the motion stands for. whole = 0: only what it can make unstable. */
enum hawser_status hawser__weigh(struct hawser_choice *choice, const double *coordinate, int rows,
                                 double omega, double spacing, int whole,
                                 struct hawser_report *report);

#endif

/* rom/weigh.h - what each mode does in a motion that it does not do statically. See weigh.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_WEIGH_H
#define HAWSER_ROM_WEIGH_H

#include <hawser/choose.h>

/* Which displacements count, in what is moved: bit 3*p + axis for x, y or z (0, 1, 2) at shape point p;
 * or those in each plane as a whole, where they are not faint. */
#define HAWSER__BY_PLANE (~0u)

/* coordinate[rows][n] of all modes over a period; those that are not kept are not looked at. `spacing`:
 * how far on either side in omega the motion stands for. whole = 0: only what it can make unstable. */
enum hawser_status hawser__weigh(struct hawser_choice *choice, const double *coordinate, int rows,
                                 double omega, double spacing, int whole, unsigned counted,
                                 struct hawser_report *report);

/* hawser_choice_weigh, of the displacements that count. */
enum hawser_status hawser__choice_weigh(struct hawser_choice *choice, const double *coordinate,
                                        int rows, double omega, int whole, unsigned counted,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

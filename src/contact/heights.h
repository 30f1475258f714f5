/* contact/heights.h - beds by their heights; see heights.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CONTACT_HEIGHTS_H
#define HAWSER_CONTACT_HEIGHTS_H

#include <hawser/surface.h>

#include "scene/tree.h"

/* The gap of x [3], its gradient n [3] and unless NULL its second derivatives H [3][3]. */
double hawser__heights_gap(double n[3], double (*H)[3], const struct hawser_heights *of,
                           const double x[3]);
/* Let the roundings begin at this distance, m, if there is as much room. */
void hawser__heights_round(struct hawser_heights *of, double round);
/* heights_read.c: the heights of a profile or grid, the obstacle `tree`, whose name in messages is
 * `section`; round as of hawser_heights_make. */
enum hawser_status hawser__heights_read(struct hawser__reader *reader, struct hawser_surface *surface,
                                        const struct hawser__tree *tree, const char *section,
                                        double round) HAWSER_MUST_CHECK;

/* --- surface_read.c: the section `obstacles` of a scene --- */

/* *surface [*count] is allocated here; the caller frees it and their heights, on failure too. round: m,
 * from a line of a bed to where its rounding begins, if there is as much room. */
enum hawser_status hawser__surfaces_read(struct hawser__reader *reader, struct hawser_surface **surface,
                                         int *count, const struct hawser__tree *tree, double round)
	HAWSER_MUST_CHECK;

#endif

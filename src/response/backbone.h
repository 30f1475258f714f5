/* response/backbone.h - branch points of a backbone.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_BACKBONE_H
#define HAWSER_RESPONSE_BACKBONE_H

#include <hawser/backbone.h>

/* Append the branch point at `start` [n + 1], u0 and Omega, where another curve goes in `direction`. */
enum hawser_status hawser__backbone_add(struct hawser_backbone *backbone, const double *start,
                                        const double *direction, double energy,
                                        struct hawser_report *report);

#endif

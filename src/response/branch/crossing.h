/* response/branch/crossing.h - where a multiplier crosses the unit circle within its own error.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_CROSSING_H
#define HAWSER_RESPONSE_CROSSING_H

#include "response/branch/station.h"

enum { HAWSER__CROSSING = 9 }; /* stations of a walk */

struct hawser__crossing {
	struct hawser__station walk[HAWSER__CROSSING], scratch;
};

void hawser__crossing_clear(struct hawser__crossing *crossing);

/* `event` was located between a and b by a sure test (station.h): where a multiplier leaves its
 * error bound. If it passes through all of that bound on the curve near by, *found becomes 1,
 * *event the place where its modulus is 1, which need not lie between a and b, and
 * crossing->scratch that orbit. */
enum hawser_status hawser__crossing_find(struct hawser__crossing *crossing,
                                         struct hawser_frf_event *event, int *found,
                                         struct hawser__orbit *orbit,
                                         const struct hawser__station *a,
                                         const struct hawser__station *b, double orbit_tolerance,
                                         double tolerance, struct hawser_report *report);

#endif

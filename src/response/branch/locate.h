/* response/branch/locate.h - the events between two neighbouring stations, by bracketing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_LOCATE_H
#define HAWSER_RESPONSE_LOCATE_H

#include "response/branch/station.h"

/* Locate the zero of test `kind` between a and b, where it changes its sign. All members of *event
 * but `after` are set; *found is 0 if there is no zero (a pole, or a neutral saddle in the torus
 * test). `scratch` is a station owned by the caller; `sure`: use the sure test function
 * (station.h). tolerance is relative, in Omega and in arc. */
enum hawser_status hawser__locate(struct hawser_frf_event *event, int *found,
                                  struct hawser__orbit *orbit,
                                  struct hawser__station *scratch,
                                  const struct hawser__station *a, const struct hawser__station *b,
                                  enum hawser_event_kind kind, int sure, double orbit_tolerance,
                                  double tolerance, struct hawser_report *report);

/* Change of the number of unstable multipliers by one event of this kind. */
int hawser__event_width(enum hawser_event_kind kind);

#endif

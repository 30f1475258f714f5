/* response/locate.h - the events between two neighbouring stations, by bracketing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_LOCATE_H
#define HAWSER_RESPONSE_LOCATE_H

#include "response/station.h"

/* Zero of test `kind` between a and b, where it changes sign. *event is filled but for `after`;
 * *found is 0 when the zero is none (a pole, or a neutral saddle in the torus test). `scratch` is a
 * station of the caller's; `sure`: of the sure test (station.h). tolerance is relative, in Omega and in
 * arc. */
enum hawser_status hawser__locate(struct hawser_frf_event *event, int *found,
                                  struct hawser__orbit *orbit,
                                  struct hawser__station *scratch,
                                  const struct hawser__station *a, const struct hawser__station *b,
                                  enum hawser_event_kind kind, int sure, double orbit_tolerance,
                                  double tolerance, struct hawser_report *report);

/* By how much one event of this kind changes the number of unstable multipliers. */
int hawser__event_width(enum hawser_event_kind kind);

#endif

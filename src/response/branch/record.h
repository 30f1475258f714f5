/* response/branch/record.h - the growing result of a continuation.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_RECORD_H
#define HAWSER_RESPONSE_RECORD_H

#include "response/branch/amplitude.h"
#include "response/branch/station.h"

/* Append a station, whose orbit's samples are still in `orbit`. */
enum hawser_status hawser__record_point(struct hawser_frf *frf, struct hawser__amplitude *amplitude,
                                        const struct hawser__station *station,
                                        const struct hawser__orbit *orbit,
                                        struct hawser_report *report);

/* Append an event; state [2n]: of its orbit, in the units of rom; NULL: none. */
enum hawser_status hawser__record_event(struct hawser_frf *frf,
                                        const struct hawser_frf_event *event, const double *state,
                                        const struct hawser_rom *rom, struct hawser_report *report);

/* At the end of a trace: events in the order of the curve, since one that a multiplier's error hides is
 * located beside the step that shows it; without those beyond the last point. */
void hawser__record_order(struct hawser_frf *frf);

/* Frequencies of the model become `periods` times as large, and motions are of so many periods.
 * `family`: they belong to a family, whose parameters stay. */
void hawser__frf_in_loads(struct hawser_frf *frf, int periods, int family);

#endif

/* water/near.h - the waves of a motion: at places that are asked for again and again, at times a little
 * later each. As hawser_waves_at, at a small part of its cost for seas with many components.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_WATER_NEAR_H
#define HAWSER_WATER_NEAR_H

#include <hawser/status.h>
#include <hawser/waves.h>

/* A workspace for this number of places, about which nothing is known yet. Threads must not share it;
 * the waves stay those of the caller. HAWSER_ERR_MEMORY. */
struct hawser__near;
enum hawser_status hawser__near_open(struct hawser__near **near, const struct hawser_waves *waves,
                                     int places, struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__near_free(struct hawser__near *near);

/* hawser_waves_at at x [3] (m) and t (s) of a place. In the seas of bench/waves within 2e-4 of the root
 * mean square of the velocity and 7e-4 of that of the acceleration (2e-3 and 5e-3 where they are
 * extrapolated above the mean surface). A place may be anywhere, but is quick if it moves little. */
void hawser__near_at(struct hawser_wave_flow *flow, struct hawser__near *near, int place,
                     const double x[3], double t);

#endif

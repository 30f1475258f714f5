/* ropeway/statics/history.h - friction that follows from the order in which a rope is paid in and out.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROPEWAY_HISTORY_H
#define HAWSER_ROPEWAY_HISTORY_H

#include <hawser/obstacles.h>

/* Walk the path of contact.sliding: history. st->held, st->path and st->line[0] are set; the caller
 * releases st. HAWSER_ERR_NO_SOLUTION (the report says at which value of the path), _CONVERGENCE,
 * _MEMORY. */
enum hawser_status hawser__obstacles_history(struct hawser_obstacles_statics *st,
                                             const struct hawser_obstacles *obstacles,
                                             struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

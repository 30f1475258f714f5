/* modes/methods.h - checks common to all methods for modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MODES_METHODS_H
#define HAWSER_MODES_METHODS_H

#include <hawser/modes.h>

/* Check that the scaled quantities of the statics are valid and that the cable is extensible.
 * Statuses: _ARGUMENT, _NO_SOLUTION, _NAN. */
enum hawser_status hawser__modes_check_statics(const struct hawser_statics *statics,
                                               struct hawser_report *report);

/* 1 if an attachment has an absorber; and the refusal of absorbers that undamped modes do not have.
 * Status: _ARGUMENT. */
int hawser__has_absorbers(const struct hawser_statics *statics);
enum hawser_status hawser__check_absorbers(const struct hawser_statics *statics,
                                           struct hawser_report *report);

#endif

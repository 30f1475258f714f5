/* response/event_error.h - how far a located event may be from the true one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_EVENT_ERROR_H
#define HAWSER_RESPONSE_EVENT_ERROR_H

#include "response/bracket.h"

/* *error, relative, of the Omega of the event that bracket->at holds: at s, where the test function is
 * f. The orbit is left with the defects of bracket->at. HAWSER_ERR_MEMORY, HAWSER_ERR_NAN. */
enum hawser_status hawser__event_error(double *error, struct hawser__bracket *bracket, double s,
                                       double f, struct hawser_report *report);

#endif

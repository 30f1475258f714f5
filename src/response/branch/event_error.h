/* response/branch/event_error.h - the estimated error of a located event.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_EVENT_ERROR_H
#define HAWSER_RESPONSE_EVENT_ERROR_H

#include "response/branch/bracket.h"

/* *error becomes the estimated relative error of Omega of the event in bracket->at, at s, where the
 * test function is f. Afterwards the discretisation of the orbit is that of bracket->at.
 * HAWSER_ERR_MEMORY, HAWSER_ERR_NAN. */
enum hawser_status hawser__event_error(double *error, struct hawser__bracket *bracket, double s,
                                       double f, struct hawser_report *report);

#endif

/* response/orbit/rest.h - the state of a model at rest under its load.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_REST_H
#define HAWSER_RESPONSE_REST_H

#include <hawser/rom.h>

/* y [2n] at the phase `tau` of a forcing of frequency omega: 0, but that the coordinates that are no
 * modes (hawser_rom_inertia) are where the load has them in steady state. These are part of what the
 * modes that are not kept do, which follow the load from the beginning; from 0 they would vibrate at
 * frequencies that the cable does not have. Returns 0, or -1 when memory runs out. */
int hawser__rest(double *y, const struct hawser_rom *rom, double tau, double omega);

#endif

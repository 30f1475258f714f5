/* rom/build/ramp.h - the forces of a model's ramp (struct hawser_ramp), for the integrators. In
 * forced.c. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_RAMP_H
#define HAWSER_ROM_RAMP_H

#include <hawser/rom.h>

/* Add the ramp at time t to acceleration [n] and, unless NULL, to its derivatives by_u and by_v
 * [n][n]. At the end of the ramp, where ds/dt is discontinuous, `over` selects the side. */
void hawser__rom_ramp(const struct hawser_rom *rom, double *acceleration, double *by_u, double *by_v,
                      const double *u, const double *v, double t, int over);

/* The contribution of its conservative terms, in s and s^2, to the energy at u. */
double hawser__rom_ramp_energy(const struct hawser_rom *rom, const double *u, double t);

#endif

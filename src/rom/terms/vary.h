/* rom/terms/vary.h - terms of the restoring force that vary with the phase tau and are not linear
 * in the coordinates. The functions of kernel.h do not contain them, since they do not know the
 * phase: a caller adds these terms to their results.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_VARY_H
#define HAWSER_ROM_VARY_H

#include <hawser/rom.h>

/* Whether the model has such terms. */
int hawser__rom_varies(const struct hawser_rom *rom);

/* Add all of them at the phase tau. */
void hawser__rom_vary_at(const struct hawser_rom *rom, double *restoring, double *tangent,
                         const double *u, double tau);

/* The same for arrays whose entries are `stride` doubles apart. */
void hawser__rom_vary_lane(const struct hawser_rom *rom, double *restoring, double *tangent,
                           const double *u, double tau, int stride);

/* The same for `count` states u [count][n] at equal distances over a period, the first at tau = 0:
 * restoring [count][n], and tangent [count][n][n] or NULL. */
void hawser__rom_vary_all(const struct hawser_rom *rom, double *restoring, double *tangent,
                          const double *u, int count);

#endif

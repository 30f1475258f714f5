/* rom/terms/vary.h - terms of the restoring force that vary with the phase tau and are not linear
 * in the coordinates. Of the functions of kernel.h only hawser__rom_tangents contains them: the others
 * do not know the phase, and a caller adds these terms to their results.
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
 * restoring [count][n], and tangent [count][n][n] or NULL. hawser__rom_tangents calls it, or, for eight
 * states from the one `first`, _eight: u and restoring [n][8], tangent [n][n][8] or NULL, of a model
 * without exact energy. */
void hawser__rom_vary_all(const struct hawser_rom *rom, double *restoring, double *tangent,
                          const double *u, int count);
void hawser__rom_vary_eight(const struct hawser_rom *rom, double *restoring, double *tangent,
                            const double *u, int first, int count);

#endif

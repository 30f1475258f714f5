/* rom/energy/exact_bend.h - bending stiffness in a model with the exact energy: see exact_bend.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_EXACT_BEND_H
#define HAWSER_ROM_EXACT_BEND_H

#include "rom/condense/bend.h"
#include "rom/energy/exact.h"

/* Add the stiffness by bending to matrix [n][n], in the order of the model, once the slopes at the
 * quadrature points are set. Nothing without cable.EI. Statuses: _MEMORY, _NAN. */
enum hawser_status hawser__exact_bend(double *matrix, const struct hawser_rom_exact *exact,
                                      const struct hawser_modes *modes,
                                      struct hawser_report *report);

/* Add to pull [n] the force on the coordinates by bending of a displacement with the strain
 * [points of the modes' grid][3], which is `at` [points][3] at the quadrature points. */
enum hawser_status hawser__exact_bend_pull(double *pull, const struct hawser_rom_exact *exact,
                                           const struct hawser_modes *modes, const double *strain,
                                           const double *at, struct hawser_report *report);

#endif

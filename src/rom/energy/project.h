/* rom/energy/project.h - the tensors of a reduced model from the modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_PROJECT_H
#define HAWSER_ROM_PROJECT_H

#include <hawser/rom.h>

#include "rom/condense/condense.h"

/* Fill Q and C of a model that hawser__rom_init has made with modes->n coordinates. The other modes
 * are condensed into C; if `condensed` is NULL, they are at rest. Modes beyond the first
 * condensed->n are second-order shapes (inertia.h): of their terms, those up to the fourth order
 * are kept, a shape counting as second order, that is T_jks of two modes and a shape. */
enum hawser_status hawser__rom_tensors(struct hawser_rom *rom, const struct hawser_modes *modes,
                                       const struct hawser__condensed *condensed,
                                       struct hawser_report *report);

/* stiffness [n][n]: second derivatives of the quadratic energy by quadrature. For converged modes
 * it is diag(omega^2), which the model uses; the difference is a check of modes and grid. */
void hawser__rom_stiffness(double *stiffness, const struct hawser_modes *modes);

/* Whether mirror symmetry can make tensor entries vanish: parity[n] becomes 1 for modes that are
 * antisymmetric about mid-span, 0 for symmetric ones. Returns 0, with all entries 0, for an
 * inclined span or if a mode has no definite symmetry. */
int hawser__rom_mirror(int *parity, const struct hawser_modes *modes);

#endif

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

/* pairing [pairs][pairs] of the first n modes, of which the lower triangle is given, += what one way to
 * pair four indices gives of the fourth derivative of V4; it is symmetric then. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__rom_pairing(double *pairing, const struct hawser_modes *modes, int n,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* Whether mirror symmetry can make tensor entries vanish: parity[n] becomes 1 for modes that are
 * antisymmetric about mid-span, 0 for symmetric ones. Returns 0, with all entries 0, for an
 * inclined span or if a mode has no definite symmetry. */
int hawser__rom_mirror(int *parity, const struct hawser_modes *modes);

#endif

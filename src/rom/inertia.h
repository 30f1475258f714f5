/* rom/inertia.h - inertia of the condensed modes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_INERTIA_H
#define HAWSER_ROM_INERTIA_H

#include <hawser/rom.h>

#include "rom/condense.h"

/* Lowest modes of the cable whose inertia is left to the choice of modes: shapes are orthogonal to
 * them. */
enum { HAWSER__LOWEST = 32 };

/* *with becomes the modes of `modes` and, behind them, second-order shapes as further ones (number 0),
 * where their inertia counts at the amplitudes that load[modes->n] and damping[modes->n] of the model
 * make for; `condensed` is of the same modes. Where it does not, with->n is 0, as it is where a mode is
 * neither loaded nor damped. *inertia says which. Clear *with. Statuses: HAWSER_ERR_NAN,
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__inertia_extend(struct hawser_modes *with,
                                          struct hawser_rom_inertia *inertia,
                                          const struct hawser_modes *modes,
                                          const struct hawser__condensed *condensed,
                                          const double *load, const double *damping,
                                          double allowed, struct hawser_report *report);

#endif

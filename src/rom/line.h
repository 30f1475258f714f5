/* rom/line.h - the loads of a model of a rope over sheaves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_LINE_H
#define HAWSER_ROM_LINE_H

#include <hawser/line_rom.h>

#include "ropeway/expand_modes.h"

/* Add the harmonics of options->load. pull: as of hawser__lexpand_drive, whose shape is the last
 * one of t then. line_load.c. */
enum hawser_status hawser__line_load(struct hawser_rom *rom, const struct hawser__lexpand *t,
                                     const struct hawser_line_modes *modes,
                                     const struct hawser_line_rom_options *options, const double *pull,
                                     struct hawser_report *report);
/* rom->contacts: the arcs on which the rope lies. line_lift.c. */
enum hawser_status hawser__line_contacts(struct hawser_rom *rom, const struct hawser_line_modes *modes,
                                         struct hawser_report *report);

#endif

/* rom/travel.h - what travelling along itself adds to a cable's model. See travel.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_TRAVEL_H
#define HAWSER_ROM_TRAVEL_H

#include <hawser/rom.h>

/* For a model that has its harmonics of loads already; nothing for a cable at rest. On failure the
 * model is the caller's to clear. */
enum hawser_status hawser__rom_travel(struct hawser_rom *rom, const struct hawser_modes *modes,
                                      const struct hawser_scene *scene,
                                      struct hawser_report *report);

/* The same of the condensed modes, which follow the forces of the speed's change and so vary the
 * stiffness of the first `moving` modes; after the above. */
enum hawser_status hawser__rom_travel_condensed(struct hawser_rom *rom,
                                                const struct hawser_modes *modes, int moving,
                                                const struct hawser_scene *scene,
                                                struct hawser_report *report);

/* Change of the scaled speed by braking. */
double hawser__travel_change(const struct hawser_modes *modes, const struct hawser_scene *scene);

#endif

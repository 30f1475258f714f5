/* rom/travel.h - terms that travel along its own length adds to a cable's model. See travel.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_TRAVEL_H
#define HAWSER_ROM_TRAVEL_H

#include <hawser/rom.h>

/* The model must have the harmonics of its loads; nothing is added for a cable at rest. On failure the
 * caller clears the model. */
enum hawser_status hawser__rom_travel(struct hawser_rom *rom, const struct hawser_modes *modes,
                                      const struct hawser_scene *scene,
                                      struct hawser_report *report);

/* The variation of the stiffness of the first `moving` modes by the condensed ones, which the forces of
 * the changing speed displace. To be called after the above. */
enum hawser_status hawser__rom_travel_condensed(struct hawser_rom *rom,
                                                const struct hawser_modes *modes, int moving,
                                                const struct hawser_scene *scene,
                                                struct hawser_report *report);

/* Change of the scaled speed by braking. */
double hawser__travel_change(const struct hawser_modes *modes, const struct hawser_scene *scene);

#endif

/* rom/terms/travel.h - terms of the model of a cable that travels along its length. See travel.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_TRAVEL_H
#define HAWSER_ROM_TRAVEL_H

#include <hawser/rom.h>

/* The harmonics of the loads must exist; nothing is added for a cable at rest. On failure the
 * caller clears the model. */
enum hawser_status hawser__rom_travel(struct hawser_rom *rom, const struct hawser_modes *modes,
                                      const struct hawser_scene *scene,
                                      struct hawser_report *report);

/* The variation of the stiffness of the first `moving` modes that is due to the condensed ones,
 * which the forces of the changing speed displace. To be called after the above. */
enum hawser_status hawser__rom_travel_condensed(struct hawser_rom *rom,
                                                const struct hawser_modes *modes, int moving,
                                                const struct hawser_scene *scene,
                                                struct hawser_report *report);

/* Shapes of the same space as the modes, which carry the inertia that the gyroscopic forces on the
 * condensed modes give them; with->n = 0 if none is needed. *turned is that of struct hawser_rom, for
 * the caller to free, on failure too. travel_modes.c. */
enum hawser_status hawser__travel_modes(struct hawser_modes *with, double **turned,
                                        const struct hawser_modes *modes,
                                        const struct hawser_scene *scene,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* Change of the scaled speed by braking. */
double hawser__travel_change(const struct hawser_modes *modes, const struct hawser_scene *scene);

#endif

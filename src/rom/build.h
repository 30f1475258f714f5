/* rom/build.h - what every model of a cable has, whatever its energy.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_BUILD_H
#define HAWSER_ROM_BUILD_H

#include <hawser/rom.h>

/* A model of modes->n coordinates with units, K and, where `scene` is not NULL, D. On failure the
 * model is clear, or the caller's to clear. */
enum hawser_status hawser__rom_begin(struct hawser_rom *rom, const struct hawser_modes *modes,
                                     const struct hawser_scene *scene,
                                     struct hawser_report *report);

/* The scene's load per length in the local frame, N/m, at scaled arclength s. */
void hawser__load_at(double local[3], const struct hawser_scene *scene,
                     const struct hawser_modes *modes, double s);

/* Load, labels and probes. */
enum hawser_status hawser__rom_finish(struct hawser_rom *rom, const struct hawser_modes *modes,
                                      const struct hawser_scene *scene,
                                      struct hawser_report *report);

#endif

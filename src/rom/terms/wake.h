/* rom/terms/wake.h - oscillators for the vortices behind a cable. See wake.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_WAKE_H
#define HAWSER_ROM_WAKE_H

#include <hawser/modes.h>
#include <hawser/rom.h>

/* Append them to a model with these modes that is not compiled yet; nothing if the scene has none.
 * HAWSER_ERR_ARGUMENT (no speed, too many coordinates), HAWSER_ERR_MEMORY. */
enum hawser_status hawser__wake_add(struct hawser_rom *rom, const struct hawser_modes *modes,
                                    const struct hawser_scene *scene, struct hawser_report *report);

#endif

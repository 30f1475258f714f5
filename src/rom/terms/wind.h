/* rom/terms/wind.h - the force of a wind on a moving cable, as terms of a model. See wind.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_WIND_H
#define HAWSER_ROM_WIND_H

#include <hawser/modes.h>
#include <hawser/rom.h>

/* Add the linear part to D, and with `whole` those of second and third order to the terms; nothing if
 * the scene has no wind, or with `whole` a wind of exact form (drag.h). HAWSER_ERR_ARGUMENT (too many
 * modes), HAWSER_ERR_MEMORY. */
enum hawser_status hawser__wind_add(struct hawser_rom *rom, const struct hawser_modes *modes,
                                    const struct hawser_scene *scene, int whole,
                                    struct hawser_report *report);
/* The same of a flow, which is cleared. */
struct hawser__flow_points;
enum hawser_status hawser__wind_take(struct hawser_rom *rom, struct hawser__flow_points *flow,
                                     int whole, struct hawser_report *report);

/* --- wake.c: oscillators for the vortices behind a cable --- */

/* Append them to a model with these modes that is not compiled yet; nothing if the scene has none.
 * HAWSER_ERR_ARGUMENT (no speed, too many coordinates), HAWSER_ERR_MEMORY. */
enum hawser_status hawser__wake_add(struct hawser_rom *rom, const struct hawser_modes *modes,
                                    const struct hawser_scene *scene, struct hawser_report *report);

#endif

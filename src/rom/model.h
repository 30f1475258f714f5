/* rom/model.h - making and unmaking a model; for the files that fill one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_MODEL_H
#define HAWSER_ROM_MODEL_H

#include <hawser/rom.h>

/* Zero *rom, give it n coordinates, D and K all zero, and units of 1. */
enum hawser_status hawser__rom_init(struct hawser_rom *rom, int n, struct hawser_report *report);

/* Room for `points` shape points: names all NULL, the arrays zero. */
enum hawser_status hawser__rom_init_shapes(struct hawser_rom *rom, int points,
                                           struct hawser_report *report);

/* Room for what condensed modes add at the shape points and along the line, all zero; after those have
 * theirs. */
enum hawser_status hawser__rom_init_second(struct hawser_rom *rom, struct hawser_report *report);

/* Room for the line, all zero. */
enum hawser_status hawser__rom_init_line(struct hawser_rom *rom, int points,
                                         struct hawser_report *report);

#endif

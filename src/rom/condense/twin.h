/* rom/condense/twin.h - the same mode of the cable in two models.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_TWIN_H
#define HAWSER_ROM_TWIN_H

#include <hawser/rom.h>

/* 1 + the index of coordinate j of `rom` among those of the full-order model `full` of the same
 * statics, negative if it has the opposite sign there; 0 if `full` does not resolve it. */
int hawser__twin(const struct hawser_rom *rom, int j, const struct hawser_rom *full);

#endif

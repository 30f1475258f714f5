/* rom/condense/known.h - the condensed modes whose frequencies and shapes are known. See known.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_KNOWN_H
#define HAWSER_ROM_KNOWN_H

#include <complex.h>

#include <hawser/rom.h>

/* H_s of known mode s at the frequency W: displacement per force that the series in `answer` of a
 * harmonic omits. */
double complex hawser__rom_known_lacks(const struct hawser_rom_known *known, int s, double W);

/* Allocate `modes` known modes, all zero, in a model that has its shape points and line. */
enum hawser_status hawser__rom_known_make(struct hawser_rom *rom, int modes,
                                      struct hawser_report *report);

/* Whether a harmonic of the model has an `answer`. */
int hawser__rom_answers_load(const struct hawser_rom *rom);

/* Release rom->known and the harmonics' forces on it. */
void hawser__rom_known_clear(struct hawser_rom *rom);

/* --- twin.c: the same mode of the cable in two models --- */

/* 1 + the index of coordinate j of `rom` among those of the full-order model `full` of the same
 * statics, negative if it has the opposite sign there; 0 if `full` does not resolve it. */
int hawser__twin(const struct hawser_rom *rom, int j, const struct hawser_rom *full);

#endif

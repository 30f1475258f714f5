/* rom/history.h - the forces of a model's history (struct hawser_rom_history). See history.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_HISTORY_H
#define HAWSER_ROM_HISTORY_H

#include <hawser/rom.h>

/* The value of a term at time t, or its time derivative; before the first and after the last time that
 * of the first and last cubic. */
double hawser__history_value(const struct hawser_rom_history *history, int term, double t, int rate);

/* Least distance of two times. */
double hawser__history_spacing(const struct hawser_rom_history *history);

/* Add the forces at time t to acceleration [n] and, unless NULL, to its derivatives by_u and by_v
 * [n][n]. */
void hawser__rom_history(const struct hawser_rom *rom, double *acceleration, double *by_u,
                         double *by_v, const double *u, const double *v, double t);

/* s times one term, in the same way. In forced.c. */
void hawser__rom_term(const struct hawser_ramp_term *term, double s, double *acceleration,
                      double *by_u, double *by_v, const double *u, const double *v, int n);

/* Free what a term owns, and the whole history. */
void hawser__rom_term_clear(struct hawser_ramp_term *term);
void hawser__rom_history_clear(struct hawser_rom *rom);

#endif

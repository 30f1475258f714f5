/* response/branch/amplitude.h - largest values over a period, from samples of the orbit.
 *
 * The samples are equidistant in phase, so that the trigonometric interpolant through them is as
 * accurate as the orbit. Its maximum is found on a finer grid and refined by Newton's method. The
 * largest sample itself would have an error of up to (pi/steps)^2/2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_AMPLITUDE_H
#define HAWSER_RESPONSE_AMPLITUDE_H

#include <hawser/rom.h>

struct hawser__amplitude;

/* Workspace for orbits of any length (grows as needed). NULL when out of memory. */
struct hawser__amplitude *hawser__amplitude_new(const struct hawser_rom *rom);
/* Another model with the same coordinates. */
void hawser__amplitude_take(struct hawser__amplitude *amplitude, const struct hawser_rom *rom);
void hawser__amplitude_free(struct hawser__amplitude *amplitude);

/* coordinate [n] and probe [shape points][3]: largest modulus over the period, from u at `rows`
 * equidistant phases from 0 on, samples [rows][n], at the scaled forcing frequency omega (0: a free
 * motion). Returns 0, or 1 when out of memory. */
int hawser__amplitude_find(struct hawser__amplitude *amplitude, double *coordinate, double *probe,
                           const double *samples, int rows, double omega);

/* swing [n]: half the difference between the largest and the smallest value over the period, from the
 * same samples. Returns 0, or 1 when out of memory. */
int hawser__amplitude_swing(struct hawser__amplitude *amplitude, double *swing, const double *samples,
                            int rows);

/* extreme [2]: smallest and largest tension over the period anywhere on the cable, N (SI), from the
 * same samples. Returns 0; 1 when out of memory; -1 if the model has no tension. */
int hawser__amplitude_tension(struct hawser__amplitude *amplitude, double extreme[2],
                              const double *samples, int rows, double omega);

/* The smallest angle of contact over the period (struct hawser_rom_contacts), and *sheave; INFINITY and
 * -1 if the model has no sheaves. Returns 0, or 1 when out of memory. */
int hawser__amplitude_contact(struct hawser__amplitude *amplitude, double *least, int *sheave,
                              const double *samples, int rows);

#endif

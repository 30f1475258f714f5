/* response/amplitude.h - largest values over a period, from the orbit's samples on the mesh.
 *
 * The mesh is uniform in phase, so the trigonometric interpolant through the samples is as accurate
 * as the orbit itself; its maximum is found on a grid eight times finer and polished by Newton.
 * Reading the largest sample instead would be off by up to (pi/steps)^2/2.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_AMPLITUDE_H
#define HAWSER_RESPONSE_AMPLITUDE_H

#include <hawser/rom.h>

struct hawser__amplitude;

/* Room for orbits of up to any length (grows as needed). NULL when out of memory. */
struct hawser__amplitude *hawser__amplitude_new(const struct hawser_rom *rom);
void hawser__amplitude_free(struct hawser__amplitude *amplitude);

/* coordinate [n] and probe [shape points][3]: largest modulus over the period, from u at `rows`
 * equidistant phases from 0 on, samples [rows][n], at the scaled forcing frequency omega, 0 of a free
 * motion. Returns 0, or 1 when out of memory. */
int hawser__amplitude_find(struct hawser__amplitude *amplitude, double *coordinate, double *probe,
                           const double *samples, int rows, double omega);

/* extreme [2]: least and largest tension over the period anywhere on the cable, N (SI), from the same
 * samples. Returns 0; 1 when out of memory; -1 where the model has no tension. */
int hawser__amplitude_tension(struct hawser__amplitude *amplitude, double extreme[2],
                              const double *samples, int rows, double omega);

#endif

/* rom/build/model.h - allocation and release of models, for the files that fill them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_MODEL_H
#define HAWSER_ROM_MODEL_H

#include <hawser/rom.h>

/* Zero *rom, give it n coordinates, D and K all zero, and units of 1. _most: a model of a file, which
 * may have more coordinates than one of a cable (kernel.h). */
enum hawser_status hawser__rom_init(struct hawser_rom *rom, int n, struct hawser_report *report);
enum hawser_status hawser__rom_init_most(struct hawser_rom *rom, int n, int most,
                                         struct hawser_report *report);

/* Allocate `points` shape points: names all NULL, the arrays zero. */
enum hawser_status hawser__rom_init_shapes(struct hawser_rom *rom, int points,
                                           struct hawser_report *report);

/* Allocate the contribution of condensed modes at the shape points and along the line, all zero;
 * after those. */
enum hawser_status hawser__rom_init_second(struct hawser_rom *rom, struct hawser_report *report);

/* Allocate the line, all zero. */
enum hawser_status hawser__rom_init_line(struct hawser_rom *rom, int points,
                                         struct hawser_report *report);

/* Another harmonic, zero but for these; NULL if out of memory. It moves the others. */
struct hawser_harmonic *hawser__rom_harmonic(struct hawser_rom *rom, int k, enum hawser_phase phase);

/* xyz [3], in global axes, of a displacement local [3] along e, n, z at shape point p. */
void hawser__shapes_global(double *xyz, const struct hawser_rom_shapes *shapes, int p,
                           const double local[3]);

/* --- the forces of a model's ramp (struct hawser_ramp), for the integrators. In forced.c --- */

/* Add the ramp at time t to acceleration [n] and, unless NULL, to its derivatives by_u and by_v
 * [n][n]. At the end of the ramp, where ds/dt is discontinuous, `over` selects the side. */
void hawser__rom_ramp(const struct hawser_rom *rom, double *acceleration, double *by_u, double *by_v,
                      const double *u, const double *v, double t, int over);

/* The contribution of its conservative terms, in s and s^2, to the energy at u. */
double hawser__rom_ramp_energy(const struct hawser_rom *rom, const double *u, double t);

#endif

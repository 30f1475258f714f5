/* rom/terms/terms.h - forces that are products of any coordinates and velocities. See terms.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_TERMS_H
#define HAWSER_ROM_TERMS_H

#include <hawser/rom.h>

/* 1: the model has forces beyond D, K, Q, C and the parts f, D, K, Q of harmonics. */
int hawser__rom_more(const struct hawser_rom *rom);

/* Where their derivatives are added: by_u and by_v [n][n], times `sign`, and by_omega [n]; each may be
 * NULL. The values of one quantity are `stride` apart, in force, u and v too: 1, or HAWSER_LANES for as
 * many states at once. */
struct hawser__more {
	double *force; /* [n] += on the right side of the equations */
	double *by_u, *by_v, *by_omega;
	double sign;
	int stride;
};
void hawser__rom_more_add(const struct hawser_rom *rom, const struct hawser__more *to,
                          const double *u, const double *v, const double *tau, double omega);
/* The same and the drag on the left side, with derivatives of the sign -1 and of stride 1, at `count`
 * states u, v [count][n] of a period at equal distances, the first at the phase 0. */
void hawser__rom_more_left(const struct hawser_rom *rom, const struct hawser__more *all,
                           const double *u, const double *v, int count, double omega);

/* The potential energy of the terms without velocities, if they derive from one; see `mass` of the
 * model. */
double hawser__terms_potential(const struct hawser_rom *rom, const double *u);

/* (M w)_j, or w_j if the model has no mass matrix. */
double hawser__rom_weighed(const struct hawser_rom *rom, const double *w, int j);

/* HAWSER_ERR_ARGUMENT if the model has such forces, which `what` does not take. */
enum hawser_status hawser__more_refuse(const struct hawser_rom *rom, const char *what,
                                       struct hawser_report *report);

/* The number of periods (rom.h), at least 1; and HAWSER_ERR_ARGUMENT if it is more, which `what` does
 * not take. */
int hawser__rom_periods(const struct hawser_rom *rom);
enum hawser_status hawser__periods_refuse(const struct hawser_rom *rom, const char *what,
                                          struct hawser_report *report);

/* Indices and values of all terms: HAWSER_ERR_ARGUMENT. */
enum hawser_status hawser__terms_check(const struct hawser_rom *rom, struct hawser_report *report);

#endif

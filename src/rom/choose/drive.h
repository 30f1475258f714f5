/* rom/choose/drive.h - excitation of the modes of a model. See drive.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_DRIVE_H
#define HAWSER_ROM_DRIVE_H

#include <complex.h>

#include <hawser/rom.h>

/* F_j of the forcing Re F_j exp(i k Omega t) on mode j. */
double complex hawser__drive(const struct hawser_rom *rom, int j, int k, double omega);

/* a [n]: the linear response Re a exp(i Omega t) to this forcing; K must be diagonal. */
enum hawser_status hawser__respond(const struct hawser_rom *rom, double complex *a, double omega,
                                   struct hawser_report *report);

/* load [n]: equivalent load of each mode at its own frequency: the load that alone would give the same
 * linear response as all loads with the gyroscopic coupling. */
enum hawser_status hawser__drives(const struct hawser_rom *rom, double *load,
                                  struct hawser_report *report);

/* At phase tau of a motion u with rate = du/dtau: add to the restoring force R [n] all terms except f
 * of the harmonics and the diagonal of D; add to its tangent J [n][n] the symmetric terms that vary
 * with the phase. */
void hawser__vary(const struct hawser_rom *rom, double *R, double *J, const double *u,
                  const double *rate, double tau, double omega);

/* Effect of 2 V G sin(Omega t) in D and V Omega G cos(Omega t) in K on the pair s, p at
 * omega_s + omega_p = m Omega, as amplitude of the stiffness with the same effect:
 * V |G_sp| |omega_s - omega_p|. */
double hawser__sway(const struct hawser_rom *rom, int s, int p, int m);

/* --- cycle.c: a forced periodic orbit as a Fourier series, to start a continuation by another
 * program --- */

/* u_j(tau) = cosine[0][j] + sum over h of cosine[h][j] cos(h tau) + sine[h][j] sin(h tau). */
struct hawser__cycle {
	int n, order;   /* coordinates; highest h */
	double *cosine; /* [order+1][n] */
	double *sine;   /* [order+1][n] */
};

/* The orbit at Omega = omega, by Newton's method from rest; if that fails, with a forcing that
 * grows from zero. HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__cycle_find(struct hawser__cycle *cycle, const struct hawser_rom *rom,
                                      double omega, struct hawser_report *report);
void hawser__cycle_clear(struct hawser__cycle *cycle);

#endif

/* rom/drive.h - what drives the modes of a model. See drive.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_DRIVE_H
#define HAWSER_ROM_DRIVE_H

#include <complex.h>

#include <hawser/rom.h>

/* F_j of the forcing Re F_j exp(i Omega t) on mode j. */
double complex hawser__drive(const struct hawser_rom *rom, int j, double omega);

/* a [n]: the linear response Re a exp(i Omega t) to it, in a model with K diagonal. */
enum hawser_status hawser__respond(const struct hawser_rom *rom, double complex *a, double omega,
                                   struct hawser_report *report);

/* load [n]: what drives each mode at its own frequency, with what gyroscopic terms bring from others:
 * the load that alone would make its linear response as large. */
enum hawser_status hawser__drives(const struct hawser_rom *rom, double *load,
                                  struct hawser_report *report);

/* At phase tau of a motion u, with rate = du/dtau: add to the restoring force R [n] everything but the
 * harmonics' f of k = 1 and the diagonal of D, to its tangent J [n][n] what varies with the phase and
 * is symmetric. */
void hawser__vary(const struct hawser_rom *rom, double *R, double *J, const double *u,
                  const double *rate, double tau, double omega);

/* What 2 V G sin(Omega t) in D and V Omega G cos(Omega t) in K do to the pair s, p at
 * omega_s + omega_p = m Omega, as the amplitude of a stiffness that would:
 * V |G_sp| |omega_s - omega_p|. */
double hawser__sway(const struct hawser_rom *rom, int s, int p, int m);

#endif

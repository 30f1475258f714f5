/* response/floquet/floquet.h - hawser_floquet_product without its allocation and checks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_FLOQUET_H
#define HAWSER_RESPONSE_FLOQUET_H

#include <hawser/orbit.h>
#include <hawser/rom.h>

/* Doubles that `work` must hold. */
size_t hawser__floquet_work(int segments, int m);

enum hawser_status hawser__floquet(double *log_modulus, double *argument, double *segment,
                                   int segments, int m, double *work, struct hawser_report *report);

/* The kind of a multiplier (Krein's signature): v* i J v over the square of the norm of its
 * eigenvector v, where K and D are symmetric and D is constant. On one side of the real axis it is
 * near 1 or near -1; multipliers of one sign do not leave the unit circle where they meet, and the
 * share of the other sign in v, (1 - |kind|)/2, tells how strongly they are coupled (Yakubovich and
 * Starzhinskii, Linear Differential Equations with Periodic Coefficients (1975), ch. III). 0: not
 * defined, or not known. */
#define HAWSER__CONDENSED 2.0 /* of the free motion of a coordinate that was condensed: it decays,
                               * and takes no part in any event */

/* That of the eigenvector v [2][2 w], real and imaginary part, of w displacements, which are multiplied
 * by their frequencies scale[p], or scale[member[p]], and velocities. */
double hawser__floquet_kind(const double *v, const double *scale, const int *member, int w);

/* kind [m] of the multipliers of the product of segment [segments][m][m] in the model; 0 where K is not
 * symmetric, or D not symmetric and constant. work is [2 m m + 38 m]. */
void hawser__floquet_kinds(double *kind, double *work, const double *segment, int segments,
                           const double *log_modulus, const double *argument,
                           const struct hawser_rom *rom, double omega);

/* Sort [m] by falling modulus; complex pairs stay together. kind [m], or NULL, goes with them. */
void hawser__floquet_sort(double *log_modulus, double *argument, double *kind, int m);

#endif

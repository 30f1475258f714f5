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

/* log_modulus, argument and, unless NULL, kind [m] of the eigenvalues of the product [m][m] over a
 * period, row-major, which is overwritten: its displacements are scaled by their frequencies
 * scale[p], or scale[member[p]]. v [m][m] and work [36 m] are workspace. Returns dgeev's info. */
int hawser__floquet_vectors(double *log_modulus, double *argument, double *kind, double *product, int m,
                            const double *scale, const int *member, double *v, double *work);

/* The same of the product of segment [segments][m][m] in the model. Returns 1, or 0 if round-off hides
 * the smallest multipliers. The kinds are 0 where K is not symmetric, or D not symmetric and constant.
 * work is [2 m m + 37 m]. */
int hawser__floquet_directly(double *log_modulus, double *argument, double *kind, double *work,
                             const double *segment, int segments, const struct hawser_rom *rom,
                             double omega);

/* Sort [m] by falling modulus; complex pairs stay together. kind [m], or NULL, goes with them. */
void hawser__floquet_sort(double *log_modulus, double *argument, double *kind, int m);

#endif

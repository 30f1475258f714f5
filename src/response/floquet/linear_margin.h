/* response/floquet/linear_margin.h - the margins of a model to a stability boundary: growth that is not
 * counted, and the uncertainty of the count. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_LINEAR_MARGIN_H
#define HAWSER_RESPONSE_LINEAR_MARGIN_H

#include <hawser/linear.h>

#include "response/torus/circle.h"
#include "response/floquet/monodromy.h"

/* After hawser_linear_growth (real parts) or hawser_linear_multipliers (logarithms of moduli, which
 * count above 1e-8 and their error, circle.h): the smallest value that counts, minus its error, and
 * the largest of the others, plus its error. Infinite if there is none. */
void hawser__linear_margin(const struct hawser_linear *linear, double margin[2]);

/* Numbers of the last multipliers that count as outside and that are undecided. */
struct hawser__circle hawser__linear_circle(const struct hawser_linear *linear);

/* What the search for tongues reads of a point (study/map/ridge.h): Omega, then of each coordinate a
 * frequency at rest [n], its component [n], and of the multipliers the logarithms [2n] and
 * arguments [2n]. Frequencies and multipliers of a component belong to its coordinates together,
 * in no order. */
#define HAWSER__EXPONENTS(n) (1 + 6*(n))
/* After hawser_linear_multipliers of the same model and Omega: to [HAWSER__EXPONENTS(n)].
 * HAWSER_ERR_CONVERGENCE: the eigenvalues at rest. */
enum hawser_status hawser__linear_exponents(struct hawser_linear *linear, double *to,
                                            const struct hawser_rom *rom, double omega,
                                            struct hawser_report *report);

/* The equation about rest as series: *system points into *linear, until the next call with it.
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__linear_series(struct hawser_linear *linear,
                                         struct hawser__variational *system,
                                         const struct hawser_rom *rom, double omega,
                                         struct hawser_report *report);

/* Multipliers for a search, with an error of about 1e-3: those of the *m states that are not
 * condensed. */
enum hawser_status hawser__linear_rough(struct hawser_linear *linear, double *log_modulus,
                                        double *argument, int *m, const struct hawser_rom *rom,
                                        double omega, struct hawser_report *report);

/* Whether expensive multipliers may be replaced by those of a condensed model. */
void hawser__linear_haste(struct hawser_linear *linear, int on);
/* Coordinates of the last multipliers. *neglected: estimated change of the logarithms by the
 * others, which respond statically. */
int hawser__linear_kept(const struct hawser_linear *linear, double *neglected);

#endif

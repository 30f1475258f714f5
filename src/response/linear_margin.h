/* response/linear_margin.h - how far from a boundary of stability a model is: what grows without
 * being counted, and by how much the count may be wrong. SPDX-License-Identifier: GPL-3.0-or-later
 * */
#ifndef HAWSER_RESPONSE_LINEAR_MARGIN_H
#define HAWSER_RESPONSE_LINEAR_MARGIN_H

#include <hawser/linear.h>

#include "response/circle.h"
#include "response/monodromy.h"

/* After hawser_linear_growth (real parts) or hawser_linear_multipliers (logarithms of moduli, which
 * count beyond 1e-8 and their error, circle.h): the least of those that count, less the error; the
 * largest of the others, plus the error. Infinite where there is none. */
void hawser__linear_margin(const struct hawser_linear *linear, double margin[2]);

/* Of the last multipliers, those that count as outside and those that are undecided. */
struct hawser__circle hawser__linear_circle(const struct hawser_linear *linear);

/* The equation about rest as series: *system points into *linear, until the next call with it.
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__linear_series(struct hawser_linear *linear,
                                         struct hawser__variational *system,
                                         const struct hawser_rom *rom, double omega,
                                         struct hawser_report *report);

/* Multipliers for a search, right to about 1e-3: the *m of the coordinates that are followed. */
enum hawser_status hawser__linear_rough(struct hawser_linear *linear, double *log_modulus,
                                        double *argument, int *m, const struct hawser_rom *rom,
                                        double omega, struct hawser_report *report);

/* Whether multipliers of a high cost may be those of a condensed model. */
void hawser__linear_haste(struct hawser_linear *linear, int on);
/* Coordinates that the last multipliers are of; *neglected: by how much the others, which follow
 * those statically, may move the logarithms. */
int hawser__linear_kept(const struct hawser_linear *linear, double *neglected);

#endif

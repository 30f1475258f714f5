/* response/linear_margin.h - how far from a boundary of stability a model is: what grows without being
 * counted, and by how much the count may be wrong. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_LINEAR_MARGIN_H
#define HAWSER_RESPONSE_LINEAR_MARGIN_H

#include <hawser/linear.h>

/* After hawser_linear_growth (real parts) or hawser_linear_multipliers (logarithms of moduli, which
 * count beyond HAWSER_OUTSIDE): the least of those that count, less the error; the largest of the
 * others, plus the error. Infinite where there is none. */
void hawser__linear_margin(const struct hawser_linear *linear, double margin[2]);

/* Whether multipliers of a high cost may be those of a condensed model. */
void hawser__linear_haste(struct hawser_linear *linear, int on);
/* Coordinates that the last multipliers are of; *neglected: by how much the others, which follow those
 * statically, may move the logarithms. */
int hawser__linear_kept(const struct hawser_linear *linear, double *neglected);

#endif

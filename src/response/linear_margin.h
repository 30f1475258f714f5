/* response/linear_margin.h - how far from a boundary of stability a model is: what grows without being
 * counted, and by how much the count may be wrong. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_LINEAR_MARGIN_H
#define HAWSER_RESPONSE_LINEAR_MARGIN_H

#include <hawser/linear.h>

/* After hawser_linear_growth (real parts) or hawser_linear_multipliers (logarithms of moduli, which
 * count beyond HAWSER_OUTSIDE): the least of those that count, less the error; the largest of the
 * others, plus the error. Infinite where there is none. */
void hawser__linear_margin(const struct hawser_linear *linear, double margin[2]);

#endif

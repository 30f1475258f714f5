/* output/drawing/axis.h - axes of pictures in the units that the user has chosen (units.h).
 *
 * A picture asks here for each of its axes, and for the unit of a number in its texts: this is the one
 * place where titles get their unit and values their factor.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_AXIS_H
#define HAWSER_OUTPUT_AXIS_H

#include "output/fields/units.h"

/* The title of an axis ends with the unit, "Tension T (kN)", in gnuplot's markup. Values in SI, or in
 * those of a model without units, are divided by `per` to be shown in that unit. */
enum { HAWSER__AXIS_SIZE = 192, HAWSER__MARKUP_SIZE = 3*HAWSER__UNIT_SIZE };
struct hawser__axis {
	char title[HAWSER__AXIS_SIZE], unit[HAWSER__MARKUP_SIZE];
	double per;
};

/* The axis of a quantity, in gnuplot's markup, with this SI unit: "" shows none, "1" is a pure number.
 * If the user has chosen no unit, forces and what is made of them have the prefix k or M where the
 * `largest` value is 1000 or more. A frequency in Hz loses the symbol of a circular one. */
struct hawser__axis hawser__axis_of(const char *quantity, const char *si, double largest);

#endif

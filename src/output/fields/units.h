/* output/fields/units.h - the units in which tables and pictures show results (--units). JSON is in SI.
 *
 * What is shown in SI elsewhere asks here, by the text of its SI unit ("N", "rad/s", "m/s^2"), what
 * the user has chosen instead. Chosen units of length, force, mass and frequency are also those in
 * compounds ("kN.ft" for N.m), unless a unit was chosen for these.
 *
 * The choice belongs to the program: it is made once, before anything is shown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_UNITS_H
#define HAWSER_OUTPUT_UNITS_H

#include <stddef.h>

#include <hawser/status.h>

struct hawser__table;

/* Choose by a list such as "kN, ft, Hz"; NULL and no call: SI. HAWSER_ERR_ARGUMENT names the word
 * that is no unit, its dimension if nothing has it, or the two units of one dimension. */
enum hawser_status hawser__units_choose(const char *list,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

enum { HAWSER__UNIT_SIZE = 32 };
/* Values in the SI unit are divided by `per` to be shown in the unit `name`. */
struct hawser__shown_unit {
	double per;
	char name[HAWSER__UNIT_SIZE];
	int changed; /* 0: it is the SI unit itself, as it was written */
	int chosen;  /* 1: the user has chosen this unit, perhaps the SI unit */
};
/* `si` may be any text; one that is no unit of results is not changed. */
struct hawser__shown_unit hawser__shown_unit(const char *si);

/* The end of a column's name for a unit: "_rad_s" for "rad/s"; "" for none. */
void hawser__unit_end(char *text, size_t size, const char *unit);
/* Cut the unit off a column's name that ends with it in one of its spellings. */
void hawser__unit_cut(char *column, const char *si);

/* The text with all numbers that have an SI unit in the chosen units: "12 m", "3 to 5 N", "1, 2 and
 * 3 rad/s". They get one digit more than they had, and six at least. The caller frees it; NULL if
 * memory ran out. */
char *hawser__units_text(const char *text);

/* Another process has shown the values, so that it is not known which units they have. */
void hawser__units_elsewhere(void);
/* Add comments: the units chosen, and those that nothing before in this result has. */
void hawser__units_comments(struct hawser__table *table);

/* --- axis.c: axes of pictures in the units that the user has chosen (units.h) ---
 *
 * A picture asks here for each of its axes, and for the unit of a number in its texts: this is
 * the one place where titles get their unit and values their factor. */

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

/* scene/units.h - numbers with units. All input conversions of units are done here.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_UNITS_H
#define HAWSER_SCENE_UNITS_H

#include <stddef.h>

/* A unit system, read from the database of udunits2 with the first unit that is none of the common
 * ones. Zero is a valid initial state; release with hawser__units_clear. */
struct hawser__units {
	struct ut_system *system;
};

enum hawser__number {
	HAWSER__NUMBER_OK = 0,
	HAWSER__NUMBER_SYNTAX,    /* not a number, or invalid text after it */
	HAWSER__NUMBER_NAN,
	HAWSER__NUMBER_OVERFLOW,  /* beyond double precision */
	HAWSER__NUMBER_UNKNOWN,   /* no such unit */
	HAWSER__NUMBER_DIMENSION, /* a unit of another dimension */
	HAWSER__NUMBER_DATABASE   /* the database of udunits2 cannot be read */
};

/* Read "18 km/h" for the unit "m/s" as 5. A plain number is in `unit`. ".inf" is a number. */
enum hawser__number hawser__units_read(struct hawser__units *units, double *value,
                                       const char *text, const char *unit);

/* By what a number in the common unit `from` is multiplied to be in `to`; 0 if this pair is no
 * common one. */
double hawser__units_common(const char *from, const char *to);

/* What follows the number in a text. */
const char *hawser__units_behind(const char *text);

/* Write the sentence that explains a failure, to follow the quoted text. */
void hawser__units_explain(char *sentence, size_t size, enum hawser__number failure,
                           const char *text, const char *unit);

/* Copy a text of the user for a message: control characters masked, at most 40 characters. */
enum { HAWSER__SHOWN = 56 };
const char *hawser__shown(char shown[HAWSER__SHOWN], const char *text);

void hawser__units_clear(struct hawser__units *units);

#endif

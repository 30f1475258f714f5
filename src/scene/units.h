/* scene/units.h - numbers with units, the one place where dimensions are converted.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_UNITS_H
#define HAWSER_SCENE_UNITS_H

#include <stddef.h>
#include <hawser/status.h>

/* A unit system, read from udunits' database when the first unit is met. All zero is a valid
 * start; release with hawser__units_clear. */
struct hawser__units {
	struct ut_system *system;
};

enum hawser__number {
	HAWSER__NUMBER_OK = 0,
	HAWSER__NUMBER_SYNTAX,    /* no number, or something strange after it */
	HAWSER__NUMBER_NAN,
	HAWSER__NUMBER_OVERFLOW,  /* beyond double precision */
	HAWSER__NUMBER_UNKNOWN,   /* no such unit */
	HAWSER__NUMBER_DIMENSION, /* a unit of something else */
	HAWSER__NUMBER_DATABASE   /* udunits' database can't be read */
};

/* "18 km/h" with unit "m/s" gives 5. A number alone is in `unit`. ".inf" is a number. */
enum hawser__number hawser__units_read(struct hawser__units *units, double *value,
                                       const char *text, const char *unit);

/* The sentence for a failure, to follow a quotation of the text. */
void hawser__units_explain(char *sentence, size_t size, enum hawser__number failure,
                           const char *text, const char *unit);

/* A user's text as it may stand in a message: control characters masked, cut at 40 characters. */
enum { HAWSER__SHOWN = 56 };
const char *hawser__shown(char shown[HAWSER__SHOWN], const char *text);

void hawser__units_clear(struct hawser__units *units);

#endif

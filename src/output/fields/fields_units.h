/* output/fields/fields_units.h - values of JSON with their units, for what reads them in this process:
 * hawser sweep, whose columns have units in their names.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_FIELDS_UNITS_H
#define HAWSER_OUTPUT_FIELDS_UNITS_H

/* 1: hawser__fields_json writes a number with a unit as an object of these three members, for
 * the result is not to be written; 0: again as a number. */
#define HAWSER__VALUE_KEY "value"   /* the number, or null */
#define HAWSER__UNIT_KEY "=unit"    /* "rad/s" */
#define HAWSER__SUFFIX_KEY "suffix" /* of columns, "_rad_s" */
void hawser__fields_with_units(int with);

#endif

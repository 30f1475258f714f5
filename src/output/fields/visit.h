/* output/fields/visit.h - reading a result that would be written: rows of its table, elements of its
 * lists.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_VISIT_H
#define HAWSER_OUTPUT_VISIT_H

#include "output/output.h"

/* What is done with each row: `row` gets its cells [columns], and returns nonzero to see no
 * more. */
struct hawser__visitor {
	int (*row)(void *to, const struct hawser__cell *cell, size_t columns);
	void *to;
};
/* Returns 0, or -1 if memory ran out. */
int hawser__table_visit(const struct hawser__table *table, struct hawser__visitor *by);

/* The elements of an array of the result, also of one whose elements are generated: these are
 * stored from now on. A failure is recorded. */
json_t *hawser__json_elements(struct hawser__json *json, json_t *array);

/* --- values of JSON with their units, for what reads them in this process: hawser sweep, whose
 * columns have units in their names --- */

/* 1: hawser__fields_json writes a number with a unit as an object of these three members, for
 * the result is not to be written; 0: again as a number. */
#define HAWSER__VALUE_KEY "value"   /* the number, or null */
#define HAWSER__UNIT_KEY "=unit"    /* "rad/s" */
#define HAWSER__SUFFIX_KEY "suffix" /* of columns, "_rad_s" */
void hawser__fields_with_units(int with);

#endif

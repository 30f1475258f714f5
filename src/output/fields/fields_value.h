/* output/fields/fields_value.h - values of the fields of a row, for tables and JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_FIELDS_VALUE_H
#define HAWSER_OUTPUT_FIELDS_VALUE_H

#include "output/fields/fields.h"

/* A row, and the structure to which it belongs. */
struct hawser__at {
	const void *row, *parent;
	size_t index, inner; /* of a matrix: the index of the inner row; else 0 */
};

/* A scalar in the unit in which it is shown. The number is set even if it is unknown. */
struct hawser__value {
	enum { HAWSER__IS_UNKNOWN, HAWSER__IS_NUMBER, HAWSER__IS_INTEGER, HAWSER__IS_FLAG,
	       HAWSER__IS_WORD } is;
	double number;
	long integer;
	const char *word;
};
struct hawser__value hawser__value_of(const struct hawser__field *field,
                                      const struct hawser__at *at, const struct hawser__view *view);
struct hawser__value hawser__integer_value(long integer, unsigned flags);
/* Number k of the `count` numbers of a vector, in its unit. */
struct hawser__value hawser__vector_at(const struct hawser__field *field,
                                       const struct hawser__at *at, const double *values, int count,
                                       int k, const struct hawser__view *view);
enum hawser__unit hawser__vector_unit(const struct hawser__field *field, int count, int k,
                                      const struct hawser__view *view);
/* Address of the field; of a vector, that of its numbers [count], or NULL. */
const void *hawser__member(const struct hawser__field *field, const struct hawser__at *at,
                           int count);

/* State of a list whose rows are computed during output. */
struct hawser__maker {
	const struct hawser__list *list;
	struct hawser__at at; /* the row to which the list belongs */
	struct hawser__view view;
};

/* room for a row that is not stored */
union hawser__room {
	char bytes[HAWSER__ROW_SIZE];
	long double align;
	void *pointer;
};

size_t hawser__count_of(const struct hawser__list *list, const struct hawser__at *of);
/* Returns 0 if there is no such row. */
int hawser__make_row(struct hawser__at *at, union hawser__room *room,
                     const struct hawser__list *list, const struct hawser__at *of, size_t index);

int hawser__is_shown(const struct hawser__field *field, const struct hawser__view *view);
int hawser__is_end(const struct hawser__field *field);

#endif

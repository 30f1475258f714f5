/* output/fields/fields.h - a result described as a table of fields.
 *
 * A field states the name, meaning and unit of a quantity, and its location in a C structure. The
 * columns and rows of tables, the members of JSON objects and the list of `hawser help columns
 * COMMAND` follow from the fields. One function converts values from the model's scale to SI, by
 * their units. To add a column, add a row to the table of fields:
 *
 *   static const struct hawser__field point[] = {
 *       {"Omega", "Omega", "forcing frequency", HAWSER__AT(struct row, omega), .unit = HAWSER__RAD_S},
 *       {"certificate.error", "error", "estimated error", HAWSER__AT(struct row, error)},
 *       HAWSER__END,
 *   };
 *
 * A row is an element of an array of structures that belongs to a parent structure. A field may
 * also be the element of another array of the parent, or a member of the parent. A value that is
 * not stored as it is shown (a difference of two numbers) is computed by a function, or a function
 * fills a row structure (struct hawser__list).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_FIELDS_H
#define HAWSER_OUTPUT_FIELDS_H

#include <limits.h>
#include <stddef.h>

#include "output/output.h"

/* Units. Those before HAWSER__FIXED are for values in the model's scale: these are converted, and
 * if the model has no units their columns have no suffix. The others are for values in SI. */
enum hawser__unit {
	HAWSER__NONE,
	HAWSER__M, HAWSER__S, HAWSER__RAD_S, HAWSER__PER_S, HAWSER__M_S, HAWSER__J,
	HAWSER__BASE, /* from here on derived from the units before */
	HAWSER__M_S2 = HAWSER__BASE,
	HAWSER__RAD_S_M2, /* (rad/s)/m^2, of a backbone */
	HAWSER__PER_M,
	/* for values that are in this unit already; no suffix if the model has no units */
	HAWSER__HZ, HAWSER__M_ALREADY,
	HAWSER__FIXED,
	HAWSER__NEWTON = HAWSER__FIXED, HAWSER__METRE, HAWSER__METRE_S, HAWSER__RADIAN_S,
	HAWSER__HERTZ, /* shows a value in rad/s in Hz */
	HAWSER__RADIAN, HAWSER__SECOND, HAWSER__BYTE, HAWSER__NEWTON_M,
	HAWSER__METRE_S2, HAWSER__METRE_S3, HAWSER__METRE_S4, /* acceleration, jerk, snap */
	HAWSER__NEWTON_METRE, HAWSER__NEWTON_SECOND, HAWSER__NEWTON_METRE_SECOND, /* moment, impulses */
	HAWSER__MOMENT_PER_METRE, HAWSER__KILOGRAM, HAWSER__KILOGRAM_M,
	HAWSER__UNITS
};

/* Factors from the model's units to SI. */
struct hawser__scale {
	double factor[HAWSER__BASE];
	int si;   /* 0: the model has no units */
	int pure; /* 1, with si = 0: its values are pure numbers */
};
/* All factors are 1: for results in SI. */
extern const struct hawser__scale hawser__si;
/* Scale from the units of length (m), frequency (rad/s) and energy (J). */
struct hawser__scale hawser__scale_of(double length, double omega, double energy, int si);
/* Convert a value; all values of results are converted here. */
double hawser__in_unit(double value, enum hawser__unit unit, const struct hawser__scale *scale);
/* The suffix of a column, such as "_rad_s" or "", and the name of the unit, "rad/s". */
const char *hawser__unit_suffix(enum hawser__unit unit, const struct hawser__scale *scale);
const char *hawser__unit_name(enum hawser__unit unit);
/* The unit with the longest suffix that the name of a column ends in. */
enum hawser__unit hawser__unit_of_column(const char *column);

enum hawser__kind {
	HAWSER__REAL, HAWSER__INT, HAWSER__FLAG, HAWSER__NOT, /* NOT: true if the member is 0 */
	HAWSER__TEXT, HAWSER__CHARS, HAWSER__LABEL, HAWSER__CONSTANT,
	HAWSER__INDEX,   /* index of the inner row of a matrix, from 1 */
	HAWSER__NUMBERS, HAWSER__INTEGERS, /* double [], int [] in the row: an array in JSON, and with a
	                                    * struct hawser__vector columns too */
	HAWSER__VECTOR,  /* const double *, with a struct hawser__vector; NULL: not shown */
	HAWSER__OBJECTS, /* JSON only: a list of objects */
	HAWSER__ROWS,    /* JSON only: a list of arrays, of the values of the fields that have keys */
	HAWSER__KEYS,    /* JSON only: a list of these keys */
	HAWSER__ARRAYS,  /* JSON only: an object with an array for each field of a list; what the list has
	                  * from the parent is no array but one member */
	HAWSER__OBJECT,  /* JSON only: an object with fields of its own, see `inner` */
	HAWSER__CALL     /* JSON only: a function writes it */
};

/* Flags: how unknown values are shown, and others. A value is unknown if it is NAN, NULL,
 * HAWSER__NO_INTEGER or, for an index, negative. Without a flag that covers it, an unknown value is
 * an error; with one it is an empty cell in tables. */
enum {
	HAWSER__NULL = 1,     /* null in JSON */
	HAWSER__OMIT = 2,     /* no member in JSON; also for empty texts and lists */
	HAWSER__INFINITE = 4, /* infinite numbers are unknown too */
	HAWSER__MISSING = 8,  /* infinite numbers are the word "missing" */
	HAWSER__FROM_1 = 16,  /* an index from 0, shown from 1 */
	HAWSER__BARE = 64,    /* the column has no suffix for its unit */
	HAWSER__BRIEF = 128,  /* the list of fields does not repeat the fields of this object or list */
	HAWSER__STREAM = 32   /* elements of this list are computed during output; the row must exist
	                       * until then */
};
enum { HAWSER__NO_INTEGER = INT_MIN };
enum { HAWSER__NESTED = '\n' }; /* separator of the names of nested objects */

struct hawser__view;
struct hawser__field;

/* Numbers of a row with a common name, such as displacements of probes or coordinates. `context` is
 * that of the view. */
struct hawser__vector {
	const char *shown; /* for the list of columns, such as "J" */
	int (*count)(const void *context);
	void (*name)(char *text, size_t size, const void *context, int k); /* NULL: JSON only */
	/* Number k of row `index` of `parent` if the vector is not stored; else NULL. */
	double (*number)(const void *context, const void *parent, size_t index, int k);
	/* 1: in JSON an object by name, 0: an array; "mid\nx" is `x` of an object `mid`, "mid\n" an element
	 * of an array `mid`, and "" is left out. */
	int object;
	enum hawser__unit rate; /* unit of the second half if it differs; else HAWSER__NONE */
	enum hawser__unit (*unit)(const void *context, int k); /* unit of each number if they differ; or
	                                                        * NULL */
	const char *pair[2];    /* in JSON objects with these two members, of two numbers each; or NULL */
};

/* A list of rows with the same fields. It belongs to a row `parent` of another table. */
struct hawser__list {
	const struct hawser__field *field;
	size_t size; /* bytes of a row; at most HAWSER__ROW_SIZE if a function makes the rows */
	/* The number of rows, and row `index`. `row` returns a stored row, or fills `row` [size], which
	 * is zero, or returns NULL if there is no such row. Text in columns is not copied: rows that
	 * are filled have pointers to text, not char arrays. Without these functions the parent has, at
	 * the offsets below, a pointer to the stored rows and an int with their number. With size 0
	 * there are no stored rows, only arrays with one element per row. */
	size_t (*count)(const void *parent);
	const void *(*row)(void *row, const void *parent, size_t index);
	size_t rows_at, count_at;
	int within; /* 1: the rows themselves are at rows_at, not a pointer to them */
	/* Rows of a matrix. `matrix`: all pairs of an outer row and an inner row, whose number is the
	 * int of the parent at inner_at; the inner index changes first. `part`: the inner rows of the
	 * outer row to which the list belongs. `column`: the outer rows, whose number is at count_at,
	 * of an inner row. */
	size_t inner_at;
	int matrix, part, column;
};
/* Size of a row that a function makes; rows that are too large do not compile. */
#define HAWSER__MADE_SIZE(type) \
	(sizeof(type) + 0*sizeof(char[sizeof(type) <= HAWSER__ROW_SIZE ? 1 : -1]))
/* Rows that `maker` fills; their number is the parent's int `number`. */
#define HAWSER__MADE_ROWS(type, of, parent, number, maker) \
	{.field = (of), .count_at = offsetof(parent, number), .row = (maker), \
	 .size = HAWSER__MADE_SIZE(type)}
#define HAWSER__MATRIX_ROWS(type, outer, inner, of) \
	{.field = (of), .count_at = offsetof(type, outer), .inner_at = offsetof(type, inner), .matrix = 1}
#define HAWSER__MATRIX_PART(type, inner, of) \
	{.field = (of), .inner_at = offsetof(type, inner), .part = 1}
#define HAWSER__MATRIX_COLUMN(type, outer, inner, of) \
	{.field = (of), .count_at = offsetof(type, outer), .inner_at = offsetof(type, inner), .column = 1}
#define HAWSER__STORED_ROWS(type, member, number, of) \
	{.field = (of), .size = sizeof *((type *)0)->member, .rows_at = offsetof(type, member), \
	 .count_at = offsetof(type, number)}
#define HAWSER__ROWS_WITHIN(type, member, number, of) \
	{.field = (of), .size = sizeof *((type *)0)->member, .rows_at = offsetof(type, member), \
	 .within = 1, .count_at = offsetof(type, number)}
enum { HAWSER__ROW_SIZE = 1024, HAWSER__COLUMNS = 64, /* largest number of fields of a table */
       HAWSER__NAME_SIZE = 96 };

/* Settings of the output of rows. */
struct hawser__view {
	struct hawser__scale scale;
	const void *context; /* for vectors; must exist until output */
	unsigned options;    /* bits of the options of this result, see `when` */
};

struct hawser__field {
	const char *key;    /* of JSON: "certificate.error" is `error` in an object; NULL: not in JSON */
	const char *column; /* of tables, without unit; NULL: not in tables; "": named by the vector */
	const char *doc;    /* one line */
	enum hawser__unit unit;
	enum hawser__kind kind;
	/* Location: a member of the row, a member of the parent, or element item + stride*index of an
	 * array to which a member of the parent points. Stride 0 is 1, or for a vector its count. */
	enum { HAWSER__IN_ROW, HAWSER__IN_PARENT, HAWSER__ALONG_ROWS, HAWSER__ALONG_OUTER,
	       HAWSER__ALONG_INNER } from; /* outer, inner: by this index of a matrix */
	size_t offset, size; /* offset of the member, size of the member or element, bytes */
	int stride, item;
	size_t step, within; /* for elements that are structures: their size, offset of the member */
	unsigned flags;
	unsigned when;      /* shown if one of these options is set; 0: always */
	int (*given)(const void *row, const void *parent); /* in JSON only if this returns nonzero (an
	                                                    * object with HAWSER__NULL: null); or NULL */
	int place;          /* columns are sorted by this number, then in the order of the fields */
	const char *(*label)(int value);
	double (*number)(const void *row); /* for a number that is not stored; else NULL */
	const char *(*word)(const void *row); /* for a text that is not stored; else NULL */
	/* The column's name if it depends on the result, from the view's context; "": not in this
	 * table. `column` is then the name in the list of columns. */
	void (*named)(char *text, size_t size, const void *context);
	const struct hawser__vector *vector;
	const struct hawser__list *list;
	/* Fields of a HAWSER__OBJECT; key "" means members of the same object. `through` 1: fields of
	 * the structure to which the member points (NULL: not shown); 0: of the structure at `offset`. */
	const struct hawser__field *inner;
	int through;
	void (*call)(struct hawser__json *json, json_t *into, const void *row);
	const char *axis; /* title of the axis in pictures, without unit, in gnuplot's markup */
	/* The SI unit of a column without .unit, of which the name need not tell it; "": none. */
	const char *(*si)(const void *context);
};
#define HAWSER__END {.key = NULL, .doc = NULL}

/* Location of a value. Its kind follows from its C type; integers may have any size. */
#define HAWSER__KIND_OF(value) _Generic((value), double: HAWSER__REAL, int: HAWSER__INT, \
	unsigned: HAWSER__INT, long: HAWSER__INT, unsigned char: HAWSER__INT, \
	signed char: HAWSER__INT, size_t: HAWSER__INT, const char *: HAWSER__TEXT, \
	char *: HAWSER__CHARS, double *: HAWSER__NUMBERS, int *: HAWSER__INTEGERS, \
	const double *: HAWSER__VECTOR)
#define HAWSER__PLACE(type, member) \
	.offset = offsetof(type, member), .size = sizeof ((type *)0)->member
#define HAWSER__AT(type, member) \
	.kind = HAWSER__KIND_OF(((type *)0)->member), HAWSER__PLACE(type, member)
#define HAWSER__IN(type, member) HAWSER__AT(type, member), .from = HAWSER__IN_PARENT
#define HAWSER__ALONG(type, member) \
	.kind = HAWSER__KIND_OF(*((type *)0)->member), .from = HAWSER__ALONG_ROWS, \
	.offset = offsetof(type, member), .size = sizeof *((type *)0)->member
#define HAWSER__LABEL_ALONG(type, member, function) \
	.kind = HAWSER__LABEL, .label = (function), .from = HAWSER__ALONG_ROWS, \
	.offset = offsetof(type, member), .size = sizeof *((type *)0)->member
/* A member of the structures in an array `member`, with one element per row, or per outer or inner
 * row of a matrix. Give the kind before it if it does not follow from the type. */
#define HAWSER__STEP(type, array, element, member) \
	.offset = offsetof(type, array), .size = sizeof ((element *)0)->member, \
	.step = sizeof(element), .within = offsetof(element, member)
#define HAWSER__OUTER(type, array, element, member) .from = HAWSER__ALONG_OUTER, \
	.kind = HAWSER__KIND_OF(((element *)0)->member), HAWSER__STEP(type, array, element, member)
#define HAWSER__INNER(type, array, element, member) .from = HAWSER__ALONG_INNER, \
	.kind = HAWSER__KIND_OF(((element *)0)->member), HAWSER__STEP(type, array, element, member)
#define HAWSER__INNER_LABEL(type, array, element, member, function) \
	.from = HAWSER__ALONG_INNER, .kind = HAWSER__LABEL, .label = (function), \
	HAWSER__STEP(type, array, element, member)
#define HAWSER__VECTOR_ALONG(type, member, of) \
	.kind = HAWSER__VECTOR, .from = HAWSER__ALONG_ROWS, .vector = &(of), \
	.offset = offsetof(type, member), .size = sizeof(double)
#define HAWSER__VECTOR_AT(type, member, of) HAWSER__AT(type, member), .vector = &(of)
#define HAWSER__VECTOR_OF(of) .kind = HAWSER__VECTOR, .vector = &(of)
#define HAWSER__CONSTANT_IS(number) .kind = HAWSER__CONSTANT, .item = (number)
/* A constant, shown as the word that the function returns for it. */
#define HAWSER__WORD_OF(number, function) HAWSER__CONSTANT_IS(number), .label = (function)
#define HAWSER__FLAG_AT(type, member) .kind = HAWSER__FLAG, HAWSER__PLACE(type, member)
/* Two successive numbers, as an array. */
#define HAWSER__PAIR_AT(type, first, second) .kind = HAWSER__NUMBERS, \
	.offset = offsetof(type, first), \
	.size = offsetof(type, second) - offsetof(type, first) + sizeof(double)
#define HAWSER__INTEGER_PAIR_AT(type, first, second) .kind = HAWSER__INTEGERS, \
	.offset = offsetof(type, first), \
	.size = offsetof(type, second) - offsetof(type, first) + sizeof(int)
#define HAWSER__NOT_AT(type, member) .kind = HAWSER__NOT, HAWSER__PLACE(type, member)
/* A number that a function computes from the row. HAWSER__NUMBERS_BY defines such a function from
 * one of a pointer to a structure. */
#define HAWSER__BY(function) .kind = HAWSER__REAL, .number = (function)
#define HAWSER__TEXT_BY(function) .kind = HAWSER__TEXT, .word = (function)
#define HAWSER__FLAG_BY(function) .kind = HAWSER__FLAG, .number = (function)
#define HAWSER__COUNT_BY(function) .kind = HAWSER__INT, .number = (function)
#define HAWSER__NUMBERS_BY(name, function) \
	static double name(const void *of) { return function(of); }
/* Functions that return one expression of a row `of`: a number, text or count, and whether a field is
 * given. */
#define HAWSER__OF(name, kind, type, expression) \
	static kind name(const void *row) { const type *of = row; return expression; }
#define HAWSER__GIVEN(name, type, condition) static int name(const void *row, const void *parent) \
	{ const type *of = row; (void)parent; return condition; }
/* A text that a function returns for the integer. HAWSER__LABELS defines such a function from one
 * of an enumeration. */
#define HAWSER__LABEL_AT(type, member, function) \
	.kind = HAWSER__LABEL, HAWSER__PLACE(type, member), .label = (function)
#define HAWSER__WORDS_AT(type, member, function) /* of an array */ \
	.kind = HAWSER__INTEGERS, HAWSER__PLACE(type, member), .label = (function)
#define HAWSER__LABELS(name, function, type) \
	static const char *name(int value) { return function((type)value); }
#define HAWSER__OBJECTS_OF(of) .kind = HAWSER__OBJECTS, .list = &(of)
#define HAWSER__ROWS_OF(of) .kind = HAWSER__ROWS, .list = &(of)
#define HAWSER__KEYS_OF(of) .kind = HAWSER__KEYS, .list = &(of), .flags = HAWSER__BRIEF
#define HAWSER__ARRAYS_OF(of) .kind = HAWSER__ARRAYS, .list = &(of)
/* A list of objects for the stored rows member[number]. */
#define HAWSER__STORED(type, member, number, of) .kind = HAWSER__OBJECTS, \
	.list = &(const struct hawser__list)HAWSER__STORED_ROWS(type, member, number, of)
#define HAWSER__STORED_WITHIN(type, member, number, of) .kind = HAWSER__OBJECTS, \
	.list = &(const struct hawser__list)HAWSER__ROWS_WITHIN(type, member, number, of)
/* An object with fields of the same row, of a structure in it, and of a structure to which it
 * points. */
#define HAWSER__OBJECT_OF(of) .kind = HAWSER__OBJECT, .inner = (of)
#define HAWSER__PART_OF(type, member, of) \
	.kind = HAWSER__OBJECT, .inner = (of), HAWSER__PLACE(type, member)
#define HAWSER__THROUGH(type, member, of) \
	.kind = HAWSER__OBJECT, .inner = (of), .through = 1, HAWSER__PLACE(type, member)
#define HAWSER__CALLS(function) .kind = HAWSER__CALL, .call = (function)

/* --- tables --- */

/* Write the row of column names. */
void hawser__fields_columns(struct hawser__table *table, const struct hawser__field *field,
                            const struct hawser__view *view);
/* Columns and all rows of the list. The rows are computed during output; `parent` must exist until
 * then. */
void hawser__fields_table(struct hawser__table *table, const struct hawser__list *list,
                          const void *parent, const struct hawser__view *view);
/* Rows of a list, stored at once, in the columns of `columns` (NULL: its own). Fields are assigned
 * by column name; columns that the list does not have are empty. */
void hawser__fields_rows(struct hawser__table *table, const struct hawser__field *columns,
                         const struct hawser__list *list, const void *parent,
                         const struct hawser__view *view);
/* One such row. */
void hawser__fields_row(struct hawser__table *table, const struct hawser__field *columns,
                        const struct hawser__field *field, const void *row,
                        const struct hawser__view *view);
/* Columns and rows of curves: of each its points, and behind the point that precedes it each event. Of
 * `parent` the curves, of these the points and events, all of them made; after: offset in an event of
 * the index, an int, of that point on the curve. */
struct hawser__curve_lists {
	const struct hawser__list *curves, *points, *events;
	size_t after;
};
void hawser__fields_curves(struct hawser__table *table, const struct hawser__curve_lists *of,
                           const void *parent, const struct hawser__view *view);
/* Comments "name = value unit" for the numbers of a row, named by their keys. */
void hawser__fields_comments(struct hawser__table *table, const struct hawser__field *field,
                             const void *row, const struct hawser__view *view);

/* The axis for values up to `largest` of the first field with this column or key that the result
 * has and that has a title, see hawser__axis_of. Pure numbers have the unit "–". */
struct hawser__axis hawser__fields_axis(const struct hawser__field *field, const char *name,
                                        const struct hawser__view *view, double largest);

/* --- JSON --- */

/* Members of the object `into` from one row. */
void hawser__fields_json(struct hawser__json *json, json_t *into, const struct hawser__field *field,
                         const void *row, const struct hawser__view *view);

/* Read a row back from an object that hawser__fields_json wrote: numbers in the row's own units
 * (NAN if missing), flags, labels and vectors; computed values and texts are not read. Members that
 * the object does not have keep their values. Of a list with stored rows, the last row is read into
 * the first one. Rows and vectors that are NULL are skipped. */
void hawser__fields_read(void *row, const struct hawser__field *field, const json_t *object,
                         const struct hawser__view *view);

/* The field of a value by its place in JSON, such as "counterweight.force", "end[1]" or
 * "towers[0].T_in"; NULL if the fields have no such place. */
const struct hawser__field *hawser__fields_at(const struct hawser__field *field, const char *place);

/* --- the list of all fields --- */

/* One line per field: name, unit, meaning; `what` is the heading. Inner lists are indented. */
void hawser__fields_print(FILE *stream, const char *what, const struct hawser__field *field,
                          int json);

/* --- values of the fields of a row, for tables and JSON --- */

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

/* output/fields.h - a result described as a table of fields.
 *
 * A field says once what a quantity is called, what it means, its unit, and where it stands in a
 * structure of C. The columns of tables, the rows below them, the members of JSON objects and the
 * list that `hawser help columns COMMAND` prints are made from it, and values are converted from the
 * model's scale to SI in one function, by unit. To add a column: add a row to the table of fields.
 *
 *   static const struct hawser__field point[] = {
 *       {"Omega", "Omega", "forcing frequency", HAWSER__AT(struct row, omega), .unit = HAWSER__RAD_S},
 *       {"certificate.error", "error", "estimated error", HAWSER__AT(struct row, error)},
 *       HAWSER__END,
 *   };
 *
 * A row is an element of an array of structures; besides, a field may be the element of another
 * array of the structure to which the rows belong, or a member of it. What is not stored as it is
 * shown (a difference of two numbers) is put into a row structure by a function, see struct
 * hawser__list.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_OUTPUT_FIELDS_H
#define HAWSER_OUTPUT_FIELDS_H

#include <limits.h>
#include <stddef.h>

#include "output/output.h"

/* Units. Those above HAWSER__FIXED belong to values in the model's scale: they are converted, and a
 * model without units has no suffix on the column. The others are in SI. */
enum hawser__unit {
	HAWSER__NONE,
	HAWSER__M, HAWSER__S, HAWSER__RAD_S, HAWSER__PER_S, HAWSER__M_S, HAWSER__J,
	HAWSER__BASE, /* the ones from here on follow from those above */
	HAWSER__M_S2 = HAWSER__BASE,
	HAWSER__RAD_S_M2, /* (rad/s)/m^2, of a backbone */
	HAWSER__PER_M,
	/* of values that are in this unit already; no suffix where the model has no units */
	HAWSER__HZ, HAWSER__M_ALREADY,
	HAWSER__FIXED,
	HAWSER__NEWTON = HAWSER__FIXED, HAWSER__METRE, HAWSER__METRE_S, HAWSER__RADIAN_S,
	HAWSER__HERTZ, /* of a value in rad/s */
	HAWSER__RADIAN, HAWSER__SECOND, HAWSER__BYTE,
	HAWSER__UNITS
};

/* SI per unit of the model. */
struct hawser__scale {
	double factor[HAWSER__BASE];
	int si;   /* 0: the model has no units */
	int pure; /* then its values are pure numbers */
};
/* Everything 1: results that are in SI already. */
extern const struct hawser__scale hawser__si;
/* From the units of length (m), frequency (rad/s) and energy (J). */
struct hawser__scale hawser__scale_of(double length, double omega, double energy, int si);
/* The conversion of every value of a result. */
double hawser__in_unit(double value, enum hawser__unit unit, const struct hawser__scale *scale);
/* "_rad_s", "" where there is none; "rad/s". */
const char *hawser__unit_suffix(enum hawser__unit unit, const struct hawser__scale *scale);
const char *hawser__unit_name(enum hawser__unit unit);

enum hawser__kind {
	HAWSER__NUMBER, HAWSER__INTEGER, HAWSER__FLAG, HAWSER__NOT, /* NOT: true where the member is 0 */
	HAWSER__TEXT, HAWSER__CHARS, HAWSER__LABEL, HAWSER__CONSTANT,
	HAWSER__INDEX,   /* of the inner row of a matrix, from 1 */
	HAWSER__NUMBERS, HAWSER__INTEGERS, /* double [], int [] in the row: an array of JSON; with a
	                                    * struct hawser__vector columns too */
	HAWSER__VECTOR,  /* const double *, with a struct hawser__vector; NULL: nothing */
	HAWSER__OBJECTS, /* JSON only: a list of objects */
	HAWSER__ARRAYS,  /* JSON only: an object with an array for each field of a list */
	HAWSER__OBJECT,  /* JSON only: an object with fields of its own, see `inner` */
	HAWSER__CALL     /* JSON only: a function writes it */
};

/* A value is unknown if it is NAN, NULL, HAWSER__NO_INTEGER or, of an index, negative. It is refused
 * as an error unless the field says what stands for it; in a table then nothing. */
enum {
	HAWSER__NULL = 1,     /* null in JSON */
	HAWSER__OMIT = 2,     /* no member; of an empty text or list neither */
	HAWSER__INFINITE = 4, /* an infinite number is unknown too */
	HAWSER__MISSING = 8,  /* an infinite number is the word "missing" */
	HAWSER__FROM_1 = 16,  /* an index, shown from 1 */
	HAWSER__BARE = 64,    /* the column has no suffix of its unit */
	HAWSER__BRIEF = 128,  /* the list of fields does not repeat the fields of this object or list */
	HAWSER__STREAM = 32   /* elements of this list are made on output; the row must stay until then */
};
enum { HAWSER__NO_INTEGER = INT_MIN };
enum { HAWSER__WITHIN = '\n' }; /* between the parts of a name of nested objects */

struct hawser__view;
struct hawser__field;

/* Numbers of a row that are named alike: displacements of probes, coordinates. `context` is the
 * view's. */
struct hawser__vector {
	const char *shown; /* for the list of columns: "J" */
	int (*count)(const void *context);
	void (*name)(char *text, size_t size, const void *context, int k); /* NULL: JSON only */
	/* Number k of row `index` of `parent`, of a vector that is not stored; else NULL. */
	double (*number)(const void *context, const void *parent, size_t index, int k);
	int object; /* in JSON an object by name, else an array; "mid\nx" is `x` of an object `mid` */
	enum hawser__unit rate; /* of the second half, where that differs; else HAWSER__NONE */
	enum hawser__unit (*unit)(const void *context, int k); /* of each, where it differs; or NULL */
	const char *pair[2];    /* in JSON objects with these members, of two numbers each; or NULL */
};

/* A list of rows of the same fields, which belongs to a row `parent` of another table. */
struct hawser__list {
	const struct hawser__field *field;
	size_t size; /* bytes of a row; at most HAWSER__ROW_SIZE where a function makes it */
	/* Number of rows, and row `index`: a stored one, or put into `row`, which is [size] bytes and
	 * zero; NULL: none. Text in columns is not copied: a row that is put there has pointers to text,
	 * no char arrays. Without these functions the parent has a pointer to the stored rows (size 0:
	 * only arrays along them) and an int with their number, at these offsets. */
	size_t (*count)(const void *parent);
	const void *(*row)(void *row, const void *parent, size_t index);
	size_t rows_at, count_at;
	int within; /* the rows themselves are at rows_at, not a pointer to them */
	/* Rows of a matrix: each of those rows times an int of the parent at inner_at, the index of the
	 * inner one changing first. `part`: the inner rows of the outer one to which the list belongs;
	 * `column`: the outer rows, whose number is at count_at, of an inner one. */
	size_t inner_at;
	int matrix, part, column;
};
/* Rows that `maker` puts into a structure, as many as the parent's int `number`. */
#define HAWSER__MADE_ROWS(type, of, parent, number, maker) \
	{.field = (of), .count_at = offsetof(parent, number), .row = (maker), \
	 .size = sizeof(type) + 0*sizeof(char[sizeof(type) <= HAWSER__ROW_SIZE ? 1 : -1])}
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
enum { HAWSER__ROW_SIZE = 1024, HAWSER__COLUMNS = 64, /* fields of a table, at most */
       HAWSER__NAME_SIZE = 96 };

/* How rows are shown. */
struct hawser__view {
	struct hawser__scale scale;
	const void *context; /* of vectors; must stay until output */
	unsigned options;    /* bits that are set in this result, see `when` */
};

struct hawser__field {
	const char *key;    /* of JSON; "certificate.error" is `error` of an object; NULL: not in JSON */
	const char *column; /* of tables, without its unit; NULL: not in tables; "": by the vector */
	const char *doc;    /* one line */
	enum hawser__unit unit;
	enum hawser__kind kind;
	/* Where it is: a member of the row, a member of the parent, or element item + stride*index of an
	 * array to which a member of the parent points (stride 0: 1, and of a vector its count). */
	enum { HAWSER__IN_ROW, HAWSER__IN_PARENT, HAWSER__ALONG_ROWS, HAWSER__ALONG_OUTER,
	       HAWSER__ALONG_INNER } from; /* outer, inner: by that index of a matrix */
	size_t offset, size; /* bytes, of the member or the element */
	int stride, item;
	size_t step, within; /* where the elements are structures: their size, the member's offset */
	unsigned flags;
	unsigned when;      /* shown if one of these options is set; 0: always */
	int (*given)(const void *row, const void *parent); /* in JSON only if this is true; or NULL */
	int place;          /* columns are in ascending order of this, then in that of the fields */
	const char *(*label)(int value);
	double (*number)(const void *row); /* of a number that is not stored; else NULL */
	const char *(*word)(const void *row); /* the same of a text */
	/* Column of a name that the result knows, from the view's context, in place of `column` (which is
	 * for the list of columns); "": not in this table. */
	void (*named)(char *text, size_t size, const void *context);
	const struct hawser__vector *vector;
	const struct hawser__list *list;
	/* Fields of HAWSER__OBJECT, where key "" means members of the same object; `through`: they are
	 * those of the structure to which the member points (NULL: nothing), else of the one at
	 * `offset`. */
	const struct hawser__field *inner;
	int through;
	void (*call)(struct hawser__json *json, json_t *into, const void *row);
	const char *axis; /* title of its axis in pictures, without the unit, in gnuplot's markup */
};
#define HAWSER__END {.key = NULL, .doc = NULL}

/* Where a value is; its kind follows from its type. Integers may have any size. */
#define HAWSER__KIND_OF(value) _Generic((value), double: HAWSER__NUMBER, int: HAWSER__INTEGER, \
	unsigned: HAWSER__INTEGER, long: HAWSER__INTEGER, unsigned char: HAWSER__INTEGER, \
	signed char: HAWSER__INTEGER, size_t: HAWSER__INTEGER, const char *: HAWSER__TEXT, \
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
/* A member of the structures of an array `member`, along the rows, or the outer or inner ones of a
 * matrix; to be preceded by its kind where that is not the type's. */
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
/* The word that the function gives for a constant. */
#define HAWSER__WORD_OF(number, function) HAWSER__CONSTANT_IS(number), .label = (function)
#define HAWSER__FLAG_AT(type, member) .kind = HAWSER__FLAG, HAWSER__PLACE(type, member)
/* Two numbers that follow each other, as an array. */
#define HAWSER__PAIR_AT(type, first, second) .kind = HAWSER__NUMBERS, \
	.offset = offsetof(type, first), \
	.size = offsetof(type, second) - offsetof(type, first) + sizeof(double)
#define HAWSER__INTEGER_PAIR_AT(type, first, second) .kind = HAWSER__INTEGERS, \
	.offset = offsetof(type, first), \
	.size = offsetof(type, second) - offsetof(type, first) + sizeof(int)
#define HAWSER__NOT_AT(type, member) .kind = HAWSER__NOT, HAWSER__PLACE(type, member)
/* A number that a function computes from the row. HAWSER__NUMBERS_BY makes one from a function of a
 * pointer to a structure. */
#define HAWSER__BY(function) .kind = HAWSER__NUMBER, .number = (function)
#define HAWSER__TEXT_BY(function) .kind = HAWSER__TEXT, .word = (function)
#define HAWSER__FLAG_BY(function) .kind = HAWSER__FLAG, .number = (function)
#define HAWSER__COUNT_BY(function) .kind = HAWSER__INTEGER, .number = (function)
#define HAWSER__NUMBERS_BY(name, function) \
	static double name(const void *of) { return function(of); }
/* Text by a function of the integer. HAWSER__LABELS makes one from a function of an enumeration. */
#define HAWSER__LABEL_AT(type, member, function) \
	.kind = HAWSER__LABEL, HAWSER__PLACE(type, member), .label = (function)
#define HAWSER__LABELS(name, function, type) \
	static const char *name(int value) { return function((type)value); }
#define HAWSER__OBJECTS_OF(of) .kind = HAWSER__OBJECTS, .list = &(of)
#define HAWSER__ARRAYS_OF(of) .kind = HAWSER__ARRAYS, .list = &(of)
/* Objects for the stored rows member[number]. */
#define HAWSER__STORED(type, member, number, of) .kind = HAWSER__OBJECTS, \
	.list = &(const struct hawser__list)HAWSER__STORED_ROWS(type, member, number, of)
#define HAWSER__STORED_WITHIN(type, member, number, of) .kind = HAWSER__OBJECTS, \
	.list = &(const struct hawser__list)HAWSER__ROWS_WITHIN(type, member, number, of)
/* An object of fields of the same row, of a structure within it, and of one to which it points. */
#define HAWSER__OBJECT_OF(of) .kind = HAWSER__OBJECT, .inner = (of)
#define HAWSER__PART_OF(type, member, of) \
	.kind = HAWSER__OBJECT, .inner = (of), HAWSER__PLACE(type, member)
#define HAWSER__THROUGH(type, member, of) \
	.kind = HAWSER__OBJECT, .inner = (of), .through = 1, HAWSER__PLACE(type, member)
#define HAWSER__CALLS(function) .kind = HAWSER__CALL, .call = (function)

/* --- tables --- */

/* The columns of these fields. */
void hawser__fields_columns(struct hawser__table *table, const struct hawser__field *field,
                            const struct hawser__view *view);
/* Columns and all rows of the list, which are made on output; `parent` must stay until then. */
void hawser__fields_table(struct hawser__table *table, const struct hawser__list *list,
                          const void *parent, const struct hawser__view *view);
/* Rows of a list, stored at once, below the columns of `columns` (NULL: its own): by the fields of
 * the same column name; what the list does not have is empty. */
void hawser__fields_rows(struct hawser__table *table, const struct hawser__field *columns,
                         const struct hawser__list *list, const void *parent,
                         const struct hawser__view *view);
/* One of them. */
void hawser__fields_row(struct hawser__table *table, const struct hawser__field *columns,
                        const struct hawser__field *field, const void *row,
                        const struct hawser__view *view);
/* Comments "name = value unit" of the numbers of a row, by their keys. */
void hawser__fields_comments(struct hawser__table *table, const struct hawser__field *field,
                             const void *row, const struct hawser__view *view);

/* The axis that shows, up to `largest`, the first field of that column or key which this result has
 * and which has a title. A tension gets the prefix k or M from 1000 on. A pure number has the unit
 * "–". */
struct hawser__axis hawser__fields_axis(const struct hawser__field *field, const char *name,
                                        const struct hawser__view *view, double largest);

/* --- JSON --- */

/* Members of the object `into` from one row. */
void hawser__fields_json(struct hawser__json *json, json_t *into, const struct hawser__field *field,
                         const void *row, const struct hawser__view *view);

/* Puts members of the object, as hawser__fields_json wrote them, back into the row: numbers in the
 * row's own units (NAN: no number), flags, labels and vectors, but nothing computed and no text. What
 * the object does not have stays as it is. Of a list whose rows are stored, the last row is put back
 * as its only one, where there is room for it: neither into rows nor into vectors that are NULL. */
void hawser__fields_read(void *row, const struct hawser__field *field, const json_t *object,
                         const struct hawser__view *view);

/* --- the list of all fields --- */

/* A line each: name, unit, meaning; `what` is the heading. Inner lists are indented. */
void hawser__fields_print(FILE *stream, const char *what, const struct hawser__field *field,
                          int json);

#endif

/* rom/file/writer.h - JSON written to a stream as it is generated, in the layouts of
 * reduced-model files. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_WRITER_H
#define HAWSER_ROM_WRITER_H

#include <stddef.h>
#include <stdio.h>

#include "core/digits.h"

enum hawser__layout {
	HAWSER__WRITE_FILE,    /* an object; values without lists or objects in them are on one line */
	HAWSER__WRITE_MEMBERS, /* members of the outermost object of a result, without its braces: the
	                        * layout of output/fields/json.c */
};

enum { HAWSER__WRITER_DEPTH = 8 };

struct hawser__writer {
	FILE *stream; /* NULL: values are checked, and nothing is written */
	enum hawser__layout layout;
	int failed;  /* memory ran out */
	int invalid; /* a number is not finite, or a word is not UTF-8 */
	int depth;   /* of containers that are open */
	int keyed;   /* the key of the next value is written */
	struct hawser__container {
		char bracket; /* '{' or '[' */
		int broken;   /* its members are on separate lines */
		int count;    /* members written */
	} container[HAWSER__WRITER_DEPTH];
	struct hawser__powers powers;
};
void hawser__writer_begin(struct hawser__writer *to, FILE *stream, enum hawser__layout layout);

/* A list '[' or an object '{'; `nested`: at least one member, or of a member that is a list at least
 * one, is a list or an object. */
void hawser__write_begin(struct hawser__writer *to, char bracket, int nested);
void hawser__write_end(struct hawser__writer *to);
/* The key of the next value, in an object. */
void hawser__write_key(struct hawser__writer *to, const char *key);
void hawser__write_number(struct hawser__writer *to, double value);
void hawser__write_integer(struct hawser__writer *to, int value);
void hawser__write_word(struct hawser__writer *to, const char *word);
/* Lists [shape[0]][shape[1]]..., `rank` of them, row-major. */
void hawser__write_numbers(struct hawser__writer *to, const double *value, const size_t *shape,
                           int rank);
/* The list [index[0], ..., index[count - 1], value], count at most 4. */
void hawser__write_entry(struct hawser__writer *to, const int *index, int count, double value);

#endif

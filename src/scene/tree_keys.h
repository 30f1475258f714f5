/* scene/tree_keys.h - the tables of keys of all kinds of scenes. See tree_rows.h for how they are
 * written.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_TREE_KEYS_H
#define HAWSER_SCENE_TREE_KEYS_H

#include <stddef.h>

#include "scene/tree.h"

enum hawser__tree_type {
	HAWSER__TREE_NUMBER, /* or a list of `count` of them */
	HAWSER__TREE_INTEGER,
	HAWSER__TREE_WORD,
	HAWSER__TREE_TEXT,
	HAWSER__TREE_LIMIT,    /* words for 0 and infinity, in place of a number */
	HAWSER__TREE_POSITION, /* on the cable: a fraction, or a length; a double, then an int: 1 for a
	                        * length */
	HAWSER__TREE_MAPPING,
	HAWSER__TREE_LIST
};

enum hawser__tree_need {
	HAWSER__TREE_OPTIONAL,
	HAWSER__TREE_REQUIRED, /* where its mapping is given */
	HAWSER__TREE_ONE_OF,   /* exactly one of those of its mapping with the same `pick` */
	HAWSER__TREE_AT_MOST_ONE,
	HAWSER__TREE_TOGETHER, /* all of them, where the mapping has more than mappings */
	HAWSER__TREE_MESH      /* of spans over obstacles that are meshes, whose reader lists its keys; a
	                        * mapping is one of those that exclude each other */
};

/* Places of values that have none: code of the kind reads them; they are read and not kept. */
#define HAWSER__TREE_NOWHERE ((size_t)-1)
#define HAWSER__TREE_CHECKED ((size_t)-2)

struct hawser__tree_key {
	const char *path;             /* "net.cables[].EA" */
	enum hawser__tree_type type;
	int count;                    /* length of a list of numbers; 0: one number */
	const char *unit;             /* of numbers, NULL: it depends on other keys; of words "a|b" */
	enum hawser__tree_range range;
	double least, most;           /* of integers; of numbers most alone; 0: without a limit */
	enum hawser__tree_need need;
	size_t at;                    /* of the value in its structure, see tree_rows.h */
	int copies;                   /* one number for so many places */
	size_t pick;                  /* of the int that says which of those with ONE_OF is given: */
	int member;                   /* this, or if it is 0 its place among them */
	const char *given;            /* default, or words about it; NULL: none */
	const char *doc;
};

/* The rows of a kind, and how its scenes are known. */
enum { HAWSER__TREE_SIGNS = 2 };
struct hawser__tree_table {
	const char *kind, *title; /* "net", "A net of cables" */
	const struct hawser__tree_key *row; /* [rows] */
	int rows;
	const char *word;         /* of the key `kind`; NULL: that of another one */
	const char *sign[HAWSER__TREE_SIGNS]; /* outermost keys that tell the kind, if `kind` does not */
};
#define HAWSER__TREE_DECLARE(name, NAME) extern const struct hawser__tree_table hawser__tree_of_##name;
HAWSER__TREE_DECLARE(span, )
HAWSER_SCENE_KINDS(HAWSER__TREE_DECLARE)
HAWSER__TREE_DECLARE(mesh, )
#undef HAWSER__TREE_DECLARE
/* That of a kind; NULL: it has none. */
const struct hawser__tree_table *hawser__tree_kind(enum hawser_kind kind);
/* That with the path or mapping `of`; NULL: there is none. */
const struct hawser__tree_table *hawser__tree_table(const char *of);

/* Row `index` of all tables, from 0; NULL beyond the last. */
const struct hawser__tree_key *hawser__tree_row(int index);

/* The next row of this path, which is another form of its value, after `row`; NULL: the first one. NULL
 * if there is none. */
const struct hawser__tree_key *hawser__tree_next(const struct hawser__tree_key *row, const char *path);

/* The key at the end of a path below the mapping `of` ("EA" of "net.cables[].EA" below
 * "net.cables[]"); NULL if the path is not that of a key directly below it. */
const char *hawser__tree_key_of(const char *path, const char *of);

/* The word of the list "a, b" that is nearest to `name`, "" if none is near. */
void hawser__tree_nearest(char best[HAWSER__TEXT_ROOM], const char *name, const char *keys);

/* What may be meant by a key `name` that the mapping `of` does not have: "did you mean EA? ", also
 * "EA under cable", or nothing. `keys`: those it has. */
const char *hawser__tree_suggest(char hint[HAWSER__TEXT_ROOM], const char *name, const char *of,
                                 const char *keys);

/* Read a default "0", "[.inf, 0, 0]", "pi" into value [most]; its number of values, 0: it is words. */
int hawser__tree_default(double *value, int most, const char *given);

/* "segments[0].EA" as "segments.0.EA". Returns 0 if a bracket has no other one, or nothing in it. */
int hawser__path_plain(char *path);
/* The number at the end of "load.extent.1", which is taken off; -1: there is none. */
int hawser__path_element(char *path);

/* The keys of a mapping as text "name, from, to", into text [size]. */
enum { HAWSER__TREE_LIST_SIZE = 256 };
void hawser__tree_key_list(char *text, size_t size, const char *of);

#endif

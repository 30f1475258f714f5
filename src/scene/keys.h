/* scene/keys.h - the internal part of the table of keys: the place of a value in struct
 * hawser_scene, its range, and which keys exclude each other.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_KEYS_H
#define HAWSER_SCENE_KEYS_H

#include <hawser/scene.h>

enum hawser__type {
	HAWSER__NUMBER, /* with words: the first one is 0, the second one infinity */
	HAWSER__INTEGER,
	HAWSER__PAIR,
	HAWSER__TRIPLE,
	HAWSER__SERIES, /* one number, or a list: damping.ratio and what follows it in the scene */
	HAWSER__WORD,
	HAWSER__PLACE, /* on the cable: a fraction or a length; a double, then an int: 1 if a length */
	HAWSER__NAME   /* char[HAWSER_NAME_SIZE] */
};

enum hawser__range {
	HAWSER__ANY, /* any finite number */
	HAWSER__POSITIVE,
	HAWSER__POSITIVE_OR_INF,
	HAWSER__NOT_NEGATIVE,
	HAWSER__NOT_NEGATIVE_OR_INF,
	HAWSER__RIGHT_ANGLE, /* [-pi/2, pi/2] */
	HAWSER__OPEN_UNIT,  /* (0, 1) */
	HAWSER__INCREASING, /* a pair in [0, 1], the second larger than the first */
	HAWSER__MODES,
	HAWSER__MULTIPLE,
	HAWSER__BASIS,
	HAWSER__WITHIN, /* [0, 1], or a length >= 0 */
	HAWSER__INSIDE, /* (0, 1), or a length > 0 */
	HAWSER__CHANGE, /* of temperature */
	HAWSER__NAMES,
	HAWSER__WORDS /* one of the words, no range */
};

/* Keys of one group exclude each other: at most one member of a group may be given. */
enum hawser__group { HAWSER__FREE, HAWSER__TENSION, HAWSER__DAMPING, HAWSER__BEAM, HAWSER__WEIGHT,
                     HAWSER__GROUPS };

struct hawser__row {
	enum hawser__type type;
	enum hawser__range range;
	enum hawser__group group;
	int member;    /* value of the group's selector if this key is chosen */
	size_t offset; /* of the value in struct hawser_scene */
};

struct hawser__section {
	const char *path; /* "damping.rayleigh" */
	int required;
	const char *doc;
};

/* The selector of a group, and the text of its rule in messages. */
struct hawser__choice {
	const char *section, *what; /* "tension", "the tension" */
	size_t offset; /* of the selector, an enum whose 0 means none */
	const char *rule;
};

const struct hawser__row *hawser__rows(void); /* parallel to hawser_scene_key() */
const struct hawser__section *hawser__sections(size_t *count);
const struct hawser__choice *hawser__choice(enum hawser__group group);

struct hawser__reader;
struct hawser__tree;

/* A list of the scene, whose items are mappings: a row of the table in lists.c. Keys "attach.KEY" of
 * the table of keys belong to each item of the list `attach`; their offset is that in the first item,
 * and a name is the last member of an item. items.c reads and finds items. */
struct hawser__items {
	const char *name;        /* "attach" */
	const char *one;         /* of an item: "attachment" */
	const char *keys;        /* "at, mass, spring, damper or name"; NULL if the items have no keys in
	                          * the table: then there is `read` */
	const char *example;     /* of an item */
	const char *required;    /* path of the key that each item must have, or NULL, and */
	const char *missing;     /* the message where it has not */
	int most;
	size_t count, first, size; /* offset of the number of items and of the first, size of an item */
	size_t called;           /* offset of the name in an item */
	const void *fresh;       /* an item with its defaults; NULL: all zero */
	enum hawser_status (*read)(struct hawser__reader *reader, int number,
	                           const struct hawser__tree *tree);
	enum hawser_status (*set)(struct hawser__reader *reader, int number, const char *path,
	                          const struct hawser__tree *tree); /* a key of an item */
	enum hawser_status (*check)(struct hawser__reader *reader); /* of all items of a scene */
};
enum { HAWSER__ATTACH, HAWSER__LOADS, HAWSER__CASES, HAWSER__LISTS };
const struct hawser__items *hawser__list_row(int index);  /* NULL beyond the last */
const struct hawser__items *hawser__list_of(int key); /* the list of the key of this row, or NULL */

/* Index of the list "attach" or of the key "attach..." of its items, or -1. */
int hawser__list_find(const char *path);
int *hawser__list_count(const struct hawser__items *list, const struct hawser_scene *scene);
/* The name of an item. */
const char *hawser__item_name(const struct hawser__items *list, const struct hawser_scene *scene,
                              int item);

/* The place in a scene of the value of row `index`; of a key of a list, in item `item`. */
void *hawser__field(const struct hawser_scene *scene, int index, int item);

/* 1 if a place on the cable is within the range of row `index`. */
int hawser__place_in(int index, double value, int by_length);

int hawser__key_find(const char *path);     /* index, or -1 */
int hawser__section_find(const char *path); /* index, or -1 */

/* items.c: the index of the key of "attach.0.mass" or "attach.NAME.mass", and in *item the number of
 * that item, -1 if the scene has no such item. Returns -1 if `path` has not this form or there is no
 * such key. */
int hawser__item_key(int *item, const struct hawser_scene *scene, const char *path);

/* Number of elements of a list, 0 for a scalar. */
int hawser__type_count(enum hawser__type type);

/* The same of a key in this scene, also of a number or list. */
int hawser__count(const struct hawser_scene *scene, int index);

/* 1 if a finite or infinite value is within the range of row `index`. */
int hawser__in_range(int index, double value);

/* Get the selector of a group in a scene; set it. */
int hawser__chosen(const struct hawser_scene *scene, enum hawser__group group);
void hawser__choose(struct hawser_scene *scene, enum hawser__group group, int member);

/* 1 if key `index` applies to this scene (the chosen tension, keys of a load that is present,
 * ...). */
int hawser__applies(const struct hawser_scene *scene, int index);

/* A number of the scene; `element` is the index in a list and is ignored for a scalar. `item` is
 * the number of the item, for keys of lists. */
double hawser__stored(const struct hawser_scene *scene, int index, int element, int item);

/* 1 if the value of key `index` is a word: "taut", or "auto" in place of a number. */
int hawser__is_word(const struct hawser_scene *scene, int index);

/* The choice-th of "taut|slack" into word [size]. */
void hawser__word(char *word, size_t size, const char *words, int choice);

/* Last component of a path, and the length of the part before its dot (0 at the top level). */
const char *hawser__leaf(const char *path);
size_t hawser__parent_length(const char *path);

/* "segments[0].EA" as "segments.0.EA". Returns 0 if a bracket has no other one, or nothing in it. */
int hawser__path_plain(char *path);
/* The number at the end of "load.extent.1", which is taken off; -1: there is none. */
int hawser__path_element(char *path);

/* 1 if `path` is directly in `section` ("" is the top level). */
int hawser__child_of(const char *path, const char *section);

#endif

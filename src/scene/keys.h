/* scene/keys.h - keys of spans (span_rows.c) in struct hawser_scene: their places, also in items of
 * lists, and which of them apply.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_KEYS_H
#define HAWSER_SCENE_KEYS_H

#include <hawser/scene.h>

#include "scene/tree_keys.h"

/* The row of the table of key `index` (hawser_scene_key). */
const struct hawser__tree_key *hawser__row(int index);

int hawser__key_find(const char *path); /* index, or -1 */
/* " N": the unit of the number at this path, as it follows a value; "": a pure one, or no number. */
const char *hawser__key_unit(const struct hawser_scene *scene, const char *path, char unit[static 32]);

/* A list of the scene, whose items are mappings: a row of the table in keys.c. A name is the last
 * member of an item. */
struct hawser__items {
	const char *name;    /* "attach" */
	const char *example; /* of an item */
	int most;
	size_t count, first, size; /* offset of the number of items and of the first, size of an item */
	size_t called;             /* offset of the name in an item */
};
enum { HAWSER__ATTACH, HAWSER__LOADS, HAWSER__CASES, HAWSER__LISTS };
const struct hawser__items *hawser__list_row(int index); /* NULL beyond the last */
const struct hawser__items *hawser__list_of(int key); /* that of the key of this row, or NULL */
int *hawser__list_count(const struct hawser__items *list, const struct hawser_scene *scene);
void *hawser__item(const struct hawser__items *list, const struct hawser_scene *scene, int item);
const char *hawser__item_name(const struct hawser__items *list, const struct hawser_scene *scene,
                              int item);

/* The key of a path "cable.EA", "attach.0.mass" or "attach.NAME.mass", and in *item the number of that
 * item, -1 if the scene has no such item. -1: there is no such key. */
int hawser__item_key(int *item, const struct hawser_scene *scene, const char *path);

/* The place in a scene of the value of row `index`; of a key of a list, in item `item`. */
void *hawser__field(const struct hawser_scene *scene, int index, int item);

/* Number of elements of a list of numbers in this scene, 0 for a scalar. */
/* The length of the list at this place of the scene, 0: a number; NULL if the key has no list. */
int *hawser__series(const struct hawser_scene *scene, size_t at);

int hawser__count(const struct hawser_scene *scene, int index);

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

/* Last component of a path. */
const char *hawser__leaf(const char *path);

/* 1 if `path` is directly in `section` ("" is the top level). */
int hawser__child_of(const char *path, const char *section);

/* check.c: rules over several keys, of a scene that was filled from this tree. */
enum hawser_status hawser__check(struct hawser__reader *reader, struct hawser_scene *scene,
                                 const struct hawser__tree *root) HAWSER_MUST_CHECK;

#endif

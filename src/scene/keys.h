/* scene/keys.h - the internal side of the table of keys: where a value lives in struct
 * hawser_scene, what it may be, and which keys exclude each other.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_KEYS_H
#define HAWSER_SCENE_KEYS_H

#include <hawser/scene.h>

enum hawser__type {
	HAWSER__NUMBER,
	HAWSER__INTEGER,
	HAWSER__PAIR,
	HAWSER__TRIPLE,
	HAWSER__WORD
};

enum hawser__range {
	HAWSER__ANY, /* any finite number */
	HAWSER__POSITIVE,
	HAWSER__POSITIVE_OR_INF,
	HAWSER__NOT_NEGATIVE,
	HAWSER__RIGHT_ANGLE, /* at most a right angle either way */
	HAWSER__OPEN_UNIT,  /* (0, 1) */
	HAWSER__INCREASING, /* a pair in [0, 1], second above first */
	HAWSER__MODES,
	HAWSER__BASIS,
	HAWSER__WORDS /* one of the words, nothing to compare */
};

/* Keys of one group are choices: at most one member of it may be given. */
enum hawser__group { HAWSER__FREE, HAWSER__TENSION, HAWSER__DAMPING, HAWSER__BEAM, HAWSER__WEIGHT,
                     HAWSER__GROUPS };

struct hawser__row {
	enum hawser__type type;
	enum hawser__range range;
	enum hawser__group group;
	int member;    /* what the group's selector holds when this key is the choice */
	size_t offset; /* of the value in struct hawser_scene */
};

struct hawser__section {
	const char *path; /* "damping.rayleigh" */
	int required;
	const char *doc;
};

/* The selector of a group, and how its rule reads in a message. */
struct hawser__choice {
	const char *section, *what; /* "tension", "the tension" */
	size_t offset; /* of the selector, an enum whose 0 means none */
	const char *rule;
};

const struct hawser__row *hawser__rows(void); /* parallel to hawser_scene_keys() */
const struct hawser__section *hawser__sections(size_t *count);
const struct hawser__choice *hawser__choice(enum hawser__group group);

int hawser__key_find(const char *path);     /* index, or -1 */
int hawser__section_find(const char *path); /* index, or -1 */

/* Values in a list, 0 for a scalar. */
int hawser__type_count(enum hawser__type type);

/* Whether a finite or infinite value obeys the range of row `index`. */
int hawser__in_range(int index, double value);

/* The selector of a group in a scene, readable and writable. */
int hawser__chosen(const struct hawser_scene *scene, enum hawser__group group);
void hawser__choose(struct hawser_scene *scene, enum hawser__group group, int member);

/* Whether key `index` means something in this scene (the tension chosen, a load present ...). */
int hawser__applies(const struct hawser_scene *scene, int index);

/* A number from the scene; `element` of a list, anything for a scalar. */
double hawser__stored(const struct hawser_scene *scene, int index, int element);

/* Whether what the scene has for key `index` is a word: "taut", or "auto" where a number could be. */
int hawser__is_word(const struct hawser_scene *scene, int index);

/* The choice-th of "taut|slack" into word [size]. */
void hawser__word(char *word, size_t size, const char *words, int choice);

/* Last component of a path, and the length of what stands before its dot (0 at the top). */
const char *hawser__leaf(const char *path);
size_t hawser__parent_length(const char *path);

/* Whether `path` lies directly in `section` ("" is the top level). */
int hawser__child_of(const char *path, const char *section);

#endif

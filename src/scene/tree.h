/* scene/tree.h - a scene as a tree of values with their places, and how scenes are read from it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_TREE_H
#define HAWSER_SCENE_TREE_H

#include <hawser/document.h>
#include <hawser/scene.h>

#include "scene/reader.h"

enum hawser__tree_kind { HAWSER__SCALAR, HAWSER__MAPPING, HAWSER__SEQUENCE };

struct hawser__tree {
	enum hawser__tree_kind kind;
	char *name, *text;           /* of an entry of a mapping; of a scalar */
	struct hawser__mark at;     /* of the name or, without one, of the value */
	struct hawser__mark value;  /* of the value */
	struct hawser__tree *child, *last, *next;
	int children;
};

/* For messages: what such a scene is, and an example of an override. */
struct hawser__tree_words {
	const char *table; /* of its keys: "net" */
	const char *scene; /* "a scene of kind net is a mapping with ..." */
	const char *set;   /* "cables.c1.EA=100 MN" */
	char item;         /* of a list, without a name: this letter and their number, c1; 0: they have
	                    * no names then */
};

/* How scenes of a kind are read from their tree. */
struct hawser__tree_form {
	struct hawser__tree_words words;
	size_t size, name; /* of the structure; where its name is */
	enum hawser_status (*interpret)(struct hawser__reader *reader, void *scene,
	                                const struct hawser__tree *root);
	void (*clear)(void *scene);
};
/* Read a scene from a document or a file, then overrides "path=value". After a failure it is all
 * zero. */
enum hawser_status hawser__tree_scene(void *scene, const struct hawser__tree_form *form,
                                      const struct hawser_document *from, const char *const *set,
                                      size_t nset, struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__tree_scene_open(void *scene, const struct hawser__tree_form *form,
                                           const char *path, const char *const *set, size_t nset,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
/* hawser_NAME_of and hawser_NAME_open of struct hawser_NAME, which has a `name`, by the function
 * `interpret` of the file and these words (struct hawser__tree_words). */
#define HAWSER__TREE_SCENES(kind, ...) \
	static void clear_##kind(void *scene) \
	{ \
		hawser_##kind##_clear(scene); \
	} \
	static const struct hawser__tree_form form = {{__VA_ARGS__}, sizeof(struct hawser_##kind), \
		offsetof(struct hawser_##kind, name), interpret, clear_##kind}; \
	enum hawser_status hawser_##kind##_of(struct hawser_##kind *to, \
	                                      const struct hawser_document *from, \
	                                      const char *const *set, size_t nset, \
	                                      struct hawser_report *report) \
	{ \
		return hawser__tree_scene(to, &form, from, set, nset, report); \
	} \
	enum hawser_status hawser_##kind##_open(struct hawser_##kind *to, const char *path, \
	                                        const char *const *set, size_t nset, \
	                                        struct hawser_report *report) \
	{ \
		return hawser__tree_scene_open(to, &form, path, set, nset, report); \
	}
/* The tree of a text; 0: it is no YAML that a scene may be, and *tree is what comes before the fault.
 * The caller clears it. */
int hawser__tree_parse(struct hawser__tree **tree, const char *text, size_t length);
void hawser__tree_clear(struct hawser__tree *tree);
/* Read one document. */
enum hawser_status hawser__tree_document(struct hawser__tree **tree, struct hawser__reader *reader,
                                         const char *text, size_t length) HAWSER_MUST_CHECK;
void hawser__tree_append(struct hawser__tree *parent, struct hawser__tree *child);
/* tree_set.c: apply an override "path=value", or "path=", which removes what is there. */
enum hawser_status hawser__tree_set(struct hawser__tree *root, struct hawser__reader *reader,
                                    const char *set, const struct hawser__tree_words *words)
	HAWSER_MUST_CHECK;
/* Entry of a mapping, or NULL; by a path "travel.final" in nested ones. */
struct hawser__tree *hawser__tree_find(const struct hawser__tree *tree, const char *name);
const struct hawser__tree *hawser__tree_at(const struct hawser__tree *tree, const char *path);
/* A name of the outermost mapping, or this value of it, that tells the kind, in the order in which they
 * are looked for; 0 beyond the last. */
struct hawser__kind_sign {
	const char *key, *word; /* word: NULL: any value */
	enum hawser_kind kind;
};
int hawser__kind_sign(struct hawser__kind_sign *sign, int index);

/* --- tree_value.c: values of a tree. `what` names the value in messages. --- */

enum hawser__tree_range {
	HAWSER__TREE_ANY, /* finite */
	HAWSER__TREE_POSITIVE, HAWSER__TREE_NOT_NEGATIVE, HAWSER__TREE_POSITIVE_OR_INF,
	HAWSER__TREE_NOT_NEGATIVE_OR_INF,
	HAWSER__TREE_RIGHT_ANGLE, /* [-pi/2, pi/2] */
	HAWSER__TREE_OPEN_UNIT,   /* (0, 1) */
	HAWSER__TREE_INCREASING,  /* a pair in [0, 1], the second larger than the first */
	HAWSER__TREE_CHANGE,      /* of temperature, in K */
	HAWSER__TREE_WITHIN,      /* a position: [0, 1], or a length >= 0 */
	HAWSER__TREE_INSIDE,      /* a position: (0, 1), or a length > 0 */
	HAWSER__TREE_RANGES
};
struct hawser__tree_limits {
	const char *text; /* "> 0" */
	double least, most;
	int above, below; /* 1: without the least value, without the largest one */
};
const struct hawser__tree_limits *hawser__tree_limits(enum hawser__tree_range range);
int hawser__tree_in_range(enum hawser__tree_range range, double value);
enum { HAWSER__TREE_NAME = 32 }; /* size of a name, with the NUL at its end */

/* tree_keys.c: a tree must be a mapping whose keys are those of the mapping `of` in the table of
 * keys (tree_keys.h), such as "net.cables[]", or of a list such as "d, h". */
enum hawser_status hawser__tree_keys(struct hawser__reader *reader, const struct hawser__tree *tree,
                                     const char *what, const char *of) HAWSER_MUST_CHECK;
enum hawser_status hawser__tree_number(struct hawser__reader *reader, double *value,
                                       const struct hawser__tree *tree, const char *what,
                                       const char *unit, enum hawser__tree_range range)
	HAWSER_MUST_CHECK;
/* Two or three numbers, along x, y and z. */
enum hawser_status hawser__tree_vector(struct hawser__reader *reader, double *value, int count,
                                       const struct hawser__tree *tree, const char *what,
                                       const char *unit) HAWSER_MUST_CHECK;
/* --- tree_fill.c: values by the table of keys --- */

/* Read all values of a mapping whose rows have a place (tree_rows.h) into a structure, those of its
 * sections too, and check its keys; what is not given gets its default. `section` begins the names of
 * its values in messages ("cables.c1"), "" at the top; `of` is its path in the table, "net.cables[]".
 * A tree NULL: the defaults. */
enum hawser_status hawser__tree_fill(struct hawser__reader *reader, void *to,
                                     const struct hawser__tree *tree, const char *section,
                                     const char *of) HAWSER_MUST_CHECK;
/* One value, by its path in the table; `what` names it in messages. What has no place there goes to
 * *to itself. */
enum hawser_status hawser__tree_value(struct hawser__reader *reader, void *to,
                                      const struct hawser__tree *tree, const char *what,
                                      const char *path) HAWSER_MUST_CHECK;
/* Fail for a value of this path that is not in the mapping `tree`. */
enum hawser_status hawser__tree_missing(struct hawser__reader *reader, const struct hawser__tree *tree,
                                        const char *what, const char *path) HAWSER_MUST_CHECK;
/* A list of mappings, of at most so many (0: any number; it may be empty if `least` is 0): zeroed room
 * for its items of this size, NULL with *status after a failure. `such` is an example of an item. */
void *hawser__tree_items(struct hawser__reader *reader, enum hawser_status *status,
                         const struct hawser__tree *tree, const char *what, size_t size, int least,
                         int most, const char *such);
/* The name of item `number` of a list, whose items have `size` and have their names at `name`: that
 * given, else a letter and the number. It must differ from those before. `what` is the list. */
enum hawser_status hawser__tree_name_item(struct hawser__reader *reader, char *name, size_t size,
                                          int number, const struct hawser__tree *tree,
                                          const char *what, char letter) HAWSER_MUST_CHECK;

/* --- tree_value.c, too --- */

/* Letters, digits, _ and -, not only digits. */
enum hawser_status hawser__tree_name(struct hawser__reader *reader, char name[HAWSER__TREE_NAME],
                                     const struct hawser__tree *tree, const char *text,
                                     const char *what) HAWSER_MUST_CHECK;
/* The text of a scalar; fails for others. */
enum hawser_status hawser__tree_text(struct hawser__reader *reader, const char **text,
                                     const struct hawser__tree *tree, const char *what)
	HAWSER_MUST_CHECK;
/* A position on a cable: a fraction, or a length. */
enum hawser_status hawser__tree_position(struct hawser__reader *reader, double *value, int *by_length,
                                         const struct hawser__tree *tree, const char *what,
                                         enum hawser__tree_range range) HAWSER_MUST_CHECK;
int hawser__tree_between(enum hawser__tree_range range, double value, int by_length);
/* The index of a scalar in words [count]. */
enum hawser_status hawser__tree_word(struct hawser__reader *reader, int *index,
                                     const struct hawser__tree *tree, const char *what,
                                     const char *const *words, int count) HAWSER_MUST_CHECK;

/* --- wind_read.c: the lists of a wind, and its rules --- */

/* Drag, lift, profile and tables from `tree`, whose path in the table of keys is `of`, such as
 * "span.wind"; `what` names it in messages. The numbers are in *wind already. */
enum hawser_status hawser__wind_lists(struct hawser__reader *reader, struct hawser_wind *wind,
                                      const struct hawser__tree *tree, const char *what,
                                      const char *of) HAWSER_MUST_CHECK;
/* What of it is needed together, and what contradicts what. */
enum hawser_status hawser__wind_check(struct hawser__reader *reader, const struct hawser_wind *wind,
                                      const struct hawser__tree *tree, const char *what)
	HAWSER_MUST_CHECK;

#endif

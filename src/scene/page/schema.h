/* scene/page/schema.h - parts of the JSON Schema of scenes. Objects are NULL where memory is
 * short; a NULL that is put into an object fails the whole.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_SCENE_SCHEMA_H
#define HAWSER_SCENE_SCHEMA_H

#include <jansson.h>

struct hawser__schema {
	int failed; /* 1: out of memory */
};

/* Put `value`, which is then owned by `into`. */
void hawser__schema_put(struct hawser__schema *schema, json_t *into, const char *key, json_t *value);
void hawser__schema_add(struct hawser__schema *schema, json_t *list, json_t *value);

/* --- schema_value.c --- */

/* The limits of a number. */
struct hawser__schema_range {
	double least, most; /* -INFINITY, INFINITY: none */
	int open;           /* 1: without its least value */
	int whole;          /* 1: an integer */
};
/* A number, which may be text with a unit ("" or NULL: none is suggested). */
json_t *hawser__schema_number(struct hawser__schema *schema, const char *unit,
                              const struct hawser__schema_range *range);
/* A list of so many of them. */
json_t *hawser__schema_numbers(struct hawser__schema *schema, int count, const char *unit,
                               const struct hawser__schema_range *range);
/* One of "a|b|c". What YAML 1.1 reads as a truth value (yes, on, ...) is accepted as that too. */
json_t *hawser__schema_words(struct hawser__schema *schema, const char *words);
json_t *hawser__schema_type(struct hawser__schema *schema, const char *type);
/* Any of the list of forms, or its only one; takes the list. */
json_t *hawser__schema_any(struct hawser__schema *schema, json_t *forms);
/* {"required": [key]} */
json_t *hawser__schema_needs(struct hawser__schema *schema, const char *key);
/* A mapping without keys; hawser__schema_key adds one, and returns what it was given. */
json_t *hawser__schema_mapping(struct hawser__schema *schema);
void hawser__schema_key(struct hawser__schema *schema, json_t *mapping, const char *key, json_t *value,
                        int required);

/* Every key of `together` needs all of them. */
void hawser__schema_together(struct hawser__schema *schema, json_t *mapping, json_t *together);
/* schema.c: a mapping by its path in the table of keys. */
json_t *hawser__schema_of(struct hawser__schema *schema, const char *path);
/* schema_span.c: a cable, or a beam. */
json_t *hawser__schema_span(struct hawser__schema *schema, int beam);

/* --- example.c: the complete scene that hawser-scene(5) shows; a test reads it --- */

extern const char hawser__scene_example[];

#endif

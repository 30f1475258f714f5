/* rom/read.h - checked reading of JSON values; `where` is the position of the value in the file,
 * "K[1][0]".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_READ_H
#define HAWSER_ROM_READ_H

#include <jansson.h>

#include <hawser/rom.h>

struct hawser__reader {
	const char *name; /* of the file, for messages */
	struct hawser_report *report;
};

enum hawser_status hawser__wrong(const struct hawser__reader *reader, const char *format, ...)
	HAWSER_PRINTF(2, 3);

/* A finite number. */
enum hawser_status hawser__read_number(const struct hawser__reader *reader, double *number,
                                       const json_t *value, const char *where);

/* The positive number `key` of `object`, whose position is `where`. */
enum hawser_status hawser__read_positive(const struct hawser__reader *reader, double *number,
                                         const json_t *object, const char *key, const char *where);

/* Nested lists of numbers: out is [shape[0]][shape[1]]... row-major, with `rank` sizes. */
enum hawser_status hawser__read_array(const struct hawser__reader *reader, double *out,
                                      const json_t *value, const size_t *shape, int rank,
                                      const char *where);

/* `count` strings, copied into word. */
enum hawser_status hawser__read_words(const struct hawser__reader *reader, char **word,
                                      const json_t *value, size_t count, const char *where);

/* Whether `object` is an object and has no key but `keys` (NULL at the end). */
enum hawser_status hawser__read_keys(const struct hawser__reader *reader, json_t *object,
                                     const char *const *keys, const char *where);

/* The keys of a ramp's terms, in the order of enum hawser_ramp_power. */
extern const char *const hawser__ramp_names[HAWSER_RAMP_TERMS];

/* Known condensed modes, after the shape points and the harmonics have been read. read_known.c. */
enum hawser_status hawser__read_known(const struct hawser__reader *reader, struct hawser_rom *rom,
                                      const json_t *root);

/* Motions of the ends (ends.h), after the shape points have been read. read_ends.c. */
enum hawser_status hawser__read_ends(const struct hawser__reader *reader, struct hawser_rom *rom,
                                     json_t *object);

/* labels, scale, shapes, answers and known modes. */
enum hawser_status hawser__read_extras(const struct hawser__reader *reader, struct hawser_rom *rom,
                                       const json_t *root);

/* A whole model from text [size]. */
enum hawser_status hawser__rom_parse(struct hawser_rom *rom, const char *text, size_t size,
                                     const char *name, struct hawser_report *report);

#endif

/* rom/file/read.h - checked reading of JSON values; `where` is the position of the value in the file,
 * "K[1][0]".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_ROM_READ_H
#define HAWSER_ROM_READ_H

#include <jansson.h>
#include <stddef.h>

#include <hawser/rom_source.h>

struct hawser__parser {
	const char *name; /* of the file, for messages */
	struct hawser_report *report;
	const json_t *root;
	const struct hawser_parameter *parameter; /* [parameters] that texts in place of numbers may name */
	int parameters;
	int plain; /* 1: equations of first order stay as they are */
};

enum hawser_status hawser__wrong(const struct hawser__parser *reader, const char *format, ...)
	HAWSER_PRINTF(2, 3);

/* A finite number. */
enum hawser_status hawser__read_number(const struct hawser__parser *reader, double *number,
                                       const json_t *value, const char *where);

/* An integer from low to high; high < low: no upper bound. */
enum hawser_status hawser__read_integer(const struct hawser__parser *reader, int *number,
                                        const json_t *value, int low, int high, const char *where);

/* The positive number `key` of `object`, whose position is `where`. */
enum hawser_status hawser__read_positive(const struct hawser__parser *reader, double *number,
                                         const json_t *object, const char *key, const char *where);

/* Nested lists of numbers: out is [shape[0]][shape[1]]... row-major, with `rank` sizes. */
enum hawser_status hawser__read_array(const struct hawser__parser *reader, double *out,
                                      const json_t *value, const size_t *shape, int rank,
                                      const char *where);

/* `count` strings, copied into word. */
enum hawser_status hawser__read_words(const struct hawser__parser *reader, char **word,
                                      const json_t *value, size_t count, const char *where);

/* Whether `object` is an object and has no key but `keys` (NULL at the end). */
enum hawser_status hawser__read_keys(const struct hawser__parser *reader, json_t *object,
                                     const char *const *keys, const char *where);

/* The keys of a ramp's terms, in the order of enum hawser_ramp_power. */
extern const char *const hawser__ramp_names[HAWSER_RAMP_TERMS];

/* Known condensed modes, after the shape points and the harmonics have been read. read_known.c. */
enum hawser_status hawser__read_known(const struct hawser__parser *reader, struct hawser_rom *rom,
                                      const json_t *root);

/* Motions of the ends (ends.h), after the shape points have been read. read_ends.c. */
enum hawser_status hawser__read_ends(const struct hawser__parser *reader, struct hawser_rom *rom,
                                     json_t *object);

enum hawser_status hawser__read_range(const struct hawser__parser *reader, struct hawser_rom *rom,
                                      const json_t *list);

/* labels, scale, shapes, answers, ranges and known modes. */
enum hawser_status hawser__read_extras(const struct hawser__parser *reader, struct hawser_rom *rom,
                                       const json_t *root);

/* *root, which is to be released, from text [size]; a whole model from it, with these values [sets] of
 * its parameters in place of those of the text; and both. */
enum hawser_status hawser__rom_load(json_t **root, const char *text, size_t size, const char *name,
                                    struct hawser_report *report);
enum hawser_status hawser__rom_read(struct hawser_rom *rom, json_t *root, const char *name,
                                    const struct hawser_parameter *set, int sets,
                                    struct hawser_report *report);
enum hawser_status hawser__rom_parse(struct hawser_rom *rom, const char *text, size_t size,
                                     const char *name, const struct hawser_parameter *set, int sets,
                                     struct hawser_report *report);
enum hawser_status hawser__read_model(const struct hawser__parser *reader, struct hawser_rom *rom,
                                      json_t *root);

/* The parameters of the text, into parameter [HAWSER_PARAMETERS], *count. */
enum hawser_status hawser__parse_parameters(struct hawser_parameter *parameter, int *count,
                                            const char *text, size_t size, const char *name,
                                            struct hawser_report *report);

/* read_own.c: parameters, before all else; what only own models have, last; lists of terms, and entries
 * of a harmonic that become terms. */
enum hawser_status hawser__read_parameters(struct hawser__parser *reader,
                                           struct hawser_parameter *parameter, const json_t *root,
                                           const struct hawser_parameter *set, int sets);
enum hawser_status hawser__read_own(const struct hawser__parser *reader, struct hawser_rom *rom,
                                    json_t *root);
enum hawser_status hawser__read_terms(const struct hawser__parser *reader, struct hawser_term **term,
                                      int *terms, int n, const json_t *list, const char *name);
/* The default relaxation of equations u' = - K u + ... of first order. */
double hawser__relaxation(const double *K, int n);
/* The equations times the inverse [n][n] of a mass matrix; row [n] is room. */
enum hawser_status hawser__rom_divide(struct hawser_rom *rom, const double *inverse, double *row,
                                      struct hawser_report *report);
enum hawser_status hawser__quads_to_terms(struct hawser_harmonic *h, struct hawser_report *report);
enum hawser_status hawser__cubics_to_terms(struct hawser_harmonic *h, const struct hawser_cubic *C,
                                           int cubics, struct hawser_report *report);

/* --- formula.c: numbers that a model file gives as texts with named parameters --- */

/* *value of a text such as "1 + 2*eps^2", with the values of parameter [count]. Returns 0, or 1 with
 * the reason in wrong [size]. */
int hawser__formula(double *value, const char *text, const struct hawser_parameter *parameter,
                    int count, char *wrong, size_t size);

/* 1: the text can be the name of a parameter. */
int hawser__formula_name(const char *name);

#endif

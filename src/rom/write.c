/* rom/write.c - the reduced-model file (hawser-rom(5)): numbers have 17 digits, so that reading
 * restores the same bits; each entry is a line, so that two models can be compared line by line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/file.h"
#include "core/report.h"
#include "rom/read.h"

enum { FLAGS = JSON_ENCODE_ANY | JSON_REAL_PRECISION(17) };

/* --- the model as a JSON value; NULL when out of memory. Numbers that are not finite and names
 * that are not UTF-8 become null, which has no other use in it --- */

static json_t *real(double value)
{
	return isfinite(value) ? json_real(value) : json_null();
}

static json_t *name(const char *word)
{
	json_t *string = json_string(word);

	/* tried again, so that a failed allocation is not reported as an invalid character */
	if (!string)
		string = json_string(word);
	return string ? string : json_null();
}

/* Array [count] of items made by the caller; takes over the item; NULL makes the array fail. */
static void append(json_t **array, json_t *item)
{
	if (*array && json_array_append_new(*array, item) != 0) {
		json_decref(*array);
		*array = NULL;
	}
}

static void set(json_t **object, const char *key, json_t *item)
{
	if (*object && json_object_set_new(*object, key, item) != 0) {
		json_decref(*object);
		*object = NULL;
	} else if (!*object) {
		json_decref(item);
	}
}

/* [shape[0]][shape[1]]... numbers, row-major. */
static json_t *numbers(const double *value, const size_t *shape, int rank)
{
	json_t *array = json_array();
	size_t below = 1;

	for (int i = 1; i < rank; i++)
		below *= shape[i];
	for (size_t i = 0; array && i < shape[0]; i++)
		append(&array, rank == 1 ? real(value[i])
		                         : numbers(value + i*below, shape + 1, rank - 1));
	return array;
}

static json_t *vector(const double *value, int n)
{
	return numbers(value, (size_t[]){(size_t)n}, 1);
}

static json_t *matrix(const double *value, int rows, int columns)
{
	return numbers(value, (size_t[]){(size_t)rows, (size_t)columns}, 2);
}

static json_t *words(char *const *word, int n)
{
	json_t *array = json_array();

	for (int i = 0; array && i < n; i++)
		append(&array, name(word[i]));
	return array;
}

static json_t *entries(const struct hawser_rom *rom, int cubic)
{
	json_t *array = json_array();

	for (int i = 0; array && cubic && i < rom->cubics; i++) {
		const struct hawser_cubic *c = &rom->C[i];

		append(&array, json_pack("[iiiio]", c->j, c->k, c->l, c->m, real(c->value)));
	}
	for (int i = 0; array && !cubic && i < rom->quads; i++) {
		const struct hawser_quad *q = &rom->Q[i];

		append(&array, json_pack("[iiio]", q->j, q->k, q->l, real(q->value)));
	}
	return array;
}

static void set_term(json_t **object, const double *f, const double *D, const double *K, int n)
{
	if (f)
		set(object, "f", vector(f, n));
	if (D)
		set(object, "D", matrix(D, n, n));
	if (K)
		set(object, "K", matrix(K, n, n));
}

static json_t *harmonic(const struct hawser_harmonic *h, int n, int points, int known)
{
	json_t *object = json_pack("{siss si}", "k", h->k, "phase",
	                           h->phase == HAWSER_COS ? "cos" : "sin", "omega_power",
	                           h->omega_power);

	set_term(&object, h->f, h->D, h->K, n);
	if (h->answer)
		set(&object, "answer", numbers(h->answer, (size_t[]){2, (size_t)points, 4}, 3));
	if (h->known)
		set(&object, "known", vector(h->known, known));
	return object;
}

static json_t *ramp(const struct hawser_ramp *from, int n, int points)
{
	json_t *object = json_pack("{so}", "time", real(from->time));

	for (int p = 0; p < HAWSER_RAMP_TERMS; p++) {
		const struct hawser_ramp_term *term = &from->term[p];
		json_t *part = json_object();

		set_term(&part, term->f, term->D, term->K, n);
		if (term->answer)
			set(&part, "answer", matrix(term->answer, points, 4));
		set(&object, hawser__ramp_names[p], part);
	}
	return object;
}

static json_t *harmonics(const struct hawser_rom *rom)
{
	json_t *array = json_array();

	for (int h = 0; array && h < rom->harmonics; h++)
		append(&array, harmonic(&rom->harmonic[h], rom->n, rom->shapes.points,
		                        rom->known.modes));
	return array;
}

static json_t *shapes(const struct hawser_rom *rom)
{
	const struct hawser_rom_shapes *s = &rom->shapes;
	const size_t shape[3] = {(size_t)rom->n, (size_t)s->points, 3};
	json_t *object = json_object();

	set(&object, "names", words(s->name, s->points));
	set(&object, "s", vector(s->s, s->points));
	set(&object, "tangent", matrix(s->tangent, s->points, 2));
	set(&object, "stretch", vector(s->stretch, s->points));
	set(&object, "shape", numbers(s->shape, shape, 3));
	set(&object, "slope", numbers(s->slope, shape, 3));
	set(&object, "EA", real(s->EA));
	if (s->mach2 != 0.0)
		set(&object, "mach2", real(s->mach2));
	if (s->second_shape) {
		const size_t second[3] = {(size_t)rom->n*(rom->n + 1)/2, (size_t)s->points, 3};

		set(&object, "second_shape", numbers(s->second_shape, second, 3));
		set(&object, "second_slope", numbers(s->second_slope, second, 3));
	}
	return object;
}

static json_t *known(const struct hawser_rom *rom)
{
	const struct hawser_rom_known *k = &rom->known;
	const size_t shape[3] = {(size_t)k->modes, (size_t)rom->shapes.points, 4};
	json_t *object = json_pack("{so}", "reach", real(k->reach));

	if (k->modes == 0)
		return object;
	set(&object, "K", vector(k->K, k->modes));
	set(&object, "D", vector(k->D, k->modes));
	set(&object, "shape", numbers(k->shape, shape, 3));
	return object;
}

static json_t *model(const struct hawser_rom *rom)
{
	json_t *object = json_pack("{si si}", "hawser_rom", 1, "n", rom->n);

	set(&object, "D", matrix(rom->D, rom->n, rom->n));
	set(&object, "K", matrix(rom->K, rom->n, rom->n));
	set(&object, "Q", entries(rom, 0));
	set(&object, "C", entries(rom, 1));
	set(&object, "harmonics", harmonics(rom));
	if (rom->ramp)
		set(&object, "ramp", ramp(rom->ramp, rom->n, rom->shapes.points));
	if (rom->label)
		set(&object, "labels", words(rom->label, rom->n));
	if (rom->inertia.shapes > 0)
		set(&object, "second_order_shapes", json_integer(rom->inertia.shapes));
	if (rom->scaled)
		set(&object, "scale", json_pack("{so so so}", "length", real(rom->length), "time",
		                                real(rom->time), "force", real(rom->force)));
	if (rom->shapes.points > 0)
		set(&object, "shapes", shapes(rom));
	if (rom->known.reach > 0.0)
		set(&object, "known", known(rom));
	return object;
}

/* --- layout: a value without nested lists is written on one line --- */

static int is_flat(const json_t *value)
{
	const char *key;
	json_t *item;
	size_t i;

	json_array_foreach(value, i, item) {
		if (json_is_array(item) || json_is_object(item))
			return 0;
	}
	json_object_foreach((json_t *)value, key, item) {
		if (json_is_object(item) || (json_is_array(item) && !is_flat(item)))
			return 0;
	}
	return 1;
}

static int holds_null(json_t *value)
{
	const char *key;
	json_t *item;
	size_t i;

	json_array_foreach(value, i, item) {
		if (holds_null(item))
			return 1;
	}
	json_object_foreach(value, key, item) {
		if (holds_null(item))
			return 1;
	}
	return json_is_null(value);
}

static int put(FILE *stream, json_t *value, int depth)
{
	const char *key, *between = "\n";
	json_t *item;
	size_t i;
	int bad = 0;

	if (is_flat(value) && depth > 0)
		return json_dumpf(value, stream, FLAGS);
	fputc(json_is_array(value) ? '[' : '{', stream);
	json_array_foreach(value, i, item) {
		fprintf(stream, "%s%*s", between, 2*depth + 2, "");
		bad |= put(stream, item, depth + 1);
		between = ",\n";
	}
	json_object_foreach(value, key, item) {
		fprintf(stream, "%s%*s\"%s\": ", between, 2*depth + 2, "", key);
		bad |= put(stream, item, depth + 1);
		between = ",\n";
	}
	fprintf(stream, "\n%*s%c", 2*depth, "", json_is_array(value) ? ']' : '}');
	return bad;
}

enum hawser_status hawser_rom_text(const struct hawser_rom *rom, char **text,
                                   struct hawser_report *report)
{
	json_t *value;
	FILE *stream;
	size_t size;
	int bad;

	*text = NULL;
	if (rom->exact)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rom",
		                    "a model with the exact strain energy can't be written as a "
		                    "reduced-model file, which holds quadratic and cubic terms: take "
		                    "model.energy: quartic, or pass the scene on");
	value = model(rom);
	if (!value)
		return hawser__no_memory(report, "rom");
	if (holds_null(value)) {
		json_decref(value);
		return hawser__fail(report, HAWSER_ERR_NAN, "rom",
		                    "the model can't be written: a number in it is not finite, or a name "
		                    "is not UTF-8");
	}
	stream = open_memstream(text, &size);
	bad = !stream || put(stream, value, 0);
	if (stream)
		bad |= fputc('\n', stream) == EOF;
	/* when memory is short, glibc's fclose returns 0 but sets no text */
	if (stream && (fclose(stream) != 0 || !*text))
		bad = 1;
	json_decref(value);
	if (!bad)
		return HAWSER_OK;
	free(*text);
	*text = NULL;
	return hawser__no_memory(report, "rom");
}

enum hawser_status hawser_rom_save(const struct hawser_rom *rom, const char *path,
                                   struct hawser_report *report)
{
	char *text;
	enum hawser_status status = hawser_rom_text(rom, &text, report);

	if (!status)
		status = hawser__file_put(path, text, strlen(text), report);
	free(text);
	return status;
}

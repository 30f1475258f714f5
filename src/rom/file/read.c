/* rom/file/read.c - strict reading of the reduced-model file (hawser-rom(5)): an unknown key, a wrong
 * shape, an index out of range, or a value that is not a finite number is an error, whose message
 * states its place in the file and what is expected there.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/report.h"
#include "core/spelling.h"
#include "rom/file/entries.h"
#include "rom/energy/kernel.h"
#include "rom/build/model.h"
#include "rom/file/read.h"

enum hawser_status hawser__wrong(const struct hawser__parser *reader, const char *format, ...)
{
	char text[480];
	va_list args;

	va_start(args, format);
	vsnprintf(text, sizeof text, format, args);
	va_end(args);
	return hawser__fail(reader->report, HAWSER_ERR_SCENE, "rom", "%s: %s", reader->name, text);
}

/* Description of a value for messages: "the text \"x\"", "2.5", "a list of 3". */
static const char *describe(char *out, size_t size, const json_t *value)
{
	if (json_is_number(value))
		snprintf(out, size, "%.17g", json_number_value(value));
	else if (json_is_string(value))
		snprintf(out, size, "\"%.40s\"", json_string_value(value));
	else if (json_is_array(value))
		snprintf(out, size, "a list of %zu", json_array_size(value));
	else
		snprintf(out, size, "%s", json_is_object(value) ? "an object"
		         : json_is_boolean(value) ? "true or false" : value ? "null" : "missing");
	return out;
}

static enum hawser_status unwanted(const struct hawser__parser *reader, const char *where,
                                   const json_t *value, const char *wanted)
{
	char text[64];

	return hawser__wrong(reader, "%s is %s; %s is wanted", where,
	                     describe(text, sizeof text, value), wanted);
}

enum hawser_status hawser__read_number(const struct hawser__parser *reader, double *number,
                                       const json_t *value, const char *where)
{
	const char *formula = json_string_value(value);
	char why[160];

	if (formula && reader->parameters > 0) {
		if (hawser__formula(number, formula, reader->parameter, reader->parameters, why, sizeof why))
			return hawser__wrong(reader, "%s is \"%.80s\": %s", where, formula, why);
		return HAWSER_OK;
	}
	*number = json_number_value(value);
	if (!json_is_number(value) || !isfinite(*number))
		return unwanted(reader, where, value, "a number");
	return HAWSER_OK;
}

enum hawser_status hawser__read_integer(const struct hawser__parser *reader, int *number,
                                        const json_t *value, int low, int high, const char *where)
{
	double x = json_number_value(value), top = high < low ? 1e9 : high;
	char wanted[64];

	if (json_is_number(value) && x >= low && x <= top && x == floor(x)) {
		*number = (int)x;
		return HAWSER_OK;
	}
	if (high == low)
		snprintf(wanted, sizeof wanted, "%d", low);
	else if (high < low)
		snprintf(wanted, sizeof wanted, "an integer, %d or more", low);
	else
		snprintf(wanted, sizeof wanted, "an integer from %d to %d", low, high);
	return unwanted(reader, where, value, wanted);
}

enum hawser_status hawser__read_array(const struct hawser__parser *reader, double *out,
                                      const json_t *value, const size_t *shape, int rank,
                                      const char *where)
{
	enum hawser_status status = HAWSER_OK;
	size_t below = 1;
	char inner[96];

	if (!json_is_array(value) || json_array_size(value) != shape[0]) {
		snprintf(inner, sizeof inner, "a list of %zu %s", shape[0],
		         shape[0] == 1 ? (rank > 1 ? "list" : "number")
		         : rank > 1 ? "lists" : "numbers");
		return unwanted(reader, where, value, inner);
	}
	for (int i = 1; i < rank; i++)
		below *= shape[i];
	for (size_t i = 0; !status && i < shape[0]; i++) {
		const json_t *item = json_array_get(value, i);

		if (rank == 1 && json_is_number(item)) { /* finite, and without its place a tenth of the time */
			out[i] = json_number_value(item);
			continue;
		}
		snprintf(inner, sizeof inner, "%s[%zu]", where, i);
		status = rank == 1 ? hawser__read_number(reader, out + i, item, inner)
		         : hawser__read_array(reader, out + i*below, item, shape + 1, rank - 1, inner);
	}
	return status;
}

enum hawser_status hawser__read_words(const struct hawser__parser *reader, char **word,
                                      const json_t *value, size_t count, const char *where)
{
	char text[96];

	if (!json_is_array(value) || json_array_size(value) != count) {
		snprintf(text, sizeof text, "a list of %zu texts", count);
		return unwanted(reader, where, value, text);
	}
	for (size_t i = 0; i < count; i++) {
		const char *item = json_string_value(json_array_get(value, i));

		snprintf(text, sizeof text, "%s[%zu]", where, i);
		if (!item)
			return unwanted(reader, text, json_array_get(value, i), "a text");
		if (!(word[i] = strdup(item)))
			return hawser__no_memory(reader->report, "rom");
	}
	return HAWSER_OK;
}

static const char *nearest(const char *key, const char *const *keys)
{
	const char *best = NULL;
	int least = hawser__edit_limit(strlen(key)) + 1;

	for (; *keys; keys++) {
		int distance = hawser__edit_distance(key, *keys);

		if (distance < least) {
			least = distance;
			best = *keys;
		}
	}
	return best;
}

enum hawser_status hawser__read_keys(const struct hawser__parser *reader, json_t *object,
                                     const char *const *keys, const char *where)
{
	const char *key, *near;
	json_t *item;

	if (!json_is_object(object))
		return unwanted(reader, where, object, "an object");
	json_object_foreach(object, key, item) {
		int known = 0;
		char list[160] = "";

		for (int i = 0; keys[i]; i++)
			known = known || !strcmp(key, keys[i]);
		if (known)
			continue;
		for (int i = 0; keys[i]; i++)
			hawser__append(list, sizeof list, ", ", "%s", keys[i]);
		near = nearest(key, keys);
		if (near)
			return hawser__wrong(reader, "unknown key \"%.40s\" in %s: did you mean %s?", key,
			                     where, near);
		return hawser__wrong(reader, "unknown key \"%.40s\" in %s, which takes %s", key, where,
		                     list);
	}
	return HAWSER_OK;
}

/* --- the parts of a model --- */

static enum hawser_status read_matrix(const struct hawser__parser *reader, double **matrix, int n,
                                      const json_t *value, const char *where)
{
	if (!*matrix)
		/* NOLINTNEXTLINE(clang-analyzer-optin.portability.UnixAPI): n is at least 1, and limited */
		*matrix = malloc((size_t)n*n*sizeof **matrix);
	if (!*matrix)
		return hawser__no_memory(reader->report, "rom");
	return hawser__read_array(reader, *matrix, value, (size_t[]){(size_t)n, (size_t)n}, 2, where);
}

/* [j, k, l, value] or [j, k, l, m, value]: `count` indices, then the value. */
static enum hawser_status read_entry(const struct hawser__parser *reader, int *index, double *value,
                                     int count, int n, const json_t *entry, const char *where)
{
	static const char letters[] = "jklm";
	char place[64];

	if (!json_is_array(entry) || json_array_size(entry) != (size_t)count + 1)
		return unwanted(reader, where, entry, count == 3 ? "[j, k, l, value]"
		                                                 : "[j, k, l, m, value]");
	for (int i = 0; i < count; i++) {
		enum hawser_status status;

		snprintf(place, sizeof place, "%s: index %c", where, letters[i]);
		status = hawser__read_integer(reader, &index[i], json_array_get(entry, (size_t)i), 0, n - 1,
		                      place);
		if (status)
			return status;
	}
	snprintf(place, sizeof place, "%s: the value", where);
	return hawser__read_number(reader, value, json_array_get(entry, (size_t)count), place);
}

/* entries: room for a list Q or C with so many indices, NULL if memory is short; *count: its length. */
static enum hawser_status read_entries(const struct hawser__parser *reader, void *entries, int *count,
                                       int indices, int n, const json_t *list, const char *name)
{
	enum hawser_status status = HAWSER_OK;
	size_t all = json_array_size(list);

	if (!json_is_array(list))
		return unwanted(reader, name, list, "a list of entries");
	if (!entries)
		return hawser__no_memory(reader->report, "rom");
	for (size_t i = 0; !status && i < all; i++) {
		struct hawser__entry entry = {{0}, 0.0};
		char where[48];

		snprintf(where, sizeof where, "%s[%zu]", name, i);
		status = read_entry(reader, entry.index, &entry.value, indices, n, json_array_get(list, i),
		                    where);
		hawser__entry_put(entries, indices, (*count)++, entry);
	}
	return status;
}

static enum hawser_status read_phase(const struct hawser__parser *reader, enum hawser_phase *phase,
                                     const json_t *value, const char *where)
{
	const char *word = json_string_value(value);
	char place[48];

	*phase = word && !strcmp(word, "sin") ? HAWSER_SIN : HAWSER_COS;
	snprintf(place, sizeof place, "%s.phase", where);
	if (value && (!word || (strcmp(word, "sin") != 0 && strcmp(word, "cos") != 0)))
		return unwanted(reader, place, value, "\"cos\" or \"sin\"");
	return HAWSER_OK;
}

/* The terms f, D and K of a harmonic or a ramp, if present. */
static enum hawser_status read_term(const struct hawser__parser *reader, double **f, double **D,
                                    double **K, int n, const json_t *object, const char *where)
{
	const json_t *load = json_object_get(object, "f"), *damping = json_object_get(object, "D");
	const json_t *stiffness = json_object_get(object, "K");
	enum hawser_status status = HAWSER_OK;
	char place[48];

	snprintf(place, sizeof place, "%s.f", where);
	if (load && !(*f = malloc((size_t)n*sizeof **f)))
		return hawser__no_memory(reader->report, "rom");
	if (load)
		status = hawser__read_array(reader, *f, load, (size_t[]){(size_t)n}, 1, place);
	snprintf(place, sizeof place, "%s.D", where);
	if (!status && damping)
		status = read_matrix(reader, D, n, damping, place);
	snprintf(place, sizeof place, "%s.K", where);
	if (!status && stiffness)
		status = read_matrix(reader, K, n, stiffness, place);
	return status;
}

/* C and terms of a harmonic, and a Q with a power of Omega: they become terms. */
static enum hawser_status read_harmonic_terms(const struct hawser__parser *reader,
                                              struct hawser_harmonic *h, int n, json_t *object,
                                              const char *where)
{
	const json_t *C = json_object_get(object, "C"), *terms = json_object_get(object, "terms");
	enum hawser_status status = HAWSER_OK;
	struct hawser_cubic *list = NULL;
	char place[48];
	int cubics = 0;

	snprintf(place, sizeof place, "%s.C", where);
	if (C)
		status = read_entries(reader, list = hawser__entries_room(4, json_array_size(C)), &cubics, 4,
		                      n, C, place);
	if (!status && cubics > 0)
		status = hawser__cubics_to_terms(h, list, cubics, reader->report);
	free(list);
	if (!status && h->quads > 0 && h->omega_power > 0)
		status = hawser__quads_to_terms(h, reader->report);
	snprintf(place, sizeof place, "%s.terms", where);
	return status || !terms ? status : hawser__read_terms(reader, &h->term, &h->terms, n, terms, place);
}

static enum hawser_status read_harmonic(const struct hawser__parser *reader,
                                        struct hawser_harmonic *h, int n, json_t *object,
                                        const char *where)
{
	static const char *const keys[] = {"k", "phase", "omega_power", "load_power", "f", "D", "K",
	                                   "Q", "C", "terms", "answer", "known", NULL};
	const json_t *load = json_object_get(object, "load_power");
	const json_t *Q = json_object_get(object, "Q");
	const json_t *f = json_object_get(object, "f"), *D = json_object_get(object, "D");
	const json_t *K = json_object_get(object, "K"), *power = json_object_get(object, "omega_power");
	enum hawser_status status = hawser__read_keys(reader, object, keys, where);
	char place[48];

	snprintf(place, sizeof place, "%s.k", where);
	if (!status)
		status = hawser__read_integer(reader, &h->k, json_object_get(object, "k"), 0, -1, place);
	if (!status)
		status = read_phase(reader, &h->phase, json_object_get(object, "phase"), where);
	snprintf(place, sizeof place, "%s.omega_power", where);
	if (!status && power)
		status = hawser__read_integer(reader, &h->omega_power, power, 0, 3, place);
	snprintf(place, sizeof place, "%s.load_power", where);
	if (!status && load)
		status = hawser__read_integer(reader, &h->load_power, load, 1, 9, place);
	if (!status && !f && !D && !K && !Q && !json_object_get(object, "C") &&
	    !json_object_get(object, "terms"))
		return hawser__wrong(reader, "%s has none of f, D, K, Q, C and terms: give what it drives",
		                     where);
	if (!status)
		status = read_term(reader, &h->f, &h->D, &h->K, n, object, where);
	snprintf(place, sizeof place, "%s.Q", where);
	if (!status && Q)
		status = read_entries(reader, h->Q = hawser__entries_room(3, json_array_size(Q)), &h->quads, 3,
		                      n, Q, place);
	return status ? status : read_harmonic_terms(reader, h, n, object, where);
}

static enum hawser_status read_harmonics(const struct hawser__parser *reader,
                                         struct hawser_rom *rom, const json_t *list)
{
	enum hawser_status status = HAWSER_OK;
	size_t count = json_array_size(list);

	if (!json_is_array(list))
		return unwanted(reader, "harmonics", list, "a list of objects");
	if (count && !(rom->harmonic = calloc(count, sizeof *rom->harmonic)))
		return hawser__no_memory(reader->report, "rom");
	rom->harmonics = (int)count;
	for (size_t i = 0; !status && i < count; i++) {
		char where[32];

		snprintf(where, sizeof where, "harmonics[%zu]", i);
		status = read_harmonic(reader, &rom->harmonic[i], rom->n, json_array_get(list, i),
		                       where);
	}
	return status;
}

const char *const hawser__ramp_names[HAWSER_RAMP_TERMS] = {"linear", "square", "rate"};

static enum hawser_status read_ramp(const struct hawser__parser *reader, struct hawser_rom *rom,
                                    json_t *object)
{
	static const char *const keys[] = {"time", "linear", "square", "rate", NULL};
	static const char *const parts[] = {"f", "D", "K", "answer", NULL};
	enum hawser_status status = hawser__read_keys(reader, object, keys, "ramp");

	if (status)
		return status;
	if (!(rom->ramp = calloc(1, sizeof *rom->ramp)))
		return hawser__no_memory(reader->report, "rom");
	status = hawser__read_positive(reader, &rom->ramp->time, object, "time", "ramp");
	for (int p = 0; !status && p < HAWSER_RAMP_TERMS; p++) {
		struct hawser_ramp_term *term = &rom->ramp->term[p];
		json_t *part = json_object_get(object, hawser__ramp_names[p]);
		char where[32];

		if (!part)
			continue;
		snprintf(where, sizeof where, "ramp.%s", hawser__ramp_names[p]);
		status = hawser__read_keys(reader, part, parts, where);
		if (!status)
			status = read_term(reader, &term->f, &term->D, &term->K, rom->n, part, where);
	}
	return status;
}

/* n and K, which every model has. */
static enum hawser_status read_size(const struct hawser__parser *reader, struct hawser_rom *rom,
                                    const json_t *root)
{
	const json_t *version = json_object_get(root, "hawser_rom");
	enum hawser_status status;
	int n = 0, one;

	if (version && (status = hawser__read_integer(reader, &one, version, 1, 1,
	                                      "hawser_rom (the version of the format)")))
		return status;
	status = hawser__read_integer(reader, &n, json_object_get(root, "n"), 1, HAWSER_ROM_MOST, "n");
	if (!status)
		status = hawser__rom_init_most(rom, n, HAWSER_ROM_MOST, reader->report);
	if (!status)
		status = read_matrix(reader, &rom->K, n, json_object_get(root, "K"), "K");
	return status;
}

/* Errors that only the complete model shows are reported as errors of the file as well. */
static enum hawser_status compile(const struct hawser__parser *reader, struct hawser_rom *rom)
{
	struct hawser_report report = {.message = ""};
	enum hawser_status status = hawser_rom_compile(rom, &report);

	if (status == HAWSER_ERR_ARGUMENT)
		return hawser__wrong(reader, "%s", report.message);
	if (status && reader->report)
		*reader->report = report;
	return status;
}

enum hawser_status hawser__read_model(const struct hawser__parser *reader, struct hawser_rom *rom,
                                      json_t *root)
{
	static const char *const keys[] = {"hawser_rom", "n", "D", "K", "Q", "C", "harmonics", "ramp",
		"M", "terms", "first_order", "relaxation", "parameters", "periods", "labels",
		"second_order_shapes", "scale", "shapes", "range", "contacts", "known", "ends", "command",
		"version", "scene", "stats", "accuracy", "warnings", "columns", "comment", NULL};
	const json_t *D = json_object_get(root, "D"), *Q = json_object_get(root, "Q");
	const json_t *C = json_object_get(root, "C"), *list = json_object_get(root, "harmonics");
	const json_t *shapes = json_object_get(root, "second_order_shapes");
	json_t *ramp = json_object_get(root, "ramp");
	enum hawser_status status = hawser__read_keys(reader, root, keys, "the model");

	if (!status)
		status = read_size(reader, rom, root);
	if (!status && D)
		status = read_matrix(reader, &rom->D, rom->n, D, "D");
	if (!status && Q)
		status = read_entries(reader, rom->Q = hawser__entries_room(3, json_array_size(Q)),
		                      &rom->quads, 3, rom->n, Q, "Q");
	if (!status && C)
		status = read_entries(reader, rom->C = hawser__entries_room(4, json_array_size(C)),
		                      &rom->cubics, 4, rom->n, C, "C");
	if (!status && list)
		status = read_harmonics(reader, rom, list);
	if (!status && ramp)
		status = read_ramp(reader, rom, ramp);
	if (!status && shapes)
		status = hawser__read_integer(reader, &rom->inertia.shapes, shapes, 0, rom->n - 1,
		                      "second_order_shapes");
	if (!status)
		status = hawser__read_extras(reader, rom, root);
	if (!status)
		status = hawser__read_own(reader, rom, root);
	return status ? status : compile(reader, rom);
}

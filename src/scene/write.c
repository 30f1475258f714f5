/* scene/write.c - write a scene as YAML in SI, with the defaults in use.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "scene/keys.h"

/* Write a number with 15 to 17 digits, as few as give the same number when read. */
static void number(FILE *stream, double value)
{
	char text[40];

	if (isinf(value)) {
		fputs(value > 0.0 ? ".inf" : "-.inf", stream);
		return;
	}
	for (int digits = 15; digits <= 17; digits++) {
		snprintf(text, sizeof text, "%.*g", digits, value);
		if (strtod(text, NULL) == value)
			break;
	}
	fputs(text, stream);
}

static void value(FILE *stream, const struct hawser_scene *scene, int index, int item,
                  const char *words)
{
	const struct hawser__row *row = &hawser__rows()[index];
	int count = hawser__count(scene, index), choice;
	char word[HAWSER_WORD_SIZE];

	if (hawser__is_word(scene, index)) {
		memcpy(&choice, (const char *)scene + row->offset, sizeof choice);
		hawser__word(word, sizeof word, words, choice);
		fputs(word, stream);
		return;
	}
	fputs(count ? "[" : "", stream);
	for (int i = 0; i < (count ? count : 1); i++) {
		fputs(i ? ", " : "", stream);
		number(stream, hawser__stored(scene, index, i, item));
	}
	fputs(count ? "]" : "", stream);
}

static int depth_of(const char *path, size_t length)
{
	int depth = 0;

	for (size_t i = 0; i < length; i++)
		depth += path[i] == '.';
	return depth;
}

/* Write the headers of the sections of `path` that do not contain the previous key: "damping:",
 * "  rayleigh:". */
static void sections(FILE *stream, const char *path, const char *before)
{
	for (const char *dot = strchr(path, '.'); dot; dot = strchr(dot + 1, '.')) {
		size_t length = (size_t)(dot - path), start = length;

		if (!strncmp(path, before, length + 1))
			continue;
		while (start && path[start - 1] != '.')
			start--;
		fprintf(stream, "%*s%.*s:\n", 2*depth_of(path, length), "", (int)(length - start),
		        path + start);
	}
}

static void whole(FILE *stream, const struct hawser_scene *scene)
{
	const struct hawser_scene_key *key;
	const char *before = "";

	for (int i = 0; (key = hawser_scene_key(i)); i++) {
		if (!hawser__applies(scene, i))
			continue;
		sections(stream, key->path, before);
		fprintf(stream, "%*s%s: ", 2*depth_of(key->path, strlen(key->path)), "",
		        hawser__leaf(key->path));
		value(stream, scene, i, 0, key->words);
		if (*key->unit && strcmp(key->unit, "1") != 0)
			fprintf(stream, "  # %s", key->unit);
		fputc('\n', stream);
		before = key->path;
	}
}

/* The keys of attachment `item`, as a mapping in a list. */
static void attachment(FILE *stream, const struct hawser_scene *scene, int item)
{
	const struct hawser_attachment *a = &scene->attach[item];
	const struct hawser_scene_key *key;
	const char *separator = "  - {";

	for (int i = 0; (key = hawser_scene_key(i)); i++) {
		enum hawser__type type = hawser__rows()[i].type;

		if (!hawser__is_item(i) || (type == HAWSER__NAME && !*a->name))
			continue;
		fprintf(stream, "%s%s: ", separator, hawser__leaf(key->path));
		separator = ", ";
		if (type == HAWSER__NAME)
			fputs(a->name, stream);
		else
			value(stream, scene, i, item, NULL);
		if (type == HAWSER__PLACE && a->by_length)
			fputs(" m", stream);
	}
	fputs("}\n", stream);
}

static void attachments(FILE *stream, const struct hawser_scene *scene)
{
	if (scene->attachments)
		fputs("attach:\n", stream);
	for (int item = 0; item < scene->attachments; item++)
		attachment(stream, scene, item);
}

static void cases(FILE *stream, const struct hawser_scene *scene)
{
	if (scene->cases)
		fputs("cases:\n", stream);
	for (int i = 0; i < scene->cases; i++) {
		const struct hawser_case *c = &scene->load_case[i];

		fprintf(stream, "  - {name: %s", c->name);
		for (int k = 0; c->loaded && k < 3; k++) {
			fputs(k ? ", " : ", load: {static: {per_length: [", stream);
			number(stream, c->per_length[k]);
		}
		if (c->loaded) {
			fputs("], mass: ", stream);
			number(stream, c->mass);
			fputs("}}", stream);
		}
		if (c->heated) {
			fputs(", temperature: {change: ", stream);
			number(stream, c->change);
			fputs(", expansion: ", stream);
			number(stream, c->expansion);
			fputs("}", stream);
		}
		fputs("}\n", stream);
	}
}

enum hawser_status hawser_scene_write(const struct hawser_scene *scene, FILE *stream,
                                      struct hawser_report *report)
{
	locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
	locale_t own;

	if (!c)
		return hawser__no_memory(report, "scene");
	own = uselocale(c); /* with a decimal point */
	errno = 0;
	whole(stream, scene);
	attachments(stream, scene);
	cases(stream, scene);
	uselocale(own);
	freelocale(c);
	if (fflush(stream) || ferror(stream))
		return hawser__fail(report, HAWSER_ERR_IO, "scene", "cannot write the scene: %s",
		                    strerror(errno));
	return HAWSER_OK;
}

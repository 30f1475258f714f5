/* scene/write.c - write a scene as YAML in SI, with the defaults in use.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/locale.h"
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
	int count = hawser__count(scene, index), choice;
	char word[HAWSER_WORD_SIZE];

	if (hawser__is_word(scene, index)) {
		memcpy(&choice, hawser__field(scene, index, item), sizeof choice);
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

/* Rows of numbers below wind. */
static void rows(FILE *stream, const char *key, const double *value, int count, int columns)
{
	if (count)
		fprintf(stream, "  %s: ", key);
	for (int i = 0; i < count*columns; i++) {
		fputs(i == 0 ? "[[" : i%columns ? ", " : "], [", stream);
		number(stream, value[i]);
	}
	fputs(count ? "]]\n" : "", stream);
}

static void wind_rows(FILE *stream, const struct hawser_wind *wind)
{
	rows(stream, "profile", wind->profile[0], wind->profiles, 2);
	rows(stream, "table", wind->table[0], wind->tables, 3);
	rows(stream, "reynolds", wind->reynolds[0], wind->crises, 2);
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
		if (!strcmp(key->path, "wind.form"))
			wind_rows(stream, &scene->wind);
		before = key->path;
	}
}

/* Of the keys of a load, those of a force are not written beside those of a force per length. */
static int told(const struct hawser_scene *scene, const struct hawser__items *list, int index,
                int item)
{
	static const char *const lengthwise[] = {"per_length", "from", "to", "wave"};
	const char *leaf = hawser__leaf(hawser_scene_key(index)->path);
	const double *force = scene->piece[item].force;
	int point = force[0] != 0.0 || force[1] != 0.0 || force[2] != 0.0;

	if (hawser__row(index)->type == HAWSER__TREE_TEXT)
		return *hawser__item_name(list, scene, item) != '\0';
	if (list != hawser__list_row(HAWSER__LOADS))
		return 1;
	for (size_t i = 0; i < sizeof lengthwise/sizeof *lengthwise; i++)
		if (!strcmp(leaf, lengthwise[i]))
			return !point;
	return point || (strcmp(leaf, "force") != 0 && strcmp(leaf, "at") != 0);
}

/* The keys of an item, as a mapping in a list. */
static void one(FILE *stream, const struct hawser_scene *scene, const struct hawser__items *list,
                int item)
{
	const struct hawser_scene_key *key;
	const char *separator = "  - {";
	int by_length;

	for (int i = 0; (key = hawser_scene_key(i)); i++) {
		enum hawser__tree_type type = hawser__row(i)->type;

		if (hawser__list_of(i) != list || !told(scene, list, i, item))
			continue;
		fprintf(stream, "%s%s: ", separator, hawser__leaf(key->path));
		separator = ", ";
		if (type == HAWSER__TREE_TEXT)
			fputs(hawser__item_name(list, scene, item), stream);
		else
			value(stream, scene, i, item, key->words);
		if (type != HAWSER__TREE_POSITION)
			continue;
		memcpy(&by_length, (const char *)hawser__field(scene, i, item) + sizeof(double),
		       sizeof by_length);
		fputs(by_length ? " m" : "", stream);
	}
	fputs("}\n", stream);
}

static void items(FILE *stream, const struct hawser_scene *scene)
{
	const struct hawser__items *list;

	for (int l = 0; (list = hawser__list_row(l)); l++) {
		int count = l == HAWSER__CASES ? 0 : *hawser__list_count(list, scene);

		if (count)
			fprintf(stream, "%s:\n", list->name);
		for (int item = 0; item < count; item++)
			one(stream, scene, list, item);
	}
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
		if (c->wind > 0.0) {
			fputs(", wind: {speed: ", stream);
			number(stream, c->wind);
			fputs("}", stream);
		}
		fputs("}\n", stream);
	}
}

enum hawser_status hawser_scene_write(const struct hawser_scene *scene, FILE *stream,
                                      struct hawser_report *report)
{
	struct hawser__locale locale;

	hawser__locale_begin(&locale);
	errno = 0;
	whole(stream, scene);
	items(stream, scene);
	cases(stream, scene);
	hawser__locale_end(&locale);
	if (fflush(stream) || ferror(stream))
		return hawser__fail(report, HAWSER_ERR_IO, "scene", "cannot write the scene: %s",
		                    strerror(errno));
	return HAWSER_OK;
}

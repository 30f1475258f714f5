/* tests/fuzz/fuzz-set.c - any lines as --set, one after another, for a valid scene. Each key is
 * also read, and each value also parsed as a frequency.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tests/fuzz/fuzz.h"

enum { MOST = 16 };

static const char base[] =
	"cable: {EA: 4e8, rho: 6}\nspan: {d: 250, h: 10}\ntension: {T0: 8e4}\n"
	"damping: {alpha: 0.08}\nload: {frame: local, per_length: [0.8, 0.8, 0.8]}\n";

/* Calls of the library with the parts of an option. */
static void ask(const struct hawser_scene *scene, char *set)
{
	struct hawser_report report = {.message = ""};
	char *equals = strchr(set, '='), word[HAWSER_WORD_SIZE];
	struct hawser_scene copy = *scene;
	double value = 2.385;

	if (!equals)
		return;
	*equals = '\0';
	if (hawser_scene_word(scene, word, set, &report))
		demand(is_message(report.message), "a word is refused with a reason", report.message);
	if (hawser_scene_get(scene, &value, set, &report))
		demand(is_message(report.message), "a key is refused with a reason", report.message);
	if (hawser_unit_parse(&value, equals + 1, "rad/s", &report))
		demand(is_message(report.message), "a number is refused with a reason",
		       report.message);
	if (hawser_scene_set(&copy, set, value, &report))
		demand(is_message(report.message), "a value is refused with a reason",
		       report.message);
	else
		demand(is_sound(&copy), "a scene that was set is sound", set);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct hawser_report report = {.message = ""};
	struct hawser_scene scene;
	char *text = malloc(size + 1), *next;
	const char *set[MOST];
	size_t count = 0;
	enum hawser_status status;

	memcpy(text, data, size);
	text[size] = '\0';
	for (next = text; next && count < MOST; count++) {
		set[count] = next;
		next = strchr(next, '\n');
		if (next)
			*next++ = '\0';
	}
	status = read_scene(&scene, base, sizeof base - 1, set, count, &report);
	if (status) {
		demand(status == HAWSER_ERR_SCENE && is_message(report.message) &&
		       (!strncmp(report.message, "--set ", 6) ||
		        !strncmp(report.message, "s.yaml:", 7)),
		       "an override is refused with its place", report.message);
	} else {
		check_scene(&scene);
		for (size_t i = 0; i < count; i++)
			ask(&scene, (char *)set[i]);
	}
	hawser_scene_clear(&scene);
	free(text);
	return 0;
}

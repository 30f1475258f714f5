/* Damaged scenes: every prefix, and every single byte replaced, removed or doubled, gives a valid
 * scene or a scene error with a place.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

/* short, because each scene with a unit reads udunits2's database */
static const char with_units[] =
	"cable: {EA: 4 N, rho: 6}\nspan: {d: 2, h: 0}\ntension: {H: 8}\n";

static const char plain[] =
	"g: 9.81\ncable: {EA: .inf, rho: 6}\nspan: {d: 250, h: -1e1}\n"
	"tension:\n  sag: '8.25'\ndamping: {alpha: 0.08}\n"
	"load:\n  frame: local\n  per_length: [0.8, 0.8, \"0\"]\n  extent:\n    - 0\n    - .5\n"
	"model: {modes: 5, tolerance: 1.e-9}\n";

static int sound(const struct hawser_scene *scene)
{
	return scene->cable.EA > 0.0 && scene->cable.rho > 0.0 && scene->span.d > 0.0 &&
	       isfinite(scene->span.h) && scene->g > 0.0 && scene->tension.value > 0.0 &&
	       isfinite(scene->tension.value) && scene->tension.given != HAWSER_GIVEN_NONE &&
	       scene->load.extent[0] < scene->load.extent[1] && scene->model.modes > 0 &&
	       scene->model.tolerance > 0.0 && scene->name;
}

static int read_count, good_count;

/* 0 if the result for these bytes is correct. */
static int misbehaves(const char *text, size_t length)
{
	struct hawser_scene scene;
	struct hawser_report report = {.message = ""};
	enum hawser_status status = read_bytes(&scene, text, length, NULL, 0, &report);
	int wrong;

	read_count++;
	good_count += status == HAWSER_OK;
	if (status == HAWSER_OK)
		wrong = !sound(&scene);
	else
		wrong = status != HAWSER_ERR_SCENE || strncmp(report.message, "s.yaml:", 7) ||
		        strlen(report.message) < 20;
	if (wrong)
		printf("# status %d, %s, from:\n# %.*s\n", status, report.message, (int)length, text);
	hawser_scene_clear(&scene);
	return wrong;
}

static void prefixes(const char *text)
{
	int wrong = 0;

	for (size_t length = 0; length <= strlen(text); length++)
		wrong += misbehaves(text, length);
	ok(wrong == 0, "every prefix");
}

static void replaced(const char *text, const char *bytes, size_t nbytes)
{
	size_t length = strlen(text), step = nbytes > 1 && !getenv("HAWSER_LONG") ? 3 : 1;
	char *copy = malloc(length + 2);
	int wrong = 0;

	/* of many bytes each place gets every third, the next place the next ones; with HAWSER_LONG all */
	for (size_t at = 0; at < length; at++)
		for (size_t i = at % step; i < nbytes; i += step) {
			memcpy(copy, text, length + 1);
			copy[at] = bytes[i];
			wrong += misbehaves(copy, length);
		}
	ok(wrong == 0, "every byte replaced");
	free(copy);
}

static void removed_and_doubled(const char *text)
{
	size_t length = strlen(text);
	char *copy = malloc(length + 2);
	int wrong = 0;

	for (size_t at = 0; at < length; at++) {
		memcpy(copy, text, at);
		memcpy(copy + at, text + at + 1, length - at - 1);
		wrong += misbehaves(copy, length - 1);
		memcpy(copy, text, at + 1);
		memcpy(copy + at + 1, text + at, length - at);
		wrong += misbehaves(copy, length + 1);
	}
	ok(wrong == 0, "every byte removed, and doubled");
	free(copy);
}

CASE(unit_scene_fuzz)
{
	static const char many[] = "\0\n \"#&'*,-0:?[]{|\xff";

	prefixes(plain);
	prefixes(with_units);
	replaced(plain, many, sizeof many - 1);
	removed_and_doubled(plain);
	replaced(with_units, "9", 1);
	ok(good_count > 100 && good_count < read_count/2, "%d of %d were still scenes", good_count,
	   read_count);
	return done_testing();
}

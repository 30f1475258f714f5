/* Random scenes: overriding every key of one scene with the values of another gives the other one;
 * writing and reading a scene gives the same scene. The routes share only the parsing of values.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdint.h>

#include "tests/tap.h"
#include "tests/unit/scene-text.h"

enum { PAIRS = 25, SCENES = 40 };

/* A scene as a list of keys and values. */
struct listing {
	int n;
	char path[PAIRS][40], value[PAIRS][80];
};

static uint64_t seed = 20180614;

static unsigned draw(unsigned below)
{
	seed = seed*6364136223846793005ULL + 1442695040888963407ULL;
	return (unsigned)(seed >> 33)%below;
}

/* A positive number of any size, sometimes with an exponent. */
static const char *number(char *text, size_t size)
{
	snprintf(text, size, draw(2) ? "%u.%03u" : "%u.%03ue%d", 1 + draw(999), draw(1000),
	         (int)draw(13) - 6);
	return text;
}

static void add(struct listing *list, const char *path, const char *value)
{
	snprintf(list->path[list->n], sizeof *list->path, "%s", path);
	snprintf(list->value[list->n++], sizeof *list->value, "%s", value);
}

static void add_number(struct listing *list, const char *path)
{
	char text[40];

	add(list, path, number(text, sizeof text));
}

/* `bends`: with bending stiffness, so that lists of the same scene agree about it. */
static void random_list(struct listing *list, unsigned bends)
{
	static const char *const tension[] = {"tension.H", "tension.T0", "tension.T1",
	                                      "tension.length0", "tension.sag"};
	static const char *const always[] = {"g", "cable.EA", "cable.rho", "span.d", "span.h"};
	unsigned choice = draw(5), kind = draw(3);
	char text[80], a[24], b[24], c[24];

	list->n = 0;
	for (size_t i = 0; i < sizeof always/sizeof *always; i++) {
		if (i == 3 && bends) {
			add_number(list, "cable.EI");
			add(list, "ends.A", draw(2) ? "clamped" : "pinned");
			add_number(list, "ends.B");
		} else if (i == 3) {
			add(list, "cable.EI", "0");
		}
		add_number(list, always[i]);
	}
	add_number(list, tension[choice]);
	if (choice == 1 || choice == 2)
		add(list, "tension.branch", draw(2) ? "slack" : "taut");
	if (kind == 0)
		add_number(list, "damping.alpha");
	snprintf(text, sizeof text, "[%s, %s, %s]", number(a, sizeof a), number(b, sizeof b),
	         number(c, sizeof c));
	if (kind == 1 && draw(2))
		add(list, "damping.ratio", text);
	else if (kind == 1)
		add_number(list, "damping.ratio");
	if (kind == 2) {
		add_number(list, "damping.rayleigh.mass");
		add_number(list, "damping.rayleigh.stiffness");
	}
	add(list, "load.frame", draw(2) ? "local" : "global");
	snprintf(text, sizeof text, "[-%s, %s, %s]", number(a, sizeof a), number(b, sizeof b),
	         number(c, sizeof c));
	add(list, "load.per_length", text);
	snprintf(text, sizeof text, "[0.%03u, 0.%03u]", draw(500), 500 + draw(500));
	add(list, "load.extent", text);
	snprintf(text, sizeof text, "%u", 1 + draw(40));
	add(list, "model.modes", draw(4) ? text : "auto");
	add(list, "model.accuracy", draw(2) ? "0.25 %" : "3e-4");
	add(list, "model.basis", text);
	add(list, "model.tolerance", "1.5e-9");
	add(list, "model.condense", draw(2) ? "none" : "static");
	add(list, "model.inertia", draw(2) ? "none" : "auto");
	add(list, "model.energy", !bends && draw(2) ? "exact" : "quartic");
}

/* The list as a file: one mapping per section, in flow style. */
static void as_file(char *text, size_t size, const struct listing *list)
{
	size_t used = 0;
	char open[40] = "";

	for (int i = 0; i < list->n; i++) {
		char section[40], name[40], *dot;
		const char *next = i + 1 < list->n ? list->path[i + 1] : "";

		snprintf(section, sizeof section, "%s", list->path[i]);
		dot = strrchr(section, '.');
		snprintf(name, sizeof name, "%s", dot ? dot + 1 : section);
		if (dot)
			*dot = '\0';
		if (!dot)
			section[0] = '\0';
		if (*section && strcmp(section, open))
			used += (size_t)snprintf(text + used, size - used,
			                         strchr(section, '.') ? "damping: {rayleigh: {" : "%s: {",
			                         section);
		used += (size_t)snprintf(text + used, size - used, "%s: %s", name, list->value[i]);
		if (*section && !strncmp(next, section, strlen(section)) &&
		    next[strlen(section)] == '.')
			used += (size_t)snprintf(text + used, size - used, ", ");
		else
			used += (size_t)snprintf(text + used, size - used, "%s\n",
			                         strchr(section, '.') ? "}}" : *section ? "}" : "");
		snprintf(open, sizeof open, "%s", section);
	}
}

/* Everything except the name, byte by byte: both are zeroed before they are filled. */
static int same(struct hawser_scene *a, struct hawser_scene *b)
{
	struct hawser_scene x = *a, y = *b;

	x.name = y.name = NULL;
	return !memcmp(&x, &y, sizeof x);
}

static int set_is_edit(void)
{
	static struct listing one, other;
	static char text_one[2048], text_other[2048], overrides[PAIRS][128];
	const char *set[PAIRS];
	struct hawser_scene edited, overridden;
	struct hawser_report report = {.message = ""};
	unsigned bends = draw(2);
	int equal;

	random_list(&one, bends);
	random_list(&other, bends);
	as_file(text_one, sizeof text_one, &one);
	as_file(text_other, sizeof text_other, &other);
	for (int i = 0; i < other.n; i++) {
		snprintf(overrides[i], sizeof overrides[i], "%s=%s", other.path[i], other.value[i]);
		set[i] = overrides[i];
	}
	if (read_text(&edited, text_other, NULL, &report) != HAWSER_OK ||
	    read_bytes(&overridden, text_one, strlen(text_one), set, (size_t)other.n, &report) !=
	            HAWSER_OK) {
		printf("# %s\n# %s\n# %s\n", report.message, text_one, text_other);
		return 0;
	}
	equal = same(&edited, &overridden);
	if (!equal)
		printf("# %s# overridden by\n%s\n", text_one, text_other);
	hawser_scene_clear(&edited);
	hawser_scene_clear(&overridden);
	return equal;
}

static int survives_writing(void)
{
	static struct listing list;
	static char text[2048];
	struct hawser_scene scene, again;
	struct hawser_report report;
	char *written = NULL;
	size_t length = 0;
	FILE *stream = open_memstream(&written, &length);
	int equal;

	random_list(&list, draw(2));
	as_file(text, sizeof text, &list);
	if (read_text(&scene, text, NULL, &report) != HAWSER_OK ||
	    hawser_scene_write(&scene, stream, &report) != HAWSER_OK)
		return 0;
	fclose(stream);
	if (read_text(&again, written, NULL, &report) != HAWSER_OK)
		return 0;
	equal = same(&scene, &again);
	free(written);
	hawser_scene_clear(&scene);
	hawser_scene_clear(&again);
	return equal;
}

CASE(unit_scene_property)
{
	int edits = 0, writings = 0;

	for (int i = 0; i < SCENES; i++) {
		edits += set_is_edit();
		writings += survives_writing();
	}
	ok(edits == SCENES, "overrides are edits in %d of %d scenes", edits, SCENES);
	ok(writings == SCENES, "writing loses nothing in %d of %d scenes", writings, SCENES);
	return done_testing();
}

/* scene/suggest.c - nearest key by edit distance. Keys of the same section are preferred, since a
 * typing error is more likely than a wrong section.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdio.h>
#include <string.h>

#include "core/spelling.h"
#include "scene/keys.h"
#include "scene/suggest.h"

enum { LONGEST = 63 };

static int least(int a, int b)
{
	return a < b ? a : b;
}

struct search {
	const char *path, *name; /* what was written */
	const char *best;
	int distance;
};

static void offer(struct search *search, const char *candidate, int distance)
{
	if (distance >= search->distance)
		return;
	search->distance = distance;
	search->best = candidate;
}

/* Call `visit` for every key and section, in the order of the table. */
static void each(struct search *search, const char *section,
                 void (*visit)(struct search *, const char *, const char *))
{
	size_t count;
	const struct hawser__section *sections = hawser__sections(&count);

	for (size_t i = 0; i < count; i++)
		visit(search, sections[i].path, section);
	for (int i = 0; hawser_scene_key(i); i++)
		visit(search, hawser_scene_key(i)->path, section);
}

static void sibling(struct search *search, const char *candidate, const char *section)
{
	if (hawser__child_of(candidate, section))
		offer(search, candidate,
		      hawser__edit_distance(search->name, hawser__leaf(candidate)));
}

static const char *below(const char *path, const char *section);

/* In the sections of `section`. */
static void nested(struct search *search, const char *candidate, const char *section)
{
	if (*section && below(candidate, section))
		offer(search, candidate,
		      hawser__edit_distance(search->name, hawser__leaf(candidate)));
}

static void anywhere(struct search *search, const char *candidate, const char *section)
{
	(void)section;
	offer(search, candidate, least(hawser__edit_distance(search->name, hawser__leaf(candidate)),
	                               hawser__edit_distance(search->path, candidate)));
}

static void parent(char *section, size_t size, const char *path)
{
	snprintf(section, size, "%.*s", (int)hawser__parent_length(path), path);
}

const char *hawser__nearest(const char *path)
{
	struct search search = {.path = path, .name = hawser__leaf(path)};
	char section[LONGEST + 1];
	int limit = hawser__edit_limit(strlen(search.name)) + 1;

	parent(section, sizeof section, path);
	search.distance = limit;
	each(&search, section, sibling);
	if (!search.best)
		each(&search, section, nested);
	if (!search.best)
		each(&search, section, anywhere);
	return search.best;
}

/* The part of `path` below `section`: "rayleigh.mass" for "damping"; NULL if `path` is not in
 * it. */
static const char *below(const char *path, const char *section)
{
	size_t length = strlen(section);

	if (!length)
		return path;
	return !strncmp(path, section, length) && path[length] == '.' ? path + length + 1 : NULL;
}

void hawser__list(char *hint, size_t size, const char *section)
{
	const struct hawser_scene_key *key;
	size_t used;
	const char *separator = "", *last = "";

	used = (size_t)snprintf(hint, size, "%s takes ", *section ? section : "a scene");
	for (int i = 0; used < size && (key = hawser_scene_key(i)); i++) {
		const char *child = below(key->path, section);
		size_t length = child ? strcspn(child, ".") : 0;

		/* the keys of a subsection are adjacent and are listed once */
		if (!child || (!strncmp(child, last, length) && last[length] == '.'))
			continue;
		used += (size_t)snprintf(hint + used, size - used, "%s%.*s", separator, (int)length,
		                         child);
		separator = ", ";
		last = child;
	}
	if (!*section && used < size) /* a list whose items are not rows of the table */
		snprintf(hint + used, size - used, ", cases");
}

void hawser__suggest(char *hint, size_t size, const char *path)
{
	const char *best = hawser__nearest(path);
	char section[LONGEST + 1];

	parent(section, sizeof section, path);
	if (!best)
		hawser__list(hint, size, hawser__section_find(section) >= 0 ? section : "");
	else if (hawser__child_of(best, section))
		snprintf(hint, size, "did you mean %s?", best);
	else if (hawser__parent_length(best) == 0)
		snprintf(hint, size, "did you mean %s at the top level?", best);
	else
		snprintf(hint, size, "did you mean %s under %.*s?", hawser__leaf(best),
		         (int)hawser__parent_length(best), best);
}

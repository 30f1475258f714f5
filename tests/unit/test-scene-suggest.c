/* Suggestions: the edit distance against a slow recursive one, its invariants, and the
 * suggestion as the argument of its minimum over the table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <ctype.h>
#include <stdint.h>
#include <stdlib.h>

#include "core/spelling.h"
#include "scene/keys.h"
#include "scene/suggest.h"
#include "tests/tap.h"

static uint64_t seed = 20221007;

static unsigned draw(unsigned below)
{
	seed = seed*6364136223846793005ULL + 1442695040888963407ULL;
	return (unsigned)(seed >> 33)%below;
}

static int least(int a, int b)
{
	return a < b ? a : b;
}

/* The recursive definition, from the front, without a table. */
static int slow(const char *a, const char *b)
{
	int best;

	if (!*a || !*b)
		return 2*(int)(strlen(a) + strlen(b));
	best = least(slow(a + 1, b), slow(a, b + 1)) + 2;
	best = least(best, slow(a + 1, b + 1) +
	                   (*a == *b ? 0 : tolower(*a) == tolower(*b) ? 1 : 2));
	if (a[1] && b[1] && a[0] == b[1] && a[1] == b[0])
		best = least(best, slow(a + 2, b + 2) + 2);
	return best;
}

static void random_word(char *word, unsigned longest)
{
	unsigned length = draw(longest + 1);

	for (unsigned i = 0; i < length; i++)
		word[i] = "abAB0"[draw(5)];
	word[length] = '\0';
}

static void distances(void)
{
	int wrong = 0, skew = 0, apart = 0;

	ok(hawser__edit_distance("EA", "Ea") == 1, "a slip of the shift key costs 1");
	ok(hawser__edit_distance("sapn", "span") == 2, "two letters swapped cost 2");
	ok(hawser__edit_distance("tenson", "tension") == 2, "a letter left out costs 2");
	ok(hawser__edit_distance("", "rho") == 6, "from nothing");
	for (int i = 0; i < 2000; i++) {
		char a[8], b[8];

		random_word(a, 6);
		random_word(b, 6);
		wrong += hawser__edit_distance(a, b) != slow(a, b);
		skew += hawser__edit_distance(a, b) != hawser__edit_distance(b, a);
		apart += (hawser__edit_distance(a, b) == 0) != !strcmp(a, b);
	}
	ok(wrong == 0, "2000 pairs agree with the definition");
	ok(skew == 0 && apart == 0, "symmetric, and zero for equals only");
}

static const char *candidate(size_t i)
{
	size_t nsections;
	const struct hawser__section *sections = hawser__sections(&nsections);
	const struct hawser_scene_key *key;

	if (i < nsections)
		return sections[i].path;
	key = hawser_scene_key((int)(i - nsections));
	return key ? key->path : NULL;
}

/* Least cost of any candidate: among siblings, or by last component and whole path. */
static int minimum(const char *path, int siblings)
{
	const char *dot = strrchr(path, '.');
	const char *name = dot ? dot + 1 : path, *other;
	char section[64];
	int best = 2*(int)strlen(name) + 2;

	snprintf(section, sizeof section, "%.*s", dot ? (int)(dot - path) : 0, path);
	for (size_t i = 0; (other = candidate(i)); i++) {
		const char *end = strrchr(other, '.');

		if (siblings && !hawser__child_of(other, section))
			continue;
		end = end ? end + 1 : other;
		/* each letter more or less costs 2; the slow distance is exponential */
		if (2*abs((int)strlen(name) - (int)strlen(end)) < best)
			best = least(best, slow(name, end));
		if (!siblings)
			best = least(best, hawser__edit_distance(path, other));
	}
	return best;
}

static int cost(const char *path, const char *answer, int siblings)
{
	const char *dot = strrchr(path, '.'), *end = strrchr(answer, '.');
	int byname = slow(dot ? dot + 1 : path, end ? end + 1 : answer);

	return siblings ? byname : least(byname, hawser__edit_distance(path, answer));
}

/* A key of the table with one or two random edits of its last component. */
static void misspell(char *path, size_t size, const char *key)
{
	size_t length;
	size_t start = (size_t)(hawser__leaf(key) - key);

	snprintf(path, size, "%s", key);
	length = strlen(path);
	for (unsigned edits = 1 + draw(2); edits; edits--) {
		size_t at = start + draw((unsigned)(length - start));

		path[at] = "abdehlmoprtAETH"[draw(15)];
	}
}

static void nearest(void)
{
	int wrong = 0, near = 0, none = 0;
	unsigned keys = 0;

	while (hawser_scene_key((int)keys))
		keys++;
	for (int i = 0; i < 1500; i++) {
		const char *key = hawser_scene_key((int)draw(keys))->path;
		char path[64];

		if (strlen(hawser__leaf(key)) > 6)
			continue; /* the slow distance is exponential */
		misspell(path, sizeof path, key);

		const char *answer = hawser__nearest(path);
		int limit = hawser__edit_limit(strlen(hawser__leaf(path)));
		int siblings = minimum(path, 1) <= limit, best = minimum(path, siblings);

		if (!answer) {
			none++;
			wrong += best <= limit;
		} else {
			near++;
			wrong += best > limit || cost(path, answer, siblings) != best;
		}
	}
	ok(wrong == 0, "the suggestion is the nearest key (%d suggestions, %d without)", near, none);
	ok(near > 100 && none > 10, "both cases met");
}

static void sentences(void)
{
	static const struct {
		const char *path, *hint;
	} table[] = {
		{"cable.Ea", "did you mean cable.EA?"},
		{"sapn", "did you mean span?"},
		{"tension.TO", "did you mean tension.T0?"},
		{"damping.rayliegh", "did you mean damping.rayleigh?"},
		{"EA", "did you mean EA under cable?"},
		{"cable.EA.x", "a scene takes g, cable, ends, span, tension, travel, support, damping, load, "
		               "temperature, attach, loads, model, beam, cases"},
		{"cable.alpha", "did you mean alpha under damping?"},
		{"cable.g", "did you mean g at the top level?"},
		{"damping.stiffness", "did you mean stiffness under damping.rayleigh?"},
		{"cable.youngs_modulus", "cable takes EA, rho, EI"},
		{"damping.viscous", "damping takes alpha, rayleigh, ratio, drag"},
		{"damping.rayleigh.q", "damping.rayleigh takes mass, stiffness"},
		{"x", "a scene takes g, cable, ends, span, tension, travel, "
		      "support, damping, load, temperature, "
		      "attach, loads, model, beam, cases"},
	};
	char hint[256];

	for (size_t i = 0; i < sizeof table/sizeof *table; i++) {
		hawser__suggest(hint, sizeof hint, table[i].path);
		if (!ok(!strcmp(hint, table[i].hint), "unknown key %s", table[i].path))
			printf("# got  %s\n# want %s\n", hint, table[i].hint);
	}
	hawser__suggest(hint, 8, "cable.youngs_modulus");
	ok(strlen(hint) == 7, "a short buffer is filled, not overrun");
}

CASE(unit_scene_suggest)
{
	distances();
	nearest();
	sentences();
	return done_testing();
}

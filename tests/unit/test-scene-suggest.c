/* Suggestions: the edit distance against a slow recursive one, its invariants, and the
 * suggestion as the argument of its minimum over the table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <stdint.h>
#include <stdlib.h>

#include "core/spelling.h"
#include "scene/keys.h"
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

/* The keys of a mapping, and what is suggested for a key that it does not have. */
static const char *suggested(char hint[HAWSER__TEXT_ROOM], const char *of, const char *name)
{
	char keys[HAWSER__TREE_LIST_SIZE];

	hawser__tree_key_list(keys, sizeof keys, of);
	return hawser__tree_suggest(hint, name, of, keys);
}

/* A key with one or two random edits. */
static void misspell(char *name, size_t size, const char *key)
{
	size_t length;

	snprintf(name, size, "%s", key);
	length = strlen(name);
	for (unsigned edits = 1 + draw(2); edits; edits--)
		name[draw((unsigned)length)] = "abdehlmoprtAETH"[draw(15)];
}

/* The least distance of a name from the keys of a mapping or, if it is "", of all. */
static int minimum(const char *name, const char *of)
{
	int best = 1000;

	for (int i = 0; i < hawser__tree_of_span.rows; i++) {
		const char *path = hawser__tree_of_span.row[i].path, *own = strrchr(path, '.') + 1;

		/* each letter more or less costs 2; the slow distance is exponential */
		if ((!*of || hawser__tree_key_of(path, of)) && !strpbrk(own, "[*") &&
		    2*abs((int)strlen(name) - (int)strlen(own)) < best)
			best = least(best, slow(name, own));
	}
	return best;
}

static void nearest(void)
{
	int wrong = 0, near = 0, none = 0, rows = hawser__tree_of_span.rows;

	for (int i = 0; i < 1500; i++) {
		const char *path = hawser__tree_of_span.row[draw((unsigned)rows)].path;
		const char *key = strrchr(path, '.') + 1;
		char of[64], name[64], hint[HAWSER__TEXT_ROOM], want[64] = "";
		int limit, best;

		if (strlen(key) > 6 || strchr(key, '['))
			continue; /* the slow distance is exponential */
		snprintf(of, sizeof of, "%.*s", (int)(key - 1 - path), path);
		misspell(name, sizeof name, key);
		if (strlen(name) == 1 && strchr("ELlTv", *name))
			continue; /* other names of keys */
		limit = hawser__edit_limit(strlen(name));
		best = minimum(name, of);
		if (best > limit) { /* one letter is near every other one */
			best = minimum(name, "");
			best = name[1] || best == 0 ? best : 1000;
		}
		suggested(hint, of, name);
		(void)sscanf(hint, "did you mean %60[^ ?]", want);
		near += best <= limit;
		none += best > limit;
		wrong += best <= limit ? !*want || slow(name, want) != best : *want != '\0';
	}
	ok(wrong == 0, "the suggestion is the nearest key (%d suggestions, %d without)", near, none);
	ok(near > 100 && none > 10, "both cases met");
}

static void sentences(void)
{
	static const struct {
		const char *of, *name, *hint;
	} table[] = {
		{"span.cable", "Ea", "did you mean EA? "},
		{"span", "sapn", "did you mean span? "},
		{"span.tension", "TO", "did you mean T0? "},
		{"span.damping", "rayliegh", "did you mean rayleigh? "},
		{"span", "EA", "did you mean EA under cable? "},
		{"span", "cable.EA", "did you mean EA under cable? "},
		{"span.cable", "alpha", "did you mean alpha under damping? "},
		{"span.cable", "g", "did you mean g at the top level? "},
		{"span.damping", "stiffness", "did you mean stiffness under damping.rayleigh? "},
		{"net.cables[]", "tensio", "did you mean tension? "},
		{"span.cable", "youngs_modulus", ""},
		{"span", "x", ""},
	};
	char hint[HAWSER__TEXT_ROOM];

	for (size_t i = 0; i < sizeof table/sizeof *table; i++)
		if (!ok(!strcmp(suggested(hint, table[i].of, table[i].name), table[i].hint),
		        "unknown key %s", table[i].name))
			printf("# got  %s\n# want %s\n", hint, table[i].hint);
}

CASE(unit_scene_suggest)
{
	distances();
	nearest();
	sentences();
	return done_testing();
}

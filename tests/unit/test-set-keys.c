/* Overrides (--set) of scenes of every kind, those of hawser init and lists besides: each value
 * set to what it is, by each form of its key, gives the same scene; a key that is taken out has its
 * default; an unknown one is refused with a suggestion.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <hawser/net.h>
#include <hawser/obstacles.h>
#include <hawser/rod.h>
#include <hawser/ropeway.h>
#include <hawser/scene.h>
#include <hawser/tow.h>

#include "scene/tree_keys.h"
#include "tests/tap.h"

extern const char cli_init_cable[], cli_init_travelling[], cli_init_beam[], cli_init_net[],
	cli_init_obstacles[], cli_init_ropeway[], cli_init_rod[], cli_init_tow[];

enum { PATH = 200, TEXT = 4000, ARRAYS = 5, SETS = 200 };

union scene {
	struct hawser_scene span;
	struct hawser_net net;
	struct hawser_ropeway ropeway;
	struct hawser_obstacles obstacles;
	struct hawser_rod rod;
	struct hawser_tow tow;
};

#define READER(kind, type) \
	static enum hawser_status read_##kind(union scene *to, const struct hawser_document *from, \
	                                      const char *const *set, size_t n, \
	                                      struct hawser_report *report) \
	{ \
		return type##_of(&to->kind, from, set, n, report); \
	} \
	static void clear_##kind(union scene *scene) \
	{ \
		type##_clear(&scene->kind); \
	}
READER(span, hawser_scene) READER(net, hawser_net) READER(ropeway, hawser_ropeway)
READER(obstacles, hawser_obstacles) READER(rod, hawser_rod) READER(tow, hawser_tow)

/* A list of a structure: where its pointer and its number of items are. */
struct array {
	size_t at, count, size;
};
#define LIST_OF(type, items, count) \
	{offsetof(struct type, items), offsetof(struct type, count), sizeof *((struct type *)0)->items}

static const struct kind {
	const char *name, *text, *more, *table;
	enum hawser_status (*read)(union scene *, const struct hawser_document *, const char *const *,
	                           size_t, struct hawser_report *);
	void (*clear)(union scene *);
	char item; /* names of items of lists, without a name; 0: they have none */
	struct array array[ARRAYS];
} kinds[] = {
	{"cable", cli_init_cable, "attach: [{at: 25 %, mass: 20 kg, damper: [0, 1, 0], name: one}, "
	 "{at: 50 %, mass: 2, spring: [0, 3 N/m, 0]}]\n"
	 "loads: [{per_length: [0, 1 N/m, 0], from: 20 %, to: 40 %, phase: 0.1}]\n", "span",
	 read_span, clear_span, 0, {{0, 0, 0}}},
	{"travelling", cli_init_travelling, "", "span", read_span, clear_span, 0,
	 {{0, 0, 0}}},
	{"beam", cli_init_beam, "", "span", read_span, clear_span, 0, {{0, 0, 0}}},
	{"net", cli_init_net, "obstacles:\n"
	 "  - {circle: {centre: [30, -200, 0], radius: 1}, friction: 0.1}\n"
	 "contact: {restitution: 0.2, steps: 7}\ndynamics: {step: 0.1, rho_inf: 0.7}\n", "net", read_net,
	 clear_net, 'c',
	 {LIST_OF(hawser_net, node, nodes), LIST_OF(hawser_net, cable, cables),
	  LIST_OF(hawser_net, load, loads), LIST_OF(hawser_net, motion, motions),
	  LIST_OF(hawser_net, surface, surfaces)}},
	{"obstacles", cli_init_obstacles, "", "obstacles", read_obstacles, clear_obstacles,
	 's',
	 {LIST_OF(hawser_obstacles, line.sheave, line.sheaves),
	  LIST_OF(hawser_obstacles, obstacle, line.sheaves)}},
	{"ropeway", cli_init_ropeway, "  cases: [{name: half, mass: {up: 1, down: 1}}]\n", "ropeway",
	 read_ropeway, clear_ropeway, 'p',
	 {LIST_OF(hawser_ropeway, tower, towers), LIST_OF(hawser_ropeway, load_case, cases)}},
	{"rod", cli_init_rod, "dynamics: {step: 0.1, rho_inf: 0.7}\n", "rod", read_rod, clear_rod,
	 'i',
	 {LIST_OF(hawser_rod, segment, segments), LIST_OF(hawser_rod, load, loads)}},
	{"tow", cli_init_tow, "", "tow", read_tow, clear_tow, 'p',
	 {LIST_OF(hawser_tow, segment, segments), LIST_OF(hawser_tow, waypoint, waypoints)}},
};

/* Read with up to one override. */
static enum hawser_status with(union scene *to, const struct kind *kind,
                               const struct hawser_document *from, const char *set,
                               struct hawser_report *report)
{
	return kind->read(to, from, set ? &set : NULL, set != NULL, report);
}

/* Are two scenes the same, but for pointers, and for which keys of a span are given? */
static int same(union scene *a, union scene *b, const struct kind *kind)
{
	int good = 1;

	for (int k = 0; k < ARRAYS && kind->array[k].size && good; k++) {
		const struct array *of = &kind->array[k];
		void **x = (void **)(void *)((char *)a + of->at);
		void **y = (void **)(void *)((char *)b + of->at);
		int n = *(int *)(void *)((char *)a + of->count);

		good = n == *(int *)(void *)((char *)b + of->count) &&
		       (!n || !memcmp(*x, *y, (size_t)n*of->size));
	}
	if (kind->read == read_span) {
		struct hawser_scene x = a->span, y = b->span;

		x.name = y.name = NULL;
		memset(x.written, 0, sizeof x.written);
		memset(y.written, 0, sizeof y.written);
		good = !memcmp(&x, &y, sizeof x);
	}
	return good;
}

struct work {
	const struct kind *kind;
	struct hawser_document from;
	char set[SETS][PATH]; /* each value by each form of its key */
	int sets, taken, kept, refused, wrong;
};

static void collect(struct work *work, const char *path, const char *text)
{
	if (work->sets < SETS)
		snprintf(work->set[work->sets++], PATH, "%.120s=%.70s", path, text);
}

/* The scene with overrides from number `first` on is as it is without. */
static int keeps(const struct work *work, int first, int count)
{
	const char *set[SETS];
	union scene plain, other;
	struct hawser_report report = {0};
	int good;

	for (int i = 0; i < count; i++)
		set[i] = work->set[first + i];
	if (with(&plain, work->kind, &work->from, NULL, &report))
		return 0;
	good = work->kind->read(&other, &work->from, set, (size_t)count, &report) == HAWSER_OK;
	if (good) {
		good = same(&plain, &other, work->kind);
		work->kind->clear(&other);
	}
	work->kind->clear(&plain);
	if (!good)
		printf("# %s: %s ...: %s\n", work->kind->name, set[0], report.message);
	return good;
}

/* "path=" is as "path=default". */
static void taken(struct work *work, const char *path, const char *given)
{
	union scene a, b;
	struct hawser_report report = {0}, other = {0};
	char set[2*PATH];
	enum hawser_status one, two;

	snprintf(set, sizeof set, "%s=", path);
	one = with(&a, work->kind, &work->from, set, &report);
	snprintf(set, sizeof set, "%s=%s", path, given);
	two = with(&b, work->kind, &work->from, set, &other);
	work->taken++;
	if (!one && !two && same(&a, &b, work->kind))
		work->kept++;
	else
		printf("# %s: %s= (%s), =%s (%s)\n", work->kind->name, path, report.message, given,
		       other.message);
	if (!one)
		work->kind->clear(&a);
	if (!two)
		work->kind->clear(&b);
}

/* A letter more is refused with the right key, as far as the last part is a key of the table. */
static void mistyped(struct work *work, const char *path)
{
	const char *leaf = strrchr(path, '.') ? strrchr(path, '.') + 1 : path;
	struct hawser_report report = {0};
	char set[2*PATH], hint[PATH];
	union scene scene;

	snprintf(set, sizeof set, "%sq=1", path);
	snprintf(hint, sizeof hint, "did you mean %s?", leaf);
	work->refused++;
	if (with(&scene, work->kind, &work->from, set, &report) == HAWSER_OK)
		work->kind->clear(&scene);
	if (strstr(report.message, hint))
		return;
	work->wrong++;
	printf("# %s: %s: %s\n", work->kind->name, set, report.message);
}

/* The row of the table for a path of the tree, "net.cables[].EA", or NULL. */
static const char *default_of(const char *row)
{
	const struct hawser__tree_key *one;
	char *end;

	for (int i = 0; (one = hawser__tree_row(i)); i++)
		if (!strcmp(one->path, row) && one->given && one->need == HAWSER__TREE_OPTIONAL &&
		    one->type != HAWSER__TREE_TEXT && (strtod(one->given, &end), end != one->given))
			return one->given;
	return NULL;
}

static void visit(struct work *work, const struct hawser__tree *tree, const char *dotted,
                  const char *bracketed, const char *named, const char *row);

static void children(struct work *work, const struct hawser__tree *tree, const char *dotted,
                     const char *bracketed, const char *named, const char *row)
{
	int number = 0;

	for (const struct hawser__tree *one = tree->child; one; one = one->next, number++) {
		const struct hawser__tree *called = hawser__tree_find(one, "name");
		const char *dot = *dotted ? "." : "";
		char a[PATH], b[PATH], c[PATH], d[PATH];

		if (tree->kind == HAWSER__SEQUENCE) {
			snprintf(a, sizeof a, "%.150s.%d", dotted, number);
			snprintf(b, sizeof b, "%.150s[%d]", bracketed, number);
			snprintf(c, sizeof c, "%.150s.%d", named, number);
			if (called)
				snprintf(c, sizeof c, "%.150s.%.30s", named, called->text);
			else if (work->kind->item)
				snprintf(c, sizeof c, "%.150s.%c%d", named, work->kind->item, number);
			snprintf(d, sizeof d, "%.150s[]", row);
		} else {
			snprintf(a, sizeof a, "%.150s%s%.40s", dotted, dot, one->name);
			snprintf(b, sizeof b, "%.150s%s%.40s", bracketed, dot, one->name);
			snprintf(c, sizeof c, "%.150s%s%.40s", named, dot, one->name);
			snprintf(d, sizeof d, "%.150s.%.40s", row, one->name);
		}
		visit(work, one, a, b, c, d);
	}
}

static void visit(struct work *work, const struct hawser__tree *tree, const char *dotted,
                  const char *bracketed, const char *named, const char *row)
{
	const char *given = default_of(row);

	if (given)
		taken(work, dotted, given);
	if (tree->kind != HAWSER__SCALAR) {
		children(work, tree, dotted, bracketed, named, row);
		return;
	}
	collect(work, dotted, tree->text);
	collect(work, bracketed, tree->text);
	collect(work, named, tree->text);
	if (tree->name && strcmp(dotted, "kind") != 0 && strcmp(row, "net.supports.*") != 0 &&
	    !strstr(row, ".nodes.") && !strstr(row, ".masses.") && !strstr(row, ".supports.") &&
	    !strstr(row, ".loads.") && strcmp(tree->name, "name") != 0 && strlen(tree->name) > 1 &&
	    work->sets%2)
		mistyped(work, dotted);
}

CASE(unit_set_keys)
{
	for (size_t k = 0; k < sizeof kinds/sizeof *kinds; k++) {
		struct work work = {.kind = &kinds[k]};
		struct hawser_report report = {0};
		char text[TEXT];
		int all, length = snprintf(text, sizeof text, "%s%s", kinds[k].text, kinds[k].more);
		FILE *stream = fmemopen(text, (size_t)length, "r");

		ok(stream && !hawser_document_read(&work.from, stream, "scene", &report) && work.from.tree,
		   "%s: read %s", kinds[k].name, report.message);
		if (stream)
			fclose(stream);
		children(&work, work.from.tree, "", "", "", kinds[k].table);
		all = keeps(&work, 0, work.sets);
		for (int i = 0; i < work.sets && !all; i++)
			(void)keeps(&work, i, 1);
		ok(work.sets >= 18 && work.sets < SETS && all, "%s: %d values by forms of their keys are kept",
		   kinds[k].name, work.sets);
		ok(work.kept == work.taken, "%s: %d of %d keys that are taken out have their defaults",
		   kinds[k].name, work.kept, work.taken);
		ok(work.refused >= 2 && !work.wrong, "%s: %d of %d mistyped keys are refused with a suggestion",
		   kinds[k].name, work.refused - work.wrong, work.refused);
		hawser_document_clear(&work.from);
	}
	return done_testing();
}

/* Branches that end at rest: two oscillators with cubic terms whose stiffness and coupling vary in
 * time. The motion begins where rest has a multiplier 1. By a second route, this point is a branch
 * point of the branch of rest.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include <hawser/frf.h>

#include "tests/tap.h"

struct example {
	const char *name;
	int k;          /* harmonic of the variation */
	double depth;   /* variation of the first oscillator's stiffness */
	int quads;
	double at;      /* Omega of the first orbit */
	double start[4];
	int folds;      /* the branch from `at` to rest */
};

static const struct example example[] = {
	/* opposite motions are equivalent: the square of the amplitude goes to zero linearly */
	{"half the frequency", 2, 0.15, 0, 1.0, {0.0759527, -0.0009796, -0.5745639, -0.018012}, 0},
	/* quadratic terms distinguish them: the amplitude goes to zero linearly */
	{"quadratic terms", 1, 0.6, 2, 0.98, {0.7819985, 0.0579254, 0.1256801, 0.016918}, 1},
};

static void *copy(const void *from, size_t size)
{
	void *to = malloc(size);

	if (!to)
		abort();
	return memcpy(to, from, size);
}

static void make(struct hawser_rom *rom, const struct example *e)
{
	const double D[] = {0.02, 0.0, 0.0, 0.03}, K[] = {1.0, 0.0, 0.0, 2.25};
	const double varying[] = {e->depth, 0.05, 0.05, 0.15};
	const struct hawser_quad quad[] = {{0, 0, 0, 0.3}, {1, 0, 0, 0.1}};
	const struct hawser_cubic cubic[] = {{0, 0, 0, 0, 0.3}, {0, 0, 1, 1, 0.2}, {1, 0, 0, 1, 0.2},
		{1, 1, 1, 1, 0.4}};

	*rom = (struct hawser_rom){.n = 2, .time = 1.0, .length = 1.0, .harmonics = 1,
		.quads = e->quads, .cubics = 4};
	rom->D = copy(D, sizeof D);
	rom->K = copy(K, sizeof K);
	rom->Q = copy(quad, sizeof quad);
	rom->C = copy(cubic, sizeof cubic);
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	rom->harmonic[0].k = e->k;
	rom->harmonic[0].K = copy(varying, sizeof varying);
	ok(!hawser_rom_compile(rom, NULL), "compiled");
}

/* Relative distance of an event from the nearest branch point of rest, in units of both errors. */
static double from_rest(const struct hawser_frf_event *event, const struct hawser_rom *rom,
                        const struct hawser_frf_options *options)
{
	struct hawser_frf_options straight = *options;
	struct hawser_frf frf;
	double least = INFINITY;

	straight.begin = 0.0;
	straight.start = NULL;
	ok(!hawser_frf_trace(&frf, rom, &straight, NULL) && frf.events == 2, "rest: two branch points");
	for (int i = 0; i < frf.events; i++)
		if (frf.event[i].kind == HAWSER_BRANCH_POINT)
			least = fmin(least, fabs(frf.event[i].omega/event->omega - 1.0)/
			                    (frf.event[i].error + event->error));
	/* the error of the multipliers of rest is 1e-12 */
	for (int i = 0; strcmp(options->method, "balance") == 0 && i < frf.events; i++)
		ok(frf.event[i].error < 1e-9, "the error that it states: %.1e", frf.event[i].error);
	hawser_frf_clear(&frf);
	return least;
}

static void check(const struct example *e, const char *method)
{
	struct hawser_frf_options options = {.method = NULL};
	struct hawser_rom rom;
	struct hawser_frf frf;
	int folds = 0;

	make(&rom, e);
	options.method = method;
	options.from = 1.3;
	options.to = 0.8;
	options.begin = e->at;
	options.start = e->start;
	options.samples = HAWSER_NONE;
	ok(!hawser_frf_trace(&frf, &rom, &options, NULL), "%s, %s: traced", e->name, method);
	ok(frf.end == HAWSER_END_AT_REST && frf.points < 100, "%s, %s: ends %s after %d points", e->name,
	   method, hawser_frf_end_name(frf.end), frf.points);
	for (int i = 0; i < frf.events; i++)
		folds += frf.event[i].kind == HAWSER_FOLD;
	if (ok(folds == e->folds && frf.events == folds + 1, "%s, %s: %d folds and the end", e->name,
	       method, folds)) {
		const struct hawser_frf_event *last = &frf.event[frf.events - 1];
		double away = from_rest(last, &rom, &options);

		ok(last->kind == HAWSER_BRANCH_POINT && last->located && last->error < 1e-9 &&
		   away <= 1.0, "%s, %s: at the branch point of rest, Omega %.12g (error %.1e; %.2g of "
		   "both errors)", e->name, method, last->omega, last->error, away);
	}
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
}

CASE(unit_frf_vanish)
{
	for (size_t i = 0; i < sizeof example/sizeof *example; i++) {
		check(&example[i], "shooting");
		check(&example[i], "balance");
	}
	return done_testing();
}

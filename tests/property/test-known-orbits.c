/* A response that passes orbits which are known from another trace of its curve, about a fold beside
 * a torus point: whichever of them are known, it has the events of the response without them. A step
 * to an orbit behind the fold, where the curve has turned by more than a right angle, would lead back
 * if the direction of its tangent were not known too; a curve that goes back is traced again, in
 * shorter steps.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "response/branch/trace.h"
#include "rom/build/model.h"
#include "tests/tap.h"

static struct hawser_report report;

/* The two lowest modes of a taut cable, in its plane and across, both loaded. */
static int make(struct hawser_rom *rom)
{
	static const double f[2] = {0.0182, 0.0271};

	if (hawser__rom_init(rom, 2, &report))
		return 0;
	rom->K[0] = 1.0;
	rom->K[3] = 1.0127;
	rom->D[0] = 0.0107;
	rom->D[3] = 0.0102;
	rom->cubics = 4;
	rom->C = calloc(4, sizeof *rom->C);
	rom->harmonics = 1;
	rom->harmonic = calloc(1, sizeof *rom->harmonic);
	if (!rom->C || !rom->harmonic)
		return 0;
	rom->C[0] = (struct hawser_cubic){0, 0, 0, 0, 0.35};
	rom->C[1] = (struct hawser_cubic){0, 0, 1, 1, 0.35};
	rom->C[2] = (struct hawser_cubic){1, 0, 0, 1, 0.35};
	rom->C[3] = (struct hawser_cubic){1, 1, 1, 1, 0.35};
	rom->harmonic[0] = (struct hawser_harmonic){.k = 1, .f = calloc(2, sizeof(double))};
	if (!rom->harmonic[0].f)
		return 0;
	memcpy(rom->harmonic[0].f, f, sizeof f);
	return !hawser_rom_compile(rom, &report);
}

static int same(const struct hawser_frf *a, const struct hawser_frf *b)
{
	if (a->events != b->events || a->end != b->end)
		return 0;
	for (int e = 0; e < a->events; e++)
		if (a->event[e].kind != b->event[e].kind ||
		    !(fabs(a->event[e].omega/b->event[e].omega - 1.0) < 1e-7))
			return 0;
	return 1;
}

static void pass(const struct hawser_rom *rom, const struct hawser_frf_options *options,
                 const struct hawser_frf *frf, const struct hawser__orbits *orbits)
{
	struct hawser__orbits some = {.n = orbits->n, .item = calloc((size_t)orbits->count,
	                                                             sizeof *some.item)};
	struct hawser__trace_watch watch = {.known = &some, .for_folds = 1};
	int traces = 0, good = 0, most = 0;

	for (int stride = 1; some.item && stride < 10; stride++)
		for (int from = 0; from < stride; from++) {
			struct hawser_frf again;

			some.count = 1;
			some.item[0] = orbits->item[0];
			for (int i = from + 1; i < orbits->count; i += stride)
				some.item[some.count++] = orbits->item[i];
			traces++;
			good += !hawser__frf_trace(&again, rom, options, &watch, &report) &&
			        same(&again, frf);
			most = again.points > most ? again.points : most;
			hawser_frf_clear(&again);
		}
	free(some.item);
	ok(good == traces, "the same events with any of %d orbits known: %d of %d traces", orbits->count,
	   good, traces);
	ok(most <= frf->points, "%d points at most, %d without", most, frf->points);
}

CASE(property_known_orbits)
{
	struct hawser_frf_options options = {.method = "balance", .from = 0.9, .to = 1.6,
		.samples = HAWSER_NONE};
	struct hawser__orbits orbits = {.n = 0};
	struct hawser__trace_watch watch = hawser__orbits_watch(&orbits);
	int folds = 0, tori = 0;
	struct hawser_frf frf;
	struct hawser_rom rom;

	if (!ok(make(&rom), "model %s", report.message) ||
	    !ok(!hawser__frf_trace(&frf, &rom, &options, &watch, &report), "traced %s", report.message))
		return done_testing();
	for (int e = 0; e < frf.events; e++) {
		folds += frf.event[e].kind == HAWSER_FOLD;
		tori += frf.event[e].kind == HAWSER_TORUS;
	}
	ok(folds > 2 && tori > 1, "%d folds, %d torus points, %d points", folds, tori, frf.points);
	pass(&rom, &options, &frf, &orbits);
	hawser__orbits_clear(&orbits);
	hawser_frf_clear(&frf);
	hawser_rom_clear(&rom);
	return done_testing();
}

/* Stated errors against true ones on random scenes of a fixed seed: a small version of
 * bench/estimates. No true error may exceed the stated one. For each command at least one true
 * error must exceed a hundredth of the stated one (for two commands a thousandth), since an
 * estimate that is always far too large is useless. With HAWSER_LONG there are ten times as many
 * scenes; in one of 300 the true error may exceed the stated one, but by at most a factor of ten.
 * Also scenes for which an estimate was once too small.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "bench/estimates.h"
#include "tests/tap.h"

static const struct {
	const char *name;
	int scenes;
	double least; /* fraction of the stated errors that must be exceeded */
} tried[] = {
	{"statics", 300, 0.01}, {"modes", 20, 0.01}, {"campbell", 20, 0.01}, {"irvine", 6, 0.01},
	{"frf", 6, 0.01}, {"integrate", 3, 0.01}, {"hill", 60, 0.01}, {"map", 2, 0.01},
	/* the same for few scenes and the most cautious estimates */
	{"beam", 3, 1e-3}, {"events", 6, 1e-3},
};

static const struct {
	const char *name;
	int scene;
	uint64_t seed;
} found[] = {
	{"landmarks", 6, 1}, {"landmarks", 8, 1}, {"map", 15, 202}, {"map", 36, 202},
};

static const struct estimate *find(const char *name)
{
	for (int i = 0; i < estimates_count; i++)
		if (!strcmp(estimates[i].name, name))
			return &estimates[i];
	return NULL;
}

CASE(property_estimates)
{
	int more = getenv("HAWSER_LONG") ? 10 : 1;

	for (size_t i = 0; i < sizeof tried/sizeof *tried; i++) {
		const struct estimate *estimate = find(tried[i].name);
		struct tally tally = {.here = -1.0, .divide = 1.0, .show = 1.0};
		double most;

		if (!ok(estimate != NULL, "%s", tried[i].name))
			continue;
		estimate_run(&tally, estimate, 0, more*tried[i].scenes, 2385);
		most = tally_quantile(&tally.worst, 1.0);
		ok(!tally.failed && tally.far_exceeded == 0 &&
		   300*tally.exceeded <= (more > 1 ? tally.scenes : 0),
		   "%s: %d of %d scenes are worse than stated, the worst by a factor of %.2g",
		   tried[i].name, tally.exceeded, tally.scenes, most);
		ok(most > tried[i].least, "%s: %g of the stated error would not hold", tried[i].name,
		   tried[i].least);
		tally_clear(&tally);
	}
	for (size_t i = 0; i < sizeof found/sizeof *found; i++) {
		struct tally tally = {.here = -1.0, .divide = 1.0, .show = 1.0};

		estimate_run(&tally, find(found[i].name), found[i].scene, 1, found[i].seed);
		ok(!tally.failed && !tally.refused && tally.exceeded == 0, "%s, scene %d of seed %d, holds",
		   found[i].name, found[i].scene, (int)found[i].seed);
		tally_clear(&tally);
	}
	return done_testing();
}

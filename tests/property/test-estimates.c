/* Stated errors against true ones, on random scenes of a fixed seed: bench/estimates in small. None may be
 * exceeded; and each command states an error that, were it a hundredth of it, would be: one that is
 * always far too large says nothing. With HAWSER_LONG ten times as many scenes, of which one in 300 may
 * be exceeded, none by more than ten times.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>
#include <string.h>

#include "bench/estimates.h"
#include "tests/tap.h"

static const struct {
	const char *name;
	int scenes;
} tried[] = {
	{"statics", 300}, {"modes", 20}, {"campbell", 20}, {"irvine", 6}, {"frf", 6}, {"events", 6},
	{"integrate", 5}, {"hill", 60}, {"map", 2}, {"beam", 3},
};

static const struct estimate *find(const char *name)
{
	for (int i = 0; i < estimates_count; i++)
		if (!strcmp(estimates[i].name, name))
			return &estimates[i];
	return NULL;
}

int main(void)
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
		ok(most > 0.01, "%s: a hundredth of the stated error would not hold", tried[i].name);
		tally_clear(&tally);
	}
	return done_testing();
}

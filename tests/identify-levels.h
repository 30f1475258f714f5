/* tests/identify-levels.h - intervals of keys of a scene, from frequencies with noise.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TESTS_IDENTIFY_LEVELS_H
#define HAWSER_TESTS_IDENTIFY_LEVELS_H

#include <hawser/identify.h>

#include "tests/tap.h"

/* Two independent standard normal numbers, by Box and Muller. */
static inline void normal(double pair[2], unsigned long long *seed)
{
	double u[2];

	for (int k = 0; k < 2; k++) {
		*seed = *seed*6364136223846793005ull + 1442695040888963407ull;
		u[k] = ((double)(*seed >> 11) + 0.5)/9007199254740992.0;
	}
	pair[0] = sqrt(-2.0*log(u[0]))*cos(2.0*M_PI*u[1]);
	pair[1] = sqrt(-2.0*log(u[0]))*sin(2.0*M_PI*u[1]);
}

/* Intervals from the frequencies exact [count <= 12], an even number, with noise contain the true value
 * of both keys as often as they say. `known`: the deviation is given. */
static inline void identify_levels(const struct hawser_scene *scene, const char *const key[2],
                                   const double truth[2], const struct hawser_measured *exact,
                                   int count, int runs, double confidence, int known,
                                   unsigned long long seed)
{
	struct hawser_identify_options options = {.key = key, .keys = 2, .confidence = confidence};
	struct hawser_measured measured[12];
	const double noise = 4e-4;
	double expected = runs*confidence, spread = sqrt(runs*confidence*(1.0 - confidence));
	int within[2] = {0}, failed = 0;

	for (int run = 0; run < runs; run++) {
		struct hawser_identified found;

		for (int i = 0; i < count; i += 2) {
			double pair[2];

			normal(pair, &seed);
			for (int k = 0; k < 2; k++) {
				measured[i + k] = exact[i + k];
				measured[i + k].omega *= 1.0 + noise*pair[k];
				measured[i + k].deviation = known ? noise*exact[i + k].omega : 0.0;
			}
		}
		if (hawser_identify(&found, scene, measured, count, &options, NULL)) {
			failed++;
			continue;
		}
		for (int k = 0; k < 2; k++)
			within[k] += found.key[k].low <= truth[k] && truth[k] <= found.key[k].high;
		hawser_identified_clear(&found);
	}
	ok(failed == 0, "%d runs with noise", runs);
	for (int k = 0; k < 2; k++)
		ok(fabs(within[k] - expected) <= 3.3*spread + 0.5,
		   "%s: %d of %d intervals of level %g contain the true value", key[k], within[k], runs,
		   confidence);
}

#endif

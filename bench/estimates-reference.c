/* bench/estimates-reference.c - the true error of a response (estimates.h): its distance from the
 * response of a full-order model with a sufficiently large basis.
 *
 *   d     distance of the response from that of the reference
 *   move  distance of the reference from the previous one, with FINER functions per component less
 *
 * No fixed number of functions is sufficient. If a harmonic of a lightly damped response meets a
 * high mode, a small error of the frequency of this mode causes a large error of the amplitude:
 * near the sixth mode of a sagging span 12 functions have an error of up to 12 %, 16 of 1 %, and 20
 * of 0.2 %, which is more than the error of a condensed model of 25 exact modes. Functions are
 * therefore added until the error of the reference does not matter: until `move` is at most a tenth
 * of d, or until the sum of d and `move` is below half the stated error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench/estimates.h"
#include "study/compare/distance.h"

enum { FUNCTIONS = 12, FINER = 4, FUNCTIONS_MOST = 33, POINTS = 2500 };
static const double settled = 0.1; /* part of d */
static const double clear = 0.5;   /* relative to the stated error */
static const double known = 1e-4;  /* tolerance of the peaks of the responses, relative */

static int trace(struct hawser_frf *frf, struct hawser_rom *rom,
                 const struct estimate_response *response, int functions)
{
	struct hawser_frf_options options = {.method = NULL};

	options.method = "balance";
	options.from = response->from;
	options.to = response->to;
	options.tolerance = 1e-7;
	options.step_max = ESTIMATE_STEP;
	options.samples = HAWSER_NONE;
	options.max_points = POINTS;
	options.unjudged = 1; /* distances are those of shapes; multipliers took nine tenths of the time */
	return hawser_rom_build_full(rom, response->statics, response->scene, functions, NULL) ||
	       hawser_frf_trace(frf, rom, &options, NULL) || frf->end == HAWSER_END_MAX_POINTS;
}

/* The part of a response that is compared. */
static int find(struct hawser__marks *marks, const struct hawser_frf *frf,
                const struct hawser_rom *rom)
{
	struct hawser_frf_options options = {.method = NULL};

	return hawser__marks_find(marks, frf, rom, &options, known, NULL) != HAWSER_OK;
}

/* The same for a full-order response; returns 1 if there is none. */
static int find_full(struct hawser__marks *marks, const struct estimate_response *response,
                     int functions)
{
	struct hawser_rom rom = {.n = 0};
	struct hawser_frf frf = {.n = 0};
	int failed = trace(&frf, &rom, response, functions) || find(marks, &frf, &rom);

	hawser_rom_clear(&rom);
	hawser_frf_clear(&frf);
	return failed;
}

/* 1: the verdict does not depend on the reference any more. */
static int enough(const struct estimate_truth *truth, double stated)
{
	return truth->move <= settled*truth->distance ||
	       truth->distance + truth->move < clear*stated;
}

int estimate_truth(struct estimate_truth *truth, const struct estimate_response *response, int more,
                   double stated)
{
	int fewest = more + FINER > FUNCTIONS ? more + FINER : FUNCTIONS;
	struct hawser__marks own = {.count = 0}, coarse = {.count = 0}, fine;
	int failed = find(&own, response->frf, response->rom);

	*truth = (struct estimate_truth){.distance = NAN, .move = NAN};
	for (int functions = fewest; !failed && functions <= FUNCTIONS_MOST; functions += FINER) {
		fine = (struct hawser__marks){.count = 0};
		/* with a basis too small for the motion there may be no response */
		if (find_full(&fine, response, functions))
			continue;
		truth->functions = functions;
		if (coarse.curve.points > 0)
			failed = hawser__marks_distance(&truth->distance, &own, &fine, NULL) ||
			         hawser__marks_distance(&truth->move, &coarse, &fine, NULL);
		hawser__marks_clear(&coarse);
		coarse = fine;
		if (enough(truth, stated))
			break;
	}
	hawser__marks_clear(&own);
	hawser__marks_clear(&coarse);
	return failed || isnan(truth->distance);
}

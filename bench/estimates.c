/* bench/estimates.c - do stated errors hold? For each command, random scenes over wide ranges: the
 * error that the command states is compared with the true one, from a much more accurate method
 * (estimates.h).
 *
 *   bench/estimates [COMMAND|all [COUNT [SEED [SHOW [FIRST]]]]]
 *
 * COUNT scenes (1000) are drawn from SEED (1). With SHOW, numbers whose true error exceeds SHOW
 * times the stated one are listed. FIRST (0) is the number of the first scene. Status 1 if for a
 * command more than 1 of 1000 scenes have an error beyond the stated one, or one has an error
 * beyond 10 times the stated one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <cblas.h>
#include <stdlib.h>
#include <string.h>

#include "bench/clock.h"
#include "bench/estimates.h"

static int report(const struct estimate *estimate, struct tally *tally, double secs)
{
	int answered = tally->worst.count, broken;

	broken = tally->far_exceeded > 0 || 1000.0*tally->exceeded > fmax(answered, 1.0);
	printf("%-10s %6d %7d %8d %8.1e %8.1e %8.1e %8.1e %8.1e %6d %5d %7.0f  %s\n",
	       estimate->name, tally->scenes, tally->refused, tally->all.count,
	       tally_quantile(&tally->all, 0.5), tally_quantile(&tally->all, 0.9),
	       tally_quantile(&tally->all, 0.99), tally_quantile(&tally->all, 0.999),
	       tally_quantile(&tally->all, 1.0), tally->exceeded, tally->far_exceeded, secs,
	       broken ? "BROKEN" : answered ? "holds" : "nothing stated");
	fflush(stdout);
	return broken;
}

int main(int argc, char **argv)
{
	const char *which = argc > 1 ? argv[1] : "all";
	int count = argc > 2 ? atoi(argv[2]) : 1000, broken = 0, met = 0;
	uint64_t seed = argc > 3 ? strtoull(argv[3], NULL, 10) : 1;

	openblas_set_num_threads(1); /* small systems, whose threads would wait for each other */
	printf("true over stated error: %d scenes a command, seed %llu\n", count,
	       (unsigned long long)seed);
	printf("%-10s %6s %7s %8s %8s %8s %8s %8s %8s %6s %5s %7s\n", "command", "scenes", "refused",
	       "numbers", "50 %", "90 %", "99 %", "99.9 %", "largest", ">1", ">10", "s");
	for (int i = 0; i < estimates_count; i++) {
		struct tally tally = {.here = -1.0, .divide = 1.0, .show = argc > 4 ? atof(argv[4]) : 0.0};
		double start = clock_secs();

		if (strcmp(which, "all") && strcmp(which, estimates[i].name))
			continue;
		met = 1;
		estimate_run(&tally, &estimates[i], argc > 5 ? atoi(argv[5]) : 0, count, seed);
		if (tally.failed)
			return 4;
		broken |= report(&estimates[i], &tally, clock_secs() - start);
		tally_clear(&tally);
	}
	if (!met)
		fprintf(stderr, "estimates: no such command: %s\n", which);
	return broken || !met;
}

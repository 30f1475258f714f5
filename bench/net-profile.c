/* bench/net-profile - methods of the statics of nets on the random cables of B 3.2.3: what each solves,
 * iterations and times.
 *
 *     bench/net-profile [-n CABLES] [-s SEED] [-m METHOD] [-x NOISE] [-p]
 *
 * A cable counts as solved if the method says so and a certificate agrees that uses nothing of the
 * methods. Rows with /chord or /density begin at straight cables with noise, whose largest part of the
 * chord is NOISE (1e-4), or at force densities, in place of the method's own start. With -p the
 * performance profiles as blocks for gnuplot (doc/figures.sh): ratio of the time to the least of all
 * methods, number of iterations, percent of the cables. The status is 1 if a result is wrong.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/nets/comparison.h"

enum { CORNERS = 150 }; /* of a profile at most, so that pictures stay small */

static void table(const struct net_comparison *of)
{
	printf("%-20s %8s %10s %6s %5s %17s %8s %6s %7s\n", "method", "solved_%", "compressed", "failed",
	       "wrong", "iterations", "time_ms", "ratio", "best_%");
	for (int w = 0; w < of->ways; w++) {
		const struct net_score *score = &of->score[w];

		printf("%-20s %8.1f %10d %6d %5d %5g %5g %5g %8.2g %6.1f %7.0f\n", score->way->name,
		       100.0*score->solved/of->nets, score->compressed, score->failed, score->wrong,
		       score->iterations[0], score->iterations[1], score->iterations[2], 1e3*score->seconds[0],
		       score->ratio, 100.0*score->best);
	}
}

static int profiles(const struct net_comparison *of)
{
	double *time = calloc((size_t)of->nets, sizeof *time);
	double *iterations = calloc((size_t)of->nets, sizeof *iterations);

	for (int w = 0; w < of->ways && time && iterations; w++) {
		net_comparison_profile(time, of, w, 0);
		net_comparison_profile(iterations, of, w, 1);
		printf("# %s\n1 1 0\n", of->score[w].way->name);
		for (int i = 0, solved = of->score[w].solved; i < solved; i++)
			if (i == solved - 1 || i%(1 + solved/CORNERS) == 0)
				printf("%.4g %g %.4g\n", time[i], iterations[i], 100.0*(i + 1)/of->nets);
		printf("\n\n");
	}
	free(time);
	free(iterations);
	return !time || !iterations;
}

int main(int argc, char *argv[])
{
	struct net_comparison_options options = {.nets = 1600};
	struct net_comparison of;
	struct hawser_report report = {0};
	int option, profile = 0, wrong = 0;

	while ((option = getopt(argc, argv, "n:s:m:x:p")) != -1)
		switch (option) {
		case 'n': options.nets = atoi(optarg); break;
		case 's': options.seed = (unsigned)atoi(optarg); break;
		case 'm': options.way = optarg; break;
		case 'x': options.noise = atof(optarg); break;
		case 'p': profile = 1; break;
		default: return 2;
		}
	if (net_compare(&of, &options, &report)) {
		fprintf(stderr, "net-profile: %s\n", report.message);
		return 2;
	}
	if (profile)
		wrong = profiles(&of);
	else
		table(&of);
	for (int w = 0; w < of.ways; w++)
		wrong |= of.score[w].wrong > 0;
	net_comparison_clear(&of);
	return wrong;
}

/* bench/irvine.c - Irvine diagrams of B Table 4.1 and their cost: ten branches at 400 tensions,
 * level and inclined. Verifies before it times: status 1 if a branch of a level span changes its
 * symmetry, a branch of an inclined span crosses another, or a diagram takes more than a second of
 * processor time.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <hawser/irvine.h>
#include <math.h>
#include <stdio.h>

#include "bench/clock.h"

enum { REPEAT = 3 };
static const double most_secs = 1.0;

/* Number of branches whose symmetry changes; where P becomes dominant the label is the opposite
 * one. */
static int changed(const struct hawser_irvine *irvine)
{
	int count = 0;

	for (int b = 0; b < irvine->branches; b++) {
		int bad = 0;

		for (int i = 0; i < irvine->stations; i++) {
			int same = irvine->symmetry[i*irvine->branches + b] == irvine->symmetry[b];

			bad += same != (irvine->family[i*irvine->branches + b] == irvine->family[b]);
		}
		count += bad > 0;
	}
	return count;
}

static int line(const char *name, struct hawser_span span, double slope)
{
	const struct hawser_irvine_options options = {.points = 400, .n = 10};
	struct hawser_irvine irvine;
	struct hawser_report report;
	double best = INFINITY;
	int crossings = 0, bad;

	span.h = slope*span.d;
	for (int i = 0; i < REPEAT; i++) {
		double start = cpu_secs();

		if (hawser_irvine_trace(&irvine, &span, &options, &report)) {
			printf("%s: %s\n", name, report.message);
			return 1;
		}
		best = fmin(best, cpu_secs() - start);
		if (i + 1 < REPEAT)
			hawser_irvine_clear(&irvine);
	}
	for (int k = 0; k < irvine.crossovers; k++)
		crossings += irvine.crossover[k].kind == HAWSER_CROSSING;
	bad = slope == 0.0 ? changed(&irvine) : crossings;
	printf("%-7s %6.3f %9d %7d %10d %9d %9d %12.4f %9.3f\n", name, slope, irvine.stations,
	       irvine.solves, crossings, irvine.crossovers - crossings, bad, irvine.least_correlation,
	       best);
	hawser_irvine_clear(&irvine);
	return bad > 0 || best > most_secs;
}

int main(void)
{
	const struct hawser_span table41[] = {{235e6, 12.94, 9.81, 100.0, 0.0},
	                                      {40e6, 6.0, 9.81, 100.0, 0.0},
	                                      {1e6, 3.0, 9.81, 100.0, 0.0}};
	const char *const names[] = {"case 1", "case 2", "case 3"};
	int bad = 0;

	printf("Irvine diagrams, ten branches, 400 tensions, lambda/pi from 0.1 to 10\n"
	       "           h/d  stations  solves  crossings  veerings   swapped  correlation  cpu, s\n");
	for (int i = 0; i < 3; i++) {
		bad |= line(names[i], table41[i], 0.0);
		bad |= line(names[i], table41[i], 1.0/3.0);
	}
	return bad;
}

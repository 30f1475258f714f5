/* bench/statics.c - solutions per second of the elastic catenary from each given quantity, with
 * their errors. First everything is verified: N random spans (argument 1, default 1e6) as in
 * tests/statics-draw.h, solved from H and back from each of the five quantities. A failure, a given
 * quantity missed by more than 1e-12, or an end missed by more than 1e-12 of the chord (in long
 * double) ends the program with status 1. Then the same solutions are timed in blocks, without
 * other work.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "tests/statics-draw.h"

enum { BLOCK = 10000, GIVENS = 6 };
static const char *const names[GIVENS] = {"", "H", "T0", "T1", "length0", "sag"};

struct job {
	struct hawser_span span;
	struct hawser_statics st;
	enum hawser_branch branch[GIVENS];
};

static struct {
	double secs, error, closure;
	long iterations, failed;
} tally[GIVENS];

static int prepare(struct job *job)
{
	double H = draw_span(&job->span);

	if (hawser_statics_solve(&job->st, &job->span, HAWSER_GIVEN_H, H, HAWSER_BRANCH_TAUT, NULL))
		return 0;
	job->branch[HAWSER_GIVEN_T0] = branch_of(&job->st, HAWSER_GIVEN_T0);
	job->branch[HAWSER_GIVEN_T1] = branch_of(&job->st, HAWSER_GIVEN_T1);
	return 1;
}

static void verify(const struct job *job, enum hawser_given given)
{
	double value = value_of(&job->st, given), e;
	struct hawser_statics st;

	if (hawser_statics_solve(&st, &job->span, given, value, job->branch[given], NULL)) {
		tally[given].failed++;
		return;
	}
	e = fabs(value_of(&st, given)/value - 1.0);
	tally[given].error = e <= tally[given].error ? tally[given].error : e;
	e = draw_closure(&st);
	tally[given].closure = e <= tally[given].closure ? tally[given].closure : e;
	tally[given].iterations += st.iterations;
}

static double processor_secs(void)
{
	struct timespec now;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9*(double)now.tv_nsec;
}

static void clock_block(const struct job *jobs, int count, enum hawser_given given)
{
	struct hawser_statics st;
	double start = processor_secs();
	int failed = 0;

	for (int i = 0; i < count; i++)
		failed += hawser_statics_solve(&st, &jobs[i].span, given,
		                               value_of(&jobs[i].st, given), jobs[i].branch[given],
		                               NULL) != HAWSER_OK;
	tally[given].secs += processor_secs() - start;
	if (failed && !tally[given].failed)
		tally[given].failed = failed;
}

static int show(long spans)
{
	int bad = 0;

	printf("statics: %ld random spans; EA 1e4..1e14 N, slope -20..20, delta 1e-7..20\n", spans);
	printf("%-8s %10s %12s %14s %14s %12s\n", "given", "failed", "solves/s", "given off by",
	       "ends/chord", "iterations");
	for (int g = HAWSER_GIVEN_H; g < GIVENS; g++) {
		printf("%-8s %10ld %12.3g %14.1e %14.1e %12.2f\n", names[g], tally[g].failed,
		       (double)spans/tally[g].secs, tally[g].error, tally[g].closure,
		       (double)tally[g].iterations/(double)spans);
		bad |= tally[g].failed || !(tally[g].error <= 1e-12) || !(tally[g].closure <= 1e-12);
	}
	return bad;
}

int main(int argc, char **argv)
{
	long spans = argc > 1 ? atol(argv[1]) : 1000000, done = 0;
	struct job *jobs = calloc(BLOCK, sizeof *jobs);

	if (!jobs || spans < 1)
		return 4;
	while (done < spans) {
		int count = spans - done < BLOCK ? (int)(spans - done) : BLOCK;

		for (int i = 0; i < count; i++)
			if (!prepare(&jobs[i]))
				tally[HAWSER_GIVEN_H].failed++;
		for (int g = HAWSER_GIVEN_H; g < GIVENS; g++) {
			for (int i = 0; i < count; i++)
				verify(&jobs[i], (enum hawser_given)g);
			clock_block(jobs, count, (enum hawser_given)g);
		}
		done += count;
	}
	free(jobs);
	return show(spans);
}

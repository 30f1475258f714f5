/* bench/clock.h - the wall clock of the benchmarks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_BENCH_CLOCK_H
#define HAWSER_BENCH_CLOCK_H

#include <time.h>

/* Monotonic time, s. */
static inline double clock_secs(void)
{
	struct timespec now;

	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1e-9*(double)now.tv_nsec;
}

/* Processor time of this process, s, which is not affected by other work of the machine. */
static inline double cpu_secs(void)
{
	struct timespec now;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9*(double)now.tv_nsec;
}

#endif

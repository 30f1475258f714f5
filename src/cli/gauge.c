/* cli/gauge.c - what a call costs: time and memory.
 *
 * Memory is the high-water mark of the heap in a child process that does the work once: nothing
 * mapped apart, nothing given back, every gap left by what was there before filled up. The heap
 * then ends where the work's peak was, to a page, whatever the work freed on its way. Resident size
 * would be coarser (some 100 kB) and depend on what else the process has touched. It is 0 where
 * the C library can't tell (no glibc, or a checked build), and leaves out what libraries map for
 * themselves, such as the threads' buffers of OpenBLAS, which don't depend on the problem.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/cli.h"

#if defined(__GLIBC__) && defined(__GLIBC_PREREQ)
#if __GLIBC_PREREQ(2, 33)
#define HAWSER_HEAP_KNOWN 1 /* mallinfo2 is there */
#include <malloc.h>
#endif
#endif

enum { most_repeats = 50 };
static const double enough_secs = 0.1;

double cli_gauge_time(int (*work)(void *context), void *context)
{
	double best = HUGE_VAL, total = 0.0;
	int i;

	for (i = 0; i < most_repeats && total < enough_secs; i++) {
		double start = cli_seconds(), took;

		if (!work(context))
			break;
		took = cli_seconds() - start;
		best = fmin(best, took);
		total += took;
	}
	return best;
}

#ifdef HAWSER_HEAP_KNOWN
/* Leave no gap below the heap's end. What is allocated here stays until the process ends. */
static void fill_gaps(void)
{
	size_t size = mallinfo2().fordblks;

	while (size >= 32) {
		size_t before = mallinfo2().arena;
		void *volatile gap = malloc(size);

		if (!gap || mallinfo2().arena > before) {
			free(gap);
			size /= 2;
		}
	}
}

static double heap_growth(int (*work)(void *context), void *context)
{
	size_t before;

	mallopt(M_MMAP_MAX, 0);
	mallopt(M_TRIM_THRESHOLD, INT_MAX);
	mallopt(M_TOP_PAD, 0);
	malloc_trim(0);
	fill_gaps();
	before = mallinfo2().uordblks;
	if (!work(context))
		return 0.0;
	return (double)(mallinfo2().arena - before);
}

double cli_gauge_memory(int (*work)(void *context), void *context)
{
	double bytes = 0.0;
	int ends[2], state;
	pid_t child;

	if (mallinfo2().arena == 0 || pipe(ends) != 0)
		return 0.0;
	child = fork();
	if (child == 0) {
		bytes = heap_growth(work, context);
		_exit(write(ends[1], &bytes, sizeof bytes) == sizeof bytes ? 0 : 1);
	}
	close(ends[1]);
	if (child > 0) {
		if (read(ends[0], &bytes, sizeof bytes) != sizeof bytes)
			bytes = 0.0;
		while (waitpid(child, &state, 0) < 0 && errno == EINTR)
			;
	}
	close(ends[0]);
	return bytes;
}
#else
double cli_gauge_memory(int (*work)(void *context), void *context)
{
	(void)work;
	(void)context;
	return 0.0;
}
#endif

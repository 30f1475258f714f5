/* cli/frame/gauge.c - time and memory of a call.
 *
 * Memory is the high-water mark of the heap in a child process that does the work once. In this
 * process memory is never mapped separately and never returned, and the gaps in the heap are filled
 * before. The end of the heap then gives the peak of the work to a page, whatever the work frees.
 * The resident size would be coarser (some 100 kB) and depend on the rest of the process. The
 * result is 0 if the C library gives no information (no glibc, or a build with sanitizers). Memory
 * that libraries map themselves is not included, such as the threads' buffers of OpenBLAS, which do
 * not depend on the problem.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/frame/cli.h"
#include "cli/frame/gauge.h"

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
/* Fill the gaps below the end of the heap. This memory stays allocated until the process ends. */
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

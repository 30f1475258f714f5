/* core/share.c - compute independent items of work by several threads.
 *
 * Each call starts and joins its threads, which takes about 30 us per thread; a call should have at
 * least a millisecond of work. OpenMP is not used: the threads of libgomp spin for milliseconds at
 * the end of every loop. On a map with many short loops this took as much processor time as the
 * work. OMP_WAIT_POLICY=passive would prevent it, but is read before main. libgomp also ends the
 * program if a thread cannot be created.
 *
 * All signals are blocked in these threads, so that they are delivered to a thread of the caller.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <limits.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>

#include "core/share.h"

struct share {
	atomic_long next; /* the first item that is not assigned to a thread */
	long count;
	void (*work)(void *context, long item, int worker);
	void *context;
};

struct worker {
	struct share *share;
	pthread_t thread;
	int number;
};

static void take(struct share *share, int number)
{
	long item;

	while ((item = atomic_fetch_add(&share->next, 1)) < share->count)
		share->work(share->context, item, number);
}

static void *begin(void *of)
{
	const struct worker *worker = of;

	take(worker->share, worker->number);
	return NULL;
}

int hawser__thread_start(pthread_t *thread, void *(*run)(void *of), void *of)
{
	sigset_t all, before;
	int started;

	sigfillset(&all);
	pthread_sigmask(SIG_BLOCK, &all, &before);
	started = pthread_create(thread, NULL, run, of) == 0;
	pthread_sigmask(SIG_SETMASK, &before, NULL);
	return started;
}

/* Start up to `most` threads; returns the number started. */
static int start(struct worker *worker, int most, struct share *share)
{
	int count = 0;

	for (; count < most; count++) {
		worker[count] = (struct worker){.share = share, .number = count + 1};
		if (!hawser__thread_start(&worker[count].thread, begin, &worker[count]))
			break;
	}
	return count;
}

void hawser__share(long count, int threads, void (*work)(void *context, long item, int worker),
                   void *context)
{
	struct share share = {.count = count, .work = work, .context = context};
	int more = (int)(threads - 1 < count - 1 ? threads - 1 : count - 1), started = 0;
	struct worker *worker = more > 0 ? malloc((size_t)more*sizeof *worker) : NULL;

	atomic_init(&share.next, 0);
	if (worker)
		started = start(worker, more, &share);
	take(&share, 0);
	for (int i = 0; i < started; i++)
		pthread_join(worker[i].thread, NULL);
	free(worker);
}

int hawser__processors(void)
{
	const char *wanted = getenv("OMP_NUM_THREADS");
	long count = wanted ? strtol(wanted, NULL, 10) : 0;
	cpu_set_t set;

	if (count > 0)
		return count < INT_MAX ? (int)count : INT_MAX;
	CPU_ZERO(&set);
	if (sched_getaffinity(0, sizeof set, &set) != 0)
		return 1;
	return CPU_COUNT(&set);
}

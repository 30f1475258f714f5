/* core/share.h - compute independent items of work by several threads.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_SHARE_H
#define HAWSER_CORE_SHARE_H

#include <pthread.h>

/* Call work(context, item, worker) once for each item from 0 to count - 1, by at most `threads`
 * threads, including that of the caller. Items are started in ascending order. `worker` is 0 to
 * threads - 1; calls with the same `worker` do not run at the same time. If the system provides
 * fewer threads, these do all the work. */
void hawser__share(long count, int threads, void (*work)(void *context, long item, int worker),
                   void *context);

/* Start a thread that gets no signals: those of the process are the caller's. 0: the system has no more
 * threads. */
int hawser__thread_start(pthread_t *thread, void *(*run)(void *of), void *of);

/* Default number of threads: OMP_NUM_THREADS, else the number of processors available to the
 * process. */
int hawser__processors(void);

#endif

/* core/share.h - independent items of work, computed by several threads.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_SHARE_H
#define HAWSER_CORE_SHARE_H

/* Call work(context, item, worker) once for each item from 0 to count - 1, by at most `threads`
 * threads, the caller's among them. Items begin in ascending order. `worker` is 0 to threads -
 * 1, and no two calls with the same one run at a time. Where the system gives fewer threads,
 * those that there are do it all. */
void hawser__share(long count, int threads, void (*work)(void *context, long item, int worker),
                   void *context);

/* How many threads to take where the user does not say: OMP_NUM_THREADS, else the processors
 * that this process may run on. */
int hawser__processors(void);

#endif

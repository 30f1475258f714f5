/* response/time/planner.c - see planner.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <pthread.h>
#include <stdlib.h>

#include "response/time/planner.h"

#define ALIGNED 64      /* bytes, for vector instructions of any processor */
#define PLAN_ROOM 65536 /* bytes that a plan takes while it is made, at most; chosen */

static pthread_mutex_t planner = PTHREAD_MUTEX_INITIALIZER;

void hawser__planner_lock(void)
{
	pthread_mutex_lock(&planner);
}

int hawser__planner_begin(void)
{
	void *room = malloc(PLAN_ROOM);

	if (!room)
		return 1;
	free(room);
	hawser__planner_lock();
	return 0;
}

void *hawser__planner_array(size_t count, size_t size)
{
	return aligned_alloc(ALIGNED, (count*size/ALIGNED + 1)*ALIGNED);
}

void hawser__planner_unlock(void)
{
	pthread_mutex_unlock(&planner);
}

int hawser__planner_rows(int least)
{
	for (int rows = least > 1 ? least : 1;; rows++) {
		int rest = rows;

		for (int prime = 2; prime <= 5; prime++)
			while (rest%prime == 0)
				rest /= prime;
		if (rest == 1)
			return rows;
	}
}

/* response/time/planner.c - see planner.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <pthread.h>

#include "response/time/planner.h"

static pthread_mutex_t planner = PTHREAD_MUTEX_INITIALIZER;

void hawser__planner_lock(void)
{
	pthread_mutex_lock(&planner);
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

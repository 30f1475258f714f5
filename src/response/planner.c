/* response/planner.c - see planner.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <pthread.h>

#include "response/planner.h"

static pthread_mutex_t planner = PTHREAD_MUTEX_INITIALIZER;

void hawser__planner_lock(void)
{
	pthread_mutex_lock(&planner);
}

void hawser__planner_unlock(void)
{
	pthread_mutex_unlock(&planner);
}

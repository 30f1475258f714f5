/* response/time/planner.h - for plans of FFTW: a lock, since the planner, unlike the transforms,
 * must not be called by two threads at once (every plan is made and destroyed under this lock),
 * and lengths. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_PLANNER_H
#define HAWSER_RESPONSE_PLANNER_H

#include <stddef.h>

void hawser__planner_lock(void);
/* The lock, for a new plan. FFTW ends the program where memory is short: 1, and no lock, if there is
 * not as much as a plan takes. */
int hawser__planner_begin(void);
/* An aligned array for a transform, for free(); NULL if memory is short, where FFTW's own functions end
 * the program. */
void *hawser__planner_array(size_t count, size_t size);
void hawser__planner_unlock(void);

/* Smallest number of samples, at least `least`, of which transforms are fast: without prime factors
 * above 5. */
int hawser__planner_rows(int least);

#endif

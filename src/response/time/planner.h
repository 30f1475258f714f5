/* response/time/planner.h - for plans of FFTW: a lock, since the planner, unlike the transforms,
 * must not be called by two threads at once (every plan is made and destroyed under this lock),
 * and lengths. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_PLANNER_H
#define HAWSER_RESPONSE_PLANNER_H

void hawser__planner_lock(void);
void hawser__planner_unlock(void);

/* Smallest number of samples, at least `least`, of which transforms are fast: without prime factors
 * above 5. */
int hawser__planner_rows(int least);

#endif

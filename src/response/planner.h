/* response/planner.h - a lock for FFTW's planner, which, unlike its transforms, must not be called
 * by two threads at once: every plan is made and destroyed under this lock.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_PLANNER_H
#define HAWSER_RESPONSE_PLANNER_H

void hawser__planner_lock(void);
void hawser__planner_unlock(void);

#endif

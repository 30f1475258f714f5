/* response/planner.h - FFTW's planner, unlike its transforms, is not safe to call from two
 * threads: every plan is made and destroyed between these two.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_PLANNER_H
#define HAWSER_RESPONSE_PLANNER_H

void hawser__planner_lock(void);
void hawser__planner_unlock(void);

#endif

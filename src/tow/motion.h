/* tow/motion.h - a towed body in time: what its files share.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_TOW_MOTION_H
#define HAWSER_TOW_MOTION_H

#include "rod/motion.h"
#include "tow/steady.h"

struct hawser__tow_run {
	const struct hawser_tow *tow;
	struct hawser_tow own;             /* *tow with all stiffnesses, and the path of the start */
	struct hawser_water_level level;   /* of a current over time, at the start */
	struct hawser__tow_frame frame;
	struct hawser__tow_end body;       /* of the string at the start */
	struct hawser__tow_rod rod;
	struct hawser__rod_motion motion;
	struct hawser__rod_body mass;
	double *phase, *swing;             /* [elements] rad of vortex shedding at time `at`, rad/s */
	double at;                         /* s */
	double frequency;                  /* Hz, largest at time `at` */
	double clamp[4];                   /* axes of a clamped towing point at the start */
	double angle;                      /* rad, of the orbit then */
};

/* motion_loads.c: wind at a time; the function of loads, of a run. */
void hawser__tow_wind(double wind[3], const struct hawser_tow *tow, double t);
int hawser__tow_push(void *data, struct hawser__rod_motion *motion, double t, int tangent);
/* Shedding goes on to the time of the state: phases, their rates, the frequency. */
void hawser__tow_shed(struct hawser__tow_run *run);

/* motion_state.c: the state and the next step's length h as numbers, *state [*states], which are
 * allocated; and from a file that has them. */
enum hawser_status hawser__tow_state_save(double **state, int *states,
                                          const struct hawser__tow_run *run, double h,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status hawser__tow_state_read(struct hawser__tow_run *run, double *h, const char *path,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;

/* motion_start.c: the state at the start, and where the towing point goes. */
enum hawser_status hawser__tow_run_open(struct hawser__tow_run *run, const struct hawser_tow *tow,
                                        int refine, double until, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser__tow_run_close(struct hawser__tow_run *run);

#endif

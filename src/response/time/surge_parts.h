/* response/time/surge_parts.h - responses from rest to a change of the travel speed, for surge.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_SURGE_PARTS_H
#define HAWSER_RESPONSE_SURGE_PARTS_H

#include <complex.h>

#include "response/time/stepper.h"

/* A model that is integrated from rest at t = 0, in step with another run. surge_run.c. */
struct hawser__surge_run {
	const struct hawser_rom *rom;
	const struct hawser__method *method;
	struct hawser__stepper problem, *stepper;
	double end;      /* time up to which it is needed */
	double *y;       /* [2n] u then u' at the time of the last call of _at */
};

/* Clear *run, on failure too. `rom` must outlive it. */
enum hawser_status hawser__surge_run_open(struct hawser__surge_run *run,
                                          const struct hawser_rom *rom, double omega, double end,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
/* run->y at time t, which does not decrease from call to call. */
enum hawser_status hawser__surge_run_at(struct hawser__surge_run *run, double t,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser__surge_run_clear(struct hawser__surge_run *run);

/* Linear modes without coupling: those of `rom` from `first` on, each with the diagonal entries of D
 * and K, from rest at t = 0. surge_lone.c. */
struct hawser__lone_modes {
	const struct hawser_rom *rom;
	int first;
	double *y;                    /* [n] from `first` on: displacement at the time of the last call of
	                               * _at; 0 before `first` */
	double *held;                 /* [n] static response to the force at that time, of all modes */
	double complex *root, *swing; /* [n][2] roots of the free motion, and its amplitudes */
	double begin;                 /* time at which this free motion began */
	int over;                     /* 1: after the ramp */
};

/* Returns whether memory sufficed. Clear *lone in any case. */
int hawser__lone_modes_make(struct hawser__lone_modes *lone, const struct hawser_rom *rom, int first,
                            double omega);
void hawser__lone_modes_at(struct hawser__lone_modes *lone, double t, double omega);
void hawser__lone_modes_clear(struct hawser__lone_modes *lone);

#endif

/* response/stepper.h - what a time integrator offers to hawser_integrate: open, advance, close.
 *
 * The state is y = (u, u') [2n], time and quantities scaled. A method keeps its own workspace in a
 * structure that begins with a struct hawser__stepper.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_STEPPER_H
#define HAWSER_RESPONSE_STEPPER_H

#include <hawser/integrate.h>

/* Local tolerances where the caller gives none. */
#define HAWSER_DEFAULT_RTOL 1e-10
#define HAWSER_DEFAULT_ATOL 1e-13

/* A time for a message, for "%.6g%s": in s where the model knows its unit. */
#define HAWSER_SHOWN_TIME(rom, t) (t)*(rom)->time, (rom)->scaled ? " s" : ""

/* The problem, and the cost of solving it so far. */
struct hawser__stepper {
	const struct hawser_rom *rom;
	double omega;      /* of the forcing, 0 where there is none */
	double rtol, atol;
	double begin;      /* time at which `open` starts */
	double until;      /* never evaluated beyond */
	int over;          /* a model's ramp, if it has one, is over */
	long max_steps;
	long steps, evaluations, jacobians;
	int bad_coordinate; /* of the last acceleration that was not finite; -1 while all are */
	double bad_time;
};

struct hawser__method {
	struct hawser_integrate_method about;
	/* A stepper at t = problem->begin, state y0 [2n]; NULL when memory runs out. */
	struct hawser__stepper *(*open)(const struct hawser__stepper *problem, const double *y0);
	/* The state y [2n] at time t, which never falls from call to call nor exceeds `until`. */
	enum hawser_status (*advance)(struct hawser__stepper *stepper, double *y, double t,
	                              struct hawser_report *report);
	void (*close)(struct hawser__stepper *stepper);
};

extern const struct hawser__method hawser__gauss, hawser__adams, hawser__bdf;

/* Omega times t + low, less whole turns, to round-off whatever t is. */
double hawser__stepper_phase(const struct hawser__stepper *stepper, double t, double low);

/* Acceleration [n] at time t, where the forcing has this phase; counts it. Returns 0, or -1 when an
 * entry is not finite, after noting which and when. */
int hawser__stepper_acceleration(struct hawser__stepper *stepper, double *acceleration, double t,
                                 double phase, const double *u, const double *v);

/* The two ways a run ends early, with what the user can do. `y` is the last good state, at t. */
enum hawser_status hawser__stepper_escaped(const struct hawser__stepper *stepper, const double *y,
                                           double t, double step, struct hawser_report *report);
enum hawser_status hawser__stepper_too_long(const struct hawser__stepper *stepper, double t,
                                            struct hawser_report *report);

#endif

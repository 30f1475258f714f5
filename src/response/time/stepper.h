/* response/time/stepper.h - the interface between a time integrator and hawser_integrate: open,
 * advance, close.
 *
 * The state is y = (u, u') [2n], scaled like time. The workspace of a method is a structure that
 * begins with a struct hawser__stepper.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_STEPPER_H
#define HAWSER_RESPONSE_STEPPER_H

#include <hawser/integrate.h>

/* Default local tolerances. */
#define HAWSER_DEFAULT_RTOL 1e-10
#define HAWSER_DEFAULT_ATOL 1e-13
/* Default of the largest number of steps: some minutes of the smallest model. */
#define HAWSER_DEFAULT_MAX_STEPS 100000000L

/* Arguments for "%.6g%s" that print a time, in s if the model has a unit of time. */
#define HAWSER_SHOWN_TIME(rom, t) (t)*(rom)->time, (rom)->scaled ? " s" : ""

/* The problem, and the cost of its solution so far. */
struct hawser__stepper {
	const struct hawser_rom *rom;
	double omega;      /* forcing frequency at `since`; 0: none */
	double rate;       /* its change per time */
	double since;      /* time at which the run begins */
	double rtol, atol;
	double begin;      /* time at which the integration starts */
	double until;      /* time beyond which nothing is evaluated */
	int over;          /* 1: the ramp of the model has ended */
	double first;      /* length of the first step; 0: chosen by the method */
	double longest;    /* length of the longest step; 0: any */
	const char *used;  /* of auto: name of the method of most of the run */
	int watched;       /* 1: gauss sets `longer` */
	double reached;    /* of methods with `step`: time reached */
	double step;       /* of methods with `step`: length of the last step */
	double longer;     /* factor by which the last step could have been longer for its error with
	                    * the weights of weights.h */
	long max_steps;
	long steps, evaluations, jacobians;
	int bad_coordinate; /* index in the last acceleration that was not finite; -1: none */
};

struct hawser__method {
	struct hawser_integrate_method about;
	/* Open a stepper at t = problem->begin with the state y0 [2n]; NULL when out of memory. */
	struct hawser__stepper *(*open)(const struct hawser__stepper *problem, const double *y0);
	/* Compute the state y [2n] at time t, which does not decrease from call to call nor exceed
	 * `until`. */
	enum hawser_status (*advance)(struct hawser__stepper *stepper, double *y, double t,
	                              struct hawser_report *report);
	void (*close)(struct hawser__stepper *stepper);
	/* One step of the method's own length; NULL where it has no such call. */
	enum hawser_status (*step)(struct hawser__stepper *stepper, struct hawser_report *report);
};

extern const struct hawser__method hawser__gauss, hawser__radau, hawser__adams, hawser__bdf,
	hawser__automatic;

/* The method of a model for which none is named. */
const struct hawser__method *hawser__integrate_default(const struct hawser_rom *rom);

/* The forcing frequency at time t. */
double hawser__stepper_omega(const struct hawser__stepper *stepper, double t);
/* omega (t + low) modulo 2 pi, with the accuracy of round-off for any t. */
double hawser__stepper_turned(double omega, double t, double low);
/* Phase of the forcing at t + low: this, and what the change of the frequency adds. */
double hawser__stepper_phase(const struct hawser__stepper *stepper, double t, double low);

/* The step h, or the longest one. */
static inline double hawser__stepper_limited(const struct hawser__stepper *stepper, double h)
{
	return stepper->longest > 0.0 && h > stepper->longest ? stepper->longest : h;
}

/* Length of the first step: `first`, or short compared with the period of the forcing and with all
 * rates in the row sums of the Jacobian, so that the controller can increase it. */
double hawser__stepper_first(const struct hawser__stepper *stepper);

/* Acceleration [n] at time t, at which the forcing has this phase; it is counted. Returns 0, or -1
 * if an entry is not finite, whose index and time are stored. */
int hawser__stepper_acceleration(struct hawser__stepper *stepper, double *acceleration, double t,
                                 double phase, const double *u, const double *v);

/* The two failures that end a run early, with advice to the user. `y` is the last good state, at
 * t. */
enum hawser_status hawser__stepper_escaped(const struct hawser__stepper *stepper, const double *y,
                                           double t, double step, struct hawser_report *report);
enum hawser_status hawser__stepper_too_long(const struct hawser__stepper *stepper, double t,
                                            struct hawser_report *report);

#endif

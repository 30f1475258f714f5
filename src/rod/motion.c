/* rod/motion.c - steps of a rod in motion: their memory, beginning, length and failures (motion.h); a
 * step itself is in motion_newton.c. SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "rod/motion.h"

enum { SPLITS = 10 };   /* a step that has no solution is made in 2^SPLITS parts at most */
#define GROW 2.0        /* of a step's length, at most */
#define SHRINK 0.2      /* at least */
#define SAFETY 0.8      /* steps are so much shorter than their errors would let them be */
#define STEADY 1.2      /* a step that may be longer by less is kept, and the factors with it */
#define SHORTEST 1e-9   /* of the time: steps that are not made shorter for their error */

/* --- memory --- */

enum hawser_status hawser__rod_motion_open(struct hawser__rod_motion *motion,
                                           struct hawser__rod_mesh *mesh,
                                           struct hawser_report *report)
{
	size_t nodes = (size_t)mesh->nodes;
	/* cppcheck-suppress uninitvar ; sizeof of its elements alone */
	double (**const six[])[6] = {
		&motion->velocity, &motion->rate, &motion->mean, &motion->step, &motion->past, &motion->past2,
		&motion->velocity0, &motion->rate0, &motion->mean0, &motion->applied, &motion->applied0,
		&motion->pushed, &motion->pushed0, &motion->reaction, &motion->reaction0};
	int good = 1;

	memset(motion, 0, sizeof *motion);
	motion->mesh = mesh;
	motion->rho_inf = mesh->rod->rho_inf >= 0.0 ? mesh->rod->rho_inf : 0.8;
	motion->alpha = mesh->rod->alpha;
	for (size_t i = 0; i < sizeof six/sizeof *six; i++)
		good = (*six[i] = calloc(nodes, sizeof **six[i])) != NULL && good;
	motion->added = hawser__hold(&motion->hold, nodes, sizeof *motion->added);
	motion->mass = hawser__hold(&motion->hold, nodes, sizeof *motion->mass);
	motion->mass0 = hawser__hold(&motion->hold, nodes, sizeof *motion->mass0);
	motion->factor = hawser__hold(&motion->hold, (size_t)mesh->rod->loads + 1, sizeof *motion->factor);
	motion->node0 = hawser__hold(&motion->hold, nodes, sizeof *motion->node0);
	motion->Ji = hawser__hold(&motion->hold, nodes, sizeof *motion->Ji);
	motion->factor_q = hawser__hold(&motion->hold, nodes, sizeof *motion->factor_q);
	if (!good || motion->hold.short_of_memory) {
		hawser__rod_motion_clear(motion);
		return hawser__no_memory(report, "rod");
	}
	hawser__rod_motion_masses(motion);
	return HAWSER_OK;
}

void hawser__rod_motion_clear(struct hawser__rod_motion *motion)
{
	double (*six[])[6] = {
		motion->velocity, motion->rate, motion->mean, motion->step, motion->past, motion->past2,
		motion->velocity0, motion->rate0, motion->mean0, motion->applied, motion->applied0,
		motion->pushed, motion->pushed0, motion->reaction, motion->reaction0};

	for (size_t i = 0; i < sizeof six/sizeof *six; i++)
		free(six[i]);
	hawser__hold_clear(&motion->hold);
	hawser__rod_winch_clear(&motion->winch);
	memset(motion, 0, sizeof *motion);
}

static enum hawser_status undefined(const struct hawser__rod_motion *motion,
                                    struct hawser_report *report)
{
	return hawser__fail(report, HAWSER_ERR_NAN, "rod", "at %.9g s the forces are not finite: a "
	                    "load, a motion or a stiffness is out of range", motion->t);
}

enum hawser_status hawser__rod_motion_begin(struct hawser__rod_motion *motion, int first,
                                            struct hawser_report *report)
{
	struct hawser__rod_mesh *mesh = motion->mesh;
	double sum = 0.0;

	motion->past_h = motion->past2_h = motion->factor_h = 0.0;
	hawser__rod_motion_factors(motion, motion->t, 1);
	hawser__rod_motion_hold(motion, motion->t);
	if (hawser__rod_motion_rates(motion, motion->t))
		return motion->bent >= 0
			? hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "rod", "at %.9g s the element from %.6g m "
			               "to %.6g m turns by pi or more: give more elements", motion->t,
			               mesh->s[motion->bent], mesh->s[motion->bent + 1])
			: hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "rod", "at %.9g s the motion is not "
			               "determined: a node has no mass or no inertia, or a load refuses",
			               motion->t);
	for (int i = 0; i < mesh->nodes; i++)
		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			sum += fabs(motion->rate[i][k]) + fabs(motion->velocity[i][k]);
	if (!isfinite(sum))
		return undefined(motion, report);
	memcpy(motion->mean, motion->rate, (size_t)mesh->nodes*sizeof *motion->mean);
	hawser__rod_winch_power(motion);
	if (!first)
		return HAWSER_OK;
	motion->energy = (struct hawser__rod_energy){0};
	memset(&motion->momentum, 0, sizeof motion->momentum);
	motion->winch.over = 0.0;
	motion->energy_lost = motion->momentum_gap = motion->angular_gap = motion->most_momentum =
	                      motion->most_angular = motion->most_energy = 0.0;
	hawser__rod_motion_sum(motion);
	motion->start_energy = motion->energy.kinetic + motion->energy.strain + motion->energy.height;
	memcpy(motion->start, motion->momentum.linear, 3*sizeof *motion->start);
	memcpy(motion->start + 3, motion->momentum.angular, 3*sizeof *motion->start);
	return HAWSER_OK;
}

/* --- a step --- */

static void keep(struct hawser__rod_motion *motion, double h)
{
	size_t nodes = (size_t)motion->mesh->nodes;
	double part = motion->past_h > 0.0 ? h/motion->past_h : 1.0;

	memcpy(motion->node0, motion->mesh->node, nodes*sizeof *motion->node0);
	memcpy(motion->velocity0, motion->velocity, nodes*sizeof *motion->velocity);
	memcpy(motion->rate0, motion->rate, nodes*sizeof *motion->rate);
	memcpy(motion->applied0, motion->applied, nodes*sizeof *motion->applied);
	memcpy(motion->pushed0, motion->pushed, nodes*sizeof *motion->pushed);
	memcpy(motion->reaction0, motion->reaction, nodes*sizeof *motion->reaction);
	memcpy(motion->mean0, motion->mean, nodes*sizeof *motion->mean);
	memcpy(motion->mass0, motion->mass, nodes*sizeof *motion->mass);
	if (motion->winch.as)
		memcpy(motion->winch.slip0, motion->winch.slip, nodes*sizeof *motion->winch.slip);
	if (part != 1.0)
		for (size_t i = 0; i < nodes; i++)
			for (int k = 0; k < HAWSER__ROD_FREE; k++)
				motion->mean0[i][k] = motion->rate[i][k] +
				                      part*(motion->mean[i][k] - motion->rate[i][k]);
}

/* The state as before the step; its mean rates belong to a step of the last length again. */
static void restore(struct hawser__rod_motion *motion, double h)
{
	size_t nodes = (size_t)motion->mesh->nodes;
	double part = motion->past_h > 0.0 ? motion->past_h/h : 1.0;

	memcpy(motion->mesh->node, motion->node0, nodes*sizeof *motion->node0);
	memcpy(motion->velocity, motion->velocity0, nodes*sizeof *motion->velocity);
	memcpy(motion->rate, motion->rate0, nodes*sizeof *motion->rate);
	memcpy(motion->applied, motion->applied0, nodes*sizeof *motion->applied);
	memcpy(motion->pushed, motion->pushed0, nodes*sizeof *motion->pushed);
	memcpy(motion->reaction, motion->reaction0, nodes*sizeof *motion->reaction);
	memcpy(motion->mass, motion->mass0, nodes*sizeof *motion->mass);
	if (motion->winch.as)
		memcpy(motion->winch.slip, motion->winch.slip0, nodes*sizeof *motion->winch.slip);
	for (size_t i = 0; i < nodes; i++)
		for (int k = 0; k < HAWSER__ROD_FREE; k++)
			motion->mean[i][k] = motion->rate0[i][k] + part*(motion->mean0[i][k] - motion->rate0[i][k]);
}

/* Largest local error, c h^3 x''', by the increments of the last steps, turns times the rod's length; 0
 * if it is not known. */
static double local_error(const struct hawser__rod_motion *motion,
                          const struct hawser__rod_scheme *s, double h)
{
	double h1 = motion->past_h, h2 = motion->past2_h, most = 0.0, a0, a1, part;

	if (h1 <= 0.0 || h2 <= 0.0)
		return 0.0;
	a0 = 2.0/(h + h1);
	a1 = 2.0/(h1 + h2);
	part = 3.0/(h + h1 + h2)*s->c*h*h*h;
	for (int i = 0; i < motion->mesh->nodes; i++)
		for (int k = 0; k < HAWSER__ROD_FREE; k++) {
			double third = a0*motion->step[i][k]/h - (a0 + a1)*motion->past[i][k]/h1 +
			               a1*motion->past2[i][k]/h2;

			most = fmax(most, fabs(third)*(k < 3 ? 1.0 : motion->mesh->rod->length));
		}
	return part*most;
}

static void finish(struct hawser__rod_motion *motion, double h)
{
	double (*swap)[6] = motion->past2;

	/* supports and loads of the state itself: the last ones were before the last increment */
	(void)hawser__rod_motion_form(motion, motion->t + h, 0);
	motion->h = h;
	motion->t += h;
	hawser__rod_motion_account(motion, h);
	motion->past2 = motion->past;
	motion->past = swap;
	memcpy(motion->past, motion->step, (size_t)motion->mesh->nodes*sizeof *motion->step);
	motion->past2_h = motion->past_h;
	motion->past_h = h;
	motion->drift += motion->error;
	motion->steps++;
}

/* Try one step; 0: the state is as before, since there was no solution (motion->error 0) or its
 * local error, motion->error, is more than limit. */
static int attempt(struct hawser__rod_motion *motion, double h, double limit)
{
	struct hawser__rod_scheme s = hawser__rod_scheme_of(motion->rho_inf);
	int done;

	keep(motion, h);
	hawser__rod_motion_factors(motion, motion->t + h, 0);
	hawser__rod_motion_predict(motion, h);
	done = hawser__rod_motion_newton(motion, &s, h);
	motion->error = done ? local_error(motion, &s, h) : 0.0;
	if (done && motion->error <= limit) {
		finish(motion, h);
		return 1;
	}
	motion->factor_h = 0.0;
	restore(motion, h);
	return 0;
}

static enum hawser_status failed(const struct hawser__rod_motion *motion, double h,
                                 struct hawser_report *report)
{
	const struct hawser__rod_mesh *mesh = motion->mesh;

	if (motion->refused)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "rod", "at %.9g s the loads are not "
		                    "defined", motion->t);
	if (motion->undefined)
		return undefined(motion, report);
	if (motion->bent >= 0)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "rod", "at %.9g s the element from %.6g "
		                    "m to %.6g m turns by pi or more: give more elements", motion->t,
		                    mesh->s[motion->bent], mesh->s[motion->bent + 1]);
	if (motion->spun >= 0)
		return hawser__fail(report, HAWSER_ERR_CONVERGENCE, "rod", "at %.9g s the rod at %.6g m "
		                    "turns by more than %g rad in a step of %.3g s: give a shorter step",
		                    motion->t, mesh->s[motion->spun], HAWSER__ROD_SPUN, h);
	return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "rod", HAWSER__ROD_ITERATIONS,
	                       motion->increment,
	                       "at %.9g s no step of %.3g s or longer has a solution: give a shorter "
	                       "step, or more elements", motion->t, h);
}

/* Whether the rod is paid out faster than its waves run. */
static enum hawser_status outrun(struct hawser__rod_motion *motion, struct hawser_report *report)
{
	const struct hawser__rod_strain *at = motion->mesh->strain;

	if (!hawser__rod_winch_watch(motion))
		return HAWSER_OK;
	return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "rod", "at %.9g s the winch pays out or hauls "
	                    "in %.3g m/s, faster than waves run there with a tension of %.3g N, for the "
	                    "length of an element: the place of a hinge does not determine such a motion; "
	                    "give a lower speed, more tension, or hold: clamped", motion->t,
	                    fabs(motion->winch.speed), at->N[0]);
}

static enum hawser_status split(struct hawser__rod_motion *motion, double h, int depth,
                                struct hawser_report *report)
{
	enum hawser_status status;

	if (attempt(motion, h, INFINITY))
		return outrun(motion, report);
	if (depth == 0)
		return failed(motion, h, report);
	motion->splits++;
	status = split(motion, 0.5*h, depth - 1, report);
	return status ? status : split(motion, 0.5*h, depth - 1, report);
}

enum hawser_status hawser__rod_motion_step(struct hawser__rod_motion *motion, double h,
                                           struct hawser_report *report)
{
	return split(motion, h, SPLITS, report);
}

enum hawser_status hawser__rod_motion_adapt(struct hawser__rod_motion *motion, double *h, double end,
                                            double tolerance, struct hawser_report *report)
{
	for (;;) {
		double left = end - motion->t, step = *h >= left ? left : *h > 0.5*left ? 0.5*left : *h, f;
		int least = step <= SHORTEST*fmax(fabs(end), left);

		if (attempt(motion, step, least ? INFINITY : tolerance)) {
			f = motion->error > 0.0 ? SAFETY*cbrt(tolerance/motion->error) : GROW;
			/* the same length again saves factors; what was left of the interval says nothing */
			if (f < 1.0 || f > STEADY || step != *h)
				*h = step < *h && f >= 1.0 ? *h : step*fmin(fmax(f, SHRINK), GROW);
			return outrun(motion, report);
		}
		if (least)
			return failed(motion, step, report);
		motion->rejected++;
		f = motion->error > 0.0 ? fmin(SAFETY*cbrt(tolerance/motion->error), SAFETY) : SHRINK;
		*h = step*fmax(f, SHRINK);
	}
}

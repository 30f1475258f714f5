/* net/motion/motion.c - time integration of a mesh: begin, steps, their control.
 *
 * Newton's method ends at 1e-12 of the largest force or, where round-off is larger, when it gains
 * nothing more: the energy is kept as well as the equations are solved.
 *
 * Local error: of a step of order 2 it is h^3*q'''/12 (the scheme is the trapezoidal rule to this
 * order), q''' from divided differences of the mean velocities of three steps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include "core/report.h"
#include "net/motion/motion-contact.h"
#include "net/motion/motion-events.h"

enum { ITERATIONS = 30, CAREFUL = 100, SPLITS = 12 };
static const double SMALLEST = 1.0/256.0; /* part of a correction */
/* Of the control of steps: as is usual; the shortest step over the whole time. */
/* Of the error of a jump, which may be a hundred times the local error, since there are few jumps. */
static const double JUMPS = 0.01;
static const double SAFETY = 0.9, GROW = 1.5, SHRINK = 0.3, SHORTEST = 1e-9;

/* Hold the rows of held directions out of the residual, whose largest entry is returned. */
static double rest_of(const struct hawser__motion *motion)
{
	double most = 0.0;

	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++)
			if (motion->mesh->unknown[i][k] >= 0 && !(fabs(motion->r[i][k]) <= most))
				most = fabs(motion->r[i][k]);
	return most;
}

static enum hawser_status correct(struct hawser__motion *motion, int *good,
                                  struct hawser_report *report)
{
	const struct hawser__blocks_matrix matrix = {
		(const double (*)[9])motion->B, (const double (*)[9])motion->other,
		(const double (*)[2])motion->mass, motion->point, (const double (*)[9])motion->block};
	enum hawser_status status;

	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++)
			motion->r[i][k] = motion->mesh->unknown[i][k] < 0 ? 0.0 : -motion->r[i][k];
	if (motion->attached)
		hawser__attached_eliminate(motion, 0);
	status = hawser__blocks_solve(motion->r, good, motion->blocks, &matrix, report);
	if (motion->attached && !status && *good)
		hawser__attached_eliminate(motion, 1);
	return status;
}

static void keep(struct hawser__motion *motion)
{
	size_t size = (size_t)motion->nodes*sizeof *motion->u;

	memcpy(motion->u0, motion->u, size);
	memcpy(motion->v0, motion->v, size);
	memcpy(motion->a0, motion->a, size);
}

/* Accelerations of the state, where a scheme needs them: M*a = what is not balanced. */
static enum hawser_status accelerate(struct hawser__motion *motion, struct hawser_report *report)
{
	const struct hawser__motion_rule rule = {.m = {1.0}, .c = {0.0, 1.0}, .weight = 0.0};
	enum hawser_status status;
	int good = 1;

	keep(motion);
	memset(motion->x, 0, (size_t)motion->nodes*sizeof *motion->x);
	hawser__motion_prepare(motion, &rule, 1.0);
	hawser__motion_residual(motion, &rule, 1.0, 1);
	status = correct(motion, &good, report);
	if (!good) /* nodes without mass: only a first guess is lost */
		memset(motion->r, 0, (size_t)motion->nodes*sizeof *motion->r);
	return status;
}

enum hawser_status hawser__motion_restart(struct hawser__motion *motion, struct hawser_report *report)
{
	enum hawser_status status = accelerate(motion, report);

	if (!status)
		memcpy(motion->a, motion->r, (size_t)motion->nodes*sizeof *motion->a);
	motion->past_h = motion->past2_h = 0.0;
	return status;
}

void hawser__motion_watch(struct hawser__motion *motion, int element, const double d[3], double p,
                          double t)
{
	double T = hawser__motion_tension(motion, element, d, p), zero = motion->element[element].zero;

	if (motion->element[element].rod)
		return;
	if (T < motion->least) {
		motion->least = T;
		motion->least_at = t;
	}
	if ((p < zero || (p > zero && T == 0.0)) && isnan(motion->slack_at)) {
		motion->slack_at = t;
		motion->slack_element = element;
	}
}

enum hawser_status hawser__motion_begin(struct hawser__motion *motion, struct hawser_report *report)
{
	enum hawser_status status;

	hawser__motion_supports(motion->u, motion->v, motion, motion->t);
	status = hawser__motion_restart(motion, report);
	if (status)
		return status;
	if (motion->contact)
		hawser__contact_begin(motion);
	motion->energy = (struct hawser__motion_energy){0};
	hawser__motion_energies(motion);
	motion->start_energy = motion->energy.kinetic + motion->energy.potential;
	motion->most_energy = motion->energy.kinetic;
	motion->closure = 0.0;
	motion->least = INFINITY;
	motion->slack_at = NAN;
	for (int e = 0; e < motion->elements; e++)
		hawser__motion_watch(motion, e, motion->element[e].d, motion->element[e].p, motion->t);
	return HAWSER_OK;
}

/* First increment: supports as they move, the others by the mean velocities of the last steps. */
static void predict(struct hawser__motion *motion, double h)
{
	double f = motion->past_h > 0.0 ? h/motion->past_h : 0.0;
	/* without the velocities of the state, which alternate from step to step where damping is strong */
	double g = motion->past2_h > 0.0 && motion->damps > 0.0
		? f*(h + motion->past_h)/(motion->past_h + motion->past2_h) : 0.0;

	hawser__motion_supports(motion->u, motion->v, motion, motion->t + h);
	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++) {
			double v = motion->v0[i][k], mean = motion->past[i][k]*f, x;

			x = h*v + (f > 0.0 ? f*(h*v - mean) : 0.5*h*h*motion->a0[i][k]);
			if (g > 0.0)
				x = mean + g*(motion->past[i][k] - motion->past_h/motion->past2_h*motion->past2[i][k]);
			motion->x[i][k] = motion->mesh->unknown[i][k] < 0 && !motion->mesh->rigid[i]
				? motion->u[i][k] - motion->u0[i][k] : x;
		}
	if (motion->bodies)
		hawser__bodies_predict(motion, h);
}

static void move(struct hawser__motion *motion, double part)
{
	for (int n = 0; n < motion->nodes; n++)
		for (int k = 0; k < 3; k++)
			motion->x[n][k] += part*motion->move[n][k];
	if (motion->bodies)
		hawser__bodies_move(motion, part);
}

/* Newton's method for the increment; *done is 0 if it fails. `careful`: a correction is halved while
 * the residual grows. Between slack and taut, and where damping ends to pull, the law has corners,
 * about which whole corrections can go to and fro for ever. */
static enum hawser_status iterate(struct hawser__motion *motion, int *done, int careful,
                                  const struct hawser__motion_rule *rule, double h,
                                  struct hawser_report *report)
{
	double last = INFINITY, part = 1.0;
	int fresh = 1;

	*done = 0;
	for (int i = 0; i < (careful ? CAREFUL : ITERATIONS); i++) {
		double rest, tolerance;
		int good, made = fresh;
		enum hawser_status status;

		hawser__motion_residual(motion, rule, h, fresh);
		rest = rest_of(motion);
		if (motion->bodies)
			rest = hawser__bodies_rest(motion, rest);
		tolerance = 5000.0*DBL_EPSILON*motion->scale;
		*done = (i > 0 || !motion->contact) && /* as where there are contacts */
		        (rest <= tolerance || (rest <= 1e3*tolerance && rest > 0.25*last));
		motion->undefined = i == 0 && !isfinite(rest);
		motion->singular = i == 1 && !isfinite(rest);
		if (*done || !isfinite(rest))
			return HAWSER_OK;
		if (careful && rest >= last && part > SMALLEST) {
			part *= 0.5;
			move(motion, -part);
			fresh = 1;
			continue;
		}
		fresh = i == 0 || !(rest <= HAWSER__KEEPS*last);
		last = rest;
		part = 1.0;
		status = motion->bodies ? hawser__bodies_correct(motion, &good, made, correct, report)
		                        : correct(motion, &good, report);
		motion->singular = !good && i == 0;
		if (status || !good)
			return status;
		motion->iterations++;
		memcpy(motion->move, motion->r, (size_t)motion->nodes*sizeof *motion->r);
		move(motion, 1.0);
	}
	return HAWSER_OK;
}

enum hawser_status hawser__motion_solve(struct hawser__motion *motion, int *done,
                                        const struct hawser__motion_rule *rule, double h,
                                        struct hawser_report *report)
{
	enum hawser_status status = iterate(motion, done, 0, rule, h, report);

	if (status || *done)
		return status;
	predict(motion, h);
	return iterate(motion, done, 1, rule, h, report);
}

static void finish(struct hawser__motion *motion, const struct hawser__motion_rule *rule, double h)
{
	double (*swap)[3] = motion->past2;

	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3; k++) {
			double x = motion->x[i][k], v = motion->v0[i][k], a = motion->a0[i][k];

			if (motion->mesh->unknown[i][k] < 0)
				continue;
			motion->u[i][k] = motion->u0[i][k] + x;
			motion->v[i][k] = rule->to_v[0]*x + rule->to_v[1]*v + rule->to_v[2]*a;
			motion->a[i][k] = rule->to_a[0]*x + rule->to_a[1]*v + rule->to_a[2]*a;
		}
	if (motion->bodies)
		hawser__bodies_finish(motion);
	if (motion->contact)
		hawser__contact_finish(motion);
	hawser__motion_account(motion, rule, h);
	motion->past2 = motion->past;
	motion->past = swap;
	memcpy(motion->past, motion->x, (size_t)motion->nodes*sizeof *motion->x);
	motion->past2_h = motion->past_h;
	motion->past_h = h;
	for (int e = 0; e < motion->elements; e++) {
		const struct hawser__motion_element *el = &motion->element[e];

		motion->switches += !el->rod && (el->p > el->zero) != (el->p1 > el->zero);
		hawser__motion_watch(motion, e, el->d1, el->p1, motion->t + h);
	}
	motion->drift += motion->contact ? fmax(motion->error, motion->contact->jump_error) : motion->error;
	motion->t += h;
	motion->steps++;
	if (motion->events)
		hawser__events_finish(motion);
}

/* Largest local error of a position: h^3 q'''/12 or, of order 1, h^2 q''/2; 0 if it is not known. Both
 * are sums of the increments of the last steps. */
static double local_error(const struct hawser__motion *motion, double h)
{
	double h1 = motion->past_h, h2 = motion->past2_h, most = 0.0, a0, a1, part, c[3];
	int first = motion->scheme->shown.order == 1;

	if (h1 <= 0.0 || h2 <= 0.0)
		return 0.0;
	a0 = 2.0/(h + h1);
	a1 = 2.0/(h1 + h2);
	part = 4.0/(h + 2.0*h1 + h2)*h*h*h/12.0;
	c[0] = (first ? 0.5*h*h : part)*a0/h;
	c[1] = (first ? -0.5*h*h*a0 : -part*(a0 + a1))/h1;
	c[2] = first ? 0.0 : part*a1/h2;
	for (int i = 0; i < motion->nodes; i++)
		for (int k = 0; k < 3 && !(motion->contact && motion->contact->recent[i]); k++)
			most = fmax(most, fabs(c[0]*motion->x[i][k] + c[1]*motion->past[i][k] +
			                       c[2]*motion->past2[i][k]));
	return most;
}

/* Try one step; *done is 0, and the state as before, if it fails or its local error, which
 * motion->error gets, is more than limit. */
static enum hawser_status attempt(struct hawser__motion *motion, int *done, double h, double limit,
                                  struct hawser_report *report)
{
	struct hawser__motion_rule rule = {0};
	enum hawser_status status;
	size_t size = (size_t)motion->nodes*sizeof *motion->u;

	motion->scheme->rule(&rule, h, motion->rho_inf);
	if (motion->events)
		hawser__events_wind(motion, motion->t + 0.5*h);
	keep(motion);
	predict(motion, h);
	hawser__motion_prepare(motion, &rule, h);
	status = motion->contact ? hawser__contact_solve(motion, done, &rule, h, report)
	                         : hawser__motion_solve(motion, done, &rule, h, report);
	motion->error = !status && *done ? local_error(motion, h) : 0.0;
	if (!status && *done && motion->contact) {
		hawser__contact_jump(motion, &rule, h);
		motion->error = fmax(motion->error, JUMPS*motion->contact->jump_error);
	}
	if (!status && *done && motion->events)
		*done = hawser__events_fits(motion, h);
	if (!status && *done && motion->error <= limit) {
		finish(motion, &rule, h);
	} else {
		*done = 0;
		memcpy(motion->u, motion->u0, size);
		memcpy(motion->v, motion->v0, size);
	}
	return status;
}

static enum hawser_status split(struct hawser__motion *motion, double h, int depth,
                                struct hawser_report *report)
{
	int done;
	enum hawser_status status = attempt(motion, &done, h, INFINITY, report);

	while (!status && !done && motion->events && motion->events->cut > 0.0)
		status = attempt(motion, &done, motion->events->cut, INFINITY, report);
	if (status || done)
		return status;
	if (depth == 0 && motion->undefined)
		return hawser__fail(report, HAWSER_ERR_NAN, "net", "at %.9g s the forces are not finite: a "
		                    "load, a motion or a stiffness is out of range", motion->t);
	if (depth == 0 && motion->contact && motion->contact->refusal.status) {
		if (report)
			*report = motion->contact->refusal;
		return motion->contact->refusal.status;
	}
	if (depth == 0 && motion->singular)
		return hawser__fail(report, HAWSER_ERR_NO_SOLUTION, "net", "at %.9g s the motion is not "
		                    "determined: no tension holds a node with next to no mass; give it a mass",
		                    motion->t);
	if (depth == 0)
		return hawser__fail_at(report, HAWSER_ERR_CONVERGENCE, "net", ITERATIONS, rest_of(motion),
		                       "at %.9g s no step of %.3g s or longer has a solution: begin from "
		                       "another state, or change loads, damping or what meets there",
		                       motion->t, h);
	motion->splits++;
	status = split(motion, h/2.0, depth - 1, report);
	return status || hawser__events_due(motion) ? status : split(motion, h/2.0, depth - 1, report);
}

enum hawser_status hawser__motion_step(struct hawser__motion *motion, double h,
                                       struct hawser_report *report)
{
	return split(motion, h, SPLITS, report);
}

int hawser__motion_asked(struct hawser__motion *motion)
{
	motion->stopped |= motion->stop && motion->stop(motion->data);
	return motion->stopped;
}

enum hawser_status hawser__motion_adapt(struct hawser__motion *motion, double *h, double end,
                                        double tolerance, struct hawser_report *report)
{
	const double power = 1.0/(motion->scheme->shown.order + 1.0);
	enum hawser_status status = HAWSER_OK;

	while (!status && motion->t < end*(1.0 - 4.0*DBL_EPSILON) && !hawser__events_due(motion) &&
	       !hawser__motion_asked(motion)) {
		double left = end - motion->t, part = ceil(left / *h), step = left/part, f;
		/* an impact has no derivatives: at some length the step is taken as it is */
		int least = step <= SHORTEST*end;
		int done;

		status = attempt(motion, &done, step, least ? INFINITY : tolerance, report);
		if (status)
			break;
		if (!done && motion->events && motion->events->cut > 0.0) {
			*h = motion->events->cut;
			continue;
		}
		if (!done && least) {
			status = hawser__motion_step(motion, step, report);
			continue;
		}
		motion->rejected += !done;
		f = motion->error > 0.0 ? SAFETY*pow(tolerance/motion->error, power) : done ? GROW : SHRINK;
		*h = step*fmin(fmax(f, SHRINK), done ? GROW : SAFETY);
	}
	return status;
}

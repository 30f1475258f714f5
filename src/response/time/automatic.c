/* response/time/automatic.c - gauss or radau, whichever is cheaper for the motion at hand.
 *
 *   ratio    work of a step of radau over that of a step of gauss, in additions and multiplications
 *
 * A run begins with gauss. Where its steps could be longer for the error alone, with coordinates that
 * are too fast for them as followers, radau is tried. Its steps must be longer than those of gauss by
 * more than the ratio; if not, a fast coordinate vibrates by more than the tolerance allows, and the
 * run returns to gauss for at least twice as many steps as the last time. What is decided depends on
 * the run alone, not on the machine's speed.
 *
 * On models without such coordinates gauss's steps follow the error, and nothing is tried. Figures:
 * doc/theory-integrate.md.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/orbit/collocation.h"
#include "response/time/stepper.h"
#include "rom/energy/kernel.h"

#define WORTH 1.2   /* of the ratio: steps of radau worth taking */
#define EVIDENCE 1.5 /* factor by which gauss's steps could be longer, from which radau is tried; it
                      * is 0.9 to 1.3 where its steps follow the error */
#define AT_MOST 10.0 /* ratio up to which that is enough: beyond it, the factor must exceed the ratio */
#define PATIENCE 16  /* steps, times the ratio, in which that shows, at first */
#define MORE 2       /* times as many after each return to gauss */
#define TERM 16      /* steps of radau that are judged together */
#define ENOUGH 0.8   /* part of the length wanted that will do: vibration dies out with radau, and
                      * lasts with gauss */
#define BEGINNING 0.4 /* the same in the first term, in which what is below the tolerance dies out */
#define ROUNDS 2.5  /* iterations of a step of radau, mostly */
/* A factorisation of order m costs m^2 (CUBIC m + SQUARE); JACOBIAN is the cost of a Jacobian, stored
 * in the matrix, over the count of its operations. Fitted to measured ratios: with 5, 10, 13 and 17
 * coordinates 1.8, 3.1, 4 and 2.2; computed ones: 1.6, 3.2, 5 and 3. */
#define CUBIC 0.1
#define SQUARE 17.0
#define JACOBIAN 1.5
#define OVERHEAD 200.0 /* operations that a call for a force is worth beside its own */

struct automatic {
	struct hawser__stepper base;
	const struct hawser__method *method; /* of `at_work` */
	struct hawser__stepper *at_work;
	double *y;            /* [2n] scratch */
	double force, tangent, dense; /* operations: of a force, of its Jacobian, of a factorisation */
	double mean_step, mean_calls; /* of gauss of late: length of a step, evaluations in it */
	double term_begin;    /* time at which the steps of radau that are judged next began */
	long evaluations;     /* of `at_work` before its last step */
	int seen;             /* steps that speak for radau, less those that do not */
	double patience;
	int taken, terms;     /* steps of radau since term_begin, and terms judged before */
	double by_radau;      /* time covered by its steps */
	struct hawser__stepper done; /* cost of the steppers that have been closed */
};

/* Operations of one call. */
static void count_work(struct automatic *automatic)
{
	const struct hawser_rom *rom = automatic->base.rom;
	double n = rom->n, order = n*HAWSER__NODES;

	automatic->force = OVERHEAD + 4.0*n*n + hawser__rom_flops(rom, 0);
	automatic->tangent = OVERHEAD + 4.0*(1 + HAWSER__NODES)*n*n + hawser__rom_flops(rom, 1);
	automatic->dense = order*order*(CUBIC*order + SQUARE);
}

static double ratio(const struct automatic *automatic)
{
	double s = HAWSER__NODES, stages = 4.0*s*automatic->base.rom->n; /* of one node, in a round */

	return (s*JACOBIAN*automatic->tangent + automatic->dense + ROUNDS*s*(automatic->force + stages))/
	       (fmax(automatic->mean_calls, s)*(automatic->force + stages));
}

static void close_automatic(struct hawser__stepper *stepper)
{
	struct automatic *automatic = (struct automatic *)stepper;

	if (automatic->at_work)
		automatic->method->close(automatic->at_work);
	free(automatic->y);
	free(automatic);
}

static void total(struct automatic *automatic)
{
	const struct hawser__stepper *at_work = automatic->at_work, *done = &automatic->done;

	automatic->base.steps = done->steps + at_work->steps;
	automatic->base.evaluations = done->evaluations + at_work->evaluations;
	automatic->base.jacobians = done->jacobians + at_work->jacobians;
	automatic->base.reached = at_work->reached;
	automatic->base.used = 2.0*automatic->by_radau > at_work->reached - automatic->base.begin ?
	                       hawser__radau.about.name : hawser__gauss.about.name;
}

/* Go on with the other method, from the time reached, with this step. */
static enum hawser_status change(struct automatic *automatic, const struct hawser__method *method,
                                 double step, struct hawser_report *report)
{
	struct hawser__stepper problem = automatic->base, *next;
	double reached = automatic->at_work->reached;
	enum hawser_status status = automatic->method->advance(automatic->at_work, automatic->y,
	                                                       reached, report);

	if (status)
		return status;
	problem.begin = reached;
	problem.first = step;
	problem.steps = problem.evaluations = problem.jacobians = 0;
	problem.max_steps -= automatic->base.steps;
	if (!(next = method->open(&problem, automatic->y)))
		return hawser__no_memory(report, "integrate");
	automatic->done.steps = automatic->base.steps;
	automatic->done.evaluations = automatic->base.evaluations;
	automatic->done.jacobians = automatic->base.jacobians;
	automatic->method->close(automatic->at_work);
	automatic->at_work = next;
	automatic->method = method;
	automatic->seen = automatic->taken = 0;
	automatic->terms = 0;
	automatic->term_begin = reached;
	return HAWSER_OK;
}

static void take_mean(double *mean, double value)
{
	*mean += (value - *mean)/(*mean > 0.0 ? PATIENCE : 1);
}

/* After a step of gauss. */
static enum hawser_status judge_gauss(struct automatic *automatic, struct hawser_report *report)
{
	double longer = automatic->at_work->longer, now;

	take_mean(&automatic->mean_step, automatic->at_work->step);
	take_mean(&automatic->mean_calls, automatic->at_work->evaluations - automatic->evaluations);
	now = ratio(automatic);
	automatic->seen += longer > (now > AT_MOST ? WORTH*now : EVIDENCE) ? 1 : -1;
	automatic->seen = automatic->seen > 0 ? automatic->seen : 0;
	if (automatic->seen < automatic->patience*fmax(now, 1.0))
		return HAWSER_OK;
	return change(automatic, &hawser__radau, fmax(longer, WORTH*now)*automatic->mean_step, report);
}

/* After a step of radau. */
static enum hawser_status judge_radau(struct automatic *automatic, struct hawser_report *report)
{
	double wanted = ratio(automatic)*automatic->mean_step, mean;

	if (++automatic->taken < TERM)
		return HAWSER_OK;
	mean = (automatic->at_work->reached - automatic->term_begin)/TERM;
	automatic->taken = 0;
	automatic->term_begin = automatic->at_work->reached;
	if (mean >= (automatic->terms++ ? ENOUGH : BEGINNING)*wanted)
		return HAWSER_OK;
	automatic->patience *= MORE;
	return change(automatic, &hawser__gauss, automatic->mean_step, report);
}

static enum hawser_status advance(struct hawser__stepper *stepper, double *y, double t,
                                  struct hawser_report *report)
{
	struct automatic *automatic = (struct automatic *)stepper;
	enum hawser_status status = HAWSER_OK;

	while (!status && automatic->at_work->reached < t) {
		if (automatic->at_work->steps)
			status = automatic->method == &hawser__gauss ? judge_gauss(automatic, report)
			                                             : judge_radau(automatic, report);
		automatic->evaluations = automatic->at_work->evaluations;
		if (!status && automatic->base.steps >= stepper->max_steps)
			return hawser__stepper_too_long(stepper, automatic->at_work->reached, report);
		if (!status)
			status = automatic->method->step(automatic->at_work, report);
		if (!status && automatic->method == &hawser__radau)
			automatic->by_radau += automatic->at_work->step;
		total(automatic);
	}
	return status ? status : automatic->method->advance(automatic->at_work, y, t, report);
}

static struct hawser__stepper *open_automatic(const struct hawser__stepper *problem,
                                              const double *y0)
{
	struct automatic *automatic = calloc(1, sizeof *automatic);

	if (!automatic)
		return NULL;
	automatic->base = *problem;
	automatic->base.watched = 1;
	automatic->method = &hawser__gauss;
	automatic->patience = PATIENCE;
	automatic->y = calloc(2*(size_t)problem->rom->n, sizeof *automatic->y);
	automatic->at_work = hawser__gauss.open(&automatic->base, y0);
	if (!automatic->y || !automatic->at_work) {
		close_automatic(&automatic->base);
		return NULL;
	}
	count_work(automatic);
	total(automatic);
	return &automatic->base;
}

const struct hawser__method hawser__automatic = {
	{"auto", "gauss or radau, whichever is cheaper for the motion at hand"},
	open_automatic, advance, close_automatic, NULL
};

/* ropeway/transient/transient.c - a ropeway that starts, brakes or runs: the run over time, its
 * rows, its extremes, what is refused, and the error by a second run with half the elements and
 * steps twice as long.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "core/settle.h"
#include "ropeway/transient/transient.h"

#define AFTER 20.0 /* s, after a ramp or a stop: some ten periods of the spans' sag */
#define SLOWEST 120.0 /* s, longest time to stop that is foreseen for a brake of given force */
#define ROUND_OFF 1e-12 /* of a time or a number of steps: it is reached */
enum { ELEMENTS = 7, PHASES = 200, ROWS = 500, /* defaults: waves of some 20 m, 0.5 % of a spacing, and
                                                * enough rows for a picture */
       MOST_ELEMENTS = 501, MOST_STEPS = 20000000 /* more are a mistake in the step */ };

void hawser_transient_settle(struct hawser_transient_options *options)
{
	hawser__settle_count(&options->elements, ELEMENTS);
	hawser__settle_count(&options->phases, PHASES);
}

/* --- what the event needs --- */

static enum hawser_status need(const struct hawser_ropeway *rw, struct hawser_report *report,
                               const char *text)
{
	char line[HAWSER__FILE_LINE];

	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "transient", "top.drive%s %s",
	                    hawser__file_line(line, rw->drive_line), text);
}

static enum hawser_status check_event(const struct hawser_ropeway *rw,
                                      const struct hawser_transient_options *o,
                                      struct hawser_report *report)
{
	char line[HAWSER__FILE_LINE];

	if (rw->lanes < 2)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "transient", "down: off leaves one lane, and "
		                    "a rope that moves needs the whole loop: remove that key");
	if (rw->sliding == HAWSER_ROPEWAY_REVERSE)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "transient", "sliding: reverse has no "
		                    "transients: the rope runs up on lane up; exchange the masses of the "
		                    "lanes");
	if (!(rw->speed > 0.0))
		return need(rw, report, "speed is missing or 0: give the speed of the rope, such as speed: "
		            "5 m/s");
	if (o->event == HAWSER_TRANSIENT_START && !(rw->ramp > 0.0))
		return need(rw, report, "ramp is missing or 0: give the time in which the drive reaches its "
		            "speed, such as ramp: 15 s");
	if (o->event == HAWSER_TRANSIENT_STOP && !(rw->brake > 0.0) && !(rw->brake_force > 0.0))
		return need(rw, report, "brake is missing: give its deceleration or its force, such as brake: "
		            "{deceleration: 1.25 m/s2}");
	if (rw->tension <= HAWSER_ROPEWAY_T0 && !(rw->carriage > 0.0))
		return hawser__fail(
			report, HAWSER_ERR_ARGUMENT, "transient",
			"bottom.mass is missing or 0: a carriage that moves needs the mass of itself and of all "
			"that moves with it (bottom.tension%s: a weight of %.6g N hung on it without pulleys has "
			"%.6g kg)", hawser__file_line(line, rw->tension_line),
			rw->tension == HAWSER_ROPEWAY_T0 ? 2.0*rw->value : rw->value,
			(rw->tension == HAWSER_ROPEWAY_T0 ? 2.0*rw->value : rw->value)/rw->g);
	return HAWSER_OK;
}

static double duration(const struct hawser_ropeway *rw, enum hawser_transient_event event, double mass)
{
	double spacing = rw->spacing > 0.0 ? rw->spacing : 10.0*rw->speed;

	if (event == HAWSER_TRANSIENT_START)
		return rw->ramp + AFTER;
	if (event == HAWSER_TRANSIENT_RUN)
		return 2.0*spacing/rw->speed;
	if (rw->brake > 0.0)
		return rw->speed/rw->brake + AFTER;
	return fmin(mass*rw->speed/rw->brake_force, SLOWEST) + AFTER;
}

static double mass_of(const struct hawser__chain *chain)
{
	double sum = chain->wheel_mass;

	for (int i = 0; i < chain->N; i++)
		sum += i == 1 ? 0.0 : chain->mass[i];
	return sum;
}

static enum hawser_status check_times(struct hawser_transient_options *o,
                                      const struct hawser_ropeway *rw, const struct hawser__slow *slow,
                                      double mass, struct hawser_report *report)
{
	double mean = 0.0, steps;

	for (int k = 0; k < 2*slow->spans; k++)
		mean += slow->length[k]/(2*slow->spans*o->elements);
	if (!(o->until > 0.0))
		o->until = duration(rw, o->event, mass);
	if (!(o->every > 0.0))
		o->every = o->until/ROWS;
	if (!(o->step > 0.0))
		o->step = 0.5*mean*sqrt(rw->rho/rw->EA);
	if (!isfinite(o->until) || !isfinite(o->every) || !isfinite(o->step) || o->every > o->until ||
	    o->until/o->step > MOST_STEPS || o->until/o->every > MOST_STEPS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "transient", "until = %.9g s with rows every "
		                    "%.9g s and steps of %.3g s: rows must be no further apart than the run is "
		                    "long, and there are at most %d steps and rows", o->until, o->every,
		                    o->step, MOST_STEPS);
	steps = ceil(o->every/o->step*(1.0 - ROUND_OFF));
	o->step = o->every/(o->skip_error ? steps : 2.0*ceil(0.5*steps)); /* even: the second has half */
	return HAWSER_OK;
}

/* --- the law of the drive --- */

static void command(struct hawser__chain *chain, enum hawser_transient_event event, double t)
{
	const struct hawser_ropeway *rw = chain->rw;

	chain->reference = rw->speed;
	chain->motor_most = rw->drive_most > 0.0 ? rw->drive_most : INFINITY;
	if (event == HAWSER_TRANSIENT_START) {
		chain->reference = rw->speed*fmin(t/rw->ramp, 1.0);
	} else if (event == HAWSER_TRANSIENT_STOP) {
		chain->reference = rw->brake > 0.0 ? fmax(rw->speed - rw->brake*t, 0.0) : 0.0;
		chain->motor_most = rw->brake > 0.0 ? INFINITY : rw->brake_force;
	}
}

/* --- the run --- */

static struct hawser_transient_range unknown(void)
{
	return (struct hawser_transient_range){NAN, NAN, NAN, NAN};
}

static double closure(const struct hawser_transient_energy *e)
{
	double scale = fmax(fmax(fabs(e->work), fabs(e->slow)),
	                    fmax(fmax(fabs(e->kinetic), fabs(e->stored)), fabs(e->dissipated)));

	return scale > 0.0 ? fabs(e->kinetic + e->stored - e->work - e->slow + e->dissipated)/scale : 0.0;
}

static void balance(struct hawser_transient *run, struct hawser__chain *chain, double kinetic,
                    double stored)
{
	double worst = run->energy.closure;

	run->energy = (struct hawser_transient_energy){
		.kinetic = hawser__chain_kinetic(chain, chain->mass) - kinetic,
		.stored = hawser__chain_stored(chain) - stored, .work = chain->work,
		.slow = chain->slow_work, .dissipated = chain->dissipated, .exchanged = chain->exchanged};
	run->energy.closure = fmax(worst, closure(&run->energy));
}

static enum hawser_status allot(struct hawser_transient *run, const struct hawser__slow *slow,
                                struct hawser_report *report)
{
	size_t spans = 2*(size_t)slow->spans, towers = 2*(size_t)slow->towers;

	run->rows = (int)floor(run->options.until/run->options.every*(1.0 + ROUND_OFF)) + 1;
	run->row = calloc((size_t)run->rows, sizeof *run->row);
	run->span = calloc(spans, sizeof *run->span);
	run->tower = calloc(towers + 1, sizeof *run->tower);
	if (!run->row || !run->span || !run->tower)
		return hawser__no_memory(report, "transient");
	run->spans = (int)spans;
	run->towers = (int)towers;
	for (int k = 0; k < run->spans; k++)
		run->span[k] = (struct hawser_transient_place){k/slow->spans, k%slow->spans, unknown(),
			unknown(), unknown()};
	for (int k = 0; k < run->towers; k++)
		run->tower[k] = (struct hawser_transient_place){k/slow->towers, k%slow->towers, unknown(),
			unknown(), unknown()};
	run->force = run->T = run->needed_friction = run->slip_arc = run->travel = run->acceleration =
		unknown();
	run->stopped_at = run->lifts_at = NAN;
	return HAWSER_OK;
}

/* From the state at t = 0 to the end. */
static enum hawser_status follow(struct hawser_transient *run, struct hawser__chain *chain,
                                 struct hawser_report *report)
{
	const struct hawser_transient_options *o = &run->options;
	long each = lround(o->every/o->step);
	double kinetic = hawser__chain_kinetic(chain, chain->mass), stored = hawser__chain_stored(chain);
	struct hawser_transient_row row;
	enum hawser_status status = HAWSER_OK;

	for (long i = 0; i <= (run->rows - 1)*each && !status; i++) {
		if (i > 0) {
			command(chain, o->event, (double)i*o->step);
			status = hawser__chain_step(chain, report);
			if (status)
				break;
		}
		chain->t = (double)i*o->step;
		hawser__transient_row(&row, chain);
		status = hawser__transient_judge(run, chain, &row, report);
		hawser__transient_extremes(run, chain, &row);
		balance(run, chain, kinetic, stored);
		if (i%each == 0)
			run->row[i/each] = row;
	}
	run->steps = chain->steps;
	run->solves = chain->solves;
	run->slipped = chain->slip;
	return status;
}

/* One run; of the second one only the rows are of use. */
static enum hawser_status one_run(struct hawser_transient *run, const struct hawser_ropeway *rw,
                                  const struct hawser__slow *slow, struct hawser_report *report)
{
	struct hawser__chain chain;
	enum hawser_status status = hawser__chain_open(&chain, rw, slow, &run->options, report);

	if (!status)
		status = hawser__chain_begin(&chain, run->options.event == HAWSER_TRANSIENT_START ? 0.0
		                             : rw->speed, report);
	if (!status) {
		run->mass = mass_of(&chain);
		run->rest_force = chain.now.force;
		status = check_times(&run->options, rw, slow, run->mass, report);
		chain.h = run->options.step;
	}
	if (!status)
		status = allot(run, slow, report);
	if (!status)
		status = follow(run, &chain, report);
	hawser__chain_clear(&chain);
	return status;
}

/* Differences from a run with half the elements and steps twice as long. */
static enum hawser_status estimate(struct hawser_transient *run, const struct hawser__slow *slow,
                                   struct hawser_report *report)
{
	struct hawser_transient other = {.ropeway = run->ropeway, .options = run->options};
	int half = run->options.elements/2;
	enum hawser_status status;

	other.options.elements = half < 1 ? 1 : half%2 ? half : half + 1;
	other.options.step = 2.0*run->options.step;
	other.options.tolerate = other.options.skip_error = 1;
	status = one_run(&other, run->ropeway, slow, report);
	run->error_force = run->error_T = run->error_travel = 0.0;
	for (int i = 0; i < run->rows && !status; i++) {
		const struct hawser_transient_row *a = &run->row[i], *b = &other.row[i];

		run->error_force = fmax(run->error_force, fabs(a->force - b->force));
		run->error_T = fmax(run->error_T, fmax(fabs(a->T_min - b->T_min), fabs(a->T_max - b->T_max)));
		run->error_travel = fmax(run->error_travel, fabs(a->travel - b->travel));
	}
	hawser_transient_clear(&other);
	return status;
}

enum hawser_status hawser_transient_solve(struct hawser_transient *run, const struct hawser_ropeway *rw,
                                          const struct hawser_transient_options *options,
                                          struct hawser_report *report)
{
	struct hawser__slow slow = {.phases = 0};
	enum hawser_status status;

	*run = (struct hawser_transient){.ropeway = rw, .error_force = NAN, .error_T = NAN,
	                                 .error_travel = NAN};
	if (options)
		run->options = *options;
	hawser_transient_settle(&run->options);
	if (run->options.load_case < 0 || run->options.load_case >= rw->cases ||
	    run->options.elements%2 == 0 || run->options.elements < 1 ||
	    run->options.elements > MOST_ELEMENTS || run->options.phases < 1)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "transient", "load case %d of %d with %d "
		                    "elements and %d phases: the case must exist, elements be an odd number "
		                    "from 1 to %d, and phases at least 1", run->options.load_case, rw->cases,
		                    run->options.elements, run->options.phases, MOST_ELEMENTS);
	status = check_event(rw, &run->options, report);
	if (!status)
		status = hawser__slow_open(&slow, rw, &run->options, report);
	if (!status)
		status = one_run(run, rw, &slow, report);
	if (!status && !run->options.skip_error)
		status = estimate(run, &slow, report);
	hawser__slow_clear(&slow);
	if (status)
		hawser_transient_clear(run);
	return hawser__in_file(report, status, rw->name);
}

void hawser_transient_clear(struct hawser_transient *run)
{
	if (!run)
		return;
	free(run->row);
	free(run->span);
	free(run->tower);
	memset(run, 0, sizeof *run);
}

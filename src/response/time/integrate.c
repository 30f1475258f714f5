/* response/time/integrate.c - hawser_integrate: the table of methods, and the loop over output times.
 *
 * `auto` begins with gauss and changes to radau if the motion excites coordinates that are too fast
 * for the steps (automatic.c). At equal error it needs less time than adams and bdf on the models
 * of bench/integrate (doc/theory-integrate.md); these two serve as independent methods for
 * comparison. If a coordinate is overdamped beyond all natural frequencies, `auto` is radau from
 * the beginning: a full-order model of a braking cable needs 86 steps with radau, and steps of 2 us
 * with gauss.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/append.h"
#include "core/progress.h"
#include "core/report.h"
#include "response/orbit/rest.h"
#include "response/time/stepper.h"
#include "rom/terms/history.h"
#include "rom/build/model.h"
#include "rom/terms/terms.h"

#define WHERE "integrate"
#define MIN_RTOL 1e-15          /* four and a half units of round-off */
/* Longest step, in intervals of a history, so that it cannot jump over what the table has: the steps of
 * all methods see the forces at several times. */
#define PER_STEP 2.0
#define MAX_BYTES 8589934592.0  /* of a trajectory: 8 GiB */

static const struct hawser__method *const methods[] = {&hawser__gauss, &hawser__radau,
	&hawser__adams, &hawser__bdf};
#define METHODS ((int)(sizeof methods/sizeof *methods))

const struct hawser_integrate_method *hawser_integrate_method(int index)
{
	return index >= 0 && index < METHODS ? &methods[index]->about : NULL;
}

/* 1 if the damping of a coordinate exceeds twice a bound on the natural frequencies: it is
 * overdamped, faster than everything that oscillates. Gyroscopic terms are off the diagonal and are
 * not counted, since they do not dissipate energy. */
static int overdamped(const struct hawser_rom *rom)
{
	int n = rom->n;
	double damping = 0.0, stiffness = 0.0;

	for (int j = 0; j < n; j++) {
		double row = 0.0;

		for (int k = 0; k < n; k++)
			row += fabs(rom->K[j*n + k]);
		stiffness = fmax(stiffness, row);
		damping = fmax(damping, rom->D[j*n + j]);
	}
	return damping > 2.0*sqrt(stiffness);
}

const struct hawser__method *hawser__integrate_default(const struct hawser_rom *rom)
{
	return overdamped(rom) ? &hawser__radau : &hawser__automatic;
}

static const struct hawser__method *choose(const char *name, const struct hawser_rom *rom)
{
	if (!name || !strcmp(name, "auto"))
		return hawser__integrate_default(rom);
	for (int i = 0; i < METHODS; i++)
		if (!strcmp(name, methods[i]->about.name))
			return methods[i];
	return NULL;
}

static enum hawser_status no_such_method(const char *name, struct hawser_report *report)
{
	char names[200] = "auto";

	for (int i = 0; i < METHODS; i++)
		hawser__append(names, sizeof names, ", ", "%s", methods[i]->about.name);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
	                    "no integration method is called '%s'; there are: %s", name, names);
}

static double or_default(double value, double fallback)
{
	return value == 0.0 ? fallback : value;
}

/* Tolerance for round-off of output times: 10 intervals of 0.1 in 1.0 give 11 rows, the last one at
 * 1.0. */
static double slack(double t, double every)
{
	return fmin(1e-12*t, 1e-3*every);
}

/* --- the forcing --- */

/* Change of the frequency per time. */
static double rate_of(const struct hawser_integrate_options *options)
{
	return options->omega_to > 0.0
	       ? (options->omega_to - options->omega)/(options->until - options->begin) : 0.0;
}

struct hawser_rom_moment hawser_integrate_moment(const struct hawser_integrate_options *options,
                                                 double t)
{
	double rate = rate_of(options), since = t - options->begin;

	return (struct hawser_rom_moment){.tau = options->omega*t + 0.5*rate*since*since,
	                                  .omega = options->omega + rate*since, .time = t};
}

/* --- arguments --- */

static enum hawser_status check_times(const struct hawser_integrate_options *options,
                                      const struct hawser_rom *rom, struct hawser_report *report)
{
	double span = options->until - options->begin, rows = span/options->every + 1.0;
	enum hawser_status status;

	if (!(options->until > 0.0) || !isfinite(options->until))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the end time (until) is %g%s: it must be positive and finite",
		                    HAWSER_SHOWN_TIME(rom, options->until));
	if (!(options->begin >= 0.0) || !(options->begin < options->until))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the run begins at t = %g%s: that must not be negative, and before "
		                    "its end (until), %g%s", HAWSER_SHOWN_TIME(rom, options->begin),
		                    HAWSER_SHOWN_TIME(rom, options->until));
	if (rom->history && (status = hawser__history_covers(rom, options->begin, options->until, report)))
		return status;
	if (!(options->omega_to >= 0.0) || !isfinite(options->omega_to))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the forcing frequency (Omega) ends at %g: it must be positive and "
		                    "finite", options->omega_to);
	if (!(options->every > 0.0) || options->every > options->until)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the output interval (every) is %g%s: it must be positive and no "
		                    "longer than the run, %g%s",
		                    HAWSER_SHOWN_TIME(rom, options->every),
		                    HAWSER_SHOWN_TIME(rom, options->until));
	if (rows >= INT_MAX || rows*(2.0*rom->n + 2.0)*sizeof(double) > MAX_BYTES)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "%.3g output rows of %d numbers would take %.3g GiB, above the "
		                    "limit of 8: raise the output interval (every) or shorten the "
		                    "run", rows, 2*rom->n + 2,
		                    rows*(2.0*rom->n + 2.0)*sizeof(double)/1073741824.0);
	return HAWSER_OK;
}

static enum hawser_status check_problem(const struct hawser__stepper *problem,
                                        struct hawser_report *report)
{
	if (!(problem->rtol >= MIN_RTOL && problem->rtol < 1.0))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the relative tolerance (rtol) is %g: it must be from %g to below "
		                    "1", problem->rtol, MIN_RTOL);
	if (!(problem->atol > 0.0) || !isfinite(problem->atol))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the absolute tolerance (atol) is %g: it must be positive",
		                    problem->atol);
	if (problem->max_steps < 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the limit on steps (max_steps) is %ld: it must be positive",
		                    problem->max_steps);
	if (problem->rom->harmonics > 0 && !hawser_rom_autonomous(problem->rom) &&
	    !(problem->omega > 0.0 && isfinite(problem->omega)))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, WHERE,
		                    "the model is forced, and its forcing frequency (Omega) is %g: it "
		                    "must be positive", problem->omega);
	return HAWSER_OK;
}

/* Check state and acceleration at t = 0, so that an invalid model or initial state is reported as
 * such. */
static enum hawser_status check_start(struct hawser__stepper *problem, double *scratch,
                                      const double *y, struct hawser_report *report)
{
	int n = problem->rom->n;

	for (int i = 0; i < 2*n; i++)
		if (!isfinite(y[i]))
			return hawser__fail(report, HAWSER_ERR_NAN, WHERE,
			                    "the %s of coordinate %d at t = %.6g%s is %g: check the "
			                    "initial state", i < n ? "displacement" : "velocity", i % n,
			                    HAWSER_SHOWN_TIME(problem->rom, problem->begin), y[i]);
	if (hawser__stepper_acceleration(problem, scratch, problem->begin,
	                                 hawser__stepper_phase(problem, problem->begin, 0.0), y, y + n))
		return hawser__fail(report, HAWSER_ERR_NAN, WHERE,
		                    "the acceleration of coordinate %d at t = %.6g%s is %g: check the "
		                    "model and the initial state", problem->bad_coordinate,
		                    HAWSER_SHOWN_TIME(problem->rom, problem->begin),
		                    scratch[problem->bad_coordinate]);
	return HAWSER_OK;
}

/* --- the run --- */

static enum hawser_status allocate(struct hawser_trajectory *trajectory, int n, int rows,
                                   struct hawser_report *report)
{
	trajectory->n = n;
	trajectory->time = malloc((size_t)rows*sizeof *trajectory->time);
	trajectory->state = calloc((size_t)rows*2*(size_t)n, sizeof *trajectory->state);
	trajectory->energy = malloc((size_t)rows*sizeof *trajectory->energy);
	if (trajectory->time && trajectory->state && trajectory->energy)
		return HAWSER_OK;
	hawser_trajectory_clear(trajectory);
	return hawser__no_memory(report, WHERE);
}

/* Append the row that was filled to the trajectory, unless it contains a number that is not
 * finite. */
static enum hawser_status keep_row(struct hawser_trajectory *trajectory,
                                   const struct hawser_rom *rom, double t,
                                   struct hawser_report *report)
{
	int n = rom->n, row = trajectory->rows;
	const double *y = trajectory->state + (size_t)row*2*(size_t)n;

	for (int i = 0; i < 2*n; i++)
		if (!isfinite(y[i]))
			return hawser__fail(report, HAWSER_ERR_NAN, WHERE,
			                    "the %s of coordinate %d at t = %.6g%s is %g",
			                    i < n ? "displacement" : "velocity", i % n,
			                    HAWSER_SHOWN_TIME(rom, t), y[i]);
	trajectory->time[row] = t;
	trajectory->energy[row] = hawser_rom_energy(rom, y, y + n) +
	                          (rom->ramp ? hawser__rom_ramp_energy(rom, y, t) : 0.0);
	trajectory->rows++;
	return HAWSER_OK;
}

/* Number of complete intervals up to t, with the tolerance of slack(). */
static double intervals(const struct hawser_integrate_options *options, double t)
{
	return floor((t + slack(t, options->every))/options->every);
}

/* Number of rows: one at the beginning, one at every later multiple of the interval, and one at the
 * end. */
static int count_rows(const struct hawser_integrate_options *options)
{
	double last = intervals(options, options->until), until = options->until;
	int beyond = until - last*options->every > slack(until, options->every);

	return (int)(last - intervals(options, options->begin)) + 1 + beyond;
}

/* Multiples of the interval are computed in the same way for every `begin`, so that they are equal
 * to the last bit in continued runs. */
static double output_time(const struct hawser_integrate_options *options, int row)
{
	double t = (intervals(options, options->begin) + row)*options->every;

	return t < options->until - slack(options->until, options->every) ? t : options->until;
}

/* The first time. If it is a multiple of the interval up to round-off (from a file in s), the
 * multiple itself. */
static double begin_of(const struct hawser_integrate_options *options)
{
	double t = intervals(options, options->begin)*options->every;

	return fabs(options->begin - t) <= slack(t, options->every) ? t : options->begin;
}

static void count_cost(struct hawser_trajectory *trajectory, const struct hawser__stepper *stepper)
{
	trajectory->steps += stepper->steps;
	trajectory->evaluations += stepper->evaluations;
	trajectory->jacobians += stepper->jacobians;
	if (stepper->used)
		trajectory->method = stepper->used;
}

/* A run: the problem, and the stepper that integrates it. */
struct course {
	const struct hawser__method *method;
	struct hawser__stepper problem;
	struct hawser__stepper *stepper;
};

/* Restart the integration at the end of a ramp, since the equations are not smooth there and no
 * step may extend across it. y [2n] is scratch. */
static enum hawser_status cross(struct course *course, struct hawser_trajectory *trajectory,
                                double *y, double until, struct hawser_report *report)
{
	enum hawser_status status = course->method->advance(course->stepper, y,
	                                                    course->problem.until, report);

	if (status)
		return status;
	count_cost(trajectory, course->stepper);
	course->problem.max_steps -= course->stepper->steps;
	course->problem.begin = course->problem.until;
	course->problem.until = until;
	course->problem.over = 1;
	course->method->close(course->stepper);
	course->stepper = course->method->open(&course->problem, y);
	return course->stepper ? HAWSER_OK : hawser__no_memory(report, WHERE);
}

/* Report progress at time t. */
static int told_to_stop(const struct hawser_integrate_options *options, double t, int rows,
                        double began)
{
	double begin = begin_of(options);
	struct hawser_progress_state state;

	if (!hawser__is_watched(&options->progress))
		return 0;
	state = hawser__progress_state("integration", "rows", rows, began);
	state.fraction = (t - begin)/(options->until - begin);
	return hawser__told_to_stop(&options->progress, &state);
}

static enum hawser_status run(struct hawser_trajectory *trajectory, struct course *course,
                              const struct hawser_integrate_options *options, int rows,
                              struct hawser_report *report)
{
	struct hawser__stepper *stepper = course->stepper;
	size_t width = 2*(size_t)stepper->rom->n;
	double began = hawser__wall_seconds();

	for (int row = 1; row < rows; row++) {
		double t = output_time(options, row), *y = trajectory->state + (size_t)row*width;
		enum hawser_status status = HAWSER_OK;

		if (t > course->problem.until)
			status = cross(course, trajectory, y, options->until, report);
		stepper = course->stepper;
		if (!status)
			status = course->method->advance(stepper, y, t, report);
		if (!status)
			status = keep_row(trajectory, stepper->rom, t, report);
		if (status)
			return status;
		if (told_to_stop(options, t, row + 1, began)) {
			trajectory->interrupted = 1;
			return HAWSER_OK;
		}
	}
	return HAWSER_OK;
}

enum hawser_status hawser_integrate(struct hawser_trajectory *trajectory,
                                    const struct hawser_rom *rom,
                                    const struct hawser_integrate_options *options,
                                    struct hawser_report *report)
{
	const struct hawser__method *method = choose(options->method, rom);
	struct course course = {.method = method, .problem = {
		.rom = rom, .omega = options->omega/hawser__rom_periods(rom),
		.rate = rate_of(options)/hawser__rom_periods(rom),
		.since = options->begin, .until = options->until,
		.rtol = or_default(options->rtol, HAWSER_DEFAULT_RTOL),
		.atol = or_default(options->atol, HAWSER_DEFAULT_ATOL),
		.max_steps = options->max_steps ? options->max_steps : HAWSER_DEFAULT_MAX_STEPS,
		.bad_coordinate = -1,
		.longest = rom->history ? PER_STEP*hawser__history_spacing(rom->history) : 0.0,
	}};
	struct hawser__stepper *problem = &course.problem;
	enum hawser_status status;
	int rows;

	memset(trajectory, 0, sizeof *trajectory);
	if (!method)
		return no_such_method(options->method, report);
	if ((status = check_times(options, rom, report)) || (status = check_problem(problem, report)))
		return status;
	problem->begin = begin_of(options);
	rows = count_rows(options);
	if ((status = allocate(trajectory, rom->n, rows, report)))
		return status;
	trajectory->method = method->about.name;
	if (options->initial)
		memcpy(trajectory->state, options->initial, 2*(size_t)rom->n*sizeof(double));
	else if (hawser__rest(trajectory->state, rom, hawser__stepper_phase(problem, problem->begin, 0.0),
	                      problem->omega))
		return hawser__no_memory(report, WHERE);
	if (rom->first) { /* u' = g(u, tau): the velocities follow */
		double *u = trajectory->state, *none = trajectory->state + 2*(size_t)rom->n;

		memset(none, 0, (size_t)rom->n*sizeof *none);
		hawser_rom_acceleration(rom->first, u + rom->n, u, none,
		                        hawser__stepper_phase(problem, problem->begin, 0.0), problem->omega);
	}
	/* the second row is not yet filled and serves as scratch for the first acceleration */
	if ((status = check_start(problem, trajectory->state + 2*(size_t)rom->n, trajectory->state,
	                          report)) ||
	    (status = keep_row(trajectory, rom, problem->begin, report)))
		return status;
	problem->over = rom->ramp && rom->ramp->time <= problem->begin;
	if (rom->ramp && !problem->over && rom->ramp->time < options->until)
		problem->until = rom->ramp->time;
	if (!(course.stepper = method->open(problem, trajectory->state)))
		return hawser__no_memory(report, WHERE);
	status = run(trajectory, &course, options, rows, report);
	if (course.stepper) {
		count_cost(trajectory, course.stepper);
		method->close(course.stepper);
	}
	return status;
}

void hawser_trajectory_clear(struct hawser_trajectory *trajectory)
{
	if (!trajectory)
		return;
	free(trajectory->time);
	free(trajectory->state);
	free(trajectory->energy);
	memset(trajectory, 0, sizeof *trajectory);
}

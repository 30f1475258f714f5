/* rod/integrate.c - hawser_rod_integrate: a motion, its rows, and its step and mesh error.
 *
 * Beside the motion run two others: one makes each of its steps in halves, the other has twice as many
 * elements. Both errors are of order 2, so that 4/3 of the largest difference of places is the error
 * of the motion itself. Where loads jump or have a kink, steps end, and rates begin anew.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/order.h"
#include "core/progress.h"
#include "core/hold.h"
#include "core/report.h"
#include "rod/run.h"
#include "rod/so3.h"

enum { ROWS = 10000000, DEFAULT_ROWS = 400, MAIN = 0, HALVES = 1, FINE = 2, TWINS = 3 };
#define ASKED_EVERY 0.05    /* s, between two questions whether to go on: not felt by the user */
#define TOLERANCE 1e-6      /* lengths of the rod, of the local error: some 1e-3 of it in a run */
#define SAME 1e-12          /* of the time: two times that are closer are one */
#define SHARE (4.0/3.0)      /* of the difference from half the step or element, by order 2 */

struct run {
	const struct hawser_rod_motion_options *options;
	struct hawser__rod_twin twin[TWINS];
	double *stop;            /* [stops] s, in order: when a load jumps or has a kink */
	int stops, next;         /* next: the first that is not passed */
	double h, first, step, every, tolerance; /* s, s, s, s, m; step 0: by the error; first: shortest */
	double began, asked;     /* s, clock */
	double from, turned;     /* s; revolutions */
	int stopped;
};

const struct hawser_rod_scheme *hawser_rod_scheme(int index)
{
	static const struct hawser_rod_scheme table[] = {
		{"alpha", "generalised-alpha on places and rotations: damps what is faster than the step, "
		 "order 2", "Bruels and Cardona 2010", 2},
	};

	return index >= 0 && (size_t)index < sizeof table/sizeof *table ? &table[index] : NULL;
}

void hawser_rod_motion_clear(struct hawser_rod_motion *motion)
{
	if (!motion)
		return;
	hawser__hold_clear(&(struct hawser__hold){.last = motion->held});
	free(motion->state);
	memset(motion, 0, sizeof *motion);
}

/* --- the beginning --- */

static enum hawser_status stops(struct run *run, const struct hawser_rod *rod,
                                struct hawser_report *report)
{
	const struct hawser_rod_winch *winch = &rod->winch;
	size_t count = 2 + (size_t)winch->rows;

	for (int l = 0; l < rod->loads; l++)
		count += (size_t)rod->load[l].factors;
	run->stop = calloc(count, sizeof *run->stop);
	if (!run->stop)
		return hawser__no_memory(report, "rod");
	for (int l = 0; l < rod->loads; l++)
		for (int i = 0; i < rod->load[l].factors; i++)
			run->stop[run->stops++] = rod->load[l].factor[i][0];
	for (int i = 0; i < winch->rows; i++)
		run->stop[run->stops++] = winch->row[i][0];
	if (winch->on && winch->rise > 0.0)
		run->stop[run->stops++] = winch->rise;
	qsort(run->stop, (size_t)run->stops, sizeof *run->stop, hawser__ascending);
	return HAWSER_OK;
}

/* The time in which an axial wave passes an element. */
static double transit(const struct hawser__rod_twin *twin)
{
	double least = INFINITY;

	for (int e = 0; e < twin->mesh.elements; e++) {
		const struct hawser__rod_element *el = &twin->mesh.element[e];

		least = fmin(least, el->h*sqrt(twin->mesh.rod->segment[twin->mesh.segment[e]].rho/el->EA[0]));
	}
	return least;
}

static enum hawser_status resume(struct run *run, struct hawser_report *report)
{
	struct hawser__rod_motion *motion = &run->twin[MAIN].motion;
	enum hawser_status status = hawser__rod_state_read(motion, &run->h, &run->turned,
	                                                   run->options->initial, report);
	double length;

	if (status)
		return status;
	if (motion->t >= run->options->until)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "%s is the state at %g s, and the run "
		                    "is to end at %g s: the end counts from the beginning of the first run",
		                    run->options->initial, motion->t, run->options->until);
	while (run->next < run->stops && run->stop[run->next] < motion->t*(1.0 - SAME))
		run->next++;
	length = motion->winch.length;
	hawser__rod_motion_factors(motion, motion->t, 0);
	status = hawser__rod_winch_same(motion, length, run->options->initial, report);
	(void)hawser__rod_motion_form(motion, motion->t, 0);
	hawser__rod_winch_power(motion);
	return status;
}

/* The other two motions; what they cannot do is noted, and only the lack of memory ends the run. */
static enum hawser_status others(struct run *run, struct hawser_rod_motion *to,
                                 const struct hawser_rod *rod, struct hawser_report *report)
{
	enum hawser_status status = HAWSER_OK;

	for (int i = HALVES; i < TWINS && !status; i++) {
		struct hawser__rod_twin *twin = &run->twin[i];

		status = hawser__rod_twin_open(twin, rod, i == FINE ? 2 : 1, run->options->until, 0,
		                               &to->unchecked);
		twin->motion.rho_inf = run->twin[MAIN].motion.rho_inf;
		twin->parts = i == HALVES ? 2 : 1;
		if (!status)
			status = hawser__rod_motion_begin(&twin->motion, 1, &to->unchecked);
		twin->live = !status;
	}
	return status == HAWSER_ERR_MEMORY ? hawser__no_memory(report, "rod") : HAWSER_OK;
}

static enum hawser_status prepare(struct run *run, struct hawser_rod_motion *to,
                                  const struct hawser_rod *rod, struct hawser_report *report)
{
	const struct hawser_rod_motion_options *options = run->options;
	struct hawser__rod_twin *twin = &run->twin[MAIN];
	enum hawser_status status;

	if (!(options->until > 0.0) || !isfinite(options->until))
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "the end of the motion must be a "
		                    "positive time, not %g s", options->until);
	run->every = options->every > 0.0 ? options->every : options->until/DEFAULT_ROWS;
	if (options->until/run->every > ROWS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "rod", "%.3g rows are more than %d: choose a "
		                    "longer time between them", options->until/run->every, ROWS);
	run->step = options->step != 0.0 ? fmax(options->step, 0.0) : rod->step;
	run->tolerance = (options->tolerance > 0.0 ? options->tolerance : TOLERANCE)*rod->length;
	status = stops(run, rod, report);
	if (!status)
		status = hawser__rod_twin_open(twin, rod, 1, options->until, options->initial != NULL, report);
	if (status)
		return status;
	if (options->rho_inf != 0.0)
		twin->motion.rho_inf = fmax(options->rho_inf, 0.0);
	run->first = run->h = 0.1*transit(twin);
	if (options->initial)
		return resume(run, report);
	status = hawser__rod_motion_begin(&twin->motion, 1, report);
	while (run->next < run->stops && run->stop[run->next] <= 0.0)
		run->next++;
	return status || options->skip_error ? status : others(run, to, rod, report);
}

/* --- steps --- */

static int ask(const struct run *run, long rows)
{
	const struct hawser_rod_motion_options *options = run->options;
	double t = run->twin[MAIN].motion.t;
	struct hawser_progress_state state = hawser__progress_state("motion", "rows", rows, run->began);

	state.expected = (long)((options->until - run->from)/run->every) + 1;
	state.fraction = (t - run->from)/fmax(options->until - run->from, DBL_MIN);
	return hawser__told_to_stop(&options->progress, &state);
}

/* Part of the step h by which the rod turns about z, revolutions. */
static double turn_of(const struct hawser__rod_motion *motion, double h)
{
	double sum = 0.0;

	for (int i = 0; i < motion->mesh->nodes; i++) {
		double before[9], now[9], length = 0.0;

		for (int e = i - 1; e <= i; e++)
			if (e >= 0 && e < motion->mesh->elements)
				length += 0.5*motion->mesh->element[e].h;
		hawser__quaternion_matrix(before, motion->node0[i].q);
		hawser__quaternion_matrix(now, motion->mesh->node[i].q);
		sum += length*0.5*(hawser__dot(before + 6, motion->velocity0[i] + 3) +
		                   hawser__dot(now + 6, motion->velocity[i] + 3));
	}
	return sum*h/motion->mesh->rod->length/(2.0*acos(-1.0));
}

/* The others make the step of the first motion. */
static void follow(struct run *run, struct hawser_rod_motion *to, double t, int anew)
{
	for (int i = HALVES; i < TWINS; i++) {
		struct hawser__rod_twin *twin = &run->twin[i];
		double h = (t - twin->motion.t)/twin->parts;
		enum hawser_status status = HAWSER_OK;

		for (int k = 0; k < twin->parts && twin->live && !anew && !status; k++)
			status = hawser__rod_motion_step(&twin->motion, h, &to->unchecked);
		if (!anew)
			twin->motion.t = t;
		if (twin->live && anew)
			status = hawser__rod_motion_begin(&twin->motion, 0, &to->unchecked);
		twin->live = twin->live && !status;
	}
}

/* Loads that jump or have a kink now: rates begin anew, after a jump with the shortest step. */
static enum hawser_status pass(struct run *run, struct hawser_rod_motion *to,
                               struct hawser_report *report)
{
	struct hawser__rod_motion *motion = &run->twin[MAIN].motion;
	double t = motion->t;
	int at = 0, jump = 0;

	while (run->next < run->stops && run->stop[run->next] <= t*(1.0 + SAME)) {
		run->next++;
		at = 1;
	}
	for (int l = 0; l < motion->mesh->rod->loads; l++)
		for (int i = 1; i < motion->mesh->rod->load[l].factors; i++) {
			const double *row = motion->mesh->rod->load[l].factor[i];

			jump |= row[0] == row[-2] && fabs(row[0] - t) <= SAME*t;
		}
	if (!at)
		return HAWSER_OK;
	run->h = jump ? run->first : 0.25*run->h;
	follow(run, to, t, 1);
	return hawser__rod_motion_begin(motion, 0, report);
}

/* To time `end`, at most to the next jump or kink. */
static enum hawser_status march(struct run *run, struct hawser_rod_motion *to, double end,
                                struct hawser_report *report)
{
	struct hawser__rod_motion *motion = &run->twin[MAIN].motion;
	double fixed = run->step > 0.0 ? (end - motion->t)/ceil((end - motion->t)/run->step*(1.0 - SAME))
	                               : 0.0;
	enum hawser_status status = HAWSER_OK;

	while (!status && end - motion->t > SAME*end) {
		double before = motion->t, now = hawser__wall_seconds();

		if (hawser__is_watched(&run->options->progress) && now - run->asked > ASKED_EVERY) {
			run->asked = now;
			run->stopped = ask(run, to->rows);
			if (run->stopped)
				return HAWSER_OK;
		}
		status = fixed > 0.0 ? hawser__rod_motion_step(motion, fixed, report)
			: hawser__rod_motion_adapt(motion, &run->h, end, run->tolerance, report);
		if (status)
			break;
		if (end - motion->t <= SAME*end)
			motion->t = end;
		run->turned += turn_of(motion, motion->t - before);
		follow(run, to, motion->t, 0);
	}
	return status;
}

static enum hawser_status advance(struct run *run, struct hawser_rod_motion *to, double end,
                                  struct hawser_report *report)
{
	struct hawser__rod_motion *motion = &run->twin[MAIN].motion;
	enum hawser_status status = HAWSER_OK;

	while (!status && !run->stopped && end - motion->t > SAME*end) {
		double stop;

		status = pass(run, to, report);
		stop = run->next < run->stops ? run->stop[run->next] : INFINITY;
		if (!status)
			status = march(run, to, fmin(stop, end), report);
	}
	return status;
}

/* --- rows --- */

static void compare(struct hawser_rod_motion *to, struct run *run)
{
	const struct hawser__rod_mesh *mesh = &run->twin[MAIN].mesh;

	for (int i = HALVES; i < TWINS; i++) {
		const struct hawser__rod_twin *twin = &run->twin[i];
		double *error = i == HALVES ? &to->step_error : &to->mesh_error;

		for (int n = 0; n < mesh->nodes && twin->live; n++) {
			const double *a = mesh->node[n].x, *b = twin->mesh.node[i == FINE ? 2*n : n].x;
			double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};

			*error = fmax(*error, SHARE*sqrt(hawser__dot(d, d)));
		}
		run->twin[i].motion.factor_h = 0.0;
	}
}

static enum hawser_status rows(struct hawser_rod_motion *to, struct run *run,
                               struct hawser_report *report)
{
	struct hawser__rod_twin *twin = &run->twin[MAIN];
	double first = floor(twin->motion.t/run->every*(1.0 + SAME));
	double last = run->options->until/run->every;
	enum hawser_status status = hawser__rod_rows_open(to, (size_t)fmax(last - first, 0.0) + 3,
	                                                  (size_t)run->options->probes,
	                                                  (size_t)twin->mesh.nodes, report);

	run->from = twin->motion.t;
	run->began = hawser__wall_seconds();
	if (!status)
		status = hawser__rod_row(to, twin, run->turned, run->options, report);
	for (double i = first + 1.0; i <= last*(1.0 + SAME) && !status && !to->interrupted; i++) {
		status = advance(run, to, i*run->every, report);
		to->interrupted = run->stopped;
		if (status || to->interrupted)
			break;
		status = hawser__rod_row(to, twin, run->turned, run->options, report);
		compare(to, run);
		to->interrupted |= ask(run, to->rows);
	}
	to->reached = twin->motion.t;
	return status;
}

static void finish(struct hawser_rod_motion *to, const struct run *run)
{
	const struct hawser__rod_motion *motion = &run->twin[MAIN].motion;
	double most = 0.0;

	for (int i = 0; i < to->rows; i++)
		most = fmax(most, fabs(to->lost[i]));
	to->closure = most/fmax(motion->most_energy, DBL_MIN);
	to->momentum_gap = motion->momentum_gap;
	to->angular_gap = motion->angular_gap;
	to->local_error = motion->drift;
	to->checked = run->twin[HALVES].live && run->twin[FINE].live;
	to->scheme = hawser_rod_scheme(0)->name;
	to->rho_inf = motion->rho_inf;
	to->elements = motion->mesh->elements;
	to->unknowns = motion->mesh->n;
	to->steps = motion->steps;
	to->iterations = motion->iterations;
	to->factored = motion->factored;
	to->rejected = motion->rejected;
	to->splits = motion->splits;
}

enum hawser_status hawser_rod_integrate(struct hawser_rod_motion *to, const struct hawser_rod *rod,
                                        const struct hawser_rod_motion_options *options,
                                        struct hawser_report *report)
{
	struct run *run = calloc(1, sizeof *run);
	enum hawser_status status;

	memset(to, 0, sizeof *to);
	if (!run)
		return hawser__no_memory(report, "rod");
	run->options = options;
	status = prepare(run, to, rod, report);
	if (!status)
		status = rows(to, run, report);
	if (!status)
		status = hawser__rod_state_save(&to->state, &to->states, &run->twin[MAIN].motion, run->h,
		                                run->turned, report);
	if (!status)
		finish(to, run);
	for (int i = 0; i < TWINS; i++)
		hawser__rod_twin_clear(&run->twin[i]);
	free(run->stop);
	free(run);
	if (status)
		hawser_rod_motion_clear(to);
	return status;
}

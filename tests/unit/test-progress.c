/* Progress: the line of text for a state, omission of unknown members, and truncation of the line; the
 * processor's clock.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <sys/resource.h>

#include "core/progress.h"
#include "tests/tap.h"

static void says(const struct hawser_progress_state *state, const char *want)
{
	char text[200];

	hawser_progress_text(state, text, sizeof text);
	ok(!strcmp(text, want), "%s", text);
}

static int answer(void *data, const struct hawser_progress_state *state)
{
	return state->done >= *(const long *)data;
}

/* Where the processor time of a process is limited, Linux brings the clock of the process up to date at
 * its ticks alone, 1 to 10 ms apart. */
static void clock_of_limited(void)
{
	struct rlimit before, limited;
	double least = 1.0, began, now;
	int limits = getrlimit(RLIMIT_CPU, &before);

	limited = before;
	limited.rlim_cur = limited.rlim_cur < 100000 ? limited.rlim_cur : 100000;
	limits |= setrlimit(RLIMIT_CPU, &limited);
	for (int i = 0; i < 10; i++, least = fmin(least, now - began)) {
		began = hawser__processor_seconds();
		do
			now = hawser__processor_seconds();
		while (!(now > began));
	}
	limits |= setrlimit(RLIMIT_CPU, &before);
	ok(!limits && least < 1e-4, "with limited processor time its clock moves on after %.1e s", least);
}

/* Halfway from 0.2 to 0.6 of the whole, 3 s after its beginning; then a stage that says nothing. */
static void stages(double began)
{
	struct hawser__span span = {.began = began - 3.0};
	struct hawser_progress_state state = hawser__progress_state("sweep", "points", 3, began);

	hawser__span_foretell(&span, &state);
	ok(state.fraction == 0.0 && isnan(state.left), "at the beginning no time is told");
	hawser__span_stage(&span, 0.2, 0.6);
	state.fraction = 0.5;
	hawser__span_foretell(&span, &state);
	close_to(state.fraction, 0.4, 1e-12, "part of the whole");
	close_to(state.left, 4.5, 0.05, "what took 3 s for 0.4 takes another 4.5 s");
	hawser__span_stage(&span, 0.3, 1.0);
	state.fraction = NAN;
	hawser__span_foretell(&span, &state);
	close_to(state.fraction, 0.4, 1e-12, "it does not fall");
}

static int keep(void *data, const struct hawser_progress_state *state)
{
	*(struct hawser_progress_state *)data = *state;
	return 0;
}

/* 6 of 20, of which 2 were there before: 4 took 3 s, so that 14 take 10.5 s. */
static void left_of(double began)
{
	struct hawser_progress_state told,
		state = hawser__progress_state("sweep", "points", 6, began - 3.0);
	const struct hawser_progress progress = {keep, &told};

	state.expected = 20;
	state.fresh = 4;
	hawser__told_to_stop(&progress, &state);
	close_to(told.fraction, 0.3, 1e-12, "the fraction follows from the numbers");
	close_to(told.left, 10.5, 0.1, "the time left follows from those that this run has computed");
	state.left = 7.0;
	hawser__told_to_stop(&progress, &state);
	close_to(told.left, 7.0, 1e-12, "unless the computation knows better");
}

/* What is told of the state at a second of a run; left: NAN: the stage says nothing. */
static struct hawser_progress_state told_at(struct hawser__forecast *forecast, double at, double left)
{
	struct hawser_progress_state state = hawser__progress_state("sweep", "points", 6,
	                                                            hawser__wall_seconds());

	forecast->began = hawser__wall_seconds() - at;
	state.left = left;
	hawser__forecast_hear(forecast, &state);
	hawser__forecast_tell(forecast, &state);
	return state;
}

static void forecasts(void)
{
	struct hawser__forecast steady = {.told = 0.0}, drifting = {.told = 0.0};
	struct hawser_progress_state state;
	int told = 0;

	ok(isnan(told_at(&steady, 0.1, NAN).left), "nothing is known");
	ok(isnan(told_at(&steady, 1.0, 9.0).left), "a first forecast is not told");
	for (double at = 1.1; at < 2.0; at += 0.1)
		state = told_at(&steady, at, 10.0 - at);
	close_to(state.left, 8.1, 0.2, "one that stays is told");
	close_to(state.fraction, 0.19, 0.01, "with the part of the run that it means");
	state = told_at(&steady, 3.0, NAN);
	close_to(state.left, 7.0, 0.01, "a stage that says nothing leaves the end where it was");
	state = told_at(&steady, 4.0, 10.0);
	ok(state.longer && state.fraction >= 0.28, "a later end says so, and the part does not fall: %g",
	   state.fraction);
	for (double at = 1.0; at < 20.0; at *= 1.1)
		told += !isnan(told_at(&drifting, at, at*at).left);
	ok(told < 8, "ends that run away are not told: %d of 32 are", told);
	for (double at = 20.0; at < 60.0; at += 0.1)
		state = told_at(&drifting, at, 100.0 - at);
	close_to(state.left, 40.0, 1.0, "after many more than are kept the last ones count");
}

CASE(unit_progress)
{
	double began = hawser__wall_seconds();
	struct hawser_progress_state state = hawser__progress_state("sweep", "frequencies", 3, began);
	struct hawser_progress progress = {.function = NULL};
	char text[12];
	long most = 4;

	ok(state.seconds >= 0.0 && state.seconds < 60.0, "time since the beginning: %g s",
	   state.seconds);
	ok(state.fresh == 3 && !state.frf && isnan(state.fraction) && isnan(state.left),
	   "all else is unknown");
	says(&state, "sweep: 3 frequencies");
	hawser_progress_text(&state, text, sizeof text);
	ok(!strcmp(text, "sweep: 3 fr"), "cut: %s", text);
	text[0] = 'x';
	hawser_progress_text(&state, text, 0);
	ok(text[0] == 'x', "no room: nothing is written");
	state.expected = 20;
	state.fraction = 0.15;
	state.left = 42.385;
	says(&state, "sweep: 15 %, 3 of about 20 frequencies, about 42 s left");
	state = hawser__progress_state("fold curve", "points", 7, began);
	state.events = 2;
	state.omega = 2.385;
	state.load = 0.75;
	says(&state, "fold curve: 7 points, 2 events, Omega 2.385, load 0.75");

	ok(!hawser__is_watched(&progress) && !hawser__told_to_stop(&progress, &state),
	   "without a function nobody ends the run");
	progress = (struct hawser_progress){answer, &most};
	ok(hawser__is_watched(&progress) && hawser__told_to_stop(&progress, &state),
	   "7 of at most 4 points: the function ends it");
	state.done = 2;
	ok(!hawser__told_to_stop(&progress, &state), "2 of at most 4: it goes on");
	stages(began);
	left_of(began);
	forecasts();
	clock_of_limited();
	return done_testing();
}

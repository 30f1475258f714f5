/* Progress: the line of text for a state, omission of unknown members, and truncation of the line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

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
	return done_testing();
}

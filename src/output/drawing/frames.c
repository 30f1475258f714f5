/* output/drawing/frames.c - see frames.h. Whether an axis is logarithmic is no variable of
 * gnuplot, so it is read from the script: its "set logscale" before the plot.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "output/drawing/frames.h"

static const char mark[] = "hawser-panel ", none[] = "# no quantities";
/* px: lower panels hold a legend only. */
static const double lowest = 20.0;

void hawser__frames_ask(FILE *script)
{
	fprintf(script,
	        "if (exists('GPVAL_X_MIN')) print '%s', GPVAL_TERM_XMIN, GPVAL_TERM_XMAX, GPVAL_TERM_YMIN, "
	        "GPVAL_TERM_YMAX, GPVAL_X_MIN, GPVAL_X_MAX, GPVAL_Y_MIN, GPVAL_Y_MAX\n", mark);
}

void hawser__frames_none(FILE *script)
{
	fprintf(script, "%s\n", none);
}

static int begins(const char *line, const char *word)
{
	return strncmp(line, word, strlen(word)) == 0;
}

int hawser__frames_answer(const char *line)
{
	return begins(line, mark);
}

/* What is known of the panel being plotted. */
struct state {
	int log;     /* now: bit 1: x, bit 2: y */
	int plotted; /* log at the last plot; -1: nothing is plotted since the last question */
	int hidden;
};

/* "x", "y", "xy"; "" is all. */
static int axes(const char *names)
{
	size_t length = strcspn(names, " \n");

	if (length == 0)
		return 3;
	return (memchr(names, 'x', length) ? 1 : 0) | (memchr(names, 'y', length) ? 2 : 0);
}

static void follow(struct state *state, const char *line)
{
	static const char on[] = "set logscale", off[] = "unset logscale";

	if (begins(line, on))
		state->log |= axes(line + sizeof on - 1 + (line[sizeof on - 1] == ' '));
	else if (begins(line, off))
		state->log &= ~axes(line + sizeof off - 1 + (line[sizeof off - 1] == ' '));
	else if (begins(line, none))
		state->hidden = 1;
	else if (begins(line, "plot "))
		state->plotted = state->log;
}

/* Go on to the next question in the script and say what was plotted before it: its bits, or -1. */
static int next_panel(FILE *script, struct state *state)
{
	char line[256];
	int fresh = 1; /* 0: the rest of a long line */

	state->plotted = -1;
	state->hidden = 0;
	while (fgets(line, sizeof line, script)) {
		if (fresh && begins(line, "if (exists('GPVAL_X_MIN'))"))
			return state->hidden ? -1 : state->plotted;
		if (fresh)
			follow(state, line);
		fresh = strchr(line, '\n') != NULL;
	}
	return -1;
}

/* The next answer: px and ranges [8]. Returns 0 if there is none. */
static int answer(double *value, FILE *messages)
{
	char line[400];

	while (fgets(line, sizeof line, messages))
		if (begins(line, mark))
			return sscanf(line + sizeof mark - 1, "%lf %lf %lf %lf %lf %lf %lf %lf", &value[0],
			              &value[1], &value[2], &value[3], &value[4], &value[5], &value[6],
			              &value[7]) == 8;
	return 0;
}

void hawser__frames_write(FILE *to, FILE *script, FILE *messages, double height)
{
	struct state state = {.log = 0};
	const char *between = "";
	double value[8];

	rewind(script);
	rewind(messages);
	next_panel(script, &state); /* before the first plot gnuplot has no ranges, and no answer */
	fputs("data-panels=\"", to);
	while (answer(value, messages)) {
		int log = next_panel(script, &state);

		if (log < 0 || !(value[3] - value[2] > lowest))
			continue;
		fprintf(to, "%s%.2f %.2f %.2f %.2f %.10g %.10g %.10g %.10g %d", between, value[0], value[1],
		        height - value[3], height - value[2], value[4], value[5], value[6], value[7], log);
		between = ";";
	}
	fputs("\" ", to);
}

/* core/progress.c - see progress.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <time.h>

#include <hawser/status.h>

#include "core/progress.h"

#define WORTH 0.02 /* part of a whole above which a time left is told; chosen */

double hawser__wall_seconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1e-9*(double)now.tv_nsec;
}

double hawser__processor_seconds(void)
{
	struct timespec now;

	/* not that of the process, which Linux brings up to date at its ticks alone, some ms apart, where
	 * the processor time is limited (ulimit -t, batch systems): short work would take 0 s */
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9*(double)now.tv_nsec;
}

struct hawser_progress_state hawser__progress_state(const char *stage, const char *unit, long done,
                                                    double began)
{
	return (struct hawser_progress_state){.stage = stage, .unit = unit, .done = done,
		.fresh = done, .fraction = NAN, .seconds = hawser__wall_seconds() - began, .left = NAN,
		.omega = NAN, .load = NAN, .events = -1};
}

void hawser__span_stage(struct hawser__span *span, double from, double to)
{
	span->from = from;
	span->to = to;
}

void hawser__span_foretell(struct hawser__span *span, struct hawser_progress_state *state)
{
	double inside = isnan(state->fraction) ? 0.0 : state->fraction;

	span->reached = fmax(span->reached, span->from + inside*(span->to - span->from));
	state->fraction = span->reached;
	state->left = span->reached > WORTH ? (hawser__wall_seconds() - span->began)*
	                                      (1.0/span->reached - 1.0) : NAN;
}

static void add(char **text, size_t *size, const char *format, ...) HAWSER_PRINTF(3, 4);

static void add(char **text, size_t *size, const char *format, ...)
{
	va_list args;
	int length;

	va_start(args, format);
	length = vsnprintf(*text, *size, format, args);
	va_end(args);
	if (length < 0 || *size == 0)
		return;
	if ((size_t)length >= *size)
		length = (int)(*size - 1);
	*text += length;
	*size -= (size_t)length;
}

void hawser_progress_text(const struct hawser_progress_state *state, char *text, size_t size)
{
	add(&text, &size, "%s: ", state->stage);
	if (!isnan(state->fraction))
		add(&text, &size, "%.0f %%, ", 100.0*state->fraction);
	if (state->expected > 0)
		add(&text, &size, "%ld of about %ld %s", state->done, state->expected, state->unit);
	else
		add(&text, &size, "%ld %s", state->done, state->unit);
	if (state->events >= 0)
		add(&text, &size, ", %d events", state->events);
	if (!isnan(state->omega))
		add(&text, &size, ", Omega %.6g", state->omega);
	if (!isnan(state->load))
		add(&text, &size, ", load %.4g", state->load);
	if (!isnan(state->left))
		add(&text, &size, ", about %.0f s left", state->left);
}

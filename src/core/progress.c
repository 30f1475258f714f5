/* core/progress.c - see progress.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <time.h>

#include <hawser/status.h>

#include "core/progress.h"

#define WORTH 0.02  /* fraction of several stages from which on a time left is computed; chosen */
#define RECENT 0.4  /* a time left is told if the end of the run that follows from it has
                     * changed, in this last part of the run so far, by less than */
#define SAME 1.45   /* this factor. While a fraction stands still, the end moves in this part by
                     * 1/(1 - RECENT) = 1.67, and is not told; both chosen */
#define LONGER 1.25 /* ratio of an end to the earliest one that was told, from which on the text
                     * says that it is later than foreseen; chosen */

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

int hawser__told_to_stop(const struct hawser_progress *progress,
                         const struct hawser_progress_state *state)
{
	struct hawser_progress_state told = *state;
	double fresh = told.done > 0 ? (double)told.fresh/(double)told.done : 1.0;

	if (!progress->function)
		return 0;
	if (isnan(told.fraction) && told.expected > 0)
		told.fraction = fmin((double)told.done/(double)told.expected, 1.0);
	if (isnan(told.left) && fresh*told.fraction > 0.0)
		told.left = told.seconds*(1.0 - told.fraction)/(fresh*told.fraction);
	return progress->function(progress->data, &told);
}

void hawser__span_stage(struct hawser__span *span, double from, double to)
{
	span->from = span->at = from;
	span->to = to;
}

void hawser__span_ahead(struct hawser__span *span, double stage, double after)
{
	double done = hawser__wall_seconds() - span->began, all = done + stage + after;

	hawser__span_stage(span, done/all, (done + stage)/all);
}

void hawser__span_foretell(struct hawser__span *span, struct hawser_progress_state *state)
{
	double inside = isnan(state->fraction) ? 0.0 : state->fraction;

	span->at = fmax(span->at, span->from + inside*(span->to - span->from));
	span->reached = fmax(span->reached, span->at);
	state->fraction = span->reached;
	state->left = span->at > WORTH ? (hawser__wall_seconds() - span->began)*(1.0/span->at - 1.0) : NAN;
}

/* Remember a forecast; when there is no room, every second one goes. */
static void remember(struct hawser__forecast *forecast, double at, double end)
{
	int kept = 0;

	if (forecast->count == HAWSER__FORECASTS) {
		for (int i = 0; i < HAWSER__FORECASTS; i += 2)
			forecast->past[kept++] = forecast->past[i];
		forecast->count = kept;
	}
	if (forecast->count > 0 &&
	    at - forecast->past[forecast->count - 1].at < 2.0*RECENT*at/HAWSER__FORECASTS)
		return;
	forecast->past[forecast->count].at = at;
	forecast->past[forecast->count++].end = end;
}

/* The latest end that was foreseen in the last part of the run; NAN if the ends differ by more than
 * SAME, or none was foreseen so long ago. */
static double latest(const struct hawser__forecast *forecast, double at, double end)
{
	double low = end, high = end, since = at;

	for (int i = forecast->count - 1; i >= 0 && since > (1.0 - RECENT)*at; i--) {
		since = forecast->past[i].at;
		low = fmin(low, forecast->past[i].end);
		high = fmax(high, forecast->past[i].end);
	}
	return since <= (1.0 - RECENT)*at && high <= SAME*low ? high : NAN;
}

void hawser__forecast_hear(struct hawser__forecast *forecast,
                           const struct hawser_progress_state *state)
{
	double now = hawser__wall_seconds();

	if (forecast->began == 0.0)
		forecast->began = now - hawser__processor_seconds();
	if (isnan(state->left))
		return;
	if (isinf(state->left)) { /* what was foreseen does not hold */
		forecast->end = 0.0;
		forecast->count = 0;
		return;
	}
	forecast->end = now - forecast->began + state->left;
	remember(forecast, now - forecast->began, forecast->end);
}

void hawser__forecast_tell(struct hawser__forecast *forecast, struct hawser_progress_state *state)
{
	double at = hawser__wall_seconds() - forecast->began, end = forecast->end;
	double last = latest(forecast, at, end);

	state->left = end - at;
	if (state->left >= 0.0 && !isnan(last)) {
		forecast->told = fmax(forecast->told, at/last);
		if (!(forecast->soonest > 0.0 && forecast->soonest < end))
			forecast->soonest = end;
		state->longer = end > LONGER*forecast->soonest;
	} else {
		state->left = NAN;
	}
	state->fraction = forecast->told > 0.0 ? fmin(forecast->told, 0.99) : NAN;
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
	if (isfinite(state->left))
		add(&text, &size, ", about %.0f s left%s", state->left,
		    state->longer ? ", more than foreseen" : "");
}

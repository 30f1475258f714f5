/* core/progress.h - how a computation fills in struct hawser_progress_state.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_PROGRESS_H
#define HAWSER_CORE_PROGRESS_H

#include <hawser/progress.h>

/* Wall time, s, of a clock that nobody sets. */
double hawser__wall_seconds(void);
/* Processor time of the calling thread, s. */
double hawser__processor_seconds(void);

/* A state with these members and `seconds` since `began`; all others say "unknown". */
struct hawser_progress_state hawser__progress_state(const char *stage, const char *unit, long done,
                                                    double began);

/* A computation of several stages: of the whole, the part that is done where the present stage
 * begins and where it ends. What a stage takes is known from others of its kind only. */
struct hawser__span {
	double began;      /* s, hawser__wall_seconds */
	double from, to;
	double reached;
	double at;         /* the same by the present stage, which may be expected earlier or later */
};

void hawser__span_stage(struct hawser__span *span, double from, double to);
/* The stage that begins now takes `stage` s, and what follows it `after` s. */
void hawser__span_ahead(struct hawser__span *span, double stage, double after);
/* state->fraction, that of the stage (NAN: unknown), becomes that of the whole, and `left` the time
 * left. */
void hawser__span_foretell(struct hawser__span *span, struct hawser_progress_state *state);

/* What was foreseen of a run that may have several stages. */
enum { HAWSER__FORECASTS = 64 };
struct hawser__forecast {
	double began;      /* s, hawser__wall_seconds */
	double told;       /* fraction of the run that was told last */
	double end;        /* s since then: the end that was foreseen last; 0: none */
	double soonest;    /* s: earliest end that was told; 0: none */
	struct {
		double at, end; /* s since `began`: when it was foreseen, and which end */
	} past[HAWSER__FORECASTS];
	int count;
};

/* Take the time left of a state, if it has one; INFINITY: forget those of the states before. To be
 * called with each state. */
void hawser__forecast_hear(struct hawser__forecast *forecast,
                           const struct hawser_progress_state *state);
/* state->left and `fraction` become those of the run. `left` follows from the last state that had one,
 * and is NAN unless the end of the run that follows from it has hardly changed for the last part of the
 * run. `fraction` follows from the latest of these ends; it never falls. */
void hawser__forecast_tell(struct hawser__forecast *forecast, struct hawser_progress_state *state);

/* Whether the caller is to be asked. */
static inline int hawser__is_watched(const struct hawser_progress *progress)
{
	return progress->function != NULL;
}

/* The caller's answer: nonzero ends the computation. 0 if nobody is to be asked. What the state does
 * not say follows: the fraction from `done` and `expected`, the time left from what is fresh of it. */
int hawser__told_to_stop(const struct hawser_progress *progress,
                         const struct hawser_progress_state *state);

#endif

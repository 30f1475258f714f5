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
};

void hawser__span_stage(struct hawser__span *span, double from, double to);
/* state->fraction, that of the stage (NAN: unknown), becomes that of the whole, and `left` the time
 * left. */
void hawser__span_foretell(struct hawser__span *span, struct hawser_progress_state *state);

/* Whether the caller is to be asked. */
static inline int hawser__is_watched(const struct hawser_progress *progress)
{
	return progress->function != NULL;
}

/* The caller's answer: nonzero ends the computation. 0 if nobody is to be asked. */
static inline int hawser__told_to_stop(const struct hawser_progress *progress,
                                       const struct hawser_progress_state *state)
{
	return progress->function && progress->function(progress->data, state);
}

#endif

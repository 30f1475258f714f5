/* response/locus/locus_responses.c - the responses at whose bifurcations loci begin: see
 * locus_responses.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "core/report.h"
#include "response/locus/folds_known.h"
#include "response/locus/locus_responses.h"

#define SAME_ORBIT 1e-5 /* relative distance of states that are one; chosen, above their errors */

/* A response that reaches the other end of the range need not be the one that begins there: *other. */
static enum hawser_status look_back(const struct hawser__locus_responses *all, int *other,
                                    const struct hawser_rom *rom,
                                    const struct hawser_frf_options *back)
{
	struct hawser_frf_options choice = *back;
	const struct hawser_frf *first = all->first;
	int m = 2*first->n;
	struct hawser_frf frf;
	enum hawser_status status;

	choice.max_points = 1;
	choice.skip_events = 1;
	status = hawser_frf_trace(&frf, rom, &choice, NULL);
	*other = frf.points > 0 && first->end == HAWSER_END_RANGE &&
	         !hawser__same_state(first->state + (size_t)m*(size_t)(first->points - 1), frf.state, m,
	                             SAME_ORBIT);
	hawser_frf_clear(&frf);
	return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
}

static enum hawser_status trace_one(struct hawser_cover *cover, const struct hawser_rom *rom,
                                    const struct hawser_frf_options *choice,
                                    struct hawser_report *report)
{
	enum hawser_status status;

	cover->branch = malloc(sizeof *cover->branch);
	if (!cover->branch)
		return hawser__no_memory(report, "locus");
	cover->branches = 1;
	status = hawser_frf_trace(cover->branch, rom, choice, report);
	cover->work = hawser_orbit_work(&cover->branch->cost, rom);
	return status == HAWSER_ERR_CONVERGENCE ? HAWSER_OK : status;
}

/* From a motion that was given: its curve in the other direction. */
static enum hawser_status trace_back(struct hawser__locus_responses *all,
                                     const struct hawser_rom *rom,
                                     const struct hawser_frf_options *choice,
                                     struct hawser_report *report)
{
	const struct hawser_frf *first = all->first;
	struct hawser_frf_options back = *choice;

	if (first->points < 2 || first->end == HAWSER_END_CLOSED || first->end == HAWSER_END_INTERRUPTED)
		return HAWSER_OK;
	back.start = first->state;
	back.begin = first->point[0].parameter;
	back.along = NULL;
	back.direction = first->point[1].parameter > first->point[0].parameter ? -1 : 1;
	return trace_one(&all->cover, rom, &back, report);
}

static enum hawser_status trace_others(struct hawser__locus_responses *all,
                                       const struct hawser_rom *rom,
                                       const struct hawser_frf_options *choice,
                                       struct hawser_report *report)
{
	struct hawser_frf_options back = *choice;
	struct hawser_cover *cover = &all->cover;
	int other;
	enum hawser_status status;

	if (choice->start)
		return trace_back(all, rom, choice, report);
	if (hawser_cover_needed(all->first, choice))
		return hawser_cover_trace(cover, all->first, rom, choice, report);
	if (all->first->end != HAWSER_END_RANGE)
		return HAWSER_OK;
	back.from = choice->to;
	back.to = choice->from;
	status = look_back(all, &other, rom, &back);
	if (status || !other)
		return status;
	return trace_one(cover, rom, &back, report);
}

enum hawser_status hawser__locus_responses_trace(struct hawser__locus_responses *all,
                                                 const struct hawser_rom *rom,
                                                 const struct hawser_frf_options *choice,
                                                 struct hawser__span *span, const double stage[2],
                                                 struct hawser_report *report)
{
	enum hawser_status status = hawser_frf_trace(all->first, rom, choice, report);

	if (status == HAWSER_ERR_CONVERGENCE && all->first->points > 0)
		status = HAWSER_OK;
	hawser__span_stage(span, stage[0], stage[1]);
	return status || all->first->end == HAWSER_END_WORK ? status
	       : trace_others(all, rom, choice, report);
}

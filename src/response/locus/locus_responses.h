/* response/locus/locus_responses.h - the responses at whose bifurcations loci begin.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_LOCUS_RESPONSES_H
#define HAWSER_RESPONSE_LOCUS_RESPONSES_H

#include <hawser/cover.h>

#include "core/progress.h"

/* The first response, and those that it does not lead to: one from the other end of the range, and
 * others where parts of the range have none (cover.h); or from a motion that was given its curve to the
 * other side. */
struct hawser__locus_responses {
	struct hawser_frf *first;
	struct hawser_cover cover;
};

/* Trace all of them; `span` goes to this stage after the first. */
enum hawser_status hawser__locus_responses_trace(struct hawser__locus_responses *all,
                                                 const struct hawser_rom *rom,
                                                 const struct hawser_frf_options *choice,
                                                 struct hawser__span *span, const double stage[2],
                                                 struct hawser_report *report);

static inline struct hawser_frf *hawser__locus_response(const struct hawser__locus_responses *all,
                                                        int k)
{
	return k ? &all->cover.branch[k - 1] : all->first;
}

#endif

/* cli/frf_cover.h - further branches of a frequency response, where the first does not cover the range.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FRF_COVER_H
#define HAWSER_CLI_FRF_COVER_H

#include <hawser/cover.h>

#include "cli/cli.h"
#include "cli/progress.h"

/* Locates the peaks of a result's curve, which are [result->peaks] and the caller's to free. */
typedef enum hawser_status cli_peaks_function(struct hawser_landmark **peak,
                                              struct cli_frf_result *result,
                                              struct cli_progress *progress,
                                              const struct hawser_frf_options *options, int cut,
                                              struct hawser_report *report);

/* What the further branches of a result are kept in. Ready if all zero. */
struct cli_cover {
	struct hawser_cover of;
	struct cli_frf_result *other; /* [of.branches] each like the result, with its own curve */
};
/* Trace what the result's branch leaves of the range, if it leaves anything; set `other`, `gap` and
 * their numbers of the result, which refer to *cover. Statuses of hawser_cover_trace. */
enum hawser_status cli_cover_trace(struct cli_cover *cover, struct cli_frf_result *result,
                                   const struct hawser_frf_options *options,
                                   struct cli_progress *progress, cli_peaks_function *peaks,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_cover_clear(struct cli_cover *cover);

/* Points, probes, coordinates, events and peaks of all branches, one after the other. */
struct cli_joined {
	struct hawser_frf frf;
	int *branch; /* [frf.points] number of the branch */
	struct hawser_landmark *peak; /* [peaks] */
	int peaks;
};
/* 1: no memory; release with cli_joined_clear either way. */
int cli_frf_join(struct cli_joined *joined, const struct cli_frf_result *result);
void cli_joined_clear(struct cli_joined *joined);

#endif

/* cli/curves/frf_cover.h - further branches of a frequency response, for the parts of the range
 * that the first one does not cover. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FRF_COVER_H
#define HAWSER_CLI_FRF_COVER_H

#include <hawser/branches.h>
#include <hawser/cover.h>

#include "cli/frame/cli.h"
#include "cli/model/label.h"
#include "cli/frame/progress.h"

/* Locate the peaks of a result's curve, [result->peaks]; the caller frees them. */
typedef enum hawser_status cli_peaks_function(struct hawser_landmark **peak,
                                              struct cli_frf_result *result,
                                              struct cli_progress *progress,
                                              const struct hawser_frf_options *options, int cut,
                                              struct hawser_report *report);

/* What was not followed, and why: a sentence. */
struct cli_missed {
	char text[960];
};

/* Storage of the further branches of a result. All zero before use. */
struct cli_cover {
	struct hawser_cover of;
	struct hawser_frf **born; /* [borns] branches that begin at bifurcations */
	int borns;
	struct cli_missed *missed; /* [misses] */
	int misses;
	struct cli_frf_result *other; /* [of.branches + borns] copies of the result, each with its own
	                               * curve */
};
/* Follow further branches in the parts of the range without one. Sets `other`, `gap` and their
 * numbers of the result, which refer to *cover. Statuses of hawser_cover_trace. */
enum hawser_status cli_cover_trace(struct cli_cover *cover, struct cli_frf_result *result,
                                   const struct hawser_frf_options *options,
                                   struct cli_progress *progress, cli_peaks_function *peaks,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;
/* The same for branches that begin at period doublings and branch points of the branches so far, and,
 * down to `depth`, of these (frf_switch.c); 0: only what `switched` names, or, if the response is rest,
 * as under parametric excitation alone, the first ones. switched: a label of the branches so far, or
 * NULL. Those that are not found are no error: sets `missed` and `misses` of the result too.
 * HAWSER_ERR_ARGUMENT: no branch begins at that label. */
enum hawser_status cli_cover_switch(struct cli_cover *cover, struct cli_frf_result *result,
                                    const struct hawser_frf_options *options, int depth,
                                    const char *switched, struct cli_progress *progress,
                                    cli_peaks_function *peaks,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_cover_clear(struct cli_cover *cover);

/* --switch TEXT (or NULL): whether it is a label of another result, FILE#LABEL; its form, and `other`,
 * an option that says where to start too, or NULL; and the branch that begins at a label of another. */
int cli_switch_elsewhere(const char *text);
enum hawser_status cli_switch_check(const char *text, const char *other,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
enum hawser_status cli_switch_trace(struct hawser_frf *frf, const struct cli_frf_result *result,
                                    const struct cli_label *label,
                                    const struct hawser_frf_options *options, const char *text,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* --period N (0: not given): a multiple of that of the label TEXT (--from-label; or NULL). */
enum hawser_status cli_switch_period(struct cli_label *label, int period, const char *text,
                                     const struct cli_model *model,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

/* Points, probes, coordinates, events and peaks of all branches, in succession. */
struct cli_joined {
	struct hawser_frf frf;
	int *branch; /* [frf.points] number of the branch of each point */
	struct hawser_landmark *peak; /* [peaks] */
	int peaks;
};
/* 1: no memory; release with cli_joined_clear either way. */
int cli_frf_join(struct cli_joined *joined, const struct cli_frf_result *result);
void cli_joined_clear(struct cli_joined *joined);

#endif

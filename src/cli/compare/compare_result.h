/* cli/compare/compare_result.h - a comparison of fidelities: its table, JSON and picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_COMPARE_RESULT_H
#define HAWSER_CLI_COMPARE_RESULT_H

#include "cli/frame/cli.h"

enum { CLI_FIDELITIES = 65 }; /* with the reference and the mesh of a net */

struct cli_compare_result {
	const struct cli_common *common;
	const struct cli_model *model;
	double from, to;    /* scaled */
	double tolerance;   /* of the responses */
	int count, reference; /* the reference's index */
	struct hawser_study_curve curve[CLI_FIDELITIES]; /* in the order of the command line */
	struct hawser_study_error error[CLI_FIDELITIES]; /* partner is NULL if there is none */
	int done[CLI_FIDELITIES]; /* 1: computed, and not interrupted by the user */
	double estimate[CLI_FIDELITIES]; /* processor time, s, estimated by the plan; NAN: not
	                                  * estimated */
	double limit;       /* largest processor time of a curve, s; for the reference, `count` times
	                     * this */
	int landmarks;      /* 1: the table lists folds and peaks, not fidelities */
};

/* 1 if fidelity i has a response. */
int cli_compare_has(const struct cli_compare_result *result, int i);
/* Outcome of a fidelity: "complete"; "returned" (the curve returned to its beginning) or "cut" (by
 * a limit), both without a part of the range; "unreached" (the required accuracy); "failed";
 * "interrupted". */
const char *cli_compare_outcome(const struct cli_compare_result *result, int i);
/* Reason why a curve ended before the end of the range. */
const char *cli_compare_ended(const struct hawser_study_curve *curve);
extern const struct cli_showing cli_compare_showing;

/* --- compare_made.c: fidelities of nets and ropeways: models of several numbers of modes. Of
 * nets the reference is the mesh, in which the folds and peaks of the largest model are
 * corrected --- */

/* What is compared where nothing else is asked for. */
#define CLI_COMPARE_MADE "condensed 4, condensed 6, condensed 9, condensed 12"

/* Refuse fidelities that are none of these scenes, and make the mesh the reference of a net that has
 * none. *most: the largest number of modes. */
enum hawser_status cli_compare_made_choose(struct cli_compare_result *result, int *most, int net,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;
/* Whether i is the mesh. */
int cli_compare_is_mesh(const struct cli_compare_result *result, int i);
/* The curve of fidelity i; of the mesh also that of the largest model, from which it comes. */
enum hawser_status cli_compare_made(struct cli_compare_result *result, int i,
                                    const struct hawser_frf_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
/* The mesh has one peak of each resonance, the largest: those of other components do not count. */
void cli_compare_made_count(struct cli_compare_result *result, int i);

#endif

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

#endif

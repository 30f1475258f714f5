/* cli/compare_result.h - a comparison of fidelities: its table, JSON and picture, kept out of its
 * command.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_COMPARE_RESULT_H
#define HAWSER_CLI_COMPARE_RESULT_H

#include "cli/cli.h"

enum { CLI_FIDELITIES = 64 };

struct cli_compare_result {
	const struct cli_common *common;
	const struct cli_model *model;
	double from, to;    /* scaled */
	double tolerance;   /* of the responses */
	int count, reference; /* the reference's index */
	struct hawser_study_curve curve[CLI_FIDELITIES]; /* in the order asked for */
	struct hawser_study_error error[CLI_FIDELITIES]; /* partner is NULL where there is none */
	int done[CLI_FIDELITIES]; /* was run, and not stopped by the user */
	double estimate[CLI_FIDELITIES]; /* s of the processor, the plan's; NAN where there is none */
	int bound[CLI_FIDELITIES];       /* 1: that is the least time, as the plan says */
	double limit;       /* s of processor time a curve; count times that for the reference */
	int landmarks;      /* the table lists them, not the fidelities */
};

/* Did this one give a response? */
int cli_compare_has(const struct cli_compare_result *result, int i);
/* What became of it: "complete"; "returned" (its curve came back to where it began) or "cut" (by a
 * limit), so that part of the range is missing; "unreached" (an accuracy); "failed", "interrupted". */
const char *cli_compare_outcome(const struct cli_compare_result *result, int i);
/* Why a curve ended before its range did. */
const char *cli_compare_ended(const struct hawser_study_curve *curve);
extern const struct cli_showing cli_compare_showing;

#endif

/* cli/plan/plan_result.h - a plan as text, table and JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_PLAN_RESULT_H
#define HAWSER_CLI_PLAN_RESULT_H

#include "cli/frame/cli.h"

enum { CLI_PLAN_ROWS = 64 };

struct cli_plan_result {
	const struct cli_common *common;
	const struct cli_model *model;
	struct hawser_fidelity_choice choice[CLI_PLAN_ROWS];
	int choices;
	struct hawser_plan plan;
};

/* A setting in use, of the scene or of the response. */
struct cli_setting {
	char name[64], value[96];
	const char *unit, *doc; /* static strings */
	int written;            /* 1: given by the user, 0: default */
};
enum { CLI_SETTINGS = 64 };
/* Fill setting [CLI_SETTINGS]; returns their number. */
int cli_plan_settings(struct cli_setting *setting, const struct cli_plan_result *result);

/* Remove results that differ between runs: times, and estimates that depend on how far a response
 * was computed within a time limit. */
void cli_plan_forget_times(struct hawser_plan *plan);

/* The part about what is modelled, and why. */
void cli_plan_print_decisions(FILE *stream, const struct cli_plan_result *result);
void cli_plan_print(FILE *stream, const struct cli_plan_result *result);
extern const struct cli_showing cli_plan_showing;

#endif

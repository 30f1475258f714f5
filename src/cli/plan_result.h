/* cli/plan_result.h - a plan as text, table and JSON, kept out of its command.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_PLAN_RESULT_H
#define HAWSER_CLI_PLAN_RESULT_H

#include "cli/cli.h"

enum { CLI_PLAN_ROWS = 64 };

struct cli_plan_result {
	const struct cli_common *common;
	const struct cli_model *model;
	struct hawser_fidelity_choice choice[CLI_PLAN_ROWS];
	int choices;
	struct hawser_plan plan;
};

/* A setting in use: of the scene, or of the response. */
struct cli_setting {
	char name[64], value[96];
	const char *unit, *doc; /* static strings */
	int written;            /* by the user, else a default */
};
enum { CLI_SETTINGS = 64 };
/* setting [CLI_SETTINGS]; returns their number. */
int cli_plan_settings(struct cli_setting *setting, const struct cli_plan_result *result);

/* Take out of a plan what another run may have otherwise: times, and what depends on how far a response
 * was run in a certain time. */
void cli_plan_forget_times(struct hawser_plan *plan);

void cli_plan_print(FILE *stream, const struct cli_plan_result *result);
extern const struct cli_showing cli_plan_showing;

#endif

/* cli/plan/plan_result.h - a plan as text, table and JSON.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_PLAN_RESULT_H
#define HAWSER_CLI_PLAN_RESULT_H

#include <hawser/net_plan.h>

#include "cli/frame/cli.h"
#include "cli/frame/view.h"
#include "output/fields/fields.h"

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

/* --- plan_model.c: hawser plan of a reduced model --- */

/* from, to: frequencies as in the command line. */
enum hawser_status cli_plan_model(const struct cli_common *common, const char *from, const char *to,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_plan_model_field[], cli_plan_model_member[];
/* plan_ropeway.c */
extern const struct hawser__field cli_plan_ropeway_row[];

/* --- plan_net.c: hawser plan of a scene of kind `net` --- */

/* Texts of options; NULL if not given. */
struct cli_plan_net {
	const char *until, *step, *scheme;
	double rtol, limit; /* 0: the library's */
	int modes;          /* 0: the library's */
};
/* A row of the table of cables, with its name. */
struct cli_plan_net_cable {
	const char *name;
	struct hawser_net_plan_cable at;
};

enum { CLI_PLAN_NET_SETTINGS = 16 };
struct cli_plan_net_result {
	const struct cli_common *common;
	const struct cli_plan_net *given;
	struct hawser_net net;
	struct hawser_net_plan plan;
	struct hawser_net_plan_options options;
	struct cli_setting setting[CLI_PLAN_NET_SETTINGS];
	int settings;
	struct cli_plan_net_cable *cable; /* [cables] */
	int cables;
};

enum hawser_status cli_plan_net(const struct cli_common *common, const struct cli_plan_net *settings,
                                struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_plan_net_print(FILE *stream, const struct cli_plan_net_result *result);
/* Fields of the table and of JSON, for the list of columns. */
extern const struct hawser__field cli_plan_net_row[], cli_plan_net_fields[];

#endif

/* cli/plan/plan_net.h - hawser plan of a scene of kind `net`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_PLAN_NET_H
#define HAWSER_CLI_PLAN_NET_H

#include <hawser/net_plan.h>

#include "cli/plan/plan_result.h"
#include "output/fields/fields.h"

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

/* cli/motion/transient_ropeway.h - what hawser transient shows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_TRANSIENT_ROPEWAY_H
#define HAWSER_CLI_TRANSIENT_ROPEWAY_H

#include <hawser/transient.h>

#include "cli/frame/view.h"

enum { CLI_TRANSIENT_NAME = 2*HAWSER_ROPEWAY_NAME + 8 };

/* A span or a tower of one lane. */
struct cli_transient_place {
	const char *lane, *name;
	char text[CLI_TRANSIENT_NAME]; /* "p0 to p1" */
	struct hawser_transient_place of;
};

struct cli_transient {
	const struct cli_common *common;
	struct hawser_ropeway ropeway;
	struct hawser_transient run;
	struct hawser_passing passing;   /* with --pass, and no run */
	struct cli_transient_place *span, *tower; /* [spans], [towers] */
	int spans, towers, passes, table; /* passes 1: --pass; table: CLI_TRANSIENT_SPANS, .. or 0 */
	const char *event, *lane;
};
enum { CLI_TRANSIENT_SPANS = 1, CLI_TRANSIENT_TOWERS = 2, CLI_TRANSIENT_PASSES = 4,
       CLI_TRANSIENT_RUNS = 8 }; /* bits of the view */

/* transient_fields.c */
extern const struct hawser__field cli_transient_field[];
extern const struct hawser__list cli_transient_row_list, cli_transient_span_list,
                                 cli_transient_tower_list, cli_passing_list;

#endif

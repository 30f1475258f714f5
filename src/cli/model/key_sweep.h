/* cli/model/key_sweep.h - the values of --over: KEY=FROM:TO, KEY=FROM:TO:POINTS, both with :log behind
 * for equal ratios, and KEY=[A, B, ...].
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_KEY_SWEEP_H
#define HAWSER_CLI_KEY_SWEEP_H

#include "cli/frame/cli.h"

enum { CLI_KEY_SWEEP_POINTS = 21, /* of a range that says none */
       CLI_KEY_SWEEP_MOST = 2000 }; /* values of a sweep */

struct cli_key_sweep {
	const char *command, *over; /* the option's value */
	const char *example;        /* of a whole value, for messages */
	int logarithmic;            /* 1: values at equal ratios */
	int most;                   /* values; 0: CLI_KEY_SWEEP_MOST */
	/* set by cli_key_sweep_read */
	char key[96], si[32];       /* the unit is that of the option, or "" */
	int points;
	double *value;              /* [points]; the caller frees it */
};
/* Read the option. */
enum hawser_status cli_key_sweep_read(struct cli_key_sweep *sweep,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* value [points] from `from` to `to`; sets sweep->value. */
enum hawser_status cli_key_sweep_place(struct cli_key_sweep *sweep, double from, double to,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;

/* The options of the command line, with the key at a value, in `common`, whose text is `set`. */
enum { CLI_KEY_SWEEP_SET = 192 };
void cli_key_sweep_at(struct cli_common *common, char set[CLI_KEY_SWEEP_SET],
                      const struct cli_key_sweep *sweep, const struct cli_common *own, double value);
/* A message about the override `set` becomes one about --over. Returns `status`. */
enum hawser_status cli_key_sweep_blame(struct hawser_report *report, enum hawser_status status,
                                       const struct cli_key_sweep *sweep, const char *set);

#endif

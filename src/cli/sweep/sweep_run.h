/* cli/sweep/sweep_run.h - the variations of a sweep while they are computed. See sweep_run.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_SWEEP_RUN_H
#define HAWSER_CLI_SWEEP_RUN_H

#include "cli/frame/progress.h"
#include "cli/sweep/sweep.h"

enum { CLI_SWEEP_PROCESSES = 1024 }; /* two pipes each, of the files that a process may open */

struct cli_sweep_run {
	struct cli_study *sweep;
	struct cli_sweep_file file;
	long count;       /* variations, of the part if it is one */
	long done, fresh; /* fresh: not from the checkpoint */
	long next;        /* the first that is neither done nor handed out */
	long first;       /* all before this are done, and have no result */
	int checked;      /* 1: the first result has been looked at */
	double began;
	struct cli_watch watch;
};

/* Keep a result, whose text is then owned by the sweep. */
enum hawser_status cli_sweep_finish(struct cli_sweep_run *run, long variation,
                                    struct cli_sweep_packed packed, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* The next variation to compute; the number of all: none is left. */
long cli_sweep_next(struct cli_sweep_run *run);
/* Show the progress. Returns nonzero if the user has interrupted. */
int cli_sweep_watch(struct cli_sweep_run *run);
/* The message after an interrupt. */
enum hawser_status cli_sweep_interrupted(const struct cli_sweep_run *run,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;

/* sweep_processes.c: all variations by so many processes. */
enum hawser_status cli_sweep_together(struct cli_sweep_run *run, int count,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* sweep_ranks.c: among the ranks of the sweep. */
enum hawser_status cli_sweep_among(struct cli_sweep_run *run,
                                   struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* cli/sweep/cmd_merge.c - hawser merge: join the checkpoints of the parts of a map or of a sweep.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/frame/cli.h"
#include "cli/sweep/sweep.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *checkpoint;
};
static const struct settings defaults = {.checkpoint = NULL};

static const struct cli_option options[] = {
	{"checkpoint", 0, "FILE", "the new file, which hawser map or sweep --checkpoint FILE continues",
	 CLI_TEXT(checkpoint)},
	{"quiet", 'q', "", "print nothing but errors",
	 CLI_STORED_IN(struct cli_common, cli_store_flag, quiet)},
	CLI_HELP_OPTION,
	CLI_NO_OPTION,
};
static const char *const notes[] = {
	"Each CHECKPOINT is of a part that hawser map or sweep --part K/N computed, or of an interrupted",
	"one. The same command with --checkpoint FILE in place of --part then computes what is left, and",
	"writes the result: the same bytes as without parts.",
	NULL,
};

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	const char *from[CLI_MORE_INPUTS + 1] = {settings->common.input};
	int count = settings->common.mores + 1, sweep;
	long points;
	enum hawser_status status;

	if (!settings->checkpoint)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "merge",
		                    "--checkpoint is missing: write --checkpoint FILE, the new file");
	for (int k = 1; k < count; k++)
		from[k] = settings->common.more[k - 1];
	sweep = cli_sweep_file_is(from[0]);
	status = sweep ? cli_sweep_merge(&points, settings->checkpoint, from, count, report)
	               : hawser_map_merge(&points, settings->checkpoint, from, count, report);
	if (!status && !settings->common.quiet)
		printf("%ld %s of %d checkpoint%s are in %s\n", points, sweep ? "results" : "points", count,
		       count > 1 ? "s" : "", settings->checkpoint);
	return status;
}

const struct cli_command cli_merge = {
	"merge", "CHECKPOINT...", "Join the checkpoints of the parts of a map or sweep", notes, options,
	&defaults, sizeof(struct settings), 1, run, NULL,
	.takes = 0,
};

/* cli/sweep/sweep_check.c - keys and values of a sweep against its scene, and the place of its options,
 * before anything is computed. See sweep.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cli/frame/kinds.h"
#include "cli/sweep/sweep.h"
#include "core/report.h"

enum { TRIES = 16 }; /* variations that are read */

static int has_option(const struct cli_command *command, const char *name, size_t length)
{
	const struct cli_option *row;

	for (int i = 0; (row = cli_option_row(command, i)); i++)
		if (strlen(row->name) == length && strncmp(row->name, name, length) == 0)
			return 1;
	return 0;
}

enum hawser_status cli_sweep_place(const struct cli_study *sweep, int words,
                                   struct hawser_report *report)
{
	for (int i = words; i < sweep->words; i++) {
		const char *name = sweep->word[i] + 2;
		size_t length = strncmp(sweep->word[i], "--", 2) == 0 ? strcspn(name, "=") : 0;

		if (length > 0 && !has_option(sweep->choice.command, name, length) &&
		    has_option(&cli_sweep, name, length))
			return hawser__fail(report, HAWSER_ERR_ARGUMENT, "sweep",
			                    "--%.*s is an option of the sweep: write it before the --",
			                    (int)length, name);
	}
	return HAWSER_OK;
}

enum hawser_status cli_sweep_reads(const struct cli_common *own, char (*set)[CLI_SWEEP_SET], int sets,
                                   struct hawser_report *report)
{
	const struct cli_kind_record *kind = cli_kind_record(cli_kind_number(cli_kind(own), CLI_EVERY));
	struct cli_common common = *own;
	struct hawser_scene scene;
	char text[CLI_SCENE_FACTS];
	int forced;
	enum hawser_status status;

	for (int k = 0; k < sets && common.sets < CLI_SETS; k++)
		common.set[common.sets++] = set[k];
	if (kind && kind->look)
		return kind->look(text, &forced, &common, report);
	status = cli_read_scene(&scene, &common, report);
	if (!status)
		hawser_scene_clear(&scene);
	return status;
}

/* The message, without "--set KEY=VALUE: " of its first variation, which is named instead. */
static enum hawser_status refuse(const struct cli_study *sweep, char (*set)[CLI_SWEEP_SET],
                                 enum hawser_status status, struct hawser_report *report)
{
	const struct hawser_report failed = *report;
	const char *message = failed.message;
	char name[300];

	cli_sweep_name(name, sizeof name, &sweep->plan, 0);
	for (int k = 0; k < sweep->plan.keys && strncmp(message, "--set ", 6) == 0; k++) {
		size_t length = strlen(set[k]);

		if (strncmp(message + 6, set[k], length) == 0 && strncmp(message + 6 + length, ": ", 2) == 0)
			message += 6 + length + 2;
	}
	return hawser__fail(report, status, "sweep", "nothing is computed: no variation can be read; the "
	                    "first, %s: %s", name, message);
}

/* A variation that can be read shows that keys and units are right. Where none of some that are spread
 * over all can be, the message is that of the first. */
enum hawser_status cli_sweep_check(const struct cli_study *sweep, const struct cli_common *common,
                                   struct hawser_report *report)
{
	const struct cli_sweep_plan *plan = &sweep->plan;
	long tries = plan->count < TRIES ? plan->count : TRIES;
	char set[CLI_SWEEP_KEYS][CLI_SWEEP_SET];
	enum hawser_status status = HAWSER_OK;

	if (cli_kind(common) == HAWSER_KIND_MODEL)
		return HAWSER_OK;
	for (long i = tries - 1; i >= 0; i--) {
		long variation = tries > 1 ? i*(plan->count - 1)/(tries - 1) : 0;

		for (int k = 0; k < plan->keys; k++)
			cli_sweep_set(set[k], plan, k, variation);
		status = cli_sweep_reads(common, set, plan->keys, report);
		if (!status || status == HAWSER_ERR_MEMORY)
			return status;
	}
	return refuse(sweep, set, status, report);
}

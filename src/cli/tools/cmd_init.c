/* cli/tools/cmd_init.c - hawser init: a scene with comments, to begin with.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "cli/frame/input.h"
#include "cli/frame/kinds.h"
#include "core/file.h"

static const struct cli_option options[] = {
	CLI_HELP_OPTION,
	CLI_NO_OPTION,
};
static const char *const notes[] = {
	"A scene of the kind of the argument, or of a span of cable. It is complete, and goes to standard",
	"output: hawser init net >net.yaml. Its first line says what to try.",
	NULL,
};

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct cli_common *common = context;
	int index = 0;
	enum hawser_status status = cli_choose_input(&index, &cli_init, common->input, report);

	return status ? status : hawser__file_put("-", cli_kind_record(index)->text,
	                                          strlen(cli_kind_record(index)->text), report);
}

#define FIRST(name, BIT) #name
#define NEXT(name, BIT) "|" #name
const struct cli_command cli_init = {
	"init", "[" CLI_KINDS_WRITTEN(FIRST, NEXT) "]",
	"A scene with comments, to begin with", notes, options, NULL, sizeof(struct cli_common), 0, run,
	NULL,
	.takes = 0,
};

/* cli/tools/cmd_init.c - hawser init: a scene with comments, to begin with.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cli/frame/kinds.h"
#include "cli/tools/init_from.h"
#include "cli/tools/init_scenes.h"
#include "core/file.h"
#include "core/report.h"

struct settings {
	struct cli_common common;
	const char *from;
};

static const struct cli_option options[] = {
	CLI_HELP_OPTION,
	CLI_TEXT_OPTION(from, "FILE", "the mooring of a file of MoorDyn (version 2) or MoorPy, as a net"),
	CLI_NO_OPTION,
};
static const char *const notes[] = {
	"A scene of the kind or structure of the argument, or of a span of cable. It is complete, and goes",
	"to standard output: hawser init net >net.yaml. Its first line says what to try.",
	"With --from, what scenes cannot say of the file is named on standard error.",
	NULL,
};

/* After the kinds that are written. */
#define TEXT(name) cli_init_##name,
static const char *const structure[] = {CLI_INIT_STRUCTURES(TEXT)};

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct settings *settings = context;
	const char *text;
	int index = 0;
	enum hawser_status status = cli_choose_input(&index, &cli_init, settings->common.input, report);

	if (!status && settings->from)
		return settings->common.input
			? hawser__fail(report, HAWSER_ERR_ARGUMENT, "init", "--from FILE has its own kind of "
			               "scene: leave '%s' out", settings->common.input)
			: cli_init_from(settings->from, report);
	if (status)
		return status;
	text = index < CLI_NUMBER_MODEL ? cli_kind_record(index)->text
	                                : structure[index - CLI_NUMBER_MODEL];
	return hawser__file_put("-", text, strlen(text), report);
}

#define FIRST(name, BIT) #name
#define NEXT(name, BIT) "|" #name
#define OR(name) "|" #name
const struct cli_command cli_init = {
	"init", "[" CLI_KINDS_WRITTEN(FIRST, NEXT) CLI_INIT_STRUCTURES(OR) "]",
	"A scene with comments, to begin with", notes, options, NULL, sizeof(struct settings), 0, run,
	NULL,
	.takes = 0,
};

/* cli/tools/cmd_schema.c - hawser schema: the JSON Schema of scenes, for editors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/frame/kinds.h"

static const struct cli_option options[] = {
	CLI_HELP_OPTION,
	CLI_NO_OPTION,
};
static const char *const notes[] = {
	"Of scenes of one kind, or of any. Language servers for YAML complete and check scenes with it.",
	NULL,
};

static enum hawser_status run(void *context, struct hawser_report *report)
{
	const struct cli_common *common = context;
	int index = 0;
	enum hawser_status status = cli_choose_input(&index, &cli_schema, common->input, report);

	return status ? status : hawser_schema_write(stdout, common->input, report);
}

#define WORD(name, NAME) "|" #name
const struct cli_command cli_schema = {
	"schema", "[cable|beam" HAWSER_SCENE_KINDS(WORD) "]", "JSON Schema of scenes, for editors",
	notes, options, NULL, sizeof(struct cli_common), 0, run, NULL,
	.takes = 0,
};

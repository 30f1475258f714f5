/* cli/frame/kinds.c - see kinds.h. SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cli/frame/kinds.h"
#include "core/append.h"
#include "core/report.h"

enum { COMMANDS = 400 }; /* characters of a list of commands */

#define RECORD(name, BIT) &cli_kind_##name,
static const struct cli_kind_record *const records[CLI_KINDS_ALL] = {CLI_KINDS(RECORD)};

const struct cli_kind_record *cli_kind_record(int index)
{
	return index >= 0 && index < CLI_KINDS_ALL ? records[index] : NULL;
}

int cli_kind_number(enum hawser_kind kind, unsigned bits)
{
	int found = CLI_KINDS_ALL; /* whose bit is none of a kind */

	for (int i = CLI_KINDS_ALL - 1; i >= 0; i--)
		if (records[i]->kind == kind && (bits & 1u << i || !(bits & 1u << found)))
			found = i;
	return found;
}

const struct cli_part *cli_part_of(const struct cli_command *command, int index)
{
	return (const struct cli_part *)(const void *)((const char *)records[index] + command->part);
}

const struct cli_part *cli_part(const struct cli_command *command, const struct cli_common *common)
{
	return cli_part_of(command, cli_kind_number(cli_kind(common), CLI_EVERY));
}

static int takes(const struct cli_command *command, int index)
{
	return command->takes & 1u << index || (command->takes & CLI_MODELS && records[index]->models) ||
	       (command->part && cli_part_of(command, index)->run);
}

/* "nets", "nets and ropeways", "spans, nets and rods" */
static void list_kinds(char *text, size_t size, unsigned kinds)
{
	size_t length = 0;

	for (int i = 0, later; i < CLI_KINDS_ALL && length < size; i++) {
		if (!(kinds & 1u << i))
			continue;
		for (int k = 0; k < CLI_KINDS_ALL; k++) /* those of spans have one word */
			if (records[k]->kind == records[i]->kind)
				kinds &= ~(1u << k);
		for (later = 0; later < CLI_KINDS_ALL && !(kinds & 1u << later); later++)
			;
		length += (size_t)snprintf(text + length, size - length, "%s%s", length == 0 ? ""
		                           : later < CLI_KINDS_ALL ? ", " : " and ", records[i]->many);
	}
}

static enum hawser_status check_options(const char *command, const struct cli_common *common,
                                        struct hawser_report *report)
{
	const struct hawser_document *document = NULL;
	enum hawser_kind kind;
	char many[128];
	int number;

	for (int i = 0; i < common->givens; i++) {
		const struct cli_option *option = common->given[i];

		if (!option->kinds)
			continue;
		kind = cli_kind(common);
		/* what cannot be read is refused where it is read */
		if (!common->library && (cli_document(&document, common, NULL) ||
		                         (kind == HAWSER_KIND_SPAN && !document->tree)))
			return HAWSER_OK;
		number = cli_kind_number(kind, option->kinds);
		if (option->kinds & 1u << number)
			continue;
		list_kinds(many, sizeof many, option->kinds);
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command, "--%s is for %s, and %s is %s",
		                    option->name, many, cli_input_name(common), records[number]->called);
	}
	return HAWSER_OK;
}

/* Names of commands that take the kind. forced: all (-1), or those (1) or all but those (0) that need
 * a force. Commands that take any kind are not named. */
static void list_commands(char *text, size_t size, int index, int forced)
{
	const struct cli_command *command;

	*text = '\0';
	for (int i = 0; (command = cli_command_row(i)); i++) {
		int needs = (command->takes & CLI_FORCED) != 0;

		if ((command->takes & CLI_EVERY) != CLI_EVERY && takes(command, index) &&
		    (forced < 0 || forced == needs))
			hawser__append(text, size, ", ", "%s", command->name);
	}
}

/* Whether the command takes no spans, and the input is one without a fault. */
static int is_other_span(const struct cli_command *command, const struct cli_common *common)
{
	struct hawser_scene scene;
	enum hawser_status status;

	if (command->takes & (CLI_SPAN | CLI_MODELS))
		return 0;
	status = cli_read_scene(&scene, common, NULL);
	hawser_scene_clear(&scene);
	return !status;
}

static enum hawser_status check_input(const struct cli_command *command,
                                      const struct cli_common *common, struct hawser_report *report)
{
	enum hawser_kind kind = cli_kind(common);
	char others[COMMANDS];
	int number = cli_kind_number(kind, CLI_EVERY);
	const char *unmade = command->takes & CLI_MODELS ? records[number]->unmade : NULL;

	if (takes(command, number) || (kind == HAWSER_KIND_SPAN && !is_other_span(command, common)))
		return HAWSER_OK;
	list_commands(others, sizeof others, number, -1);
	return hawser__fail(report, HAWSER_ERR_ARGUMENT, "main",
	                    "%s is %s, which hawser %s does not take; these commands do: %s%s%s",
	                    cli_input_name(common), records[number]->one, command->name, others,
	                    unmade ? ". " : "", unmade ? unmade : "");
}

enum hawser_status cli_kind_check(const struct cli_command *command, const struct cli_common *common,
                                  struct hawser_report *report)
{
	enum hawser_status status = strncmp(command->input, "SCENE", 5) == 0
	                            ? check_input(command, common, report) : HAWSER_OK;

	return status ? status : check_options(command->name, common, report);
}

int cli_is_forced(const struct hawser_scene *scene)
{
	int moves = 0;

	for (int end = 0; end < 2; end++)
		for (int axis = 0; axis < 3; axis++)
			moves = moves || scene->support[end].motion[axis] != 0.0;
	return scene->load.present || scene->loads > 0 || moves || scene->travel.fluctuation > 0.0;
}

void cli_kind_print(FILE *to, int index, int forced)
{
	char names[COMMANDS];

	list_commands(names, sizeof names, index, forced ? -1 : 0);
	fprintf(to, "commands that take it: %s\n", names);
	if (forced)
		return;
	list_commands(names, sizeof names, index, 1);
	fprintf(to, "those for which it lacks %s: %s\n", index == CLI_NUMBER_MODEL
	        ? "a harmonic force" : index == CLI_NUMBER_NET ? "a load or motion with harmonic"
	        : "a load, a moving end or a travel.fluctuation", names);
}


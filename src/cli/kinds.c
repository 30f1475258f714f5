/* cli/kinds.c - see kinds.h. A new kind of scene is a row of the table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "cli/kinds.h"
#include "core/report.h"

/* By hawser_kind. */
static const struct {
	const char *one, *many;
} table[HAWSER_KINDS] = {
	[HAWSER_KIND_SPAN] = {"a span", "spans"},
	[HAWSER_KIND_NET] = {"a net", "nets"},
	[HAWSER_KIND_OBSTACLES] = {"a span over obstacles", "spans over obstacles"},
	[HAWSER_KIND_ROPEWAY] = {"a ropeway", "ropeways"},
	[HAWSER_KIND_ROD] = {"a rod", "rods"},
	[HAWSER_KIND_TOW] = {"a towed body", "towed bodies"},
	[HAWSER_KIND_MODEL] = {"a reduced model", "reduced models"},
};
static const enum hawser_kind said_in_turn[] = {HAWSER_KIND_ROPEWAY, HAWSER_KIND_NET,
                                                HAWSER_KIND_OBSTACLES, HAWSER_KIND_SPAN};

enum cli_kind cli_kind_of(const struct cli_common *common, unsigned kinds)
{
	unsigned bit = 1u << cli_kind(common);

	return kinds & bit ? (enum cli_kind)bit : CLI_SPAN;
}

/* "nets", "ropeways and nets" */
static void list_kinds(char *text, size_t size, unsigned kinds)
{
	text[0] = '\0';
	for (size_t i = 0; i < sizeof said_in_turn/sizeof *said_in_turn; i++)
		if (kinds & 1u << said_in_turn[i]) {
			size_t length = strlen(text);

			snprintf(text + length, size - length, "%s%s", length ? " and " : "",
			         table[said_in_turn[i]].many);
		}
}

enum hawser_status cli_kind_check(const struct cli_given *list, const char *command,
                                  const struct cli_common *common, struct hawser_report *report)
{
	const struct hawser_document *document;
	char many[64];

	if (cli_document(&document, common, NULL))
		return HAWSER_OK; /* it is refused where it is read */
	for (; list->name; list++) {
		if (!list->given || list->kinds & 1u << document->kind)
			continue;
		list_kinds(many, sizeof many, list->kinds);
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
		                    "--%s is for %s, and %s is the scene of %s", list->name, many,
		                    document->name, table[document->kind].one);
	}
	return HAWSER_OK;
}

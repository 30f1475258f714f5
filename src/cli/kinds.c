/* cli/kinds.c - see kinds.h. A new kind of scene is a row of the table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>
#include <unistd.h>

#include "cli/kinds.h"
#include "core/report.h"

static const struct {
	enum cli_kind kind;
	const char *one, *many;
	int (*is)(const char *path);
} table[] = {
	{CLI_ROPEWAY, "a ropeway", "ropeways", hawser_ropeway_is},
	{CLI_NET, "a net", "nets", hawser_net_is},
	{CLI_OBSTACLES, "a span over obstacles", "spans over obstacles", hawser_obstacles_is},
	{CLI_SPAN, "a span", "spans", NULL}, /* what is of no other kind */
};
enum { KINDS = sizeof table/sizeof *table };

enum cli_kind cli_kind_of(const char *path, unsigned kinds)
{
	for (int i = 0; i < KINDS - 1; i++)
		if ((kinds & (unsigned)table[i].kind) && table[i].is(path))
			return table[i].kind;
	return CLI_SPAN;
}

/* "nets", "ropeways and nets" */
static void list_kinds(char *text, size_t size, unsigned kinds)
{
	text[0] = '\0';
	for (int i = 0; i < KINDS; i++)
		if (kinds & (unsigned)table[i].kind) {
			size_t length = strlen(text);

			snprintf(text + length, size - length, "%s%s", length ? " and " : "", table[i].many);
		}
}

enum hawser_status cli_kind_check(enum cli_kind kind, const struct cli_given *list, const char *command,
                                  const char *path, struct hawser_report *report)
{
	char many[64];
	int own = 0, unknown = kind == CLI_SPAN && strcmp(path, "-") != 0 && access(path, R_OK) != 0;

	while (table[own].kind != kind)
		own++;
	for (; list->name && !unknown; list++) { /* what cannot be read is refused where it is read */
		if (!list->given || (list->kinds & (unsigned)kind))
			continue;
		list_kinds(many, sizeof many, list->kinds);
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
		                    "--%s is for %s, and %s is the scene of %s", list->name, many, path,
		                    table[own].one);
	}
	return HAWSER_OK;
}

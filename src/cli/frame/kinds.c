/* cli/frame/kinds.c - see kinds.h. A new kind of scene is a row of the table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <string.h>

#include "cli/frame/kinds.h"
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
/* "nets", "nets and ropeways", "spans, nets and rods" */
static void list_kinds(char *text, size_t size, unsigned kinds)
{
	size_t length = 0;

	for (int i = 0, later; i < HAWSER_KINDS && length < size; i++) {
		if (!(kinds & 1u << i))
			continue;
		kinds &= ~(1u << i);
		for (later = 0; later < HAWSER_KINDS && !(kinds & 1u << later); later++)
			;
		length += (size_t)snprintf(text + length, size - length, "%s%s", length == 0 ? ""
		                           : later < HAWSER_KINDS ? ", " : " and ", table[i].many);
	}
}

enum hawser_status cli_kind_check(const char *command, const struct cli_common *common,
                                  struct hawser_report *report)
{
	const struct hawser_document *document = NULL;
	enum hawser_kind kind;
	char many[128];

	for (int i = 0; i < common->givens; i++) {
		const struct cli_option *option = common->given[i];

		if (!option->kinds)
			continue;
		kind = cli_kind(common);
		/* what cannot be read is refused where it is read */
		if (!common->library && (cli_document(&document, common, NULL) ||
		                         (kind == HAWSER_KIND_SPAN && !document->tree)))
			return HAWSER_OK;
		if (option->kinds & 1u << kind)
			continue;
		list_kinds(many, sizeof many, option->kinds);
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command, "--%s is for %s, and %s is %s",
		                    option->name, many, cli_input_name(common), table[kind].one);
	}
	return HAWSER_OK;
}

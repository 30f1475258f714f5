/* cli/frame/document.c - the input of a command, which is read once, and scenes of each kind from it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cli/frame/cli.h"
#include "cli/frame/within.h"

/* Of the command in which others run. */
static struct {
	const char *input;
	const struct hawser_document *document;
} outer;

void cli_document_within(const char *input, const struct hawser_document *document)
{
	outer.input = input;
	outer.document = document;
}

enum hawser_status cli_document(const struct hawser_document **document,
                                const struct cli_common *common, struct hawser_report *report)
{
	int is_outer = outer.input && common->input && strcmp(outer.input, common->input) == 0;

	*document = is_outer ? outer.document : common->document;
	return is_outer || common->document->name ? HAWSER_OK
	       : hawser_document_open(common->document, common->input, report);
}

enum hawser_kind cli_kind(const struct cli_common *common)
{
	const struct hawser_document *document;

	if (common->library)
		return HAWSER_KIND_MODEL;
	return common->input && !cli_document(&document, common, NULL) ? document->kind
	                                                                : HAWSER_KIND_SPAN;
}

#define OPEN(name, NAME) \
	enum hawser_status cli_read_##name(struct hawser_##name *name, \
	                                   const struct cli_common *common, \
	                                   struct hawser_report *report) \
	{ \
		const struct hawser_document *document; \
		enum hawser_status status = cli_document(&document, common, report); \
	\
		memset(name, 0, sizeof *name); \
		return status ? status : hawser_##name##_of(name, document, common->set, \
		                                            (size_t)common->sets, report); \
	}
CLI_KINDS_OF_SCENES(OPEN)

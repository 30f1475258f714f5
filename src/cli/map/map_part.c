/* cli/map/map_part.c - parts of maps, and maps that are shared among ranks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <string.h>

#include "cli/map/map_part.h"
#include "core/report.h"

void cli_map_part_done(const struct hawser_map_options *options, const struct hawser_map *map,
                       int quiet)
{
	if (!quiet)
		printf("part %d of %d: %ld points%s in %s\n", options->part, options->parts, map->visited,
		       map->interrupted ? ", interrupted," : "", options->checkpoint);
}

enum hawser_status cli_map_ranks(struct hawser_map_options *to, struct cli_common *common,
                                 struct hawser__ranks *ranks, struct hawser_report *report)
{
	if (!ranks)
		return HAWSER_OK;
	if (strcmp(common->input, "-") == 0)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "several ranks cannot read the scene from standard input: name a file "
		                    "that all of them can read");
	to->ranks = ranks;
	to->threads = cli_ranks_threads(ranks, to->threads);
	if (ranks->rank == 0)
		return HAWSER_OK;
	to->checkpoint = NULL;
	common->json = common->tsv = common->plot = common->gp = NULL;
	common->quiet = 1;
	return HAWSER_OK;
}

void cli_map_lost(struct hawser_report *report, const struct hawser__ranks *ranks,
                  const char *checkpoint)
{
	size_t used = strlen(report->message);

	if (!ranks || ranks->rank > 0 || !ranks->lost)
		return;
	if (checkpoint)
		snprintf(report->message + used, sizeof report->message - used,
		         "; the points so far are in the checkpoint %s: start the map again, with any "
		         "number of ranks", checkpoint);
	else
		snprintf(report->message + used, sizeof report->message - used,
		         "; with --checkpoint FILE the points so far would not be lost");
}

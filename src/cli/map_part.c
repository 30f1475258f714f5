/* cli/map_part.c - parts of maps, and maps that are shared among ranks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/map_part.h"
#include "core/report.h"

enum { MOST_PARTS = 10000 }; /* chosen: more than the tiles of any map that is worth it */

enum hawser_status cli_map_part(struct hawser_map_options *to, const char *part,
                                const struct cli_common *common, const char *other,
                                struct hawser_report *report)
{
	const char *writes = common->json ? "json" : common->tsv ? "tsv" : common->plot ? "plot"
	                     : common->gp ? "gp" : other;
	char *end;
	long number, parts;

	if (!part)
		return HAWSER_OK;
	number = strtol(part, &end, 10);
	parts = *end == '/' ? strtol(end + 1, &end, 10) : 0;
	if (*end || number < 1 || parts < number || parts > MOST_PARTS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "--part %s: write K/N, such as 2/8: part 2 of 8; N is at most %d", part,
		                    MOST_PARTS);
	if (!to->checkpoint)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "--part %s: the points of a part are kept in a checkpoint: write "
		                    "--checkpoint FILE, a file of its own for each part", part);
	if (writes)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, "map",
		                    "--%s: a part has no result: join the checkpoints of all parts with "
		                    "hawser merge, and give this option to the map that continues from "
		                    "that", writes);
	to->part = (int)number;
	to->parts = (int)parts;
	return HAWSER_OK;
}

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

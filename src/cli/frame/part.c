/* cli/frame/part.c - see part.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>

#include "cli/frame/part.h"
#include "core/report.h"

enum { MOST_PARTS = 10000 }; /* chosen: more than the tiles of any map that is worth it */

enum hawser_status cli_part_read(int *number, int *parts, const char *text, const char *command,
                                 const char *checkpoint, const struct cli_common *common,
                                 const char *other, struct hawser_report *report)
{
	const char *writes = common->json ? "json" : common->tsv ? "tsv" : common->plot ? "plot"
	                     : common->gp ? "gp" : other;
	char *end;
	long k, n;

	if (!text)
		return HAWSER_OK;
	k = strtol(text, &end, 10);
	n = *end == '/' ? strtol(end + 1, &end, 10) : 0;
	if (*end || k < 1 || n < k || n > MOST_PARTS)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
		                    "--part %s: write K/N, such as 2/8: part 2 of 8; N is at most %d", text,
		                    MOST_PARTS);
	if (!checkpoint)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
		                    "--part %s: the results of a part are kept in a checkpoint: write "
		                    "--checkpoint FILE, a file of its own for each part", text);
	if (writes)
		return hawser__fail(report, HAWSER_ERR_ARGUMENT, command,
		                    "--%s: a part has no result: join the checkpoints of all parts with "
		                    "hawser merge, and give this option to the %s that continues from that",
		                    writes, command);
	*number = (int)k;
	*parts = (int)n;
	return HAWSER_OK;
}

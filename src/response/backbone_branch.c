/* response/backbone_branch.c - see backbone.h; the end of a backbone's memory.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include <stdlib.h>
#include <string.h>

#include "core/report.h"
#include "response/backbone.h"

enum hawser_status hawser__backbone_add(struct hawser_backbone *to, const double *start,
                                        const double *direction, double energy,
                                        struct hawser_report *report)
{
	size_t size = (size_t)to->n + 1, count = (size_t)to->branches + 1;
	struct hawser_backbone_branch *branch = realloc(to->branch, count*sizeof *branch);
	double *starts, *directions;

	to->branch = branch ? branch : to->branch;
	starts = realloc(to->branch_start, count*size*sizeof *starts);
	to->branch_start = starts ? starts : to->branch_start;
	directions = realloc(to->branch_direction, count*size*sizeof *directions);
	to->branch_direction = directions ? directions : to->branch_direction;
	if (!branch || !starts || !directions)
		return hawser__no_memory(report, "backbone");
	branch[count - 1] = (struct hawser_backbone_branch){start[to->n], energy, to->points - 1};
	memcpy(starts + (count - 1)*size, start, size*sizeof *starts);
	memcpy(directions + (count - 1)*size, direction, size*sizeof *directions);
	to->branches++;
	return HAWSER_OK;
}

void hawser_backbone_clear(struct hawser_backbone *backbone)
{
	if (!backbone)
		return;
	free(backbone->point);
	free(backbone->coordinate);
	free(backbone->probe);
	free(backbone->start);
	free(backbone->branch);
	free(backbone->branch_start);
	free(backbone->branch_direction);
	memset(backbone, 0, sizeof *backbone);
}

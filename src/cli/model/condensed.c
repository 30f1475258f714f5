/* cli/model/condensed.c - see condensed.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/model/condensed.h"

void cli_condensed_comment(struct hawser__table *table, const struct hawser_map_condensed *condensed)
{
	if (condensed->points > 0)
		hawser__table_comment(table, "multipliers at %ld points are those of %d or more "
		                      "coordinates, with the fast ones eliminated: estimated "
		                      "error of their logarithms up to %.1e", condensed->points,
		                      condensed->kept, condensed->neglected);
}

#define OF(member) HAWSER__AT(struct hawser_map_condensed, member)
const struct hawser__field cli_condensed_field[] = {
	{"condensed.points", NULL, "points at which fast coordinates were condensed", OF(points)},
	{"condensed.kept", NULL, "least number of coordinates that were followed", OF(kept)},
	{"condensed.neglected", NULL, "estimated error of the multipliers' logarithms, at most",
	 OF(neglected)},
	HAWSER__END,
};
#undef OF

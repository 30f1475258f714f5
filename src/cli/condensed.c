/* cli/condensed.c - see condensed.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "config.h"

#include "cli/condensed.h"

void cli_condensed_comment(struct hawser__table *table, const struct hawser_map_condensed *condensed)
{
	if (condensed->points > 0)
		hawser__table_comment(table, "multipliers at %ld points are those of %d or more "
		                      "coordinates, with the fast ones condensed statically: estimated "
		                      "error of their logarithms up to %.1e", condensed->points,
		                      condensed->kept, condensed->neglected);
}

void cli_condensed_json(struct hawser__json *json, const struct hawser_map_condensed *condensed)
{
	json_t *row;

	if (condensed->points == 0)
		return;
	row = hawser__json_object(json, json->root, "condensed");
	hawser__json_integer(json, row, "points", condensed->points);
	hawser__json_integer(json, row, "kept", condensed->kept);
	hawser__json_number(json, row, "neglected", condensed->neglected);
}

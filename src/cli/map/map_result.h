/* cli/map/map_result.h - what hawser map computed, for tables, JSON and pictures.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MAP_RESULT_H
#define HAWSER_CLI_MAP_RESULT_H

#include "cli/model/judged.h"

struct cli_map_result {
	const struct cli_common *common;
	const struct cli_model *model;
	const struct hawser_map *map;
	const struct hawser_map_quantity *quantity;
	struct hawser_map_options options;
	const char *key[2], *unit[2]; /* [2] */
	double omega; /* 0: none */
	int responds; /* 1: stability is that of the periodic response */
	struct cli_judged judged;
	int full, along; /* 1: write rows of interpolated points too; by rows: the axis that is followed */
	struct hawser_basins basins; /* or count 0 */
	char flat[CLI_WARNING_SIZE]; /* why there is nothing to see; or "" */
};
/* Set `flat`. */
void cli_map_judge(struct cli_map_result *result);
/* Unit of the mapped value; "1" for a beam without dimensions. */
const char *cli_map_value_unit(const struct cli_map_result *result);
extern const struct cli_showing cli_map_showing;
enum hawser_status cli_map_draw(const char *path, const void *result, struct hawser_report *report);

#endif

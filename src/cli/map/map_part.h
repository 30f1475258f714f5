/* cli/map/map_part.h - parts of maps, and maps that are shared among ranks.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MAP_PART_H
#define HAWSER_CLI_MAP_PART_H

#include "cli/frame/cli.h"
#include "cli/map/map_result.h"
#include "cli/frame/ranks.h"

/* What a part tells in place of a result. */
void cli_map_part_done(const struct hawser_map_options *options, const struct hawser_map *map,
                       int quiet);
/* With other ranks: what can't be shared is refused; a worker has no files to write. */
enum hawser_status cli_map_ranks(struct hawser_map_options *to, struct cli_common *common,
                                 struct hawser__ranks *ranks, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* After a failure: what the user can do if a rank was lost. */
void cli_map_lost(struct hawser_report *report, const struct hawser__ranks *ranks,
                  const char *checkpoint);

/* map_result.c: the table of the points of the boundaries. */
void cli_map_boundary(struct hawser__table *table, const struct cli_map_result *result);
/* map_hdf5.c: points and boundaries as HDF5. */
enum hawser_status cli_map_hdf5(const char *path, const struct cli_map_result *result,
                                const struct hawser__table *boundaries,
                                struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* cli/modes/modes_obstacles.h - hawser modes of a span over obstacles.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MODES_OBSTACLES_H
#define HAWSER_CLI_MODES_OBSTACLES_H

#include <hawser/obstacles.h>

#include "cli/modes/modes_ropeway.h"

/* contact: slip or stick, or NULL: as the scene says. n: number of modes, 0 for the default;
 * points: in shapes, 0: none. */
enum hawser_status cli_modes_obstacles(const struct cli_common *common, const char *contact, int n,
                                       int points, struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_modes_obstacles_member[];

#endif

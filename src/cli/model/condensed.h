/* cli/model/condensed.h - error of multipliers that is due to the condensation of fast coordinates.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_CONDENSED_H
#define HAWSER_CLI_CONDENSED_H

#include <hawser/map.h>

#include "output/fields/fields.h"

/* A comment with the error of the condensation, and the object `condensed` of a struct
 * hawser_map_condensed; both are omitted if no coordinate was condensed (points is 0). */
void cli_condensed_comment(struct hawser__table *table, const struct hawser_map_condensed *condensed);
extern const struct hawser__field cli_condensed_field[];

#endif

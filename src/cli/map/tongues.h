/* cli/map/tongues.h - tongues that the search of map and hill could not tell.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_TONGUES_H
#define HAWSER_CLI_TONGUES_H

#include <hawser/map.h>

#include "output/fields/fields.h"

/* Comments, a warning, and the list `unresolved` of a struct hawser_tongues; omitted if there are
 * none. */
void cli_tongues_comment(struct hawser__table *table, const struct hawser_tongues *tongues);
void cli_tongues_warn(const struct hawser_tongues *tongues);
extern const struct hawser__field cli_tongues_field[];

#endif

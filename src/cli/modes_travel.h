/* cli/modes_travel.h - hawser modes of a scene that travels: complex modes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MODES_TRAVEL_H
#define HAWSER_CLI_MODES_TRAVEL_H

#include "cli/view.h"

/* Rows of the modes, or with points > 0 of their shapes. */
void cli_travel_rows(struct hawser__table *table, const struct hawser_modes *modes,
                     int points);
/* The list of modes, and with points > 0 the shapes. */
void cli_travel_json(struct hawser__json *json, const struct hawser_modes *modes,
                     int points);
/* Of a mode, and of all. */
extern const struct hawser__field cli_travel_mode_field[], cli_travel_field[];
void cli_travel_methods(void);

#endif

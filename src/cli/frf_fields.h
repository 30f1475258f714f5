/* cli/frf_fields.h - the fields of a frequency response.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FRF_FIELDS_H
#define HAWSER_CLI_FRF_FIELDS_H

#include "cli/view.h"

/* Of a struct cli_frf_result; and of a struct hawser_frf, what it cost. */
extern const struct hawser__field cli_frf_field[], cli_frf_cost_field[];

struct hawser__view cli_frf_view(const struct cli_frf_result *result);
/* Columns and rows: the curve, the sweeps, the backbone. */
void cli_frf_rows(struct hawser__table *table, const struct cli_frf_result *result);

#endif

/* cli/curves/frf_waves.h - hawser frf of a net with waves: its linear response to them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FRF_WAVES_H
#define HAWSER_CLI_FRF_WAVES_H

#include "cli/frame/view.h"

/* Whether the input is a net whose scene has waves. */
int cli_waves_in(const struct cli_common *common);
/* Compute and show the response; texts of options, or NULL. */
enum hawser_status cli_waves_response(const struct cli_common *common, const char *from, const char *to,
                                      int points, struct hawser_report *report) HAWSER_MUST_CHECK;
extern const struct hawser__field cli_waves_field[];

#endif

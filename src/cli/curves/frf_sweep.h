/* cli/curves/frf_sweep.h - hawser frf --sweep: settled motions over a range of frequencies, by
 * integration. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_FRF_SWEEP_H
#define HAWSER_CLI_FRF_SWEEP_H

#include "cli/frame/cli.h"

/* list [2] and *count: sweeps in the direction `which`, "up", "down" or "both"; NULL: none. points:
 * number of frequencies. Statuses of hawser_sweep_run. */
enum hawser_status cli_sweeps(struct cli_sweep *list, int *count, const char *which, int points,
                              const struct cli_frf_result *result,
                              struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

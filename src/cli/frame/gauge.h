/* cli/frame/gauge.h - time and memory of a call; `work` returns 0 if it fails.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_GAUGE_H
#define HAWSER_CLI_GAUGE_H

/* Seconds of wall time, the best of several calls. */
double cli_gauge_time(int (*work)(void *context), void *context);
/* Bytes by which the heap's high-water mark rises, or 0 if that is not known. */
double cli_gauge_memory(int (*work)(void *context), void *context);

#endif

/* cli/measure/measured.h - a table of measured natural frequencies.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_MEASURED_H
#define HAWSER_CLI_MEASURED_H

#include <hawser/identify.h>

/* Read *measured [*count] from the file at `path` ("-": standard input); free it. Columns by name,
 * others are skipped: omega_rad_s or frequency_Hz, deviation_rad_s or deviation_Hz, plane, index (among
 * all modes), number (in its plane). Without a line of names the only column is frequency_Hz.
 * HAWSER_ERR_SCENE: the message names file, line and column. */
enum hawser_status cli_measured_read(struct hawser_measured **measured, int *count,
                                     const char *path,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

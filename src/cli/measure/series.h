/* cli/measure/series.h - two columns of a text table: a measured series, or a result of another
 * command. SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_SERIES_H
#define HAWSER_CLI_SERIES_H

#include <hawser/identify.h>
#include <hawser/status.h>

enum { CLI_COLUMN_NAME = 64 };

struct cli_series {
	double *x, *y; /* [count] */
	int count;
	/* "column 2", or the name in the first line of the table */
	char x_name[CLI_COLUMN_NAME], y_name[CLI_COLUMN_NAME];
};

/* Reads `path` ("-" is standard input). A column is chosen by its number from 1 or by its name. `y` may
 * be NULL: then it is the displacement with the largest value where the names tell which columns
 * are displacements (x_*_m, y_*_m and z_*_m, else u_*), and column 2 otherwise.
 * Returns HAWSER_OK, HAWSER_ERR_ARGUMENT (no such column), HAWSER_ERR_SCENE (a row lacks the number),
 * HAWSER_ERR_IO or HAWSER_ERR_MEMORY. */
enum hawser_status cli_series_read(struct cli_series *series, const char *path, const char *x,
                                   const char *y, struct hawser_report *report) HAWSER_MUST_CHECK;
void cli_series_clear(struct cli_series *series);

/* The columns of a table by their names, name [names]: column[k] [*rows], or NULL if the table does not
 * have it; free them. The first one and another one are required, and further columns refused
 * (HAWSER_ERR_SCENE). Other statuses as above. */
enum hawser_status cli_columns_read(double **column, int *rows, const char *path,
                                    const char *const *name, int names,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- measured.c: a table of measured natural frequencies --- */

/* Read *measured [*count] from the file at `path` ("-": standard input); free it. Columns by name,
 * others are skipped: omega_rad_s or frequency_Hz, deviation_rad_s or deviation_Hz, plane, index (among
 * all modes), number (in its plane). Without a line of names the only column is frequency_Hz.
 * HAWSER_ERR_SCENE: the message names file, line and column. */
enum hawser_status cli_measured_read(struct hawser_measured **measured, int *count,
                                     const char *path,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

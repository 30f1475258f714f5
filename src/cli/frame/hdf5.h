/* cli/frame/hdf5.h - tables as HDF5, for results of millions of rows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CLI_HDF5_H
#define HAWSER_CLI_HDF5_H

#include <hawser/status.h>
#include "output/fields/fields.h"
#include "output/output.h"

/* A word or a number about the result, an attribute of the file. */
struct cli_hdf5_fact {
	const char *name, *word; /* word NULL: the number */
	double number;
};
enum { CLI_HDF5_WORD = 32 }; /* bytes of a word, with the zero at its end; chosen */
/* A table is a group with a data set for each column: numbers as doubles (no value: not-a-number),
 * words as texts of CLI_HDF5_WORD bytes. */
struct cli_hdf5_table {
	const char *name;
	const struct hawser__table *table;
	const struct hawser__field *field; /* its columns: which of them have words */
};

/* Write tables [tables] and facts [facts] to the new file `path`, which is complete or not made.
 * Rows that a table makes on output are made a block at a time. HAWSER_ERR_PROGRAM: this program is
 * built without HDF5, or its library can't be loaded; HAWSER_ERR_IO; HAWSER_ERR_MEMORY;
 * HAWSER_ERR_NAN. */
enum hawser_status cli_hdf5_write(const char *path, const struct cli_hdf5_table *tables, int count,
                                  const struct cli_hdf5_fact *fact, int facts,
                                  struct hawser_report *report) HAWSER_MUST_CHECK;
/* Before a long computation: whether that is possible. NULL is legal. */
enum hawser_status cli_hdf5_check(const char *path, struct hawser_report *report) HAWSER_MUST_CHECK;

#endif

/* study/map/map_rows_file.h - the rows of a map in its checkpoint.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MAP_ROWS_FILE_H
#define HAWSER_STUDY_MAP_ROWS_FILE_H

#include "study/map/map.h"
#include "study/map/map_rows.h"

struct hawser__map_rows_file {
	struct hawser__map_checkpoint checkpoint;
	struct hawser__map_row *row; /* [rows] */
	int rows;
	struct hawser__map_row *open; /* row that is being read, or NULL */
	int answers;                  /* of this row */
};

/* Open or create the file; rows that are in it become ready. `fixed`, `at` and `count` of the rows
 * [rows] are set. Statuses of hawser__map_checkpoint_open. */
enum hawser_status hawser__map_rows_file_open(struct hawser__map_rows_file *file, const char *path,
                                              const char *identity, const char *settings,
                                              struct hawser__map_row *row, int rows,
                                              struct hawser_report *report);
/* Put a row into the text that hawser__map_checkpoint_flush appends. */
enum hawser_status hawser__map_rows_file_add(struct hawser__map_rows_file *file,
                                             const struct hawser__map_row *row,
                                             struct hawser_report *report);

#endif

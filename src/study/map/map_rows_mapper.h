/* study/map/map_rows_mapper.h - what a map by rows is computed with: map_rows.c, and its tasks,
 * map_rows_ranks.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MAP_ROWS_MAPPER_H
#define HAWSER_STUDY_MAP_ROWS_MAPPER_H

#include <stdatomic.h>

#include "study/map/map_rows_file.h"

struct hawser__rows_mapper {
	struct hawser_map *map;
	const struct hawser_map_field *field;
	const struct hawser_map_options *options;
	struct hawser__map_row *row; /* [rows] */
	struct hawser__map_seed **seed; /* [rows][] of the rows */
	int rows, along;
	double *x, *y;               /* [rows] for the field's `prepare` */
	void **worker;               /* [threads] */
	int threads;
	struct hawser__map_rows_file file;
	double began;
	long done, fresh;
	atomic_int stop;
	long *pending, all;          /* [all] the rows that are not ready */
};

/* map_rows.c: tell the progress; not 0: stop. */
int hawser__rows_told_to_stop(struct hawser__rows_mapper *mapper);
/* map_rows.c: the status of a row in which a point has no value, if the map is strict. */
enum hawser_status hawser__rows_refuse(const struct hawser__rows_mapper *mapper,
                                       const struct hawser__map_row *row,
                                       struct hawser_report *report);
/* map_rows_across.c: the seeds of the rows, from curves along the other coordinate. */
enum hawser_status hawser__rows_across(struct hawser__rows_mapper *mapper,
                                       struct hawser_report *report);
/* map_rows_ranks.c: compute the rows that are not ready, by all threads and ranks; or, in a worker,
 * compute for rank 0 until it ends. */
enum hawser_status hawser__rows_compute(struct hawser__rows_mapper *mapper, const char *settings,
                                        struct hawser_report *report);

#endif

/* study/map/map_rows_mapper.h - what a map by rows is computed with: map_rows.c, by threads, and
 * map_rows_ranks.c, by several processes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MAP_ROWS_MAPPER_H
#define HAWSER_STUDY_MAP_ROWS_MAPPER_H

#include <pthread.h>
#include <stdatomic.h>

#include "study/map/map_rows_file.h"

struct hawser__rows_mapper {
	struct hawser_map *map;
	const struct hawser_map_field *field;
	const struct hawser_map_options *options;
	struct hawser__map_row *row; /* [rows] */
	int rows, along;
	double *x, *y;               /* [rows] for the field's `prepare` */
	void **worker;               /* [threads] */
	int threads;
	struct hawser__map_rows_file file;
	double began;
	long done, fresh;
	pthread_t caller;
	atomic_int stop;
	long *pending, all;          /* [all] with other ranks: the rows that are not ready */
	/* of the rows that are computed now */
	int from;
	pthread_mutex_t lock;
	int failed;                  /* the first row that failed */
	enum hawser_status status;
	struct hawser_report report;
};

/* map_rows.c: tell the progress; not 0: stop. */
int hawser__rows_told_to_stop(struct hawser__rows_mapper *mapper);
/* map_rows.c: 1: the row is of the part that is computed. */
int hawser__rows_has(const struct hawser__rows_mapper *mapper, int j);
/* map_rows.c: the status of a row in which a point has no value, if the map is strict. */
enum hawser_status hawser__rows_refuse(const struct hawser__rows_mapper *mapper,
                                       const struct hawser__map_row *row,
                                       struct hawser_report *report);
/* map_rows_ranks.c: compute the rows that are not ready, by all ranks; or, in a worker, compute for
 * rank 0 until it ends. */
enum hawser_status hawser__rows_by_ranks(struct hawser__rows_mapper *mapper, const char *settings,
                                         struct hawser_report *report);

#endif

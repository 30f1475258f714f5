/* study/map/map_rows.h - maps by rows: the responses of a model along one parameter, for each value
 * of the other. map_row.c computes a row, map_rows.c the map, map_rows_file.c its file,
 * map_rows_lines.c its boundaries.
 *
 * The model of a row is that of map_row_model.c.
 *
 *    row      all responses at one value of the parameter that is not followed
 *    cell     a value of the followed parameter in a row
 *    along    the coordinate that is followed: 0: x, 1: y
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MAP_ROWS_H
#define HAWSER_STUDY_MAP_ROWS_H

#include <stdatomic.h>

#include <hawser/frf.h>
#include <hawser/map.h>

#include "study/map/map.h"

/* What a row has at a value of the parameter. */
struct hawser__map_answer {
	struct hawser_map_sample sample; /* value: the largest amplitude */
	double least, most, tension;     /* tension: least one, N; NaN: none is known */
	int branches, stable;
};

/* An event on a curve of a row. */
struct hawser__map_turn {
	double at, error;   /* value of the parameter; absolute */
	enum hawser_event_kind kind;
	int side;           /* of a fold: the side on which the two responses are, -1 or 1; else 0 */
};

enum { HAWSER__MAP_KEEPS_ALL = -1 };

/* A motion at a value of the followed parameter. */
struct hawser__map_seed {
	double at;
	int coordinates; /* n */
	double *state;   /* [2n] scaled, at phase 0 */
};

struct hawser__map_row {
	/* what is asked for */
	const double *at;   /* [count] values of the followed parameter, ascending or descending */
	int count;
	double fixed;       /* value of the other parameter */
	int only_stable;    /* 1: only stable responses count */
	int across;         /* 1: the row is along the other coordinate of the map */
	int keeps, keep;    /* 1: the states of the responses at the place `keep` are kept, or at all */
	const struct hawser__map_seed *seed; /* [seeds] motions whose curves are followed too */
	int seeds;
	const struct hawser_progress *progress; /* asked by the traces; may end them */
	/* results */
	struct hawser__map_answer *answer; /* [count] */
	struct hawser__map_turn *turn;     /* [turns] by `at` */
	int turns;
	int ready, interrupted;
	int incomplete;     /* 1: a curve could not be followed to its end */
	double *state;      /* [kept][2n] scaled, at phase 0, or NULL */
	int *kept_at;       /* [kept] their places */
	int kept, coordinates; /* n */
	char *why[HAWSER_MAP_CODES]; /* the reason of the first answer of this code, or NULL */
	char *broken;       /* why the row is incomplete, or NULL */
};
/* map_row_result.c */
void hawser__map_row_clear(struct hawser__map_row *row);
/* Replace *text by a copy; without memory it becomes NULL. */
void hawser__map_note(char **text, const char *message);

/* map_row_result.c: after answers without a value got their code: the reason, of the first of each
 * code; `message` may be NULL. */
void hawser__map_row_explain(struct hawser__map_row *row, const struct hawser__map_answer *answer,
                             const char *message);
/* map_row_result.c: these answers have no value, for this reason. */
void hawser__map_row_fill(struct hawser__map_row *row, int from, int to, enum hawser_map_code code,
                          const char *message);
/* map_row.c: all responses of a model along Omega or, with a family, along its parameter, of which only
 * positive values are taken if `positive`. omega: a scaled frequency of the range. Statuses of
 * hawser_frf_trace but HAWSER_ERR_CONVERGENCE. */
enum hawser_status hawser__map_row_follow(struct hawser__map_row *row, const struct hawser_rom *rom,
                                          const struct hawser_rom_family *family, double omega,
                                          int positive, struct hawser_report *report)
	HAWSER_MUST_CHECK;
/* map_rows_across.c: a row, of this frequency in rad/s or the model's unit, that has the states of the
 * responses which curves over the frequency have there, or none. To be cleared; row->at must not be
 * used.
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__map_row_at(struct hawser__map_row *row, const struct hawser_rom *rom,
                                      double omega, const struct hawser_progress *progress,
                                      struct hawser_report *report) HAWSER_MUST_CHECK;
/* map_row_model.c: the member `row` of the field of a cable; `worker` is that of map_point.c. */
enum hawser_status hawser__map_worker_row(void *worker, struct hawser__map_row *row,
                                          struct hawser_report *report);
/* map_row_model.c: the coordinate that is followed for this source. */
int hawser__map_row_along(const void *context);

/* map_rows.c */
enum hawser_status hawser__map_rows(struct hawser_map *map, const struct hawser_map_field *field,
                                    const struct hawser_map_options *options,
                                    struct hawser_report *report);
/* map_rows_lines.c: boundaries and segments from the rows [rows], which are at `fixed` [rows]. */
enum hawser_status hawser__map_rows_lines(struct hawser_map *map, const struct hawser__map_row *row,
                                          int rows, int along, struct hawser_report *report);

/* --- map_rows_file.c: the rows of a map in its checkpoint --- */

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

/* --- what a map by rows is computed with: map_rows.c, and its tasks, map_rows_ranks.c --- */

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

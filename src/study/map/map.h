/* study/map/map.h - shared parts of the computation of a map: points that are computed once
 * (map_memo.c), their file (map_checkpoint.c), cells (map_tree.c), and boundaries on the edges of
 * cells (map_edges.c).
 *
 *    node    a point of the grid of the requested resolution: (x[i], y[j])
 *    probe   a point between two nodes of a line of the grid
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MAP_H
#define HAWSER_STUDY_MAP_H

#include <hawser/map.h>

#include "core/ranks.h"
#include "study/map/ridge.h"

/* --- map_checkpoint.c --- */

struct hawser__map_record {
	double x, y;
	struct hawser_map_sample sample;
	int ready, visited; /* already computed; requested in this run */
};

/* A text file to which lines are only appended; open while the map is traced. fd -1: none. */
struct hawser__map_checkpoint {
	int fd;
	const char *path;
	int marks;
	char *text; /* lines to be appended next */
	size_t used, room;
};

/* Open or create the file, lock it, and pass each record in it to `take`. `identity` and `settings`
 * must be those in the file. */
struct hawser__map_taker {
	enum hawser_status (*take)(void *context, const struct hawser__map_record *record,
	                           const double *marks, struct hawser_report *report);
	void *context;
};
enum hawser_status hawser__map_checkpoint_open(struct hawser__map_checkpoint *checkpoint,
                                               const char *path, const char *identity,
                                               const char *settings, int marks,
                                               const struct hawser__map_taker *taker,
                                               struct hawser_report *report);
/* _add puts a record into the text, _flush appends the text to the file. */
enum hawser_status hawser__map_checkpoint_add(struct hawser__map_checkpoint *checkpoint,
                                              const struct hawser__map_record *record,
                                              const double *marks, struct hawser_report *report);
enum hawser_status hawser__map_checkpoint_flush(struct hawser__map_checkpoint *checkpoint,
                                                struct hawser_report *report);
void hawser__map_checkpoint_close(struct hawser__map_checkpoint *checkpoint);
/* Whether a line, with its newline, has its checksum; and whether it is a header. */
int hawser__map_checkpoint_is_sound(const char *line);
int hawser__map_checkpoint_is_head(const char *line);

/* --- map_memo.c --- */

enum { HAWSER__MARGINS = 2 };

/* The points of a map, found by their coordinates. Points are first requested, then computed
 * together. */
struct hawser__map_memo {
	const struct hawser_map_field *field;
	const struct hawser_map_options *options;
	struct hawser__map_record *record; /* [count] */
	double *mark;                      /* [count][marks] */
	int marks;                         /* number of marks that are stored: all if lines are
	                                    * examined, else the margins */
	double *scratch;                   /* [threads][field->marks] */
	long count, visited, restored, fresh;
	long *slot, slots;                 /* hash: index of a record + 1, or 0 */
	long *pending, waiting;            /* records that are requested but not computed */
	void **worker;                     /* [threads] */
	int threads, interrupted;
	double cost;                       /* time per point of the last computation, s; 0: none */
	double began;                      /* start time, s, hawser__wall_seconds */
	struct hawser__map_checkpoint checkpoint;
	struct hawser__tasks tasks;
	char *identity;                    /* of field and settings */
	const long *asked;                 /* records that are computed now */
	long later;                        /* the expected number of further points */
	const char *stage;
	struct hawser_map_condensed others; /* of the points that other ranks computed */
};
enum hawser_status hawser__map_memo_open(struct hawser__map_memo *memo,
                                         const struct hawser_map_field *field,
                                         const struct hawser_map_options *options,
                                         const char *settings, struct hawser_report *report);
void hawser__map_memo_close(struct hawser__map_memo *memo);
/* *index becomes that of the point at x, y. If it is not computed yet, the next _run computes it.
 * */
enum hawser_status hawser__map_want(struct hawser__map_memo *memo, long *index, double x, double y,
                                    struct hawser_report *report);
/* Compute the requested points; `later` is the expected number of further points. */
enum hawser_status hawser__map_run(struct hawser__map_memo *memo, const char *stage, long later,
                                   struct hawser_report *report);

/* The status of a point whose failure ends a strict map; its coordinates are added to the report.
 * */
enum hawser_status hawser__map_refuse(const struct hawser__map_memo *memo, struct hawser_report *report,
                                      const struct hawser__map_record *record);
/* Tell the progress, `left` points before the end; not 0: stop. */
int hawser__map_told_to_stop(const struct hawser__map_memo *memo, const char *stage, long left);

/* --- map_ranks.c --- */

enum hawser_status hawser__map_ranks_open(struct hawser__map_memo *memo, const char *settings,
                                          struct hawser_report *report);
/* Compute pending [count], by threads and by other ranks where that is worth it. */
enum hawser_status hawser__map_ranks_run(struct hawser__map_memo *memo, const long *pending, long count,
                                         struct hawser_report *report);
/* In a worker: compute for rank 0 until it ends. */
void hawser__map_ranks_serve(struct hawser__map_memo *memo);
/* In rank 0: end the workers. */
void hawser__map_ranks_end(struct hawser__map_memo *memo);
void hawser__map_condensed_merge(struct hawser_map_condensed *all,
                                 const struct hawser_map_condensed *part);
/* The text that tells whether ranks have the same field and settings, or NULL. */
char *hawser__map_ranks_identity(const char *identity, const char *settings);
/* The number of the part, from 1, that the item at column a, row b of a grid of columns x rows has.
 * */
int hawser__map_part_of(int a, int b, int columns, int rows, int parts);

/* --- map_tree.c --- */

struct hawser__map_cell {
	int i0, i1, j0, j1; /* indices of the nodes at its corners */
};
struct hawser__map_cells {
	struct hawser__map_cell *cell; /* [count] */
	size_t count;
};

/* An edge between neighbouring nodes: from node (i, j) by one along x (0) or y (1); its index is 2
 * (j nx + i) + along. */
struct hawser__map_probe {
	long edge;
	double t; /* position along the edge, 0 to 1 */
	long index;
};

struct hawser__mapper {
	const struct hawser_map_field *field;
	const struct hawser_map_options *options;
	struct hawser__map_memo memo;
	int nx, ny;
	double *x, *y;            /* [nx], [ny] */
	long *node;               /* [ny][nx] index of the record, or -1 */
	unsigned char *hot;       /* [ny][nx] bits 1, 2: a narrow instability crosses the edge from this
	                           * node along x, y */
	struct hawser__map_cells leaf;
	struct hawser__map_probe *probe; /* [probes] inside edges between neighbouring nodes */
	size_t probes;
	int searched;             /* 1: map_ridges.c has been called */
	long later;               /* points that are expected beyond those of this level of cells */
	struct hawser__ridge_log tongues;
	double low, high;         /* range of the values at nodes */
};

/* Evaluate nodes and split cells until each is small or has corners that agree. */
enum hawser_status hawser__map_grow(struct hawser__mapper *mapper, struct hawser_report *report);
/* Whether two records lie on different sides of a boundary; or in different tongues with the same
 * number of instabilities, between which there are two boundaries. */
int hawser__map_differ(const struct hawser__mapper *mapper, long a, long b);
const struct hawser_map_sample *hawser__map_sample(const struct hawser__mapper *mapper, long index);
const double *hawser__map_marks(const struct hawser__mapper *mapper, long index);

/* --- map_ridges.c --- */

/* Search for tongues that cross the edges of the first cells, and follow those that are narrower
 * than a smallest cell: sets mapper->hot and adds probes. */
enum hawser_status hawser__map_ridges(struct hawser__mapper *mapper,
                                      const struct hawser__map_cells *cells,
                                      struct hawser_report *report);

/* --- map_edges.c --- */

/* A boundary between two points at t[0] < t[1] of an edge. */
struct hawser__map_bracket {
	long edge;
	double t[2];
	long index[2];
	double reach[2]; /* range of t in which the growth may be 0; contains the bracket */
	int known;       /* 0: no range narrower than the bracket at the start is known */
	double width0;   /* width of the bracket at the start */
	int steps, done;
	long middle;
	double at;
};

struct hawser__map_brackets {
	struct hawser__map_bracket *item;
	size_t count;
};

double hawser__map_between(double a, double b, double t);
/* The point at the fraction t of an edge that begins at node (i, j) and extends over `length`
 * nodes. */
enum hawser_status hawser__map_want_on(struct hawser__mapper *mapper, long *index, int i, int j,
                                       int along, int length, double t,
                                       struct hawser_report *report);
/* Compute boundary points and segments. */
enum hawser_status hawser__map_boundaries(struct hawser_map *map, struct hawser__mapper *mapper,
                                          struct hawser_report *report);

/* --- map_doubt.c --- */

/* Update `reach` after t has become narrower, or, with `anew`, is new. */
void hawser__map_doubt(const struct hawser__mapper *mapper, struct hawser__map_bracket *item,
                       int anew);

/* --- map_lines.c --- */

/* Make points and segments from brackets in the order of their edges. */
enum hawser_status hawser__map_lines(struct hawser_map *map, const struct hawser__mapper *mapper,
                                     const struct hawser__map_brackets *list,
                                     struct hawser_report *report);

#endif

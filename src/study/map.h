/* study/map.h - the parts of a map: points that are computed once (map_memo.c), their file
 * (map_checkpoint.c), cells (map_tree.c), and boundaries on the cells' edges (map_edges.c).
 *
 *   node    a point of the lattice of the resolution asked for: (x[i], y[j])
 *   probe   a point on an edge where one of the field's lines crosses it
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_MAP_H
#define HAWSER_STUDY_MAP_H

#include <hawser/map.h>

/* --- map_checkpoint.c --- */

struct hawser__map_record {
	double x, y;
	struct hawser_map_sample sample;
	int ready, visited; /* computed; asked for in this run */
};

/* A file of lines of text that is only ever appended to; open while the map is traced. fd -1: none. */
struct hawser__map_checkpoint {
	int fd;
	const char *path;
	int marks;
	char *text; /* what is to be appended next */
	size_t used, room;
};

/* Open or create and lock it, and give every record in it to `take`. `identity` and `settings` are what
 * it must belong to. */
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
/* Put a record into the text, and append the text to the file. */
enum hawser_status hawser__map_checkpoint_add(struct hawser__map_checkpoint *checkpoint,
                                              const struct hawser__map_record *record,
                                              const double *marks, struct hawser_report *report);
enum hawser_status hawser__map_checkpoint_flush(struct hawser__map_checkpoint *checkpoint,
                                                struct hawser_report *report);
void hawser__map_checkpoint_close(struct hawser__map_checkpoint *checkpoint);

/* --- map_memo.c --- */

enum { HAWSER__MARGINS = 2 };

/* Points by their coordinates: wanted first, then computed together. */
struct hawser__map_memo {
	const struct hawser_map_field *field;
	const struct hawser_map_options *options;
	struct hawser__map_record *record; /* [count] */
	double *mark;                      /* [count][marks] */
	int marks;                         /* kept: all where lines are looked at, else the margins */
	double *scratch;                   /* [threads][field->marks] */
	long count, capacity, visited, restored, fresh;
	long *slot, slots;                 /* hash: index of a record + 1, or 0 */
	long *pending, waiting, room;      /* visited and not ready */
	void **worker;                     /* [threads] */
	int threads, chunk, interrupted;
	double cost;                       /* s a point took last; 0: none did */
	double began;                      /* s, hawser__wall_seconds */
	struct hawser__map_checkpoint checkpoint;
};
enum hawser_status hawser__map_memo_open(struct hawser__map_memo *memo,
                                         const struct hawser_map_field *field,
                                         const struct hawser_map_options *options,
                                         const char *settings, struct hawser_report *report);
void hawser__map_memo_close(struct hawser__map_memo *memo);
/* *index of the point, computed after the next _run if it is not yet. */
enum hawser_status hawser__map_want(struct hawser__map_memo *memo, long *index, double x, double y,
                                    struct hawser_report *report);
/* Compute what is pending; `later` points are expected after these. */
enum hawser_status hawser__map_run(struct hawser__map_memo *memo, const char *stage, long later,
                                   struct hawser_report *report);

/* --- map_tree.c --- */

struct hawser__map_cell {
	int i0, i1, j0, j1; /* nodes at its corners */
};
struct hawser__map_cells {
	struct hawser__map_cell *cell; /* [count] */
	size_t count, room;
};

/* A fine edge runs from node (i, j) by one along x (0) or y (1): edge 2 (j nx + i) + along. */
struct hawser__map_probe {
	long edge;
	double t; /* 0 to 1 along it */
	long index;
};

struct hawser__mapper {
	const struct hawser_map_field *field;
	const struct hawser_map_options *options;
	struct hawser__map_memo memo;
	int nx, ny;
	double *x, *y;            /* [nx], [ny] */
	long *node;               /* [ny][nx] index of the record, or -1 */
	unsigned char *hot;       /* [ny][nx] bits 1, 2: fine edges along x, y hide something */
	struct hawser__map_cells leaf;
	struct hawser__map_probe *probe; /* [probes] on fine edges, other than their ends */
	size_t probes, probe_room;
	double low, high;         /* of the values at nodes */
};

/* Visit nodes until every cell is small or dull. */
enum hawser_status hawser__map_grow(struct hawser__mapper *mapper, struct hawser_report *report);
/* Whether two samples lie on different sides of a boundary. */
int hawser__map_differ(const struct hawser_map_sample *a, const struct hawser_map_sample *b);
const struct hawser_map_sample *hawser__map_sample(const struct hawser__mapper *mapper, long index);
const double *hawser__map_marks(const struct hawser__mapper *mapper, long index);

/* --- map_probes.c --- */

/* Look at the lines that cross the edges of the cells: hot[c] is set where something hides on an
 * edge of cell c. */
enum hawser_status hawser__map_probes(struct hawser__mapper *mapper, unsigned char *hot,
                                      const struct hawser__map_cells *cells,
                                      struct hawser_report *report);

/* --- map_edges.c --- */

/* A boundary between two points of a fine edge, at t[0] < t[1] along it. */
struct hawser__map_bracket {
	long edge;
	double t[2];
	long index[2];
	double reach[2]; /* where growth is 0: t, or wider */
	int known;       /* 0: nothing narrower than t at the beginning is known of that */
	double width0;   /* at the beginning */
	int steps, done;
	long middle;
	double at;
};

struct hawser__map_brackets {
	struct hawser__map_bracket *item;
	size_t count, room;
};

double hawser__map_between(double a, double b, double t);
/* The point at part t of the edge of `length` fine edges that begins at node (i, j). */
enum hawser_status hawser__map_want_on(struct hawser__mapper *mapper, long *index, int i, int j,
                                       int along, int length, double t,
                                       struct hawser_report *report);
/* Boundary points and segments. */
enum hawser_status hawser__map_boundaries(struct hawser_map *map, struct hawser__mapper *mapper,
                                          struct hawser_report *report);

/* --- map_doubt.c --- */

/* Find `reach` for t, which has become narrower, or is `anew`. */
void hawser__map_doubt(const struct hawser__mapper *mapper, struct hawser__map_bracket *item,
                       int anew);

/* --- map_lines.c --- */

/* Of brackets in the order of their edges. */
enum hawser_status hawser__map_lines(struct hawser_map *map, const struct hawser__mapper *mapper,
                                     const struct hawser__map_brackets *list,
                                     struct hawser_report *report);

/* An array that has `count` elements of `size` bytes takes one more; NULL when out of memory. */
void *hawser__map_room(void *array, size_t *room, size_t count, size_t size);

#endif

/* hawser/map.h - maps over two parameters: the value of a quantity, the number of instabilities,
 * and the lines on which that number changes.
 *
 * The mapped field is a function of (x, y). hawser_map_trace evaluates it on cells, from coarse to
 * fine: cells whose corners differ are split down to the requested resolution, and the boundary is
 * bracketed by bisection on their edges. Points inside cells whose corners agree are interpolated
 * and marked as such. A map of responses is computed by rows instead: the curves of responses are
 * followed along one parameter, for each value of the other, and every point is computed. A value
 * depends on (x, y) only, so that results do not depend on the number of
 * threads or on interruptions, to the last bit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_MAP_H
#define HAWSER_MAP_H

#include <hawser/progress.h>
#include <hawser/rom.h>
#include <hawser/rom_source.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The outcome of a point. */
enum hawser_map_code {
	HAWSER_MAP_OK = 0,
	HAWSER_MAP_NO_STATE,      /* no such equilibrium, no steady state */
	HAWSER_MAP_SLACK,         /* the tension is negative somewhere, which a cable cannot carry */
	HAWSER_MAP_NOT_CONVERGED, /* an iteration did not reach its tolerance */
	HAWSER_MAP_NOT_FINITE,    /* infinite, or not a number */
	HAWSER_MAP_REFUSED,       /* a parameter out of its range, or a model that cannot be made */
	HAWSER_MAP_NO_RESPONSE,   /* the response that grows out of rest has a fold before the whole
	                           * excitation is reached, and jumps */
	HAWSER_MAP_LEFT,          /* not visited: the map was interrupted */
	HAWSER_MAP_CODES
};
const char *hawser_map_code_name(enum hawser_map_code code); /* "ok", "no-state", ... */
/* 1 for _NOT_CONVERGED, _NOT_FINITE and _REFUSED: the value could not be computed. _NO_STATE and
 * _NO_RESPONSE, in contrast, are results: the cable has no such state. */
int hawser_map_uncomputed(enum hawser_map_code code);

struct hawser_map_sample {
	double value; /* of the quantity; 0 where code is not HAWSER_MAP_OK, but for _SLACK */
	int number;   /* of instabilities */
	enum hawser_map_code code;
};

/* If a model has many coordinates and some of them are fast, the multipliers are computed from the
 * coordinates that can take part in an instability; the others follow them (slow manifold). */
struct hawser_map_condensed {
	long points;      /* number of points with condensed coordinates */
	int kept;         /* smallest number of coordinates that were not condensed */
	double neglected; /* estimate of the largest error of the multipliers' logarithms by it */
};

struct hawser__map_row;
struct hawser__ranks; /* other processes that compute; the program has them of mpirun */

/* A motion whose curves a map by rows has too, as one on a detached curve. */
struct hawser_map_start {
	double at[2];         /* [2] x and y, in the range of the map */
	int coordinates;      /* n, of the model */
	const double *state;  /* [2n] scaled, at phase 0 */
};

/* A field to be mapped. The results of `point` depend on (x, y) only. */
struct hawser_map_field {
	const char *name;     /* of the quantity */
	const char *identity; /* text that identifies the field, for checkpoints */
	double threshold;     /* value at which the number of instabilities becomes positive */
	int responds;         /* 1: multipliers and growth are about the periodic response, where something
	                       * moves the model; 0: about rest */
	int logarithmic;      /* 1: values are compared by their ratio; 0: by their difference */
	int marks;            /* number of further results of `point`, the marks */
	int margins;          /* 1: the first two marks are margins, in a measure of growth that is 0 on
	                       * the boundary: the smallest growth among the counted instabilities, minus
	                       * its error; and the largest growth among all else, plus its error. Errors
	                       * and growth below the limit of counting then widen the bracket */
	int exponents;        /* n: the marks behind the margins are the frequency of excitation and, of n
	                       * coordinates, a frequency at rest [n], the number of the part of the
	                       * model [n] whose coordinates are coupled, and the logarithms of the moduli
	                       * [2n] and arguments [2n] of the multipliers; those of a part belong to
	                       * its coordinates together. Parametric instabilities narrower than a cell
	                       * are then searched; 0: they are not */
	const struct hawser_map_condensed *condensed; /* statistics of all points of workers that are
	                                               * closed; or NULL */
	void *context;
	/* A worker for each thread; `close` takes NULL. */
	enum hawser_status (*open)(void **worker, void *context, struct hawser_report *report);
	void (*close)(void *worker);
	/* Called from the caller's thread before points x, y [count] are computed; may be NULL. */
	enum hawser_status (*prepare)(void *context, const double *x, const double *y, int count,
	                              int threads, struct hawser_report *report);
	/* Computes the point at x, y, and marks [marks] unless that is NULL. A status other than
	 * HAWSER_OK ends the map. If only this point has no value, the status is HAWSER_OK,
	 * sample->code says which case it is, and the report has the reason. */
	enum hawser_status (*point)(void *worker, struct hawser_map_sample *sample, double *marks,
	                            double x, double y, struct hawser_report *report);
	/* If not NULL, the map consists of rows along coordinate `along` (0: x, 1: y), each
	 * computed at once, and `point` is not called: the responses at each point are those of
	 * curves that are followed along the row. Statuses as of `point`. */
	enum hawser_status (*row)(void *worker, struct hawser__map_row *row,
	                          struct hawser_report *report);
	int along;
	int columns; /* of a map by rows: curves are followed along the other coordinate too, at so many of
	              * its values, and from their responses curves along the rows */
	const struct hawser_map_start *start; /* of a map by rows: the same through this motion; or NULL */
};

struct hawser_map_options {
	double from[2], to[2]; /* ranges of x and y */
	int points[2];         /* requested resolution, each >= 2; 0: 200 */
	int coarse;            /* the first cells are coarser by this factor; 1: all points are
	                        * evaluated; 0: 8 */
	double jump;           /* a cell is also split if the value varies over it by more than this
	                        * fraction of the variation over the map; 0: 0.05; HAWSER_NONE: cells
	                        * are split by numbers only */
	double tolerance;      /* of boundary points, relative to the range; 0: 1e-4 */
	int threads;           /* 0: OMP_NUM_THREADS, else all processors */
	const char *checkpoint; /* file that stores every point evaluated, or NULL */
	struct hawser_progress progress; /* called every 0.1 to 0.5 s */
	int strict; /* 1: end with HAWSER_ERR_CONVERGENCE at the first point that could not be computed
	             * (hawser_map_uncomputed) instead of leaving it empty */
	int only_stable; /* a map by rows: 1: only stable responses count */
	/* Of `parts` parts, number `part` from 1: the cells, or the rows, of this part are computed
	 * as far as the part alone decides, into the checkpoint. The checkpoints of all parts
	 * together, joined by hawser_map_merge, have nearly all points of the map, and it computes
	 * those that are left. 0, 0: all. */
	int part, parts;
	struct hawser__ranks *ranks; /* or NULL. In a worker hawser_map_trace computes for rank 0, and the
	                              * map stays empty */
};
void hawser_map_settle(struct hawser_map_options *options);

struct hawser_map_point {
	struct hawser_map_sample sample;
	int computed; /* 0: interpolated from the corners of its cell, which have the same number and
	               * code */
};

/* A parametric resonance of the frequencies at rest: w_j + w_k = m Omega, or with sign -1 their
 * difference. */
struct hawser_tongue {
	int of[2]; /* j and k, from 0 */
	int sign, order; /* +-1; m */
	double at[2]; /* where it was met */
};
/* What the search for parametric instabilities could not tell. */
struct hawser_tongues {
	int count;
	struct hawser_tongue *item; /* [count] nowhere wider than round-off of the multipliers */
	int beyond; /* 1: tongues of an order above 12, which are not searched, may lie in the plane */
};

/* A change of the number or of the code along an edge of the grid of the requested resolution. */
struct hawser_map_boundary {
	double x, y;
	double width;  /* width of the bracket in the unit of the varying coordinate. The boundary, at
	                * which the growth is 0, is at most half of it away */
	int along;     /* the coordinate that varies: 0: x, 1: y */
	int number[2]; /* at the smaller value of this coordinate, and at the larger one */
	enum hawser_map_code code[2];
	const char *event;  /* of a map by rows: "fold", "torus", ..., and the width is that of its
	                     * location; "" where none was found between two points that differ, and
	                     * NULL in other maps */
	int branches[2];    /* of a map by rows: the numbers of responses on both sides */
};

struct hawser_map {
	int nx, ny;
	double *x, *y;                  /* [nx], [ny] */
	struct hawser_map_point *point; /* [ny][nx] */
	int boundaries, segments;
	struct hawser_map_boundary *boundary; /* [boundaries] */
	double *segment;                /* [segments][4] x, y of both ends of the segments that form the
	                                 * boundary lines */
	/* Of a map by rows, otherwise NULL: [ny][nx] the smallest and the largest amplitude of the
	 * responses that coexist at a point (with options->only_stable: of the stable ones), in the
	 * unit of the quantity; their number, and the number of those that are stable. The value of
	 * a point is the largest one, its number the smallest number of unstable multipliers among
	 * them. Where a response is one that a cable bears, slack ones do not count. */
	double *least, *most;           /* [ny][nx] */
	int *branches, *stable;         /* [ny][nx] */
	int incomplete;                 /* number of rows in which a curve could not be followed to its
	                                 * end: responses may be missing */
	char broken[320];               /* why, in the first of them */
	struct hawser_tongues narrow;
	long visited;                   /* number of points evaluated, including those on edges */
	long restored;                  /* how many of these were read from the checkpoint */
	int count[HAWSER_MAP_CODES];    /* number of evaluated points of each code */
	char reason[HAWSER_MAP_CODES][320]; /* message of the first point of each code, or "" */
	int interrupted;
	struct hawser_map_condensed condensed; /* of the points computed in this run */
};

/* Trace the map. Release with hawser_map_clear whatever the status. HAWSER_ERR_ARGUMENT: ranges,
 * counts, a checkpoint of another map. HAWSER_ERR_IO: the checkpoint cannot be written, is
 * damaged, or is in use by another process. HAWSER_ERR_CONVERGENCE: a point could not be
 * computed, and options->strict. HAWSER_ERR_MEMORY, and what the field's functions return. */
enum hawser_status hawser_map_trace(struct hawser_map *map, const struct hawser_map_field *field,
                                    const struct hawser_map_options *options,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_map_clear(struct hawser_map *map);

/* Join checkpoints from [count] of the same map in the new file `to`, which is complete or not
 * made. *points becomes the number of records: points, or of a map by rows the parts of rows.
 * HAWSER_ERR_ARGUMENT: a file is no checkpoint of a map, or of another map than the first, or in
 * use; `to` exists. HAWSER_ERR_IO, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_map_merge(long *points, const char *to, const char *const *from, int count,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

/* --- maps of cables --- */

/* A row of the table of quantities: the value of the map, and what its number counts. */
struct hawser_map_quantity {
	const char *name;    /* "growth", "multiplier", ... */
	const char *summary; /* one line */
	const char *unit;    /* "1/s", "1", "m" */
	const char *counts;  /* what the number counts: "growing modes", ... */
	int needs_omega, nonlinear, logarithmic;
};
/* Row `index` of the table, from 0; NULL beyond the last. Static storage. */
const struct hawser_map_quantity *hawser_map_quantity(int index);

/* A scene or a model (the other is NULL), and two parameters. A parameter is a key of the scene
 * (hawser_scene_key, in SI), "Omega" (rad/s; in the unit of the model if it has no scale),
 * "factor.load" (multiplies all harmonics) or "factor.damping" (multiplies the symmetric part of
 * D). */
struct hawser_map_source {
	const struct hawser_scene *scene;
	const struct hawser_rom *rom;
	const struct hawser_rom_source *file; /* of the model, whose parameters may be keys; or NULL */
	const char *key[2];    /* [2] of x and of y */
	double from[2], to[2]; /* [2] their ranges */
	double omega;          /* forcing frequency, unless "Omega" is one of the keys; 0: none */
	const char *quantity;
	double orbit;          /* relative tolerance of the responses of a map; 0: 1e-6 */
	int waves;             /* of a travelling cable: the coordinates are the span of its lowest complex
	                        * modes, so many (hawser_complex_modes_span); 0: the modes of the scene.
	                        * About a response, what follows the speed has then the first correction
	                        * for its inertia */
	int swapped;           /* 1: about a response without that correction, about rest with it: to
	                        * measure its effect */
	int rest;              /* 1: stability is that of rest. 0: with a forcing frequency it is that of
	                        * the periodic response that grows out of rest with the excitation,
	                        * where a load, moving ends or a fluctuating speed move the model */
	const struct hawser_map_start *start; /* of the quantity amplitude, or NULL */
};
/* The field of a scene with a travelling beam, over two numeric keys of its section: the quantity
 * "growth" or "unstable" of the `modes` eigenvalues of least modulus, with `functions` Legendre
 * functions (0: 24). The growth is scaled if the beam is, otherwise in 1/s. Statuses of
 * hawser_beam_eigenvalues; release with hawser_map_beam_close. */
enum hawser_status hawser_map_beam_open(struct hawser_map_field *field,
                                        const struct hawser_map_source *source, int modes,
                                        int functions, struct hawser_report *report)
	HAWSER_MUST_CHECK;
void hawser_map_beam_close(struct hawser_map_field *field);

/* The field of a span in a wind, over two keys of its scene but wind.speed: the quantity
 * critical-speed, the lowest speed up to twice wind.speed from which on one of the scene's modes
 * grows, all together. HAWSER_ERR_ARGUMENT, HAWSER_ERR_MEMORY; release with _close. */
enum hawser_status hawser_map_gallop_open(struct hawser_map_field *field,
                                          const struct hawser_map_source *source,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_map_gallop_close(struct hawser_map_field *field);

/* The field of a cable or a model. The source must outlive it; release with hawser_map_cable_close.
 * HAWSER_ERR_ARGUMENT (quantity, key, missing Omega, multipliers about rest of a model with the exact
 * energy),
 * HAWSER_ERR_SCENE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_map_cable_open(struct hawser_map_field *field,
                                         const struct hawser_map_source *source,
                                         struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_map_cable_close(struct hawser_map_field *field);

/* Where boundaries of stability cross a line along one axis. */
struct hawser_map_line {
	double other; /* the other coordinate */
	int count;
	double *at;   /* [count] ascending */
};
/* Error of boundaries by what their model leaves out. */
struct hawser_map_shift {
	int compared;    /* edges of unstable regions; 0: there was none on the lines */
	double distance; /* largest estimated error of one, in the unit of the axis, and */
	double share;    /* as a part of the width of its region */
};
/* Compare the edges of the widest region on each line [lines] along axis `along` (0: x, 1: y) with
 * those of the model of another source, of a scene with multipliers; the estimate is 1.5 times the
 * distance and, where source->waves is set, a part for what both models lack. Statuses of
 * hawser_map_cable_open and of a field's points. */
enum hawser_status hawser_map_shift(struct hawser_map_shift *to, const struct hawser_map_source *source,
                                    const struct hawser_map_source *better, int along,
                                    const struct hawser_map_line *line, int lines,
                                    struct hawser_report *report) HAWSER_MUST_CHECK;

#ifdef __cplusplus
}
#endif
#endif

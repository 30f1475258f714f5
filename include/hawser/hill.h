/* hawser/hill.h - where Hill's equation, a model under parametric excitation about rest, loses its
 * stability: boundaries in the plane of any two parameters, followed by continuation.
 *
 *   plus    a multiplier +1: motion of the excitation's period
 *   minus   a multiplier -1: of twice that
 *   torus   a complex pair leaves the unit circle: combination resonance, or flutter
 *
 * hawser/map.h fills the plane with cells instead, and brackets the boundary between them: more
 * evaluations, and nothing is missed that is wider than a cell. Here a boundary is followed from
 * where a line of search meets it, as precisely as the multipliers are known.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_HILL_H
#define HAWSER_HILL_H

#include <hawser/linear.h>
#include <hawser/map.h>

#ifdef __cplusplus
extern "C" {
#endif

enum hawser_hill_kind { HAWSER_HILL_PLUS = 0, HAWSER_HILL_MINUS, HAWSER_HILL_TORUS,
                       HAWSER_HILL_KINDS };
const char *hawser_hill_kind_name(enum hawser_hill_kind kind); /* "plus", "minus", "torus" */

/* Multipliers of m = 2n states at (x, y): log_modulus and argument [m]. */
struct hawser_hill_field {
	int m;
	const struct hawser_map_condensed *condensed; /* so far; or NULL */
	void *context;
	enum hawser_status (*multipliers)(void *context, double *log_modulus, double *argument,
	                                  double x,
	                                  double y, struct hawser_report *report);
	/* May be NULL: the model and the forcing frequency in the model's units at (x, y); they serve
	 * until the next call with the same `worker`, 0 to workers - 1. Boundaries are then zeros of
	 * determinants of Hill matrices, which takes a fraction of the time, and calls with different
	 * workers come from different threads. */
	enum hawser_status (*model)(void *context, const struct hawser_rom **rom, double *omega,
	                            int worker, double x, double y, struct hawser_report *report);
	int workers;
	int cheap; /* 1 x, 2 y: the axis along which models cost least, 0: neither */
	/* May be NULL: what the models at count points need is made, by so many threads. */
	enum hawser_status (*prepare)(void *context, const double *x, const double *y, int count,
	                              int threads, struct hawser_report *report);
};

struct hawser_hill_options {
	double from[2], to[2]; /* the rectangle */
	int lines, samples;    /* lines of search across it, points on each; 0: 9 and 240 */
	double step;           /* longest step, as a part of the rectangle; 0: 0.01 */
	double tolerance;      /* of a point, as a part of the rectangle; 0: 1e-14 */
	int max_points;        /* of a boundary; 0: 2000 */
	struct hawser_progress progress; /* called after each point or tongue */
};
void hawser_hill_settle(struct hawser_hill_options *options);

struct hawser_hill_boundary {
	enum hawser_hill_kind kind;
	int points, capacity;
	double *at; /* [points][2] x, y */
	int named;  /* 1: the order and, without damping, the side are known (hawser_mathieu_trace) */
	int order, upper;
};

/* A tongue of Mathieu's equation in the rectangle. */
struct hawser_hill_tongue {
	int order;
	double width[2]; /* of delta: least and most in the rectangle, as precise as delta however small */
	double opens;    /* least |epsilon| at which the damping leaves it open; infinite: none */
};

struct hawser_hill_chart {
	int boundaries;
	struct hawser_hill_boundary *boundary; /* [boundaries] */
	long evaluations;
	int interrupted;
	int tongues;
	struct hawser_hill_tongue *tongue; /* [tongues] of hawser_mathieu_trace, by order */
	double truncation;                 /* of the same: relative, of delta */
};

/* HAWSER_ERR_ARGUMENT (ranges, counts), HAWSER_ERR_MEMORY, and what the field returns. Release with
 * hawser_hill_clear. */
enum hawser_status hawser_hill_trace(struct hawser_hill_chart *chart,
                                     const struct hawser_hill_field *field,
                                     const struct hawser_hill_options *options,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_hill_clear(struct hawser_hill_chart *chart);

/* Unstable multipliers at points of a field, for a picture or a check. Statuses of the field and
 * HAWSER_ERR_MEMORY; release with hawser_hill_counter_free. The field has to outlive it. */
struct hawser_hill_counter;
enum hawser_status hawser_hill_counter_open(struct hawser_hill_counter **counter,
                                            const struct hawser_hill_field *field,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
/* unstable [count]: how many multipliers are outside the unit circle by more than their errors at
 * (x, y), [count] each. Where fast coordinates can be condensed and the answer is clear without
 * them, those of the others. */
enum hawser_status hawser_hill_count(struct hawser_hill_counter *counter, int *unstable,
                                     const double *x, const double *y, int count,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_hill_counter_free(struct hawser_hill_counter *counter);

/* The field of a scene or a model over two of its parameters: hawser_map_source, of which
 * `quantity` is not read. Statuses of hawser_map_cable_open. */
enum hawser_status hawser_hill_cable_open(struct hawser_hill_field *field,
                                          const struct hawser_map_source *source,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_hill_cable_close(struct hawser_hill_field *field);

/* --- Mathieu's equation  x'' + 2 c x' + (delta + 2 epsilon cos 2t) x = 0 --- */

/* The field over (delta, epsilon), `damping` is c. */
enum hawser_status hawser_mathieu_open(struct hawser_hill_field *field, double damping,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_mathieu_close(struct hawser_hill_field *field);

/* The boundaries over (delta, epsilon) as eigenvalues of the Hill matrices: those of every tongue
 * in the rectangle, however narrow. Of the options rectangle, step, max_points and progress are
 * read. HAWSER_ERR_ARGUMENT, HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. Release with
 * hawser_hill_clear. */
enum hawser_status hawser_mathieu_trace(struct hawser_hill_chart *chart, double damping,
                                        const struct hawser_hill_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* *delta, a characteristic value without damping, as eigenvalue of the Hill matrix: even (a_r, r
 * >= 0) or odd (b_r, r >= 1); r <= 1000, |epsilon| < 1e4. HAWSER_ERR_ARGUMENT,
 * HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_mathieu_value(double *delta, int r, int odd, double epsilon,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* *distance, of delta from a characteristic value next to it, by elimination from both ends of the
 * Hill matrix: a check of a boundary that does not use eigenvalues. Its relative error is of the
 * order of distance/gap, with the gap to the next value of the same kind. HAWSER_ERR_ARGUMENT,
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser_mathieu_distance(double *distance, double delta, int r, int odd,
                                           double epsilon,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* The expansions to second order in epsilon: Bertrand 2022, (G.12) to (G.33), corrected or as
 * printed. */
double hawser_mathieu_expansion(int r, int odd, double epsilon, int printed);

#ifdef __cplusplus
}
#endif
#endif

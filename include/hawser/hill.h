/* hawser/hill.h - stability boundaries of Hill's equation, that is of a linear model under parametric
 * excitation, in the plane of any two parameters, followed by continuation.
 *
 *   plus    a multiplier is +1: the critical motion has the period of the excitation
 *   minus   a multiplier is -1: the critical motion has twice this period
 *   torus   a complex pair leaves the unit circle: combination resonance, or flutter
 *
 * Boundaries start where search lines across the rectangle cross them, and are as accurate as the
 * multipliers. The maps of hawser/map.h cover the rectangle with cells and bracket the boundaries
 * between them: they need more evaluations, but miss nothing that is wider than a cell.
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

/* The multipliers as functions of the two parameters x and y. */
struct hawser_hill_field {
	int m; /* number of multipliers: 2n for n coordinates */
	int responds; /* 1: about the periodic response, where something moves the model; 0: about rest */
	const struct hawser_map_condensed *condensed; /* statistics of all calls so far; or NULL */
	void *context;
	/* If `responds`, HAWSER_ERR_CONVERGENCE of `multipliers` and `model` is that of the point: the
	 * search goes on beside it.
	 * Computes the logarithm of the modulus and the argument of each multiplier, [m], at (x, y). */
	enum hawser_status (*multipliers)(void *context, double *log_modulus, double *argument,
	                                  double x,
	                                  double y, struct hawser_report *report);
	/* Makes the model and the forcing frequency, in the units of the model, at (x, y). Both are valid
	 * until the next call with the same `worker`, 0 to workers - 1; calls with different workers come
	 * from different threads. May be NULL. If it is not, boundaries are computed as zeros of
	 * determinants of Hill matrices, which is several times faster than from multipliers. */
	enum hawser_status (*model)(void *context, const struct hawser_rom **rom, double *omega,
	                            int worker, double x, double y, struct hawser_report *report);
	int workers;
	int cheap; /* the parameter along which models are cheapest to make: 1: x, 2: y, 0: neither */
	/* Computes with so many threads what the models at the points x, y [count] have in common, such
	 * as modes. May be NULL. */
	enum hawser_status (*prepare)(void *context, const double *x, const double *y, int count,
	                              int threads, struct hawser_report *report);
};

struct hawser_hill_options {
	double from[2], to[2]; /* the rectangle */
	int lines, samples;    /* search lines in each direction, and intervals on each; 0: 9 and 240 */
	double step;           /* longest step, relative to the rectangle; 0: 0.01 */
	double tolerance;      /* error of a point, relative to the rectangle; 0: 1e-14 */
	int max_points;        /* of a boundary; 0: 20/step, at least 2000 */
	struct hawser_progress progress; /* called after each point or tongue */
};
void hawser_hill_settle(struct hawser_hill_options *options);

struct hawser_hill_boundary {
	enum hawser_hill_kind kind;
	int points, capacity;
	double *at; /* [points][2] x, y */
	int limited; /* 1: it was not followed to its end: options.max_points */
	int named;  /* 1: `order` and `upper` are known (hawser_mathieu_trace) */
	int order;  /* order of the tongue that this boundary limits */
	int upper;  /* without damping: 1: the side of larger delta, 0: that of smaller delta */
};

/* A tongue of Mathieu's equation in the rectangle. */
struct hawser_hill_tongue {
	int order;
	double width[2]; /* smallest and largest width in delta within the rectangle; its relative error
	                  * does not grow as the width becomes small */
	double opens;    /* smallest |epsilon| at which the tongue exists with the given damping; infinite:
	                  * it does not exist in the rectangle */
};

struct hawser_hill_chart {
	int boundaries;
	struct hawser_hill_boundary *boundary; /* [boundaries] */
	long evaluations;
	int interrupted;
	long missed;    /* points at which no response was found: it has a fold, or was lost */
	char why[320];  /* at one of them */
	struct hawser_tongues narrow;
	int tongues;
	struct hawser_hill_tongue *tongue; /* [tongues] by order; of hawser_mathieu_trace only */
	double truncation;                 /* relative truncation error of delta; likewise */
};

/* Trace the boundaries. Release with hawser_hill_clear. HAWSER_ERR_ARGUMENT (ranges, counts),
 * HAWSER_ERR_MEMORY, and the statuses of the field's functions. */
enum hawser_status hawser_hill_trace(struct hawser_hill_chart *chart,
                                     const struct hawser_hill_field *field,
                                     const struct hawser_hill_options *options,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_hill_clear(struct hawser_hill_chart *chart);

/* Counts unstable multipliers at points of a field, for a picture or a check. The field must outlive
 * the counter; release it with hawser_hill_counter_free. Statuses of the field's functions, and
 * HAWSER_ERR_MEMORY. */
struct hawser_hill_counter;
enum hawser_status hawser_hill_counter_open(struct hawser_hill_counter **counter,
                                            const struct hawser_hill_field *field,
                                            struct hawser_report *report) HAWSER_MUST_CHECK;
/* unstable [count]: number of multipliers that are outside the unit circle by more than their errors,
 * at the points x, y [count]; -1: no response was found there. If fast coordinates can be condensed
 * and the count is certain without them, the condensed model is used. */
enum hawser_status hawser_hill_count(struct hawser_hill_counter *counter, int *unstable,
                                     const double *x, const double *y, int count,
                                     struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_hill_counter_free(struct hawser_hill_counter *counter);

/* Make the field of a scene or a model over two of its parameters. `quantity` of the source is not
 * read. Statuses of hawser_map_cable_open. */
enum hawser_status hawser_hill_cable_open(struct hawser_hill_field *field,
                                          const struct hawser_map_source *source,
                                          struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_hill_cable_close(struct hawser_hill_field *field);

/* --- Mathieu's equation  x'' + 2 c x' + (delta + 2 epsilon cos 2t) x = 0 --- */

/* Make the field of Mathieu's equation over x = delta and y = epsilon; `damping` is c. */
enum hawser_status hawser_mathieu_open(struct hawser_hill_field *field, double damping,
                                       struct hawser_report *report) HAWSER_MUST_CHECK;
void hawser_mathieu_close(struct hawser_hill_field *field);

/* Compute the boundaries over (delta, epsilon) as eigenvalues of the Hill matrices. All tongues in the
 * rectangle are found, however narrow they are. The options `lines`, `samples` and `tolerance` are
 * not read. HAWSER_ERR_ARGUMENT, HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. Release with
 * hawser_hill_clear. */
enum hawser_status hawser_mathieu_trace(struct hawser_hill_chart *chart, double damping,
                                        const struct hawser_hill_options *options,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* *delta becomes a characteristic value without damping, an eigenvalue of the Hill matrix: a_r (odd =
 * 0, r >= 0) or b_r (odd = 1, r >= 1); r <= 1000, |epsilon| < 1e4. HAWSER_ERR_ARGUMENT,
 * HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_mathieu_value(double *delta, int r, int odd, double epsilon,
                                        struct hawser_report *report) HAWSER_MUST_CHECK;

/* *distance becomes the difference of delta and the characteristic value near it, computed by
 * elimination from both ends of the Hill matrix. It checks a boundary without the use of eigenvalues.
 * Its relative error is of the order of distance/gap, where gap is the difference to the next
 * characteristic value of the same kind. HAWSER_ERR_ARGUMENT, HAWSER_ERR_MEMORY. */
enum hawser_status hawser_mathieu_distance(double *distance, double delta, int r, int odd,
                                           double epsilon,
                                           struct hawser_report *report) HAWSER_MUST_CHECK;

/* A characteristic value expanded to second order in epsilon, Bertrand 2022, (G.12) to (G.33):
 * corrected (printed = 0, doc/errata.md), or as printed there (1). */
double hawser_mathieu_expansion(int r, int odd, double epsilon, int printed);

#ifdef __cplusplus
}
#endif
#endif

/* study/hill/hill.h - shared parts of the continuation of stability boundaries: test functions of the
 * multipliers (hill_test.c) and of a boundary (hill_track.c), steps (hill.c), starting points
 * (hill_seed.c), search lines (hill_lines.c).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_HILL_H
#define HAWSER_STUDY_HILL_H

#include <hawser/hill.h>

#include "continuation/false_position.h"
#include "core/progress.h"
#include "response/floquet/hill_matrix.h"
#include "study/map/ridge.h"

/* The workspace of a thread. */
struct hawser__hill_worker {
	int number;
	int m;                          /* number of multipliers of the last point */
	double *log_modulus, *argument; /* [field->m] */
	double *work;                   /* [3 field->m] */
	int *used;                      /* [field->m] */
	double *memory;
	struct hawser_linear *linear;   /* NULL: the field has no models */
	struct hawser__hill_matrix matrix;
	double *part;                   /* K and D of a part of the model */
	size_t part_room;
	long evaluations, missed;
	char why[320];                  /* where a response was missed */
	enum hawser_status status;      /* first status that is not HAWSER_OK */
	struct hawser_report report;
};

struct hawser__hill {
	const struct hawser_hill_field *field;
	const struct hawser_hill_options *options;
	struct hawser_hill_chart *chart;
	struct hawser__hill_worker *worker; /* [threads] */
	int threads;
	int backwards;                  /* 1: the boundary is followed in reverse */
	struct hawser__span span;       /* the part that is done: of the search lines */
	struct hawser__ridge_log tongues;
	enum hawser_status status;      /* first status that is not HAWSER_OK */
	struct hawser_report *report;
};

/* The test function of one boundary, continuous along it, with a simple zero on it. */
enum hawser__track_by {
	HAWSER__BY_MULTIPLIERS, /* hill_test.c */
	HAWSER__BY_DETERMINANT, /* of the Hill matrix, of multipliers +1 and -1 */
	HAWSER__BY_GROWTH,      /* the real part of an exponent: torus, with damping */
	HAWSER__BY_EXTREMUM     /* the determinant between two exponents: torus, without damping */
};

struct hawser__hill_track {
	int kind;
	enum hawser__track_by by;
	int part;         /* a coordinate of the part of the model whose determinant it is: coordinates that
	                   * are not coupled do not disturb each other then */
	double lambda[2]; /* the exponent divided by Omega */
	double slope[2];  /* derivative of the determinant by lambda/Omega; 0: not known */
	int exponent;     /* determinants are divided by 2 to this power */
	int known;        /* 1: `exponent` is known */
	int harmonics;    /* number of harmonics for this root; 0: to be determined */
	double noise;     /* round-off of the last value; 0: not known */
	double rise;      /* slope of the function to the left of the boundary; 0: not known */
	double drift;     /* of lambda[1], to the left of the boundary */
	double turn;      /* of lambda[1], along the boundary */
	double ahead;     /* expected change of lambda[1] in the next step */
};

/* --- hill_test.c: test functions of the worker's multipliers --- */

double hawser__hill_test(struct hawser__hill_worker *worker, int kind);
/* Number of complex multipliers outside the unit circle. */
int hawser__hill_outside(const struct hawser__hill_worker *worker);
/* *argument of the complex pair that is nearest to the unit circle, without damping of those off it.
 * Returns 0 if there is none. */
int hawser__hill_pair(const struct hawser__hill_worker *worker, double *argument);
int hawser__hill_undamped(const struct hawser__hill_worker *worker);
/* Whether the two exponents of this pair have left each other by far less than their distance from all
 * others; 1 with damping. */
int hawser__hill_alone(const struct hawser__hill_worker *worker);

/* --- hill_track.c: at a point of the rectangle, 0 to 1 --- */

/* Compute the multipliers, strict or rough (response/floquet/linear_margin.h); rough ones only
 * if the field has models. */
enum hawser_status hawser__hill_multipliers(struct hawser__hill *hill,
                                            struct hawser__hill_worker *worker,
                                            const double at[2], int rough);
/* What ridge.h reads of a point, [HAWSER__EXPONENTS(n)], and the number of multipliers outside the
 * unit circle, strict or rough; only if the field has models. */
enum hawser_status hawser__hill_exponents(struct hawser__hill *hill,
                                          struct hawser__hill_worker *worker, int *unstable,
                                          double *to, const double at[2], int rough);
/* From the rectangle to the parameters of the caller. */
void hawser__hill_to_caller(double out[2], const struct hawser__hill *hill, const double at[2]);
/* The test function of a track; NAN if it is not defined there or hill->status is set. */
double hawser__hill_value(struct hawser__hill *hill, struct hawser__hill_track *track,
                          const double at[2]);
/* The root *s on from + s*along, within `reach`, of a track with HAWSER__BY_GROWTH at which the
 * function increases, together with the imaginary part of the exponent. Returns 0 if none is found:
 * the track is then as before. */
int hawser__hill_newton(struct hawser__hill *hill, struct hawser__hill_track *track, double *s,
                        const double from[2], const double along[2], double reach);
/* Choose the test function of the boundary near `at`, for a torus on its unstable side; the strict
 * multipliers if no determinant can be used. Returns 0 if there is no boundary, since the product of
 * two real multipliers is 1; or if hill->status is set. */
int hawser__hill_choose(struct hawser__hill *hill, struct hawser__hill_track *track, int kind, int part,
                        const double at[2]);
/* Whether no coordinate before `part` is coupled to it. */
int hawser__hill_is_first(struct hawser__hill *hill, int part, const double at[2]);

/* --- hill.c --- */

double hawser__hill_root(struct hawser__hill *hill, struct hawser__hill_track *track,
                         const double from[2], const double along[2], struct hawser__bracketed in);
void hawser__hill_follow(struct hawser__hill *hill, struct hawser_hill_boundary *boundary,
                         struct hawser__hill_track *track, double way[2]);
/* Without damping the discriminant is also 0 where two pairs pass each other on the circle without
 * leaving it. Returns whether multipliers leave the circle on the right of a boundary, at the
 * distance `beside`; 1 for all other kinds. */
int hawser__hill_real(struct hawser__hill *hill, const struct hawser__hill_track *track,
                      const double at[2], const double way[2], double beside);
int hawser__hill_known(const struct hawser__hill *hill, int kind, const double at[2],
                       const double way[2]);
enum hawser_status hawser__hill_append(struct hawser_hill_boundary *boundary, const double at[2],
                                       struct hawser_report *report);

/* --- hill_lines.c --- */

struct hawser__hill_line {
	double from[2], along[2];
	int samples;
	double *g; /* [samples + 1][HAWSER_HILL_KINDS] */
};

/* Prepare the models of the samples of a line, or of `places` other places on it. */
enum hawser_status hawser__hill_prepare(struct hawser__hill *hill,
                                        const struct hawser__hill_line *line,
                                        const double *place, int places);
/* Allocate the workers of hill->field; a field without models has one. */
enum hawser_status hawser__hill_open(struct hawser__hill *hill);
void hawser__hill_close(struct hawser__hill *hill);

/* Report progress: number of complete boundaries, and of points of the next. Returns the answer of
 * the caller's function. */
int hawser__hill_told_to_stop(const struct hawser_hill_options *options, int boundaries, int points,
                              struct hawser__span *span);

/* Check the options of a trace: HAWSER_ERR_ARGUMENT. */
enum hawser_status hawser__hill_check(const struct hawser_hill_options *options,
                                      struct hawser_report *report);

/* --- hill_seed.c --- */

/* A change of sign between lo and hi: find its boundary. */
void hawser__hill_try(struct hawser__hill *hill, int kind, const struct hawser__hill_line *line,
                      double lo, double hi);
/* The same in the part of the model with coordinate `part`, between s, where a multiplier with the
 * exponent lambda Omega is outside the circle, and `out`, where it is inside. Returns 0 if there is
 * none. */
int hawser__hill_side(struct hawser__hill *hill, int kind, int part, const double lambda[2],
                      const struct hawser__hill_line *line, double s, double out);
/* Without models: the middle of three samples of the same sign is the smallest: find a pair of roots
 * between them, if there is one. */
void hawser__hill_between(struct hawser__hill *hill, int kind, const struct hawser__hill_line *line,
                          double lo, double hi, double sign);

/* --- hill_ridges.c --- */

/* Find the tongues on a line that its samples do not show, and follow their boundaries. */
void hawser__hill_ridges(struct hawser__hill *hill, const struct hawser__hill_line *line);

/* --- mathieu.c: values of delta at which Mathieu's equation has a multiplier +1 or -1, from its
 * Hill matrices, with full precision for any width of a tongue ---
 *
 * r    order of a tongue: at its boundaries the harmonic r of the motion is the largest; the
 * multiplier is +1 if r is even, -1 if it is odd. Tongue 0 is the region of negative stiffness
 * and has an upper boundary only */

struct hawser__tongue {
	double edge[2]; /* delta of the lower and of the upper boundary; of tongue 0 the upper one
	                 * twice */
	double width;   /* its relative error is that of round-off, however small the width is */
	double truncation; /* if requested: change of an edge by eight further harmonics */
	int open;       /* 0: with this damping the tongue does not exist */
};

/* Compute tongue r at epsilon, with damping c >= 0; `certain`: also its truncation error.
 * HAWSER_ERR_CONVERGENCE, HAWSER_ERR_MEMORY. */
enum hawser_status hawser__mathieu_tongue(struct hawser__tongue *tongue, int r, double epsilon,
                                          double c, int certain, struct hawser_report *report);

/* The highest harmonic required for boundary r at epsilon. */
int hawser__mathieu_highest(int r, double epsilon);

/* *delta becomes the boundary without damping whose motion is even or odd in the standard form, an
 * eigenvalue of the Hill matrix of the harmonics up to top. HAWSER_ERR_CONVERGENCE,
 * HAWSER_ERR_MEMORY. */
enum hawser_status hawser__mathieu_eigenvalue(double *delta, int r, int odd, double epsilon, int top,
                                              struct hawser_report *report);

#endif

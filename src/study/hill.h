/* study/hill.h - the parts of boundaries by continuation: test functions of the multipliers
 * (hill_test.c) and of a boundary that is followed (hill_track.c), steps (hill.c), where
 * boundaries begin (hill_seed.c), the lines of search (hill_lines.c).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_HILL_H
#define HAWSER_STUDY_HILL_H

#include <hawser/hill.h>

#include "response/hill_matrix.h"

/* What one thread works with. */
struct hawser__hill_worker {
	int number;
	int m;                          /* multipliers at hand: of the last point */
	double *log_modulus, *argument; /* [field->m] */
	double *work;                   /* [3 field->m] */
	int *used;                      /* [field->m] */
	double *memory;
	struct hawser_linear *linear;   /* NULL: the field gives no models */
	struct hawser__hill_matrix matrix;
	long evaluations;
	enum hawser_status status;      /* the first that is not HAWSER_OK */
	struct hawser_report report;
};

struct hawser__hill {
	const struct hawser_hill_field *field;
	const struct hawser_hill_options *options;
	struct hawser_hill_chart *chart;
	struct hawser__hill_worker *worker; /* [threads] */
	int threads;
	int backwards;                  /* the boundary is followed against its sense */
	double began;                   /* s, hawser__wall_seconds */
	enum hawser_status status;      /* the first that is not HAWSER_OK */
	struct hawser_report *report;
};

/* The test function of one boundary, continuous along it, with a simple zero on it. */
enum hawser__track_by {
	HAWSER__BY_MULTIPLIERS, /* hill_test.c */
	HAWSER__BY_DETERMINANT, /* of the Hill matrix, of multipliers +1 and -1 */
	HAWSER__BY_GROWTH       /* real part of one exponent: torus, with damping */
};

struct hawser__track {
	int kind;
	enum hawser__track_by by;
	double lambda[2]; /* the exponent over Omega */
	double slope[2];  /* of the determinant over lambda/Omega; 0: not known */
	int exponent;     /* by 2^which determinants are divided */
	int known;        /* `exponent` is */
	int harmonics;    /* of this root; 0: to be found */
	double noise;     /* round-off of the last value; 0: not known */
	double rise;      /* of the function to the left of the boundary; 0: not known */
};

/* --- hill_test.c: of the worker's multipliers --- */

double hawser__hill_test(struct hawser__hill_worker *worker, int kind);
/* Complex multipliers outside the circle. */
int hawser__hill_outside(const struct hawser__hill_worker *worker);
/* *argument of the complex pair that is nearest to the circle. 0: there is none. */
int hawser__hill_pair(const struct hawser__hill_worker *worker, double *argument);
int hawser__hill_undamped(const struct hawser__hill_worker *worker);

/* --- hill_track.c: at a point of the rectangle, 0 to 1 --- */

/* Multipliers, strict or rough (response/linear_margin.h); rough ones only where the field gives
 * models. */
enum hawser_status hawser__hill_multipliers(struct hawser__hill *hill,
                                            struct hawser__hill_worker *worker,
                                            const double at[2], int rough);
/* The function of a track; not a number where it has none there, or hill->status is set. */
double hawser__hill_value(struct hawser__hill *hill, struct hawser__track *track,
                          const double at[2]);
/* Choose how the boundary near `at` is followed; strict multipliers where nothing better is to be
 * had. 0: there is none, as the product of two real multipliers is 1; or hill->status is set. */
int hawser__hill_choose(struct hawser__hill *hill, struct hawser__track *track, int kind,
                        const double at[2]);

/* --- hill.c --- */

double hawser__hill_root(struct hawser__hill *hill, struct hawser__track *track,
                         const double from[2], const double along[2],
                         double lo, double hi, double g_lo, double g_hi);
void hawser__hill_follow(struct hawser__hill *hill, struct hawser_hill_boundary *boundary,
                         struct hawser__track *track, double way[2]);
/* Without damping the discriminant is 0 as well where two pairs pass each other on the circle.
 * Whether on the right of a boundary, `beside` away, multipliers are off the circle; 1 for all
 * other kinds. */
int hawser__hill_real(struct hawser__hill *hill, const struct hawser__track *track,
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

/* The workers of hill->field, one of a field without models. */
enum hawser_status hawser__hill_open(struct hawser__hill *hill);
void hawser__hill_close(struct hawser__hill *hill);

/* The caller's answer, told that so many boundaries are complete and the next has so many points.
 * */
int hawser__hill_told_to_stop(const struct hawser_hill_options *options, int boundaries, int points,
                              double began);

/* Of the options of a trace: HAWSER_ERR_ARGUMENT. */
enum hawser_status hawser__hill_check(const struct hawser_hill_options *options,
                                      struct hawser_report *report);

/* --- hill_seed.c --- */

/* A change of sign between lo and hi. */
void hawser__hill_try(struct hawser__hill *hill, int kind, const struct hawser__hill_line *line,
                      double lo, double hi);
/* Between three samples of one sign the middle one is the smallest: is there a place of the other
 * sign? */
void hawser__hill_between(struct hawser__hill *hill, int kind, const struct hawser__hill_line *line,
                          double lo, double hi, double sign);

#endif

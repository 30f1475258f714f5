/* study/identify/half_power.h - what half_power.c and the fits of half_power_one.c and
 * half_power_pair.c share; its glossary is in half_power.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_HALF_POWER_H
#define HAWSER_STUDY_HALF_POWER_H

#include <complex.h>

/* Unknowns: of a parabola; of two modes of one ratio; of two modes with two ratios, or of a parabola
 * with what adds to it; of a quotient of polynomials. */
enum { HAWSER__HALF_PARABOLA = 3, HAWSER__HALF_EQUAL = 5, HAWSER__HALF_SHAPES = 6,
       HAWSER__HALF_MOST = 7 };

struct hawser__half_table {
	const double *omega, *a; /* [count] */
	int count, best;         /* best: index of the largest amplitude */
	double confidence;
};

struct hawser__half_span {
	int first, last;
};

struct hawser__half_fit {
	double zp, D, ratio;
	double zp_error, ratio_error;
	double apart;   /* half the difference of the ratios of two modes */
	double hidden;  /* what the difference may be that noise hides, of two modes of one ratio */
	double sum;     /* of the squares of a pair's residuals */
	double both;    /* error of the mean that contains both ratios of two modes with their intervals */
	double lag;     /* correlation of neighbouring residuals */
	double noise;   /* `scatter` where it is random, or 0 */
	double scatter; /* standard deviation of a point, relative to the largest amplitude */
};

/* Adds a row, its right side last, to R by Givens rotations. */
void hawser__half_join(double R[HAWSER__HALF_MOST][HAWSER__HALF_MOST + 1],
                       double row[HAWSER__HALF_MOST + 1], int count);
/* The solution p [count] of these rows. */
void hawser__half_solve(double *p, const double R[HAWSER__HALF_MOST][HAWSER__HALF_MOST + 1], int count);
/* |R^-T g|: the standard deviation of a quantity with the gradient g [count] if that of the points is
 * 1. */
double hawser__half_spread(const double R[HAWSER__HALF_MOST][HAWSER__HALF_MOST + 1],
                           const double *g, int count);

/* What adds to the parabola: nothing, or modes farther away and a bend. */
enum hawser__half_others { HAWSER__HALF_NONE, HAWSER__HALF_SMOOTH };

/* Fit 1/a^2 by functions of x = (z - zc)/h. Returns 0 if the parabola is not that of an oscillator. */
int hawser__half_shapes(struct hawser__half_fit *fit, const struct hawser__half_table *table,
                        struct hawser__half_span span, enum hawser__half_others others, double zc,
                        double h);

/* How far the ratios of two modes may be from that of the one that is fitted, whose scatter hides
 * them. */
double hawser__half_hidden(const struct hawser__half_fit *fit, const struct hawser__half_table *table,
                           struct hawser__half_span span);

/* Sums of the residuals r, and of products of neighbours. */
struct hawser__half_residuals {
	double sum, lag, before;
};

static inline void hawser__half_add(struct hawser__half_residuals *residuals, double r)
{
	residuals->sum += r*r;
	residuals->lag += r*residuals->before;
	residuals->before = r;
}

/* Standard deviation of a point of `count`. */
double hawser__half_deviation(const struct hawser__half_residuals *residuals, int count, int unknowns);

struct hawser__half_pair_of {
	const struct hawser__half_table *table;
	struct hawser__half_span span;
	double wp, ratio; /* of the parabola */
	int unknowns;     /* HAWSER__HALF_EQUAL or HAWSER__HALF_SHAPES */
	const double *held; /* where q2 does not vary, its value; the unknowns are then q0, q1, q3, q4 */
};

/* Fit two modes: from q or, with the fewer unknowns, from anywhere. Returns 0 if there is no fit. */
int hawser__half_pair(double q[HAWSER__HALF_SHAPES], struct hawser__half_fit *two,
                      struct hawser__half_pair_of *pair, int unknowns);

/* The least and the greatest ratio of pairs of one ratio that fit as well as q, the best one, with the
 * sum of squares `sum`; up to a distance that is more than an error may be. */
void hawser__half_reach(double reach[2], const double q[HAWSER__HALF_SHAPES], double sum,
                        const struct hawser__half_pair_of *pair);

/* Where to fit two modes from, by a quotient of polynomials, which needs no guess
 * (half_power_quotient.c). Returns 0 if the quotient has not two resonances. */
int hawser__half_quotient(double q[HAWSER__HALF_SHAPES], const struct hawser__half_pair_of *pair);
/* The sum of two modes at w, relative to the largest amplitude, and its derivatives by q. */
double complex hawser__half_pair_at(double complex by[HAWSER__HALF_SHAPES],
                                    const struct hawser__half_pair_of *pair, const double *q, double w);

#endif

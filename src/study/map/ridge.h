/* study/map/ridge.h - the least stable point on a line through a tongue of parametric instability.
 *
 *    resonance   w_j + w_k = m Omega, or w_j - w_k = m Omega, with the frequencies w at rest
 *    a, b        the two multipliers that meet there: log a = i w_j T, log b = -i w_k T (difference:
 *                i w_k T), T = 2 pi/Omega
 *    Q           ((log a - log b)/T)^2, its real part
 *    t           position on the line
 *    ridge       the curve of these points in a plane of parameters
 *
 * Outside a tongue a and b have different arguments, inside it they have the same and different
 * moduli ("locked"). With the detuning r = w_j + w_k - m Omega, the coupling c and a difference h of
 * the rates of damping,
 *
 *      Q = h^2 + 4 c^2 - r^2,    growth = (log |a b|)/(2 T) + sqrt(Q)/2
 *
 * While the moduli have a corner at the edge of the locked part, and the arguments are constant in
 * it, Q is smooth across both: a parabola in t, whose vertex is the point of largest growth. With
 * damping the unstable part is narrower than the locked part, or empty: it is found or excluded by
 * a few points wherever these lie, and however narrow it is.
 *
 * Where the motion is large it displaces the frequencies, by more than their distances: a resonance is
 * then looked for where two multipliers meet by their arguments and rates at two points
 * (ridge_find.c), whatever the frequencies at rest.
 *
 * Reference: Yakubovich and Starzhinskii, Linear Differential Equations with Periodic Coefficients.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_STUDY_RIDGE_H
#define HAWSER_STUDY_RIDGE_H

#include <hawser/map.h>

#include "response/floquet/linear_margin.h"

/* w_j + sign w_k = m Omega, coordinates j <= k. */
struct hawser__combination {
	int j, k, sign, m;
	/* by courses: the argument at which two multipliers meet, and their rates by t; 0: by the
	 * frequencies at rest */
	double angle, turn[2];
};

struct hawser__ridge {
	struct hawser__combination of;
	double slope;           /* of the detuning r by t */
	double low, high;       /* range of t */
	double at;              /* the next point */
	double origin, anchor[2]; /* the arguments of both multipliers at the latest one */
	double place[3], Q[3];  /* the last points, the latest first */
	int points;
	double mean;            /* (log |a b|)/(2 T) at the latest */
	double growth, angle;   /* of the less stable of a and b there: (log |a|)/T and its argument */
	double centre, top;     /* vertex of the parabola, and Q there */
	double before;          /* the former Q of the vertex */
	int clamped;
};

/* The same with t in units of which the edge has `length`. */
struct hawser__combination hawser__combination_on(const struct hawser__combination *of, double length);

enum hawser__ridge_state {
	HAWSER__RIDGE_GOES_ON,
	HAWSER__RIDGE_CLOSED,     /* stable at the least stable point */
	HAWSER__RIDGE_UNRESOLVED, /* unstable by less than the multipliers tell */
	HAWSER__RIDGE_LOST        /* there is no vertex in the range */
};

enum { HAWSER__RIDGE_HIGHEST = 12 }; /* largest m that is searched; chosen */

/* Two points at distance 1 with exponents [HAWSER__EXPONENTS(n)], and one near each. */
struct hawser__ridge_edge {
	const double *end[2], *near[2]; /* near: at t = step[0], 1 + step[1]; NULL: none */
	double step[2];
	int n;
};

/* Call `found` for each resonance between the points, with its t and the slope of its detuning. Returns
 * the first status other than HAWSER_OK. *above: set to 1 if there are others with
 * m > HAWSER__RIDGE_HIGHEST. */
struct hawser__ridge_taker {
	enum hawser_status (*found)(void *context, const struct hawser__combination *of, double t,
	                            double slope, struct hawser_report *report);
	void *context;
};
enum hawser_status hawser__ridge_find(const struct hawser__ridge_edge *edge, int *above,
                                      const struct hawser__ridge_taker *taker,
                                      struct hawser_report *report);

/* Begin at ridge->at with of, slope, low and high; all else zero. Then: the exponents of the point
 * ridge->at. While the state is _GOES_ON, the next one is in ridge->at. */
enum hawser__ridge_state hawser__ridge_take(struct hawser__ridge *ridge, const double *exponents,
                                            int n);
/* Half the width of the unstable part by the parabola; 0: there is none. */
double hawser__ridge_half(const struct hawser__ridge *ridge);

/* The resonances of a plane whose tongue was found, or could not be told from round-off. */
struct hawser__ridge_log {
	struct hawser_tongue *item; /* [count] each resonance once */
	unsigned char *found;       /* [count] */
	size_t count;
	int above;                  /* 1: there are others with m > HAWSER__RIDGE_HIGHEST */
};
/* `at`: x and y. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__ridge_note(struct hawser__ridge_log *log,
                                      const struct hawser__combination *of, int found,
                                      const double at[2], struct hawser_report *report);
/* Move the resonances that were not found to *to, whose array the caller frees. Clears the log. */
void hawser__ridge_unresolved(struct hawser_tongues *to, struct hawser__ridge_log *log);

#endif

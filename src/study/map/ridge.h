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
 * Where the motion is large it displaces the frequencies: a resonance is also looked for by the
 * arguments of the multipliers at two points, each pair of which is given to the frequency at rest from
 * which it is displaced alike at both, and the least.
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
	double moved[2]; /* what the motion adds to w_j and w_k near the line; 0: not known */
};

struct hawser__ridge {
	struct hawser__combination of;
	double slope;           /* of the detuning r by t */
	double low, high;       /* range of t */
	double at;              /* the next point */
	double place[3], Q[3];  /* the last points, the latest first */
	int points;
	double mean;            /* (log |a b|)/(2 T) at the latest */
	double growth, angle;   /* of the less stable of a and b there: (log |a|)/T and its argument */
	double centre, top;     /* vertex of the parabola, and Q there */
	int clamped;
};

enum hawser__ridge_state {
	HAWSER__RIDGE_GOES_ON,
	HAWSER__RIDGE_CLOSED,     /* stable at the least stable point */
	HAWSER__RIDGE_UNRESOLVED, /* unstable by less than the multipliers tell */
	HAWSER__RIDGE_LOST        /* there is no vertex in the range */
};

enum { HAWSER__RIDGE_HIGHEST = 12 }; /* largest m that is searched; chosen */

/* Call `found` for each resonance on the line between two points at distance 1 with exponents a and b
 * [HAWSER__EXPONENTS(n)], with its t and the slope of its detuning. Returns the first status other
 * than HAWSER_OK. *above: set to 1 if there are others with m > HAWSER__RIDGE_HIGHEST. */
struct hawser__ridge_taker {
	enum hawser_status (*found)(void *context, const struct hawser__combination *of, double t,
	                            double slope, struct hawser_report *report);
	void *context;
};
enum hawser_status hawser__ridge_find(const double *a, const double *b, int n, int *above,
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
	size_t count, room;
	int above;                  /* 1: there are others with m > HAWSER__RIDGE_HIGHEST */
};
/* `at`: x and y. HAWSER_ERR_MEMORY. */
enum hawser_status hawser__ridge_note(struct hawser__ridge_log *log,
                                      const struct hawser__combination *of, int found,
                                      const double at[2], struct hawser_report *report);
/* Move the resonances that were not found to *to, whose array the caller frees. Clears the log. */
void hawser__ridge_unresolved(struct hawser_tongues *to, struct hawser__ridge_log *log);

#endif

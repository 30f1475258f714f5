/* response/orbit/start.h - the first orbit of a branch.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_RESPONSE_START_H
#define HAWSER_RESPONSE_START_H

#include "response/orbit/load.h"
#include "response/orbit/method.h"

/* Orbits that a response passes as its load is raised from rest, by ascending load. */
struct hawser__way {
	struct hawser__passed {
		double load, *y; /* [length] unknowns; those behind are 0 */
		int length;
	} *passed; /* [count] */
	int count, n;  /* n: of coordinates */
	double rough; /* tolerance of the orbits below the whole load with which these were found; 0: as
	               * rough as is tried first */
};
/* Add the orbit y [count] at this load; not 0: memory is short. */
int hawser__way_add(struct hawser__way *way, double load, const double *y, int count);
/* y [count] becomes the orbit `next` of the way of another model. Where the orbit `from` is known that
 * corresponds to its orbit `here`, the same is added that these differ by; here -1: none is. */
void hawser__way_predict(double *y, const struct hawser__way *way, int next, int here,
                         const double *from, int count);
void hawser__way_clear(struct hawser__way *way);

/* How far the load could be raised. The first six are set by the caller. */
struct hawser__raised {
	int lone;    /* only the orbit that grows out of rest with the load is wanted */
	struct hawser__way *way;         /* of a lone one: orbits that are passed are added; or NULL */
	const struct hawser__way *guide; /* of a lone one: the way of a model like this, along which the
	                                  * load is raised; or NULL */
	int slow;     /* 1: the load is raised even where the linear response leads to an orbit */
	double rough; /* of a lone one: tolerance of the orbits below the whole load */
	double most; /* work, s (hawser_orbit_work), at which it ends; 0: no limit */
	double load; /* factor of the load; -1: that was not tried, or other loads would not help */
	int turned;  /* 1: the curve over the load turned back there; 0: it was lost */
	double *x;   /* [m] state of the orbit at this load, where it is above 0 */
};

#define HAWSER__ON_THE_WAY 1e-3 /* tolerance of orbits below the whole load, harmonics too: narrow
                         * resonances of high ones are passed, 1e-6 takes five times as long */

/* A load that is raised. */
struct hawser__climb {
	struct hawser__load weak;
	double *good, *last, *guess; /* [size] the last orbit, the one before, a prediction */
	double *t, *row;             /* [size] direction of the curve over the load, and its dual */
	double load, last_load, step, growth;
	double peak;                 /* greatest load so far */
};

/* `step`: the first of the load. */
enum hawser_status hawser__climb_open(struct hawser__climb *climb, const struct hawser__orbit *orbit,
                                      double step, struct hawser_report *report);
void hawser__climb_close(struct hawser__climb *climb);
/* y is the next orbit, at this load. Returns 0, or 3 when out of memory. */
int hawser__climb_pass(struct hawser__climb *climb, const double *y, double load,
                       const struct hawser__orbit *orbit, const struct hawser__raised *raised);
/* Follow the curve over the load by its arclength, from the last orbit until the load is whole: then y
 * becomes a guess of the orbit there; or until it has a fold. A dip of the load is passed: a narrow
 * resonance of a high harmonic, which nothing damps. Returns 0; 1: a fold, or the curve was lost; 2: no
 * discretisation is fine enough; 3: out of memory. */
int hawser__climb_arc(double *y, struct hawser__climb *climb, struct hawser__orbit *orbit,
                      struct hawser__correction *correction, double omega,
                      const struct hawser__raised *raised, struct hawser_report *report);

/* Whether the load has fallen from its peak by more than in a dip: the curve has a fold there. */
int hawser__climb_turned(const struct hawser__climb *climb);

#define HAWSER__SEEN 10.0 /* a coordinate that is larger than this many tolerances, relative to the
                           * orbit, is determined; chosen */
/* Whether coordinate j of n, where it is larger than `least`, is opposite in y [count] to what it was,
 * as where it has passed folds of its own: farther from it than the larger of both, by half of the
 * smaller. */
int hawser__orbit_reversed(const double *y, int count, const double *from, int length, int n, int j,
                           double least);
/* Distance of y from `from`, relative to it, both known to `rough`; at least 1 if a coordinate is
 * reversed, which may be small beside the others. */
double hawser__orbit_distance(const double *y, int count, const double *from, int length, int n,
                              double rough);

/* 1 if the orbits so far took more than raised->most. */
int hawser__start_spent(const struct hawser__orbit *orbit, const struct hawser__raised *raised);

/* Find the orbit y [size] at Omega = omega: from `start` [m] (state at phase 0) or, if that is
 * NULL, from the linear response. If Newton's method fails, or raised->lone and it ends far from
 * there, the load is increased from zero. With
 * HAWSER_ERR_CONVERGENCE and raised->load >= 0, the report is left to the caller. */
enum hawser_status hawser__start(double *y, struct hawser__orbit *orbit,
                                 struct hawser__correction *correction, const double *start,
                                 double omega, double tolerance, struct hawser__raised *raised,
                                 struct hawser_report *report);

/* *size: the smallest coordinate of the last corrected orbit y, by balance, relative to it,
 * between `from` and `to`, that is opposite to the linear response, at rest and beside the motion
 * of the others, although it does not change fast with the load there: it may have passed folds of
 * its own. 0: there is none. The orbit's defects are then not those of y. */
enum hawser_status hawser__start_reversed(double *size, const double *y, struct hawser__orbit *orbit,
                                      double omega, double from, double to,
                                      struct hawser_report *report);

#endif
